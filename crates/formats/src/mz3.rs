//! MZ3, the format of Surf Ice: little-endian, one header, triangles and vertices in single precision; usually gzip.
//!
//! Source: the description of the format in the repository of Surf Ice. Colors, scalars and further layers are skipped.

use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::{FormatError, ReadLimits};
use nalgebra::Point3;

const HEADER_BYTES: usize = 16;
const HAS_FACES: u16 = 1;
const HAS_VERTICES: u16 = 2;
/// The attributes that the format defines.
const KNOWN: u16 = 0x3f;

/// Whether these are the first bytes of an MZ3 file. Programs of Windows begin with the same two letters.
pub(super) fn is_mz3(bytes: &[u8]) -> bool {
    bytes.starts_with(b"MZ") && bytes.len() >= HEADER_BYTES && attributes(bytes) <= KNOWN && attributes(bytes) > 0
}

fn attributes(bytes: &[u8]) -> u16 {
    u16::from_le_bytes([bytes[2], bytes[3]])
}

/// Reads a mesh of triangles.
///
/// # Errors
/// [`FormatError`]; a file of scalars or colors alone is not a surface.
///
/// # Cost
/// Linear in the file's length.
pub fn read_mz3(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let available = bytes.len() as u64;
    if bytes.len() < HEADER_BYTES {
        return Err(FormatError::Truncated { part: "the MZ3 header", needed: HEADER_BYTES as u64, available });
    }
    if attributes(bytes) & (HAS_FACES | HAS_VERTICES) != HAS_FACES | HAS_VERTICES {
        return Err(FormatError::Unsupported {
            what: "an MZ3 file without vertices and faces",
            advice: "send the surface to which its values belong",
        });
    }
    let mut scanner = Scanner::new(&bytes[4..]);
    let counts = Element::U32.wholes(scanner.take(3, 4, "the MZ3 header")?, ByteOrder::Little);
    let [n_faces, n_vertices, skip] = [counts[0] as u64, counts[1] as u64, counts[2] as u64];
    Polygons::check_count(n_vertices, limits)?;
    Polygons::check_faces(n_faces, limits)?;
    scanner.take(skip, 1, "what the MZ3 header says is skipped")?;
    let corners = scanner.take(n_faces.saturating_mul(3), 4, "the list of faces")?;
    let points = Element::F32.reals(scanner.take(n_vertices * 3, 4, "the list of vertices")?, ByteOrder::Little);
    let vertices = points.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2])).collect();
    let mut polygons = Polygons::of(vertices);
    for face in Element::I32.wholes(corners, ByteOrder::Little).chunks_exact(3) {
        polygons.push(face.iter().copied())?;
    }
    polygons.into_mesh()
}
