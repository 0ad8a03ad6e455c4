//! From claim to finish: what workers do, fenced by the epoch.

use super::rows::{self, JobRow};
use super::writing::{end_job, refer};
use super::{SqliteStore, blobs, domain_error, query_text};
use crate::jobs::{
    Failure, JobError, JobState, Lease, LeaseStatus, LeasedJob, Outcome, Recovered, TraceChunk, WorkerId,
    state_after_crash, state_after_release,
};
use sqlx::SqliteConnection;
use std::time::Duration;

/// A running job whose worker is gone: id, crashes so far, limit, whether its end was asked for.
type Orphan = (String, u32, u32, bool);

/// The fence: whether the job runs under exactly this epoch, and whether its end was asked for.
async fn fence(connection: &mut SqliteConnection, lease: &Lease) -> Result<bool, JobError> {
    let held: Option<bool> = sqlx::query_scalar(query_text!("lease_status"))
        .bind(lease.job_id.to_string())
        .bind(epoch(lease))
        .fetch_optional(connection)
        .await
        .map_err(domain_error)?;
    held.ok_or(JobError::LeaseLost)
}

fn epoch(lease: &Lease) -> i64 {
    i64::try_from(lease.epoch).unwrap_or(i64::MAX)
}

fn status(cancel_requested: Option<bool>) -> LeaseStatus {
    match cancel_requested {
        None => LeaseStatus::Lost,
        Some(true) => LeaseStatus::CancelRequested,
        Some(false) => LeaseStatus::Held,
    }
}

impl SqliteStore {
    pub(super) async fn claim_next(
        &self,
        worker: &WorkerId,
        duration: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        // Asked without a lock first, so that idle workers do not take the write lock several times a second.
        let waiting: Option<String> =
            sqlx::query_scalar(query_text!("next_queued")).fetch_optional(&self.readers).await.map_err(domain_error)?;
        if waiting.is_none() {
            return Ok(None);
        }
        let mut writing = self.begin().await?;
        let id: Option<String> =
            sqlx::query_scalar(query_text!("next_queued")).fetch_optional(&mut *writing).await.map_err(domain_error)?;
        let Some(id) = id else { return Ok(None) };
        sqlx::query(query_text!("claim_job"))
            .bind(&id)
            .bind(worker.name())
            .bind(rows::milliseconds(duration))
            .execute(&mut *writing)
            .await
            .map_err(domain_error)?;
        // A rerun makes the same points again from the first: those of earlier epochs would be doubles.
        for text in [query_text!("clear_trace"), query_text!("clear_progress")] {
            sqlx::query(text).bind(&id).execute(&mut *writing).await.map_err(domain_error)?;
        }
        let row: JobRow = sqlx::query_as(query_text!("get_leased_job"))
            .bind(&id)
            .fetch_one(&mut *writing)
            .await
            .map_err(domain_error)?;
        writing.commit().await.map_err(domain_error)?;
        let job = row.into_job()?;
        let lease =
            Lease { job_id: job.id, tenant: job.tenant.clone(), epoch: job.lease_epoch, worker: worker.clone() };
        Ok(Some(LeasedJob { lease, job }))
    }

    pub(super) async fn prolong(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError> {
        let mut writing = self.begin().await?;
        let answer: Option<bool> = sqlx::query_scalar(query_text!("heartbeat"))
            .bind(lease.job_id.to_string())
            .bind(epoch(lease))
            .bind(rows::milliseconds(duration))
            .fetch_optional(&mut *writing)
            .await
            .map_err(domain_error)?;
        writing.commit().await.map_err(domain_error)?;
        Ok(status(answer))
    }

    pub(super) async fn look_at(&self, lease: &Lease) -> Result<LeaseStatus, JobError> {
        let answer = sqlx::query_scalar(query_text!("lease_status"))
            .bind(lease.job_id.to_string())
            .bind(epoch(lease))
            .fetch_optional(&self.readers)
            .await
            .map_err(domain_error)?;
        Ok(status(answer))
    }

    pub(super) async fn append(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError> {
        let id = lease.job_id.to_string();
        let mut writing = self.begin().await?;
        fence(&mut writing, lease).await?;
        // A chunk whose first writing was answered with an error may be there all the same.
        let last: i64 = sqlx::query_scalar(query_text!("last_seq"))
            .bind(&id)
            .fetch_one(&mut *writing)
            .await
            .map_err(domain_error)?;
        let points: Vec<_> = chunk.points.iter().filter(|p| p.seq > last.unsigned_abs()).collect();
        if let (Some(first), Some(last)) = (points.first(), points.last()) {
            sqlx::query(query_text!("append_trace_chunk"))
                .bind(&id)
                .bind(i64::try_from(first.seq).unwrap_or(i64::MAX))
                .bind(i64::try_from(last.seq).unwrap_or(i64::MAX))
                .bind(epoch(lease))
                .bind(rows::to_json("a trace chunk", &points)?)
                .execute(&mut *writing)
                .await
                .map_err(domain_error)?;
        }
        let progress = &chunk.progress;
        sqlx::query(query_text!("set_progress"))
            .bind(&id)
            .bind(progress.fraction)
            .bind(progress.phase.map(|p| p.name()))
            .bind(progress.iteration)
            .bind(&progress.message)
            .bind(progress.energy_latest)
            .execute(&mut *writing)
            .await
            .map_err(domain_error)?;
        writing.commit().await.map_err(domain_error)
    }

    pub(super) async fn finish_job(&self, lease: &Lease, outcome: &Outcome) -> Result<(), JobError> {
        let mut writing = self.begin().await?;
        fence(&mut writing, lease).await?;
        let id = lease.job_id.to_string();
        match outcome {
            Outcome::Succeeded(artifacts) => {
                for artifact in artifacts {
                    refer(&mut writing, lease.job_id, artifact).await?;
                }
                end_job(&mut writing, &id, JobState::Succeeded, None).await?;
            }
            Outcome::Failed(failure) => {
                end_job(&mut writing, &id, JobState::Failed, Some(failure)).await?;
            }
            Outcome::Cancelled => {
                end_job(&mut writing, &id, JobState::Cancelled, None).await?;
            }
        }
        blobs::end_hold(&mut writing, &lease.holder()).await?;
        writing.commit().await.map_err(domain_error)
    }

    pub(super) async fn release_job(&self, lease: &Lease) -> Result<(), JobError> {
        let id = lease.job_id.to_string();
        let mut writing = self.begin().await?;
        let cancel_requested = fence(&mut writing, lease).await?;
        match state_after_release(cancel_requested) {
            JobState::Queued => {
                sqlx::query(query_text!("release_job")).bind(&id).execute(&mut *writing).await.map_err(domain_error)?;
            }
            ended => {
                end_job(&mut writing, &id, ended, None).await?;
            }
        }
        blobs::end_hold(&mut writing, &lease.holder()).await?;
        writing.commit().await.map_err(domain_error)
    }

    pub(super) async fn recover_expired_leases(&self) -> Result<Recovered, JobError> {
        let expired: Vec<Orphan> =
            sqlx::query_as(query_text!("expired_leases")).fetch_all(&self.readers).await.map_err(domain_error)?;
        if expired.is_empty() {
            return Ok(Recovered::default());
        }
        let mut writing = self.begin().await?;
        let orphans: Vec<Orphan> =
            sqlx::query_as(query_text!("expired_leases")).fetch_all(&mut *writing).await.map_err(domain_error)?;
        let recovered = recover(&mut writing, orphans).await?;
        writing.commit().await.map_err(domain_error)?;
        Ok(recovered)
    }

    pub(super) async fn recover_leases_of(&self, worker: &WorkerId) -> Result<Recovered, JobError> {
        let mut writing = self.begin().await?;
        let orphans: Vec<Orphan> = sqlx::query_as(query_text!("leases_of_worker"))
            .bind(worker.name())
            .fetch_all(&mut *writing)
            .await
            .map_err(domain_error)?;
        let recovered = recover(&mut writing, orphans).await?;
        writing.commit().await.map_err(domain_error)?;
        Ok(recovered)
    }
}

async fn recover(connection: &mut SqliteConnection, orphans: Vec<Orphan>) -> Result<Recovered, JobError> {
    let mut recovered = Recovered::default();
    for (id, crashes, max_attempts, cancel_requested) in orphans {
        sqlx::query(query_text!("count_crash")).bind(&id).execute(&mut *connection).await.map_err(domain_error)?;
        let crashes = crashes + 1;
        match state_after_crash(cancel_requested, crashes, max_attempts) {
            JobState::Queued => {
                sqlx::query(query_text!("requeue_job"))
                    .bind(&id)
                    .execute(&mut *connection)
                    .await
                    .map_err(domain_error)?;
                recovered.queued += 1;
            }
            JobState::Dead => {
                let detail = format!("{crashes} workers were lost while they ran this job");
                let failure = Failure::new("crash-limit-reached", detail);
                end_job(connection, &id, JobState::Dead, Some(&failure)).await?;
                recovered.dead += 1;
            }
            ended => {
                end_job(connection, &id, ended, None).await?;
                recovered.cancelled += 1;
            }
        }
    }
    Ok(recovered)
}
