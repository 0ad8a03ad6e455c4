//! Readers and writers of meshes and label volumes, one module per format, and writers of the results of a match: pairs of
//! vertices as tables ([`npy`], [`arrow`]), per-vertex values with their mesh, and transforms ([`transform`]).
//!
//! Input is untrusted. Readers take the whole file as a slice, and [`ReadLimits`]; counts in a header are checked against
//! the length of the file before anything is allocated, so a small file cannot cause a large allocation or a long
//! computation. Compressed files are decompressed to their end, and every checksum is verified. [`read`] detects the format
//! from the bytes and uses the file's name only where they do not decide. Errors carry positions (lines, vertices,
//! voxels), never text of the file, which may name a patient.

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

pub use error::{FormatError, GzipFault};
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

/// Bounds on the size of what is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReadLimits {
    /// Largest size after decompression, bytes; also the most memory that the labels of a volume may take.
    pub max_inflated_bytes: usize,
    /// Most vertices of a mesh.
    pub max_vertices: usize,
}

impl Default for ReadLimits {
    fn default() -> Self {
        ReadLimits { max_inflated_bytes: 1 << 30, max_vertices: 200_000 }
    }
}

/// The content of a file.
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
/// [`FormatError::UnknownFormat`] if it is none of them; [`FormatError::Gzip`] if the compressed stream is damaged or
/// incomplete; else those of the format's reader.
///
/// # Cost
/// Linear in the inflated size.
pub fn read(
    bytes: &[u8],
    file_name: Option<&str>,
    limits: &ReadLimits,
) -> Result<(InputFormat, FileContent), FormatError> {
    let head = gzip::unverified_prefix(bytes, nifti::HEADER_BYTES)?;
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

/// The decompressed bytes of a file, borrowed if it was not compressed.
type Plain<'a> = Cow<'a, [u8]>;

#[cfg(test)]
mod export_tests;
#[cfg(test)]
mod gzip_tests;
#[cfg(test)]
mod tests;
