//! The energy trace of the fits of a displacement.

use homolog_primitives::observe::{Observer, Phase, Quantity, TracePoint};
use homolog_registration::deformation::FittedField;
use std::sync::atomic::{AtomicU32, Ordering};

/// The observer of a displacement, and the number of fits reported to it.
pub(crate) struct FitTrace<'a> {
    observer: &'a dyn Observer,
    n_begun: AtomicU32,
}

/// A fit in the trace: its number, from 0, and its iterations so far.
#[derive(Debug)]
pub(crate) struct TracedFit {
    round: u32,
    iterations: u32,
}

impl<'a> FitTrace<'a> {
    pub(crate) fn new(observer: &'a dyn Observer) -> Self {
        FitTrace { observer, n_begun: AtomicU32::new(0) }
    }

    /// The next fit. Must not be called from several threads at once: the numbers are part of the trace.
    pub(crate) fn begin(&self) -> TracedFit {
        TracedFit { round: self.n_begun.fetch_add(1, Ordering::Relaxed), iterations: 0 }
    }

    /// Traces an iteration of a fit of labels with this energy.
    pub(crate) fn trace_labels(&self, fit: &mut TracedFit, energy: f64) {
        self.observer.trace(&TracePoint {
            quantity: Some(Quantity::MeanIsometryEnergy),
            energy: Some(energy),
            ..fit.next(Phase::Inference)
        });
    }

    /// Traces an iteration of a fit of `field`: the `misfit` of the moved surfaces, and half the squared norm of its
    /// coefficients per independent observation, of which there are `observations`.
    pub(crate) fn trace(&self, fit: &mut TracedFit, misfit: f64, field: &FittedField, observations: f64) {
        let cost = 0.5 * field.cost() / observations;
        self.observer.trace(&TracePoint {
            quantity: Some(Quantity::FieldEnergy),
            energy: Some(misfit + cost),
            energy_unary: Some(misfit),
            energy_pairwise: Some(cost),
            ..fit.next(Phase::Displacement)
        });
    }
}

impl TracedFit {
    fn next(&mut self, phase: Phase) -> TracePoint {
        self.iterations += 1;
        TracePoint { start: Some(self.round), ..TracePoint::new(self.round, phase, self.iterations) }
    }
}

impl Observer for FitTrace<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
}
