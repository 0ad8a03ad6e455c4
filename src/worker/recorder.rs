//! The observer of a running job: numbers and times its trace points, and keeps its progress from going back.

use super::control::Control;
use crate::jobs::{NumberedPoint, Progress, TraceChunk};
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Collects what a computation tells until the worker stores it.
#[derive(Debug)]
pub struct Recorder {
    started: Instant,
    control: Arc<Control>,
    recording: Mutex<Recording>,
}

#[derive(Debug)]
struct Recording {
    last_seq: u64,
    points: Vec<NumberedPoint>,
    progress: Progress,
    changed: bool,
}

impl Recorder {
    /// A recorder whose attempt begins now.
    pub fn new(control: Arc<Control>) -> Self {
        let progress = Progress { fraction: 0.0, phase: None, iteration: None, message: None, energy_latest: None };
        let recording = Recording { last_seq: 0, points: Vec::new(), progress, changed: true };
        Recorder { started: Instant::now(), control, recording: Mutex::new(recording) }
    }

    /// What was told since the last time; `None` if nothing was.
    pub fn take(&self) -> Option<TraceChunk> {
        let mut recording = self.lock();
        if !recording.changed {
            return None;
        }
        recording.changed = false;
        Some(TraceChunk { points: std::mem::take(&mut recording.points), progress: recording.progress.clone() })
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Recording> {
        self.recording.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Observer for Recorder {
    fn phase(&self, phase: Phase) {
        let mut recording = self.lock();
        recording.progress.phase = Some(phase);
        recording.progress.iteration = None;
        recording.changed = true;
    }

    fn progress(&self, fraction: f64) {
        let mut recording = self.lock();
        // NaN fails the comparison and is left out.
        if fraction > recording.progress.fraction {
            recording.progress.fraction = fraction.min(1.0);
            recording.changed = true;
        }
    }

    fn trace(&self, point: &TracePoint) {
        let elapsed_ms = u64::try_from(self.started.elapsed().as_millis()).unwrap_or(u64::MAX);
        let mut recording = self.lock();
        recording.last_seq += 1;
        let point = NumberedPoint { seq: recording.last_seq, point: finite(point), elapsed_ms };
        recording.progress.iteration = Some(point.point.iteration);
        recording.progress.energy_latest = point.point.energy.or(recording.progress.energy_latest);
        recording.points.push(point);
        recording.changed = true;
    }

    fn is_cancelled(&self) -> bool {
        self.control.is_stopped()
    }
}

/// The point without values that are not finite: JSON has none, and a stored `null` would be a lie about absence.
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
    fn points_are_numbered_without_a_gap_over_several_takes() {
        let recorder = Recorder::new(Arc::default());
        let mut seen = Vec::new();
        for iteration in 1..=5 {
            recorder.trace(&TracePoint::new(0, Phase::Inference, iteration));
            if iteration % 2 == 0 {
                seen.extend(recorder.take().unwrap().points);
            }
        }
        seen.extend(recorder.take().unwrap().points);
        assert_eq!(seen.iter().map(|p| p.seq).collect::<Vec<_>>(), [1, 2, 3, 4, 5]);
        assert!(recorder.take().is_none());
    }

    #[test]
    fn progress_never_goes_back() {
        let recorder = Recorder::new(Arc::default());
        for fraction in [0.2, 0.5, 0.3, f64::NAN, 7.0] {
            recorder.progress(fraction);
        }
        assert_eq!(recorder.take().unwrap().progress.fraction, 1.0);
    }
}
