//! How long a job will run, for clients that see it wait or begin.

use super::demand::SurfaceSize;
use super::engine::Engine;
use super::ids::JobId;
use super::job::{Job, JobInput};
use super::state::JobState;
use parking_lot::Mutex;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Jobs whose run times are kept, at most: a poll then reads no parameters again.
const MOST_KEPT: usize = 4096;

/// Predicts run times from parameters and sizes of surfaces.
#[derive(Clone)]
pub(super) struct Forecast {
    engine: Arc<dyn Engine>,
    /// Most cores that a job gets.
    cores: usize,
    /// Run times by job, ms; the parameters of a job never change.
    kept: Arc<Mutex<BTreeMap<JobId, Option<u64>>>>,
}

impl Forecast {
    pub(super) fn new(engine: Arc<dyn Engine>, cores: usize) -> Self {
        Forecast { engine, cores, kept: Arc::default() }
    }

    /// `job` with its expected run time, where nothing better is known yet. `O(parameters)`.
    pub(super) fn of(&self, job: Job) -> Job {
        let is_open = match job.state {
            JobState::Queued => true,
            JobState::Running => job.progress.as_ref().is_none_or(|progress| !progress.tells_time()),
            _ => false,
        };
        let expected_run_ms = if is_open { self.run_ms(&job) } else { None };
        Job { expected_run_ms, ..job }
    }

    fn run_ms(&self, job: &Job) -> Option<u64> {
        if let Some(known) = self.kept.lock().get(&job.id) {
            return *known;
        }
        let predicted = self.predicted_ms(job);
        let mut kept = self.kept.lock();
        kept.insert(job.id, predicted);
        if kept.len() > MOST_KEPT {
            // Ids are ordered by time.
            kept.pop_first();
        }
        predicted
    }

    fn predicted_ms(&self, job: &Job) -> Option<u64> {
        let size = |input: &JobInput| SurfaceSize { n_vertices: input.n_vertices, n_faces: input.n_faces };
        let computation = self.engine.restore(&job.parameters).ok()?;
        computation.demand(size(&job.source), size(&job.target)).run_ms(self.cores)
    }
}
