//! The sparse message update of one block: up to [`BLOCK_LANES`] outgoing messages side by side.
//!
//! From the cavity products `h` of [`super::cavity`], label by label with all lanes of a label side by side:
//! `m(y) = max(ε·max h, max_{x ∈ N_r(y)} ψ(x, y) h(x))`, or the sum; every load is whole vectors, no gather, no exp:
//! `ψ = exp(−β|ℓ − d'|/ℓ')` is the smaller of `exp(−βℓ/ℓ')·exp(βd'/ℓ')` and its inverse.
//!
//! Without a distance term (`β = 0`) max-product needs far fewer comparisons than `N_r` has members: a maximum over
//! `N_r` is a maximum over `N_1` repeated `r` times, on a triangle mesh `7 r` comparisons instead of `1 + 3 r (r + 1)`.
//!
//! Every operation is the same on every instruction set (no fused multiply-add, fixed order), so the dispatched
//! versions give equal bits.

use super::block_plan::BLOCK_LANES;
use super::cavity::Chains;
use super::full_update::DenseFactors;
use super::label_rows::LabelRows;
use super::lanes::{CHUNK, Lanes};
use super::pair_table::{PairTable, pair_factor, truncated_pair_factor};
use super::vector::{Simd, Vector, WIDTH, dispatch};
use multiversion::multiversion;

/// Scratch of one thread, reused from block to block.
#[derive(Debug, Clone)]
pub(super) struct Scratch {
    /// Cavity products, `[label][lane]`, followed by a row of zeros; an update may overwrite them.
    pub cavity: Vec<Lanes>,
    /// Updated messages before scaling, `[label][lane]`, also with one more row.
    pub updated: Vec<Lanes>,
    /// Scratch of the cavity pass.
    pub chains: Chains,
    /// Factors of a few labels against all others, for the full update only.
    pub dense: Vec<DenseFactors>,
    /// Updated messages of a chunk of labels, written together.
    pub chunk: Box<[Lanes; CHUNK]>,
}

impl Scratch {
    /// Room for `stride` labels.
    pub(super) fn new(stride: usize) -> Self {
        let zero = Lanes::splat(0.0);
        Scratch {
            cavity: vec![zero; stride + 1],
            updated: vec![zero; stride + 1],
            chains: Chains::new(),
            dense: Vec::new(),
            chunk: Box::new([zero; CHUNK]),
        }
    }
}

/// Vectors per label, over all lanes.
const GROUPS: usize = BLOCK_LANES / WIDTH;

dispatch! {
    /// A chunk of `to(y) = max(floor, max_{x ∈ rows(y)} from(x))`; 0 beyond the labels.
    pub(super) fn max_chunk(rows: &LabelRows, chunk: usize, from: &[Lanes], floor: &Lanes, to: &mut [Lanes]) = maxima
}

dispatch! {
    /// A chunk of `to(y) = rest + share · Σ_{x ∈ rows(y)} from(x)` with `terms = (rest, share)`; 0 beyond the labels.
    /// Raises `largest` to the largest value of each lane.
    pub(super) fn sum_chunk(
        rows: &LabelRows,
        chunk: usize,
        from: &[Lanes],
        terms: (&Lanes, f32),
        to: &mut [Lanes],
        largest: &mut Lanes,
    ) = sums
}

#[inline(always)]
fn maxima<S: Simd>(simd: S, rows: &LabelRows, chunk: usize, from: &[Lanes], floor: &Lanes, to: &mut [Lanes]) {
    fold_chunk(simd, rows, chunk, from, floor, |best: S::Vector, h| best.max(h), to);
}

#[inline(always)]
fn sums<S: Simd>(
    simd: S,
    rows: &LabelRows,
    chunk: usize,
    from: &[Lanes],
    (rest, share): (&Lanes, f32),
    to: &mut [Lanes],
    largest: &mut Lanes,
) {
    fold_chunk(simd, rows, chunk, from, &Lanes::splat(0.0), |sum: S::Vector, h| sum.add(h), to);
    let (rest, share) = (load(simd, rest), simd.splat(share));
    let mut top = load(simd, largest);
    let n = rows.members(chunk).len() / rows.width();
    for message in &mut to[..n] {
        let sum = load(simd, message);
        let made: [S::Vector; GROUPS] = std::array::from_fn(|group| rest[group].add(share.mul(sum[group])));
        for group in 0..GROUPS {
            top[group] = made[group].max(top[group]);
        }
        store(made, message);
    }
    store(top, largest);
}

/// `to(y)` is `first`, combined with the values of all members of the row of `y`.
#[inline(always)]
fn fold_chunk<S: Simd>(
    simd: S,
    rows: &LabelRows,
    chunk: usize,
    from: &[Lanes],
    first: &Lanes,
    combine: impl Fn(S::Vector, S::Vector) -> S::Vector + Copy,
    to: &mut [Lanes],
) {
    assert!(rows.limit() <= from.len(), "labels beyond the cavity products");
    let first = load(simd, first);
    let members = rows.members(chunk);
    // The usual widths of triangle and quad meshes, unrolled.
    match rows.width() {
        5 => fold_rows(simd, members.as_chunks::<5>().0.iter(), from, first, combine, to),
        7 => fold_rows(simd, members.as_chunks::<7>().0.iter(), from, first, combine, to),
        8 => fold_rows(simd, members.as_chunks::<8>().0.iter(), from, first, combine, to),
        width => fold_rows(simd, members.chunks_exact(width), from, first, combine, to),
    }
    for &[y, x] in rows.more(chunk) {
        let to = &mut to[y as usize % CHUNK];
        let (h, so_far) = (load(simd, &from[x as usize]), load(simd, to));
        store(std::array::from_fn(|group| combine(so_far[group], h[group])), to);
    }
    to[members.len() / rows.width()..].fill(Lanes::splat(0.0));
}

#[inline(always)]
fn fold_rows<'a, S: Simd>(
    simd: S,
    rows: impl Iterator<Item = impl IntoIterator<Item = &'a u32>>,
    from: &[Lanes],
    first: [S::Vector; GROUPS],
    combine: impl Fn(S::Vector, S::Vector) -> S::Vector + Copy,
    to: &mut [Lanes],
) {
    for (row, to) in rows.zip(to) {
        let mut so_far = first;
        for &x in row {
            // SAFETY: labels of the rows are below their limit, and `from` has as many, which the caller asserts.
            // Checks here would be a fifth of the work.
            #[allow(unsafe_code)]
            let h = load(simd, unsafe { from.get_unchecked(x as usize) });
            for group in 0..GROUPS {
                so_far[group] = combine(so_far[group], h[group]);
            }
        }
        store(so_far, to);
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, lanes: &Lanes) -> [S::Vector; GROUPS] {
    let groups = lanes.as_chunks().0;
    std::array::from_fn(|group| simd.load(&groups[group]))
}

#[inline(always)]
fn store<V: Vector>(values: [V; GROUPS], lanes: &mut Lanes) {
    for (value, lanes) in values.into_iter().zip(lanes.as_chunks_mut().0) {
        value.store(lanes);
    }
}

/// Max-product without a distance term: `ψ = 1` within the neighborhood. Overwrites `scratch.cavity`. `largest` are the
/// maxima of the cavity products; they equal the maxima of the messages, since a label is in its own neighborhood.
pub(super) fn max_update_uniform(table: &PairTable, floor: &Lanes, scratch: &mut Scratch) {
    max_steps_but_last(table, scratch);
    for (chunk, to) in scratch.updated.chunks_mut(CHUNK).enumerate() {
        max_chunk(&table.steps, chunk, &scratch.cavity, floor, to);
    }
}

/// All steps of [`max_update_uniform`] except the last: `scratch.cavity` then lacks one maximum over `N_1`.
pub(super) fn max_steps_but_last(table: &PairTable, scratch: &mut Scratch) {
    for _ in 1..table.n_steps {
        for (chunk, to) in scratch.updated.chunks_mut(CHUNK).enumerate() {
            max_chunk(&table.steps, chunk, &scratch.cavity, &Lanes::splat(0.0), to);
        }
        std::mem::swap(&mut scratch.cavity, &mut scratch.updated);
    }
}

/// Sum-product without a distance term: `ε Σ_x h(x) + (1 − ε) Σ_{x ∈ N_r(y)} h(x)`, with `rest = ε Σ_x h(x)`. Returns
/// the largest value of each lane. Sums have no shortcut by `N_1`, which would count a label once for each path.
pub(super) fn sum_update_uniform(table: &PairTable, rest: &Lanes, epsilon: f32, scratch: &mut Scratch) -> Lanes {
    let mut largest = Lanes::splat(0.0);
    // The padding label of rows, which lies beyond the last label.
    scratch.cavity[table.n_labels()] = Lanes::splat(0.0);
    for (chunk, to) in scratch.updated.chunks_mut(CHUNK).enumerate() {
        sum_chunk(&table.members, chunk, &scratch.cavity, (rest, 1.0 - epsilon), to, &mut largest);
    }
    largest
}

/// Max-product with a distance term. `near` and `far` are the [`super::pair_table::edge_factors`] of each lane.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn max_update(
    table: &PairTable,
    cavity: &[Lanes],
    (near, far): (&Lanes, &Lanes),
    floor: &Lanes,
    updated: &mut [Lanes],
) -> Lanes {
    let mut largest = Lanes::splat(0.0);
    for (y, message) in updated[..table.n_labels()].iter_mut().enumerate() {
        let mut best = *floor;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..BLOCK_LANES {
                let value = pair_factor((near[k], far[k]), pair.factors) * h[k];
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

/// Sum-product: `ε Σ_x h(x) + Σ_{x ∈ N_r(y)} (ψ(x, y) − ε) h(x)`, with `ψ` not below `ε` (`epsilon`) and
/// `rest = ε Σ_x h(x)`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn sum_update(
    table: &PairTable,
    cavity: &[Lanes],
    (near, far): (&Lanes, &Lanes),
    (rest, epsilon): (&Lanes, f32),
    updated: &mut [Lanes],
) -> Lanes {
    let mut largest = Lanes::splat(0.0);
    for (y, message) in updated[..table.n_labels()].iter_mut().enumerate() {
        let mut sum = *rest;
        for pair in table.row(y) {
            let h = &cavity[pair.label as usize];
            for k in 0..BLOCK_LANES {
                let psi = truncated_pair_factor((near[k], far[k]), pair.factors, epsilon);
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
