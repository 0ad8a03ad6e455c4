//! The observer of a running job: it numbers and times the trace points and keeps the progress monotone.

use super::control::Control;
use crate::jobs::{NumberedPoint, Progress, TraceChunk};
use crate::spans::Span;
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use parking_lot::Mutex;
use std::sync::Arc;
use std::time::Instant;

/// Collects trace and progress of a computation until the worker stores them.
#[derive(Debug)]
pub(crate) struct JobObserver {
    started: Instant,
    control: Arc<Control>,
    /// The trace context of the run, the parent of the spans of the phases.
    context: Option<String>,
    observed: Mutex<Observed>,
}

#[derive(Debug)]
struct Observed {
    last_seq: u64,
    points: Vec<NumberedPoint>,
    progress: Progress,
    changed: bool,
    phase_span: Span,
}

impl JobObserver {
    /// The observer of an attempt that starts now.
    pub(crate) fn new(control: Arc<Control>, context: Option<String>) -> Self {
        let progress = Progress { fraction: 0.0, phase: None, iteration: None, message: None, energy_latest: None };
        let phase_span = Span::default();
        let observed = Observed { last_seq: 0, points: Vec::new(), progress, changed: true, phase_span };
        JobObserver { started: Instant::now(), control, context, observed: Mutex::new(observed) }
    }

    /// Ends the span of the last phase.
    pub(crate) fn end_phase(&self) {
        self.observed.lock().phase_span = Span::default();
    }

    /// Sets the energy of the result, which may differ from the energy of the last trace point.
    pub(crate) fn settle_energy(&self, energy: f64) {
        let mut observed = self.observed.lock();
        observed.progress.energy_latest = Some(energy);
        observed.changed = true;
    }

    /// Trace and progress since the last call; `None` if there is nothing new.
    pub(crate) fn take(&self) -> Option<TraceChunk> {
        let mut observed = self.observed.lock();
        if !observed.changed {
            return None;
        }
        observed.changed = false;
        Some(TraceChunk { points: std::mem::take(&mut observed.points), progress: observed.progress.clone() })
    }
}

impl Observer for JobObserver {
    fn phase(&self, phase: Phase) {
        let mut observed = self.observed.lock();
        // The span of the previous phase ends first.
        observed.phase_span = Span::default();
        observed.phase_span = Span::part(phase.name(), self.context.as_deref());
        observed.progress.phase = Some(phase);
        observed.progress.message = Some(sentence(phase).to_owned());
        observed.progress.iteration = None;
        observed.changed = true;
    }

    fn progress(&self, fraction: f64) {
        let mut observed = self.observed.lock();
        // NaN fails the comparison and is ignored.
        if fraction > observed.progress.fraction {
            observed.progress.fraction = fraction.min(1.0);
            observed.changed = true;
        }
    }

    fn trace(&self, point: &TracePoint) {
        let elapsed_ms = u64::try_from(self.started.elapsed().as_millis()).unwrap_or(u64::MAX);
        let mut observed = self.observed.lock();
        observed.last_seq += 1;
        let point = NumberedPoint { seq: observed.last_seq, point: finite(point), elapsed_ms };
        observed.progress.iteration = Some(point.point.iteration);
        observed.progress.energy_latest = point.point.energy.or(observed.progress.energy_latest);
        observed.points.push(point);
        observed.changed = true;
    }

    fn is_cancelled(&self) -> bool {
        self.control.is_stopped()
    }
}

/// A description of a phase, for people.
fn sentence(phase: Phase) -> &'static str {
    match phase {
        Phase::Reading => "Reading both inputs",
        Phase::Features => "Computing the curvature of both surfaces",
        Phase::Bounding => "Bounding the energy from below",
        Phase::Inference => "Minimizing the energy",
        Phase::Registration => "Estimating the rigid transform",
        Phase::Refinement => "Refining the rigid transform",
        Phase::Displacement => "Fitting a smooth displacement field",
        Phase::Reporting => "Measuring distances and writing the result",
    }
}

/// The point without its non-finite values, which JSON cannot represent.
fn finite(point: &TracePoint) -> TracePoint {
    let keep = |value: Option<f64>| value.filter(|v| v.is_finite());
    TracePoint {
        energy: keep(point.energy),
        energy_unary: keep(point.energy_unary),
        energy_pairwise: keep(point.energy_pairwise),
        message_delta_max: keep(point.message_delta_max),
        temperature: keep(point.temperature),
        lower_bound: keep(point.lower_bound),
        ..point.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_numbered_consecutively_across_several_takes() {
        let observer = JobObserver::new(Arc::default(), None);
        let mut seen = Vec::new();
        for iteration in 1..=5 {
            observer.trace(&TracePoint::new(0, Phase::Inference, iteration));
            if iteration % 2 == 0 {
                seen.extend(observer.take().unwrap().points);
            }
        }
        seen.extend(observer.take().unwrap().points);
        assert_eq!(seen.iter().map(|p| p.seq).collect::<Vec<_>>(), [1, 2, 3, 4, 5]);
        assert!(observer.take().is_none());
    }

    #[test]
    fn progress_never_decreases() {
        let observer = JobObserver::new(Arc::default(), None);
        for fraction in [0.2, 0.5, 0.3, f64::NAN, 7.0] {
            observer.progress(fraction);
        }
        assert_eq!(observer.take().unwrap().progress.fraction, 1.0);
    }
}
