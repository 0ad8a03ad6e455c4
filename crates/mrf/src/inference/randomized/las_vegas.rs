//! Las Vegas: random local moves that lower the energy, random restarts, and an answer that is either certified or
//! marked as not.
//!
//! Source: the name is Babai's (1979), for an algorithm that may take long but never gives a wrong answer unnoticed.
//! Here an answer is right if a full evaluation shows its energy to be at most a stated target. Without a restart in a
//! good basin the target is missed, and the outcome reports that the budget ended.

use super::energy::SearchEnergy;
use super::search::{RunEnd, SearchOutcome, SearchRun, SearchStop, SearchSweep};
use super::sweeps::{SiteUpdate, Sweeps};
use crate::MrfModel;
use homolog_primitives::observe::{Cancelled, Observer};

/// Options of Las Vegas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LasVegasOptions {
    /// Number of consecutive sweeps without a move after which a descent is abandoned and another begins from random
    /// labels.
    pub patience: u32,
}

/// Las Vegas over one model.
pub struct LasVegas<'a> {
    options: LasVegasOptions,
    energy: SearchEnergy<'a>,
    sweeps: Sweeps,
}

impl<'a> LasVegas<'a> {
    /// Las Vegas over `model`, which has at least one label. Cost `O(n_variables · n_labels)`.
    pub fn new(model: &'a MrfModel, options: LasVegasOptions) -> Self {
        let sweeps = Sweeps::new(&model.variables, model.n_labels(), false);
        LasVegas { options, energy: SearchEnergy::new(model), sweeps }
    }

    /// Like [`SimulatedAnnealing::set_bias`](super::SimulatedAnnealing::set_bias). The energy with the bias decides on
    /// moves, the energy without it on the target.
    pub fn set_bias(&mut self, add: impl Fn(usize, &mut [f32]) + Sync) {
        self.energy.set_bias(add);
    }

    /// Descends and restarts until the target is reached or the sweeps are used up. Without a target it uses all of
    /// them and returns the best labeling. A sweep makes one random move at every variable and costs `O(|E→| log k̄)`.
    ///
    /// The first descent begins at `run.start`. `on_sweep` is called after every sweep.
    ///
    /// # Errors
    /// [`Cancelled`] as soon as `observer` asks to stop.
    pub fn run(
        &mut self,
        run: &SearchRun<'_>,
        observer: &dyn Observer,
        mut on_sweep: impl FnMut(&SearchSweep),
    ) -> Result<SearchOutcome, Cancelled> {
        let mut state = run.begin(&self.energy);
        let mut end = RunEnd { sweeps: 0, restarts: 0, stop: SearchStop::Budget };
        let mut quiet = 0;
        let mut reached = state.reaches_target(&self.energy);
        while !reached && end.sweeps < run.sweeps {
            if quiet >= self.options.patience.max(1) {
                quiet = 0;
                end.restarts += 1;
                state.restart(&self.energy, self.energy.random_labels(run.seed, end.restarts));
                reached = state.reaches_target(&self.energy);
                continue;
            }
            end.sweeps += 1;
            let stream = (run.seed, end.sweeps);
            let swept = self.sweeps.sweep(&self.energy, &mut state, SiteUpdate::Descent, stream, observer)?;
            state.settle();
            on_sweep(&SearchSweep {
                sweep: end.sweeps,
                energy: state.terms().energy(),
                best_energy: state.best_terms().energy(),
                temperature: None,
                labels_changed: swept.changed,
                restarts: end.restarts,
            });
            quiet = if swept.changed == 0 { quiet + 1 } else { 0 };
            reached = swept.target_reached;
        }
        if reached {
            end.stop = SearchStop::TargetReached;
        }
        end.outcome(&self.energy, &mut state, observer)
    }
}
