//! Belief propagation over all labels as a minimizer.

use super::minimizer::{InferenceRun, Minimizer, MinimizerResult, OnStep};
use crate::pair::vertex_map::VertexMap;
use homolog_contract::result::{ConvergenceDocument, ConvergenceStatus, StopReason};
use homolog_mrf::inference::{self, BeliefPropagation, BpIteration, BpOutcome, BpStop};
use homolog_primitives::observe::{Cancelled, Phase, Quantity, TracePoint};

/// Belief propagation over all labels.
pub(crate) struct Propagation<'a> {
    pub bp: BeliefPropagation<'a>,
}

impl Minimizer for Propagation<'_> {
    fn reset(&mut self) {
        self.bp.reset();
    }

    fn set_bias(&mut self, add: &(dyn Fn(usize, &mut [f32]) + Sync)) {
        self.bp.set_bias(add);
    }

    fn run(&mut self, run: &InferenceRun<'_>, on_step: OnStep<'_>) -> Result<MinimizerResult, Cancelled> {
        let &InferenceRun { round, budget, positions, observer } = run;
        let outcome = self.bp.run(budget, observer, |iteration| on_step(trace_point(round, iteration)))?;
        let spread_mm = self.bp.spreads(positions, observer)?;
        Ok(labeled(outcome, spread_mm))
    }
}

/// An iteration of belief propagation as a point of the trace.
pub(crate) fn trace_point(round: u32, iteration: &BpIteration) -> TracePoint {
    TracePoint {
        quantity: Some(Quantity::CurvatureEnergy),
        energy: Some(iteration.energy.total()),
        energy_unary: Some(iteration.energy.unary),
        energy_pairwise: Some(iteration.energy.pairwise),
        message_delta_max: Some(iteration.message_delta_max.into()),
        vertices_changed: Some(iteration.labels_changed),
        ..TracePoint::new(round, Phase::Inference, iteration.iteration)
    }
}

/// The outcome of belief propagation in the form that all minimizers share.
pub(crate) fn labeled(outcome: BpOutcome, spread_mm: Vec<f64>) -> MinimizerResult {
    let BpOutcome { labeling, confidence, energy, iterations, stop, convergence } = outcome;
    let (status, period) = match convergence.status {
        inference::ConvergenceStatus::Converged => (ConvergenceStatus::Converged, None),
        inference::ConvergenceStatus::Slow => (ConvergenceStatus::Slow, None),
        inference::ConvergenceStatus::Oscillating { period } => (ConvergenceStatus::Oscillating, Some(period)),
    };
    MinimizerResult {
        map: VertexMap { labeling, confidence, spread_mm },
        energy,
        iterations,
        stop_reason: match stop {
            BpStop::Converged => StopReason::Converged,
            BpStop::MaxIterations => StopReason::MaxIterations,
        },
        convergence: ConvergenceDocument { status, period },
    }
}
