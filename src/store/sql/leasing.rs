//! From claim to finish: what workers do, fenced by the epoch.

use super::database::{Row, Session, bind};
use super::dialect::{Dialect, sql};
use super::writing::{end_job, refer};
use super::{SqlStore, blobs, rows};
use crate::jobs::{
    Failure, JobError, JobId, JobState, Lease, LeaseStatus, LeasedJob, Outcome, Overdue, Recovered, TraceChunk,
    WaitingJob, WorkerId, state_after_crash, state_after_release,
};
use std::time::Duration;

/// The fence: whether the job runs under exactly this epoch, and whether its end was asked for. It stays so until the
/// transaction ends.
pub(super) async fn fence(session: &mut Session, lease: &Lease) -> Result<bool, JobError> {
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

/// Leases a waiting job whose row is locked.
async fn lease_to(
    session: &mut Session,
    id: &str,
    worker: &WorkerId,
    duration: Duration,
    max_run: Duration,
) -> Result<LeasedJob, JobError> {
    let arguments = bind![id, worker.name(), duration, max_run];
    let epoch: Option<i64> = session.value(sql!("claim_job"), arguments).await?;
    if epoch != Some(1) {
        // A rerun makes the same points again from the first: those of earlier epochs would be doubles.
        for query in [sql!("clear_trace"), sql!("clear_progress")] {
            session.execute(query, bind![id]).await?;
        }
    }
    let row = session.row(sql!("get_leased_job"), bind![id]).await?.ok_or(JobError::NotFound)?;
    let job = rows::job(&row)?;
    let lease = Lease { job_id: job.id, tenant: job.tenant.clone(), epoch: job.lease_epoch, worker: worker.clone() };
    Ok(LeasedJob { lease, job })
}

impl SqlStore {
    pub(super) async fn claim_next(
        &self,
        worker: &WorkerId,
        duration: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        // In SQLite asked without a lock first, so that idle workers do not take the one write lock several times a
        // second.
        if self.database.dialect() == Dialect::Sqlite
            && self.database.reading().await?.row(sql!("next_queued"), bind![]).await?.is_none()
        {
            return Ok(None);
        }
        let mut session = self.database.begin().await?;
        let done = async {
            let id: Option<String> = session.value(sql!("next_queued"), bind![]).await?;
            let Some(id) = id else { return Ok(None) };
            lease_to(&mut session, &id, worker, duration, max_run).await.map(Some)
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn claim_first_of(
        &self,
        jobs: &[JobId],
        worker: &WorkerId,
        duration: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            for job in jobs {
                let id: Option<String> = session.value(sql!("lock_waiting"), bind![*job]).await?;
                if let Some(id) = id {
                    return lease_to(&mut session, &id, worker, duration, max_run).await.map(Some);
                }
            }
            Ok(None)
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn read_front(&self, limit: u32) -> Result<Vec<WaitingJob>, JobError> {
        let rows = self.database.reading().await?.rows(sql!("front_of_queue"), bind![limit]).await?;
        rows.iter().map(rows::waiting_job).collect()
    }

    pub(super) async fn prolong(&self, lease: &Lease, duration: Duration) -> Result<LeaseStatus, JobError> {
        let mut session = self.database.begin().await?;
        let answer = session.value(sql!("heartbeat"), bind![lease.job_id, lease.epoch, duration]).await;
        session.end(answer).await.map(status)
    }

    pub(super) async fn look_at(&self, lease: &Lease) -> Result<LeaseStatus, JobError> {
        let mut session = self.database.reading().await?;
        Ok(status(session.value(sql!("lease_status"), bind![lease.job_id, lease.epoch]).await?))
    }

    pub(super) async fn append(&self, lease: &Lease, chunk: &TraceChunk) -> Result<(), JobError> {
        let id = lease.job_id;
        let mut session = self.database.begin().await?;
        let done = async {
            fence(&mut session, lease).await?;
            // A chunk whose first writing was answered with an error may be there all the same.
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
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn finish_job(
        &self,
        lease: &Lease,
        outcome: &Outcome,
        keep: Option<Duration>,
    ) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            fence(&mut session, lease).await?;
            let id = lease.job_id;
            match outcome {
                Outcome::Succeeded(artifacts) => {
                    for artifact in artifacts {
                        refer(&mut session, id, artifact).await?;
                    }
                    end_job(&mut session, id, JobState::Succeeded, None, keep).await?;
                }
                Outcome::Failed(failure) => {
                    end_job(&mut session, id, JobState::Failed, Some(failure), None).await?;
                }
                Outcome::Cancelled => {
                    end_job(&mut session, id, JobState::Cancelled, None, None).await?;
                }
            }
            blobs::end_hold(&mut session, &lease.holder()).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn release_job(&self, lease: &Lease) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            let cancel_requested = fence(&mut session, lease).await?;
            match state_after_release(cancel_requested) {
                JobState::Queued => {
                    session.execute(sql!("release_job"), bind![lease.job_id]).await?;
                }
                ended => {
                    end_job(&mut session, lease.job_id, ended, None, None).await?;
                }
            }
            blobs::end_hold(&mut session, &lease.holder()).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn recover_expired_leases(&self) -> Result<Recovered, JobError> {
        let expired = self.database.reading().await?.row(sql!("expired_leases"), bind![]).await?;
        if expired.is_none() {
            return Ok(Recovered::default());
        }
        let mut session = self.database.begin().await?;
        let done = async {
            let orphans = session.rows(sql!("expired_leases"), bind![]).await?;
            recover(&mut session, orphans).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn recover_leases_of(&self, worker: &WorkerId) -> Result<Recovered, JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            let orphans = session.rows(sql!("leases_of_worker"), bind![worker.name()]).await?;
            recover(&mut session, orphans).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn end_overdue_jobs(&self, patience: Duration) -> Result<Overdue, JobError> {
        if self.database.reading().await?.row(sql!("overdue_jobs"), bind![patience]).await?.is_none() {
            return Ok(Overdue::default());
        }
        let mut session = self.database.begin().await?;
        let done = async {
            let mut overdue = Overdue::default();
            for row in session.rows(sql!("overdue_jobs"), bind![patience]).await? {
                let id = rows::job_id(&row.get::<String>("id")?)?;
                let (state, failure) = match rows::state(&row.get::<String>("state")?)? {
                    JobState::Queued => {
                        overdue.expired += 1;
                        let detail = "no worker was free before the job's deadline";
                        (JobState::Expired, Failure::new("deadline-passed", detail))
                    }
                    _ => {
                        overdue.stuck += 1;
                        let detail = "the job ran longer than it may, and its worker did not end it";
                        (JobState::Failed, Failure::new("run-time-exceeded", detail))
                    }
                };
                end_job(&mut session, id, state, Some(&failure), None).await?;
            }
            Ok(overdue)
        };
        let done = done.await;
        session.end(done).await
    }
}

/// What becomes of running jobs whose workers are gone; their rows are locked.
async fn recover(session: &mut Session, orphans: Vec<Row>) -> Result<Recovered, JobError> {
    let mut recovered = Recovered::default();
    for row in orphans {
        let id: JobId = rows::job_id(&row.get::<String>("id")?)?;
        session.execute(sql!("count_crash"), bind![id]).await?;
        let crashes = row.count("crashes")? + 1;
        match state_after_crash(row.get("cancel_requested")?, crashes, row.count("max_attempts")?) {
            JobState::Queued => {
                session.execute(sql!("requeue_job"), bind![id]).await?;
                recovered.queued += 1;
            }
            JobState::Dead => {
                let detail = format!("{crashes} workers were lost while they ran this job");
                let failure = Failure::new("crash-limit-reached", detail);
                end_job(session, id, JobState::Dead, Some(&failure), None).await?;
                recovered.dead += 1;
            }
            ended => {
                end_job(session, id, ended, None, None).await?;
                recovered.cancelled += 1;
            }
        }
    }
    Ok(recovered)
}
