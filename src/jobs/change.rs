//! The feed of state changes, from which a client catches up after an outage.

use super::ids::{BatchId, JobId};
use super::state::JobState;
use jiff::Timestamp;

/// A change of the state of a job.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    /// Its number, ascending in the order of commits: a change never appears after one with a larger number.
    pub seq: u64,
    /// The job.
    pub job_id: JobId,
    /// The batch it belongs to.
    pub batch_id: Option<BatchId>,
    /// The new state.
    pub state: JobState,
    /// When.
    pub at: Timestamp,
}

/// A page of the feed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChangePage {
    /// Changes in ascending order of `seq`.
    pub changes: Vec<Change>,
    /// `since` of the next page: the last `seq` of this one, or the requested one if this page is empty.
    pub next_since: u64,
    /// Whether there are further changes.
    pub more: bool,
}
