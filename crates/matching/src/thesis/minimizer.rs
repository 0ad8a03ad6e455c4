//! The common interface of all minimizers of the energy, so that the rounds of a match do not depend on the minimizer.

use crate::pair::vertex_map::VertexMap;
use homolog_contract::result::{ConvergenceDocument, StopReason};
use homolog_mrf::Energy;
use homolog_primitives::observe::{Cancelled, Observer, TracePoint};
use nalgebra::Point3;

/// A labeling, and the course of its minimization.
pub(crate) struct MinimizerResult {
    pub map: VertexMap,
    pub energy: Energy,
    pub iterations: u32,
    pub stop_reason: StopReason,
    pub convergence: ConvergenceDocument,
}

/// Called with every point of the trace.
pub(crate) type OnStep<'f> = &'f mut dyn FnMut(TracePoint);

/// One run of a minimizer.
#[derive(Clone, Copy)]
pub(crate) struct InferenceRun<'r> {
    /// Number of the round, for the points of the trace.
    pub round: u32,
    /// Most iterations or sweeps.
    pub budget: u32,
    /// Positions of the labels, mm.
    pub positions: &'r [Point3<f64>],
    pub observer: &'r dyn Observer,
}

/// A minimizer that is reused from round to round.
pub(crate) trait Minimizer {
    /// Discards the state of earlier runs: the next run is a cold start.
    fn reset(&mut self);

    /// Sets the unary potentials to those of the model plus the additions of `add(i, row)` to the row of variable `i`.
    fn set_bias(&mut self, add: &(dyn Fn(usize, &mut [f32]) + Sync));

    /// Minimizes the energy, and calls `on_step` with every point of the trace.
    fn run(&mut self, run: &InferenceRun<'_>, on_step: OnStep<'_>) -> Result<MinimizerResult, Cancelled>;
}
