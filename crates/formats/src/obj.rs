//! Wavefront OBJ: vertices and polygons; normals, textures, groups, lines and materials are skipped.
//!
//! Source: "Object Files (.obj)", Advanced Visualizer manual, appendix B1. Indices count from 1, or from the last vertex
//! backwards if negative. Statements that are not known are skipped, as other readers do. (MNI `.obj` files are another
//! format under the same ending.)

use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::{FormatError, ReadLimits};
use nalgebra::Point3;

/// Statements with which a file may begin.
const STATEMENTS: [&[u8]; 10] = [b"v", b"vt", b"vn", b"vp", b"f", b"g", b"o", b"s", b"mtllib", b"usemtl"];

/// Whether this text begins with a statement of the format, after comments.
pub(super) fn is_obj(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes);
    while let Some(line) = scanner.line() {
        if line.contains(&0) {
            return false;
        }
        match words(line).next() {
            None => {}
            Some(word) if word.starts_with(b"#") || word.starts_with(b"$") => {}
            Some(word) => return STATEMENTS.contains(&word),
        }
    }
    false
}

fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise polygons are split into triangles.
///
/// # Errors
/// [`FormatError`].
///
/// # Cost
/// Linear in the file's length.
pub fn read_obj(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let mut polygons = Polygons::default();
    let mut faces: Vec<i64> = Vec::new();
    let mut ends = Vec::new();
    let mut joined = Vec::new();
    while let Some(line) = scanner.line() {
        joined.clear();
        let mut line = line;
        // A line that ends in a backslash goes on in the next.
        while let Some(part) = line.strip_suffix(b"\\") {
            joined.extend_from_slice(part);
            joined.push(b' ');
            line = scanner.line().unwrap_or_default();
        }
        joined.extend_from_slice(line);
        let mut words = words(&joined);
        match words.next() {
            Some(b"v") => {
                let mut p = Point3::origin();
                for c in p.iter_mut() {
                    let number = words.next().and_then(|w| std::str::from_utf8(w).ok()).and_then(|w| w.parse().ok());
                    *c = number.ok_or_else(|| scanner.expected_before("a coordinate"))?;
                }
                polygons.vertices.push(p);
                Polygons::check_count(polygons.vertices.len() as u64, limits)?;
            }
            Some(b"f") => {
                for word in words {
                    // vertex/texture/normal
                    let index = word.split(|&b| b == b'/').next().and_then(|w| std::str::from_utf8(w).ok());
                    let index: Option<i64> = index.and_then(|w| w.parse().ok()).filter(|&index| index != 0);
                    let index = index.ok_or_else(|| scanner.expected_before("a vertex index other than 0"))?;
                    let n = polygons.vertices.len() as i64;
                    faces.push(if index > 0 { index - 1 } else { n.saturating_add(index) });
                }
                ends.push(faces.len());
                Polygons::check_faces(ends.len() as u64, limits)?;
            }
            _ => {}
        }
    }
    // Faces may come before the vertices that they use.
    let mut start = 0;
    for end in ends {
        polygons.push(faces[start..end].iter().copied())?;
        start = end;
    }
    polygons.into_mesh()
}
