//! Which label pairs the sparse update visits, with the factors of their pairwise potential.

use super::label_rows::LabelRows;
use homolog_primitives::graph::LabelNeighborhoods;

/// Pairs of neighbouring labels with the two factors of their pairwise potential, in rows by label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PairTable {
    offsets: Vec<u32>,
    pairs: Vec<Pair>,
    /// `N_1`, each label included, for maxima.
    pub steps: LabelRows,
    /// `N_r` is that many steps of `N_1`: a maximum over `N_r` is a maximum over `N_1`, that many times. At least 1.
    pub n_steps: usize,
    /// `N_r`, for sums; filled up with the label after the last one.
    pub members: LabelRows,
}

/// A label `x` in `N_r(y)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    pub label: u32,
    /// `exp(β(d'/ℓ' − 1))`.
    pub rising: f32,
    /// Its inverse.
    pub falling: f32,
}

impl PairTable {
    /// The table of `labels` for weight `beta` and length scale `length_scale`. Cost `O(n k̄)`.
    pub fn new(labels: &LabelNeighborhoods, beta: f64, length_scale: f64) -> Self {
        let n = labels.n_labels();
        let mut offsets = vec![0u32];
        let mut pairs = Vec::new();
        let mut nearest = Vec::with_capacity(n);
        for y in 0..n {
            for (&x, &d) in labels.members(y).iter().zip(labels.distances(y)) {
                let exponent = beta * (f64::from(d) / length_scale - 1.0);
                pairs.push(Pair { label: x, rising: exponent.exp() as f32, falling: (-exponent).exp() as f32 });
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
    pub fn n_labels(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The labels of `N_r(y)` with their factors `[rising, falling]`.
    pub fn factors(&self, y: usize) -> impl Iterator<Item = (usize, [f32; 2])> {
        self.row(y).iter().map(|pair| (pair.label as usize, [pair.rising, pair.falling]))
    }

    /// `N_r(y)`.
    pub fn row(&self, y: usize) -> &[Pair] {
        &self.pairs[self.offsets[y] as usize..self.offsets[y + 1] as usize]
    }
}

/// The two factors of `ψ` that belong to a source edge of `length`: `exp(−β(ℓ/ℓ' − 1))` and its inverse.
pub(super) fn edge_factors(beta: f64, length_scale: f64, length: f32) -> (f32, f32) {
    let exponent = beta * (f64::from(length) / length_scale - 1.0);
    ((-exponent).exp() as f32, exponent.exp() as f32)
}
