//! The states of a job, and the only code that decides which state follows which.
//!
//! A store reads a row, calls this module, and writes the new state, all in one transaction.

use serde::{Deserialize, Serialize};

/// The state of a job. A final state never changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum JobState {
    /// Waits for a worker.
    Queued,
    /// A worker holds its lease.
    Running,
    /// Has a result.
    Succeeded,
    /// Ended without a result; `error` says why.
    Failed,
    /// Cancelled on request.
    Cancelled,
    /// Its deadline passed, or its result was removed when its time was over.
    Expired,
    /// Its workers crashed too often.
    Dead,
}

impl JobState {
    /// All states.
    pub const ALL: [JobState; 7] = [
        JobState::Queued,
        JobState::Running,
        JobState::Succeeded,
        JobState::Failed,
        JobState::Cancelled,
        JobState::Expired,
        JobState::Dead,
    ];

    /// The name used in JSON and in the database.
    pub fn name(self) -> &'static str {
        match self {
            JobState::Queued => "queued",
            JobState::Running => "running",
            JobState::Succeeded => "succeeded",
            JobState::Failed => "failed",
            JobState::Cancelled => "cancelled",
            JobState::Expired => "expired",
            JobState::Dead => "dead",
        }
    }

    /// The state of this name.
    pub fn from_name(name: &str) -> Option<JobState> {
        JobState::ALL.into_iter().find(|s| s.name() == name)
    }

    /// Whether the state is final.
    pub fn is_final(self) -> bool {
        !matches!(self, JobState::Queued | JobState::Running)
    }
}

/// Effect of a request to cancel on a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CancelEffect {
    /// It is queued: it is cancelled at once.
    CancelNow,
    /// A worker is running it and learns of the request through its heartbeat.
    TellWorker,
    /// It is cancelled already: nothing changes.
    AlreadyCancelled,
    /// It has ended otherwise.
    AlreadyFinal,
}

/// Effect of a request to cancel on a job in `state`.
pub fn cancel_effect(state: JobState) -> CancelEffect {
    match state {
        JobState::Queued => CancelEffect::CancelNow,
        JobState::Running => CancelEffect::TellWorker,
        JobState::Cancelled => CancelEffect::AlreadyCancelled,
        JobState::Succeeded | JobState::Failed | JobState::Expired | JobState::Dead => CancelEffect::AlreadyFinal,
    }
}

/// The next state of a running job whose worker was lost; `crashes` includes this loss.
///
/// A lost worker is no failure: the job returns to the queue until `max_attempts` workers were lost. If its cancellation was
/// requested before, it is cancelled.
pub fn state_after_crash(cancel_requested: bool, crashes: u32, max_attempts: u32) -> JobState {
    if cancel_requested {
        JobState::Cancelled
    } else if crashes >= max_attempts {
        JobState::Dead
    } else {
        JobState::Queued
    }
}

/// The next state of a running job that its worker releases, for example at a shutdown. That counts neither as an attempt nor
/// as a crash.
pub fn state_after_release(cancel_requested: bool) -> JobState {
    if cancel_requested { JobState::Cancelled } else { JobState::Queued }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_parse_back() {
        for state in JobState::ALL {
            assert_eq!(JobState::from_name(state.name()), Some(state));
            assert_eq!(serde_json::to_value(state).unwrap(), state.name());
        }
    }

    #[test]
    fn cancellation_never_changes_a_final_state() {
        for state in JobState::ALL {
            let changes = matches!(cancel_effect(state), CancelEffect::CancelNow | CancelEffect::TellWorker);
            assert_eq!(changes, !state.is_final(), "{state:?}");
        }
    }

    #[test]
    fn the_crash_limit_ends_a_job() {
        let after: Vec<_> = (1..=3).map(|n| state_after_crash(false, n, 3)).collect();
        assert_eq!(after, [JobState::Queued, JobState::Queued, JobState::Dead]);
        assert_eq!(state_after_crash(true, 1, 3), JobState::Cancelled);
    }
}
