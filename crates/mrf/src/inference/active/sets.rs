//! Size, initial choice and revision of candidate sets.

use super::candidates::Candidates;
use super::potentials::UnaryInput;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Variables between two calls of the observer.
const BATCH: usize = 1024;

/// Sizes and revisions of candidate sets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveSets {
    /// Number of initial labels of a variable: those of its lowest unary potentials. At least 1.
    pub initial: usize,
    /// Largest number of labels that a revision keeps because of their belief. At least 1.
    pub kept: usize,
    /// Largest number of labels of a variable after a revision, including proposals of its neighbors.
    pub largest: usize,
    /// A label is dropped if its cost exceeds the variable's best by more than this margin. The cost is the unary
    /// potential at the start, and the belief as an energy later; feedback is included.
    pub margin: f32,
    /// Iterations between revisions, at least 1.
    pub every: u32,
    /// Number of best labels of each neighbor whose `N_1` is added to a variable at a revision.
    pub best_of_neighbors: usize,
}

impl ActiveSets {
    /// The sets proposed by `evidence` alone for `n_variables` over `n_labels`: the [`ActiveSets::initial`] labels of
    /// lowest potential within the margin of the lowest; ties go to the lower label.
    ///
    /// Cost `O(n_variables · n_labels)`, on all cores; memory of one row per thread.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn propose(
        &self,
        n_variables: usize,
        n_labels: usize,
        evidence: UnaryInput<'_>,
        observer: &dyn Observer,
    ) -> Result<Candidates, Cancelled> {
        let rows = self.lowest(n_variables, n_labels, evidence, observer)?;
        let rows: Vec<(Vec<u32>, Vec<f32>)> =
            rows.into_par_iter().enumerate().map(|(i, labels)| with_potentials(evidence, i, labels)).collect();
        Ok(Candidates::from_rows(rows.into_iter()))
    }

    /// The labels of [`ActiveSets::propose`], ascending, for every variable.
    pub(super) fn lowest(
        &self,
        n_variables: usize,
        n_labels: usize,
        evidence: UnaryInput<'_>,
        observer: &dyn Observer,
    ) -> Result<Vec<Vec<u32>>, Cancelled> {
        let mut rows: Vec<Vec<u32>> = Vec::with_capacity(n_variables);
        for start in (0..n_variables).step_by(BATCH) {
            checkpoint(observer)?;
            let batch = (start..(start + BATCH).min(n_variables)).into_par_iter().map_init(
                || (vec![0.0; n_labels], vec![0.0; n_labels]),
                |(row, bias), i| {
                    evidence.row(i, row, bias);
                    self.lowest_of(row)
                },
            );
            rows.par_extend(batch);
        }
        Ok(rows)
    }

    fn lowest_of(&self, row: &[f32]) -> Vec<u32> {
        let lowest = row.iter().copied().fold(f32::INFINITY, f32::min);
        let within = row.iter().enumerate().filter(|(_, theta)| **theta <= lowest + self.margin);
        let mut found: Vec<(f32, u32)> = within.map(|(x, &theta)| (theta, x as u32)).collect();
        keep_first(&mut found, self.initial.max(1), |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut labels: Vec<u32> = found.into_iter().map(|(_, x)| x).collect();
        labels.sort_unstable();
        labels
    }
}

/// Keeps the first `count` of `values` in the order of `compare`, in any order.
pub(super) fn keep_first<T>(values: &mut Vec<T>, count: usize, compare: impl Fn(&T, &T) -> std::cmp::Ordering) {
    if values.len() > count {
        values.select_nth_unstable_by(count, compare);
        values.truncate(count);
    }
}

/// A row of candidates.
pub(super) fn with_potentials(evidence: UnaryInput<'_>, variable: usize, labels: Vec<u32>) -> (Vec<u32>, Vec<f32>) {
    let mut unary = vec![0.0; labels.len()];
    evidence.unary.at(variable, &labels, &mut unary);
    (labels, unary)
}
