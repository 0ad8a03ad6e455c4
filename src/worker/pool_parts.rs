//! The dependencies of a pool: stores, engine, heartbeats, settings and signals.

use super::heartbeat::Heartbeats;
use super::quota::Quota;
use super::settings::WorkerSettings;
use crate::jobs::{ArtifactStore, Engine, JobStore, Signals, StudyProgression, WorkerId};
use std::sync::Arc;
use tokio_util::sync::CancellationToken;

/// The dependencies of a pool.
#[derive(Clone)]
pub(crate) struct PoolParts {
    /// Jobs.
    pub(crate) store: Arc<dyn JobStore>,
    /// Blobs.
    pub(crate) artifacts: Arc<dyn ArtifactStore>,
    /// Studies, and their progress.
    pub(crate) studies: StudyProgression,
    /// The computation.
    pub(crate) engine: Arc<dyn Engine>,
    /// Extends the leases, over separate database connections.
    pub(crate) heartbeats: Arc<Heartbeats>,
    /// The identity under which jobs are claimed.
    pub(crate) worker: WorkerId,
    /// Settings.
    pub(crate) settings: WorkerSettings,
    /// Notifications between this pool and the requests in this process that queue and follow jobs.
    pub(crate) signals: Arc<Signals>,
    /// When a process that only runs jobs exits by itself.
    pub(crate) quota: Arc<Quota>,
    /// When cancelled, no further job is claimed.
    pub(crate) stop: CancellationToken,
    /// When cancelled, running jobs return to the queue at once.
    pub(crate) give_back: CancellationToken,
}
