//! From the bytes of an uploaded file to a surface that can be matched, or a refusal that says what is wrong and where.
//!
//! [`prepare_surface`] reads the file, makes a surface, repairs it as far as the parameters allow and checks the result;
//! [`inspect`] does the same and reports what it found instead of refusing. Neither repeats the file's name or text from
//! the file: both may name a patient.

mod candidate;
mod error;
mod inspection;
mod split;

pub use error::{Advice, IntakeError};
pub use homolog_contract::input::{InputFormat, InputKind, InputReport, Inspection};
pub use inspection::inspect;

use candidate::Candidate;
use homolog_contract::input::{LabelCount, Refusal, RepairNote, VolumeInspection};
use homolog_contract::parameters::{InputParameters, Repair};
pub use homolog_formats::DEFAULT_INFLATION;
use homolog_formats::{FileContent, FormatError, ReadFile, ReadLimits};
use homolog_mesh::{Numbering, SurfaceMesh};

/// A surface that is ready to be matched: its faces agree in orientation and look outwards.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedSurface {
    /// The surface, mm.
    pub mesh: SurfaceMesh,
    /// Which vertex of the upload each vertex of `mesh` is. For a label volume the upload is the surface made from it,
    /// which is `mesh` itself.
    pub numbering: Numbering,
    /// The faces of `mesh` over the vertices of the upload, where repairs dropped or merged some.
    restored: Option<SurfaceMesh>,
    /// What the input was and what was done to it.
    pub report: InputReport,
}

impl PreparedSurface {
    /// The surface whose vertices an answer counts: the faces that were matched, over all vertices of the upload,
    /// including those that no face uses any more.
    pub fn uploaded(&self) -> &SurfaceMesh {
        self.restored.as_ref().unwrap_or(&self.mesh)
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        let restored = self.restored.as_ref().map_or(0, SurfaceMesh::heap_bytes);
        self.mesh.heap_bytes() + self.numbering.heap_bytes() + restored
    }
}

/// Bounds on what is read, so that no file can demand more memory than the operator allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct IntakeLimits {
    /// Largest file as uploaded, bytes.
    pub max_bytes: usize,
    /// Largest file after decompression, bytes.
    pub max_inflated_bytes: usize,
    /// Largest file after decompression, as a multiple of the file as uploaded, above a mebibyte.
    pub max_inflation: usize,
    /// Most vertices of a surface.
    pub max_vertices: usize,
    /// Most memory that one match may take, bytes; it grows with the product of both sizes.
    pub max_match_bytes: u64,
}

/// The default of [`IntakeLimits::max_match_bytes`]: enough for two surfaces of about 12,000 vertices each.
pub const DEFAULT_MATCH_BYTES: u64 = 8 << 30;

impl Default for IntakeLimits {
    fn default() -> Self {
        IntakeLimits {
            max_bytes: 256 << 20,
            max_inflated_bytes: 1 << 30,
            max_inflation: DEFAULT_INFLATION,
            max_vertices: 200_000,
            max_match_bytes: DEFAULT_MATCH_BYTES,
        }
    }
}

/// Reads `bytes`, makes a surface, repairs it as far as `parameters` allow, and refuses the result if it has no
/// consistent orientation, is closed but encloses no volume, or has a boundary that they do not allow. `file_name` is used only where the bytes alone do not
/// determine the format.
///
/// # Errors
/// [`IntakeError`].
///
/// # Cost
/// Linear in the file; filling a label volume adds `O(n log n)` in the box around the structure. An unsuitable surface
/// costs up to four times as much, to find the repair to recommend.
pub fn prepare_surface(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<PreparedSurface, IntakeError> {
    let file = read(bytes, file_name, parameters, limits)?;
    let candidate = Candidate::from_file(&file, parameters, limits)?;
    if let Some(refusal) = candidate.refusal(&file, parameters, limits) {
        return Err(refusal);
    }
    let ReadFile { format, content, mut notes, .. } = file;
    let Candidate { mesh, numbering, added, topology, repairs, turned_outward, notes: of_repairs, .. } = candidate;
    notes.extend(of_repairs);
    let report = InputReport { format, topology, repairs, turned_outward, notes };
    let restored = match &content {
        // Repairs keep the order of vertices, so a mesh of as many vertices has the numbering of the file.
        FileContent::Mesh(file) if numbering.n_vertices() < file.mesh.n_vertices() + added.len() => {
            let mut vertices: Vec<_> = file.mesh.vertices().iter().copied().chain(added).collect();
            // Closing a tunnel moves some.
            for (&original, place) in numbering.originals().iter().zip(mesh.vertices()) {
                vertices[original as usize] = *place;
            }
            let restored = numbering.restored(&mesh, &vertices);
            Some(restored.map_err(|e| IntakeError::Unreadable(e.into()))?)
        }
        _ => None,
    };
    Ok(PreparedSurface { mesh, numbering, restored, report })
}

fn read(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<ReadFile, IntakeError> {
    if bytes.len() > limits.max_bytes {
        let (found, limit) = (bytes.len() as u64, limits.max_bytes as u64);
        return Err(IntakeError::TooLarge { what: "bytes", found, limit });
    }
    if bytes.is_empty() {
        return Err(IntakeError::Unreadable(FormatError::Empty));
    }
    let IntakeLimits { max_inflated_bytes, max_inflation, max_vertices, .. } = *limits;
    let read_limits = ReadLimits { max_inflated_bytes, max_inflation, max_vertices };
    homolog_formats::read_with(bytes, file_name, &read_limits, parameters.fraction).map_err(|error| match error {
        FormatError::UnknownFormat => IntakeError::UnknownFormat,
        FormatError::TooLarge { what, found, limit } => IntakeError::TooLarge { what, found, limit },
        error => IntakeError::Unreadable(error),
    })
}

/// The name of a repair in JSON.
fn repair_name(repair: Repair) -> &'static str {
    match repair {
        Repair::Weld => "weld",
        Repair::Orient => "orient",
        Repair::Split => "split",
        Repair::LargestComponent => "largest_component",
        Repair::Fill => "fill",
        Repair::Triangulate => "triangulate",
        Repair::Simplify => "simplify",
    }
}

/// `n` and its noun, in the singular or the plural.
fn counted(n: u64, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
