//! Why a use case or a store did not do what it was asked.

use super::state::JobState;

/// Errors of jobs and of the stores behind them.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// No such job of this tenant.
    #[error("no such job")]
    NotFound,
    /// The queue is at its limit.
    #[error("{limit} jobs wait already")]
    QueueFull {
        /// Most jobs that may wait.
        limit: u32,
    },
    /// The job has to be finished first.
    #[error("the job is {}", state.name())]
    StillActive {
        /// Its state.
        state: JobState,
    },
    /// The job is finished, and not by being cancelled.
    #[error("the job is {} already", state.name())]
    AlreadyFinal {
        /// Its state.
        state: JobState,
    },
    /// The job has no result yet.
    #[error("the job is {}", state.name())]
    NotReady {
        /// Its state.
        state: JobState,
    },
    /// The job ended without a result.
    #[error("the job is {}", state.name())]
    NoResult {
        /// Its state.
        state: JobState,
    },
    /// No such upload of this tenant.
    #[error("no such mesh")]
    MeshNotFound,
    /// No such batch of this tenant.
    #[error("no such batch")]
    BatchNotFound,
    /// No such webhook of this tenant.
    #[error("no such webhook")]
    WebhookNotFound,
    /// Jobs refer to the upload.
    #[error("jobs refer to the mesh")]
    MeshInUse,
    /// The result was removed when its time was over.
    #[error("the result was removed")]
    Gone,
    /// A blob is being removed; it can be written again in a moment.
    #[error("the blob is being removed")]
    BeingRemoved,
    /// The lease is somebody else's now, or the job is finished or gone.
    #[error("the lease is lost")]
    LeaseLost,
    /// No room on disk.
    #[error("the store is full")]
    StorageFull,
    /// The store cannot answer now.
    #[error("the store is unavailable")]
    Unavailable(#[source] Box<dyn std::error::Error + Send + Sync>),
    /// The store answers something that cannot be.
    #[error("the store holds something unreadable: {what}")]
    Corrupt {
        /// What was read.
        what: &'static str,
        /// Why it cannot be.
        #[source]
        source: Option<Box<dyn std::error::Error + Send + Sync>>,
    },
}

impl JobError {
    /// A stored thing that cannot be read.
    pub fn corrupt(what: &'static str, source: impl std::error::Error + Send + Sync + 'static) -> Self {
        JobError::Corrupt { what, source: Some(Box::new(source)) }
    }
}
