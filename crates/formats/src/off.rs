//! OFF of Geomview, ASCII: positions and polygons; normals, colors and texture coordinates are skipped.
//!
//! Source: Geomview manual, "OFF Files". The keyword is optional; comments begin with `#`; each vertex or face takes a
//! line. Lines after the last face mean that the counts are wrong.

use super::budget::Budget;
use super::polygons::{MeshFile, Polygons};
use super::text::{Scanner, real, whole, words};
use super::{FormatError, ReadLimits, units};
use nalgebra::Point3;

/// Whether the text has the keyword of the format, or names it in a comment in its first line.
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

/// The next line that is not empty after removal of its comment.
fn significant<'a>(scanner: &mut Scanner<'a>) -> Option<&'a [u8]> {
    loop {
        let line = scanner.text_line()?;
        let end = line.iter().position(|&b| b == b'#').unwrap_or(line.len());
        let line = line[..end].trim_ascii();
        if !line.is_empty() {
            return Some(line);
        }
    }
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
    let counts = counts.next().and_then(whole::<u64>).zip(counts.next().and_then(whole::<u64>));
    let (n_vertices, n_faces) = counts.ok_or_else(|| scanner.expected_before("the counts of vertices and faces"))?;
    Polygons::check_count(n_vertices, limits)?;
    Polygons::check_faces(n_faces, limits)?;
    let budget = Budget::of(limits);
    let mut polygons = Polygons::new(&budget);
    for found in 0..n_vertices {
        let mut p = Point3::origin();
        let Some(line) = significant(&mut scanner) else {
            return Err(FormatError::CountMismatch { what: "vertices", stated: n_vertices, found });
        };
        let mut coordinates = words(line).map(real);
        for c in p.iter_mut() {
            *c = coordinates.next().flatten().ok_or_else(|| scanner.expected_before("three coordinates"))?;
        }
        polygons.vertex(p)?;
    }
    for found in 0..n_faces {
        let Some(line) = significant(&mut scanner) else {
            return Err(FormatError::CountMismatch { what: "faces", stated: n_faces, found });
        };
        // A digit and a blank for each corner, while the list of the line grows.
        let n_bytes = 12 * line.len();
        budget.charge(n_bytes)?;
        polygons.push(corners(line).ok_or_else(|| scanner.expected_before(FACE))?)?;
        budget.release(n_bytes);
    }
    let mut file = polygons.into_mesh()?;
    file.notes.extend(check_end(&mut scanner, n_faces, &budget)?);
    let comments = bytes.split(|&byte| byte == b'\n').filter(|line| line.contains(&b'#'));
    if let Some(unit) = comments.into_iter().find_map(units::stated_in) {
        file.scale(unit)?;
    }
    Ok(file)
}

/// Checks the lines after the last face: further faces mean that the stated number is wrong. Returns a note on other
/// bytes.
fn check_end(scanner: &mut Scanner<'_>, stated: u64, budget: &Budget) -> Result<Option<String>, FormatError> {
    let rest = scanner.rest();
    let (mut n_more, mut is_other) = (0, false);
    while let Some(line) = significant(scanner) {
        budget.charge(12 * line.len())?;
        match corners(line) {
            Some(_) => n_more += 1,
            None => is_other |= line.iter().any(|&byte| byte != 0),
        }
        budget.release(12 * line.len());
    }
    if n_more > 0 {
        return Err(FormatError::CountMismatch { what: "faces", stated, found: stated + n_more });
    }
    Ok(is_other.then(|| super::trailing_note(rest.len())))
}

const FACE: &str = "the number of corners and a vertex index for each";

/// The corners of a face, whose number the line states; colors may follow.
fn corners(line: &[u8]) -> Option<Vec<i64>> {
    let mut words = words(line);
    let n: usize = whole(words.next()?)?;
    let corners: Vec<i64> = words.by_ref().take(n).map_while(whole).collect();
    (corners.len() == n && words.all(|word| real(word).is_some())).then_some(corners)
}
