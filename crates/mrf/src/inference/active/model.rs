//! The energy over candidate labels.

use super::candidates::{CandidateError, Candidates, MAX_CANDIDATES};
use crate::{Energy, MrfModel, PairwisePotential};
use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};

/// The energy of [`crate`], with unary potentials for candidate labels only.
#[derive(Debug, Clone, PartialEq)]
pub struct ActiveModel<'a> {
    pub(super) variables: &'a EdgeGraph,
    pub(super) lengths: &'a [f32],
    pub(super) labels: &'a LabelNeighborhoods,
    pub(super) pairwise: PairwisePotential,
    pub(super) candidates: Candidates,
}

impl<'a> ActiveModel<'a> {
    /// The model of `variables` with edges of `lengths` (mm, one per directed edge), whose variables take labels from
    /// `candidates`; `labels` are the neighborhoods of the labels.
    ///
    /// # Errors
    /// [`CandidateError`]: `lengths` must have one value per directed edge and `candidates` one row per variable. A
    /// row, and the union of the candidates of a variable's neighbors, may have at most 65,536 labels.
    pub fn new(
        variables: &'a EdgeGraph,
        lengths: &'a [f32],
        labels: &'a LabelNeighborhoods,
        pairwise: PairwisePotential,
        candidates: Candidates,
    ) -> Result<Self, CandidateError> {
        let mismatch = |what, found, expected| Err(CandidateError::LengthMismatch { what, found, expected });
        let n = variables.n_vertices();
        if lengths.len() != variables.n_directed_edges() {
            return mismatch("lengths", lengths.len(), variables.n_directed_edges());
        }
        if candidates.n_variables() != n {
            return mismatch("rows of candidates", candidates.n_variables(), n);
        }
        for variable in 0..n {
            let row = candidates.labels(variable);
            if row.last().is_some_and(|&x| x as usize >= labels.n_labels()) {
                return Err(CandidateError::NotAscending { variable, n_labels: labels.n_labels() });
            }
            let size = |&j: &u32| candidates.labels(j as usize).len();
            let around: usize = variables.neighbors(variable).iter().map(size).sum();
            let found = row.len().max(around.min(labels.n_labels()));
            if found > MAX_CANDIDATES {
                return Err(CandidateError::TooManyCandidates { variable, found });
            }
        }
        Ok(ActiveModel { variables, lengths, labels, pairwise, candidates })
    }

    /// `model` restricted to `candidates`.
    ///
    /// # Errors
    /// As [`ActiveModel::new`].
    pub fn of(model: &'a MrfModel, candidates: Candidates) -> Result<Self, CandidateError> {
        ActiveModel::new(&model.variables, &model.lengths, &model.labels, model.pairwise, candidates)
    }

    /// The candidate sets.
    pub fn candidates(&self) -> &Candidates {
        &self.candidates
    }

    /// Number of variables.
    pub fn n_variables(&self) -> usize {
        self.variables.n_vertices()
    }

    /// `E` of a labeling whose labels are candidates, term by term in the fixed order of [`MrfModel::energy`]. Cost
    /// `O(|E→| log k̄ + n log K)`.
    pub(super) fn energy(&self, labeling: &[u32]) -> Energy {
        let unary = |i: usize| {
            // Every label was decoded from these candidates, so the search always finds it.
            let at = self.candidates.labels(i).binary_search(&labeling[i]).unwrap_or_default();
            self.candidates.unary(i)[at]
        };
        Energy::sum(self.variables, unary, |edge, i, j| {
            let distance = self.labels.distance_within(labeling[i] as usize, labeling[j] as usize);
            self.pairwise.potential(self.lengths[edge].into(), distance.map(f64::from))
        })
    }
}
