//! Cavity products of one block: `h_{i→j}(x) = φ_i(x) Π_{k ∈ N(i)\j} m_{k→i}(x)` for each of its lanes.
//!
//! A chunk of labels at a time: the products of a variable's messages from the first on and from the last on, whose
//! meeting leaves out one; contiguous rows all the way. Then the chunk is turned, so that the lanes of one label lie
//! side by side. The belief, which is the whole product, is decoded on the way.

// The dispatch to instruction sets that `multiversion` generates needs unsafe calls; nothing here does itself.
#![allow(unsafe_code)]

use super::block_plan::{BLOCK_LANES, BlockVariable, LANES};
use super::sparse_update::Lanes;
use super::turning::{CHUNK, ChunkRows, rows_to_lanes};
use multiversion::multiversion;

/// Products of messages are carried times this in each of two chains, so that a dozen messages at the floor do not
/// underflow 32 bits; a power of two, so that no rounding depends on it. Their product stays below 2¹²⁸.
const CHAIN_SCALE: f32 = (1u64 << 60) as f32;

/// Scratch of the cavity pass.
#[derive(Debug, Clone)]
pub(super) struct Chains {
    /// Products of the first messages of a variable, `[number of messages][label of the chunk]`.
    forward: Vec<[f32; CHUNK]>,
    /// Product of the last messages.
    backward: [f32; CHUNK],
    /// Cavity products before they are turned.
    rows: Box<ChunkRows>,
    /// Of every variable of the block.
    beliefs: Vec<RunningPeak>,
}

impl Chains {
    pub fn new() -> Self {
        Chains {
            forward: Vec::new(),
            backward: [0.0; CHUNK],
            rows: Box::new([[0.0; CHUNK]; BLOCK_LANES]),
            beliefs: Vec::new(),
        }
    }

    /// The peaks of the beliefs of the variables of the block that was last computed, in its order.
    pub fn peaks(&self) -> impl Iterator<Item = BeliefPeak> {
        self.beliefs.iter().map(RunningPeak::finish)
    }
}

/// The largest belief of a variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BeliefPeak {
    /// The label of the largest belief, the lowest of equal ones.
    pub label: u32,
    /// That belief, in an arbitrary scale.
    pub peak: f32,
    /// Sum of the beliefs over all labels, in the same scale.
    pub sum: f32,
}

/// Writes the cavity products of all lanes of a block to `cavity`, label by label, and returns their maxima.
///
/// `phi` has the row of every variable of the block, `messages` the incoming rows of all of them, one variable after
/// the other; all rows are as long as `cavity`, a multiple of [`LANES`], and beyond the labels `phi` is 0.
/// Lanes that the block leaves empty hold numbers without a meaning.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn cavity_products(
    phi: &[&[f32]],
    messages: &[&[f32]],
    variables: &[BlockVariable],
    chains: &mut Chains,
    cavity: &mut [Lanes],
) -> Lanes {
    chains.beliefs.clear();
    chains.beliefs.resize(variables.len(), RunningPeak::new());
    let mut largest = [0.0f32; BLOCK_LANES];
    for (chunk, turned) in cavity.chunks_mut(CHUNK).enumerate() {
        let labels = chunk * CHUNK..chunk * CHUNK + turned.len();
        let mut first = 0;
        for (at, of) in variables.iter().enumerate() {
            let incoming = &messages[first..first + of.incoming.len()];
            first += incoming.len();
            multiply_chains(&phi[at][labels.clone()], incoming, of, chains, labels.start);
            chains.beliefs[at].add(&chains.forward[incoming.len()][..turned.len()], labels.start);
        }
        rows_to_lanes(&chains.rows, turned);
        for h in turned.iter() {
            for k in 0..BLOCK_LANES {
                largest[k] = if h[k] > largest[k] { h[k] } else { largest[k] };
            }
        }
    }
    largest
}

/// The products of one variable over one chunk of labels, from label `start` on, into its rows.
#[inline(always)]
fn multiply_chains(phi: &[f32], incoming: &[&[f32]], of: &BlockVariable, chains: &mut Chains, start: usize) {
    let length = phi.len();
    let Chains { forward, backward, rows, .. } = chains;
    if forward.len() <= incoming.len() {
        forward.resize(incoming.len() + 1, [0.0; CHUNK]);
    }
    for (product, &phi) in forward[0].iter_mut().zip(phi) {
        *product = phi * CHAIN_SCALE;
    }
    for (slot, message) in incoming.iter().enumerate() {
        let (done, open) = forward.split_at_mut(slot + 1);
        let factors = done[slot].iter().zip(&message[start..start + length]);
        for (product, (&a, &b)) in open[0].iter_mut().zip(factors) {
            *product = a * b;
        }
    }
    backward.fill(CHAIN_SCALE);
    for slot in (of.slots.start..incoming.len()).rev() {
        if slot < of.slots.end {
            let row = &mut rows[of.lane + slot - of.slots.start][..length];
            for (product, (&a, &b)) in row.iter_mut().zip(forward[slot].iter().zip(backward.iter())) {
                *product = a * b;
            }
        }
        for (product, &message) in backward.iter_mut().zip(&incoming[slot][start..start + length]) {
            *product *= message;
        }
    }
}

/// Peak of a belief while its labels go by, [`LANES`] at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RunningPeak {
    peaks: [f32; LANES],
    /// Which vector of labels each of them came from.
    vectors: [u32; LANES],
    sums: [f32; LANES],
}

impl RunningPeak {
    fn new() -> Self {
        RunningPeak { peaks: [-1.0; LANES], vectors: [0; LANES], sums: [0.0; LANES] }
    }

    /// Takes the beliefs of the labels from `start` on.
    #[inline(always)]
    fn add(&mut self, beliefs: &[f32], start: usize) {
        let RunningPeak { mut peaks, mut vectors, mut sums } = *self;
        for (at, belief) in beliefs.as_chunks::<LANES>().0.iter().enumerate() {
            let vector = (start / LANES + at) as u32;
            for k in 0..LANES {
                sums[k] += belief[k];
                vectors[k] = if belief[k] > peaks[k] { vector } else { vectors[k] };
                peaks[k] = if belief[k] > peaks[k] { belief[k] } else { peaks[k] };
            }
        }
        *self = RunningPeak { peaks, vectors, sums };
    }

    fn finish(&self) -> BeliefPeak {
        let mut best = BeliefPeak { label: u32::MAX, peak: -1.0, sum: self.sums.iter().sum() };
        for k in 0..LANES {
            let label = self.vectors[k] * LANES as u32 + k as u32;
            if self.peaks[k] > best.peak || (self.peaks[k] == best.peak && label < best.label) {
                best.label = label;
                best.peak = self.peaks[k];
            }
        }
        best
    }
}
