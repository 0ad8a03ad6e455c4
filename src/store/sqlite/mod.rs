//! Jobs and their queue in one SQLite database.
//!
//! One connection writes, some read. Every write transaction begins with `BEGIN IMMEDIATE`: one that began as a
//! reader and became a writer would be refused at once when another process writes. `synchronous=FULL` makes every
//! commit durable; write-ahead logging lets readers go on meanwhile.
//!
//! Queries stand in `queries/`, a file a query; the folder's code: [`reading`], [`writing`] (submission, cancel,
//! delete), [`leasing`] (claim to finish), [`blobs`] (references), [`rows`] (what a row means).

mod blobs;
mod leasing;
mod reading;
mod rows;
mod writing;

use crate::jobs::{
    ArtifactKey, ArtifactKind, ArtifactRef, ArtifactStore, Job, JobError, JobFilter, JobId, JobPage, JobState,
    JobStore, Lease, LeaseStatus, LeasedJob, NewJob, Outcome, PageRequest, Recovered, Tenant, TraceChunk, TracePage,
    WorkerId,
};
use async_trait::async_trait;
use sqlx::migrate::MigrateError;
use sqlx::sqlite::{SqliteConnectOptions, SqliteJournalMode, SqlitePool, SqlitePoolOptions, SqliteSynchronous};
use sqlx::{Sqlite, Transaction};
use std::path::Path;
use std::time::Duration;

/// The text of a query in `queries/`.
macro_rules! query_text {
    ($name:literal) => {
        include_str!(concat!("queries/", $name, ".sql"))
    };
}
pub(crate) use query_text;

static MIGRATIONS: sqlx::migrate::Migrator = sqlx::migrate!("src/store/sqlite/migrations");

/// Longest wait for another process's write, and for a free connection.
const PATIENCE: Duration = Duration::from_secs(10);
/// Readers; each is a thread, and reads here are short.
const READERS: u32 = 4;

/// Jobs in SQLite.
#[derive(Debug, Clone)]
pub struct SqliteStore {
    writer: SqlitePool,
    readers: SqlitePool,
}

impl SqliteStore {
    /// Opens `homolog.sqlite` in `data_dir`, makes it if it is not there, and brings its tables up to date.
    ///
    /// # Errors
    /// [`JobError::Unavailable`]; also if a newer version of this program has changed the tables already.
    pub async fn open(data_dir: &Path) -> Result<Self, JobError> {
        let options = SqliteConnectOptions::new()
            .filename(data_dir.join("homolog.sqlite"))
            .create_if_missing(true)
            .journal_mode(SqliteJournalMode::Wal)
            .synchronous(SqliteSynchronous::Full)
            .foreign_keys(true)
            .busy_timeout(PATIENCE);
        // Processes that start together take turns: SQLite itself has no lock that spans all migrations.
        let turn = MigrationTurn::wait(data_dir.to_owned()).await?;
        let writer = SqlitePoolOptions::new()
            .max_connections(1)
            .acquire_timeout(PATIENCE)
            .connect_with(options.clone())
            .await
            .map_err(domain_error)?;
        MIGRATIONS.run(&writer).await.map_err(migration_error)?;
        drop(turn);
        let readers = SqlitePoolOptions::new()
            .max_connections(READERS)
            .acquire_timeout(PATIENCE)
            .connect_with(options.pragma("query_only", "ON"))
            .await
            .map_err(domain_error)?;
        Ok(SqliteStore { writer, readers })
    }

    /// Ends all connections, the write-ahead log written back.
    pub async fn close(&self) {
        self.readers.close().await;
        self.writer.close().await;
    }

    /// `synchronous` and `journal_mode` as the writing connection has them.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn durability(&self) -> Result<(i64, String), JobError> {
        let synchronous = sqlx::query_scalar("PRAGMA synchronous").fetch_one(&self.writer).await;
        let journal = sqlx::query_scalar("PRAGMA journal_mode").fetch_one(&self.writer).await;
        Ok((synchronous.map_err(domain_error)?, journal.map_err(domain_error)?))
    }

    async fn begin(&self) -> Result<Transaction<'static, Sqlite>, JobError> {
        self.writer.begin_with("BEGIN IMMEDIATE").await.map_err(domain_error)
    }
}

/// The right to run migrations, an exclusive lock on a file.
struct MigrationTurn {
    _lock: std::fs::File,
}

impl MigrationTurn {
    async fn wait(data_dir: std::path::PathBuf) -> Result<Self, JobError> {
        let locked = tokio::task::spawn_blocking(move || {
            let path = data_dir.join("migration.lock");
            let lock = std::fs::File::options().create(true).truncate(false).write(true).open(path)?;
            lock.lock()?;
            Ok(MigrationTurn { _lock: lock })
        });
        match locked.await {
            Ok(turn) => turn.map_err(|e: std::io::Error| JobError::Unavailable(Box::new(e))),
            Err(join) => Err(JobError::Unavailable(Box::new(join))),
        }
    }
}

fn migration_error(error: MigrateError) -> JobError {
    JobError::Unavailable(Box::new(error))
}

/// What a failure of the driver means to jobs.
fn domain_error(error: sqlx::Error) -> JobError {
    // SQLITE_FULL, with or without an extended code in the higher bits.
    const FULL: i64 = 13;
    let code = error.as_database_error().and_then(|e| e.code()).and_then(|c| c.parse::<i64>().ok());
    match code {
        Some(code) if code & 0xff == FULL => JobError::StorageFull,
        _ => JobError::Unavailable(Box::new(error)),
    }
}

#[async_trait]
impl JobStore for SqliteStore {
    async fn ping(&self) -> Result<(), JobError> {
        sqlx::query(query_text!("ping")).execute(&self.readers).await.map(|_| ()).map_err(domain_error)
    }

    async fn insert(&self, job: &NewJob, max_queued: u32, holder: &str) -> Result<Job, JobError> {
        self.insert_job(job, max_queued, holder).await
    }

    async fn queue_length(&self) -> Result<u32, JobError> {
        sqlx::query_scalar(query_text!("queue_length")).fetch_one(&self.readers).await.map_err(domain_error)
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

    async fn hold_blobs(&self, holder: &str, keys: &[ArtifactKey], for_at_most: Duration) -> Result<(), JobError> {
        self.hold(holder, keys, for_at_most).await
    }

    async fn drop_hold(&self, holder: &str) -> Result<(), JobError> {
        self.end_hold(holder).await
    }

    async fn remove_unreferenced_blobs(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError> {
        self.remove_unreferenced(artifacts).await
    }

    async fn claim(&self, worker: &WorkerId, lease: Duration) -> Result<Option<LeasedJob>, JobError> {
        self.claim_next(worker, lease).await
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

    async fn finish(&self, lease: &Lease, outcome: &Outcome) -> Result<(), JobError> {
        self.finish_job(lease, outcome).await
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
}
