//! Observers of a match within a match.

use homolog_primitives::observe::Observer;
use parking_lot::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// Forwards only steps and cancellation; phases, progress and trace are those of the outer match.
pub(super) struct StepsOnly<'a>(pub &'a dyn Observer);

impl Observer for StepsOnly<'_> {
    fn step(&self) {
        self.0.step();
    }
    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// Forwards only steps and cancellation until the match is kept in place of the outer one, then all reports.
pub(super) struct UnseenUntilKept<'a> {
    observer: &'a dyn Observer,
    is_kept: AtomicBool,
}

impl<'a> UnseenUntilKept<'a> {
    pub(super) fn new(observer: &'a dyn Observer) -> Self {
        UnseenUntilKept { observer, is_kept: AtomicBool::new(false) }
    }

    pub(super) fn keep(&self) {
        self.is_kept.store(true, Ordering::Relaxed);
    }
}

impl Observer for UnseenUntilKept<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        self.is_kept.load(Ordering::Relaxed).then_some(self.observer)
    }
    fn step(&self) {
        self.observer.step();
    }
    fn is_cancelled(&self) -> bool {
        self.observer.is_cancelled()
    }
}

/// Forwards all reports, but of the progress only what is more than before: a match that takes the place of another
/// begins with less.
pub(super) struct RisingProgress<'a> {
    observer: &'a dyn Observer,
    reported: Mutex<f64>,
}

impl<'a> RisingProgress<'a> {
    pub(super) fn new(observer: &'a dyn Observer) -> Self {
        RisingProgress { observer, reported: Mutex::new(0.0) }
    }
}

impl Observer for RisingProgress<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
    fn progress(&self, fraction: f64) {
        // Held during the report, so that reports are in order.
        let mut reported = self.reported.lock();
        if fraction >= *reported {
            *reported = fraction;
            self.observer.progress(fraction);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Seen(Mutex<Vec<f64>>);

    impl Observer for Seen {
        fn progress(&self, fraction: f64) {
            self.0.lock().push(fraction);
        }
    }

    #[test]
    fn a_match_is_seen_once_it_is_kept_and_progress_never_falls() {
        let seen = Seen::default();
        let rising = RisingProgress::new(&seen);
        let inner = UnseenUntilKept::new(&rising);
        rising.progress(0.3);
        inner.progress(0.4);
        inner.keep();
        inner.progress(0.1);
        inner.progress(0.5);
        assert_eq!(*seen.0.lock(), [0.3, 0.5]);
    }
}
