//! Progress of a displacement, from the number of its steps.

use crate::pair::progress::{PROGRESS_AT_END, PROGRESS_BEFORE_LOCAL};
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use parking_lot::Mutex;

/// Number of steps, and the share of the processor time of the displacement at the beginning of that step, from four
/// pairs of hippocampi. The second step precedes inference. The local stage begins at the 54th
/// or skips the steps of stages that were not run. The energy of the answer follows the last step.
const CURVE: [(f64, f64); 7] =
    [(0.0, 0.0), (2.0, 0.1), (25.0, 0.155), (32.0, 0.205), (54.0, PROGRESS_BEFORE_LOCAL), (87.0, 0.72), (122.0, 0.9)];

/// Reports the progress of a displacement, estimated from the number of steps. The
/// rounds of its energy trace follow those of inference.
pub(crate) struct DisplacementProgress<'a> {
    pub observer: &'a dyn Observer,
    /// Progress of the match at the beginning of the displacement.
    pub done_before: f64,
    pub n_steps: Mutex<u32>,
    /// The last round of inference, which the first fit shares; `None` if no energy of labels was minimized before.
    pub last_round: Option<u32>,
}

/// Share of the time of a displacement at the step `n_steps`. Beyond the expected number of steps it approaches 1
/// exponentially.
fn time_share(n_steps: f64) -> f64 {
    let [.., before, last] = CURVE;
    let linear = |[a, b]: [(f64, f64); 2]| a.1 + (n_steps - a.0) * (b.1 - a.1) / (b.0 - a.0);
    let beyond = |n_more: f64| {
        1.0 - (1.0 - last.1) * (-n_more * (last.1 - before.1) / (last.0 - before.0) / (1.0 - last.1)).exp()
    };
    let within = CURVE.array_windows().find(|[_, b]| n_steps <= b.0).map(|segment| linear(*segment));
    within.unwrap_or_else(|| beyond(n_steps - last.0))
}

impl Observer for DisplacementProgress<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
    fn trace(&self, point: &TracePoint) {
        // The energy of the labels of near isometries is not that of the rounds.
        if self.last_round.is_none() || point.phase != Phase::Inference {
            self.observer.trace(&TracePoint { round: self.last_round.unwrap_or(0) + point.round, ..point.clone() });
        }
    }
    /// A stage begins at `share` of the displacement: the steps of previous stages that were not run are skipped.
    fn progress(&self, share: f64) {
        let mut n_steps = self.n_steps.lock();
        while time_share(f64::from(*n_steps)) < share {
            *n_steps += 1;
        }
    }
    fn step(&self) {
        // Held during the report, so that reported progress never decreases.
        let mut n_steps = self.n_steps.lock();
        *n_steps += 1;
        let done = time_share(f64::from(*n_steps));
        self.observer.progress(self.done_before + (PROGRESS_AT_END - self.done_before) * done);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_primitives::observe::{checkpoint, checkpoint_within};

    #[derive(Default)]
    struct Said(Mutex<Vec<f64>>);

    impl Observer for Said {
        fn progress(&self, fraction: f64) {
            self.0.lock().push(fraction);
        }
        fn is_cancelled(&self) -> bool {
            self.0.lock().len() >= 3
        }
    }

    #[test]
    fn only_steps_count_as_progress_and_checks_within_a_step_stop_it() {
        let said = Said::default();
        let counting =
            DisplacementProgress { observer: &said, done_before: 0.0, n_steps: Mutex::new(0), last_round: None };
        let stack = super::super::unseen::StepsOnly(&counting);
        for step in 1..=3 {
            for _ in 0..1000 {
                assert!(checkpoint_within(&stack).is_ok());
            }
            assert_eq!(said.0.lock().len(), step - 1, "only steps are counted");
            assert_eq!(checkpoint(&stack).is_err(), step == 3);
        }
        assert!(checkpoint_within(&stack).is_err());
    }
}
