//! The queue: from the claim of a job to its end, fenced by the lease's epoch.

use super::argument::bind;
use super::database::{Row, Session};
use super::dialect::{Sql, sql};
use super::fence::lock_lease;
use super::writing::{end_job, insert_artifact};
use super::{SqlStore, StoreSettings, blobs, rows};
use crate::jobs::{
    JobError, JobId, JobQueue, JobState, Lease, LeaseStatus, LeasedJob, Outcome, Tenant, TenantWeights, TraceChunk,
    WaitingJob, WorkerId, state_after_release,
};
use async_trait::async_trait;
use std::time::Duration;

fn status(cancel_requested: Option<bool>) -> LeaseStatus {
    match cancel_requested {
        None => LeaseStatus::Lost,
        Some(true) => LeaseStatus::CancelRequested,
        Some(false) => LeaseStatus::Held,
    }
}

/// A turn of a tenant of weight 1, in the units of the table of turns.
const TURN: i64 = 1_000_000;
/// Tenants whose queues are read at once, and the least number of jobs read from each.
const TENANTS_AT_ONCE: u32 = 64;
const LEAST_OF_TENANT: u32 = 4;
/// Length of the front of the queue from which a process that claims one job at a time takes the first free job: more
/// than processes claim at once.
const FRONT: u32 = 64;

/// The waiting tenants in the order of their turns: name, due time of the next turn, and the present time.
async fn tenants_in_turn(session: &mut Session) -> Result<Vec<Row>, JobError> {
    session.rows(sql!("tenants_in_turn"), bind![TENANTS_AT_ONCE]).await
}

/// The number of a tenant's running jobs, counted up to `at_most`.
async fn running_jobs(session: &mut Session, tenant: &str, at_most: u32) -> Result<u32, JobError> {
    let row = session.row(sql!("running_jobs"), bind![tenant, at_most]).await?;
    row.map_or(Ok(0), |row| row.count(0))
}

/// Locks the turns of a tenant, so that transactions which claim its jobs count them one at a time.
pub(super) async fn lock_turns(session: &mut Session, tenant: &str) -> Result<(), JobError> {
    session.execute(sql!("lock_turns"), bind![tenant]).await.map(|_| ())
}

/// The front of the queue: tenants take turns in proportion to their weights, and each tenant's jobs are ordered by
/// priority and age. A tenant that was idle begins at the present time: it is owed no turns, and it does not wait
/// behind tenants that have queued more jobs.
///
/// `of_tenant` reads the first jobs of a tenant's queue; its rows are returned.
async fn front(
    session: &mut Session,
    limit: u32,
    settings: &StoreSettings,
    of_tenant: &'static Sql,
) -> Result<Vec<Row>, JobError> {
    let weights = &settings.weights;
    let tenants = tenants_in_turn(session).await?;
    let of_each = (limit / u32::try_from(tenants.len()).unwrap_or(limit).max(1)).max(LEAST_OF_TENANT).min(limit);
    let mut jobs = Vec::new();
    for row in &tenants {
        let tenant: String = row.get("tenant")?;
        let (due, present): (i64, i64) = (row.get("due")?, row.get("present")?);
        let turn = TURN / i64::from(weights.of(&tenant));
        let of_this = match settings.max_running {
            Some(most) => of_each.min(most.saturating_sub(running_jobs(session, &tenant, most).await?)),
            None => of_each,
        };
        if of_this == 0 {
            continue;
        }
        for (place, row) in (0..).zip(session.rows(of_tenant, bind![tenant, of_this]).await?) {
            jobs.push((due.max(present) + place * turn, row));
        }
    }
    // A stable sort: of two tenants with the same due time, the one that comes first in the order of tenants goes
    // first.
    jobs.sort_by_key(|(due, _)| *due);
    jobs.truncate(limit as usize);
    Ok(jobs.into_iter().map(|(_, row)| row).collect())
}

/// Counts a turn of a tenant.
async fn take_turn(session: &mut Session, tenant: &Tenant, weights: &TenantWeights) -> Result<(), JobError> {
    let turn = TURN / i64::from(weights.of(tenant.name()));
    session.execute(sql!("take_turn"), bind![tenant, turn]).await.map(|_| ())
}

/// Claims the first of `jobs` that is still queued and that no other transaction has locked.
async fn claim_first(session: &mut Session, jobs: &[JobId], claim: &Claim<'_>) -> Result<Option<LeasedJob>, JobError> {
    for &job in jobs {
        if let Some(queued) = lock_queued(session, job).await? {
            let (id, tenant): (String, String) = (queued.get("id")?, queued.get("tenant")?);
            if let Some(most) = claim.max_running {
                lock_turns(session, &tenant).await?;
                if running_jobs(session, &tenant, most).await? >= most {
                    // The next read of the front of the queue omits this tenant. Continuing with another tenant's jobs
                    // would lock the turns of two tenants, in an order that differs between processes.
                    return Ok(None);
                }
            }
            return claim_job(session, &id, claim).await.map(Some);
        }
    }
    Ok(None)
}

/// Who claims a job, and for how long.
struct Claim<'a> {
    worker: &'a WorkerId,
    lease: Duration,
    max_run: Duration,
    weights: &'a TenantWeights,
    /// Maximum number of running jobs of a tenant.
    max_running: Option<u32>,
}

/// Locks a job if it is still queued and no other transaction has locked it.
async fn lock_queued(session: &mut Session, id: JobId) -> Result<Option<Row>, JobError> {
    session.row(sql!("lock_queued"), bind![id]).await
}

/// Leases a queued job whose row is locked.
async fn claim_job(session: &mut Session, id: &str, claim: &Claim<'_>) -> Result<LeasedJob, JobError> {
    let &Claim { worker, lease, max_run, weights, .. } = claim;
    let epoch: Option<i64> = session.value(sql!("claim_job"), bind![id, worker.name(), lease, max_run]).await?;
    if epoch != Some(1) {
        // A rerun computes the same trace from its first point, so the points of earlier epochs would be duplicates.
        for query in [sql!("clear_trace"), sql!("clear_progress")] {
            session.execute(query, bind![id]).await?;
        }
    }
    let row = session.row(sql!("get_leased_job"), bind![id]).await?.ok_or(JobError::NotFound)?;
    let job = rows::job(&row)?;
    take_turn(session, &job.tenant, weights).await?;
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
        let mut session = self.database.reader().await?;
        let front = front(&mut session, FRONT, &self.settings, sql!("queued_of_tenant")).await?;
        drop(session);
        let jobs = front.iter().map(|row| rows::job_id(&row.get::<String>("id")?)).collect::<Result<Vec<_>, _>>()?;
        // Idle workers should not take a lock several times a second.
        if jobs.is_empty() {
            return Ok(None);
        }
        self.claim_one_of(&jobs, worker, lease, max_run).await
    }

    async fn note_worker(&self, worker: &WorkerId) -> Result<(), JobError> {
        self.database
            .transaction(async |session| session.execute(sql!("note_worker"), bind![worker.name()]).await.map(|_| ()))
            .await
    }

    async fn forget_worker(&self, worker: &WorkerId) -> Result<(), JobError> {
        self.database
            .transaction(async |session| session.execute(sql!("forget_worker"), bind![worker.name()]).await.map(|_| ()))
            .await
    }

    async fn front_of_queue(&self, limit: u32) -> Result<Vec<WaitingJob>, JobError> {
        let mut session = self.database.reader().await?;
        let front = front(&mut session, limit, &self.settings, sql!("queue_of_tenant")).await?;
        front.iter().map(rows::waiting_job).collect()
    }

    async fn claim_one_of(
        &self,
        jobs: &[JobId],
        worker: &WorkerId,
        lease: Duration,
        max_run: Duration,
    ) -> Result<Option<LeasedJob>, JobError> {
        let claim =
            Claim { worker, lease, max_run, weights: &self.settings.weights, max_running: self.settings.max_running };
        self.database.transaction(async |session| claim_first(session, jobs, &claim).await).await
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
                    Outcome::Succeeded { artifacts, verdict } => {
                        for artifact in artifacts {
                            insert_artifact(session, id, artifact).await?;
                        }
                        let verdict = verdict.as_ref().map(|v| rows::to_json("a verdict", v)).transpose()?;
                        session.execute(sql!("set_verdict"), bind![id, verdict]).await?;
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
