//! From the bytes of an uploaded file to a closed genus-0 surface, or a refusal that says where and why.

use crate::matching::parameters::{InputParameters, Repair};
use crate::mesh::SurfaceMesh;
use crate::mesh::topology::TopologyReport;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A surface that is ready to be matched: closed, manifold, oriented outwards, of genus 0.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedSurface {
    /// The surface, mm.
    pub mesh: SurfaceMesh,
    /// For every vertex its index in the uploaded mesh (the first of those welded); `None`: indices are the mesh's own.
    pub uploaded_vertex: Option<Vec<u32>>,
    /// What the input was and what was done to it.
    pub report: InputReport,
}

/// What an input was, and what was done to it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct InputReport {
    /// The file's format.
    pub format: InputFormat,
    /// Topology of the surface before repairs.
    pub topology: TopologyReport,
    /// Repairs that changed something, in order.
    pub repairs: Vec<RepairNote>,
}

/// Formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum InputFormat {
    /// NIfTI-1 label volume, plain or gzip.
    Nifti,
    /// Stanford PLY.
    Ply,
    /// STL.
    Stl,
    /// Legacy VTK.
    Vtk,
}

/// A repair that changed something.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct RepairNote {
    /// Which repair.
    pub repair: Repair,
    /// What it changed, in one sentence with numbers.
    pub detail: String,
}

/// Bounds on what is read, so that no file can ask for more memory than the operator allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct IntakeLimits {
    /// Largest file, bytes, as uploaded.
    pub max_bytes: usize,
    /// Largest file, bytes, after decompression.
    pub max_inflated_bytes: usize,
    /// Most vertices of a surface.
    pub max_vertices: usize,
}

impl Default for IntakeLimits {
    fn default() -> Self {
        IntakeLimits { max_bytes: 256 << 20, max_inflated_bytes: 1 << 30, max_vertices: 200_000 }
    }
}

/// Why a file is refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntakeError {
    /// None of the formats that are read.
    #[error("the file is none of NIfTI-1, PLY, STL, legacy VTK")]
    UnknownFormat,
}

impl IntakeError {
    /// The stable name of this kind of refusal, used as problem type: `unknown-format`, `unreadable-file`,
    /// `too-large`, `empty-structure`, `unsuitable-surface`.
    pub fn code(&self) -> &'static str {
        match self {
            IntakeError::UnknownFormat => "unknown-format",
        }
    }

    /// The topology of the surface that was refused, where there was one.
    pub fn topology(&self) -> Option<&TopologyReport> {
        None
    }
}

/// Reads `bytes`, makes a surface of it, repairs it as far as `parameters` allow, and refuses what is then not a
/// closed manifold of genus 0. `file_name` helps only where the bytes alone do not tell the format.
///
/// # Errors
/// [`IntakeError`].
pub fn prepare_surface(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<PreparedSurface, IntakeError> {
    let _ = (bytes, file_name, parameters, limits);
    Err(IntakeError::UnknownFormat)
}
