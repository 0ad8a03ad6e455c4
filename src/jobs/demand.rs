//! The predicted demand of a job for cores and memory.
//!
//! Predictions only decide when a job starts and on how many threads; the result is the same however wrong they are.

use super::job::JobId;
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
}

impl Demand {
    /// The demand of a job that cannot be predicted: it gets the machine for itself.
    pub const UNKNOWN: Demand = Demand { cores: usize::MAX, memory_bytes: 0 };
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
