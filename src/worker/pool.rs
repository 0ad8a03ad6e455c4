//! The running jobs of a process: claimed when they can start, and run side by side while cores and memory suffice.

use super::capacity::Capacity;
use super::error_text::with_sources;
use super::execution::execute;
use super::pool_parts::PoolParts;
use super::priority;
use super::schedule::{Candidate, Room, startable};
use crate::jobs::{Computation, Demand, Engine, Failure, JobError, JobId, LeasedJob, WaitingJob};
use std::collections::HashMap;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::task::{self, JoinError, JoinHandle, JoinSet};

/// Wait after the store did not answer.
const AFTER_ERROR: Duration = Duration::from_secs(1);
/// Wait after other processes claimed all jobs that could start here, so that the processes do not read the queue in
/// step.
const AFTER_MISS: Duration = Duration::from_millis(5);
/// How often the store is told that this process runs jobs.
const SEEN_EVERY: Duration = Duration::from_secs(15);
/// Queued jobs that are read to find one that can start: more than start at once on any machine, and few enough that
/// reading them takes a few milliseconds.
const FRONT: u32 = 64;

/// The running pool.
#[derive(Debug)]
pub(crate) struct Pool {
    dispatcher: Option<JoinHandle<()>>,
}

impl Pool {
    /// Starts to run jobs; with 0 slots it runs none.
    pub(crate) fn start(parts: &PoolParts) -> Self {
        priority::lower_priority_of_global_pool();
        let runs_jobs = parts.settings.slots != Some(0);
        Pool { dispatcher: runs_jobs.then(|| tokio::spawn(Dispatcher::new(parts.clone()).run())) }
    }

    /// Returns when `stop` is cancelled and every running job has ended.
    pub(crate) async fn ended(self) {
        if let Some(dispatcher) = self.dispatcher {
            let _ = dispatcher.await;
        }
    }
}

/// A claimed job with the cores and the memory that are reserved for it.
struct Claimed {
    leased: LeasedJob,
    computation: Result<Arc<dyn Computation>, Failure>,
    room: Room,
    n_threads: usize,
}

/// The outcome of an attempt to claim a job.
enum Attempt {
    Claimed(Box<Claimed>),
    /// Other processes claimed all jobs that could have started here.
    Missed,
    /// No queued job can start here.
    Nothing,
}

/// A queued job as the dispatcher knows it. Its parameters never change, so they are read only once.
struct Known {
    computation: Result<Arc<dyn Computation>, Failure>,
    demand: Demand,
}

impl Known {
    fn new(engine: &dyn Engine, job: &WaitingJob) -> Self {
        let computation = engine.restore(&job.parameters);
        // A job whose parameters this version does not accept fails as soon as it starts.
        let failing = Demand { cores: 1, ..Demand::UNKNOWN };
        let demand = computation.as_ref().map_or(failing, |known| known.demand(job.source, job.target));
        Known { computation, demand }
    }
}

/// Claims only jobs that can start: other jobs wait in the queue, where any process can take them.
struct Dispatcher {
    parts: PoolParts,
    capacity: Capacity,
    running: JoinSet<()>,
    rooms: HashMap<task::Id, Room>,
    /// The jobs at the front of the queue.
    known: HashMap<JobId, Known>,
    /// When the store was last told of this process.
    seen: Option<Instant>,
}

impl Dispatcher {
    fn new(parts: PoolParts) -> Self {
        let capacity = Capacity::new(&parts.settings);
        Dispatcher {
            parts,
            capacity,
            running: JoinSet::new(),
            rooms: HashMap::new(),
            known: HashMap::new(),
            seen: None,
        }
    }

    async fn run(mut self) {
        while !self.parts.stop.is_cancelled() {
            while let Some(ended) = self.running.try_join_next_with_id() {
                self.free(ended);
            }
            if !self.parts.heartbeats.is_healthy() {
                self.pause(AFTER_ERROR).await;
                continue;
            }
            self.note().await;
            if self.parts.quota.is_over() {
                tracing::info!("the limit of jobs or of idle time is reached; the process exits");
                self.parts.stop.cancel();
                break;
            }
            self.start_one().await;
        }
        while let Some(ended) = self.running.join_next_with_id().await {
            self.free(ended);
        }
        // Otherwise it counts as idle for a minute.
        let _ = self.parts.store.forget_worker(&self.parts.worker).await;
    }

    /// Tells the store now and then that this process runs jobs. What fails is done next time: only a count depends on it.
    async fn note(&mut self) {
        if self.seen.is_none_or(|seen| seen.elapsed() >= SEEN_EVERY) {
            self.seen = Some(Instant::now());
            let _ = self.parts.store.note_worker(&self.parts.worker).await;
        }
    }

    /// Starts a job, or waits until a job may be able to start.
    async fn start_one(&mut self) {
        let free = self.free_room();
        if free.cores == 0 || !self.parts.quota.begin() {
            return self.pause(self.parts.settings.poll).await;
        }
        let attempt = self.try_claim(free).await;
        self.parts.quota.claimed(matches!(attempt, Ok(Attempt::Claimed(_))));
        match attempt {
            Ok(Attempt::Claimed(claimed)) => self.start(*claimed),
            Ok(Attempt::Missed) => tokio::time::sleep(AFTER_MISS).await,
            Ok(Attempt::Nothing) => self.pause(self.parts.settings.poll).await,
            Err(error) => {
                tracing::warn!(error = %with_sources(&error), "no job could be claimed");
                self.pause(AFTER_ERROR).await;
            }
        }
    }

    async fn try_claim(&mut self, free: Room) -> Result<Attempt, JobError> {
        let PoolParts { store, engine, worker, settings, .. } = &self.parts;
        let (lease, max_run) = (settings.lease, settings.max_run);
        if settings.slots == Some(1) {
            // The only slot is free, so the next job can start whatever its demand is.
            let Some(leased) = store.claim_next(worker, lease, max_run).await? else { return Ok(Attempt::Nothing) };
            let computation = engine.restore(&leased.job.parameters);
            let room = self.capacity.need(Demand::UNKNOWN);
            let n_threads = self.capacity.n_threads(room, true);
            return Ok(Attempt::Claimed(Box::new(Claimed { leased, computation, room, n_threads })));
        }
        let waiting = store.front_of_queue(FRONT).await?;
        self.known.retain(|id, _| waiting.iter().any(|job| job.id == *id));
        let mut candidates = Vec::with_capacity(waiting.len());
        for job in &waiting {
            let known = self.known.entry(job.id).or_insert_with(|| Known::new(engine.as_ref(), job));
            candidates.push(Candidate { need: self.capacity.need(known.demand), waited: job.waited });
        }
        let positions = startable(free, &candidates, settings.patience);
        if positions.is_empty() {
            return Ok(Attempt::Nothing);
        }
        let jobs: Vec<_> = positions.iter().map(|&position| waiting[position].id).collect();
        let Some(leased) = store.claim_one_of(&jobs, worker, lease, max_run).await? else { return Ok(Attempt::Missed) };
        let position = waiting.iter().position(|job| job.id == leased.job.id);
        let room = position.map_or(self.capacity.budget, |position| candidates[position].need);
        let computation = match self.known.remove(&leased.job.id) {
            Some(known) => known.computation,
            None => engine.restore(&leased.job.parameters),
        };
        let is_alone = self.rooms.is_empty() && waiting.len() == 1;
        let n_threads = self.capacity.n_threads(room, is_alone);
        Ok(Attempt::Claimed(Box::new(Claimed { leased, computation, room, n_threads })))
    }

    fn start(&mut self, claimed: Claimed) {
        let Claimed { leased, computation, room, n_threads } = claimed;
        let parts = self.parts.clone();
        let running = self.running.spawn(async move {
            execute(&parts, leased, computation, n_threads).await;
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

    /// Waits until a job ends, one is queued, or `at_most` has passed.
    async fn pause(&mut self, at_most: Duration) {
        tokio::select! {
            () = self.parts.stop.cancelled() => {}
            () = self.parts.signals.queued.notified() => {}
            Some(ended) = self.running.join_next_with_id() => self.free(ended),
            () = tokio::time::sleep(at_most) => {}
        }
    }
}
