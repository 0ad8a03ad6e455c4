//! The energy of a labeling: a Markov random field whose variables are source vertices and whose labels are target
//! vertices.
//!
//! ```text
//! E(x) = Σ_i θ_i(x_i) + Σ_{ij ∈ edges} θ_ij(x_i, x_j)          lower is better, no unit
//!
//! θ_i(x)     = α · mean_f [ w_f · min(|f_i − f'_x| / s_f, τ)^p ]                     unary
//! θ_ij(x, y) = min(β · |ℓ_ij − d'(x, y)| / ℓ', T)   if y ∈ N_r(x),   else T          pairwise
//! ```
//!
//! `f` are vertex features with robust scales `s_f`; `ℓ_ij` is the length of the source edge, `d'` the distance on
//! the target and `ℓ'` its mean edge length; `N_r(x)` are the labels within `r` edges of `x`, itself included.
//! Nothing here knows a mesh: a model is made of a graph, a table of unary potentials and label neighbourhoods.
//! Who minimises it is [`crate::inference`]'s business.

pub mod inference;
mod potentials;

pub use potentials::{Feature, unary_potentials};

use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};

/// A labeling: for every variable the label it has.
pub type Labeling = Vec<u32>;

/// The energy: graph, unary table and truncated pairwise potentials. Immutable while it is minimised.
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

/// `θ_ij(x, y)` as a function of `ℓ_ij` and, within the neighbourhood, `d'(x, y)`.
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
    /// The potential for a source edge of `length` and labels at `distance` if they are neighbours, else `None`.
    pub fn potential(&self, length: f64, distance: Option<f64>) -> f64 {
        match distance {
            Some(d) => (self.beta * (length - d).abs() / self.length_scale).min(self.truncation),
            None => self.truncation,
        }
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

    /// `θ_i(·)`, one value a label.
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
    /// With a truncation of infinity (the hard neighbourhood constraint) a labeling that breaks a neighbourhood has
    /// infinite energy, and this says so. JSON has no infinity: a report then leaves the energy out and gives
    /// [`MrfModel::broken_edges`] instead.
    pub fn energy(&self, labeling: &[u32]) -> Energy {
        let mut energy = Energy { unary: 0.0, pairwise: 0.0 };
        for (i, &x) in labeling.iter().enumerate() {
            energy.unary += f64::from(self.unary_row(i)[x as usize]);
            for edge in self.variables.row(i) {
                let j = self.variables.head(edge);
                if i < j {
                    energy.pairwise += self.pairwise_potential(edge, x, labeling[j]);
                }
            }
        }
        energy
    }

    /// Edges (each counted once) whose labels are no neighbours, `y ∉ N_r(x)`: those that pay the truncation because
    /// of where they went and not of how far. 0 means that the labeling keeps every neighbourhood, and that its
    /// energy is finite also where the truncation is not. Cost `O(|E→| log k̄)`.
    pub fn broken_edges(&self, labeling: &[u32]) -> usize {
        let broken = |i: usize, j: usize| {
            i < j && self.labels.distance_within(labeling[i] as usize, labeling[j] as usize).is_none()
        };
        (0..self.n_variables())
            .map(|i| self.variables.neighbors(i).iter().filter(|&&j| broken(i, j as usize)).count())
            .sum()
    }

    /// The labeling that every unary potential prefers alone; the lowest label where two are equal.
    pub fn unary_minimum(&self) -> Labeling {
        (0..self.n_variables())
            .map(|i| {
                let row = self.unary_row(i);
                (0..row.len()).fold(0, |best, x| if row[x] < row[best] { x } else { best }) as u32
            })
            .collect()
    }
}
