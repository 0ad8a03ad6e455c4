//! The labeling of a run over candidates as it changes, and the history of its iterations.

use super::super::convergence::History;
use super::super::outcome::{BpIteration, BpOutcome, BpStop};
use super::model::ActiveModel;
use crate::Energy;

/// The largest belief of a variable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen {
    /// Its number among the candidates.
    pub candidate: u32,
    /// Its share of all beliefs.
    pub confidence: f64,
}

/// The labeling of a run as it changes.
pub(super) struct Progress {
    labeling: Vec<u32>,
    confidence: Vec<f64>,
    energy: Energy,
    history: History,
    pub iterations: u32,
}

impl Progress {
    /// Before the first labeling is decoded.
    pub fn new(n_variables: usize) -> Self {
        Progress {
            labeling: vec![0; n_variables],
            confidence: vec![1.0; n_variables],
            energy: Energy { unary: 0.0, pairwise: 0.0 },
            history: History::default(),
            iterations: 0,
        }
    }

    /// Takes a labeling; returns how many labels changed.
    pub fn take(&mut self, model: &ActiveModel<'_>, chosen: &[Chosen]) -> u32 {
        let mut changed = 0;
        for (i, found) in chosen.iter().enumerate() {
            let label = model.candidates.labels(i)[found.candidate as usize];
            changed += u32::from(self.labeling[i] != label);
            self.labeling[i] = label;
            self.confidence[i] = found.confidence;
        }
        let chosen: Vec<u32> = chosen.iter().map(|found| found.candidate).collect();
        self.energy = model.energy(&chosen);
        changed
    }

    /// One more iteration is done, whose labeling was taken last.
    pub fn iterate(&mut self, message_delta_max: f32, labels_changed: u32) -> BpIteration {
        self.iterations += 1;
        self.history.push(message_delta_max, self.labeling.iter().copied());
        BpIteration { iteration: self.iterations, energy: self.energy, message_delta_max, labels_changed }
    }

    /// The outcome of the run.
    pub fn finish(self, stop: BpStop) -> BpOutcome {
        BpOutcome {
            labeling: self.labeling,
            confidence: self.confidence,
            energy: self.energy,
            iterations: self.iterations,
            stop,
            convergence: self.history.convergence(stop == BpStop::Converged),
        }
    }
}
