//! The ports to what stores: jobs with their queue, and blobs.

use super::error::JobError;
use super::job::{Failure, Job, JobFilter, JobId, JobPage, NewJob, PageRequest, Tenant};
use super::lease::{Lease, LeaseStatus, LeasedJob, Recovered, WorkerId};
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

/// The address of a blob: its content, within a tenant.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ArtifactKey {
    /// Owner; equal bytes of two tenants are two blobs.
    pub tenant: Tenant,
    /// 64 lower-case hexadecimal digits of BLAKE3.
    pub hash: String,
}

impl ArtifactKey {
    /// The address of `bytes`.
    pub fn of(tenant: &Tenant, bytes: &[u8]) -> Self {
        ArtifactKey { tenant: tenant.clone(), hash: blake3::hash(bytes).to_hex().to_string() }
    }
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

    /// Stores a job as queued; on return it survives loss of power. `QueueFull` if `max_queued` jobs wait already.
    /// The blobs of its inputs must be held by `holder`; the hold ends with this call.
    async fn insert(&self, job: &NewJob, max_queued: u32, holder: &str) -> Result<Job, JobError>;

    /// Jobs that wait, of all tenants.
    async fn queue_length(&self) -> Result<u32, JobError>;

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

    /// The job's state and, if it has one of this kind, its blob.
    async fn artifact(
        &self,
        tenant: &Tenant,
        id: JobId,
        kind: ArtifactKind,
    ) -> Result<(super::JobState, Option<ArtifactRef>), JobError>;

    /// Protects blobs that are about to be written and referred to from [`JobStore::remove_unreferenced_blobs`].
    async fn hold_blobs(&self, holder: &str, keys: &[ArtifactKey], for_at_most: Duration) -> Result<(), JobError>;

    /// Ends a hold; what nobody refers to is then removed.
    async fn drop_hold(&self, holder: &str) -> Result<(), JobError>;

    /// Removes from `artifacts` what deleted jobs and lapsed holds left and nobody refers to. Returns how many.
    async fn remove_unreferenced_blobs(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError>;

    /// The next job to run, leased: highest priority, then oldest. Drops what an earlier epoch traced.
    async fn claim(&self, worker: &WorkerId, lease: Duration) -> Result<Option<LeasedJob>, JobError>;

    /// Prolongs a lease.
    async fn heartbeat(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError>;

    /// Looks at a lease without prolonging it; cheap enough for many times a second.
    async fn lease_status(&self, lease: &Lease) -> Result<LeaseStatus, JobError>;

    /// Adds to the trace and sets the progress. Fenced.
    async fn append_trace(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError>;

    /// Ends a job, exactly once. Fenced. Ends the hold of [`Lease::holder`].
    ///
    /// A success that comes after a request to cancel is still a success: the request came too late.
    async fn finish(&self, lease: &Lease, outcome: &Outcome) -> Result<(), JobError>;

    /// Gives a job back without counting an attempt. Fenced.
    async fn release(&self, lease: &Lease) -> Result<(), JobError>;

    /// Takes jobs from workers whose leases ran out.
    async fn recover_expired(&self) -> Result<Recovered, JobError>;

    /// Takes jobs from a worker known to be gone.
    async fn recover_worker(&self, worker: &WorkerId) -> Result<Recovered, JobError>;
}

/// Blobs by content.
#[async_trait]
pub trait ArtifactStore: Send + Sync {
    /// Whether the store takes and gives.
    async fn ping(&self) -> Result<(), JobError>;

    /// Stores `bytes` under `key`, which must be their address; on return they survive loss of power.
    async fn put(&self, key: &ArtifactKey, bytes: Bytes) -> Result<(), JobError>;

    /// The bytes under `key`.
    async fn get(&self, key: &ArtifactKey) -> Result<Bytes, JobError>;

    /// Removes what is under `key`; nothing there is no error.
    async fn remove(&self, key: &ArtifactKey) -> Result<(), JobError>;

    /// Removes what interrupted writes left. Returns how many.
    async fn sweep(&self) -> Result<u32, JobError>;
}
