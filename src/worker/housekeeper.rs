//! Periodic work of every process: requeues jobs of lost workers, advances studies, and removes unreferenced blobs.

use super::error_text::with_sources;
use crate::jobs::{
    ArtifactStore, AuditEvent, AuditStore, ClockState, JobError, JobStore, Processes, Retentions, StudyProgression,
};
use std::sync::Arc;
use std::time::Duration;
use tokio_util::sync::CancellationToken;

/// Time between two rounds; each looks for expired leases and ended processes.
const ROUND: Duration = Duration::from_secs(1);
/// Rounds between two removals of files that interrupted writes left behind.
const ROUNDS_BETWEEN_SWEEPS: u64 = 600;
/// Rounds between two purges of records past their retention.
const ROUNDS_BETWEEN_PURGES: u64 = 60;
/// Rounds between two checks for waits that a clock set back has made longer.
const ROUNDS_BETWEEN_BOUNDS: u64 = 60;
/// Rounds after a change of the clock in which nothing expires, so that holders of leases can renew them by the new
/// time.
const ROUNDS_AFTER_SET: u64 = 60;
/// Jobs purged in one round.
const PURGED_AT_ONCE: u32 = 1000;
/// How long a job may exceed its run time before it is taken from its worker, which should have ended it.
const OVERDUE_TOLERANCE: Duration = Duration::from_secs(30);

/// The dependencies of housekeeping.
#[derive(Clone)]
pub(crate) struct Housekeeper {
    /// Jobs.
    pub(crate) store: Arc<dyn JobStore>,
    /// The audit log.
    pub(crate) audit: Arc<dyn AuditStore>,
    /// Blobs.
    pub(crate) artifacts: Arc<dyn ArtifactStore>,
    /// The processes that share this one's data directory; `None` with a database server.
    pub(crate) processes: Option<Arc<dyn Processes>>,
    /// How long jobs and results are kept.
    pub(crate) retention: Retentions,
    /// Advances studies.
    pub(crate) studies: StudyProgression,
}

/// The audit event of a purge: the settings caused it, not a person.
fn purge_event() -> AuditEvent {
    AuditEvent {
        tenant: None,
        key_id: None,
        action: "purge".to_owned(),
        resource: None,
        address: Some("service".to_owned()),
        status: None,
    }
}

impl Housekeeper {
    /// Takes back the jobs of ended processes and of expired leases. Returns their number.
    ///
    /// # Errors
    /// Those of the store.
    pub(crate) async fn recover(&self) -> Result<u32, JobError> {
        let mut total = 0;
        let mut dead = 0;
        if let Some(processes) = &self.processes {
            let processes = Arc::clone(processes);
            let departed = tokio::task::spawn_blocking(move || processes.departed()).await;
            let departed = departed
                .map_err(|join| JobError::Unavailable(Box::new(join)))?
                .map_err(|error| JobError::Unavailable(Box::new(error)))?;
            for process in departed {
                let recovered = self.store.recover_worker(process.worker()).await?;
                if recovered.total() > 0 {
                    tracing::warn!(
                        worker = process.worker().name(),
                        queued = recovered.queued,
                        cancelled = recovered.cancelled,
                        dead = recovered.dead,
                        "jobs of a lost process are taken back"
                    );
                }
                total += recovered.total();
                dead += recovered.dead;
                process.remove_record();
            }
        }
        let recovered = self.store.recover_expired().await?;
        if recovered.total() > 0 {
            let (queued, cancelled) = (recovered.queued, recovered.cancelled);
            tracing::warn!(queued, cancelled, dead = recovered.dead, "jobs whose leases ran out are taken back");
        }
        metrics::counter!("homolog_leases_expired_total").increment((total + recovered.total()).into());
        metrics::counter!("homolog_jobs_dead_total").increment((dead + recovered.dead).into());
        Ok(total + recovered.total())
    }

    /// Runs until `stop` is cancelled.
    pub(crate) async fn run(self, stop: CancellationToken) {
        let mut expires_from = 0;
        for round in 0u64.. {
            if let Err(error) = self.round(round, &mut expires_from).await {
                tracing::warn!(error = %with_sources(&error), "housekeeping is put off");
            }
            tokio::select! {
                () = stop.cancelled() => return,
                () = tokio::time::sleep(ROUND) => {}
            }
        }
    }

    /// Compares the clock with the last time that was seen. Returns whether the clock is plausible.
    async fn believes_clock(&self) -> Result<bool, JobError> {
        let state = self.store.check_clock(false).await?;
        metrics::gauge!("homolog_clock_jumped").set(if state == ClockState::Plausible { 0.0 } else { 1.0 });
        if let ClockState::Jumped { by_ms } = state {
            tracing::error!(
                by_s = by_ms / 1000,
                "the clock has jumped: the database's clock differs by by_s seconds from the last time that was stored: nothing is removed and no deadline counts. \
                 Correct the clock or, if it is right, run `homolog purge --trust-clock`"
            );
        }
        Ok(state == ClockState::Plausible)
    }

    /// One round; nothing expires before the round `expires_from`.
    async fn round(&self, round: u64, expires_from: &mut u64) -> Result<(), JobError> {
        let was_set = self.store.clock_was_set().await?;
        if was_set {
            tracing::warn!("the clock was set; nothing expires for a minute");
            *expires_from = round + ROUNDS_AFTER_SET;
            self.believes_clock().await?;
        }
        // The clock may have been set while no process ran.
        if was_set || round.is_multiple_of(ROUNDS_BETWEEN_BOUNDS) {
            let n_shorter = self.store.bound_waits().await?;
            if n_shorter > 0 {
                tracing::warn!(n_shorter, "the clock was set back: waits are as long as they were meant to be");
            }
        }
        if round >= *expires_from {
            self.recover().await?;
        }
        if round >= *expires_from && !self.store.clock_has_jumped() {
            let overdue = self.store.end_overdue(OVERDUE_TOLERANCE).await?;
            if overdue.expired + overdue.stuck > 0 {
                tracing::warn!(?overdue, "jobs whose time was over are ended");
            }
        }
        if let Err(error) = self.studies.advance_studies().await {
            // A study that cannot continue must not stop the rest of the round.
            tracing::warn!(error = %with_sources(&error), "a study goes on later");
        }
        // Removal is final, so a clock that was set wrong must not decide about it.
        let is_due = round.is_multiple_of(ROUNDS_BETWEEN_PURGES);
        if is_due && self.believes_clock().await? {
            let purged = self.store.purge(&self.retention, PURGED_AT_ONCE, false).await?;
            if !purged.is_nothing() {
                tracing::info!(?purged, "what outlived its retention is removed");
            }
            if purged.results + purged.jobs + purged.studies + purged.meshes > 0 {
                self.audit.append_audit(&[purge_event()]).await?;
            }
        }
        if self.store.clock_has_jumped() {
            return Ok(());
        }
        self.store.remove_unreferenced_blobs(self.artifacts.as_ref()).await?;
        self.store.overwrite_deleted().await?;
        if round.is_multiple_of(ROUNDS_BETWEEN_SWEEPS) {
            self.artifacts.sweep().await?;
        }
        Ok(())
    }
}
