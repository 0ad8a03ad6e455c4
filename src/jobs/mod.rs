//! Jobs: what they are, their states and who may change them, the use cases, and the ports to storage and computation.
//!
//! Reading order: `ids`, [`state`] (the state machine), [`job`] (the record), [`lease`] (which worker runs it, fenced by an epoch),
//! [`trace`] (progress and energy trace), [`demand`] (cores, memory and processor time), [`turns`] (of tenants), `artifact` (blobs), [`ports`] (storage), `input_check`, `result_part`, [`engine`] (the computation),
//! [`service`] (the use cases), [`submission`], [`uploads`], [`follow`], [`signals`]. Beside the job: [`admission`], `stored_bytes` and `stored` (bytes of a tenant),
//! [`mod@batch`], `study_state`, [`study`] with [`study_submission`], [`study_outline`], [`study_score`] and [`study_progress`], [`change`], [`mesh`], [`metadata`], [`key`], [`ticket`] with `ticketing`, [`audit`], [`webhook`], [`retention`], [`presentation`] (a result in other formats).
//!
//! Invariant: nothing here knows SQL, HTTP or how a match is computed. Parameters, reports and results pass through as JSON
//! and blobs; an [`engine::Computation`] holds parameters in types that are opaque here.

pub mod address;
pub mod admission;
mod artifact;
pub mod audit;
pub mod batch;
pub mod change;
pub mod demand;
pub mod documents;
pub mod engine;
pub mod error;
pub mod follow;
mod forecast;
mod ids;
mod input_check;
pub mod job;
pub mod key;
pub mod lease;
pub mod mesh;
pub mod metadata;
pub mod ports;
pub mod presentation;
mod result_part;
pub mod retention;
pub mod service;
pub mod signals;
pub mod state;
mod stored;
mod stored_bytes;
pub mod study;
pub mod study_outline;
pub mod study_progress;
pub mod study_score;
mod study_state;
pub mod study_submission;
pub mod submission;
pub mod ticket;
mod ticketing;
pub mod trace;
pub mod turns;
pub mod uid;
pub mod uploads;
pub mod webhook;

pub use admission::{Admission, IdempotencyKey, Made, OnceStatus};
pub(crate) use artifact::BLOB_HOLD;
pub use artifact::{ArtifactKey, ArtifactKind, ArtifactRef};
pub use audit::{AuditEvent, AuditHead, AuditRow, AuditStore};
pub use batch::{Batch, BatchPage, NewBatch};
pub use change::{Change, ChangePage};
pub use demand::{Demand, SurfaceSize, WaitingJob};
pub use engine::{
    Allotted, Computation, ComputeError, ComputeInputs, Engine, InputBytes, InputView, OutOfProcess, ParameterFault,
    Purpose,
};
pub use error::JobError;
pub use ids::{BatchId, JobId, StudyId};
pub(crate) use ids::{SCORE_METHOD, STEP_METHOD};
pub use input_check::{InputRefusal, InputSummary};
pub use job::{Failure, Job, JobFilter, JobInput, JobPage, NewJob, Order, PageRequest, Tenant};
pub use key::{ApiKey, KeyPage, KeyStore, Role, Scope, SecretKey};
pub use lease::{Lease, LeaseStatus, LeasedJob, Recovered, WorkerId};
pub use mesh::{CheckOutcome, Mesh, MeshPage, MeshStore};
pub use ports::{
    ArtifactStore, ArtifactWriter, BlobHolds, BlobStream, ClockState, DepartedProcess, Housekeeping, JobQueue,
    JobReader, JobStore, JobWriter, Load, Outcome, Processes,
};
pub use presentation::{Presentation, Presented};
pub use result_part::{PartFormat, PresentError, ResultPart, WarpDirection, WarpSpace};
pub(crate) use retention::Concerned;
pub use retention::{MAX_DAYS, Overdue, Purged, Retention, Retentions, TenantDays, kept};
pub use service::{BulkCancelled, JobService, Stores, SubmissionLimits};
pub use signals::{Moves, Signals};
pub use state::{CancelEffect, JobState, cancel_effect, state_after_crash, state_after_release};
pub use study::{Study, StudyBlob, StudyChange, StudyPage, StudyStore};
pub use study_outline::{OutlinedSubject, StudyOutline};
pub use study_progress::StudyProgression;
pub use study_score::ScoreSubmission;
pub use study_state::StudyState;
pub use submission::{
    Accepted, BatchForm, BatchPair, BatchSubmission, JobOptions, Submission, SubmitError, SubmittedFile,
    SubmittedInput, Validated,
};
pub use ticket::{MAX_TICKETS, TICKET_LASTS, Ticket};
pub use trace::{NumberedPoint, Progress, TraceChunk, TracePage};
pub use turns::{TenantWeight, TenantWeights};
pub use uid::{DicomDetails, GivenUids, Uid};
pub use webhook::{
    Attempted, Delivery, DeliveryPage, DeliveryState, DueDelivery, Turn, TurnLimits, Webhook, WebhookPage, WebhookStore,
};
