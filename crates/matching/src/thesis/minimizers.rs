//! The minimizer that the parameters ask for.

use super::active_labels::ActiveLabels;
use super::minimizer::{InferenceRun, Minimizer, MinimizerResult, OnStep};
use super::propagation::Propagation;
use crate::pair::vertex_map::VertexMap;
use homolog_contract::parameters::{Algorithm, CoolingSchedule, InferenceParameters, MatchParameters, Update};
use homolog_contract::result::{ConvergenceDocument, ConvergenceStatus, StopReason};
use homolog_mrf::inference::{
    self, AnnealingOptions, BeliefPropagation, BpOptions, DualBound, DualOptions, DualOutcome, DualStop, LasVegas,
    LasVegasOptions, Product, Sampler, SearchOutcome, SearchRun, SearchStop, SearchSweep, SimulatedAnnealing,
    local_confidence,
};
use homolog_mrf::{Labeling, MrfModel};
use homolog_primitives::observe::{Cancelled, Observer, Phase, Quantity, TracePoint};
use rayon::prelude::*;

/// Smallest value of a message. It is far below `exp(−T)` at the default truncation, and only keeps products finite.
/// The hard constraint has no such floor: it would become the cost of a broken edge.
const MESSAGE_FLOOR: f32 = 1e-5;
/// The dual method ends when the energy is within this share of the bound.
const ROUND_GAP: f64 = 1e-6;
/// The dual method ends when an iteration raises the bound by less than this share.
const PROGRESS_TOLERANCE: f64 = 1e-5;
/// An annealer is frozen when no label has changed for this number of sweeps.
const FROZEN_SWEEPS: u32 = 20;

/// The minimizer that `parameters` name. `lower_bound` is a target for those that have one. `observer` is asked while it begins.
pub(crate) fn minimizer<'a>(
    model: &'a MrfModel,
    parameters: &MatchParameters,
    lower_bound: Option<f64>,
    observer: &'a dyn Observer,
) -> Box<dyn Minimizer + 'a> {
    let p = &parameters.inference;
    let propagation = |product| -> Box<dyn Minimizer + 'a> {
        match p.update {
            Update::Active => Box::new(ActiveLabels::new(model, bp_options(parameters, product))),
            Update::Sparse | Update::Full => {
                Box::new(Propagation { bp: belief_propagation(model, parameters, product, observer) })
            }
        }
    };
    let search = |engine| {
        Box::new(Search { engine, seed: parameters.seed, target_energy: p.target_energy.or(lower_bound), last: None })
    };
    match p.algorithm {
        Algorithm::SumProduct => propagation(Product::Sum),
        // Registration alone has no rounds and needs no minimizer.
        Algorithm::MaxProduct | Algorithm::None => propagation(Product::Max),
        Algorithm::TreeReweighted => Box::new(Dual { model, biased: None }),
        Algorithm::Gibbs => search(Engine::Annealing(annealing(model, p, Sampler::Gibbs))),
        Algorithm::Metropolis => search(Engine::Annealing(annealing(model, p, Sampler::Metropolis))),
        Algorithm::LasVegas => {
            search(Engine::LasVegas(LasVegas::new(model, LasVegasOptions { patience: p.restart_after })))
        }
    }
}

fn bp_options(parameters: &MatchParameters, product: Product) -> BpOptions {
    let p = &parameters.inference;
    let floor = parameters.energy.truncation.map_or(0.0, |_| MESSAGE_FLOOR);
    BpOptions { product, damping: p.damping as f32, floor, tolerance: p.tolerance as f32 }
}

fn belief_propagation<'a>(
    model: &'a MrfModel,
    parameters: &MatchParameters,
    product: Product,
    observer: &'a dyn Observer,
) -> BeliefPropagation<'a> {
    let p = &parameters.inference;
    let options = bp_options(parameters, product);
    let update = match p.update {
        Update::Sparse | Update::Active => inference::Update::Sparse,
        Update::Full => inference::Update::Full,
    };
    BeliefPropagation::observed(model, options, update, observer)
}

fn annealing<'a>(model: &'a MrfModel, p: &InferenceParameters, sampler: Sampler) -> SimulatedAnnealing<'a> {
    let options = AnnealingOptions {
        sampler,
        schedule: match p.annealing.schedule {
            CoolingSchedule::Geometric => inference::Cooling::Geometric,
            CoolingSchedule::Logarithmic => inference::Cooling::Logarithmic,
            CoolingSchedule::Linear => inference::Cooling::Linear,
        },
        initial_temperature: p.annealing.initial_temperature,
        final_temperature: p.annealing.final_temperature,
        patience: FROZEN_SWEEPS,
    };
    SimulatedAnnealing::new(model, options)
}

/// The dual method as a minimizer: every round raises the bound of its own energy, feedback included.
struct Dual<'a> {
    model: &'a MrfModel,
    biased: Option<MrfModel>,
}

impl Minimizer for Dual<'_> {
    fn reset(&mut self) {}

    fn set_bias(&mut self, add: &(dyn Fn(usize, &mut [f32]) + Sync)) {
        let mut biased = self.model.clone();
        let n = biased.n_labels().max(1);
        biased.unary.par_chunks_mut(n).enumerate().for_each(|(i, row)| add(i, row));
        self.biased = Some(biased);
    }

    fn run(&mut self, run: &InferenceRun<'_>, on_step: OnStep<'_>) -> Result<MinimizerResult, Cancelled> {
        let &InferenceRun { round, budget, observer, .. } = run;
        let minimized = self.biased.as_ref().unwrap_or(self.model);
        let mut last: Labeling = Vec::new();
        let options = DualOptions { gap_tolerance: ROUND_GAP, progress_tolerance: PROGRESS_TOLERANCE };
        let outcome = DualBound::new(minimized, options).run(budget, observer, |iteration, labeling| {
            let energy = self.model.energy(labeling);
            let changed = labeling.iter().zip(&last).filter(|(a, b)| a != b).count();
            on_step(TracePoint {
                quantity: Some(Quantity::CurvatureEnergy),
                energy: Some(energy.total()),
                energy_unary: Some(energy.unary),
                energy_pairwise: Some(energy.pairwise),
                vertices_changed: (!last.is_empty()).then_some(changed as u32),
                // With feedback the bound is for another energy than the reported one.
                lower_bound: self.biased.is_none().then_some(iteration.bound),
                ..TracePoint::new(round, Phase::Inference, iteration.iteration)
            });
            last = labeling.to_vec();
        })?;
        let DualOutcome { labeling, iterations, stop, .. } = outcome;
        let confidence = local_confidence(minimized, &labeling, observer)?;
        Ok(MinimizerResult {
            energy: self.model.energy(&labeling),
            map: VertexMap { spread_mm: vec![0.0; labeling.len()], labeling, confidence },
            iterations,
            stop_reason: if stop == DualStop::MaxIterations {
                StopReason::MaxIterations
            } else {
                StopReason::Converged
            },
            convergence: ConvergenceDocument {
                status: if stop == DualStop::MaxIterations {
                    ConvergenceStatus::Slow
                } else {
                    ConvergenceStatus::Converged
                },
                period: None,
            },
        })
    }
}

enum Engine<'a> {
    Annealing(SimulatedAnnealing<'a>),
    LasVegas(LasVegas<'a>),
}

/// A randomized minimizer. Rounds after the first start with the labels of the previous round.
struct Search<'a> {
    engine: Engine<'a>,
    seed: u64,
    target_energy: Option<f64>,
    last: Option<Labeling>,
}

impl Minimizer for Search<'_> {
    fn reset(&mut self) {
        self.last = None;
    }

    fn set_bias(&mut self, add: &(dyn Fn(usize, &mut [f32]) + Sync)) {
        match &mut self.engine {
            Engine::Annealing(annealing) => annealing.set_bias(add),
            Engine::LasVegas(las_vegas) => las_vegas.set_bias(add),
        }
    }

    fn run(&mut self, run: &InferenceRun<'_>, on_step: OnStep<'_>) -> Result<MinimizerResult, Cancelled> {
        let &InferenceRun { round, budget, observer, .. } = run;
        let search = SearchRun {
            sweeps: budget,
            seed: self.seed.wrapping_add(u64::from(round)),
            start: self.last.as_deref(),
            target_energy: self.target_energy,
        };
        let on_sweep = |sweep: &SearchSweep| {
            on_step(TracePoint {
                quantity: Some(Quantity::CurvatureEnergy),
                energy: Some(sweep.energy.total()),
                energy_unary: Some(sweep.energy.unary),
                energy_pairwise: Some(sweep.energy.pairwise),
                vertices_changed: Some(sweep.labels_changed),
                temperature: sweep.temperature,
                ..TracePoint::new(round, Phase::Inference, sweep.sweep)
            });
        };
        let outcome = match &mut self.engine {
            Engine::Annealing(annealing) => annealing.run(&search, observer, on_sweep),
            Engine::LasVegas(las_vegas) => las_vegas.run(&search, observer, on_sweep),
        }?;
        let SearchOutcome { labeling, confidence, energy, sweeps, stop, .. } = outcome;
        self.last = Some(labeling.clone());
        Ok(MinimizerResult {
            map: VertexMap { spread_mm: vec![0.0; labeling.len()], labeling, confidence },
            energy,
            iterations: sweeps,
            stop_reason: match stop {
                SearchStop::TargetReached => StopReason::TargetReached,
                SearchStop::Budget => StopReason::MaxIterations,
                SearchStop::Frozen => StopReason::Converged,
            },
            convergence: ConvergenceDocument { status: ConvergenceStatus::Sampled, period: None },
        })
    }
}
