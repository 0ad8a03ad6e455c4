//! The energy on a grid of whole numbers, never above the energy itself.
//!
//! The lower bound adds and subtracts messages millions of times. Whole numbers of 32 bits make this exact, as fast as
//! floating point of the same width, and finer: the grid has up to 30 bits, a float has 24. Rounding happens only once,
//! when potentials are put on the grid, and only downwards.

use crate::MrfModel;

/// Largest magnitude of any sum of messages, in grid units; half of the range of 32 bits.
const LARGEST: f64 = (1u32 << 30) as f64;
/// Limits of a lowered truncation, as multiples of the largest other potential. A huge or infinite truncation would
/// coarsen the grid. It is therefore lowered to the cost, above the sum of the smallest unary potentials, of the best
/// labeling with one label for all variables. That labeling breaks no neighborhood, so no labeling that breaks one is
/// then the minimum, and the minimum stays in place. The truncation is not lowered below the first multiple, nor kept
/// above the second, which matters for models with many variables. A lower truncation only lowers the energy, and hence
/// the bound.
const HARD_TRUNCATION: [f64; 2] = [4.0, 256.0];

/// The grid of whole numbers: `k` stands for the energy `k · unit`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    /// A power of two, so that scaling by it does not round.
    unit: f64,
    /// Truncation `T`, units.
    pub truncation: i32,
    /// Smallest unary potential of every variable.
    minima: Vec<f64>,
    /// Total by which the pairwise potentials may have been rounded up, units.
    pairwise_excess: i64,
    /// Bound on the rounding error of the sums of 64 bits, here and in [`MrfModel::energy`].
    sum_error: f64,
}

impl Grid {
    /// The finest grid on which no sum of messages of `model` overflows. Cost: two passes over the unary potentials.
    pub(super) fn new(model: &MrfModel) -> Self {
        let n_variables = model.n_variables();
        let n_edges = model.variables.n_directed_edges() / 2;
        let degree = (0..n_variables).map(|i| model.variables.row(i).len()).max().unwrap_or(0);
        let bounds = |values: &[f32]| {
            let ends = values.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), &v| (a.min(v), b.max(v)));
            (f64::from(ends.0), f64::from(ends.1))
        };
        let rows: Vec<(f64, f64)> = (0..n_variables).map(|i| bounds(model.unary_row(i))).collect();
        let range = rows.iter().map(|(low, high)| high - low).fold(0.0, f64::max);
        let pairwise = model.pairwise;
        let scaled = pairwise.beta / pairwise.length_scale;
        // Neither part of |βℓ/ℓ' − βd'/ℓ'| exceeds this value, and neither does their difference.
        let longest = bounds(&model.lengths).1.max(0.0);
        let farthest = (0..model.n_labels()).map(|x| bounds(model.labels.distances(x)).1).fold(0.0, f64::max);
        let near = scaled * longest.max(farthest);
        let hard = HARD_TRUNCATION.map(|times| times * range.max(near));
        let truncation = pairwise.truncation.min(cost_of_one_label(model, &rows).clamp(hard[0], hard[1]));
        // A variable gathers its unary potential and the messages of all neighbors, each at most the truncation; a
        // message is computed from that sum, a potential and one more message.
        let largest = range + near + (degree + 2) as f64 * truncation;
        let unit = if largest > 0.0 { (largest / LARGEST).log2().ceil().exp2() } else { 1.0 };
        let magnitude: f64 = rows.iter().map(|(low, high)| low.abs().max(high.abs())).sum();
        let n_terms = (n_variables + n_edges) as f64;
        Grid {
            unit,
            truncation: (truncation / unit).floor() as i32,
            minima: rows.iter().map(|row| row.0).collect(),
            // Both parts of the difference are rounded to the nearest unit, half a unit each at most.
            pairwise_excess: if pairwise.beta == 0.0 { 0 } else { n_edges as i64 },
            // Number of terms times the sum of their magnitudes times the rounding of one addition.
            sum_error: f64::EPSILON * n_terms * (magnitude + n_edges as f64 * truncation.max(near)),
        }
    }

    /// Writes the unary potentials of a row, relative to the smallest and rounded down, into `row`.
    pub(super) fn unary(&self, variable: usize, potentials: &[f32], row: &mut Vec<i32>) {
        let low = self.minima[variable];
        row.clear();
        row.extend(potentials.iter().map(|&theta| ((f64::from(theta) - low) / self.unit) as i32));
    }

    /// `β·length/ℓ'` to the nearest unit.
    pub(super) fn scaled_length(&self, model: &MrfModel, length: f32) -> i32 {
        (model.pairwise.beta * f64::from(length) / model.pairwise.length_scale / self.unit).round() as i32
    }

    /// The lower bound for `units` above the sum of the smallest unary potentials, minus what rounding may have added
    /// to the energy.
    pub(super) fn bound(&self, units: i64) -> f64 {
        let base: f64 = self.minima.iter().sum();
        base + (units - self.pairwise_excess) as f64 * self.unit - self.sum_error
    }

    /// The bound without messages: every unary potential at its smallest, no pairwise potential below 0.
    pub(super) fn trivial_bound(&self) -> f64 {
        self.minima.iter().sum::<f64>() - self.sum_error
    }
}

/// Lowest energy of a labeling of one label for all variables, above the sum of the smallest unary potentials.
fn cost_of_one_label(model: &MrfModel, rows: &[(f64, f64)]) -> f64 {
    let mut costs = vec![0.0; model.n_labels()];
    for (i, (low, _)) in rows.iter().enumerate() {
        for (cost, &theta) in costs.iter_mut().zip(model.unary_row(i)) {
            *cost += f64::from(theta) - low;
        }
    }
    let unary = costs.into_iter().fold(f64::INFINITY, f64::min);
    let stretch: f64 = model.lengths.iter().map(|&length| f64::from(length)).sum::<f64>() / 2.0;
    unary + stretch * model.pairwise.beta / model.pairwise.length_scale
}
