#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

pub mod inference;
pub mod metric;
mod potentials;
mod precisions;

pub use potentials::{Feature, FeaturePotentials, unary_potentials};
pub use precisions::learned_weights;

use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};

/// A labeling: the label of every variable.
pub type Labeling = Vec<u32>;

/// The energy: graph, unary table and truncated pairwise potentials. Immutable while it is minimized.
#[derive(Debug, Clone, PartialEq)]
pub struct MrfModel {
    /// Edges between variables.
    pub variables: EdgeGraph,
    /// Length `ℓ_ij` of every directed edge of `variables`, mm; both directions of an edge are equal.
    pub lengths: Vec<f32>,
    /// `N_r` over the labels with `d'`, mm.
    pub labels: LabelNeighborhoods,
    /// Unary potentials `θ_i(x)`, variable by variable, `n_labels` values each.
    pub unary: Vec<f32>,
    /// The pairwise potential.
    pub pairwise: PairwisePotential,
}

/// `θ_ij(x, y)` as a function of `ℓ_ij` and, within the neighborhood, `d'(x, y)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairwisePotential {
    /// Weight `β` of the difference of distances.
    pub beta: f64,
    /// Mean target edge length `ℓ'`, mm.
    pub length_scale: f64,
    /// Truncation `T`.
    pub truncation: f64,
}

impl PairwisePotential {
    /// The potential for a source edge of `length` and labels at `distance` if they are neighbors, else `None`.
    pub fn potential(&self, length: f64, distance: Option<f64>) -> f64 {
        match distance {
            Some(d) => (self.beta * (length - d).abs() / self.length_scale).min(self.truncation),
            None => self.truncation,
        }
    }

    /// `ε = exp(−T)`, or 0 for an infinite truncation (the hard constraint): pairs outside the neighborhood then add
    /// nothing to a message.
    pub(crate) fn epsilon(&self) -> f32 {
        (-self.truncation).exp() as f32
    }
}

/// An energy with its two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy {
    /// Sum of the unary potentials.
    pub unary: f64,
    /// Sum of the pairwise potentials.
    pub pairwise: f64,
}

impl Energy {
    /// The sum over all variables and edges, term by term in a fixed order: `unary(i)` of every variable and
    /// `pairwise(edge, i, j)` of every edge `i < j`.
    pub(crate) fn sum(
        variables: &EdgeGraph,
        unary: impl Fn(usize) -> f32,
        pairwise: impl Fn(usize, usize, usize) -> f64,
    ) -> Self {
        let mut energy = Energy { unary: 0.0, pairwise: 0.0 };
        for i in 0..variables.n_vertices() {
            energy.unary += f64::from(unary(i));
            for edge in variables.row(i) {
                let j = variables.head(edge);
                if i < j {
                    energy.pairwise += pairwise(edge, i, j);
                }
            }
        }
        energy
    }

    /// `E`, the sum of both parts.
    pub fn total(&self) -> f64 {
        self.unary + self.pairwise
    }
}

impl MrfModel {
    /// Number of variables (source vertices).
    pub fn n_variables(&self) -> usize {
        self.variables.n_vertices()
    }

    /// Number of labels (target vertices).
    pub fn n_labels(&self) -> usize {
        self.labels.n_labels()
    }

    /// `θ_i(·)`, one value per label.
    pub fn unary_row(&self, variable: usize) -> &[f32] {
        let n = self.n_labels();
        &self.unary[variable * n..(variable + 1) * n]
    }

    /// `θ_ij(x, y)` for the directed edge with id `edge`.
    pub fn pairwise_potential(&self, edge: usize, x: u32, y: u32) -> f64 {
        let distance = self.labels.distance_within(x as usize, y as usize).map(f64::from);
        self.pairwise.potential(self.lengths[edge].into(), distance)
    }

    /// `E(labeling)`, term by term in a fixed order. Cost `O(|E→| log k̄)`.
    ///
    /// With an infinite truncation (the hard neighborhood constraint) a labeling that breaks a neighborhood has
    /// infinite energy, which is returned. JSON has no infinity: a report then omits the energy and gives
    /// [`MrfModel::broken_edges`] instead.
    pub fn energy(&self, labeling: &[u32]) -> Energy {
        let unary = |i: usize| self.unary_row(i)[labeling[i] as usize];
        Energy::sum(&self.variables, unary, |edge, i, j| self.pairwise_potential(edge, labeling[i], labeling[j]))
    }

    /// Number of edges (each counted once) whose labels are not neighbors, `y ∉ N_r(x)`. These pay the truncation
    /// because of their labels' places, not because of a difference of lengths. 0 means that the labeling keeps every
    /// neighborhood, and that its energy is finite even with an infinite truncation. Cost `O(|E→| log k̄)`.
    pub fn broken_edges(&self, labeling: &[u32]) -> usize {
        let broken = |i: usize, j: usize| {
            i < j && self.labels.distance_within(labeling[i] as usize, labeling[j] as usize).is_none()
        };
        (0..self.n_variables())
            .map(|i| self.variables.neighbors(i).iter().filter(|&&j| broken(i, j as usize)).count())
            .sum()
    }

    /// The labeling of the lowest unary potentials; ties go to the lowest label.
    pub fn unary_minimum(&self) -> Labeling {
        (0..self.n_variables())
            .map(|i| {
                let row = self.unary_row(i);
                (0..row.len()).fold(0, |best, x| if row[x] < row[best] { x } else { best }) as u32
            })
            .collect()
    }
}
