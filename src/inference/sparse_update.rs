//! The sparse message update, one block of up to [`LANES`] outgoing messages at a time.
//!
//! For every lane (directed edge `i → j`) three passes over the labels, all within the cache of one core:
//! 1. **cavity**: `h(x) = φ_i(x) Π_{k ∈ N(i)\j} m_{k→i}(x)` from contiguous message rows, turned so that the lanes of
//!    one label lie side by side;
//! 2. **update**: `m(y) = max(ε·max h, max_{x ∈ N_r(y)} ψ(x, y) h(x))`, or the sum; every load is one full vector, no
//!    gather, no exp: `ψ = exp(−β|ℓ − d'|/ℓ')` is the smaller of `exp(−βℓ/ℓ')·exp(βd'/ℓ')` and its inverse;
//! 3. **write**: scaled to maximum 1, floored, damped with the old message, turned back into rows.
//!
//! Every operation is the same on every instruction set (no fused multiply-add, fixed order), so the dispatched
//! versions give equal bits.

// The dispatch to instruction sets that `multiversion` generates needs unsafe calls; nothing here does itself.
#![allow(unsafe_code)]

use super::block_plan::{BlockVariable, LANES};
use super::full_update::DenseFactors;
use crate::graph::LabelNeighborhoods;
use multiversion::multiversion;

/// One number for each lane.
pub(super) type Lanes = [f32; LANES];

/// Products of messages are carried times this in each of two chains, so that a dozen messages at the floor do not
/// underflow 32 bits; a power of two, so that no rounding depends on it. Their product stays below 2¹²⁸.
const CHAIN_SCALE: f32 = (1u64 << 60) as f32;

/// Pairs of neighbouring labels with the two factors of their pairwise potential, in rows by label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PairTable {
    offsets: Vec<u32>,
    pairs: Vec<Pair>,
}

/// A label `x` in `N_r(y)`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pair {
    label: u32,
    /// `exp(β(d'/ℓ' − 1))`.
    rising: f32,
    /// Its inverse.
    falling: f32,
}

impl PairTable {
    /// The table of `labels` for weight `beta` and length scale `length_scale`. Cost `O(n k̄)`.
    pub fn new(labels: &LabelNeighborhoods, beta: f64, length_scale: f64) -> Self {
        let mut offsets = vec![0u32];
        let mut pairs = Vec::new();
        for y in 0..labels.n_labels() {
            for (&x, &d) in labels.members(y).iter().zip(labels.distances(y)) {
                let exponent = beta * (f64::from(d) / length_scale - 1.0);
                pairs.push(Pair { label: x, rising: exponent.exp() as f32, falling: (-exponent).exp() as f32 });
            }
            offsets.push(pairs.len() as u32);
        }
        PairTable { offsets, pairs }
    }

    /// Number of labels `n`.
    pub fn n_labels(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The labels of `N_r(y)` with their factors `[rising, falling]`.
    pub fn factors(&self, y: usize) -> impl Iterator<Item = (usize, [f32; 2])> {
        self.row(y).iter().map(|pair| (pair.label as usize, [pair.rising, pair.falling]))
    }

    fn row(&self, y: usize) -> &[Pair] {
        &self.pairs[self.offsets[y] as usize..self.offsets[y + 1] as usize]
    }
}

/// The two factors of `ψ` that belong to a source edge of `length`: `exp(−β(ℓ/ℓ' − 1))` and its inverse.
pub(super) fn edge_factors(beta: f64, length_scale: f64, length: f32) -> (f32, f32) {
    let exponent = beta * (f64::from(length) / length_scale - 1.0);
    ((-exponent).exp() as f32, exponent.exp() as f32)
}

/// Scratch of one thread, reused from block to block.
#[derive(Debug, Clone, Default)]
pub(super) struct Scratch {
    /// Cavity products, `[label][lane]`.
    pub cavity: Vec<Lanes>,
    /// Updated messages before scaling, `[label][lane]`.
    pub updated: Vec<Lanes>,
    /// Running products of one chunk of labels, from the first and from the last neighbour on.
    forward: Vec<Lanes>,
    backward: Vec<Lanes>,
    /// Factors of a few labels against all others, of the full update only.
    pub dense: Vec<DenseFactors>,
}

impl Scratch {
    /// Room for `stride` labels.
    pub fn new(stride: usize) -> Self {
        let zero = [0.0; LANES];
        Scratch {
            cavity: vec![zero; stride],
            updated: vec![zero; stride],
            forward: Vec::new(),
            backward: Vec::new(),
            dense: Vec::new(),
        }
    }
}

/// What the cavity pass also finds of a variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BeliefPeak {
    /// The label of the largest belief, the lowest of equal ones.
    pub label: u32,
    /// That belief, in an arbitrary scale.
    pub peak: f32,
    /// Sum of the beliefs over all labels, in the same scale.
    pub sum: f32,
}

/// Writes the cavity products of one variable into its lanes and returns the peak of its belief.
///
/// `phi` and every row of `messages` hold `stride` values, a multiple of [`LANES`]; beyond the labels `phi` is 0.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn cavity_products(
    phi: &[f32],
    messages: &[f32],
    of: &BlockVariable,
    scratch: &mut Scratch,
    largest: &mut Lanes,
) -> BeliefPeak {
    let stride = phi.len();
    let degree = of.incoming.len();
    let Scratch { cavity, forward, backward, .. } = scratch;
    forward.clear();
    forward.resize(degree + 1, [0.0; LANES]);
    backward.clear();
    backward.resize(degree + 1, [CHAIN_SCALE; LANES]);
    let mut peaks = [-1.0f32; LANES];
    let mut peak_chunk = [0u32; LANES];
    let mut sums = [0.0f32; LANES];
    let mut lane_peaks = [[0.0f32; LANES]; LANES];
    let (phi_chunks, _) = phi.as_chunks::<LANES>();
    for (chunk, phi) in phi_chunks.iter().enumerate() {
        let at = chunk * LANES;
        for k in 0..LANES {
            forward[0][k] = phi[k] * CHAIN_SCALE;
        }
        for (slot, &row) in of.incoming.iter().enumerate() {
            let start = row as usize * stride + at;
            let message = &messages[start..start + LANES];
            let (done, open) = forward.split_at_mut(slot + 1);
            for k in 0..LANES {
                open[0][k] = done[slot][k] * message[k];
            }
        }
        for slot in (of.slots.start..degree).rev() {
            let start = of.incoming[slot] as usize * stride + at;
            let message = &messages[start..start + LANES];
            let (open, done) = backward.split_at_mut(slot + 1);
            for k in 0..LANES {
                open[slot][k] = done[0][k] * message[k];
            }
        }
        let belief = &forward[degree];
        for k in 0..LANES {
            sums[k] += belief[k];
            if belief[k] > peaks[k] {
                peaks[k] = belief[k];
                peak_chunk[k] = chunk as u32;
            }
        }
        for (offset, slot) in of.slots.clone().enumerate() {
            let lane = of.lane + offset;
            let (forward, backward) = (&forward[slot], &backward[slot + 1]);
            let top = &mut lane_peaks[offset];
            let mut product = [0.0f32; LANES];
            for k in 0..LANES {
                product[k] = forward[k] * backward[k];
                top[k] = if product[k] > top[k] { product[k] } else { top[k] };
            }
            for (k, label) in cavity[at..at + LANES].iter_mut().enumerate() {
                label[lane] = product[k];
            }
        }
    }
    for offset in 0..of.slots.len() {
        largest[of.lane + offset] = lane_peaks[offset].iter().fold(0.0, |a, &b| if b > a { b } else { a });
    }
    let mut best = BeliefPeak { label: u32::MAX, peak: -1.0, sum: sums.iter().sum() };
    for k in 0..LANES {
        let label = peak_chunk[k] * LANES as u32 + k as u32;
        if peaks[k] > best.peak || (peaks[k] == best.peak && label < best.label) {
            best.label = label;
            best.peak = peaks[k];
        }
    }
    best
}

/// Max-product without a distance term: `ψ = 1` within the neighbourhood. Returns the largest value of each lane.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn max_update_uniform(table: &PairTable, cavity: &[Lanes], floor: &Lanes, updated: &mut [Lanes]) -> Lanes {
    let mut largest = [0.0f32; LANES];
    for (y, message) in updated[..table.offsets.len() - 1].iter_mut().enumerate() {
        let mut best = *floor;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..LANES {
                best[k] = if h[k] > best[k] { h[k] } else { best[k] };
            }
        }
        for k in 0..LANES {
            largest[k] = if best[k] > largest[k] { best[k] } else { largest[k] };
        }
        *message = best;
    }
    largest
}

/// Max-product with a distance term. `near` and `far` are the [`edge_factors`] of each lane.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn max_update(
    table: &PairTable,
    cavity: &[Lanes],
    (near, far): (&Lanes, &Lanes),
    floor: &Lanes,
    updated: &mut [Lanes],
) -> Lanes {
    let mut largest = [0.0f32; LANES];
    for (y, message) in updated[..table.offsets.len() - 1].iter_mut().enumerate() {
        let mut best = *floor;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..LANES {
                let (a, b) = (near[k] * pair.rising, far[k] * pair.falling);
                let value = if a < b { a } else { b } * h[k];
                best[k] = if value > best[k] { value } else { best[k] };
            }
        }
        for k in 0..LANES {
            largest[k] = if best[k] > largest[k] { best[k] } else { largest[k] };
        }
        *message = best;
    }
    largest
}

/// Sum-product: `ε Σ_x h(x) + Σ_{x ∈ N_r(y)} (ψ(x, y) − ε) h(x)`, with `ψ` not below `ε` (`epsilon`).
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn sum_update(
    table: &PairTable,
    cavity: &[Lanes],
    (near, far): (&Lanes, &Lanes),
    epsilon: f32,
    updated: &mut [Lanes],
) -> Lanes {
    let mut rest = [0.0f32; LANES];
    for h in cavity {
        for k in 0..LANES {
            rest[k] += h[k];
        }
    }
    for total in &mut rest {
        *total *= epsilon;
    }
    let mut largest = [0.0f32; LANES];
    for (y, message) in updated[..table.offsets.len() - 1].iter_mut().enumerate() {
        let mut sum = rest;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..LANES {
                let (a, b) = (near[k] * pair.rising, far[k] * pair.falling);
                let psi = if a < b { a } else { b };
                let psi = if psi > epsilon { psi } else { epsilon };
                sum[k] += (psi - epsilon) * h[k];
            }
        }
        for k in 0..LANES {
            largest[k] = if sum[k] > largest[k] { sum[k] } else { largest[k] };
        }
        *message = sum;
    }
    largest
}

/// How an updated message becomes the new one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Finish {
    /// Smallest value of a message.
    pub floor: f32,
    /// Share of the old message that is kept.
    pub damping: f32,
}

/// Scales every lane to maximum 1, floors and damps it, and writes it into its row of `new`; returns the largest
/// change. `old` and `new` are the rows of the block, `stride` values each.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn write_messages(
    updated: &[Lanes],
    largest: &Lanes,
    old: &[f32],
    new: &mut [f32],
    stride: usize,
    finish: Finish,
) -> f32 {
    let n_lanes = new.len() / stride;
    let Finish { floor, damping } = finish;
    let share = 1.0 - damping;
    let mut change = [0.0f32; LANES];
    let (tiles, _) = updated.as_chunks::<LANES>();
    for (chunk, tile) in tiles.iter().enumerate() {
        for lane in 0..n_lanes {
            let start = lane * stride + chunk * LANES;
            let old = &old[start..start + LANES];
            let new = &mut new[start..start + LANES];
            // A lane whose products all vanished carries no information: a flat message.
            let scale = if largest[lane] > 0.0 { 1.0 / largest[lane] } else { 0.0 };
            let mut row = [0.0f32; LANES];
            for k in 0..LANES {
                row[k] = tile[k][lane];
            }
            for k in 0..LANES {
                let value = row[k] * scale;
                let value = if value > floor { value } else { floor };
                let value = share * value + damping * old[k];
                let step = (value - old[k]).abs();
                change[k] = if step > change[k] { step } else { change[k] };
                new[k] = value;
            }
        }
    }
    change.iter().fold(0.0, |a, &b| if b > a { b } else { a })
}
