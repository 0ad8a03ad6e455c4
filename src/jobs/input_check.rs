//! The outcomes of the check of an input: a summary of one that can be matched, the refusal of another.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// An input that can be matched.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputSummary {
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs.
    pub report: Value,
}

/// An input that cannot be matched.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputRefusal {
    /// Stable name of the problem.
    pub code: String,
    /// Description of the problem and of its place.
    pub detail: String,
    /// Topology of the refused surface.
    pub topology: Option<Value>,
    /// Where the first fault is, mm, if it is at one place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place_mm: Option<[f64; 3]>,
}
