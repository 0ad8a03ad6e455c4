//! The conditions under which jobs are stored: room in the queue, and once per idempotency key.

use super::ids::{BatchId, JobId, StudyId};
use super::job::Tenant;
use std::time::Duration;

/// The conditions under which a submission is stored.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Admission {
    /// Maximum number of queued jobs of the tenant.
    pub max_queued: u32,
    /// The name under which the inputs' blobs are held; the hold is released when the jobs are stored.
    pub holder: String,
    /// Retention of a result that is taken from an equal job at submission; forever if `None`.
    pub keep_result: Option<Duration>,
    /// The idempotency key of the submission; what was created is recorded under it in the same transaction.
    pub once: Option<IdempotencyKey>,
}

/// An idempotency key in use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IdempotencyKey {
    /// Its owner.
    pub tenant: Tenant,
    /// The key.
    pub name: String,
    /// Hash of everything that the request states.
    pub fingerprint: String,
    /// Random; identifies the request that reserved the key.
    pub token: String,
    /// How long the key is kept after the request has succeeded.
    pub keep_for: Duration,
}

/// The status of an idempotency key when a request comes with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OnceStatus {
    /// It was free and is now reserved for this request.
    Begun,
    /// The same request is in progress.
    InProgress,
    /// It was used for another request.
    OtherRequest,
    /// The same request has created this.
    Made(Made),
}

/// A job, batch or study that a request created.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Made {
    /// A job.
    Job(JobId),
    /// A batch.
    Batch(BatchId),
    /// A study.
    Study(StudyId),
}

impl Made {
    /// The form in the database.
    pub fn to_text(self) -> String {
        match self {
            Made::Job(id) => format!("job:{id}"),
            Made::Batch(id) => format!("batch:{id}"),
            Made::Study(id) => format!("study:{id}"),
        }
    }

    /// Parses the form in the database.
    pub fn from_text(text: &str) -> Option<Self> {
        match text.split_once(':')? {
            ("job", id) => JobId::parse(id).map(Made::Job),
            ("batch", id) => BatchId::parse(id).map(Made::Batch),
            ("study", id) => StudyId::parse(id).map(Made::Study),
            _ => None,
        }
    }
}
