//! A Markov random field whose pairwise potential compares the distances of any two labels.
//!
//! ```text
//! E(x) = Σ_i θ_i(x_i) + Σ_{ij ∈ edges} min(w_ij (d'(x_i, x_j) − ℓ_ij)², T)          lower is better, no unit
//! ```
//!
//! An edge may join any two variables, near or far. Its potential is a truncated Gaussian log-likelihood of the
//! distance `d'` of the two labels, given the distance `ℓ_ij` of the two variables. [`crate::MrfModel`] asks neighbors
//! to stay neighbors; this model asks all distances to be kept: variables that collapse on one label pay for it on
//! every edge, and far edges hold the whole together. A message costs `K²` operations instead of `K · k̄`, so belief
//! propagation considers a few active labels of each variable, which its beliefs revise.
//!
//! [`MetricModel::propagate`] is belief propagation over some labels of each variable. [`MetricModel::descend`] runs
//! iterated conditional modes from a labeling. [`MetricModel::fused`] combines two labelings, variable by variable.
//!
//! Sources: Pearl 1988 (max-product); Besag, "On the statistical analysis of dirty pictures", 1986 (conditional modes);
//! Anguelov et al., "The correlated correspondence algorithm for unsupervised registration of nonrigid surfaces", NIPS 2004
//! (distances along the surface as pairwise potentials of a correspondence).

mod active;
mod fusion;
#[cfg(test)]
mod tests;

pub use active::{ActiveBeliefs, ActiveLabels, ActiveOptions, Semiring};

use crate::{Energy, Labeling};

/// A pair of variables and the distance that their labels should keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MetricEdge {
    /// The two variables, which differ.
    pub ends: [u32; 2],
    /// `ℓ_ij`, in the unit of the distances between labels.
    pub length: f32,
    /// `w_ij`: half the inverse variance of the difference of both distances.
    pub weight: f32,
}

/// The energy. Immutable while it is minimized.
#[derive(Debug, Clone, PartialEq)]
pub struct MetricModel {
    n_variables: usize,
    n_labels: usize,
    edges: Vec<MetricEdge>,
    /// For each variable its edges.
    edges_of: Vec<Vec<u32>>,
    /// `d'`, row by row.
    distances: Vec<f32>,
    /// `θ_i(x)`, variable by variable.
    unary: Vec<f32>,
    truncation: f32,
}

impl MetricModel {
    /// The model over `distances` between labels (`K × K`, symmetric), `unary` potentials (`n × K`), `edges` and the
    /// truncation `T`.
    ///
    /// # Panics
    /// If `unary` or `distances` do not have these shapes, or an edge names a variable that does not exist.
    pub fn new(distances: Vec<f32>, unary: Vec<f32>, edges: Vec<MetricEdge>, truncation: f32) -> Self {
        let n_labels = distances.len().isqrt();
        assert!(n_labels > 0 && n_labels * n_labels == distances.len(), "distances between labels form a square");
        assert_eq!(unary.len() % n_labels, 0, "a unary potential for each label");
        let n_variables = unary.len() / n_labels;
        let mut edges_of = vec![Vec::new(); n_variables];
        for (edge, MetricEdge { ends, .. }) in edges.iter().enumerate() {
            assert_ne!(ends[0], ends[1], "an edge joins two variables");
            for end in ends {
                edges_of[*end as usize].push(edge as u32);
            }
        }
        MetricModel { n_variables, n_labels, edges, edges_of, distances, unary, truncation }
    }

    /// The same model with other unary potentials.
    ///
    /// # Panics
    /// If `unary` has another shape.
    #[must_use]
    pub fn with_unary(&self, unary: Vec<f32>) -> Self {
        assert_eq!(unary.len(), self.unary.len(), "a unary potential for each variable and label");
        MetricModel { unary, ..self.clone() }
    }

    /// Number of variables `n`.
    pub fn n_variables(&self) -> usize {
        self.n_variables
    }

    /// Number of labels `K`.
    pub fn n_labels(&self) -> usize {
        self.n_labels
    }

    /// `E(labeling)`, term by term in a fixed order. Cost `O(n + edges)`.
    pub fn energy(&self, labeling: &[u32]) -> Energy {
        let unary = labeling.iter().enumerate().map(|(i, &x)| f64::from(self.unary_row(i)[x as usize])).sum();
        let pairwise = |edge: &MetricEdge| {
            let [x, y] = edge.ends.map(|i| labeling[i as usize]);
            f64::from(self.pairwise(edge, self.row(x)[y as usize]))
        };
        Energy { unary, pairwise: self.edges.iter().map(pairwise).sum() }
    }

    /// The share of each variable in the energy: its unary term and half of the terms of its edges. Cost `O(n +
    /// edges)`.
    pub fn shares(&self, labeling: &[u32]) -> Vec<f64> {
        let mut shares: Vec<f64> =
            labeling.iter().enumerate().map(|(i, &x)| f64::from(self.unary_row(i)[x as usize])).collect();
        for edge in &self.edges {
            let [x, y] = edge.ends.map(|i| labeling[i as usize]);
            let half = 0.5 * f64::from(self.pairwise(edge, self.row(x)[y as usize]));
            edge.ends.iter().for_each(|&i| shares[i as usize] += half);
        }
        shares
    }

    /// Number of edges that cost the truncation because their distances differ too much.
    pub fn truncated_edges(&self, labeling: &[u32]) -> usize {
        let is_truncated = |edge: &&MetricEdge| {
            let [x, y] = edge.ends.map(|i| labeling[i as usize]);
            self.pairwise(edge, self.row(x)[y as usize]) >= self.truncation
        };
        self.edges.iter().filter(is_truncated).count()
    }

    /// The cost of each label for `variable` while all others keep theirs. Cost `O(K · degree)`.
    pub fn conditional(&self, variable: usize, labeling: &[u32]) -> Vec<f32> {
        let mut cost = self.unary_row(variable).to_vec();
        for &edge in &self.edges_of[variable] {
            let edge = &self.edges[edge as usize];
            let other = edge.ends[usize::from(edge.ends[0] as usize == variable)];
            for (cost, &distance) in cost.iter_mut().zip(self.row(labeling[other as usize])) {
                *cost += self.pairwise(edge, distance);
            }
        }
        cost
    }

    /// Iterated conditional modes: variables in turn take the label that costs least (ties go to the lowest), until
    /// none changes or `sweeps` are over. The energy never rises. Cost `O(sweeps · K · edges)`.
    pub fn descend(&self, mut labeling: Labeling, sweeps: usize) -> Labeling {
        // A variable whose neighbors have not changed since its last turn would take the same label again.
        let mut has_turn = vec![true; self.n_variables];
        for _ in 0..sweeps {
            let mut changed = false;
            for i in 0..self.n_variables {
                if !std::mem::replace(&mut has_turn[i], false) {
                    continue;
                }
                let cost = self.conditional(i, &labeling);
                let best = lowest(&cost);
                if cost[best] < cost[labeling[i] as usize] {
                    labeling[i] = best as u32;
                    changed = true;
                    for &edge in &self.edges_of[i] {
                        self.edges[edge as usize]
                            .ends
                            .iter()
                            .for_each(|&end| has_turn[end as usize] |= end as usize != i);
                    }
                }
            }
            if !changed {
                break;
            }
        }
        labeling
    }

    /// The labeling of the lowest unary potentials; ties go to the lowest label.
    pub fn unary_minimum(&self) -> Labeling {
        (0..self.n_variables).map(|i| lowest(self.unary_row(i)) as u32).collect()
    }

    fn unary_row(&self, variable: usize) -> &[f32] {
        &self.unary[variable * self.n_labels..][..self.n_labels]
    }

    /// `d'(x, ·)`.
    fn row(&self, x: u32) -> &[f32] {
        &self.distances[x as usize * self.n_labels..][..self.n_labels]
    }

    fn pairwise(&self, edge: &MetricEdge, distance: f32) -> f32 {
        let missed = distance - edge.length;
        (edge.weight * (missed * missed)).min(self.truncation)
    }
}

/// Index of the lowest number; ties go to the first.
fn lowest(cost: &[f32]) -> usize {
    (0..cost.len()).fold(0, |best, x| if cost[x] < cost[best] { x } else { best })
}
