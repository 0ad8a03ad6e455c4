//! Whether a store has recently refused a write for lack of space.
//!
//! A server that answers a health check does not report that its disk is full or its quota used up. The last refusal is
//! therefore remembered for a while: readiness reports "full" during this time, and load balancers send submissions
//! elsewhere. After it, the next submission tests whether there is room again.

use crate::jobs::JobError;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// How long a refusal counts.
const REMEMBERED: Duration = Duration::from_secs(10);

/// The last refusal of a store.
#[derive(Debug)]
pub(super) struct Space {
    begun: Instant,
    /// End of the time for which the refusal counts, in milliseconds since the creation of this value.
    full_until_ms: AtomicU64,
}

impl Default for Space {
    fn default() -> Self {
        Space { begun: Instant::now(), full_until_ms: AtomicU64::new(0) }
    }
}

impl Space {
    /// Remembers a refusal; returns the outcome unchanged.
    pub(super) fn noted<T>(&self, outcome: Result<T, JobError>) -> Result<T, JobError> {
        if matches!(outcome, Err(JobError::StorageFull)) {
            let until = self.begun.elapsed() + REMEMBERED;
            self.full_until_ms.store(until.as_millis() as u64, Ordering::Relaxed);
        }
        outcome
    }

    /// # Errors
    /// [`JobError::StorageFull`] for ten seconds after a refusal.
    pub(super) fn check(&self) -> Result<(), JobError> {
        let is_full = (self.begun.elapsed().as_millis() as u64) < self.full_until_ms.load(Ordering::Relaxed);
        if is_full { Err(JobError::StorageFull) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_is_remembered_for_a_while() {
        let space = Space::default();
        assert!(space.noted(Ok(())).is_ok() && space.check().is_ok());
        assert!(space.noted::<()>(Err(JobError::NotFound)).is_err() && space.check().is_ok());
        assert!(space.noted::<()>(Err(JobError::StorageFull)).is_err());
        assert!(matches!(space.check(), Err(JobError::StorageFull)));
        let earlier = Space { begun: Instant::now() - REMEMBERED, full_until_ms: AtomicU64::new(9_000) };
        assert!(earlier.check().is_ok());
    }
}
