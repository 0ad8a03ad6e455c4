//! The use cases: what clients can do with jobs.
//!
//! Submissions are in [`super::submission`], uploads in [`super::uploads`], following a job in [`super::follow`].

use super::artifact::{ArtifactKind, ArtifactRef};
use super::audit::{AuditStore, Recorder};
use super::batch::{Batch, BatchPage};
use super::change::ChangePage;
use super::engine::{Engine, MethodDescription};
use super::error::JobError;
use super::follow::{Feed, Feeds, Seen};
use super::forecast::Forecast;
use super::ids::{BatchId, JobId, StudyId};
use super::job::{Cursor, Job, JobFilter, JobPage, Order, PageRequest, Tenant};
use super::key::{ApiKey, KeyPage, KeyStore, Role, SecretKey};
use super::mesh::MeshStore;
use super::ports::{ArtifactStore, BlobStream, JobStore, Load};
use super::retention::Retentions;
use super::signals::Signals;
use super::state::JobState;
use super::stored_bytes::StoredBytes;
use super::study::{Study, StudyStore};
use super::study_progress::StudyProgression;
use super::trace::TracePage;
use super::webhook::WebhookStore;
use bytes::Bytes;
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

/// Time limit of a readiness check of a dependency, shorter than the time limit of a supervisor.
const READINESS_TIMEOUT: Duration = Duration::from_millis(900);

/// Number of parts of results that are read and converted at the same time.
const MAX_PRESENTATIONS: usize = 4;

/// Limits on submissions, and how long results are kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SubmissionLimits {
    /// Maximum number of queued jobs per tenant.
    pub max_queued: u32,
    /// Maximum number of inputs checked at the same time.
    pub max_checks: usize,
    /// How long a submission waits for the check of its inputs to start.
    pub max_check_wait: Duration,
    /// Number of lost workers after which a job is dead.
    pub max_attempts: u32,
    /// Maximum number of jobs in a batch.
    pub max_batch: usize,
    /// How long an idempotency key is kept.
    pub once_for: Duration,
    /// How long results are kept; for ever if `None`.
    pub retention: Retentions,
    /// Maximum run time of a job.
    pub max_run: Duration,
    /// Maximum number of bytes of a tenant's uploads and results; any number if `None`.
    pub max_stored_bytes: Option<u64>,
    /// Most cores that a job is taken to get, for estimates of its run time.
    pub cores: usize,
}

/// The stores of the use cases.
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
    /// Studies.
    pub studies: Arc<dyn StudyStore>,
    /// The audit log.
    pub audit: Arc<dyn AuditStore>,
    /// Blobs.
    pub artifacts: Arc<dyn ArtifactStore>,
}

/// The use cases over these stores and one engine.
pub struct JobService {
    pub(super) stores: Stores,
    pub(super) engine: Arc<dyn Engine>,
    pub(super) limits: SubmissionLimits,
    pub(super) checks: Arc<Semaphore>,
    /// Permits to convert parts of results; during a conversion the part is in memory twice.
    pub(super) presentations: Arc<Semaphore>,
    /// Wakes the workers of this process. Only makes them faster: they also poll.
    pub(super) signals: Arc<Signals>,
    feeds: Feeds,
    pub(super) forecast: Forecast,
    recorder: Arc<Recorder>,
    pub(super) stored: StoredBytes,
}

/// The outcome of cancelling many jobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BulkCancelled {
    /// Queued jobs that were cancelled at once.
    pub cancelled: u32,
    /// Running jobs whose workers were told to stop.
    pub told: u32,
}

impl JobService {
    /// The use cases; `signals` carry accepted jobs to the workers of this process, and state changes back.
    pub fn new(stores: Stores, engine: Arc<dyn Engine>, limits: SubmissionLimits, signals: Arc<Signals>) -> Self {
        let checks = Arc::new(Semaphore::new(limits.max_checks.max(1)));
        let presentations = Arc::new(Semaphore::new(MAX_PRESENTATIONS));
        let forecast = Forecast::new(Arc::clone(&engine), limits.cores);
        let (jobs, studies) = (Arc::clone(&stores.jobs), Arc::clone(&stores.studies));
        let feeds = Feeds::new(jobs, studies, forecast.clone(), Arc::clone(&signals));
        let recorder = Recorder::new(Arc::clone(&stores.audit));
        JobService {
            stores,
            engine,
            limits,
            checks,
            presentations,
            signals,
            feeds,
            forecast,
            recorder,
            stored: StoredBytes::default(),
        }
    }

    /// Appends to the audit log.
    pub fn recorder(&self) -> &Arc<Recorder> {
        &self.recorder
    }

    /// The progress of studies.
    pub(super) fn progression(&self) -> StudyProgression {
        StudyProgression {
            jobs: Arc::clone(&self.stores.jobs),
            studies: Arc::clone(&self.stores.studies),
            artifacts: Arc::clone(&self.stores.artifacts),
            signals: Arc::clone(&self.signals),
            retention: self.limits.retention.clone(),
        }
    }

    /// Limits on submissions.
    pub fn limits(&self) -> &SubmissionLimits {
        &self.limits
    }

    /// Records of webhooks.
    pub fn webhooks(&self) -> &dyn WebhookStore {
        self.stores.webhooks.as_ref()
    }

    /// The record of an API key: its tenant and scopes. `None` if the key is not valid.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn authenticate(&self, key: &SecretKey) -> Result<Option<ApiKey>, JobError> {
        let stored = self.stores.keys.get_key(key.id()).await?;
        Ok(stored.filter(|stored| stored.is_valid && key.has_hash(&stored.hash)))
    }

    /// Whether the key with this public part exists, is not revoked and has not expired.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn is_key_valid(&self, id: &str) -> Result<bool, JobError> {
        Ok(self.stores.keys.get_key(id).await?.is_some_and(|key| key.is_valid))
    }

    /// Creates a key of a tenant. `None` if the tenant has `at_most` valid ones already; concurrent requests may exceed that
    /// by their own number.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn create_key(
        &self,
        tenant: &Tenant,
        name: &str,
        role: Role,
        valid_for: Option<Duration>,
        at_most: u32,
    ) -> Result<Option<(SecretKey, ApiKey)>, JobError> {
        let keys = self.stores.keys.as_ref();
        if keys.count_valid_keys(tenant).await? >= at_most {
            return Ok(None);
        }
        let key = SecretKey::random();
        keys.insert_key(&key, tenant, name, role.scopes(), valid_for).await?;
        let stored = self.key(tenant, key.id()).await?;
        Ok(Some((key, stored)))
    }

    /// A key of a tenant.
    ///
    /// # Errors
    /// [`JobError::KeyNotFound`].
    pub async fn key(&self, tenant: &Tenant, id: &str) -> Result<ApiKey, JobError> {
        let found = self.stores.keys.get_key(id).await?;
        found.filter(|key| key.tenant == *tenant).ok_or(JobError::KeyNotFound)
    }

    /// A page of a tenant's keys, newest first, after a creation time in ms and an id.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn keys(&self, tenant: &Tenant, size: u32, after: Option<(i64, String)>) -> Result<KeyPage, JobError> {
        self.stores.keys.list_tenant_keys(tenant, size, after).await
    }

    /// Revokes a key of a tenant; no error if it was revoked before.
    ///
    /// # Errors
    /// [`JobError::KeyNotFound`].
    pub async fn revoke_key(&self, tenant: &Tenant, id: &str) -> Result<(), JobError> {
        let key = self.key(tenant, id).await?;
        self.stores.keys.revoke_key(&key.id).await.map(|_| ())
    }

    /// Checks whether the tenant's queue and its share of the storage have room; called before the files of a submission are
    /// read.
    ///
    /// # Errors
    /// [`JobError::QueueFull`] or [`JobError::ShareFull`] if one has none, and those of the store.
    pub async fn refuse_when_full(&self, tenant: &Tenant) -> Result<(), JobError> {
        let limit = self.limits.max_queued;
        let waiting = self.stores.jobs.queue_length(tenant, limit).await?;
        if waiting >= limit {
            return Err(JobError::QueueFull { limit });
        }
        self.refuse_over_share(tenant, 1).await
    }

    /// The numbers of queued and running jobs of all tenants.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn load(&self) -> Result<Load, JobError> {
        self.stores.jobs.load().await
    }

    /// Follows a job. All followers of a job in this process share one reader of the store.
    ///
    /// # Errors
    /// [`JobError::NotFound`].
    pub async fn follow(&self, tenant: &Tenant, id: JobId) -> Result<Arc<Feed<Seen>>, JobError> {
        self.feeds.follow(tenant, id).await
    }

    /// Follows a batch and its counts; its followers in this process share one reader too.
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

    /// Follows a study.
    ///
    /// # Errors
    /// [`JobError::StudyNotFound`].
    pub async fn follow_study(&self, tenant: &Tenant, id: StudyId) -> Result<Arc<Feed<Study>>, JobError> {
        self.feeds.follow_study(tenant, id).await
    }

    /// Cancels all unfinished jobs that match a filter.
    ///
    /// # Errors
    /// [`JobError`]; jobs that were cancelled before the error stay cancelled.
    pub async fn cancel_all(&self, tenant: &Tenant, filter: &JobFilter) -> Result<BulkCancelled, JobError> {
        let mut filter = filter.clone();
        filter.states.retain(|state| !state.is_final());
        if filter.states.is_empty() {
            // Queued jobs first, so that none of them starts while running ones are cancelled.
            filter.states = vec![JobState::Queued, JobState::Running];
        }
        let mut done = BulkCancelled::default();
        for state in filter.states.clone() {
            let filter = JobFilter { states: vec![state], ..filter.clone() };
            let mut page = PageRequest { size: 200, after: None, order: Order::OldestFirst };
            loop {
                let JobPage { jobs, next } = self.stores.jobs.list_jobs(tenant, &filter, &page).await?;
                for job in jobs {
                    match self.stores.jobs.cancel_job(tenant, job.id).await {
                        Ok(job) if job.state == JobState::Cancelled => done.cancelled += 1,
                        Ok(_) => done.told += 1,
                        // It has ended or was deleted in the meantime.
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

    /// A batch with the number of its jobs in each state.
    ///
    /// # Errors
    /// [`JobError::BatchNotFound`].
    pub async fn batch(&self, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError> {
        self.stores.jobs.get_batch(tenant, id).await
    }

    /// A page of the list of batches, newest first.
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
        self.stores.jobs.list_changes(tenant, since, limit).await
    }

    /// The number of a tenant's last change; 0 if it has none.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn newest_change(&self, tenant: &Tenant) -> Result<u64, JobError> {
        self.stores.jobs.newest_change(tenant).await
    }

    /// A job.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn get(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.stores.jobs.get_job(tenant, id).await.map(|job| self.forecast.of(job))
    }

    /// A page of the list of jobs.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn list(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError> {
        self.stores.jobs.list_jobs(tenant, filter, page).await
    }

    /// Cancels a job: a queued one at once, a running one as soon as its worker stops.
    ///
    /// # Errors
    /// [`JobError::AlreadyFinal`] if it has ended otherwise.
    pub async fn cancel(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.stores.jobs.cancel_job(tenant, id).await.map(|job| self.forecast.of(job))
    }

    /// Sets the priority of a job that has not ended.
    ///
    /// # Errors
    /// [`JobError::AlreadyFinal`] if it has.
    pub async fn set_priority(&self, tenant: &Tenant, id: JobId, priority: i32) -> Result<Job, JobError> {
        self.stores.jobs.set_priority(tenant, id, priority).await.map(|job| self.forecast.of(job))
    }

    /// Deletes a finished job with its trace, and its blobs unless other jobs refer to them.
    ///
    /// # Errors
    /// [`JobError::StillActive`].
    pub async fn delete(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        self.stores.jobs.delete_job(tenant, id).await?;
        // Blobs that cannot be removed now stay candidates, and housekeeping removes them later.
        if let Err(error) = self.remove_unreferenced_blobs().await {
            tracing::warn!(job_id = %id, %error, "blobs of a deleted job could not be removed yet");
        }
        Ok(())
    }

    pub(super) async fn remove_unreferenced_blobs(&self) -> Result<u32, JobError> {
        self.stores.jobs.remove_unreferenced_blobs(self.stores.artifacts.as_ref()).await
    }

    /// A page of a job's trace.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError> {
        self.stores.jobs.get_trace(tenant, id, after_seq, limit).await
    }

    /// The blob with a part of a succeeded job's result.
    ///
    /// # Errors
    /// [`JobError::NotReady`] before the job has finished, [`JobError::NoResult`] if it ended without a result.
    pub async fn result_part(&self, tenant: &Tenant, id: JobId, kind: ArtifactKind) -> Result<ArtifactRef, JobError> {
        match self.stores.jobs.get_artifact(tenant, id, kind).await? {
            (JobState::Succeeded, Some(artifact)) => Ok(artifact),
            // That of a score is the score alone.
            (state @ JobState::Succeeded, None) => Err(match self.get(tenant, id).await?.is_score() {
                true => JobError::NoResult { state },
                false => JobError::Corrupt { what: "a succeeded job without its result", source: None },
            }),
            (state, _) if state.is_final() => Err(JobError::NoResult { state }),
            (state, _) => Err(JobError::NotReady { state }),
        }
    }

    /// The content of a blob, or a range of it, in pieces.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn open(&self, artifact: &ArtifactRef, range: Option<Range<u64>>) -> Result<BlobStream, JobError> {
        self.stores.artifacts.open(&artifact.key, artifact.n_bytes, range).await
    }

    /// The content of a blob.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn read(&self, artifact: &ArtifactRef) -> Result<Bytes, JobError> {
        self.stores.artifacts.get(&artifact.key).await
    }

    /// The available methods.
    pub fn methods(&self) -> Vec<MethodDescription> {
        self.engine.methods()
    }

    /// Whether the clock of the job store is not believed, because it was set by days.
    pub fn has_clock_jumped(&self) -> bool {
        self.stores.jobs.clock_has_jumped()
    }

    /// Whether the job store and the blob store answer.
    pub async fn dependencies(&self) -> [(&'static str, Result<(), JobError>); 2] {
        let pings = tokio::join!(
            tokio::time::timeout(READINESS_TIMEOUT, self.stores.jobs.ping()),
            tokio::time::timeout(READINESS_TIMEOUT, self.stores.artifacts.ping()),
        );
        let answer = |ping: Result<Result<(), JobError>, tokio::time::error::Elapsed>| {
            ping.unwrap_or_else(|late| Err(JobError::Unavailable(Box::new(late))))
        };
        [("job_store", answer(pings.0)), ("artifact_store", answer(pings.1))]
    }
}
