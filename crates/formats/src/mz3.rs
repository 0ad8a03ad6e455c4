//! MZ3, the format of Surf Ice: little-endian, one header, triangles and vertices in single precision; usually gzip.
//!
//! Source: the description of the format in the repository of Surf Ice. Colors, scalars and further layers are skipped.

use super::budget::Budget;
use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons, points_of};
use super::text::Scanner;
use super::{FormatError, ReadLimits};

const HEADER_BYTES: usize = 16;
const HAS_FACES: u16 = 1;
const HAS_VERTICES: u16 = 2;
/// Attributes defined by the format.
const KNOWN: u16 = 0x3f;

/// Whether `bytes` begin like an MZ3 file. Windows programs begin with the same two letters.
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
    let budget = Budget::of(limits);
    let points = scanner.take(n_vertices * 3, 4, "the list of vertices")?;
    let points = Element::F32.charged_reals(points, ByteOrder::Little, &budget)?;
    check_rest(attributes(bytes), n_vertices, scanner.remaining() as u64)?;
    let mut polygons = Polygons::of(points_of(&points, &budget)?, &budget);
    for face in Element::I32.charged_wholes(corners, ByteOrder::Little, &budget)?.chunks_exact(3) {
        polygons.push(face.iter().copied())?;
    }
    polygons.into_mesh()
}

/// Checks the bytes after the vertices against the announced attributes: colors of 4 bytes and scalars of 4 or 8 bytes
/// per vertex, the scalars in any number of layers.
fn check_rest(attributes: u16, n_vertices: u64, rest: u64) -> Result<(), FormatError> {
    const HAS_COLORS: u16 = 4;
    const HAS_SCALARS: u16 = 8 | 16;
    let colors = if attributes & HAS_COLORS > 0 { 4 * n_vertices } else { 0 };
    let layers = rest.saturating_sub(colors);
    let fits = if attributes & HAS_SCALARS > 0 {
        layers.is_multiple_of((4 * n_vertices).max(1))
    } else {
        // Data of attributes defined later may follow.
        layers == 0 || attributes & !(HAS_FACES | HAS_VERTICES | HAS_COLORS) > 0
    };
    let what = "colors and scalars after the vertices";
    if fits { Ok(()) } else { Err(FormatError::Overlong { what, stated: colors, found: rest }) }
}
