//! The progress of a displacement, by its checks for cancellation.

use crate::pair::progress::PROGRESS_AT_END;
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use std::sync::{Mutex, PoisonError};

/// Checks for cancellation in the displacement of a pair of two subjects: 70 to 74 in four pairs of hippocampi. Other pairs have
/// fewer or more.
const CHECKS_OF_DISPLACEMENT: f64 = 75.0;

/// Says how much of a displacement is done, by the number of checks for cancellation: there is one for each step. The rounds of its energy
/// trace follow those of inference.
pub(crate) struct Counting<'a> {
    pub observer: &'a dyn Observer,
    /// The share of the match that was done before.
    pub done_before: f64,
    pub n_checks: Mutex<u32>,
    /// The last round of inference, which is that of the first fit too; `None` where no energy of labels was minimised before.
    pub last_round: Option<u32>,
}

/// The share of the time of a displacement that has passed after `share` of its checks. Something has been done before the first
/// one, poses are compared by many cheap steps before later ones have more points, and a displacement of more checks than expected
/// comes to its end ever more slowly.
fn time_share(share: f64) -> f64 {
    const FIRST: f64 = 0.14;
    const EXPONENT: f64 = 2.0;
    const LAST: f64 = 0.9;
    let early = |share: f64| FIRST + (1.0 - FIRST) * share.powf(EXPONENT);
    if share <= LAST {
        return early(share);
    }
    let (reached, slope) = (early(LAST), (1.0 - FIRST) * EXPONENT * LAST.powf(EXPONENT - 1.0));
    1.0 - (1.0 - reached) * (-(share - LAST) * slope / (1.0 - reached)).exp()
}

impl Observer for Counting<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
    fn trace(&self, point: &TracePoint) {
        // Labels of near isometries have another energy than those of the rounds.
        if self.last_round.is_none() || point.phase != Phase::Inference {
            self.observer.trace(&TracePoint { round: self.last_round.unwrap_or(0) + point.round, ..point.clone() });
        }
    }
    fn is_cancelled(&self) -> bool {
        // Held while it is said, so that what is said never decreases.
        let mut n_checks = self.n_checks.lock().unwrap_or_else(PoisonError::into_inner);
        *n_checks += 1;
        let done = time_share(f64::from(*n_checks) / CHECKS_OF_DISPLACEMENT);
        self.observer.progress(self.done_before + (PROGRESS_AT_END - self.done_before) * done);
        self.observer.is_cancelled()
    }
}
