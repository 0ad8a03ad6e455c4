//! The full message update: every label pair of one block of up to [`BLOCK_LANES`] outgoing messages.
//!
//! No table of potentials is stored. A dense row holds the two factors of the potential of one label against all
//! others, and 0 outside its neighborhood, which the lower limit `ε` turns into the truncation; it takes `O(n)` memory
//! per thread. Each pass over the cavity products updates two labels, as many as fit in 16 registers.

use super::block_plan::BLOCK_LANES;
use super::lanes::Lanes;
use super::pair_table::{PairTable, truncated_pair_factor};
use multiversion::multiversion;

/// Labels updated together.
const ROWS: usize = 2;

/// Factors `[rising, falling]` of [`ROWS`] labels against one label.
pub(super) type DenseFactors = [[f32; 2]; ROWS];

/// The pairwise potential of each lane, as factors.
#[derive(Debug, Clone, Copy)]
pub(super) struct FullPotential<'a> {
    /// First of the [`super::pair_table::edge_factors`] of each lane.
    pub near: &'a Lanes,
    /// Second of the [`super::pair_table::edge_factors`] of each lane.
    pub far: &'a Lanes,
    /// `ε = exp(−T)`.
    pub epsilon: f32,
}

/// Max-product over all label pairs. `dense` is scratch. Returns the largest value of each lane.
pub(super) fn full_max_update(
    table: &PairTable,
    cavity: &[Lanes],
    potential: FullPotential<'_>,
    dense: &mut Vec<DenseFactors>,
    updated: &mut [Lanes],
) -> Lanes {
    full_update(table, dense, updated, |dense| max_rows(dense, cavity, potential))
}

/// Sum-product over all label pairs. `dense` is scratch. Returns the largest value of each lane.
pub(super) fn full_sum_update(
    table: &PairTable,
    cavity: &[Lanes],
    potential: FullPotential<'_>,
    dense: &mut Vec<DenseFactors>,
    updated: &mut [Lanes],
) -> Lanes {
    full_update(table, dense, updated, |dense| sum_rows(dense, cavity, potential))
}

/// Fills the dense rows for [`ROWS`] labels at a time and computes their messages with `rows`.
fn full_update(
    table: &PairTable,
    dense: &mut Vec<DenseFactors>,
    updated: &mut [Lanes],
    rows: impl Fn(&[DenseFactors]) -> [Lanes; ROWS],
) -> Lanes {
    let n = table.n_labels();
    dense.clear();
    dense.resize(n, [[0.0; 2]; ROWS]);
    let mut largest = Lanes::splat(0.0);
    for start in (0..n).step_by(ROWS) {
        let labels = start..(start + ROWS).min(n);
        for (row, y) in labels.clone().enumerate() {
            for (x, factors) in table.factors(y) {
                dense[x][row] = factors;
            }
        }
        let made = rows(dense);
        for (row, y) in labels.enumerate() {
            for k in 0..BLOCK_LANES {
                largest[k] = if made[row][k] > largest[k] { made[row][k] } else { largest[k] };
            }
            updated[y] = made[row];
            for (x, _) in table.factors(y) {
                dense[x][row] = [0.0; 2];
            }
        }
    }
    largest
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn max_rows(dense: &[DenseFactors], cavity: &[Lanes], potential: FullPotential<'_>) -> [Lanes; ROWS] {
    reduced_rows(dense, cavity, potential, larger)
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn sum_rows(dense: &[DenseFactors], cavity: &[Lanes], potential: FullPotential<'_>) -> [Lanes; ROWS] {
    reduced_rows(dense, cavity, potential, sum)
}

#[inline(always)]
fn larger(best: f32, value: f32) -> f32 {
    if value > best { value } else { best }
}

#[inline(always)]
fn sum(sum: f32, value: f32) -> f32 {
    sum + value
}

/// The terms of [`ROWS`] labels over all labels, combined by `reduce`.
#[inline(always)]
fn reduced_rows(
    dense: &[DenseFactors],
    cavity: &[Lanes],
    potential: FullPotential<'_>,
    reduce: impl Fn(f32, f32) -> f32 + Copy,
) -> [Lanes; ROWS] {
    // A separate variable for each label: the compiler does not vectorize an array of them.
    let [mut first, mut second] = [Lanes::splat(0.0); ROWS];
    for (factors, h) in dense.iter().zip(cavity) {
        add_term(&mut first, potential, factors[0], h, reduce);
        add_term(&mut second, potential, factors[1], h, reduce);
    }
    [first, second]
}

#[inline(always)]
fn add_term(
    reduced: &mut Lanes,
    potential: FullPotential<'_>,
    factors: [f32; 2],
    h: &Lanes,
    reduce: impl Fn(f32, f32) -> f32,
) {
    let FullPotential { near, far, epsilon } = potential;
    for k in 0..BLOCK_LANES {
        let psi = truncated_pair_factor((near[k], far[k]), factors, epsilon);
        reduced[k] = reduce(reduced[k], psi * h[k]);
    }
}
