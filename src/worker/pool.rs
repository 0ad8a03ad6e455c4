//! The slots of a process: each claims a job, runs it, and claims the next.

use super::execution::execute;
use super::heartbeat::Heart;
use super::priority;
use super::quota::Quota;
use crate::jobs::{ArtifactStore, Engine, JobStore, WorkerId};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Notify;
use tokio::task::JoinSet;
use tokio_util::sync::CancellationToken;

/// Wait after a store did not answer.
const AFTER_ERROR: Duration = Duration::from_secs(1);

/// How workers behave.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Jobs run at the same time. Each uses all cores, so more than one mostly trades latency for memory.
    pub slots: usize,
    /// For how long a lease is given.
    pub lease: Duration,
    /// How often it is prolonged.
    pub heartbeat: Duration,
    /// How often the queue is asked while idle.
    pub poll: Duration,
    /// How often trace and progress are stored.
    pub flush: Duration,
    /// Longest run of a job.
    pub max_run: Duration,
    /// How long a stopped computation may take before its job is ended without it.
    pub stop_patience: Duration,
    /// How long results are kept; for ever if `None`.
    pub keep_results: Option<Duration>,
    /// How long its slot then waits for it before the thread is given up.
    pub abandon_after: Duration,
}

impl Default for WorkerSettings {
    fn default() -> Self {
        WorkerSettings {
            slots: 1,
            lease: Duration::from_secs(15),
            heartbeat: Duration::from_secs(3),
            poll: Duration::from_millis(250),
            flush: Duration::from_millis(200),
            max_run: Duration::from_secs(3600),
            keep_results: None,
            stop_patience: Duration::from_millis(500),
            abandon_after: Duration::from_secs(10),
        }
    }
}

/// What a pool works with.
#[derive(Clone)]
pub struct PoolParts {
    /// Jobs.
    pub store: Arc<dyn JobStore>,
    /// Blobs.
    pub artifacts: Arc<dyn ArtifactStore>,
    /// The computation.
    pub engine: Arc<dyn Engine>,
    /// The heart, over connections of its own.
    pub heart: Arc<Heart>,
    /// Who claims.
    pub worker: WorkerId,
    /// Behavior.
    pub settings: WorkerSettings,
    /// A hint that a job was queued in this process.
    pub queued: Arc<Notify>,
    /// When a process that only runs jobs ends by itself.
    pub quota: Arc<Quota>,
    /// No further claims.
    pub stop: CancellationToken,
    /// Running jobs are given back at once.
    pub give_back: CancellationToken,
}

/// Running slots.
#[derive(Debug)]
pub struct Pool {
    slots: JoinSet<()>,
}

impl Pool {
    /// Starts the slots.
    pub fn start(parts: &PoolParts) -> Self {
        priority::have_pool_give_way();
        let mut slots = JoinSet::new();
        for _ in 0..parts.settings.slots {
            slots.spawn(run_slot(parts.clone()));
        }
        Pool { slots }
    }

    /// Returns when every slot has ended, which they do after `stop`, each with its job.
    pub async fn ended(mut self) {
        while self.slots.join_next().await.is_some() {}
    }
}

async fn run_slot(parts: PoolParts) {
    while !parts.stop.is_cancelled() {
        if !parts.heart.is_healthy() {
            pause(&parts, AFTER_ERROR).await;
            continue;
        }
        if parts.quota.is_over() {
            tracing::info!("this process was to end about now");
            parts.stop.cancel();
            return;
        }
        if !parts.quota.begin() {
            pause(&parts, parts.settings.poll).await;
            continue;
        }
        let claimed = parts.store.claim(&parts.worker, parts.settings.lease, parts.settings.max_run).await;
        parts.quota.claimed(matches!(claimed, Ok(Some(_))));
        match claimed {
            Ok(Some(leased)) => {
                execute(&parts, leased).await;
                parts.quota.ended();
            }
            Ok(None) => pause(&parts, parts.settings.poll).await,
            Err(error) => {
                tracing::warn!(error = %with_sources(&error), "no job could be claimed");
                pause(&parts, AFTER_ERROR).await;
            }
        }
    }
}

async fn pause(parts: &PoolParts, at_most: Duration) {
    tokio::select! {
        () = parts.stop.cancelled() => {}
        () = parts.queued.notified() => {}
        () = tokio::time::sleep(at_most) => {}
    }
}

/// An error with what caused it, for logs.
pub fn with_sources(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(cause) = source {
        text.push_str(": ");
        text.push_str(&cause.to_string());
        source = cause.source();
    }
    text
}
