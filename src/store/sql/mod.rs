//! Jobs, their queue and all records beside them, in SQLite or PostgreSQL.
//!
//! There is one implementation: queries stand once in `queries/`, a file a query, and [`dialect`] fills in what the two
//! databases say differently; [`database`] hides whose connection it is. What one cannot rely on in PostgreSQL (that
//! write transactions follow one another) the code does not rely on in SQLite either: rows are locked before they are
//! decided on.
//!
//! The folder's code: [`reading`] (jobs, lists, traces), [`writing`] (submission, cancel, delete), [`leasing`] (claim to
//! finish), [`blobs`] (references), [`batches`], [`once`] (idempotency keys), [`changes`] (the feed), [`retention`],
//! [`meshes`], [`keys`], [`webhooks`], [`rows`] (what a row means).

mod batches;
mod blobs;
mod changes;
mod database;
mod dialect;
mod keys;
mod leasing;
mod meshes;
mod once;
mod reading;
mod retention;
mod rows;
mod webhooks;
mod writing;

pub use database::DatabaseLocation;

use crate::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, ArtifactStore, Batch, BatchId, BatchPage, ChangePage, Job,
    JobError, JobFilter, JobId, JobPage, JobState, JobStore, Lease, LeaseStatus, LeasedJob, Load, NewBatch, NewJob,
    Once, OnceStatus, Outcome, Overdue, PageRequest, Purged, Recovered, Retention, Tenant, TraceChunk, TracePage,
    WaitingJob, WorkerId, job::Cursor,
};
use async_trait::async_trait;
use database::{Database, bind};
use dialect::sql;
use std::time::Duration;

/// Jobs in a database.
#[derive(Debug, Clone)]
pub struct SqlStore {
    database: Database,
}

impl SqlStore {
    /// Connects to the database, makes it if it is a file that is not there, and brings its tables up to date.
    ///
    /// # Errors
    /// [`JobError::Unavailable`]; also if a newer version of this program has changed the tables already.
    pub async fn open(location: &DatabaseLocation) -> Result<Self, JobError> {
        Ok(SqlStore { database: Database::open(location).await? })
    }

    /// Ends all connections.
    pub async fn close(&self) {
        self.database.close().await;
    }

    /// `synchronous` and `journal_mode` as SQLite's writing connection has them; `fsync` and `synchronous_commit` of
    /// PostgreSQL.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn durability(&self) -> Result<(String, String), JobError> {
        let mut session = self.database.begin().await?;
        let texts = match self.database.dialect() {
            dialect::Dialect::Sqlite => ["PRAGMA synchronous", "PRAGMA journal_mode"],
            dialect::Dialect::Postgres => ["SHOW fsync", "SHOW synchronous_commit"],
        };
        let mut values = Vec::new();
        for text in texts {
            let rows = session.fetch(text.to_owned(), Vec::new()).await?;
            let row = rows.first().ok_or(JobError::Corrupt { what: "a setting", source: None })?;
            values.push(row.get::<String>(0).or_else(|_| row.get::<i64>(0).map(|n| n.to_string()))?);
        }
        let second = values.pop().unwrap_or_default();
        session.end(Ok((values.pop().unwrap_or_default(), second))).await
    }
}

#[async_trait]
impl JobStore for SqlStore {
    async fn ping(&self) -> Result<(), JobError> {
        self.database.reading().await?.execute(sql!("ping"), bind![]).await.map(|_| ())
    }

    async fn insert(&self, job: &NewJob, admission: &Admission) -> Result<Job, JobError> {
        self.insert_one(job, admission).await
    }

    async fn insert_batch(&self, batch: &NewBatch, jobs: &[NewJob], admission: &Admission) -> Result<Batch, JobError> {
        self.insert_many(batch, jobs, admission).await
    }

    async fn get_batch(&self, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError> {
        self.read_batch(tenant, id).await
    }

    async fn list_batches(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<BatchPage, JobError> {
        self.read_batches(tenant, size, after).await
    }

    async fn begin_once(&self, once: &Once, busy_for: Duration) -> Result<OnceStatus, JobError> {
        self.take_once(once, busy_for).await
    }

    async fn give_up_once(&self, once: &Once) -> Result<(), JobError> {
        self.drop_once(once).await
    }

    async fn queue_length(&self, tenant: &Tenant, at_most: u32) -> Result<u32, JobError> {
        self.count_queue(tenant, at_most).await
    }

    async fn load(&self) -> Result<Load, JobError> {
        self.read_load().await
    }

    async fn get(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.get_job(tenant, id).await
    }

    async fn list(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError> {
        self.list_jobs(tenant, filter, page).await
    }

    async fn cancel(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.cancel_job(tenant, id).await
    }

    async fn delete(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        self.delete_job(tenant, id).await
    }

    async fn trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError> {
        self.read_trace(tenant, id, after_seq, limit).await
    }

    async fn artifact(
        &self,
        tenant: &Tenant,
        id: JobId,
        kind: ArtifactKind,
    ) -> Result<(JobState, Option<ArtifactRef>), JobError> {
        self.get_artifact(tenant, id, kind).await
    }

    async fn changes(&self, tenant: &Tenant, since: u64, limit: u32) -> Result<ChangePage, JobError> {
        self.read_changes(tenant, since, limit).await
    }

    async fn hold_blobs(
        &self,
        holder: &str,
        keys: &[ArtifactKey],
        for_at_most: Duration,
        fence: Option<&Lease>,
    ) -> Result<(), JobError> {
        self.hold(holder, keys, for_at_most, fence).await
    }

    async fn drop_hold(&self, holder: &str) -> Result<(), JobError> {
        self.end_hold(holder).await
    }

    async fn remove_unreferenced_blobs(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError> {
        self.remove_unreferenced(artifacts).await
    }

    async fn claim(
        &self,
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        self.claim_next(worker, lease, max_run).await
    }

    async fn front_of_queue(&self, limit: u32) -> Result<Vec<WaitingJob>, JobError> {
        self.read_front(limit).await
    }

    async fn claim_one_of(
        &self,
        jobs: &[JobId],
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        self.claim_first_of(jobs, worker, lease, max_run).await
    }

    async fn heartbeat(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError> {
        self.prolong(lease, duration).await
    }

    async fn lease_status(&self, lease: &Lease) -> Result<LeaseStatus, JobError> {
        self.look_at(lease).await
    }

    async fn append_trace(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError> {
        self.append(lease, chunk).await
    }

    async fn finish(&self, lease: &Lease, outcome: &Outcome, keep: Option<Duration>) -> Result<(), JobError> {
        self.finish_job(lease, outcome, keep).await
    }

    async fn release(&self, lease: &Lease) -> Result<(), JobError> {
        self.release_job(lease).await
    }

    async fn recover_expired(&self) -> Result<Recovered, JobError> {
        self.recover_expired_leases().await
    }

    async fn recover_worker(&self, worker: &WorkerId) -> Result<Recovered, JobError> {
        self.recover_leases_of(worker).await
    }

    async fn end_overdue(&self, patience: Duration) -> Result<Overdue, JobError> {
        self.end_overdue_jobs(patience).await
    }

    async fn purge(&self, retention: &Retention, limit: u32, dry_run: bool) -> Result<Purged, JobError> {
        if dry_run { self.count_purge(retention).await } else { self.do_purge(retention, limit).await }
    }

    async fn follow_hints(&self, wake: &tokio::sync::Notify) {
        self.database.follow_hints(wake).await;
    }

    async fn give_hint(&self) {
        self.database.give_hint().await;
    }
}
