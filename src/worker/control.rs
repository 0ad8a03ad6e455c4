//! How a running computation is told to stop, and why.

use parking_lot::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use tokio_util::sync::CancellationToken;

/// Why a computation is told to stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StopCause {
    /// A client cancelled the job.
    CancelRequested,
    /// The job exceeded its time limit.
    TimeLimit,
    /// The process exits; another process will run the job.
    Shutdown,
    /// Another worker holds the job: this worker may not write anything more.
    LeaseLost,
}

/// The stop signal of a running job: set by the heartbeat and the worker, read by the computation.
#[derive(Debug, Default)]
pub(crate) struct Control {
    stopped: AtomicBool,
    cause: Mutex<Option<StopCause>>,
    token: CancellationToken,
}

impl Control {
    /// Tells the computation to stop. The first cause is kept, except that a lost lease overrides any other.
    pub(crate) fn stop(&self, cause: StopCause) {
        let mut held = self.cause.lock();
        if held.is_none() || cause == StopCause::LeaseLost {
            *held = Some(cause);
        }
        drop(held);
        self.stopped.store(true, Ordering::Release);
        self.token.cancel();
    }

    /// Whether the computation should stop. Costs one atomic load.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Acquire)
    }

    /// Why the computation should stop.
    pub(crate) fn cause(&self) -> Option<StopCause> {
        *self.cause.lock()
    }

    /// Returns when the computation is told to stop.
    pub(crate) async fn stopped(&self) {
        self.token.cancelled().await;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_cause_stays_unless_the_lease_is_lost() {
        let control = Control::default();
        assert!(!control.is_stopped());
        control.stop(StopCause::CancelRequested);
        control.stop(StopCause::Shutdown);
        assert_eq!(control.cause(), Some(StopCause::CancelRequested));
        control.stop(StopCause::LeaseLost);
        assert_eq!(control.cause(), Some(StopCause::LeaseLost));
        assert!(control.is_stopped());
    }
}
