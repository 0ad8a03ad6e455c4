//! The energy trace of the fits of a displacement.

use homolog_primitives::observe::{Observer, Phase, Quantity, TracePoint};
use homolog_registration::deformation::FittedField;
use std::sync::atomic::{AtomicU32, Ordering};

/// The observer of a displacement, and the number of fits reported to it.
pub(crate) struct FitTrace<'a> {
    observer: &'a dyn Observer,
    n_begun: AtomicU32,
}

/// A fit in the trace.
#[derive(Debug)]
pub(crate) struct TracedFit {
    /// Its number, from 0; `None` while it is not known whether the fit is kept.
    round: Option<u32>,
    iterations: u32,
    /// Points to report once it is kept.
    waiting: Vec<TracePoint>,
}

impl<'a> FitTrace<'a> {
    pub(crate) fn new(observer: &'a dyn Observer) -> Self {
        FitTrace { observer, n_begun: AtomicU32::new(0) }
    }

    /// The next fit. Must not be called from several threads at once: the numbers are part of the trace.
    pub(crate) fn begin(&self) -> TracedFit {
        TracedFit { round: Some(self.n_begun.fetch_add(1, Ordering::Relaxed)), ..TracedFit::candidate() }
    }

    /// Reports a candidate that is kept: it becomes the next fit. As [`FitTrace::begin`], not from several threads.
    pub(crate) fn keep(&self, fit: &mut TracedFit) {
        let round = self.n_begun.fetch_add(1, Ordering::Relaxed);
        fit.round = Some(round);
        for point in fit.waiting.drain(..) {
            self.observer.trace(&TracePoint { start: Some(round), round, ..point });
        }
    }

    fn report(&self, fit: &mut TracedFit, point: TracePoint) {
        fit.iterations += 1;
        let point = TracePoint { start: fit.round, iteration: fit.iterations, ..point };
        match fit.round {
            Some(round) => self.observer.trace(&TracePoint { round, ..point }),
            None => fit.waiting.push(point),
        }
    }

    /// Traces an iteration of a fit of labels with this energy.
    pub(crate) fn trace_labels(&self, fit: &mut TracedFit, energy: f64) {
        let point = TracePoint {
            quantity: Some(Quantity::MeanIsometryEnergy),
            energy: Some(energy),
            ..TracePoint::new(0, Phase::Inference, 0)
        };
        self.report(fit, point);
    }

    /// Traces an iteration of a fit of `field`: the `misfit` of the moved surfaces, and half the squared norm of its
    /// coefficients per independent observation, of which there are `observations`.
    pub(crate) fn trace(&self, fit: &mut TracedFit, misfit: f64, field: &FittedField, observations: f64) {
        let cost = 0.5 * field.cost() / observations;
        let point = TracePoint {
            quantity: Some(Quantity::FieldEnergy),
            energy: Some(misfit + cost),
            energy_unary: Some(misfit),
            energy_pairwise: Some(cost),
            ..TracePoint::new(0, Phase::Displacement, 0)
        };
        self.report(fit, point);
    }
}

impl TracedFit {
    /// A fit that is reported only if it is kept.
    pub(crate) fn candidate() -> TracedFit {
        TracedFit { round: None, iterations: 0, waiting: Vec::new() }
    }
}

impl Observer for FitTrace<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
}
