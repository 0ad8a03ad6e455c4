//! Iteration reports and the outcome of a run of belief propagation.

use super::convergence::{Convergence, History};
use crate::{Energy, Labeling};

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BpStop {
    /// No message changed by more than the tolerance.
    Converged,
    /// The budget of iterations ended.
    MaxIterations,
}

/// One finished iteration: `|E→|` message updates in either schedule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BpIteration {
    /// From 1.
    pub iteration: u32,
    /// Energy of the labeling decoded after the iteration.
    pub energy: Energy,
    /// Largest change of a message.
    pub message_delta_max: f32,
    /// Number of variables whose label changed.
    pub labels_changed: u32,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct BpOutcome {
    /// Label of the largest belief of every variable.
    pub labeling: Labeling,
    /// The largest belief of every variable, scaled so that the beliefs of a variable sum to 1.
    pub confidence: Vec<f64>,
    /// Energy of the labeling.
    pub energy: Energy,
    /// Iterations of this run.
    pub iterations: u32,
    /// Why it ended.
    pub stop: BpStop,
    /// State and rate of convergence.
    pub convergence: Convergence,
}

/// Largest belief of a variable: label and share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Decoded {
    pub variable: u32,
    pub label: u32,
    pub confidence: f64,
}

/// The labeling of a run as it changes, and the history of its iterations.
pub(super) struct Progress {
    labeling: Labeling,
    confidence: Vec<f64>,
    energy: Energy,
    history: History,
    iterations: u32,
}

impl Progress {
    /// Before the first labeling is decoded.
    pub(super) fn new(n_variables: usize) -> Self {
        Progress {
            labeling: vec![0; n_variables],
            confidence: vec![1.0; n_variables],
            energy: Energy { unary: 0.0, pairwise: 0.0 },
            history: History::default(),
            iterations: 0,
        }
    }

    /// Takes the labeling decoded from the present messages, of every variable once, in any order; `energy` evaluates
    /// it. Returns the number of changed labels.
    pub(super) fn decoded(&mut self, found: &[Decoded], energy: impl FnOnce(&[u32]) -> Energy) -> u32 {
        let mut changed = 0;
        for d in found {
            let label = &mut self.labeling[d.variable as usize];
            changed += u32::from(*label != d.label);
            *label = d.label;
            self.confidence[d.variable as usize] = d.confidence;
        }
        self.energy = energy(&self.labeling);
        changed
    }

    /// Records one more iteration, with its largest message change; its labeling was decoded last.
    pub(super) fn iterated(&mut self, message_delta_max: f32, labels_changed: u32) -> BpIteration {
        self.iterations += 1;
        self.history.push(message_delta_max, self.labeling.iter().copied());
        BpIteration { iteration: self.iterations, energy: self.energy, message_delta_max, labels_changed }
    }

    /// Iterations so far.
    pub(super) fn iterations(&self) -> u32 {
        self.iterations
    }

    /// The outcome of the run.
    pub(super) fn finish(self, stop: BpStop) -> BpOutcome {
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
