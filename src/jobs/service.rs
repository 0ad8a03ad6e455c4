//! The use cases: what the outside may ask of jobs.
//!
//! Submissions are in [`super::submission`], uploads in [`super::uploads`], following a job in [`super::follow`].

use super::batch::{Batch, BatchId, BatchPage};
use super::change::ChangePage;
use super::engine::{Engine, MethodDescription};
use super::error::JobError;
use super::follow::{Feed, Feeds, Seen};
use super::job::{Cursor, Job, JobFilter, JobId, JobPage, Order, PageRequest, Tenant};
use super::key::{ApiKey, KeyStore, SecretKey};
use super::mesh::MeshStore;
use super::ports::{ArtifactKind, ArtifactRef, ArtifactStore, JobStore, Load};
use super::signals::Signals;
use super::state::JobState;
use super::trace::TracePage;
use super::webhook::WebhookStore;
use bytes::Bytes;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

/// Longest look at a dependency: who asks is a supervisor with little patience.
const LOOK: Duration = Duration::from_secs(3);

/// Parts of results read and made into other formats at the same time.
const MAX_PRESENTATIONS: usize = 4;

/// Bounds on what is accepted, and how long it is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubmissionLimits {
    /// Most jobs of a tenant that may wait.
    pub max_queued: u32,
    /// Most inputs checked at the same time.
    pub max_checks: usize,
    /// Longest wait for a free check.
    pub max_check_wait: Duration,
    /// Crashes after which a job is dead.
    pub max_attempts: u32,
    /// Most jobs of a batch.
    pub max_batch: usize,
    /// How long an idempotency key is remembered.
    pub once_for: Duration,
    /// How long results are kept; for ever if `None`.
    pub keep_results: Option<Duration>,
    /// Longest run of a job.
    pub max_run: Duration,
}

/// All that the use cases keep things in.
#[derive(Clone)]
pub struct Stores {
    /// Jobs.
    pub jobs: Arc<dyn JobStore>,
    /// Uploads.
    pub meshes: Arc<dyn MeshStore>,
    /// API keys.
    pub keys: Arc<dyn KeyStore>,
    /// Webhooks.
    pub webhooks: Arc<dyn WebhookStore>,
    /// Blobs.
    pub artifacts: Arc<dyn ArtifactStore>,
}

/// The use cases over these stores and one engine.
pub struct JobService {
    pub(super) stores: Stores,
    pub(super) engine: Arc<dyn Engine>,
    pub(super) limits: SubmissionLimits,
    pub(super) checks: Arc<Semaphore>,
    /// Parts of results made into other formats at the same time; each is in memory twice.
    pub(super) presentations: Arc<Semaphore>,
    /// Wakes workers of this process; polling is the truth, this only makes it prompt.
    pub(super) signals: Arc<Signals>,
    feeds: Feeds,
}

/// What a cancellation of many jobs did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BulkCancelled {
    /// Jobs that were cancelled at once.
    pub cancelled: u32,
    /// Running jobs whose workers were told.
    pub told: u32,
}

impl JobService {
    /// The use cases; `signals` tell workers of every accepted job, and are told by them how jobs move on.
    pub fn new(stores: Stores, engine: Arc<dyn Engine>, limits: SubmissionLimits, signals: Arc<Signals>) -> Self {
        let checks = Arc::new(Semaphore::new(limits.max_checks.max(1)));
        let presentations = Arc::new(Semaphore::new(MAX_PRESENTATIONS));
        let feeds = Feeds::new(Arc::clone(&stores.jobs), Arc::clone(&signals));
        JobService { stores, engine, limits, checks, presentations, signals, feeds }
    }

    /// Bounds on what is accepted.
    pub fn limits(&self) -> &SubmissionLimits {
        &self.limits
    }

    /// Records of webhooks.
    pub fn webhooks(&self) -> &dyn WebhookStore {
        self.stores.webhooks.as_ref()
    }

    /// Whose key this is, and what it allows; `None` for a key that is not valid.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn authenticate(&self, key: &SecretKey) -> Result<Option<ApiKey>, JobError> {
        let stored = self.stores.keys.get_key(key.id()).await?;
        Ok(stored.filter(|stored| stored.is_valid && key.has_hash(&stored.hash)))
    }

    /// [`JobError::QueueFull`] if no job of the tenant would be accepted now; asked before an upload is read.
    ///
    /// # Errors
    /// That, and those of the store.
    pub async fn refuse_when_full(&self, tenant: &Tenant) -> Result<(), JobError> {
        let limit = self.limits.max_queued;
        let waiting = self.stores.jobs.queue_length(tenant, limit).await?;
        if waiting >= limit { Err(JobError::QueueFull { limit }) } else { Ok(()) }
    }

    /// What waits and what runs, of all tenants.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn load(&self) -> Result<Load, JobError> {
        self.stores.jobs.load().await
    }

    /// Follows a job: one reader of the store for all who follow it in this process.
    ///
    /// # Errors
    /// [`JobError::NotFound`].
    pub async fn follow(&self, tenant: &Tenant, id: JobId) -> Result<Arc<Feed<Seen>>, JobError> {
        self.feeds.follow(tenant, id).await
    }

    /// Follows a batch and its counts, likewise.
    ///
    /// # Errors
    /// [`JobError::BatchNotFound`].
    pub async fn follow_batch(&self, tenant: &Tenant, id: BatchId) -> Result<Arc<Feed<Batch>>, JobError> {
        self.feeds.follow_batch(tenant, id).await
    }

    /// Follows the feed of changes: turns true when there are changes after number `since`.
    pub fn follow_changes(&self, tenant: &Tenant, since: u64) -> Arc<Feed<bool>> {
        self.feeds.follow_changes(tenant, since)
    }

    /// Cancels all jobs that a filter shows and that are not finished.
    ///
    /// # Errors
    /// [`JobError`]; what was cancelled before stays so.
    pub async fn cancel_all(&self, tenant: &Tenant, filter: &JobFilter) -> Result<BulkCancelled, JobError> {
        let mut filter = filter.clone();
        filter.states.retain(|state| !state.is_final());
        if filter.states.is_empty() {
            // Waiting ones first, so that none of them begins while others are cancelled.
            filter.states = vec![JobState::Queued, JobState::Running];
        }
        let mut done = BulkCancelled::default();
        for state in filter.states.clone() {
            let filter = JobFilter { states: vec![state], ..filter.clone() };
            let mut page = PageRequest { size: 200, after: None, order: Order::OldestFirst };
            loop {
                let JobPage { jobs, next } = self.stores.jobs.list(tenant, &filter, &page).await?;
                for job in jobs {
                    match self.stores.jobs.cancel(tenant, job.id).await {
                        Ok(job) if job.state == JobState::Cancelled => done.cancelled += 1,
                        Ok(_) => done.told += 1,
                        // It ended or was removed at this moment.
                        Err(JobError::AlreadyFinal { .. } | JobError::NotFound) => {}
                        Err(error) => return Err(error),
                    }
                }
                page.after = next;
                if next.is_none() {
                    break;
                }
            }
        }
        Ok(done)
    }

    /// A batch with its counts.
    ///
    /// # Errors
    /// [`JobError::BatchNotFound`].
    pub async fn batch(&self, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError> {
        self.stores.jobs.get_batch(tenant, id).await
    }

    /// A part of the list of batches.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn batches(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<BatchPage, JobError> {
        self.stores.jobs.list_batches(tenant, size, after).await
    }

    /// State changes after number `since`.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn changes(&self, tenant: &Tenant, since: u64, limit: u32) -> Result<ChangePage, JobError> {
        self.stores.jobs.changes(tenant, since, limit).await
    }

    /// A job.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn get(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.stores.jobs.get(tenant, id).await
    }

    /// A part of the list of jobs.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn list(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError> {
        self.stores.jobs.list(tenant, filter, page).await
    }

    /// Asks for a job's end.
    ///
    /// # Errors
    /// [`JobError::AlreadyFinal`] if it ended otherwise.
    pub async fn cancel(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.stores.jobs.cancel(tenant, id).await
    }

    /// Removes a finished job with its trace, and its blobs unless other jobs refer to them.
    ///
    /// # Errors
    /// [`JobError::StillActive`].
    pub async fn delete(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        self.stores.jobs.delete(tenant, id).await?;
        // What cannot be removed now stays noted and is tried again by the housekeeper.
        if let Err(error) = self.remove_unreferenced_blobs().await {
            tracing::warn!(job_id = %id, %error, "blobs of a deleted job remain for now");
        }
        Ok(())
    }

    pub(super) async fn remove_unreferenced_blobs(&self) -> Result<u32, JobError> {
        self.stores.jobs.remove_unreferenced_blobs(self.stores.artifacts.as_ref()).await
    }

    /// A part of a job's trace.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError> {
        self.stores.jobs.trace(tenant, id, after_seq, limit).await
    }

    /// Where a part of a succeeded job's result is.
    ///
    /// # Errors
    /// [`JobError::NotReady`] before the job is finished, [`JobError::NoResult`] if it ended without one.
    pub async fn result_part(&self, tenant: &Tenant, id: JobId, kind: ArtifactKind) -> Result<ArtifactRef, JobError> {
        match self.stores.jobs.artifact(tenant, id, kind).await? {
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
        self.stores.artifacts.get(&artifact.key).await
    }

    /// The methods there are.
    pub fn methods(&self) -> Vec<MethodDescription> {
        self.engine.methods()
    }

    /// Whether the job store and the blob store answer.
    pub async fn dependencies(&self) -> [(&'static str, Result<(), JobError>); 2] {
        let looks = tokio::join!(
            tokio::time::timeout(LOOK, self.stores.jobs.ping()),
            tokio::time::timeout(LOOK, self.stores.artifacts.ping()),
        );
        let answer = |look: Result<Result<(), JobError>, tokio::time::error::Elapsed>| {
            look.unwrap_or_else(|late| Err(JobError::Unavailable(Box::new(late))))
        };
        [("job_store", answer(looks.0)), ("artifact_store", answer(looks.1))]
    }
}
