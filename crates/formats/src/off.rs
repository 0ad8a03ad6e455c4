//! OFF of Geomview, ASCII: positions and polygons; normals, colors and texture coordinates are skipped.
//!
//! Source: Geomview manual, "OFF Files". The keyword is optional; comments begin with `#`; a vertex or a face is a line.

use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::{FormatError, ReadLimits};
use nalgebra::Point3;

/// Whether this text has the keyword of the format, or names it in a comment in its first line.
pub(super) fn is_off(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes.get(..4096).unwrap_or(bytes));
    let first = scanner.peek_line();
    let in_comment = first.strip_prefix(b"#").is_some_and(|rest| rest.trim_ascii() == b"OFF");
    in_comment || significant(&mut scanner).and_then(|line| words(line).next()).is_some_and(is_keyword)
}

fn is_keyword(word: &[u8]) -> bool {
    let letters = word.strip_suffix(b"OFF");
    letters.is_some_and(|l| l.len() <= 5 && l.iter().all(|b| b"STCN4n".contains(b)))
}

/// The next line with anything but blanks and a comment, without the comment.
fn significant<'a>(scanner: &mut Scanner<'a>) -> Option<&'a [u8]> {
    loop {
        let line = scanner.line()?;
        let end = line.iter().position(|&b| b == b'#').unwrap_or(line.len());
        let line = line[..end].trim_ascii();
        if !line.is_empty() {
            return Some(line);
        }
    }
}

fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

fn number<T: std::str::FromStr>(word: Option<&[u8]>) -> Option<T> {
    std::str::from_utf8(word?).ok()?.parse().ok()
}

/// Reads a mesh. A file of quads alone gives a quad mesh; otherwise polygons are split into triangles.
///
/// # Errors
/// [`FormatError`]; the binary and the four-dimensional variants are not supported.
///
/// # Cost
/// Linear in the file's length.
pub fn read_off(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let Some(mut line) = significant(&mut scanner) else { return Err(scanner.expected("OFF")) };
    if let Some(keyword) = words(line).next().filter(|word| is_keyword(word)) {
        let rest = line[keyword.len()..].trim_ascii();
        if rest.starts_with(b"BINARY") || keyword.contains(&b'4') || keyword.contains(&b'n') {
            return Err(FormatError::Unsupported {
                what: "a binary or four-dimensional OFF file",
                advice: "save it as ASCII OFF in three dimensions, or as PLY",
            });
        }
        line = match rest {
            b"" => significant(&mut scanner).ok_or_else(|| scanner.expected("the counts of vertices and faces"))?,
            rest => rest,
        };
    }
    let mut counts = words(line);
    let counts = number::<u64>(counts.next()).zip(number::<u64>(counts.next()));
    let (n_vertices, n_faces) = counts.ok_or_else(|| scanner.expected_before("the counts of vertices and faces"))?;
    Polygons::check_count(n_vertices, limits)?;
    Polygons::check_faces(n_faces, limits)?;
    let mut polygons = Polygons::default();
    for _ in 0..n_vertices {
        let line = significant(&mut scanner).ok_or_else(|| scanner.expected("a vertex"))?;
        let mut coordinates = words(line);
        let mut p = Point3::origin();
        for c in p.iter_mut() {
            *c = number(coordinates.next()).ok_or_else(|| scanner.expected_before("three coordinates"))?;
        }
        polygons.vertices.push(p);
    }
    for _ in 0..n_faces {
        let line = significant(&mut scanner).ok_or_else(|| scanner.expected("a face"))?;
        let mut corners = words(line);
        let n: usize = number(corners.next()).ok_or_else(|| scanner.expected_before("the number of corners"))?;
        let mut face = Vec::new();
        for _ in 0..n {
            let corner: Option<i64> = number(corners.next());
            face.push(corner.ok_or_else(|| scanner.expected_before("a vertex index for each corner"))?);
        }
        polygons.push(face)?;
    }
    polygons.into_mesh()
}
