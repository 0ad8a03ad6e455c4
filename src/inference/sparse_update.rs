//! The sparse message update of one block: up to [`BLOCK_LANES`] outgoing messages side by side.
//!
//! From the cavity products `h` of [`super::cavity`], label by label with all lanes of a label side by side:
//! 1. **update**: `m(y) = max(ε·max h, max_{x ∈ N_r(y)} ψ(x, y) h(x))`, or the sum; every load is whole vectors, no
//!    gather, no exp: `ψ = exp(−β|ℓ − d'|/ℓ')` is the smaller of `exp(−βℓ/ℓ')·exp(βd'/ℓ')` and its inverse;
//! 2. **write**: scaled to maximum 1, floored, turned back into rows and damped with the old message.
//!
//! Without a distance term (`β = 0`) max-product needs far fewer comparisons than `N_r` has members: a maximum over
//! `N_r` is `r` times a maximum over `N_1`, on a triangle mesh `7 r` instead of `1 + 3 r (r + 1)`.
//!
//! Every operation is the same on every instruction set (no fused multiply-add, fixed order), so the dispatched
//! versions give equal bits.

// The dispatch to instruction sets that `multiversion` generates needs unsafe calls; nothing here does itself.
#![allow(unsafe_code)]

use super::block_plan::{BLOCK_LANES, LANES};
use super::cavity::Chains;
use super::full_update::DenseFactors;
use super::lanes::{CHUNK, ChunkRow, ChunkRows, Lanes};
use super::turning::lanes_to_rows;
use crate::graph::LabelNeighborhoods;
use multiversion::multiversion;

/// Pairs of neighbouring labels with the two factors of their pairwise potential, in rows by label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PairTable {
    offsets: Vec<u32>,
    pairs: Vec<Pair>,
    steps: Steps,
}

/// `N_r` as `count` steps of one smaller neighbourhood: a maximum over `N_r` is the maximum over it, `count` times.
#[derive(Debug, Clone, PartialEq)]
struct Steps {
    offsets: Vec<u32>,
    members: Vec<u32>,
    count: usize,
}

impl Steps {
    fn new(labels: &LabelNeighborhoods) -> Self {
        let mut steps = Steps { offsets: vec![0], members: Vec::new(), count: labels.rings().max(1) };
        for x in 0..labels.n_labels() {
            if labels.rings() > 0 {
                steps.members.extend_from_slice(labels.graph().neighbors(x));
            }
            steps.members.push(x as u32);
            steps.offsets.push(steps.members.len() as u32);
        }
        steps
    }
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
        PairTable { offsets, pairs, steps: Steps::new(labels) }
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
#[derive(Debug, Clone)]
pub(super) struct Scratch {
    /// Cavity products, `[label][lane]`; an update may leave something else there.
    pub cavity: Vec<Lanes>,
    /// Updated messages before scaling, `[label][lane]`.
    pub updated: Vec<Lanes>,
    /// Of the cavity pass.
    pub chains: Chains,
    /// Factors of a few labels against all others, of the full update only.
    pub dense: Vec<DenseFactors>,
    /// Messages of a chunk of labels, turned back into rows.
    pub rows: Box<ChunkRows>,
}

impl Scratch {
    /// Room for `stride` labels.
    pub fn new(stride: usize) -> Self {
        let zero = Lanes::splat(0.0);
        Scratch {
            cavity: vec![zero; stride],
            updated: vec![zero; stride],
            chains: Chains::new(),
            dense: Vec::new(),
            rows: Box::new([ChunkRow::splat(0.0); BLOCK_LANES]),
        }
    }
}

/// Max-product without a distance term: `ψ = 1` within the neighbourhood. Uses up `scratch.cavity`. `largest` are the
/// maxima of the cavity products, which those of the messages equal, since a label is in its own neighbourhood.
pub(super) fn max_update_uniform(table: &PairTable, floor: &Lanes, scratch: &mut Scratch) {
    for step in 1..=table.steps.count {
        let floor = if step == table.steps.count { *floor } else { Lanes::splat(0.0) };
        max_step(&table.steps, &scratch.cavity, &floor, &mut scratch.updated);
        if step < table.steps.count {
            std::mem::swap(&mut scratch.cavity, &mut scratch.updated);
        }
    }
}

/// `to(y) = max(floor, max_{x ∈ N(y)} from(x))` over the neighbourhood of one step.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn max_step(steps: &Steps, from: &[Lanes], floor: &Lanes, to: &mut [Lanes]) {
    for (row, to) in steps.offsets.windows(2).zip(to) {
        let mut best = *floor;
        for &x in &steps.members[row[0] as usize..row[1] as usize] {
            let h = &from[x as usize];
            for k in 0..BLOCK_LANES {
                best[k] = if h[k] > best[k] { h[k] } else { best[k] };
            }
        }
        *to = best;
    }
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
    let mut largest = Lanes::splat(0.0);
    for (y, message) in updated[..table.offsets.len() - 1].iter_mut().enumerate() {
        let mut best = *floor;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..BLOCK_LANES {
                let (a, b) = (near[k] * pair.rising, far[k] * pair.falling);
                let value = if a < b { a } else { b } * h[k];
                best[k] = if value > best[k] { value } else { best[k] };
            }
        }
        for k in 0..BLOCK_LANES {
            largest[k] = if best[k] > largest[k] { best[k] } else { largest[k] };
        }
        *message = best;
    }
    largest
}

/// Sum-product without a distance term: `ε Σ_x h(x) + (1 − ε) Σ_{x ∈ N_r(y)} h(x)`. Returns the largest value of each
/// lane. Sums have no shortcut by `N_1`, which would count a label once for each path.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn sum_update_uniform(table: &PairTable, cavity: &[Lanes], epsilon: f32, updated: &mut [Lanes]) -> Lanes {
    let rest = total(cavity, epsilon);
    let share = 1.0 - epsilon;
    let mut largest = Lanes::splat(0.0);
    for (y, message) in updated[..table.offsets.len() - 1].iter_mut().enumerate() {
        let mut sum = Lanes::splat(0.0);
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..BLOCK_LANES {
                sum[k] += h[k];
            }
        }
        // Two loops: of both in one the compiler makes numbers one by one.
        for k in 0..BLOCK_LANES {
            sum[k] = rest[k] + share * sum[k];
        }
        for k in 0..BLOCK_LANES {
            largest[k] = if sum[k] > largest[k] { sum[k] } else { largest[k] };
        }
        *message = sum;
    }
    largest
}

/// `ε Σ_x h(x)` of every lane.
#[inline(always)]
fn total(cavity: &[Lanes], epsilon: f32) -> Lanes {
    let mut total = Lanes::splat(0.0);
    for h in cavity {
        for k in 0..BLOCK_LANES {
            total[k] += h[k];
        }
    }
    Lanes(total.map(|total| total * epsilon))
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
    let rest = total(cavity, epsilon);
    let mut largest = Lanes::splat(0.0);
    for (y, message) in updated[..table.offsets.len() - 1].iter_mut().enumerate() {
        let mut sum = rest;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..BLOCK_LANES {
                let (a, b) = (near[k] * pair.rising, far[k] * pair.falling);
                let psi = if a < b { a } else { b };
                let psi = if psi > epsilon { psi } else { epsilon };
                sum[k] += (psi - epsilon) * h[k];
            }
        }
        for k in 0..BLOCK_LANES {
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

/// Scales every lane of `updated` to maximum 1, floors and damps it, and writes it into its row of `new`; returns the
/// largest change. `old` and `new` are the rows of the block, `updated.len()` values each; `rows` is scratch.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn write_messages(
    updated: &[Lanes],
    largest: &Lanes,
    old: &[f32],
    new: &mut [f32],
    finish: Finish,
    rows: &mut ChunkRows,
) -> f32 {
    let stride = updated.len();
    let mut change = [0.0f32; LANES];
    for (chunk, updated) in updated.chunks(CHUNK).enumerate() {
        lanes_to_rows(updated, rows);
        let labels = chunk * CHUNK..chunk * CHUNK + updated.len();
        let pairs = old.chunks_exact(stride).zip(new.chunks_exact_mut(stride));
        for ((row, &top), (old, new)) in rows.iter().zip(largest.iter()).zip(pairs) {
            write_row(&row[..updated.len()], top, &old[labels.clone()], &mut new[labels.clone()], finish, &mut change);
        }
    }
    change.iter().fold(0.0, |a, &b| if b > a { b } else { a })
}

/// A piece of one message, whose largest value before scaling is `top`; adds to the largest `change`.
#[inline(always)]
fn write_row(row: &[f32], top: f32, old: &[f32], new: &mut [f32], finish: Finish, change: &mut [f32; LANES]) {
    let Finish { floor, damping } = finish;
    let share = 1.0 - damping;
    // A lane whose products all vanished carries no information: a flat message.
    let scale = if top > 0.0 { 1.0 / top } else { 0.0 };
    let mut most = *change;
    let vectors = row.as_chunks::<LANES>().0.iter().zip(old.as_chunks::<LANES>().0);
    for ((row, old), new) in vectors.zip(new.as_chunks_mut::<LANES>().0) {
        for k in 0..LANES {
            let value = row[k] * scale;
            let value = if value > floor { value } else { floor };
            let value = share * value + damping * old[k];
            let step = (value - old[k]).abs();
            most[k] = if step > most[k] { step } else { most[k] };
            new[k] = value;
        }
    }
    *change = most;
}
