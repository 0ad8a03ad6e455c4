//! FreeSurfer surfaces (`lh.pial`, `rh.white`, ...): binary triangles, both kinds of binary quads, and ASCII (`.asc`).
//!
//! Source: FreeSurfer's `mrisurf_io` and the description of its file formats. Binary files are big-endian; what follows the
//! faces (the geometry of the volume, the command line) is not read. Coordinates stay as they are: FreeSurfer's surface RAS
//! ("tkregister"), whose origin is the center of the conformed volume. The quads of the old format are split as FreeSurfer
//! splits them, by the parity of their first vertex.

use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::{FormatError, ReadLimits};
use nalgebra::Point3;

const TRIANGLES: [u8; 3] = [0xff, 0xff, 0xfe];
/// Quads with coordinates in hundredths of a millimetre.
const QUADS: [u8; 3] = [0xff, 0xff, 0xff];
/// Quads with coordinates in single precision.
const NEW_QUADS: [u8; 3] = [0xff, 0xff, 0xfd];
const ASCII: &[u8] = b"#!ascii";

/// Whether these are the first bytes of a surface.
pub(super) fn is_freesurfer(bytes: &[u8]) -> bool {
    // A patch begins with four such bytes; no surface has as many vertices as its fourth would then mean.
    let is_patch = bytes.starts_with(&[0xff; 4]);
    let is_binary = [&TRIANGLES, &QUADS, &NEW_QUADS].iter().any(|magic| bytes.starts_with(*magic));
    is_binary && !is_patch || bytes.starts_with(ASCII)
}

/// Reads a mesh of triangles.
///
/// # Errors
/// [`FormatError`]; per-vertex values (`lh.thickness`, `lh.curv`) are not surfaces.
///
/// # Cost
/// Linear in the file's length.
pub fn read_freesurfer(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let polygons = match bytes.first_chunk::<3>() {
        _ if bytes.starts_with(ASCII) => ascii(bytes, limits)?,
        Some(&TRIANGLES) => triangles(bytes, limits)?,
        Some(&QUADS) if is_curvature(bytes) => {
            return Err(FormatError::Unsupported {
                what: "a FreeSurfer file of per-vertex values",
                advice: "send the surface to which they belong, such as lh.pial or lh.white",
            });
        }
        Some(&QUADS) => quads(bytes, Element::I16, 0.01, limits)?,
        Some(&NEW_QUADS) => quads(bytes, Element::F32, 1.0, limits)?,
        _ => return Err(FormatError::Payload { format: "FreeSurfer", line: None }),
    };
    let mut file = polygons.into_mesh()?;
    let note = "coordinates are FreeSurfer's surface RAS (tkregister), as stored; scanner RAS differs by the c_ras of the volume";
    file.space = homolog_contract::input::InputSpace::FreesurferRas;
    file.notes.push(note.to_owned());
    Ok(file)
}

/// Whether this is a file of values in the newer format, which begins like the old quads: three counts of four bytes each
/// and one number for each vertex and value.
fn is_curvature(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes.get(3..).unwrap_or_default());
    let Ok(counts) = scanner.take(3, 4, "the counts") else { return false };
    let counts = Element::U32.wholes(counts, ByteOrder::Big);
    scanner.remaining() as u64 == (counts[0] as u64).saturating_mul(counts[2] as u64).saturating_mul(4)
}

fn triangles(bytes: &[u8], limits: &ReadLimits) -> Result<Polygons, FormatError> {
    let mut scanner = Scanner::new(bytes.get(3..).unwrap_or_default());
    // Two lines of free text: who made the file and when. Usually the second is empty.
    scanner.line();
    scanner.line();
    let counts = Element::I32.wholes(scanner.take(2, 4, "the counts of vertices and faces")?, ByteOrder::Big);
    let [n_vertices, n_faces] = [counts[0], counts[1]].map(|n| u64::try_from(n).unwrap_or(u64::MAX));
    Polygons::check_faces(n_faces, limits)?;
    let mut polygons = Polygons::default();
    points(&mut polygons, &mut scanner, n_vertices, Element::F32, 1.0, limits)?;
    let corners = scanner.take(n_faces.saturating_mul(3), 4, "the list of faces")?;
    for face in Element::I32.wholes(corners, ByteOrder::Big).chunks_exact(3) {
        polygons.push(face.iter().copied())?;
    }
    Ok(polygons)
}

fn points(
    polygons: &mut Polygons,
    scanner: &mut Scanner<'_>,
    n: u64,
    element: Element,
    scale: f64,
    limits: &ReadLimits,
) -> Result<(), FormatError> {
    let raw = scanner.take(n.saturating_mul(3), element.size(), "the list of vertices")?;
    Polygons::check_count(n, limits)?;
    let numbers = element.reals(raw, ByteOrder::Big);
    polygons.vertices = numbers.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2]) * scale).collect();
    Ok(())
}

fn quads(bytes: &[u8], element: Element, scale: f64, limits: &ReadLimits) -> Result<Polygons, FormatError> {
    let mut scanner = Scanner::new(bytes.get(3..).unwrap_or_default());
    let three = |b: &[u8]| i64::from(b[0]) << 16 | i64::from(b[1]) << 8 | i64::from(b[2]);
    let counts = scanner.take(2, 3, "the counts of vertices and faces")?;
    let [n_vertices, n_faces] = [three(counts), three(&counts[3..])];
    Polygons::check_faces(n_faces as u64, limits)?;
    let mut polygons = Polygons::default();
    points(&mut polygons, &mut scanner, n_vertices as u64, element, scale, limits)?;
    for quad in scanner.take(n_faces as u64, 12, "the list of faces")?.chunks_exact(12) {
        let [a, b, c, d] = [0, 3, 6, 9].map(|at| three(&quad[at..]));
        let halves = if a % 2 == 0 { [[a, b, d], [c, d, b]] } else { [[a, b, c], [a, c, d]] };
        halves.into_iter().try_for_each(|triangle| polygons.push(triangle))?;
    }
    Ok(polygons)
}

/// A comment, the two counts, then a line for each vertex (three coordinates) and each face (three indices), each with a
/// further number that says whether it belongs to a patch.
fn ascii(bytes: &[u8], limits: &ReadLimits) -> Result<Polygons, FormatError> {
    let mut scanner = Scanner::new(bytes);
    scanner.line();
    let n_vertices: u64 = scanner.number("the number of vertices")?;
    let n_faces: u64 = scanner.number("the number of faces")?;
    Polygons::check_count(n_vertices, limits)?;
    Polygons::check_faces(n_faces, limits)?;
    let mut polygons = Polygons::default();
    for _ in 0..n_vertices {
        let mut p = Point3::origin();
        for c in p.iter_mut() {
            *c = scanner.number("a coordinate")?;
        }
        scanner.number::<f64>("the patch number of a vertex")?;
        polygons.vertices.push(p);
    }
    for _ in 0..n_faces {
        let mut face = [0i64; 3];
        for corner in &mut face {
            *corner = scanner.number("a vertex index")?;
        }
        scanner.number::<f64>("the patch number of a face")?;
        polygons.push(face)?;
    }
    Ok(polygons)
}
