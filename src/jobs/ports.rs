//! The ports to storage: jobs with their queue, blobs, and the processes that share them.

use super::admission::{Admission, IdempotencyKey, OnceStatus};
use super::artifact::{ArtifactKey, ArtifactKind, ArtifactRef};
use super::batch::{Batch, BatchPage, NewBatch};
use super::change::ChangePage;
use super::demand::WaitingJob;
use super::documents::Verdict;
use super::error::JobError;
use super::ids::{BatchId, JobId};
use super::job::{Cursor, Failure, Job, JobFilter, JobPage, NewJob, PageRequest, Tenant};
use super::lease::{Lease, LeaseStatus, LeasedJob, Recovered, WorkerId};
use super::retention::{Overdue, Purged, Retentions};
use super::state::JobState;
use super::trace::{TraceChunk, TracePage};
use async_trait::async_trait;
use bytes::Bytes;
use futures_util::stream::BoxStream;
use std::ops::Range;
use std::time::Duration;

/// The content of a blob, in pieces.
pub type BlobStream = BoxStream<'static, Result<Bytes, JobError>>;

/// The numbers of queued and running jobs of all tenants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Load {
    /// Queued jobs.
    pub queued: u32,
    /// Running jobs.
    pub running: u32,
    /// For how long the oldest queued job has been waiting.
    pub oldest_queued: Duration,
    /// Processes with a running job.
    pub busy_workers: u32,
    /// Processes that would run jobs and have none.
    pub idle_workers: u32,
}

/// How a job ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// With a result.
    Succeeded {
        /// The blobs that it is in.
        artifacts: Vec<ArtifactRef>,
        /// Whether it can be relied on, if the engine says so.
        verdict: Option<Verdict>,
    },
    /// Without a result.
    Failed(Failure),
    /// Because a client cancelled it.
    Cancelled,
}

/// The store of jobs: all of its parts, over one database. All times are the database's.
///
/// Every write that takes a [`Lease`] is fenced: it returns [`JobError::LeaseLost`] and changes nothing unless the job is
/// running under exactly this epoch.
#[async_trait]
pub trait JobStore: JobReader + JobWriter + JobQueue + BlobHolds + Housekeeping {
    /// Whether the database answers.
    async fn ping(&self) -> Result<(), JobError>;
}

/// Jobs, batches, traces and the feed of state changes, as clients read them.
#[async_trait]
pub trait JobReader: Send + Sync {
    /// A job with its progress and, while it is queued, its position in the queue.
    async fn get_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError>;

    /// A page of the list of jobs.
    async fn list_jobs(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError>;

    /// A batch with the number of its jobs in each state.
    async fn get_batch(&self, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError>;

    /// A page of the list of batches, newest first.
    async fn list_batches(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<BatchPage, JobError>;

    /// State changes of a tenant's jobs after number `since`, in the order of their commits.
    async fn list_changes(&self, tenant: &Tenant, since: u64, limit: u32) -> Result<ChangePage, JobError>;

    /// The number of a tenant's last state change; 0 if there is none.
    async fn newest_change(&self, tenant: &Tenant) -> Result<u64, JobError>;

    /// At most `limit` points of a job's trace after `after_seq`.
    async fn get_trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError>;

    /// The job's state and the blob of this kind, if it has one. [`JobError::Gone`] if its result was removed.
    async fn get_artifact(
        &self,
        tenant: &Tenant,
        id: JobId,
        kind: ArtifactKind,
    ) -> Result<(JobState, Option<ArtifactRef>), JobError>;

    /// The number of a tenant's queued jobs, counted up to `at_most`.
    async fn queue_length(&self, tenant: &Tenant, at_most: u32) -> Result<u32, JobError>;

    /// The bytes of a tenant's uploads and results, each blob once; reads a row of each.
    async fn stored_bytes(&self, tenant: &Tenant) -> Result<u64, JobError>;

    /// The numbers of queued and running jobs of all tenants.
    async fn load(&self) -> Result<Load, JobError>;
}

/// Changes by clients: submissions, their idempotency keys, cancellation and deletion.
#[async_trait]
pub trait JobWriter: Send + Sync {
    /// Stores a job as queued, or as succeeded if it may share the result of an equal job and there is one. When this
    /// returns, the job survives a loss of power. [`JobError::QueueFull`] if the tenant's queue has no room.
    async fn insert_job(&self, job: &NewJob, admission: &Admission) -> Result<Job, JobError>;

    /// Stores a batch with all of its jobs, or nothing; otherwise as [`JobWriter::insert_job`].
    async fn insert_batch(&self, batch: &NewBatch, jobs: &[NewJob], admission: &Admission) -> Result<Batch, JobError>;

    /// Reserves an idempotency key for `busy_for`, unless a request has used it already.
    async fn begin_once(&self, once: &IdempotencyKey, busy_for: Duration) -> Result<OnceStatus, JobError>;

    /// Keeps an idempotency key reserved for `busy_for` from now.
    async fn extend_once(&self, once: &IdempotencyKey, busy_for: Duration) -> Result<(), JobError>;

    /// Frees an idempotency key for which nothing was made.
    async fn give_up_once(&self, once: &IdempotencyKey) -> Result<(), JobError>;

    /// Cancels a queued job, or asks the worker of a running one to stop. [`JobError::AlreadyFinal`] for a job that has
    /// ended otherwise.
    async fn cancel_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError>;

    /// Sets the priority of a job that has not ended. [`JobError::AlreadyFinal`] for one that has.
    async fn set_priority(&self, tenant: &Tenant, id: JobId, priority: i32) -> Result<Job, JobError>;

    /// Removes a finished job, its trace and its references to blobs. [`JobError::StillActive`] before it has finished.
    async fn delete_job(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError>;
}

/// The queue and the leases, as workers use them.
#[async_trait]
pub trait JobQueue: Send + Sync {
    /// Leases the next job to `worker` for `lease`: tenants take turns, and of a tenant the highest priority is first, then
    /// the oldest. Drops the trace of an earlier epoch. The job may run for `max_run` unless its submitter allowed less.
    async fn claim_next(
        &self,
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError>;

    /// The front of the queue: at most `limit` jobs in the order in which [`JobQueue::claim_next`] takes them.
    async fn front_of_queue(&self, limit: u32) -> Result<Vec<WaitingJob>, JobError>;

    /// Leases the first of `jobs` that is still queued and that no other process is claiming, as
    /// [`JobQueue::claim_next`] does.
    async fn claim_one_of(
        &self,
        jobs: &[JobId],
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError>;

    /// Extends a lease to `duration` from now.
    async fn heartbeat(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError>;

    /// The status of a lease, without extending it; cheap enough for many calls a second.
    async fn lease_status(&self, lease: &Lease) -> Result<LeaseStatus, JobError>;

    /// Appends to the trace and sets the progress. Fenced. Points that are stored already are skipped, so a chunk whose
    /// first write was answered with an error can be sent again.
    async fn append_trace(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError>;

    /// Ends a job, exactly once, and releases the hold of [`Lease::holder`]. Fenced. Its result is kept for `keep`, or
    /// for ever if `None`.
    ///
    /// A success that arrives after a request to cancel is still a success: the request came too late.
    async fn finish_job(&self, lease: &Lease, outcome: &Outcome, keep: Option<Duration>) -> Result<(), JobError>;

    /// Returns a job to the queue without counting an attempt. Fenced.
    async fn release_job(&self, lease: &Lease) -> Result<(), JobError>;

    /// Notes that `worker` runs jobs or waits for some; counted as idle for a minute from then.
    async fn note_worker(&self, worker: &WorkerId) -> Result<(), JobError>;

    /// Notes that `worker` runs no more jobs.
    async fn forget_worker(&self, worker: &WorkerId) -> Result<(), JobError>;

    /// Notifies `wake` of jobs that other processes queue, and never returns. Only a hint: a store may notify of none.
    async fn follow_queued(&self, wake: &tokio::sync::Notify);

    /// Announces to other processes that a job was queued. Only a hint.
    async fn announce_queued(&self);
}

/// Which blobs are in use: references of jobs and uploads, and holds of processes that are about to refer to them.
#[async_trait]
pub trait BlobHolds: Send + Sync {
    /// Protects blobs that are about to be written and referred to from [`BlobHolds::remove_unreferenced_blobs`], for
    /// `for_at_most`. Fenced if there is a lease.
    async fn hold_blobs(
        &self,
        holder: &str,
        keys: &[ArtifactKey],
        for_at_most: Duration,
        fence: Option<&Lease>,
    ) -> Result<(), JobError>;

    /// Releases a hold; blobs to which nothing refers can then be removed.
    async fn drop_hold(&self, holder: &str) -> Result<(), JobError>;

    /// Removes from `artifacts` the blobs that deleted jobs and lapsed holds left behind and to which nothing refers.
    /// Returns their number.
    async fn remove_unreferenced_blobs(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError>;
}

/// Whether the database's clock can be believed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClockState {
    /// It follows on the last time that was seen.
    Plausible,
    /// It was set by days.
    Jumped {
        /// How far it is ahead of the last time that was seen, ms; negative: behind.
        by_ms: i64,
    },
}

/// Work of every process from time to time.
#[async_trait]
pub trait Housekeeping: Send + Sync {
    /// Takes back the jobs whose leases expired.
    async fn recover_expired(&self) -> Result<Recovered, JobError>;

    /// Takes back the jobs of a worker that is known to have ended.
    async fn recover_worker(&self, worker: &WorkerId) -> Result<Recovered, JobError>;

    /// Ends queued jobs whose deadline has passed, and running jobs that have exceeded their run time by `tolerance`,
    /// because their worker should have ended them.
    async fn end_overdue(&self, tolerance: Duration) -> Result<Overdue, JobError>;

    /// Overwrites what deletions have left in the files of the database, if there were any since the last call. What cannot
    /// be overwritten now, because somebody reads it, stays for the next call. Returns whether nothing stays.
    async fn overwrite_deleted(&self) -> Result<bool, JobError>;

    /// Holds the database's clock against the last time that was seen. A plausible one is noted; another is not believed, by
    /// any process, until it is plausible again or somebody calls this with `trusted`.
    async fn check_clock(&self, trusted: bool) -> Result<ClockState, JobError>;

    /// Whether the database's clock was set since the last call of this process.
    async fn clock_was_set(&self) -> Result<bool, JobError>;

    /// Shortens every stored wait that is longer than it was when it was stored, or than any of its kind can be, because the
    /// database's clock was set back since: pauses of webhooks and of their deliveries, leases, run times, reservations, holds and
    /// tickets. Returns the number of those that were.
    async fn bound_waits(&self) -> Result<u64, JobError>;

    /// Whether the clock was not plausible when this process last looked at it.
    fn clock_has_jumped(&self) -> bool;

    /// Removes what has outlived the retention of its tenant, at most `limit` jobs of each retention at once; as a dry run it only counts.
    async fn purge(&self, retention: &Retentions, limit: u32, dry_run: bool) -> Result<Purged, JobError>;
}

/// Blobs, addressed by their content.
#[async_trait]
pub trait ArtifactStore: Send + Sync {
    /// Whether the store can be read and written.
    async fn ping(&self) -> Result<(), JobError>;

    /// Stores `bytes` under `key`, which must be their address; when this returns, they survive a loss of
    /// power.
    async fn put(&self, key: &ArtifactKey, bytes: Bytes) -> Result<(), JobError>;

    /// Begins to store a blob whose content arrives in parts and whose address is not known yet.
    async fn begin(&self, tenant: &Tenant) -> Result<Box<dyn ArtifactWriter>, JobError>;

    /// The bytes under `key`.
    async fn get(&self, key: &ArtifactKey) -> Result<Bytes, JobError>;

    /// The blob under `key`, which has `n_bytes`, or a range of it, in pieces that are read as they are taken. A blob that is
    /// read whole ends with an error instead of its last piece if its content has not its hash.
    async fn open(&self, key: &ArtifactKey, n_bytes: u64, range: Option<Range<u64>>) -> Result<BlobStream, JobError>;

    /// Removes the blob under `key`; not an error if there is none.
    async fn remove(&self, key: &ArtifactKey) -> Result<(), JobError>;

    /// Removes the remains of interrupted writes. Returns their number.
    async fn sweep(&self) -> Result<u32, JobError>;
}

/// A blob that is being stored in parts. If dropped without [`ArtifactWriter::commit`], nothing is stored.
#[async_trait]
pub trait ArtifactWriter: Send {
    /// Appends a part.
    async fn write(&mut self, part: Bytes) -> Result<(), JobError>;

    /// Stores what was written under `key`, which must be its address; when this returns, it survives a loss of power.
    async fn commit(self: Box<Self>, key: &ArtifactKey) -> Result<(), JobError>;
}

/// The processes that share this one's data, on systems that can tell whether they are alive.
pub trait Processes: Send + Sync {
    /// The processes that have ended and whose jobs have not been taken back yet.
    ///
    /// # Errors
    /// Those of the operating system.
    fn departed(&self) -> std::io::Result<Vec<Box<dyn DepartedProcess>>>;
}

/// A process that has ended.
pub trait DepartedProcess: Send {
    /// Its identity as a worker.
    fn worker(&self) -> &WorkerId;

    /// Removes its record, once its jobs have been taken back.
    fn remove_record(self: Box<Self>);
}
