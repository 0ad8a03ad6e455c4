//! Parameters, reports and results that simulated annealing and Las Vegas share.

use super::energy::SearchEnergy;
use super::gibbs::GibbsScratch;
use super::state::SearchState;
use crate::{Energy, Labeling, MrfModel};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Parameters of one run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchRun<'s> {
    /// Largest number of sweeps; a sweep visits every variable once.
    pub sweeps: u32,
    /// Seed of all draws. The same seed gives the same bytes on any number of threads.
    pub seed: u64,
    /// Initial labels, one per variable; `None`: uniform at random.
    pub start: Option<&'s [u32]>,
    /// The run ends as soon as the energy of the model, bias excluded, is at most this value.
    pub target_energy: Option<f64>,
}

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SearchStop {
    /// The energy is at most the target.
    TargetReached,
    /// The budget of sweeps ended.
    Budget,
    /// No label has changed for many sweeps in a row (annealing only).
    Frozen,
}

/// One finished sweep. Energies are those of the model, bias excluded; with `T = ∞` a broken edge counts as a finite
/// stand-in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchSweep {
    /// From 1.
    pub sweep: u32,
    /// Energy of the labeling after the sweep.
    pub energy: Energy,
    /// Energy of the best labeling so far, which may have occurred within a sweep.
    pub best_energy: Energy,
    /// Temperature of the sweep; `None` for descent.
    pub temperature: Option<f64>,
    /// Number of variables whose label changed (accepted moves).
    pub labels_changed: u32,
    /// Restarts so far.
    pub restarts: u32,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchOutcome {
    /// The labeling that reached the target, otherwise the best one after any single change of the run. "Best" refers
    /// to the minimized quantity, the energy with the bias.
    pub labeling: Labeling,
    /// For every variable the conditional probability of its label, `p(x_i | neighbors) ∝ exp(−E_i)`, at temperature 1.
    /// Costs one pass over all unary potentials. It is not a marginal: it takes the labels of the neighbors as certain,
    /// and is nearer to 1 than a marginal wherever neighbors agree.
    pub confidence: Vec<f64>,
    /// Energy of the labeling by a full evaluation of the model, bias excluded; infinite if `T = ∞` and an edge is
    /// broken.
    pub energy: Energy,
    /// Sweeps begun.
    pub sweeps: u32,
    /// Random restarts made.
    pub restarts: u32,
    /// Why the run ended.
    pub stop: SearchStop,
    /// Whether a full evaluation of the model found the energy to be at most the target; false without a target.
    pub certified: bool,
}

/// Variables per task of the confidences.
const PART: usize = 64;

impl SearchRun<'_> {
    /// The state in which the run begins.
    pub(super) fn begin(&self, energy: &SearchEnergy<'_>) -> SearchState {
        let labels = self.start.map_or_else(|| energy.random_labels(self.seed, 0), <[u32]>::to_vec);
        SearchState::new(energy, labels, self.target_energy)
    }
}

/// Counts of a run that has ended.
pub(super) struct RunEnd {
    pub sweeps: u32,
    pub restarts: u32,
    pub stop: SearchStop,
}

impl RunEnd {
    /// The outcome: labeling, its energy evaluated in full, and confidences.
    pub(super) fn outcome(
        self,
        energy: &SearchEnergy<'_>,
        state: &mut SearchState,
        observer: &dyn Observer,
    ) -> Result<SearchOutcome, Cancelled> {
        state.settle();
        let certified = self.stop == SearchStop::TargetReached;
        let labeling = if certified { state.labels().to_vec() } else { state.best_labels().to_vec() };
        Ok(SearchOutcome {
            confidence: confidence_of(energy, &labeling, observer)?,
            energy: energy.model.energy(&labeling),
            labeling,
            sweeps: self.sweeps,
            restarts: self.restarts,
            stop: self.stop,
            certified,
        })
    }
}

/// For every variable the conditional probability of its label, `p(x_i | neighbors) ∝ exp(−E_i)`, in a labeling of any
/// minimizer. Cost `O(n_variables · n_labels)`, on all cores.
///
/// # Errors
/// [`Cancelled`].
pub fn local_confidence(model: &MrfModel, labels: &[u32], observer: &dyn Observer) -> Result<Vec<f64>, Cancelled> {
    confidence_of(&SearchEnergy::new(model), labels, observer)
}

fn confidence_of(energy: &SearchEnergy<'_>, labels: &[u32], observer: &dyn Observer) -> Result<Vec<f64>, Cancelled> {
    let mut confidence = vec![0.0; labels.len()];
    confidence.par_chunks_mut(PART).enumerate().try_for_each_init(
        || GibbsScratch::new(energy.model.n_labels()),
        |scratch, (part, values)| {
            for (k, value) in values.iter_mut().enumerate() {
                checkpoint(observer)?;
                *value = scratch.confidence(energy, labels, part * PART + k);
            }
            Ok(())
        },
    )?;
    Ok(confidence)
}
