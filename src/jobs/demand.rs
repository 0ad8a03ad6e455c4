//! The predicted demand of a job for cores, memory and processor time.
//!
//! Predictions only decide whether a job is accepted, when it starts and on how many threads; the result is the same however wrong
//! they are.

use super::ids::JobId;
use serde::Deserialize;
use serde_json::Value;
use std::time::Duration;

/// The size of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub struct SurfaceSize {
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
}

/// The predicted demand of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Demand {
    /// Number of cores up to which its run time decreases about in proportion; at least 1. If the machine has fewer, it gets
    /// all of them.
    pub cores: usize,
    /// Peak memory, bytes.
    pub memory_bytes: u64,
    /// Processor time on all cores together; zero if it cannot be predicted.
    pub processor_time: Duration,
}

impl Demand {
    /// The demand of a job that cannot be predicted: it gets the machine for itself.
    pub const UNKNOWN: Demand = Demand { cores: usize::MAX, memory_bytes: 0, processor_time: Duration::ZERO };

    /// The predicted run time where a job gets at most `most_cores`, ms; `None` if it cannot be predicted.
    pub fn run_ms(&self, most_cores: usize) -> Option<u64> {
        let cores = u32::try_from(self.cores.min(most_cores).max(1)).unwrap_or(u32::MAX);
        (!self.processor_time.is_zero())
            .then(|| u64::try_from((self.processor_time / cores).as_millis()).unwrap_or(u64::MAX))
    }
}

/// A queued job, as far as it matters for where and when it starts.
#[derive(Debug, Clone, PartialEq)]
pub struct WaitingJob {
    /// Identity.
    pub id: JobId,
    /// Effective parameters as JSON, for [`super::Engine::restore`]; they never change.
    pub parameters: Value,
    /// The surface that is moved.
    pub source: SurfaceSize,
    /// The surface that stays fixed.
    pub target: SurfaceSize,
    /// For how long it has been waiting, by the database's clock.
    pub waited: Duration,
}
