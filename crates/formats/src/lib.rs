//! Untrusted bytes to meshes and label volumes, and back; a file a format. What a match leaves is written besides: pairs
//! of vertices as tables ([`npy`], [`arrow`]), values of vertices beside their mesh, and transforms ([`transform`]).
//!
//! Readers take the whole file as a slice and [`ReadLimits`]. No allocation trusts a count that the length of the
//! file does not back, so a small file cannot ask for much memory or time. [`read`] detects the format
//! from the bytes; the file's name helps only where they do not tell. Errors carry places (lines, vertices, voxels),
//! never text of the file, which may name a patient.

mod error;
mod gzip;
mod pairs;
mod polygons;
mod text;
mod vertex_arrays;

pub mod arrow;
pub mod gifti;
pub mod nifti;
pub mod npy;
pub mod ply;
pub mod stl;
pub mod transform;
pub mod vtk;

pub use error::FormatError;
pub use homolog_contract::input::InputFormat;
pub use nifti::{write_nifti, write_nifti_gz};
pub use pairs::PairColumns;
pub use ply::write_ply;
pub use polygons::MeshFile;
pub use stl::write_stl;
pub use vertex_arrays::{VertexArray, VertexValues};
pub use vtk::write_vtk;

use homolog_mesh::volume::LabelVolume;
use std::borrow::Cow;

/// Bounds on what a reader makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReadLimits {
    /// Largest file after decompression, bytes; also the most memory that the labels of a volume may take.
    pub max_inflated_bytes: usize,
    /// Most vertices of a mesh.
    pub max_vertices: usize,
}

impl Default for ReadLimits {
    fn default() -> Self {
        ReadLimits { max_inflated_bytes: 1 << 30, max_vertices: 200_000 }
    }
}

/// What a file held.
#[derive(Debug, Clone, PartialEq)]
pub enum FileContent {
    /// A label volume.
    Labels(LabelVolume),
    /// A surface mesh.
    Mesh(MeshFile),
}

/// Reads a file of any of the [`InputFormat`]s, plain or compressed with gzip.
///
/// # Errors
/// [`FormatError::UnknownFormat`] if it is none of them; else what the format's reader says.
///
/// # Cost
/// Linear in the inflated size.
pub fn read(
    bytes: &[u8],
    file_name: Option<&str>,
    limits: &ReadLimits,
) -> Result<(InputFormat, FileContent), FormatError> {
    let head = gzip::inflated_head(bytes, nifti::HEADER_BYTES)?;
    if nifti::is_nifti(&head) {
        return Ok((InputFormat::Nifti, FileContent::Labels(nifti::read_nifti(bytes, limits)?)));
    }
    let bytes = gzip::inflate(bytes, limits.max_inflated_bytes)?;
    let format = detect(&bytes, file_name).ok_or(FormatError::UnknownFormat)?;
    let content = match format {
        InputFormat::Nifti => FileContent::Labels(nifti::read_nifti(&bytes, limits)?),
        InputFormat::Ply => FileContent::Mesh(ply::read_ply(&bytes, limits)?),
        InputFormat::Stl => FileContent::Mesh(stl::read_stl(&bytes, limits)?),
        InputFormat::Vtk => FileContent::Mesh(vtk::read_vtk(&bytes, limits)?),
    };
    Ok((format, content))
}

/// The format of a file (not compressed): by its first bytes, else by its name.
fn detect(bytes: &[u8], file_name: Option<&str>) -> Option<InputFormat> {
    let starts = |magic: &str| bytes.get(..magic.len()).is_some_and(|head| head.eq_ignore_ascii_case(magic.as_bytes()));
    if nifti::is_nifti(bytes) {
        Some(InputFormat::Nifti)
    } else if starts("ply\n") || starts("ply\r") {
        Some(InputFormat::Ply)
    } else if starts("# vtk DataFile") {
        Some(InputFormat::Vtk)
    } else if stl::is_stl(bytes) {
        Some(InputFormat::Stl)
    } else {
        format_of_name(file_name?)
    }
}

fn format_of_name(name: &str) -> Option<InputFormat> {
    let name = name.to_ascii_lowercase();
    let name = name.strip_suffix(".gz").unwrap_or(&name);
    match name.rsplit_once('.')?.1 {
        "nii" => Some(InputFormat::Nifti),
        "ply" => Some(InputFormat::Ply),
        "stl" => Some(InputFormat::Stl),
        "vtk" => Some(InputFormat::Vtk),
        _ => None,
    }
}

/// Plain bytes of a file that may be compressed.
type Plain<'a> = Cow<'a, [u8]>;

#[cfg(test)]
mod export_tests;
#[cfg(test)]
mod tests;
