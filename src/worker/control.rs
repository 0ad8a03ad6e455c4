//! How a running computation is told to stop, and why.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use tokio_util::sync::CancellationToken;

/// Why a computation should end without a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopCause {
    /// Somebody asked.
    CancelRequested,
    /// It took longer than it may.
    TimeLimit,
    /// The process ends; another will run it.
    Shutdown,
    /// The job is somebody else's now: nothing may be written any more.
    LeaseLost,
}

/// One for each running job; set by the heartbeat and the worker, asked by the computation.
#[derive(Debug, Default)]
pub struct Control {
    stopped: AtomicBool,
    cause: Mutex<Option<StopCause>>,
    token: CancellationToken,
}

impl Control {
    /// Tells the computation to stop. The first cause stays, unless the lease is lost, which outweighs all.
    pub fn stop(&self, cause: StopCause) {
        let mut held = self.cause.lock().unwrap_or_else(PoisonError::into_inner);
        if held.is_none() || cause == StopCause::LeaseLost {
            *held = Some(cause);
        }
        drop(held);
        self.stopped.store(true, Ordering::Release);
        self.token.cancel();
    }

    /// Whether the computation should stop. Costs an atomic load.
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Acquire)
    }

    /// Why.
    pub fn cause(&self) -> Option<StopCause> {
        *self.cause.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns once the computation is told to stop.
    pub async fn stopped(&self) {
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
