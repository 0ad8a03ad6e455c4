//! The jobs of a process: claimed when they can start, run side by side as far as cores and memory go.

use super::capacity::Capacity;
use super::execution::execute;
use super::heartbeat::Heart;
use super::quota::Quota;
use super::schedule::{Candidate, Room, startable};
use super::{machine, priority};
use crate::jobs::{ArtifactStore, Demand, Engine, JobError, JobStore, LeasedJob, Signals, WaitingJob, WorkerId};
use std::collections::HashMap;
use std::sync::Arc;
use std::time::Duration;
use tokio::task::{self, JoinError, JoinHandle, JoinSet};
use tokio_util::sync::CancellationToken;

/// Wait after a store did not answer.
const AFTER_ERROR: Duration = Duration::from_secs(1);
/// Wait after others took what was looked at, so that processes that look at once do not keep doing so.
const AFTER_MISS: Duration = Duration::from_millis(5);
/// Waiting jobs looked at to find one that can start: more than start at once on any machine, so few that reading them
/// takes a few milliseconds.
const FRONT: u32 = 64;

/// How workers behave.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Cores that jobs may use.
    pub cores: usize,
    /// Memory that jobs may take together, as predicted, bytes.
    pub memory_bytes: u64,
    /// Jobs run at the same time, each with its share of the cores; `None`: as many as cores and memory are predicted to
    /// be enough for.
    pub places: Option<usize>,
    /// How long jobs that come later may pass one for which there is not enough room yet.
    pub patience: Duration,
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
    /// How long its cores are then kept for it before the thread is given up.
    pub abandon_after: Duration,
}

impl Default for WorkerSettings {
    fn default() -> Self {
        WorkerSettings {
            cores: machine::cores(),
            memory_bytes: u64::MAX,
            places: None,
            patience: Duration::from_secs(10),
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
    /// Hints between this pool and those who queue and follow jobs in this process.
    pub signals: Arc<Signals>,
    /// When a process that only runs jobs ends by itself.
    pub quota: Arc<Quota>,
    /// No further claims.
    pub stop: CancellationToken,
    /// Running jobs are given back at once.
    pub give_back: CancellationToken,
}

/// The running pool.
#[derive(Debug)]
pub struct Pool {
    dispatcher: Option<JoinHandle<()>>,
}

impl Pool {
    /// Starts to run jobs; in no places it runs none.
    pub fn start(parts: &PoolParts) -> Self {
        priority::have_pool_give_way();
        let runs_jobs = parts.settings.places != Some(0);
        Pool { dispatcher: runs_jobs.then(|| tokio::spawn(Dispatcher::new(parts.clone()).run())) }
    }

    /// Returns when every job has ended, which they do after `stop`.
    pub async fn ended(self) {
        if let Some(dispatcher) = self.dispatcher {
            let _ = dispatcher.await;
        }
    }
}

/// A job that was claimed, and what it gets.
struct Granted {
    leased: LeasedJob,
    room: Room,
    n_threads: usize,
}

/// How a look at the queue ended.
enum Look {
    Granted(Box<Granted>),
    /// Others took what could have started here.
    Missed,
    /// Nothing waits that could start.
    Nothing,
}

/// Claims what can start, and nothing else: a job that has to wait does so in the queue, where any process may take it.
struct Dispatcher {
    parts: PoolParts,
    capacity: Capacity,
    running: JoinSet<()>,
    rooms: HashMap<task::Id, Room>,
}

impl Dispatcher {
    fn new(parts: PoolParts) -> Self {
        let capacity = Capacity::new(&parts.settings);
        Dispatcher { parts, capacity, running: JoinSet::new(), rooms: HashMap::new() }
    }

    async fn run(mut self) {
        while !self.parts.stop.is_cancelled() {
            while let Some(ended) = self.running.try_join_next_with_id() {
                self.free(ended);
            }
            if !self.parts.heart.is_healthy() {
                self.pause(AFTER_ERROR).await;
                continue;
            }
            if self.parts.quota.is_over() {
                tracing::info!("this process was to end about now");
                self.parts.stop.cancel();
                break;
            }
            self.start_one().await;
        }
        while let Some(ended) = self.running.join_next_with_id().await {
            self.free(ended);
        }
    }

    /// Starts a job, or waits until there may be one to start.
    async fn start_one(&mut self) {
        let free = self.free_room();
        if free.cores == 0 || !self.parts.quota.begin() {
            return self.pause(self.parts.settings.poll).await;
        }
        let look = self.look(free).await;
        self.parts.quota.claimed(matches!(look, Ok(Look::Granted(_))));
        match look {
            Ok(Look::Granted(granted)) => self.start(*granted),
            Ok(Look::Missed) => tokio::time::sleep(AFTER_MISS).await,
            Ok(Look::Nothing) => self.pause(self.parts.settings.poll).await,
            Err(error) => {
                tracing::warn!(error = %with_sources(&error), "no job could be claimed");
                self.pause(AFTER_ERROR).await;
            }
        }
    }

    async fn look(&self, free: Room) -> Result<Look, JobError> {
        let PoolParts { store, worker, settings, .. } = &self.parts;
        let (lease, max_run) = (settings.lease, settings.max_run);
        if settings.places == Some(1) {
            // It is free, so the next job can start, whatever it takes.
            let Some(leased) = store.claim(worker, lease, max_run).await? else { return Ok(Look::Nothing) };
            let room = self.capacity.need(Demand::UNKNOWN);
            return Ok(Look::Granted(Box::new(Granted {
                leased,
                room,
                n_threads: self.capacity.n_threads(room, true),
            })));
        }
        let waiting = store.front_of_queue(FRONT).await?;
        let candidates: Vec<_> = waiting.iter().map(|job| self.candidate(job)).collect();
        let places = startable(free, &candidates, settings.patience);
        if places.is_empty() {
            return Ok(Look::Nothing);
        }
        let jobs: Vec<_> = places.iter().map(|&place| waiting[place].id).collect();
        let Some(leased) = store.claim_one_of(&jobs, worker, lease, max_run).await? else { return Ok(Look::Missed) };
        let claimed = waiting.iter().position(|job| job.id == leased.job.id);
        let room = claimed.map_or(self.capacity.budget, |place| candidates[place].need);
        let is_alone = self.rooms.is_empty() && waiting.len() == 1;
        Ok(Look::Granted(Box::new(Granted { leased, room, n_threads: self.capacity.n_threads(room, is_alone) })))
    }

    fn candidate(&self, job: &WaitingJob) -> Candidate {
        let demand = self.parts.engine.demand(&job.parameters, job.source, job.target);
        Candidate { need: self.capacity.need(demand), waited: job.waited }
    }

    fn start(&mut self, granted: Granted) {
        let Granted { leased, room, n_threads } = granted;
        let parts = self.parts.clone();
        let running = self.running.spawn(async move {
            execute(&parts, leased, n_threads).await;
            parts.quota.ended();
        });
        self.rooms.insert(running.id(), room);
    }

    fn free_room(&self) -> Room {
        let used = self.rooms.values().fold(Room::NONE, |sum, room| sum.plus(*room));
        self.capacity.budget.minus(used)
    }

    fn free(&mut self, ended: Result<(task::Id, ()), JoinError>) {
        let id = ended.map_or_else(|error| error.id(), |(id, ())| id);
        self.rooms.remove(&id);
    }

    /// Until a job ends, one is queued, or the time is over.
    async fn pause(&mut self, at_most: Duration) {
        tokio::select! {
            () = self.parts.stop.cancelled() => {}
            () = self.parts.signals.queued.notified() => {}
            Some(ended) = self.running.join_next_with_id() => self.free(ended),
            () = tokio::time::sleep(at_most) => {}
        }
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
