//! Cavity products of one block: `h_{i→j}(x) = φ_i(x) Π_{k ∈ N(i)\j} m_{k→i}(x)` for each of its lanes.
//!
//! A chunk of labels at a time: the products of a variable's messages from the first on and from the last on, whose
//! meeting leaves out one; contiguous rows all the way. Then the chunk is turned, so that the lanes of one label lie
//! side by side. The belief, which is the whole product, is decoded on the way.

// The dispatch to instruction sets that `multiversion` generates needs unsafe calls; nothing here does itself.
#![allow(unsafe_code)]

use super::block_plan::{BLOCK_LANES, BlockVariable, LANES};
use super::lanes::{CHUNK, ChunkRow, ChunkRows, Lanes};
use super::turning::rows_to_lanes;
use multiversion::multiversion;

/// Products of messages are carried times this in each of two chains, so that a dozen messages at the floor do not
/// underflow 32 bits; a power of two, so that no rounding depends on it. Their product stays below 2¹²⁸.
const CHAIN_SCALE: f32 = (1u64 << 60) as f32;

/// Labels whose two chains of products fit the 16 registers of AVX2.
const VECTOR: usize = 8;

/// Scratch of the cavity pass.
#[derive(Debug, Clone)]
pub(super) struct Chains {
    /// Products of the first messages of a variable, `[number of messages][label of the chunk]`.
    forward: Vec<ChunkRow>,
    /// Product of the last messages.
    backward: ChunkRow,
    /// Cavity products before they are turned.
    rows: Box<ChunkRows>,
    /// Of every variable of the block.
    beliefs: Vec<RunningPeak>,
}

impl Chains {
    pub fn new() -> Self {
        Chains {
            forward: Vec::new(),
            backward: ChunkRow::splat(0.0),
            rows: Box::new([ChunkRow::splat(0.0); BLOCK_LANES]),
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
    let mut largest = Lanes::splat(0.0);
    for (chunk, turned) in cavity.chunks_mut(CHUNK).enumerate() {
        let labels = chunk * CHUNK..chunk * CHUNK + turned.len();
        let mut first = 0;
        for (at, of) in variables.iter().enumerate() {
            let incoming = &messages[first..first + of.incoming.len()];
            first += incoming.len();
            let phi = &phi[at][labels.clone()];
            if chains.forward.len() <= incoming.len() {
                chains.forward.resize(incoming.len() + 1, ChunkRow::splat(0.0));
            }
            // The degrees of nearly all vertices of triangle and quad meshes.
            match incoming.len() {
                3 => multiply_few::<3>(phi, incoming, of, chains, labels.start),
                4 => multiply_few::<4>(phi, incoming, of, chains, labels.start),
                5 => multiply_few::<5>(phi, incoming, of, chains, labels.start),
                6 => multiply_few::<6>(phi, incoming, of, chains, labels.start),
                7 => multiply_few::<7>(phi, incoming, of, chains, labels.start),
                8 => multiply_few::<8>(phi, incoming, of, chains, labels.start),
                _ => multiply_many(phi, incoming, of, chains, labels.start),
            }
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

/// The products of one variable of `D` neighbours over one chunk of labels, from label `start` on, into its rows. Both
/// chains stay in registers.
#[inline(always)]
fn multiply_few<const D: usize>(
    phi: &[f32],
    incoming: &[&[f32]],
    of: &BlockVariable,
    chains: &mut Chains,
    start: usize,
) {
    let n = phi.len() / VECTOR;
    let Chains { forward, rows, .. } = chains;
    let messages: [&[[f32; VECTOR]]; D] =
        std::array::from_fn(|slot| &incoming[slot][start..start + phi.len()].as_chunks().0[..n]);
    let beliefs = &mut forward[D].as_chunks_mut::<VECTOR>().0[..n];
    let (first, _) = rows[of.lane..].as_chunks_mut::<D>();
    let Some(rows) = first.first_mut() else { return };
    let products = rows.each_mut().map(|row| &mut row.as_chunks_mut::<VECTOR>().0[..n]);
    for (at, phi) in phi.as_chunks::<VECTOR>().0.iter().enumerate() {
        let mut product = multiply(phi, &[CHAIN_SCALE; VECTOR]);
        let mut before = [[0.0f32; VECTOR]; D];
        for slot in 0..D {
            before[slot] = product;
            product = multiply(&product, &messages[slot][at]);
        }
        beliefs[at] = product;
        let mut after = [CHAIN_SCALE; VECTOR];
        for slot in (0..D).rev() {
            products[slot][at] = multiply(&before[slot], &after);
            after = multiply(&after, &messages[slot][at]);
        }
    }
}

#[inline(always)]
fn multiply(a: &[f32; VECTOR], b: &[f32; VECTOR]) -> [f32; VECTOR] {
    let mut product = [0.0; VECTOR];
    for k in 0..VECTOR {
        product[k] = a[k] * b[k];
    }
    product
}

/// Likewise for any number of neighbours, and for those that a block sends to.
#[inline(always)]
fn multiply_many(phi: &[f32], incoming: &[&[f32]], of: &BlockVariable, chains: &mut Chains, start: usize) {
    let length = phi.len();
    let Chains { forward, backward, rows, .. } = chains;
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Also where a block sends to some neighbours only, as with those of a hub, and in either kind of loop.
        #[test]
        fn cavity_products_leave_out_one_message_and_peaks_none(
            degree in 1usize..12,
            left_out in 0usize..3,
            lane in 0usize..8,
            vectors in 1usize..20,
            entropy in prop::collection::vec(0.01f32..1.0, 389),
        ) {
            let slots = if degree > 8 { left_out..degree - left_out } else { 0..degree };
            let stride = vectors * LANES;
            let mut numbers = entropy.iter().copied().cycle();
            let rows: Vec<Vec<f32>> = (0..=degree).map(|_| numbers.by_ref().take(stride).collect()).collect();
            let (phi, messages) = (&rows[degree], &rows[..degree]);
            let of = BlockVariable { variable: 0, incoming: (0..degree as u32).collect(), slots, lane };
            let mut cavity = vec![Lanes::splat(0.0); stride];
            let mut chains = Chains::new();
            let messages: Vec<&[f32]> = messages.iter().map(Vec::as_slice).collect();
            let largest = cavity_products(&[phi], &messages, std::slice::from_ref(&of), &mut chains, &mut cavity);
            let scale = f64::from(CHAIN_SCALE);
            for (lane, slot) in (lane..).zip(of.slots.clone()) {
                for x in 0..stride {
                    let others = (0..degree).filter(|&k| k != slot).map(|k| f64::from(messages[k][x]));
                    let product = f64::from(phi[x]) * others.product::<f64>() * scale * scale;
                    prop_assert!((f64::from(cavity[x][lane]) - product).abs() <= 2e-6 * product);
                }
                prop_assert_eq!(largest[lane], cavity.iter().fold(0.0, |top, h| h[lane].max(top)));
            }
            let beliefs: Vec<f64> = (0..stride)
                .map(|x| f64::from(phi[x]) * messages.iter().map(|m| f64::from(m[x])).product::<f64>() * scale)
                .collect();
            let found: Vec<BeliefPeak> = chains.peaks().collect();
            let (peak, sum) = (beliefs.iter().copied().fold(0.0, f64::max), beliefs.iter().sum::<f64>());
            prop_assert_eq!(found.len(), 1);
            prop_assert!((f64::from(found[0].peak) - peak).abs() <= 2e-6 * peak);
            prop_assert!((beliefs[found[0].label as usize] - peak).abs() <= 2e-6 * peak);
            prop_assert!((f64::from(found[0].sum) - sum).abs() <= 1e-4 * sum);
        }
    }
}
