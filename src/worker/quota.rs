//! When a process that only runs jobs exits by itself.

use parking_lot::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Limits after which a process exits by itself, for example a process that a batch scheduler starts for a few jobs.
#[derive(Debug, Default)]
pub struct Quota {
    /// Exits after this time without a job.
    pub idle: Option<Duration>,
    /// Exits after this number of jobs.
    pub max_jobs: Option<u64>,
    begun: AtomicU64,
    running: AtomicU64,
    idle_since: Mutex<Option<Instant>>,
}

impl Quota {
    /// A quota; `None` is no limit.
    pub fn new(idle: Option<Duration>, max_jobs: Option<u64>) -> Self {
        Quota { idle, max_jobs, ..Quota::default() }
    }

    /// Counts a job that is about to be claimed; `false` if the limit on jobs is reached.
    pub(super) fn begin(&self) -> bool {
        let begun = self.begun.fetch_add(1, Ordering::SeqCst);
        if self.max_jobs.is_some_and(|most| begun >= most) {
            self.begun.fetch_sub(1, Ordering::SeqCst);
            return false;
        }
        self.running.fetch_add(1, Ordering::SeqCst);
        true
    }

    /// Reverses the count if no job was found.
    pub(super) fn claimed(&self, found: bool) {
        if !found {
            self.begun.fetch_sub(1, Ordering::SeqCst);
            self.running.fetch_sub(1, Ordering::SeqCst);
        }
    }

    /// Records that a job has ended.
    pub(super) fn ended(&self) {
        self.running.fetch_sub(1, Ordering::SeqCst);
        *self.idle_since.lock() = None;
    }

    /// Whether the process should exit.
    pub(super) fn is_over(&self) -> bool {
        let is_idle = self.running.load(Ordering::SeqCst) == 0;
        if self.max_jobs.is_some_and(|most| self.begun.load(Ordering::SeqCst) >= most) {
            return is_idle;
        }
        let Some(most) = self.idle else { return false };
        let mut since = self.idle_since.lock();
        is_idle && since.get_or_insert_with(Instant::now).elapsed() >= most
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_process_exits_after_its_jobs_and_not_before_the_last_has_ended() {
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
    fn a_process_exits_after_a_time_without_a_job() {
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
