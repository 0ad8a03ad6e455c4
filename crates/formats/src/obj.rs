//! Wavefront OBJ: vertices and polygons; normals, textures, groups, lines and materials are skipped.
//!
//! Source: "Object Files (.obj)", Advanced Visualizer manual, appendix B1. Indices count from 1, or backwards from the
//! last vertex if negative. A comment begins with `#` and may follow a statement. Unknown statements are skipped, as in
//! other readers. A unit stated in a comment is applied. (MNI `.obj` files are a different format with the same
//! extension.)

use super::budget::Budget;
use super::polygons::{MeshFile, Polygons};
use super::text::{Scanner, real, whole, words};
use super::{FormatError, ReadLimits, units};
use nalgebra::Point3;

/// Statements of the format.
const STATEMENTS: [&[u8]; 40] = [
    b"v",
    b"vt",
    b"vn",
    b"vp",
    b"cstype",
    b"deg",
    b"bmat",
    b"step",
    b"p",
    b"l",
    b"f",
    b"fo",
    b"curv",
    b"curv2",
    b"surf",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"g",
    b"s",
    b"mg",
    b"o",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"usemtl",
    b"mtllib",
    b"usemap",
    b"maplib",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"call",
    b"csh",
];

/// Whether the text begins with a statement of the format, after comments.
pub(super) fn is_obj(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes);
    while let Some(line) = scanner.text_line() {
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

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise polygons are split into triangles.
///
/// # Errors
/// [`FormatError`].
///
/// # Cost
/// Linear in the file's length.
pub fn read_obj(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let budget = Budget::of(limits);
    let mut polygons = Polygons::new(&budget);
    let mut faces: Vec<i64> = Vec::new();
    let mut ends = Vec::new();
    let mut joined = Vec::new();
    let mut unit = None;
    while let Some(line) = scanner.text_line() {
        joined.clear();
        let mut line = line;
        // A line that ends in a backslash continues in the next.
        while let Some(part) = line.strip_suffix(b"\\") {
            budget.extend(&mut joined, part)?;
            budget.push(&mut joined, b' ')?;
            line = scanner.text_line().unwrap_or_default();
        }
        budget.extend(&mut joined, line)?;
        if joined.starts_with(b"#") {
            unit = unit.or_else(|| units::stated_in(&joined));
            continue;
        }
        let statement = before_comment(&joined);
        let mut words = words(statement);
        match words.next() {
            Some(b"v") => {
                let mut p = Point3::origin();
                for c in p.iter_mut() {
                    *c = words.next().and_then(real).ok_or_else(|| scanner.expected_before("a coordinate"))?;
                }
                polygons.vertex(p)?;
                Polygons::check_count(polygons.vertices.len() as u64, limits)?;
            }
            Some(b"f") => {
                for word in words {
                    // vertex/texture/normal
                    let index = word.split(|&b| b == b'/').next().and_then(whole::<i64>).filter(|&index| index != 0);
                    let index = index.ok_or_else(|| scanner.expected_before("a vertex index other than 0"))?;
                    let n = polygons.vertices.len() as i64;
                    budget.push(&mut faces, if index > 0 { index - 1 } else { n.saturating_add(index) })?;
                }
                let n_corners = faces.len() - ends.last().copied().unwrap_or(0);
                if n_corners < 3 && scanner.remaining() == 0 && !bytes.ends_with(b"\n") && !bytes.ends_with(b"\r") {
                    return Err(
                        scanner.expected_before("a face of three corners or more: the file may have been cut off")
                    );
                }
                budget.push(&mut ends, faces.len())?;
                Polygons::check_faces(ends.len() as u64, limits)?;
            }
            _ => {}
        }
    }
    // Faces may precede the vertices they use.
    let mut start = 0;
    for end in ends {
        polygons.push(faces[start..end].iter().copied())?;
        start = end;
    }
    let mut file = polygons.into_mesh()?;
    if let Some(unit) = unit {
        file.scale(unit)?;
    }
    Ok(file)
}

/// The part of a line before a comment. The `#` of `1.#QNAN`, the notation of older programs for NaN, does not begin a
/// comment.
fn before_comment(line: &[u8]) -> &[u8] {
    let begins = |&at: &usize| line[at] == b'#' && !line[..at].ends_with(b"1.");
    let end = (0..line.len()).find(begins).unwrap_or(line.len());
    &line[..end]
}
