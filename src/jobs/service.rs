//! The use cases: what the outside may ask of jobs.

use super::engine::{Engine, InputBytes, InputRefusal, InputSummary, MethodDescription, ParameterFault};
use super::error::JobError;
use super::job::{Job, JobFilter, JobId, JobInput, JobPage, NewJob, PageRequest, Tenant};
use super::ports::{ArtifactKey, ArtifactKind, ArtifactRef, ArtifactStore, JobStore};
use super::state::JobState;
use super::trace::TracePage;
use bytes::Bytes;
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{Notify, Semaphore};

/// How long a submission may take between writing its blobs and storing its job.
const HOLD: Duration = Duration::from_secs(600);

/// Parts of results read and made into other formats at the same time.
const MAX_PRESENTATIONS: usize = 4;

/// Bounds on what is accepted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubmissionLimits {
    /// Most jobs that may wait.
    pub max_queued: u32,
    /// Most inputs checked at the same time.
    pub max_checks: usize,
    /// Longest wait for a free check.
    pub max_check_wait: Duration,
    /// Crashes after which a job is dead.
    pub max_attempts: u32,
}

/// A job to be accepted.
#[derive(Debug, Clone)]
pub struct Submission {
    /// Owner.
    pub tenant: Tenant,
    /// The surface that moves.
    pub source: SubmittedFile,
    /// The surface that stays.
    pub target: SubmittedFile,
    /// Parameters as asked for.
    pub parameters: Value,
    /// −100 to 100, higher first.
    pub priority: i32,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name for it.
    pub external_ref: Option<String>,
}

/// An uploaded file.
#[derive(Debug, Clone)]
pub struct SubmittedFile {
    /// All of it.
    pub bytes: Bytes,
    /// The endings of its name.
    pub name_hint: Option<String>,
}

/// Why a job is not accepted.
#[derive(Debug, thiserror::Error)]
pub enum SubmitError {
    /// The parameters are not right.
    #[error("{} faults in the parameters", .0.len())]
    Parameters(Vec<ParameterFault>),
    /// An input is not right.
    #[error("{input}: {}", refusal.detail)]
    Input {
        /// `source` or `target`.
        input: &'static str,
        /// Why.
        refusal: InputRefusal,
    },
    /// Both inputs are right, but not together.
    #[error("{}", .0.detail)]
    Pair(InputRefusal),
    /// Too many inputs are being checked.
    #[error("too many inputs are being checked")]
    Busy,
    /// A check ended in a panic.
    #[error("checking {input} failed")]
    CheckFailed {
        /// `source` or `target`.
        input: &'static str,
    },
    /// The store.
    #[error(transparent)]
    Job(#[from] JobError),
}

/// The use cases over one store, one blob store and one engine.
pub struct JobService {
    store: Arc<dyn JobStore>,
    artifacts: Arc<dyn ArtifactStore>,
    pub(super) engine: Arc<dyn Engine>,
    limits: SubmissionLimits,
    checks: Arc<Semaphore>,
    /// Parts of results made into other formats at the same time; each is in memory twice.
    pub(super) presentations: Arc<Semaphore>,
    /// Wakes workers of this process; polling is the truth, this only makes it prompt.
    queued: Arc<Notify>,
}

impl JobService {
    /// The use cases; `queued` is notified of every accepted job.
    pub fn new(
        store: Arc<dyn JobStore>,
        artifacts: Arc<dyn ArtifactStore>,
        engine: Arc<dyn Engine>,
        limits: SubmissionLimits,
        queued: Arc<Notify>,
    ) -> Self {
        let checks = Arc::new(Semaphore::new(limits.max_checks.max(1)));
        let presentations = Arc::new(Semaphore::new(MAX_PRESENTATIONS));
        JobService { store, artifacts, engine, limits, checks, presentations, queued }
    }

    /// Accepts a job: checks parameters and both inputs, stores the blobs, then the job. On return it is durable.
    ///
    /// # Errors
    /// [`SubmitError`].
    pub async fn submit(&self, submission: Submission) -> Result<Job, SubmitError> {
        let resolved = self.engine.resolve(&submission.parameters).map_err(SubmitError::Parameters)?;
        self.refuse_when_full().await?;
        let source = self.check("source", &submission.source, &resolved.parameters).await?;
        let target = self.check("target", &submission.target, &resolved.parameters).await?;

        self.engine.check_pair(&source, &target).map_err(SubmitError::Pair)?;

        let id = JobId::new();
        let holder = id.to_string();
        let files = [&submission.source, &submission.target];
        let keys = files.map(|file| ArtifactKey::of(&submission.tenant, &file.bytes));
        let input = |file: &SubmittedFile, key: &ArtifactKey, summary: InputSummary| JobInput {
            hash: key.hash.clone(),
            n_bytes: file.bytes.len() as u64,
            name_hint: file.name_hint.clone(),
            n_vertices: summary.n_vertices,
            n_faces: summary.n_faces,
            report: summary.report,
        };
        let job = NewJob {
            id,
            tenant: submission.tenant.clone(),
            method: resolved.method,
            method_version: resolved.method_version,
            parameters: resolved.parameters,
            source: input(&submission.source, &keys[0], source),
            target: input(&submission.target, &keys[1], target),
            priority: submission.priority,
            labels: submission.labels.clone(),
            external_ref: submission.external_ref.clone(),
            max_attempts: self.limits.max_attempts,
        };
        // The hold comes before the blobs: a removal that runs meanwhile leaves them alone.
        self.store.hold_blobs(&holder, &keys, HOLD).await?;
        let stored = async {
            for (key, file) in keys.iter().zip(files) {
                self.artifacts.put(key, file.bytes.clone()).await?;
            }
            self.store.insert(&job, self.limits.max_queued, &holder).await
        }
        .await;
        match stored {
            Ok(job) => {
                self.queued.notify_one();
                Ok(job)
            }
            Err(error) => {
                // The hold lapses by itself if this does not succeed either.
                if self.store.drop_hold(&holder).await.is_ok() {
                    let _ = self.store.remove_unreferenced_blobs(self.artifacts.as_ref()).await;
                }
                Err(error.into())
            }
        }
    }

    /// [`JobError::QueueFull`] if no job would be accepted now; asked before an upload is read.
    ///
    /// # Errors
    /// That, and those of the store.
    pub async fn refuse_when_full(&self) -> Result<(), JobError> {
        let limit = self.limits.max_queued;
        if self.store.queue_length().await? >= limit { Err(JobError::QueueFull { limit }) } else { Ok(()) }
    }

    async fn check(
        &self,
        input: &'static str,
        file: &SubmittedFile,
        parameters: &Value,
    ) -> Result<InputSummary, SubmitError> {
        let permit = tokio::time::timeout(self.limits.max_check_wait, Arc::clone(&self.checks).acquire_owned());
        let Ok(Ok(permit)) = permit.await else { return Err(SubmitError::Busy) };
        let (engine, file, parameters) = (Arc::clone(&self.engine), file.clone(), parameters.clone());
        let checked = tokio::task::spawn_blocking(move || {
            let _permit = permit; // given back when the check ends, also if nobody waits for it any more
            let bytes = InputBytes { bytes: &file.bytes, name_hint: file.name_hint.as_deref() };
            engine.check_input(&bytes, &parameters)
        });
        match checked.await {
            Ok(Ok(summary)) => Ok(summary),
            Ok(Err(refusal)) => Err(SubmitError::Input { input, refusal }),
            Err(_) => Err(SubmitError::CheckFailed { input }),
        }
    }

    /// A job.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn get(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.store.get(tenant, id).await
    }

    /// A part of the list of jobs.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn list(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError> {
        self.store.list(tenant, filter, page).await
    }

    /// Asks for a job's end.
    ///
    /// # Errors
    /// [`JobError::AlreadyFinal`] if it ended otherwise.
    pub async fn cancel(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.store.cancel(tenant, id).await
    }

    /// Removes a finished job with its trace, and its blobs unless other jobs refer to them.
    ///
    /// # Errors
    /// [`JobError::StillActive`].
    pub async fn delete(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        self.store.delete(tenant, id).await?;
        // What cannot be removed now stays noted and is tried again by the housekeeper.
        if let Err(error) = self.store.remove_unreferenced_blobs(self.artifacts.as_ref()).await {
            tracing::warn!(job_id = %id, %error, "blobs of a deleted job remain for now");
        }
        Ok(())
    }

    /// A part of a job's trace.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError> {
        self.store.trace(tenant, id, after_seq, limit).await
    }

    /// Where a part of a succeeded job's result is.
    ///
    /// # Errors
    /// [`JobError::NotReady`] before the job is finished, [`JobError::NoResult`] if it ended without one.
    pub async fn result_part(&self, tenant: &Tenant, id: JobId, kind: ArtifactKind) -> Result<ArtifactRef, JobError> {
        match self.store.artifact(tenant, id, kind).await? {
            (JobState::Succeeded, Some(artifact)) => Ok(artifact),
            (JobState::Succeeded, None) => {
                Err(JobError::Corrupt { what: "a succeeded job without its result", source: None })
            }
            (state, _) if state.is_final() => Err(JobError::NoResult { state }),
            (state, _) => Err(JobError::NotReady { state }),
        }
    }

    /// The bytes of a blob.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn read(&self, artifact: &ArtifactRef) -> Result<Bytes, JobError> {
        self.artifacts.get(&artifact.key).await
    }

    /// The methods there are.
    pub fn methods(&self) -> Vec<MethodDescription> {
        self.engine.methods()
    }

    /// Whether the job store and the blob store answer.
    pub async fn dependencies(&self) -> [(&'static str, Result<(), JobError>); 2] {
        [("job_store", self.store.ping().await), ("artifact_store", self.artifacts.ping().await)]
    }
}
