//! Periodic work of every process: requeue jobs of lost workers, end overdue jobs, and purge records past their
//! retention.

use super::argument::bind;
use super::database::{Row, Session};
use super::dialect::sql;
use super::writing::end_job;
use super::{SqlStore, retention, rows};
use crate::jobs::{
    ClockState, Failure, Housekeeping, JobError, JobId, JobState, Overdue, Purged, Recovered, Retentions, TICKET_LASTS,
    WorkerId, state_after_crash,
};
use async_trait::async_trait;
use std::sync::atomic::Ordering;
use std::time::Duration;

/// Longest lease that can be set.
const LONGEST_LEASE: Duration = Duration::from_secs(3600);
/// Longest hold on a blob.
const LONGEST_HOLD: Duration = Duration::from_secs(3600);
/// How long the key of a request in progress stays reserved, unless it is reserved again.
const LONGEST_REQUEST: Duration = crate::jobs::submission::BUSY;
/// Longest wait of a job after a crash.
const MAX_CRASH_PAUSE: Duration = Duration::from_secs(60);

/// The running jobs whose leases expired. In a transaction, rows that other transactions have locked are skipped.
async fn expired_leases(session: &mut Session) -> Result<Vec<Row>, JobError> {
    session.rows(sql!("expired_leases"), bind![]).await
}

/// The running jobs of a worker; in a transaction their rows are locked.
async fn leases_of_worker(session: &mut Session, worker: &WorkerId) -> Result<Vec<Row>, JobError> {
    session.rows(sql!("leases_of_worker"), bind![worker.name()]).await
}

/// Jobs past their deadline, or past their run time by `tolerance`; in a transaction their rows are locked.
async fn overdue_jobs(session: &mut Session, tolerance: Duration) -> Result<Vec<Row>, JobError> {
    session.rows(sql!("overdue_jobs"), bind![tolerance]).await
}

#[async_trait]
impl Housekeeping for SqlStore {
    async fn recover_expired(&self) -> Result<Recovered, JobError> {
        // Checked without a lock first, because usually there is nothing to do; `end_overdue` does the same.
        if expired_leases(&mut self.database.reader().await?).await?.is_empty() {
            return Ok(Recovered::default());
        }
        self.database
            .transaction(async |session| {
                let orphans = expired_leases(session).await?;
                recover(session, orphans, self.settings.crash_pause).await
            })
            .await
    }

    async fn recover_worker(&self, worker: &WorkerId) -> Result<Recovered, JobError> {
        self.database
            .transaction(async |session| {
                let orphans = leases_of_worker(session, worker).await?;
                recover(session, orphans, self.settings.crash_pause).await
            })
            .await
    }

    async fn end_overdue(&self, tolerance: Duration) -> Result<Overdue, JobError> {
        if overdue_jobs(&mut self.database.reader().await?, tolerance).await?.is_empty() {
            return Ok(Overdue::default());
        }
        self.database
            .transaction(async |session| {
                let mut overdue = Overdue::default();
                for row in overdue_jobs(session, tolerance).await? {
                    let id = rows::job_id(&row.get::<String>("id")?)?;
                    let (state, failure) = match rows::state(&row.get::<String>("state")?)? {
                        JobState::Queued => {
                            overdue.expired += 1;
                            let detail = "no worker was free before the job's deadline";
                            (JobState::Expired, Failure::new("deadline-passed", detail))
                        }
                        _ => {
                            overdue.stuck += 1;
                            let detail = "the job exceeded its run time and its worker did not end it";
                            (JobState::Failed, Failure::new("run-time-exceeded", detail))
                        }
                    };
                    end_job(session, id, state, Some(&failure), None).await?;
                }
                Ok(overdue)
            })
            .await
    }

    async fn overwrite_deleted(&self) -> Result<bool, JobError> {
        if !self.has_deleted.swap(false, Ordering::SeqCst) {
            return Ok(true);
        }
        let done = self.database.overwrite_deleted().await;
        if !matches!(done, Ok(true)) {
            self.note_deletion();
        }
        done
    }

    async fn check_clock(&self, trusted: bool) -> Result<ClockState, JobError> {
        self.look_at_clock(trusted).await
    }

    async fn clock_was_set(&self) -> Result<bool, JobError> {
        self.was_clock_set().await
    }

    async fn bound_waits(&self) -> Result<u64, JobError> {
        let bounds = [
            (sql!("bound_wait_of_deliveries"), bind![]),
            (sql!("bound_wait_of_webhooks"), bind![]),
            (sql!("bound_wait_of_removals"), bind![]),
            (sql!("bound_wait_of_holds"), bind![LONGEST_HOLD]),
            (sql!("bound_wait_of_requests"), bind![LONGEST_REQUEST]),
            (sql!("bound_time_of_tickets"), bind![TICKET_LASTS]),
            (sql!("bound_wait_of_leases"), bind![LONGEST_LEASE]),
            (sql!("bound_run_time"), bind![]),
        ];
        let mut n_shorter = 0;
        for (query, arguments) in bounds {
            n_shorter += self.database.transaction(async |session| session.execute(query, arguments).await).await?;
        }
        Ok(n_shorter)
    }

    fn clock_has_jumped(&self) -> bool {
        self.has_clock_jumped()
    }

    async fn purge(&self, retention: &Retentions, limit: u32, dry_run: bool) -> Result<Purged, JobError> {
        if dry_run {
            retention::count_purge(self, retention).await
        } else {
            retention::purge(self, retention, limit).await
        }
    }
}

/// How long a job waits after this number of crashes; each further crash multiplies the wait by five.
fn pause_after(first_pause: Duration, crashes: u32) -> Duration {
    first_pause.saturating_mul(5u32.saturating_pow(crashes.saturating_sub(1))).min(MAX_CRASH_PAUSE)
}

/// Requeues or ends running jobs whose workers are lost; their rows are locked.
async fn recover(session: &mut Session, orphans: Vec<Row>, first_pause: Duration) -> Result<Recovered, JobError> {
    let mut recovered = Recovered::default();
    for row in orphans {
        let id: JobId = rows::job_id(&row.get::<String>("id")?)?;
        session.execute(sql!("count_crash"), bind![id]).await?;
        let crashes = row.count("crashes")? + 1;
        match state_after_crash(row.get("cancel_requested")?, crashes, row.count("max_attempts")?) {
            JobState::Queued => {
                session.execute(sql!("requeue_job"), bind![id, pause_after(first_pause, crashes)]).await?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_crash_makes_the_wait_longer_up_to_a_minute() {
        let waits: Vec<u64> = (1..=5).map(|n| pause_after(Duration::from_secs(1), n).as_secs()).collect();
        assert_eq!(waits, [1, 5, 25, 60, 60]);
        assert_eq!(pause_after(Duration::ZERO, 3), Duration::ZERO);
    }
}
