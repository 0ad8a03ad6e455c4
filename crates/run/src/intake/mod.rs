//! From the bytes of an uploaded file to a closed genus-0 surface, or a refusal that says where and why.
//!
//! [`prepare_surface`] reads, makes a surface, repairs it as far as the parameters allow and judges what came out;
//! [`inspect`] does the same and tells everything it saw instead of refusing. Neither repeats text of the file or its
//! name: both may name a patient.

mod candidate;
mod error;
mod inspection;

pub use error::{Advice, IntakeError};
pub use homolog_contract::input::{
    InputFormat, InputKind, InputReport, Inspection, LabelCount, Refusal, RepairNote, VolumeInspection,
};
pub use inspection::inspect;

use candidate::Candidate;
use homolog_contract::parameters::{InputParameters, Repair};
use homolog_formats::{FileContent, FormatError, ReadLimits};
use homolog_mesh::SurfaceMesh;

/// A surface that is ready to be matched: closed, manifold, oriented outwards, of genus 0.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedSurface {
    /// The surface, mm.
    pub mesh: SurfaceMesh,
    /// The uploaded mesh's own numbering; `None` where `mesh` already has it, or where a volume was uploaded.
    pub uploaded: Option<UploadedNumbering>,
    /// What the input was and what was done to it.
    pub report: InputReport,
}

/// A repaired surface in the numbering of the mesh as it was uploaded.
#[derive(Debug, Clone, PartialEq)]
pub struct UploadedNumbering {
    /// For every vertex of the repaired surface its index in the uploaded mesh (the first of those welded).
    pub vertex: Vec<u32>,
    /// The repaired faces over all uploaded vertices, those that no face uses any more included.
    pub surface: SurfaceMesh,
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
    /// Most memory that one match may take, bytes; it grows with the product of both sizes.
    pub max_match_bytes: u64,
}

/// What one match may take unless somebody says otherwise: surfaces of some 12,000 vertices each.
pub const DEFAULT_MATCH_BYTES: u64 = 8 << 30;

impl Default for IntakeLimits {
    fn default() -> Self {
        IntakeLimits {
            max_bytes: 256 << 20,
            max_inflated_bytes: 1 << 30,
            max_vertices: 200_000,
            max_match_bytes: DEFAULT_MATCH_BYTES,
        }
    }
}

/// Reads `bytes`, makes a surface of it, repairs it as far as `parameters` allow, and refuses what is then not a
/// closed manifold of genus 0. `file_name` helps only where the bytes alone do not tell the format.
///
/// # Errors
/// [`IntakeError`].
///
/// # Cost
/// Linear in the file; filling a label volume adds `O(n log n)` in the box around the structure.
pub fn prepare_surface(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<PreparedSurface, IntakeError> {
    let (format, content) = read(bytes, file_name, limits)?;
    let candidate = Candidate::from_content(&content, parameters, limits)?;
    if let Some(refusal) = candidate.refusal(&content, parameters, limits) {
        return Err(refusal);
    }
    let Candidate { mesh, uploaded_vertex, topology, repairs, turned_outward, .. } = candidate;
    let report = InputReport { format, topology, repairs, turned_outward };
    let uploaded = match (uploaded_vertex, &content) {
        (Some(vertex), FileContent::Mesh(file)) => {
            let indices = mesh.indices().iter().map(|&k| vertex[k as usize]).collect();
            let surface = SurfaceMesh::new(file.mesh.vertices().to_vec(), mesh.arity(), indices)
                .map_err(|e| IntakeError::Unreadable(e.into()))?;
            Some(UploadedNumbering { vertex, surface })
        }
        _ => None,
    };
    Ok(PreparedSurface { mesh, uploaded, report })
}

fn read(
    bytes: &[u8],
    file_name: Option<&str>,
    limits: &IntakeLimits,
) -> Result<(InputFormat, FileContent), IntakeError> {
    if bytes.len() > limits.max_bytes {
        let (found, limit) = (bytes.len() as u64, limits.max_bytes as u64);
        return Err(IntakeError::TooLarge { what: "bytes", found, limit });
    }
    if bytes.is_empty() {
        return Err(IntakeError::Unreadable(FormatError::Empty));
    }
    let read_limits = ReadLimits { max_inflated_bytes: limits.max_inflated_bytes, max_vertices: limits.max_vertices };
    homolog_formats::read(bytes, file_name, &read_limits).map_err(|error| match error {
        FormatError::UnknownFormat => IntakeError::UnknownFormat,
        FormatError::TooLarge { what, found, limit } => IntakeError::TooLarge { what, found, limit },
        error => IntakeError::Unreadable(error),
    })
}

/// The name of a repair in JSON.
fn repair_name(repair: Repair) -> &'static str {
    match repair {
        Repair::Weld => "weld",
        Repair::LargestComponent => "largest_component",
        Repair::Fill => "fill",
    }
}
