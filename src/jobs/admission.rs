//! Under which conditions a job is taken: room in the queue, and once for an idempotency key.

use super::batch::BatchId;
use super::job::{JobId, Tenant};
use std::time::Duration;

/// What surrounds the storing of jobs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Admission {
    /// Most jobs of the tenant that may wait.
    pub max_queued: u32,
    /// Under which name the inputs' blobs are held; the hold ends when the jobs are stored.
    pub holder: String,
    /// How long a result is kept, for a job that has one at once; for ever if `None`.
    pub keep_result: Option<Duration>,
    /// The idempotency key that the submission came with; it remembers what was made, in the same transaction.
    pub once: Option<Once>,
}

/// An idempotency key in use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Once {
    /// Whose.
    pub tenant: Tenant,
    /// The key.
    pub name: String,
    /// Hash of all that the request says.
    pub fingerprint: String,
    /// Random: who works on it.
    pub token: String,
    /// How long what was made is remembered.
    pub keep_for: Duration,
}

/// What a key stands for already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OnceStatus {
    /// Nothing: go on.
    Begun,
    /// The same request is being worked on.
    InProgress,
    /// Another request came with this key.
    OtherRequest,
    /// The same request was answered with this.
    Made(Made),
}

/// What a request made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Made {
    /// A job.
    Job(JobId),
    /// A batch.
    Batch(BatchId),
}

impl Made {
    /// The form in the database.
    pub fn to_text(self) -> String {
        match self {
            Made::Job(id) => format!("job:{id}"),
            Made::Batch(id) => format!("batch:{id}"),
        }
    }

    /// What a text from the database stands for.
    pub fn from_text(text: &str) -> Option<Self> {
        match text.split_once(':')? {
            ("job", id) => JobId::parse(id).map(Made::Job),
            ("batch", id) => BatchId::parse(id).map(Made::Batch),
            _ => None,
        }
    }
}
