//! The queue: from the claim of a job to its end, fenced by the lease's epoch.

use super::database::{Session, bind};
use super::dialect::{Dialect, sql};
use super::writing::{end_job, insert_artifact};
use super::{SqlStore, blobs, rows};
use crate::jobs::{
    JobError, JobId, JobQueue, JobState, Lease, LeaseStatus, LeasedJob, Outcome, TraceChunk, WaitingJob, WorkerId,
    state_after_release,
};
use async_trait::async_trait;
use std::time::Duration;

/// The fence: returns [`JobError::LeaseLost`] unless the job is running under exactly this epoch; its row stays locked
/// until the transaction ends. Returns whether its cancellation was requested.
pub(super) async fn lock_lease(session: &mut Session, lease: &Lease) -> Result<bool, JobError> {
    let held: Option<bool> = session.value(sql!("lock_lease"), bind![lease.job_id, lease.epoch]).await?;
    held.ok_or(JobError::LeaseLost)
}

fn status(cancel_requested: Option<bool>) -> LeaseStatus {
    match cancel_requested {
        None => LeaseStatus::Lost,
        Some(true) => LeaseStatus::CancelRequested,
        Some(false) => LeaseStatus::Held,
    }
}

/// The next job to run. On PostgreSQL its row is locked, and rows that other transactions have locked are skipped.
async fn next_queued(session: &mut Session) -> Result<Option<String>, JobError> {
    session.value(sql!("next_queued"), bind![]).await
}

/// Locks a job if it is still queued and no other transaction has locked it.
async fn lock_queued(session: &mut Session, id: JobId) -> Result<Option<String>, JobError> {
    session.value(sql!("lock_queued"), bind![id]).await
}

/// Leases a queued job whose row is locked.
async fn claim_job(
    session: &mut Session,
    id: &str,
    worker: &WorkerId,
    lease: Duration,
    max_run: Duration,
) -> Result<LeasedJob, JobError> {
    let epoch: Option<i64> = session.value(sql!("claim_job"), bind![id, worker.name(), lease, max_run]).await?;
    if epoch != Some(1) {
        // A rerun computes the same trace from its first point: the points of earlier epochs would be duplicates.
        for query in [sql!("clear_trace"), sql!("clear_progress")] {
            session.execute(query, bind![id]).await?;
        }
    }
    let row = session.row(sql!("get_leased_job"), bind![id]).await?.ok_or(JobError::NotFound)?;
    let job = rows::job(&row)?;
    let lease = Lease { job_id: job.id, tenant: job.tenant.clone(), epoch: job.lease_epoch, worker: worker.clone() };
    Ok(LeasedJob { lease, job })
}

#[async_trait]
impl JobQueue for SqlStore {
    async fn claim_next(
        &self,
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        // On SQLite the queue is read without a lock first, so that idle workers do not take the only write lock several
        // times a second.
        if self.database.dialect() == Dialect::Sqlite
            && next_queued(&mut self.database.reader().await?).await?.is_none()
        {
            return Ok(None);
        }
        self.database
            .transaction(async |session| {
                let Some(id) = next_queued(session).await? else { return Ok(None) };
                claim_job(session, &id, worker, lease, max_run).await.map(Some)
            })
            .await
    }

    async fn front_of_queue(&self, limit: u32) -> Result<Vec<WaitingJob>, JobError> {
        let rows = self.database.reader().await?.rows(sql!("front_of_queue"), bind![limit]).await?;
        rows.iter().map(rows::waiting_job).collect()
    }

    async fn claim_one_of(
        &self,
        jobs: &[JobId],
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        self.database
            .transaction(async |session| {
                for &job in jobs {
                    if let Some(id) = lock_queued(session, job).await? {
                        return claim_job(session, &id, worker, lease, max_run).await.map(Some);
                    }
                }
                Ok(None)
            })
            .await
    }

    async fn heartbeat(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError> {
        let arguments = bind![lease.job_id, lease.epoch, duration];
        let answer = self.database.transaction(async |session| session.value(sql!("heartbeat"), arguments).await);
        answer.await.map(status)
    }

    async fn lease_status(&self, lease: &Lease) -> Result<LeaseStatus, JobError> {
        let mut session = self.database.reader().await?;
        Ok(status(session.value(sql!("lease_status"), bind![lease.job_id, lease.epoch]).await?))
    }

    async fn append_trace(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError> {
        let id = lease.job_id;
        self.database
            .transaction(async |session| {
                lock_lease(session, lease).await?;
                let last: Option<i64> = session.value(sql!("last_seq"), bind![id]).await?;
                let last = last.unwrap_or(0).unsigned_abs();
                let points: Vec<_> = chunk.points.iter().filter(|p| p.seq > last).collect();
                if let (Some(first), Some(last)) = (points.first(), points.last()) {
                    let text = rows::to_json("a trace chunk", &points)?;
                    let arguments = bind![id, first.seq, last.seq, lease.epoch, text];
                    session.execute(sql!("append_trace_chunk"), arguments).await?;
                }
                let progress = &chunk.progress;
                let arguments = bind![
                    id,
                    progress.fraction,
                    progress.phase.map(|p| p.name()),
                    progress.iteration,
                    &progress.message,
                    progress.energy_latest,
                ];
                session.execute(sql!("set_progress"), arguments).await.map(|_| ())
            })
            .await
    }

    async fn finish_job(&self, lease: &Lease, outcome: &Outcome, keep: Option<Duration>) -> Result<(), JobError> {
        let id = lease.job_id;
        self.database
            .transaction(async |session| {
                lock_lease(session, lease).await?;
                match outcome {
                    Outcome::Succeeded(artifacts) => {
                        for artifact in artifacts {
                            insert_artifact(session, id, artifact).await?;
                        }
                        end_job(session, id, JobState::Succeeded, None, keep).await?;
                    }
                    Outcome::Failed(failure) => {
                        end_job(session, id, JobState::Failed, Some(failure), None).await?;
                    }
                    Outcome::Cancelled => {
                        end_job(session, id, JobState::Cancelled, None, None).await?;
                    }
                }
                blobs::drop_hold(session, &lease.holder()).await
            })
            .await
    }

    async fn release_job(&self, lease: &Lease) -> Result<(), JobError> {
        self.database
            .transaction(async |session| {
                let cancel_requested = lock_lease(session, lease).await?;
                match state_after_release(cancel_requested) {
                    JobState::Queued => {
                        session.execute(sql!("release_job"), bind![lease.job_id]).await?;
                    }
                    ended => {
                        end_job(session, lease.job_id, ended, None, None).await?;
                    }
                }
                blobs::drop_hold(session, &lease.holder()).await
            })
            .await
    }

    async fn follow_queued(&self, wake: &tokio::sync::Notify) {
        self.database.follow_queued(wake).await;
    }

    async fn announce_queued(&self) {
        self.database.announce_queued().await;
    }
}
