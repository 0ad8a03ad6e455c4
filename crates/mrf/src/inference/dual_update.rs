//! The two steps of dual ascent, on whole numbers: a variable shares out its energy, and an edge passes it on.
//!
//! The choice of the grid keeps sums within 30 bits ([`super::fixed_point`]), so wrapping arithmetic never wraps. It is
//! used because overflow checks would prevent vectorization.

use super::block_plan::LANES;
use super::fixed_point::Grid;
use crate::MrfModel;
use multiversion::multiversion;

/// One whole number for each lane.
type Units = [i32; LANES];

/// Neighboring labels with `βd'/ℓ'`, in grid units, in rows by label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct UnitTable {
    offsets: Vec<u32>,
    /// Label and scaled distance.
    pairs: Vec<(u32, i32)>,
}

impl UnitTable {
    /// Cost `O(n k̄)`.
    pub(super) fn new(model: &MrfModel, grid: &Grid) -> Self {
        let mut offsets = vec![0u32];
        let mut pairs = Vec::new();
        for y in 0..model.n_labels() {
            let members = model.labels.members(y).iter().zip(model.labels.distances(y));
            pairs.extend(members.map(|(&x, &distance)| (x, grid.scaled_length(model, distance))));
            offsets.push(pairs.len() as u32);
        }
        UnitTable { offsets, pairs }
    }

    /// The labels of `N_r(y)` with their scaled distances.
    pub(super) fn row(&self, y: usize) -> &[(u32, i32)] {
        &self.pairs[self.offsets[y] as usize..self.offsets[y + 1] as usize]
    }
}

/// Adds `row` to `sum`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn add(sum: &mut [i32], row: &[i32]) {
    for (sum, &value) in sum.iter_mut().zip(row) {
        *sum = sum.wrapping_add(value);
    }
}

/// The smallest value and its first position.
pub(super) fn minimum(values: &[i32]) -> (usize, i32) {
    let lowest = values.iter().copied().min().unwrap_or(0);
    (values.iter().position(|&v| v == lowest).unwrap_or(0), lowest)
}

/// Turns the reparametrized unary potential of a variable into the share of each of its edges: the excess over the
/// minimum, divided by `parts` and rounded down. At the minimum the share is 0, and all shares together never exceed
/// the excess, so the minimum keeps its place and value.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn shares(potential: &mut [i32], lowest: i32, parts: usize) {
    // Exact division is slow; the product with the inverse, rounded down, is at most one unit lower.
    let inverse = (1u64 << 32) / parts.max(1) as u64;
    for value in potential {
        *value = ((value.wrapping_sub(lowest) as u64 * inverse) >> 32) as i32;
    }
}

/// Subtracts `share` from `row`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
pub(super) fn subtract(row: &mut [i32], share: &[i32]) {
    for (value, &share) in row.iter_mut().zip(share) {
        *value = value.wrapping_sub(share);
    }
}

/// Scratch of one block.
#[derive(Debug, Clone)]
pub(super) struct PassScratch {
    /// Negated messages `j → i`, `[label][lane]`.
    against: Vec<Units>,
    /// New messages `i → j`, `[label][lane]`.
    made: Vec<Units>,
}

impl PassScratch {
    /// Room for `n` labels.
    pub(super) fn new(n: usize) -> Self {
        PassScratch { against: vec![[0; LANES]; n], made: vec![[0; LANES]; n] }
    }
}

/// Up to [`LANES`] messages `m(y) = min( T + min h, min_{x ∈ N_r(y)} θ(x, y) + h(x) )` with `h = −against`, where
/// `against` are the messages of the opposite direction. Each message, minus its minimum, is written into its row of
/// `outgoing`; the minima are returned. `lengths` are the scaled lengths of the edges. `uniform` states that lengths
/// and distances have no weight (`β = 0`).
pub(super) fn pass_on(
    table: &UnitTable,
    against: &[&[i32]],
    lengths: &Units,
    (truncation, uniform): (i32, bool),
    scratch: &mut PassScratch,
    outgoing: &mut [Vec<i32>],
) -> Units {
    let mut ceiling = [0i32; LANES];
    for (lane, row) in against.iter().enumerate() {
        for (label, &value) in scratch.against.iter_mut().zip(*row) {
            label[lane] = value.wrapping_neg();
        }
        let highest = row.iter().copied().max().unwrap_or(0);
        ceiling[lane] = truncation.wrapping_sub(highest);
    }
    let minima = if uniform {
        make_uniform(table, &scratch.against, &ceiling, &mut scratch.made)
    } else {
        make(table, &scratch.against, lengths, &ceiling, &mut scratch.made)
    };
    for (lane, row) in outgoing.iter_mut().enumerate() {
        for (value, made) in row.iter_mut().zip(&scratch.made) {
            *value = made[lane].wrapping_sub(minima[lane]);
        }
    }
    minima
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn make(table: &UnitTable, against: &[Units], lengths: &Units, ceiling: &Units, made: &mut [Units]) -> Units {
    let mut minima = [i32::MAX; LANES];
    for (y, made) in made.iter_mut().enumerate() {
        let mut best = *ceiling;
        for &(x, distance) in table.row(y) {
            let h = &against[x as usize];
            for k in 0..LANES {
                let value = lengths[k].wrapping_sub(distance).wrapping_abs().wrapping_add(h[k]);
                best[k] = if value < best[k] { value } else { best[k] };
            }
        }
        for k in 0..LANES {
            minima[k] = if best[k] < minima[k] { best[k] } else { minima[k] };
        }
        *made = best;
    }
    minima
}

#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn make_uniform(table: &UnitTable, against: &[Units], ceiling: &Units, made: &mut [Units]) -> Units {
    let mut minima = [i32::MAX; LANES];
    for (y, made) in made.iter_mut().enumerate() {
        let mut best = *ceiling;
        for &(x, _) in table.row(y) {
            let h = &against[x as usize];
            for k in 0..LANES {
                best[k] = if h[k] < best[k] { h[k] } else { best[k] };
            }
        }
        for k in 0..LANES {
            minima[k] = if best[k] < minima[k] { best[k] } else { minima[k] };
        }
        *made = best;
    }
    minima
}
