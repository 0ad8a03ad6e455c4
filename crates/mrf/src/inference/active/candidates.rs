//! The labels that each variable may take, in compressed rows.

use crate::MrfModel;

/// Limit of candidates: the inner loops count labels and candidates with 16 bits.
pub(super) const MAX_CANDIDATES: usize = 1 << 16;

/// Candidate labels of every variable with their unary potentials; rows ascending, none empty.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidates {
    offsets: Vec<usize>,
    labels: Vec<u32>,
    unary: Vec<f32>,
}

/// Reasons why candidate sets cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CandidateError {
    /// Offsets, labels and potentials do not match each other or the model.
    #[error("{found} {what} where {expected} are needed")]
    LengthMismatch {
        /// The mismatched item.
        what: &'static str,
        /// Number found.
        found: usize,
        /// Number expected.
        expected: usize,
    },
    /// Offsets decrease, or a row is empty.
    #[error("variable {variable} has no candidate")]
    NoCandidate {
        /// The variable.
        variable: usize,
    },
    /// A row is not strictly ascending, or names a label that does not exist.
    #[error("the candidates of variable {variable} are not ascending labels below {n_labels}")]
    NotAscending {
        /// The variable.
        variable: usize,
        /// Number of labels of the model.
        n_labels: usize,
    },
    /// A row, or the union of the rows of a variable's neighbors, is longer than can be counted.
    #[error("variable {variable} or its neighbors have {found} candidates; {MAX_CANDIDATES} can be held")]
    TooManyCandidates {
        /// The variable.
        variable: usize,
        /// The number of its candidates, or of the candidates of its neighbors together.
        found: usize,
    },
}

impl Candidates {
    /// Candidates of variable `i` at `offsets[i]..offsets[i + 1]` of `labels`, with their unary potentials `θ_i(x)`.
    ///
    /// # Errors
    /// [`CandidateError`]: lengths that differ, empty rows, or rows that are not strictly ascending below `n_labels`.
    pub fn new(
        offsets: Vec<usize>,
        labels: Vec<u32>,
        unary: Vec<f32>,
        n_labels: usize,
    ) -> Result<Self, CandidateError> {
        let mismatch = |what, found, expected| Err(CandidateError::LengthMismatch { what, found, expected });
        if unary.len() != labels.len() {
            return mismatch("unary potentials", unary.len(), labels.len());
        }
        if offsets.first() != Some(&0) || offsets.last() != Some(&labels.len()) {
            return mismatch("labels", labels.len(), offsets.last().copied().unwrap_or(0));
        }
        for (variable, ends) in offsets.windows(2).enumerate() {
            if ends[0] >= ends[1] || ends[1] > labels.len() {
                return Err(CandidateError::NoCandidate { variable });
            }
            let row = &labels[ends[0]..ends[1]];
            let ascending = row.windows(2).all(|pair| pair[0] < pair[1]);
            if !ascending || row.last().is_some_and(|&x| x as usize >= n_labels) {
                return Err(CandidateError::NotAscending { variable, n_labels });
            }
        }
        Ok(Candidates { offsets, labels, unary })
    }

    /// Every label for every variable of `model`.
    pub fn all(model: &MrfModel) -> Self {
        let (n, n_labels) = (model.n_variables(), model.n_labels());
        Candidates {
            offsets: (0..=n).map(|i| i * n_labels).collect(),
            labels: (0..n).flat_map(|_| 0..n_labels as u32).collect(),
            unary: model.unary.clone(),
        }
    }

    /// Candidates from rows that are known to be ascending and nonempty.
    pub(super) fn from_rows(rows: impl Iterator<Item = (Vec<u32>, Vec<f32>)>) -> Self {
        let mut made = Candidates { offsets: vec![0], labels: Vec::new(), unary: Vec::new() };
        for (labels, unary) in rows {
            made.labels.extend(labels);
            made.unary.extend(unary);
            made.offsets.push(made.labels.len());
        }
        made
    }

    /// Number of variables.
    pub fn n_variables(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Number of candidates of all variables together.
    pub fn n_candidates(&self) -> usize {
        self.labels.len()
    }

    /// Candidates of `variable`, ascending.
    pub fn labels(&self, variable: usize) -> &[u32] {
        &self.labels[self.offsets[variable]..self.offsets[variable + 1]]
    }

    /// `θ_i(x)` of the candidates of `variable`, in the order of [`Candidates::labels`].
    pub fn unary(&self, variable: usize) -> &[f32] {
        &self.unary[self.offsets[variable]..self.offsets[variable + 1]]
    }

    /// Mean number of candidates per variable.
    pub fn mean_size(&self) -> f64 {
        self.labels.len() as f64 / self.n_variables().max(1) as f64
    }
}
