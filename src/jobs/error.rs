//! Errors of the use cases and of the stores.

use super::result_part::PresentError;
use super::state::JobState;
use super::study_state::StudyState;

/// Errors of jobs and of the stores behind them.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// No such job of this tenant.
    #[error("no such job")]
    NotFound,
    /// The queue has no room.
    #[error("{limit} jobs wait already")]
    QueueFull {
        /// Maximum number of queued jobs.
        limit: u32,
    },
    /// The tenant has stored as many bytes as it may.
    #[error("{stored} of {limit} bytes are stored")]
    ShareFull {
        /// Its stored bytes.
        stored: u64,
        /// Maximum number of its stored bytes.
        limit: u64,
    },
    /// The job has to be finished first.
    #[error("the job is {}", state.name())]
    StillActive {
        /// Its state.
        state: JobState,
    },
    /// The job has finished, and was not cancelled.
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
    /// A part of the result is not available in a format.
    #[error(transparent)]
    NotPresented(#[from] PresentError),
    /// No such upload of this tenant.
    #[error("no such mesh")]
    MeshNotFound,
    /// No such batch of this tenant.
    #[error("no such batch")]
    BatchNotFound,
    /// No such study of this tenant.
    #[error("no such study")]
    StudyNotFound,
    /// The study has no subject of this id.
    #[error("no such subject")]
    SubjectNotFound,
    /// The study, or a job of it, has to be finished first.
    #[error("the study is {}", state.name())]
    StudyActive {
        /// Its state.
        state: StudyState,
    },
    /// The study has ended, and was not cancelled.
    #[error("the study is {} already", state.name())]
    StudyFinal {
        /// Its state.
        state: StudyState,
    },
    /// The study has no result.
    #[error("the study is {}", state.name())]
    StudyNotReady {
        /// Its state.
        state: StudyState,
    },
    /// The study was changed by others again and again.
    #[error("the study is being changed")]
    StudyBusy,
    /// No such webhook of this tenant.
    #[error("no such webhook")]
    WebhookNotFound,
    /// No such API key of this tenant.
    #[error("no such API key")]
    KeyNotFound,
    /// Jobs refer to the upload.
    #[error("jobs refer to the mesh")]
    MeshInUse,
    /// The result has outlived its retention and was removed.
    #[error("the result was removed")]
    Gone,
    /// A blob is being removed; it can be written again in a moment.
    #[error("the blob is being removed")]
    BeingRemoved,
    /// Another worker holds the lease, or the job has finished or was deleted.
    #[error("the lease is lost")]
    LeaseLost,
    /// A text contains a NUL character, which not every database stores.
    #[error("a text contains a NUL character")]
    Unstorable,
    /// The disk is full.
    #[error("the store is full")]
    StorageFull,
    /// The store does not answer at the moment.
    #[error("the store is unavailable")]
    Unavailable(#[source] Box<dyn std::error::Error + Send + Sync>),
    /// The store holds something invalid.
    #[error("the store holds something unreadable: {what}")]
    Corrupt {
        /// Name of the thing that was read.
        what: &'static str,
        /// Why it is invalid.
        #[source]
        source: Option<Box<dyn std::error::Error + Send + Sync>>,
    },
}

impl JobError {
    /// The error for something stored that cannot be read.
    pub fn corrupt(what: &'static str, source: impl std::error::Error + Send + Sync + 'static) -> Self {
        JobError::Corrupt { what, source: Some(Box::new(source)) }
    }
}
