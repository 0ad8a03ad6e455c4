//! Simulated annealing: random changes of single labels at a temperature that falls.
//!
//! Source: Kirkpatrick, Gelatt, Vecchi, Science 220, 1983; with the Gibbs sampler Geman, Geman, IEEE PAMI 6(6), 1984.
//! Annealing is the classical reference for belief propagation. It needs no messages (only `O(n_variables + n_labels)`
//! of memory beside the unary potentials), and it samples. Started at a low temperature from a labeling of belief
//! propagation, it lowers the energy of that labeling.

use super::energy::SearchEnergy;
use super::schedule::{Cooling, Temperatures, energy_spread};
use super::search::{RunEnd, SearchOutcome, SearchRun, SearchStop, SearchSweep};
use super::sweeps::{SiteUpdate, Sweeps};
use crate::MrfModel;
use homolog_primitives::observe::{Cancelled, Observer};

/// Default initial temperature in spreads of the energy. Labels of two surfaces begin to agree all at once near one
/// spread; a run that begins there freezes into patches. Of 1, 1.5, 2 and 3 spreads, 2 gave the lowest mean energy of
/// three seeds, with both samplers and the geometric schedule, on two generated surfaces of 660 vertices.
const INITIAL_SPREADS: f64 = 2.0;
/// Default final temperature as a share of the initial one: a typical worsening change is then never accepted.
const FINAL_SHARE: f64 = 0.005;

/// Method of drawing a label at a temperature. Both keep `p(x) ∝ exp(−E(x)/T)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampler {
    /// Draws from all labels at once, by their conditional probabilities. A sweep costs `O(|E→| k̄)` once labels agree
    /// with their neighbors', and up to `O(n_variables · n_labels)` while the temperature is high.
    Gibbs,
    /// One proposal, accepted with `min(1, exp(−ΔE/T))`, corrected for asymmetric proposals. A sweep costs
    /// `O(|E→| log k̄)`.
    Metropolis,
}

/// Options of simulated annealing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnealingOptions {
    /// Method of drawing labels.
    pub sampler: Sampler,
    /// Cooling curve.
    pub schedule: Cooling,
    /// Temperature of the first sweep, more than 0; `None`: twice the energy's spread, which is the standard deviation
    /// of `ΔE` over random changes of random labels.
    pub initial_temperature: Option<f64>,
    /// Temperature of the last sweep, at most the initial one; `None`: a two-hundredth of the initial one. Only a floor
    /// for the logarithmic schedule.
    pub final_temperature: Option<f64>,
    /// Number of consecutive sweeps without a changed label after which a run ends as frozen.
    pub patience: u32,
}

/// Simulated annealing over one model.
pub struct SimulatedAnnealing<'a> {
    options: AnnealingOptions,
    energy: SearchEnergy<'a>,
    sweeps: Sweeps,
}

impl<'a> SimulatedAnnealing<'a> {
    /// Annealing of `model`, which has at least one label. Allocates the memory of a sweep. Cost `O(n_variables ·
    /// n_labels)`.
    pub fn new(model: &'a MrfModel, options: AnnealingOptions) -> Self {
        let gibbs = options.sampler == Sampler::Gibbs;
        let sweeps = Sweeps::new(&model.variables, model.n_labels(), gibbs);
        SimulatedAnnealing { options, energy: SearchEnergy::new(model), sweeps }
    }

    /// Sets the unary potentials to those of the model plus a bias: `add(i, row)` may add to the row of variable `i`,
    /// or overwrite it; infinite values forbid a label. Takes a copy of the table of unary potentials.
    pub fn set_bias(&mut self, add: impl Fn(usize, &mut [f32]) + Sync) {
        self.energy.set_bias(add);
        self.sweeps.reset();
    }

    /// Anneals, from the initial to the final temperature in `run.sweeps` sweeps.
    ///
    /// `on_sweep` is called after every sweep.
    ///
    /// # Errors
    /// [`Cancelled`] as soon as `observer` asks to stop.
    pub fn run(
        &mut self,
        run: &SearchRun<'_>,
        observer: &dyn Observer,
        mut on_sweep: impl FnMut(&SearchSweep),
    ) -> Result<SearchOutcome, Cancelled> {
        let options = &self.options;
        let initial =
            options.initial_temperature.unwrap_or_else(|| INITIAL_SPREADS * energy_spread(&self.energy, run.seed));
        let last = options.final_temperature.unwrap_or(FINAL_SHARE * initial);
        let temperatures = Temperatures::new(options.schedule, initial, last, run.sweeps);
        let mut state = run.begin(&self.energy);
        let mut end = RunEnd { sweeps: 0, restarts: 0, stop: SearchStop::Budget };
        if state.reaches_target(&self.energy) {
            end.stop = SearchStop::TargetReached;
            return end.outcome(&self.energy, &mut state, observer);
        }
        let mut quiet = 0;
        for sweep in 1..=run.sweeps {
            let temperature = temperatures.at(sweep);
            let update = match options.sampler {
                Sampler::Gibbs => SiteUpdate::Gibbs(temperature),
                Sampler::Metropolis => SiteUpdate::Metropolis(temperature),
            };
            let swept = self.sweeps.sweep(&self.energy, &mut state, update, (run.seed, sweep), observer)?;
            state.settle();
            end.sweeps = sweep;
            on_sweep(&SearchSweep {
                sweep,
                energy: state.terms().energy(),
                best_energy: state.best_terms().energy(),
                temperature: Some(temperature),
                labels_changed: swept.changed,
                restarts: 0,
            });
            if swept.target_reached {
                end.stop = SearchStop::TargetReached;
                break;
            }
            quiet = if swept.changed == 0 { quiet + 1 } else { 0 };
            if quiet >= options.patience.max(1) {
                end.stop = SearchStop::Frozen;
                break;
            }
        }
        end.outcome(&self.energy, &mut state, observer)
    }
}
