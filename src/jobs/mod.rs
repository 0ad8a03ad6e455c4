//! Jobs: what they are, the states they pass through, who may change them, and the ports to what stores and computes.
//!
//! Reading order: [`state`] (the machine), [`job`] (the record), [`lease`] (who works on it, fenced by an epoch),
//! [`trace`] (what a running job tells), [`ports`] (stores) and [`engine`] (the computation), [`service`] (use cases),
//! [`presentation`] (a result in the formats in which it can be had).
//!
//! Invariant: nothing here knows SQL, HTTP or how a match is computed. Parameters, reports and results are JSON
//! values and blobs that pass through.

pub mod documents;
pub mod engine;
pub mod error;
pub mod job;
pub mod lease;
pub mod ports;
pub mod presentation;
pub mod service;
pub mod state;
pub mod trace;

pub use engine::{ComputeError, ComputeTask, Engine, InputBytes, InputRefusal, InputSummary, ParameterFault};
pub use error::JobError;
pub use job::{Failure, Job, JobFilter, JobId, JobInput, JobPage, NewJob, Order, PageRequest, Tenant};
pub use lease::{Lease, LeaseStatus, LeasedJob, Recovered, WorkerId};
pub use ports::{ArtifactKey, ArtifactKind, ArtifactRef, ArtifactStore, JobStore, Outcome};
pub use presentation::{PartFormat, PresentError, Presentation, ResultPart};
pub use service::{JobService, Submission, SubmissionLimits, SubmitError, SubmittedFile};
pub use state::{CancelEffect, JobState, cancel_effect, state_after_crash, state_after_release};
pub use trace::{NumberedPoint, Progress, TraceChunk, TracePage};
