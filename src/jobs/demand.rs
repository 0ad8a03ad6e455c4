//! What a job takes of the machine that computes it, as predicted before it begins.
//!
//! Predictions decide only when a job starts and on how many threads; its result is the same however wrong they are.

use super::job::JobId;
use serde::Deserialize;
use serde_json::Value;
use std::time::Duration;

/// How large a surface is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub struct SurfaceSize {
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
}

/// What computing a job is predicted to take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Demand {
    /// Cores that make it end sooner in proportion; at least 1, and more than a machine has means all of them.
    pub cores: usize,
    /// Memory at its peak, bytes.
    pub memory_bytes: u64,
}

impl Demand {
    /// Of a job of which nothing can be said: it has the machine for itself.
    pub const UNKNOWN: Demand = Demand { cores: usize::MAX, memory_bytes: 0 };
}

/// A job that waits, as far as it matters for when it starts and where.
#[derive(Debug, Clone, PartialEq)]
pub struct WaitingJob {
    /// Identity.
    pub id: JobId,
    /// Effective parameters.
    pub parameters: Value,
    /// The surface that moves.
    pub source: SurfaceSize,
    /// The surface that stays.
    pub target: SurfaceSize,
    /// For how long it could have started, by the database's clock.
    pub waited: Duration,
}
