//! The ports to what stores: jobs with their queue, and blobs.

use super::admission::{Admission, Once, OnceStatus};
use super::batch::{Batch, BatchId, BatchPage, NewBatch};
use super::change::ChangePage;
use super::demand::WaitingJob;
use super::error::JobError;
use super::job::{Cursor, Failure, Job, JobFilter, JobId, JobPage, NewJob, PageRequest, Tenant};
use super::lease::{Lease, LeaseStatus, LeasedJob, Recovered, WorkerId};
use super::retention::{Overdue, Purged, Retention};
use super::trace::{TraceChunk, TracePage};
use async_trait::async_trait;
use bytes::Bytes;
use std::time::Duration;

/// Which blob of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ArtifactKind {
    /// The source as uploaded.
    Source,
    /// The target as uploaded.
    Target,
    /// The result document without its correspondences, JSON.
    Result,
    /// The correspondences in columns, JSON.
    Correspondences,
    /// The source surface whose vertices are counted.
    SourceSurface,
    /// The target surface whose vertices are counted.
    TargetSurface,
    /// The source surface moved onto the target.
    Aligned,
}

impl ArtifactKind {
    /// The name in the database.
    pub fn name(self) -> &'static str {
        match self {
            ArtifactKind::Source => "source",
            ArtifactKind::Target => "target",
            ArtifactKind::Result => "result",
            ArtifactKind::Correspondences => "correspondences",
            ArtifactKind::SourceSurface => "source_surface",
            ArtifactKind::TargetSurface => "target_surface",
            ArtifactKind::Aligned => "aligned",
        }
    }
}

/// The address of a blob within a tenant: a path whose last part is the hash of the content.
///
/// What was uploaded is named by its content alone, so that equal files are one blob. What a worker made is named by
/// its lease too: a worker that lost its lease cannot meet what its successor writes.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ArtifactKey {
    /// Owner; equal bytes of two tenants are two blobs.
    pub tenant: Tenant,
    path: String,
}

impl ArtifactKey {
    /// The address of an upload with this content.
    pub fn of(tenant: &Tenant, bytes: &[u8]) -> Self {
        let hash = blake3::hash(bytes).to_hex();
        let path = format!("{}/{}/{hash}", &hash[0..2], &hash[2..4]);
        ArtifactKey { tenant: tenant.clone(), path }
    }

    /// The address of an upload whose content has this hash; `None` if it is no hash.
    pub fn of_hash(tenant: &Tenant, hash: &str) -> Option<Self> {
        is_hash(hash).then(|| {
            let path = format!("{}/{}/{hash}", &hash[0..2], &hash[2..4]);
            ArtifactKey { tenant: tenant.clone(), path }
        })
    }

    /// The address of what a lease made.
    pub fn of_result(lease: &Lease, bytes: &[u8]) -> Self {
        let hash = blake3::hash(bytes).to_hex();
        ArtifactKey { tenant: lease.tenant.clone(), path: format!("results/{}/{}/{hash}", lease.job_id, lease.epoch) }
    }

    /// The address with this path; `None` if no address has it.
    pub fn from_path(tenant: &Tenant, path: &str) -> Option<Self> {
        let (folder, hash) = path.rsplit_once('/')?;
        let safe = folder.split('/').all(|part| {
            !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
        });
        (safe && is_hash(hash)).then(|| ArtifactKey { tenant: tenant.clone(), path: path.to_owned() })
    }

    /// The path under the tenant.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// 64 lower-case hexadecimal digits of BLAKE3 of the content.
    pub fn hash(&self) -> &str {
        self.path.rsplit_once('/').map_or("", |(_, hash)| hash)
    }
}

/// Whether a text is a hash as this program writes it: 64 lower-case hexadecimal digits.
pub(super) fn is_hash(text: &str) -> bool {
    text.len() == 64 && text.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f'))
}

/// A blob that a job refers to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ArtifactRef {
    /// Which.
    pub kind: ArtifactKind,
    /// Where.
    pub key: ArtifactKey,
    /// Its size.
    pub n_bytes: u64,
}

/// What waits and what runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Load {
    /// Jobs that wait.
    pub queued: u32,
    /// Jobs that run.
    pub running: u32,
    /// For how long the oldest of those that wait does so.
    pub oldest_queued: Duration,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// With a result, in these blobs.
    Succeeded(Vec<ArtifactRef>),
    /// Without.
    Failed(Failure),
    /// Because somebody asked.
    Cancelled,
}

/// Jobs, their queue, traces and references to blobs. All times are the database's.
///
/// What takes a [`Lease`] is fenced: it answers [`JobError::LeaseLost`] and changes nothing unless the job is running
/// under exactly this epoch.
#[async_trait]
pub trait JobStore: Send + Sync {
    /// Whether the store answers.
    async fn ping(&self) -> Result<(), JobError>;

    /// Stores a job as queued, or as succeeded where an equal one has a result and that may be used; on return it
    /// survives loss of power. `QueueFull` if `max_queued` jobs of the tenant wait already.
    async fn insert(&self, job: &NewJob, admission: &Admission) -> Result<Job, JobError>;

    /// Stores a batch with all its jobs, or nothing.
    async fn insert_batch(&self, batch: &NewBatch, jobs: &[NewJob], admission: &Admission) -> Result<Batch, JobError>;

    /// A batch with the number of its jobs in each state.
    async fn get_batch(&self, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError>;

    /// A part of the list of batches, the newest first.
    async fn list_batches(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<BatchPage, JobError>;

    /// Begins what may be done once for an idempotency key.
    async fn begin_once(&self, once: &Once, busy_for: Duration) -> Result<OnceStatus, JobError>;

    /// Gives a key up after nothing was made for it.
    async fn give_up_once(&self, once: &Once) -> Result<(), JobError>;

    /// Jobs of a tenant that wait, counted up to `at_most`.
    async fn queue_length(&self, tenant: &Tenant, at_most: u32) -> Result<u32, JobError>;

    /// What waits and what runs, of all tenants.
    async fn load(&self) -> Result<Load, JobError>;

    /// A job with its progress and, while queued, its place.
    async fn get(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError>;

    /// A part of the list of jobs.
    async fn list(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError>;

    /// Cancels, or tells the worker to. `AlreadyFinal` for what ended otherwise.
    async fn cancel(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError>;

    /// Removes a finished job, its trace and its references. `StillActive` before.
    async fn delete(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError>;

    /// Points of the trace after `after_seq`, at most `limit`.
    async fn trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError>;

    /// The job's state and, if it has one of this kind, its blob. `Gone` if its result was removed.
    async fn artifact(
        &self,
        tenant: &Tenant,
        id: JobId,
        kind: ArtifactKind,
    ) -> Result<(super::JobState, Option<ArtifactRef>), JobError>;

    /// State changes of a tenant's jobs after number `since`, in the order of their commits.
    async fn changes(&self, tenant: &Tenant, since: u64, limit: u32) -> Result<ChangePage, JobError>;

    /// Protects blobs that are about to be written and referred to from [`JobStore::remove_unreferenced_blobs`].
    /// With a lease, fenced.
    async fn hold_blobs(
        &self,
        holder: &str,
        keys: &[ArtifactKey],
        for_at_most: Duration,
        fence: Option<&Lease>,
    ) -> Result<(), JobError>;

    /// Ends a hold; what nobody refers to is then removed.
    async fn drop_hold(&self, holder: &str) -> Result<(), JobError>;

    /// Removes from `artifacts` what deleted jobs and lapsed holds left and nobody refers to. Returns how many.
    async fn remove_unreferenced_blobs(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError>;

    /// The next job to run, leased: highest priority, then oldest. Drops what an earlier epoch traced. It may run for
    /// `max_run` unless its submitter allowed less.
    async fn claim(&self, worker: &WorkerId, lease: Duration, max_run: Duration)
    -> Result<Option<LeasedJob>, JobError>;

    /// The front of the queue: at most `limit` jobs in the order in which [`JobStore::claim`] takes them.
    async fn front_of_queue(&self, limit: u32) -> Result<Vec<WaitingJob>, JobError>;

    /// The first of `jobs` that still waits and that nobody else is about to take, leased as by [`JobStore::claim`].
    async fn claim_one_of(
        &self,
        jobs: &[JobId],
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError>;

    /// Prolongs a lease.
    async fn heartbeat(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError>;

    /// Looks at a lease without prolonging it; cheap enough for many times a second.
    async fn lease_status(&self, lease: &Lease) -> Result<LeaseStatus, JobError>;

    /// Adds to the trace and sets the progress. Fenced.
    async fn append_trace(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError>;

    /// Ends a job, exactly once; its result is kept for `keep`, or for ever. Fenced. Ends the hold of
    /// [`Lease::holder`].
    ///
    /// A success that comes after a request to cancel is still a success: the request came too late.
    async fn finish(&self, lease: &Lease, outcome: &Outcome, keep: Option<Duration>) -> Result<(), JobError>;

    /// Gives a job back without counting an attempt. Fenced.
    async fn release(&self, lease: &Lease) -> Result<(), JobError>;

    /// Takes jobs from workers whose leases ran out.
    async fn recover_expired(&self) -> Result<Recovered, JobError>;

    /// Takes jobs from a worker known to be gone.
    async fn recover_worker(&self, worker: &WorkerId) -> Result<Recovered, JobError>;

    /// Ends queued jobs whose deadline passed, and running ones that outlived their run time by `patience`: their
    /// worker should have ended them.
    async fn end_overdue(&self, patience: Duration) -> Result<Overdue, JobError>;

    /// Removes what outlived its retention, at most `limit` jobs at once; or, as a dry run, only counts it.
    async fn purge(&self, retention: &Retention, limit: u32, dry_run: bool) -> Result<Purged, JobError>;

    /// Notifies `wake` of jobs that other processes queued, for ever; only a hint, and some stores give none.
    async fn follow_hints(&self, wake: &tokio::sync::Notify);

    /// Tells other processes that a job was queued; only a hint.
    async fn give_hint(&self);
}

/// Blobs by content.
#[async_trait]
pub trait ArtifactStore: Send + Sync {
    /// Whether the store takes and gives.
    async fn ping(&self) -> Result<(), JobError>;

    /// Stores `bytes` under `key`, which must be their address; on return they survive loss of power.
    async fn put(&self, key: &ArtifactKey, bytes: Bytes) -> Result<(), JobError>;

    /// Begins to store a blob whose content comes in parts and whose address is not known yet.
    async fn begin(&self, tenant: &Tenant) -> Result<Box<dyn ArtifactWriter>, JobError>;

    /// The bytes under `key`.
    async fn get(&self, key: &ArtifactKey) -> Result<Bytes, JobError>;

    /// Removes what is under `key`; nothing there is no error.
    async fn remove(&self, key: &ArtifactKey) -> Result<(), JobError>;

    /// Removes what interrupted writes left. Returns how many.
    async fn sweep(&self) -> Result<u32, JobError>;
}

/// A blob that is being stored in parts. Dropped without [`ArtifactWriter::commit`], it leaves nothing.
#[async_trait]
pub trait ArtifactWriter: Send {
    /// Adds a part.
    async fn write(&mut self, part: Bytes) -> Result<(), JobError>;

    /// Gives what was written its name, which must be its address; on return it survives loss of power.
    async fn commit(self: Box<Self>, key: &ArtifactKey) -> Result<(), JobError>;
}

/// Whether processes that share this one's data live, where the system can tell.
pub trait Processes: Send + Sync {
    /// The processes that are gone and not forgotten yet.
    ///
    /// # Errors
    /// Of the system.
    fn departed(&self) -> std::io::Result<Vec<Box<dyn DepartedProcess>>>;
}

/// A process that is gone.
pub trait DepartedProcess: Send {
    /// Who it was.
    fn worker(&self) -> &WorkerId;

    /// Forgets it, once its jobs are taken care of.
    fn forget(self: Box<Self>);
}
