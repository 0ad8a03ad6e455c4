//! The feed of state changes: what a platform reads to catch up after an outage.

use super::batch::BatchId;
use super::job::JobId;
use super::state::JobState;
use jiff::Timestamp;

/// A job's change of state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    /// Its number: ascending in the order of commits, so that none appears later with a smaller number.
    pub seq: u64,
    /// The job.
    pub job_id: JobId,
    /// The batch it belongs to.
    pub batch_id: Option<BatchId>,
    /// The state it came to.
    pub state: JobState,
    /// When.
    pub at: Timestamp,
}

/// A part of the feed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChangePage {
    /// Changes in ascending order of `seq`.
    pub changes: Vec<Change>,
    /// What to ask for next: the last `seq` here, or that asked with.
    pub next_since: u64,
    /// Whether more wait.
    pub more: bool,
}
