//! What a run of belief propagation tells on the way and leaves at the end.

use super::convergence::{Convergence, History};
use crate::{Energy, Labeling, MrfModel};

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
    /// Energy of the labeling decoded after it.
    pub energy: Energy,
    /// Largest change of a message.
    pub message_delta_max: f32,
    /// Variables whose label changed.
    pub labels_changed: u32,
}

/// What a run leaves.
#[derive(Debug, Clone, PartialEq)]
pub struct BpOutcome {
    /// Label of the largest belief of every variable.
    pub labeling: Labeling,
    /// That belief, scaled so that the beliefs of a variable sum to 1.
    pub confidence: Vec<f64>,
    /// Energy of the labeling.
    pub energy: Energy,
    /// Iterations of this run.
    pub iterations: u32,
    /// Why it ended.
    pub stop: BpStop,
    /// Whether it settled, and how fast it was about to.
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
pub(super) struct Progress<'m> {
    model: &'m MrfModel,
    decoded: Vec<Decoded>,
    energy: Energy,
    history: History,
    iterations: u32,
}

impl<'m> Progress<'m> {
    /// Before the first labeling is decoded.
    pub fn new(model: &'m MrfModel) -> Self {
        Progress {
            model,
            decoded: vec![Decoded { variable: 0, label: 0, confidence: 1.0 }; model.n_variables()],
            energy: Energy { unary: 0.0, pairwise: 0.0 },
            history: History::default(),
            iterations: 0,
        }
    }

    /// Takes the labeling that was decoded before any iteration, of every variable once, in any order.
    pub fn start(&mut self, found: &[Decoded]) {
        self.take(found);
    }

    /// Takes the labeling decoded after one more iteration, whose largest message change was `delta`.
    pub fn iterate(&mut self, found: &[Decoded], delta: f32) -> BpIteration {
        let labels_changed = self.take(found);
        self.iterations += 1;
        self.history.push(delta, self.decoded.iter().map(|d| d.label));
        BpIteration { iteration: self.iterations, energy: self.energy, message_delta_max: delta, labels_changed }
    }

    fn take(&mut self, found: &[Decoded]) -> u32 {
        let mut changed = 0;
        for d in found {
            let slot = &mut self.decoded[d.variable as usize];
            changed += u32::from(slot.label != d.label);
            *slot = *d;
        }
        let labeling: Labeling = self.decoded.iter().map(|d| d.label).collect();
        self.energy = self.model.energy(&labeling);
        changed
    }

    /// The outcome of the run.
    pub fn finish(self, stop: BpStop) -> BpOutcome {
        BpOutcome {
            labeling: self.decoded.iter().map(|d| d.label).collect(),
            confidence: self.decoded.iter().map(|d| d.confidence).collect(),
            energy: self.energy,
            iterations: self.iterations,
            stop,
            convergence: self.history.convergence(stop == BpStop::Converged),
        }
    }
}
