//! Label pairs visited by the sparse update, with the factors of their pairwise potential.

use super::label_rows::LabelRows;
use homolog_primitives::graph::LabelNeighborhoods;

/// Pairs of neighboring labels with the two factors of their pairwise potential, in rows by label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PairTable {
    offsets: Vec<u32>,
    pairs: Vec<Pair>,
    /// `N_1`, each label included, for maxima.
    pub steps: LabelRows,
    /// Number of steps of `N_1` that make `N_r`: a maximum over `N_r` is a maximum over `N_1`, repeated. At least 1.
    pub n_steps: usize,
    /// `N_r`, for sums; padded with the label after the last one.
    pub members: LabelRows,
}

/// A label `x` in `N_r(y)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    pub label: u32,
    /// `exp(β(d'/ℓ' − 1))`, which rises with the distance, and its inverse, which falls with it.
    pub factors: [f32; 2],
}

impl PairTable {
    /// The table of `labels` for weight `beta` and length scale `length_scale`. Cost `O(n k̄)`.
    pub(super) fn new(labels: &LabelNeighborhoods, beta: f64, length_scale: f64) -> Self {
        let n = labels.n_labels();
        let mut offsets = vec![0u32];
        let mut pairs = Vec::new();
        let mut nearest = Vec::with_capacity(n);
        for y in 0..n {
            for (&x, &d) in labels.members(y).iter().zip(labels.distances(y)) {
                let (falling, rising) = edge_factors(beta, length_scale, d);
                pairs.push(Pair { label: x, factors: [rising, falling] });
            }
            offsets.push(pairs.len() as u32);
            let neighbors = if labels.rings() > 0 { labels.graph().neighbors(y) } else { &[] };
            nearest.push(neighbors.iter().copied().chain([y as u32]).collect::<Vec<u32>>());
        }
        PairTable {
            offsets,
            pairs,
            steps: LabelRows::new(n, |y| &nearest[y], |y| y as u32),
            n_steps: labels.rings().max(1),
            members: LabelRows::new(n, |y| labels.members(y), |_| n as u32),
        }
    }

    /// Number of labels `n`.
    pub(super) fn n_labels(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The labels of `N_r(y)` with their factors `[rising, falling]`.
    pub(super) fn factors(&self, y: usize) -> impl Iterator<Item = (usize, [f32; 2])> {
        self.row(y).iter().map(|pair| (pair.label as usize, pair.factors))
    }

    /// `N_r(y)`.
    pub(super) fn row(&self, y: usize) -> &[Pair] {
        &self.pairs[self.offsets[y] as usize..self.offsets[y + 1] as usize]
    }
}

/// `ψ = exp(−β|ℓ − d'|/ℓ')` from the [`edge_factors`] of an edge and the factors `[rising, falling]` of a label pair:
/// the smaller of a product and its inverse, so that no loop over labels needs an exponential.
#[inline(always)]
pub(super) fn pair_factor((near, far): (f32, f32), [rising, falling]: [f32; 2]) -> f32 {
    let (a, b) = (near * rising, far * falling);
    if a < b { a } else { b }
}

/// [`pair_factor`], truncated below at `ε = exp(−T)`.
#[inline(always)]
pub(super) fn truncated_pair_factor(edge: (f32, f32), pair: [f32; 2], epsilon: f32) -> f32 {
    let psi = pair_factor(edge, pair);
    if psi > epsilon { psi } else { epsilon }
}

/// Largest exponent of a factor: neither the factor nor its inverse is 0 or infinite in 32 bits, which would make
/// products undefined.
const LARGEST_EXPONENT: f64 = 85.0;

/// The two factors of `ψ` for an edge of `length`: `exp(−β(ℓ/ℓ' − 1))` and its inverse, the larger of which is at most
/// `exp(85)`.
pub(super) fn edge_factors(beta: f64, length_scale: f64, length: f32) -> (f32, f32) {
    let exponent = beta * (f64::from(length) / length_scale - 1.0);
    let exponent = exponent.clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT);
    ((-exponent).exp() as f32, exponent.exp() as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_has_a_factor_of_at_most_1_at_any_weight() {
        for beta in [0.0, 1.0, 1e3, 1e9] {
            for (edge, pair) in [(0.5f32, 3.0f32), (3.0, 0.5), (3.0, 3.0), (1.0, 3.0), (0.0, 1e9)] {
                let (falling, rising) = edge_factors(beta, 1.0, pair);
                let factor = pair_factor(edge_factors(beta, 1.0, edge), [rising, falling]);
                assert!((0.0..=1.0 + 1e-6).contains(&factor), "{factor} of {edge}, {pair} at {beta}");
            }
        }
    }
}
