//! Batches: many jobs that are submitted at once and counted together.

use super::ids::BatchId;
use super::job::{Cursor, Tenant};
use super::metadata::{ExternalRef, Tags};
use super::state::JobState;
use jiff::Timestamp;
use std::collections::BTreeMap;

/// A batch to be stored.
#[derive(Debug, Clone, PartialEq)]
pub struct NewBatch {
    /// Identity.
    pub id: BatchId,
    /// Owner.
    pub tenant: Tenant,
    /// Tags of the submitter.
    pub tags: Tags,
    /// The submitter's own identifier.
    pub external_ref: Option<ExternalRef>,
}

/// A batch as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// Identity.
    pub id: BatchId,
    /// Owner.
    pub tenant: Tenant,
    /// Number of jobs with which it was submitted.
    pub n_jobs: u32,
    /// Tags of the submitter.
    pub tags: BTreeMap<String, String>,
    /// The submitter's own identifier.
    pub external_ref: Option<String>,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// Number of its jobs in each state; jobs that were deleted are not counted.
    pub counts: BTreeMap<JobState, u32>,
}

impl Batch {
    /// Whether none of its jobs is queued or running.
    pub fn is_finished(&self) -> bool {
        self.counts.iter().all(|(state, &n)| state.is_final() || n == 0)
    }
}

/// A page of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct BatchPage {
    /// The batches.
    pub batches: Vec<Batch>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}
