//! Progress and energy trace of a running job, numbered and timed.

use homolog_primitives::observe::{Phase, TracePoint};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A point of the energy trace with its number and time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct NumberedPoint {
    /// From 1, without a gap. Computation is deterministic: a rerun gives the same points the same numbers.
    pub seq: u64,
    /// The point.
    #[serde(flatten)]
    pub point: TracePoint,
    /// Time since the attempt began, ms.
    pub elapsed_ms: u64,
}

/// How far an attempt is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Progress {
    /// Share of the work that is done, `[0, 1]`; never goes back within an attempt.
    pub fraction: f64,
    /// Current phase of the computation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub phase: Option<Phase>,
    /// Iteration of the last trace point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub iteration: Option<u32>,
    /// One sentence for people.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// Energy of the last trace point that had one.
    #[serde(skip)]
    pub energy_latest: Option<f64>,
}

impl Progress {
    /// Whether enough is done to extrapolate the rest.
    pub fn tells_time(&self) -> bool {
        self.fraction >= 0.05
    }
}

/// A part of a trace that is stored at once: the points since the last chunk, and the progress.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceChunk {
    /// Points in order of `seq`; may be empty.
    pub points: Vec<NumberedPoint>,
    /// Progress at the last of them.
    pub progress: Progress,
}

/// A page of a trace.
#[derive(Debug, Clone, PartialEq)]
pub struct TracePage {
    /// Points in ascending order of `seq`, each once.
    pub points: Vec<NumberedPoint>,
    /// `after_seq` of the next page: the last `seq` here, or the requested one if this page is empty.
    pub next_after_seq: u64,
    /// Whether the job is finished and no point follows.
    pub complete: bool,
}
