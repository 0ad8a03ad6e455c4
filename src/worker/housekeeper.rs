//! What has to be done now and then in every process: jobs of the dead go back to the queue, blobs of nobody go.

use super::pool::with_sources;
use crate::jobs::{ArtifactStore, JobError, JobStore};
use crate::store::presence::Presence;
use std::sync::Arc;
use std::time::Duration;
use tokio_util::sync::CancellationToken;

/// How often leases and processes are looked at.
const ROUND: Duration = Duration::from_secs(1);
/// Rounds between sweeps of what interrupted writes left.
const ROUNDS_BETWEEN_SWEEPS: u64 = 600;

/// What housekeeping works with.
#[derive(Clone)]
pub struct Housekeeper {
    /// Jobs.
    pub store: Arc<dyn JobStore>,
    /// Blobs.
    pub artifacts: Arc<dyn ArtifactStore>,
    /// Processes on this data directory.
    pub presence: Arc<Presence>,
}

impl Housekeeper {
    /// Takes jobs from processes that are gone and from leases that ran out.
    ///
    /// # Errors
    /// Of the store.
    pub async fn recover(&self) -> Result<u32, JobError> {
        let presence = Arc::clone(&self.presence);
        let departed = tokio::task::spawn_blocking(move || presence.departed()).await;
        let departed = departed
            .map_err(|join| JobError::Unavailable(Box::new(join)))?
            .map_err(|error| JobError::Unavailable(Box::new(error)))?;
        let mut total = 0;
        for process in departed {
            let recovered = self.store.recover_worker(&process.worker).await?;
            if recovered.total() > 0 {
                tracing::warn!(worker = process.worker.name(), ?recovered, "jobs of a lost process are taken back");
            }
            total += recovered.total();
            process.forget();
        }
        let recovered = self.store.recover_expired().await?;
        if recovered.total() > 0 {
            tracing::warn!(?recovered, "jobs whose leases ran out are taken back");
        }
        Ok(total + recovered.total())
    }

    /// Goes round until `stop`.
    pub async fn run(self, stop: CancellationToken) {
        for round in 0u64.. {
            if let Err(error) = self.round(round).await {
                tracing::warn!(error = %with_sources(&error), "housekeeping is put off");
            }
            tokio::select! {
                () = stop.cancelled() => return,
                () = tokio::time::sleep(ROUND) => {}
            }
        }
    }

    async fn round(&self, round: u64) -> Result<(), JobError> {
        self.recover().await?;
        self.store.remove_unreferenced_blobs(self.artifacts.as_ref()).await?;
        if round.is_multiple_of(ROUNDS_BETWEEN_SWEEPS) {
            self.artifacts.sweep().await?;
        }
        Ok(())
    }
}
