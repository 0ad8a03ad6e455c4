//! FreeSurfer surfaces (`lh.pial`, `rh.white`, ...): binary triangles, both kinds of binary quads, and ASCII (`.asc`).
//!
//! Source: FreeSurfer's `mrisurf_io` and the description of its file formats. Binary files are big-endian. The part
//! after the faces (the geometry of the volume, the command line) is not read, unless it consists of further faces:
//! then the count is wrong. Coordinates are kept in FreeSurfer's surface RAS ("tkregister"), whose origin is the center
//! of the conformed volume. The quads of the old format are split as in FreeSurfer, by the parity of their first
//! vertex.

use super::budget::Budget;
use super::element::{ByteOrder, Element};
use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::{FormatError, ReadLimits};
use nalgebra::Point3;

const TRIANGLES: [u8; 3] = [0xff, 0xff, 0xfe];
/// Quads with coordinates in hundredths of a millimeter.
const QUADS: [u8; 3] = [0xff, 0xff, 0xff];
/// Quads with coordinates in single precision.
const NEW_QUADS: [u8; 3] = [0xff, 0xff, 0xfd];
const ASCII: &[u8] = b"#!ascii";

/// Start of a list of vertices of a surface, which is not a surface.
const LABEL: &[u8] = b"#!ascii label";
/// Largest size of the lines that name the creator and date of a file, bytes.
const STAMP_BYTES: usize = 4096;

/// Whether `bytes` are a label of FreeSurfer: a list of vertices of a surface.
pub(super) fn is_label(bytes: &[u8]) -> bool {
    bytes.starts_with(LABEL)
}

/// Whether `bytes` begin like a surface.
pub(super) fn is_freesurfer(bytes: &[u8]) -> bool {
    // A patch begins with four such bytes; as part of a vertex count the fourth would exceed every surface.
    let is_patch = bytes.starts_with(&[0xff; 4]);
    let is_binary = [&TRIANGLES, &QUADS, &NEW_QUADS].iter().any(|magic| bytes.starts_with(*magic));
    is_binary && !is_patch || bytes.starts_with(ASCII) && !is_label(bytes)
}

/// Reads a mesh of triangles.
///
/// # Errors
/// [`FormatError`]; per-vertex values (`lh.thickness`, `lh.curv`) are not surfaces.
///
/// # Cost
/// Linear in the file's length.
pub fn read_freesurfer(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let budget = &Budget::of(limits);
    let mut trailing = None;
    let polygons = match bytes.first_chunk::<3>() {
        _ if !bytes.starts_with(&[0xff]) => {
            let (polygons, note) = ascii(bytes, limits, budget)?;
            trailing = note;
            polygons
        }
        Some(&TRIANGLES) => triangles(bytes, limits, budget)?,
        Some(&QUADS) if is_curvature(bytes) => {
            return Err(FormatError::Unsupported {
                what: "a FreeSurfer file of per-vertex values",
                advice: "send the surface to which they belong, such as lh.pial or lh.white",
            });
        }
        Some(&QUADS) => quads(bytes, Element::I16, 0.01, limits, budget)?,
        Some(&NEW_QUADS) => quads(bytes, Element::F32, 1.0, limits, budget)?,
        _ => return Err(FormatError::Payload { format: "FreeSurfer", line: None }),
    };
    let mut file = polygons.into_mesh()?;
    let note = "coordinates are FreeSurfer's surface RAS (tkregister), as stored; scanner RAS differs by the c_ras of the volume";
    file.space = homolog_contract::input::InputSpace::FreesurferRas;
    file.notes.push(note.to_owned());
    file.notes.extend(trailing);
    Ok(file)
}

/// Whether `bytes` are a file of values in the newer format, which begins like the old quads: three counts of four
/// bytes each and one number for each vertex and value.
fn is_curvature(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes.get(3..).unwrap_or_default());
    let Ok(counts) = scanner.take(3, 4, "the counts") else { return false };
    let counts = Element::U32.wholes(counts, ByteOrder::Big);
    scanner.remaining() as u64 == (counts[0] as u64).saturating_mul(counts[2] as u64).saturating_mul(4)
}

fn triangles<'b>(bytes: &[u8], limits: &ReadLimits, budget: &'b Budget) -> Result<Polygons<'b>, FormatError> {
    let mut scanner = after_stamp(bytes.get(3..).unwrap_or_default())?;
    let counts = Element::I32.wholes(scanner.take(2, 4, "the counts of vertices and faces")?, ByteOrder::Big);
    let [n_vertices, n_faces] = counts[..2] else { return Err(scanner.expected("the counts of vertices and faces")) };
    let [n_vertices, n_faces] = checked_counts([n_vertices, n_faces])?;
    Polygons::check_faces(n_faces, limits)?;
    let mut polygons = Polygons::new(budget);
    points(&mut polygons, &mut scanner, n_vertices, Element::F32, 1.0, limits)?;
    let corners = scanner.take(n_faces.saturating_mul(3), 4, "the list of faces")?;
    for face in Element::I32.charged_wholes(corners, ByteOrder::Big, budget)?.chunks_exact(3) {
        polygons.push(face.iter().copied())?;
    }
    // Further faces mean that the count is wrong.
    let rest = scanner.rest();
    let is_face = |face: &&[u8]| {
        let face = [0, 4, 8].map(|at| Element::I32.whole_of(&face[at..at + 4], ByteOrder::Big));
        face.iter().all(|v| (0..n_vertices as i64).contains(v)) && face[0] != face[1]
    };
    let n_more = rest.chunks_exact(12).take_while(is_face).count() as u64;
    if n_more > 0 && !are_tags(rest) {
        return Err(FormatError::CountMismatch { what: "faces", stated: n_faces, found: n_faces + n_more });
    }
    Ok(polygons)
}

/// Whether `rest` is FreeSurfer's trailer: tags, some of which have a length and others are known.
fn are_tags(mut rest: &[u8]) -> bool {
    const REAL_RAS: i64 = 2;
    const GEOMETRY: i64 = 20;
    loop {
        // Fewer bytes than a tag are padding.
        let Some(tag) = rest.get(..4) else { return true };
        let tag = Element::I32.whole_of(tag, ByteOrder::Big);
        let begin = match tag {
            REAL_RAS => 8,
            // Text; further tags may follow.
            GEOMETRY => return rest[4..].iter().take(64).all(|byte| (b' '..0x7f).contains(byte) || *byte == b'\n'),
            1..1000 => 12,
            _ => return rest.iter().all(|&byte| byte == 0),
        };
        let length =
            if begin == 12 { rest.get(4..12).map(|raw| Element::I64.whole_of(raw, ByteOrder::Big)) } else { Some(0) };
        let after = length.and_then(|n| rest.get(begin + usize::try_from(n).ok()?..));
        match after {
            Some(after) => rest = after,
            None => return false,
        }
    }
}

fn checked_counts(counts: [i64; 2]) -> Result<[u64; 2], FormatError> {
    let valid = counts.iter().all(|&n| n >= 0);
    valid.then(|| counts.map(|n| n as u64)).ok_or_else(|| FormatError::Header {
        field: "counts of vertices and faces",
        value: format!("{counts:?}"),
        advice: "they must not be negative; the file is damaged, or no surface",
    })
}

/// The position after the free text that names the creator and date. FreeSurfer writes a line and an empty one, and
/// skips all white space after the first line when it reads; other programs take exactly two lines, and the second may
/// hold text. The first of these positions at which the counts fit the length of the file is chosen.
fn after_stamp(bytes: &[u8]) -> Result<Scanner<'_>, FormatError> {
    let mut first = Scanner::new(bytes);
    first.line();
    let mut second = first.clone();
    second.line();
    first.skip_blanks();
    let mut places = vec![first.clone(), second.clone()];
    // Further lines of text.
    while bytes.len() - second.remaining() < STAMP_BYTES && second.peek_line().iter().all(|b| (b' '..0x7f).contains(b))
    {
        if second.line().is_none() {
            break;
        }
        places.push(second.clone());
    }
    let fits = |place: &&Scanner<'_>| {
        let Ok(counts) = Scanner::clone(place).take(2, 4, "the counts") else { return false };
        let counts = Element::I32.wholes(counts, ByteOrder::Big);
        let needed = counts.iter().map(|&n| u64::try_from(n).unwrap_or(u64::MAX).saturating_mul(12));
        let needed = needed.fold(8u64, u64::saturating_add);
        counts.iter().all(|&n| n > 0) && needed <= place.remaining() as u64
    };
    Ok(places.iter().find(fits).cloned().unwrap_or(first))
}

fn points(
    polygons: &mut Polygons<'_>,
    scanner: &mut Scanner<'_>,
    n: u64,
    element: Element,
    scale: f64,
    limits: &ReadLimits,
) -> Result<(), FormatError> {
    let raw = scanner.take(n.saturating_mul(3), element.size(), "the list of vertices")?;
    Polygons::check_count(n, limits)?;
    for p in raw.chunks_exact(3 * element.size()) {
        let number = |k: usize| element.real_of(&p[k * element.size()..(k + 1) * element.size()], ByteOrder::Big);
        polygons.vertex(Point3::new(number(0), number(1), number(2)) * scale)?;
    }
    Ok(())
}

fn quads<'b>(
    bytes: &[u8],
    element: Element,
    scale: f64,
    limits: &ReadLimits,
    budget: &'b Budget,
) -> Result<Polygons<'b>, FormatError> {
    let mut scanner = Scanner::new(bytes.get(3..).unwrap_or_default());
    let three = |b: &[u8]| i64::from(b[0]) << 16 | i64::from(b[1]) << 8 | i64::from(b[2]);
    let counts = scanner.take(2, 3, "the counts of vertices and faces")?;
    let [n_vertices, n_faces] = checked_counts([three(counts), three(&counts[3..])])?.map(|n| n as i64);
    Polygons::check_faces(n_faces as u64, limits)?;
    let mut polygons = Polygons::new(budget);
    points(&mut polygons, &mut scanner, n_vertices as u64, element, scale, limits)?;
    for quad in scanner.take(n_faces as u64, 12, "the list of faces")?.chunks_exact(12) {
        let [a, b, c, d] = [0, 3, 6, 9].map(|at| three(&quad[at..]));
        let halves = if a % 2 == 0 { [[a, b, d], [c, d, b]] } else { [[a, b, c], [a, c, d]] };
        halves.into_iter().try_for_each(|triangle| polygons.push(triangle))?;
    }
    Ok(polygons)
}

/// A comment, the two counts, then a line for each vertex (three coordinates) and each face (three indices), each with
/// a further number that marks patches.
fn ascii<'b>(
    bytes: &[u8],
    limits: &ReadLimits,
    budget: &'b Budget,
) -> Result<(Polygons<'b>, Option<String>), FormatError> {
    let mut scanner = Scanner::new(bytes);
    if bytes.starts_with(b"#") {
        scanner.text_line();
    }
    let n_vertices: u64 = scanner.number("the number of vertices")?;
    let n_faces: u64 = scanner.number("the number of faces")?;
    Polygons::check_count(n_vertices, limits)?;
    Polygons::check_faces(n_faces, limits)?;
    let mut polygons = Polygons::new(budget);
    for _ in 0..n_vertices {
        let mut p = Point3::origin();
        for c in p.iter_mut() {
            *c = scanner.real("a coordinate")?;
        }
        scanner.real("the patch number of a vertex")?;
        polygons.vertex(p)?;
    }
    for _ in 0..n_faces {
        let mut face = [0i64; 3];
        for corner in &mut face {
            *corner = scanner.number("a vertex index")?;
        }
        scanner.real("the patch number of a face")?;
        polygons.push(face)?;
    }
    // Four numbers for each face.
    let note = scanner.check_end("faces", n_faces, 4)?;
    Ok((polygons, note))
}
