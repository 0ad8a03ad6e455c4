//! A labeling that changes one label at a time, its running energy, and the best labeling so far.

use super::energy::{SearchEnergy, Terms};

/// One change: variable `variable` takes `label`, and the energy changes by `delta`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct SiteMove {
    pub variable: u32,
    pub label: u32,
    pub delta: Terms,
}

/// The present labeling and the best one.
///
/// A new best labeling is not copied at once, which would cost `O(n)` each time. Later changes are written into a
/// journal instead, and [`SearchState::settle`] reverts them once per sweep. The best is thus the best after any single
/// change, at `O(1)` per change.
pub(super) struct SearchState {
    labels: Vec<u32>,
    terms: Terms,
    best_labels: Vec<u32>,
    best_terms: Terms,
    /// Whether the best labeling is `labels` with the journal reverted, instead of `best_labels`.
    best_in_journal: bool,
    /// Changes since the best labeling: variable and previous label.
    journal: Vec<(u32, u32)>,
    target: Option<f64>,
}

impl SearchState {
    /// Starts from `labels`, which count as the best so far. `target` is the energy (of the model, without bias) to
    /// watch for.
    pub(super) fn new(energy: &SearchEnergy<'_>, labels: Vec<u32>, target: Option<f64>) -> Self {
        let terms = energy.all(&labels);
        SearchState {
            best_labels: labels.clone(),
            best_terms: terms,
            best_in_journal: false,
            journal: Vec::with_capacity(labels.len()),
            target,
            terms,
            labels,
        }
    }

    /// The present labels.
    pub(super) fn labels(&self) -> &[u32] {
        &self.labels
    }

    /// The present energy, accumulated over all changes.
    pub(super) fn terms(&self) -> &Terms {
        &self.terms
    }

    /// Energy of the best labeling.
    pub(super) fn best_terms(&self) -> &Terms {
        &self.best_terms
    }

    /// The best labeling, as of the last [`SearchState::settle`].
    pub(super) fn best_labels(&self) -> &[u32] {
        &self.best_labels
    }

    /// Makes one change.
    pub(super) fn apply(&mut self, change: &SiteMove) {
        let slot = &mut self.labels[change.variable as usize];
        if self.best_in_journal {
            self.journal.push((change.variable, *slot));
        }
        *slot = change.label;
        self.terms = self.terms.plus(&change.delta);
        self.note_best();
    }

    /// Continues from other labels; the best labeling is kept.
    pub(super) fn restart(&mut self, energy: &SearchEnergy<'_>, labels: Vec<u32>) {
        self.settle();
        self.terms = energy.all(&labels);
        self.labels = labels;
        self.note_best();
    }

    fn note_best(&mut self) {
        if self.terms.total() < self.best_terms.total() {
            self.best_terms = self.terms;
            self.best_in_journal = true;
            self.journal.clear();
        }
    }

    /// Brings [`SearchState::best_labels`] up to date. Cost `O(n)`, no allocation.
    pub(super) fn settle(&mut self) {
        if self.best_in_journal {
            self.best_labels.copy_from_slice(&self.labels);
            for &(variable, label) in self.journal.iter().rev() {
                self.best_labels[variable as usize] = label;
            }
            self.journal.clear();
            self.best_in_journal = false;
        }
    }

    /// Whether the present labeling reaches the target, by a full evaluation of the model's own energy. Free of cost
    /// while the running energy is clearly above the target.
    pub(super) fn reaches_target(&self, energy: &SearchEnergy<'_>) -> bool {
        let Some(target) = self.target else { return false };
        // The running energy carries the rounding of many sums; it only decides whether to evaluate in full.
        let slack = 1e-9 * (1.0 + target.abs());
        self.terms.energy().total() <= target + slack && energy.model.energy(&self.labels).total() <= target
    }
}
