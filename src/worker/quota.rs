//! When a process that only runs jobs ends by itself.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// When a process ends by itself, as one that was started for a few jobs does.
#[derive(Debug, Default)]
pub struct Quota {
    /// After so long without a job.
    pub idle: Option<Duration>,
    /// After so many jobs.
    pub max_jobs: Option<u64>,
    begun: AtomicU64,
    running: AtomicU64,
    idle_since: Mutex<Option<Instant>>,
}

impl Quota {
    /// A quota; `None` is without end.
    pub fn new(idle: Option<Duration>, max_jobs: Option<u64>) -> Self {
        Quota { idle, max_jobs, ..Quota::default() }
    }

    /// Takes a place for a job to be claimed; `false` if there were enough.
    pub(super) fn begin(&self) -> bool {
        let begun = self.begun.fetch_add(1, Ordering::SeqCst);
        if self.max_jobs.is_some_and(|most| begun >= most) {
            self.begun.fetch_sub(1, Ordering::SeqCst);
            return false;
        }
        self.running.fetch_add(1, Ordering::SeqCst);
        true
    }

    /// Gives the place back if there was no job for it.
    pub(super) fn claimed(&self, found: bool) {
        if !found {
            self.begun.fetch_sub(1, Ordering::SeqCst);
            self.running.fetch_sub(1, Ordering::SeqCst);
        }
    }

    /// A job came to its end.
    pub(super) fn ended(&self) {
        self.running.fetch_sub(1, Ordering::SeqCst);
        *self.idle_since.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }

    /// Whether the process should end.
    pub(super) fn is_over(&self) -> bool {
        let is_idle = self.running.load(Ordering::SeqCst) == 0;
        if self.max_jobs.is_some_and(|most| self.begun.load(Ordering::SeqCst) >= most) {
            return is_idle;
        }
        let Some(most) = self.idle else { return false };
        let mut since = self.idle_since.lock().unwrap_or_else(PoisonError::into_inner);
        is_idle && since.get_or_insert_with(Instant::now).elapsed() >= most
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_process_ends_after_its_jobs_and_not_before_the_last_is_done() {
        let quota = Quota::new(None, Some(2));
        assert!(quota.begin() && quota.begin());
        assert!(!quota.begin(), "two were begun");
        quota.claimed(false);
        assert!(quota.begin(), "there was no job after all");
        quota.ended();
        assert!(!quota.is_over(), "one still runs");
        quota.ended();
        assert!(quota.is_over());
    }

    #[test]
    fn a_process_ends_after_a_while_without_a_job() {
        let quota = Quota::new(Some(Duration::from_millis(20)), None);
        assert!(!quota.is_over());
        std::thread::sleep(Duration::from_millis(30));
        assert!(quota.begin());
        assert!(!quota.is_over(), "a job runs");
        quota.ended();
        assert!(!quota.is_over(), "it ran just now");
        std::thread::sleep(Duration::from_millis(30));
        assert!(quota.is_over());
        assert!(!Quota::default().is_over());
    }
}
