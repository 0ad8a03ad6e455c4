//! STL, ASCII and binary. The format has no shared vertices, so they are welded on reading.
//!
//! Source: StereoLithography Interface Specification, 3D Systems, 1988. A binary file is 80 bytes of free text, a
//! count, and 50 bytes for each facet. Its text may begin with "solid" too, so the kind is determined from the bytes.
//! If the count disagrees with the length, the length decides provided that it fits whole facets and the count states
//! fewer, or none: streaming writers leave the count at 0. If the count states more, or if the bytes after the facets
//! are neither facets nor a short rest, the file is refused. An ASCII file without `endsolid` is read only if its
//! surface is closed: otherwise it may have been cut off.

use super::budget::Budget;
use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::units::{self, Unit};
use super::{FormatError, ReadLimits, trailing_note};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::repair::weld;
use nalgebra::Point3;
use std::hash::{DefaultHasher, Hasher as _};

const TEXT_BYTES: usize = 80;
const HEADER_BYTES: usize = 84;
const FACET_BYTES: usize = 50;
/// Bytes needed for joining, per corner and per distinct position.
const CORNER_BYTES: usize = 32;
const PLACE_BYTES: usize = 240;
/// Bytes of a file that are inspected to distinguish text from binary.
const HEAD_BYTES: usize = 1024;

/// Whether `bytes` are STL of either kind.
pub(super) fn is_stl(bytes: &[u8]) -> bool {
    is_ascii(bytes) || stated_facets(bytes).is_some_and(|n| n > 0 && bytes.len() as u64 == length_of(n))
}

/// Whether `bytes` can be binary STL with a wrong count: facets that all have finite coordinates. There may be no
/// facets if the name of the file indicates STL.
pub(super) fn may_be_stl(bytes: &[u8], is_named_so: bool) -> bool {
    let Some(facets) = bytes.get(HEADER_BYTES..) else { return false };
    (is_named_so || facets.len() >= FACET_BYTES)
        && !is_text(bytes)
        && facets.chunks_exact(FACET_BYTES).all(is_plausible)
}

fn length_of(n_facets: u64) -> u64 {
    HEADER_BYTES as u64 + n_facets * FACET_BYTES as u64
}

/// The count of the header.
fn stated_facets(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(TEXT_BYTES..HEADER_BYTES)?.first_chunk::<4>()?;
    Some(u32::from_le_bytes(*count).into())
}

/// Whether the start of a file is text.
fn is_text(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(HEAD_BYTES)];
    !head.iter().any(|&byte| byte < b' ' && !byte.is_ascii_whitespace() && byte != 0x0b)
}

fn is_ascii(bytes: &[u8]) -> bool {
    let head = super::text::without_preamble(bytes);
    let begins = |word: &[u8]| head.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
    let is_keyword = begins(b"solid") && head.get(5).is_none_or(u8::is_ascii_whitespace);
    (is_keyword || begins(b"facet normal")) && is_text(bytes)
}

/// Whether a facet has plausible coordinates.
fn is_plausible(facet: &[u8]) -> bool {
    corners_of(facet).iter().all(|p| p.iter().all(|c| c.is_finite() && c.abs() < 1e12))
}

/// Reads a mesh of triangles, welded. Normals are ignored: the order of the corners gives the orientation.
///
/// # Errors
/// [`FormatError`].
///
/// # Cost
/// Linear in the file's length.
pub fn read_stl(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    read_soup(bytes, limits)?.joined(limits)
}

/// Content of a file: three corners for each facet. It is many times smaller than a text file, which need not be held
/// while equal corners are joined.
pub(super) struct Soup {
    corners: Vec<Point3<f64>>,
    notes: Vec<String>,
    unit: Option<Unit>,
    /// The number of lines, if the text ends before its solid does.
    cut_off_at: Option<usize>,
}

/// Reads the facets.
///
/// # Errors
/// [`FormatError`].
pub(super) fn read_soup(bytes: &[u8], limits: &ReadLimits) -> Result<Soup, FormatError> {
    let budget = Budget::of(limits);
    let mut notes = Vec::new();
    let ascii = is_ascii(bytes);
    let mut cut_off_at = None;
    let corners = if ascii {
        let (corners, ended) = ascii_corners(bytes, limits, &budget)?;
        let n_lines = || 1 + bytes.iter().filter(|&&byte| byte == b'\n').count();
        cut_off_at = (!ended).then(n_lines);
        corners
    } else {
        binary_corners(bytes, limits, &budget, &mut notes)?
    };
    if let Some(vertex) = corners.iter().position(|p| !p.iter().all(|c| c.is_finite())) {
        return Err(homolog_mesh::MeshError::NonFinite { vertex }.into());
    }
    let title = if ascii { bytes.split(|&b| b == b'\n').next() } else { bytes.get(..TEXT_BYTES) };
    let unit = title.and_then(units::stated_in);
    Ok(Soup { corners, notes, unit, cut_off_at })
}

impl Soup {
    /// The surface, with equal corners joined.
    ///
    /// # Errors
    /// [`FormatError`].
    pub(super) fn joined(self, limits: &ReadLimits) -> Result<MeshFile, FormatError> {
        let Soup { corners, notes, unit, cut_off_at } = self;
        let budget = Budget::of(limits);
        budget.charge_of::<Point3<f64>>(corners.capacity())?;
        let n_corners = corners.len();
        let n_distinct = distinct(&corners, &budget)?;
        let mut polygons = Polygons::of(corners, &budget);
        for k in (0..n_corners as i64).step_by(3) {
            polygons.push([k, k + 1, k + 2])?;
        }
        let mut file = polygons.into_mesh()?;
        // Tables of corners, faces and positions, while equal corners are joined.
        budget.charge(n_corners * CORNER_BYTES + n_distinct * PLACE_BYTES)?;
        file.mesh = weld(&file.mesh)?.mesh;
        file.welded = true;
        Polygons::check_count(file.mesh.n_vertices() as u64, limits)?;
        if let Some(line) = cut_off_at {
            if file.mesh.boundary_vertices().is_some() {
                let expected = "endsolid: the file ends before it and its surface is open";
                return Err(FormatError::Syntax { line, expected });
            }
            file.notes.push("the file ends without endsolid; its surface is closed".to_owned());
        }
        let n_left_out = n_corners / 3 - file.mesh.n_faces();
        if n_left_out > 0 {
            file.notes.push(format!("{n_left_out} facets without area, or stated twice, were left out"));
        }
        file.notes.extend(notes);
        if let Some(unit) = unit {
            file.scale(unit)?;
        }
        Ok(file)
    }
}

/// Number of distinct positions, up to hash collisions.
fn distinct(corners: &[Point3<f64>], budget: &Budget) -> Result<usize, FormatError> {
    budget.charge_of::<u64>(corners.len())?;
    let mut hashes: Vec<u64> = corners
        .iter()
        .map(|p| {
            let mut hasher = DefaultHasher::new();
            p.iter().for_each(|c| hasher.write_u64(c.to_bits()));
            hasher.finish()
        })
        .collect();
    hashes.sort_unstable();
    hashes.dedup();
    budget.release(size_of::<u64>() * corners.len());
    Ok(hashes.len())
}

fn binary_corners(
    bytes: &[u8],
    limits: &ReadLimits,
    budget: &Budget,
    notes: &mut Vec<String>,
) -> Result<Vec<Point3<f64>>, FormatError> {
    let available = bytes.len() as u64;
    let stated =
        stated_facets(bytes).ok_or(FormatError::Truncated { part: "the STL header", needed: 84, available })?;
    let facets = bytes.get(HEADER_BYTES..).unwrap_or_default();
    let (found, rest) = ((facets.len() / FACET_BYTES) as u64, facets.len() % FACET_BYTES);
    let is_unstated = stated == 0 || stated == u64::from(u32::MAX);
    if stated == 0 && found == 0 {
        return Err(homolog_mesh::MeshError::Empty { n_vertices: 0, n_faces: 0 }.into());
    }
    let mismatch = FormatError::CountMismatch { what: "facets", stated, found };
    if stated > found && !is_unstated {
        return Err(mismatch);
    }
    let beyond = if is_unstated { facets } else { &facets[stated as usize * FACET_BYTES..] };
    let is_zero = !is_unstated && beyond.iter().all(|&byte| byte == 0);
    let mut each = beyond.chunks_exact(FACET_BYTES);
    let n = if is_zero {
        stated
    } else if rest == 0 && found > 0 && each.clone().all(is_plausible) {
        notes.push(format!(
            "the header states {stated} facets, but the length of the file is that of {found}, and {found} were read"
        ));
        found
    } else if is_unstated || each.next().is_some_and(is_plausible) {
        return Err(mismatch);
    } else {
        notes.push(trailing_note(beyond.len()));
        stated
    };
    Polygons::check_faces(n, limits)?;
    let facets = facets[..n as usize * FACET_BYTES].chunks_exact(FACET_BYTES);
    let mut corners = Vec::new();
    budget.reserve(&mut corners, 3 * n as usize)?;
    corners.extend(facets.flat_map(corners_of));
    Ok(corners)
}

/// A facet: normal, three corners, two bytes of attributes.
fn corners_of(facet: &[u8]) -> [Point3<f64>; 3] {
    let number = |b: &[u8]| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let corner = |b: &[u8]| Point3::new(number(b), number(&b[4..]), number(&b[8..]));
    [12, 24, 36].map(|at| corner(&facet[at..at + 12]))
}

/// The corners of all facets, and whether the last solid is complete.
fn ascii_corners(bytes: &[u8], limits: &ReadLimits, budget: &Budget) -> Result<(Vec<Point3<f64>>, bool), FormatError> {
    let mut scanner = Scanner::new(super::text::without_preamble(bytes));
    let mut corners = Vec::new();
    let is_title = scanner.peek().is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    if is_title {
        // The free text after "solid" may contain any word.
        scanner.text_line();
    }
    let (mut in_loop, mut is_open) = (None, true);
    while let Some(word) = scanner.word() {
        if word.eq_ignore_ascii_case(b"vertex") {
            budget.push(&mut corners, corner(&mut scanner)?)?;
            in_loop = in_loop.map(|n| n + 1);
        } else if word.eq_ignore_ascii_case(b"loop") {
            in_loop = Some(0);
        } else if word.eq_ignore_ascii_case(b"endloop") {
            if in_loop != Some(3) {
                return Err(scanner.expected("a facet of exactly three vertices"));
            }
            in_loop = None;
            Polygons::check_faces(corners.len() as u64 / 3, limits)?;
        } else if word.eq_ignore_ascii_case(b"endsolid") || word.eq_ignore_ascii_case(b"solid") {
            is_open = word.eq_ignore_ascii_case(b"solid");
            scanner.text_line();
        } else if in_loop.is_some() {
            return Err(scanner.expected("\"vertex\" or \"endloop\""));
        }
    }
    if in_loop.is_some() || !corners.len().is_multiple_of(3) {
        return Err(scanner.expected("the end of a facet"));
    }
    Ok((corners, !is_open))
}

fn corner(scanner: &mut Scanner<'_>) -> Result<Point3<f64>, FormatError> {
    let mut p = Point3::origin();
    for c in p.iter_mut() {
        *c = scanner.real("a coordinate")?;
    }
    Ok(p)
}

/// A binary STL file, single precision; quads are split along their first diagonal.
pub fn write_stl(mesh: &SurfaceMesh) -> Vec<u8> {
    let triangles = mesh.triangles();
    let mut file = b"binary STL, millimeters".to_vec();
    file.resize(80, b' ');
    file.extend((triangles.len() as u32).to_le_bytes());
    for t in triangles {
        let corner = t.map(|v| mesh.vertices()[v as usize]);
        let normal = (corner[1] - corner[0]).cross(&(corner[2] - corner[0])).try_normalize(0.0).unwrap_or_default();
        let numbers = normal.iter().chain(corner.iter().flat_map(|p| p.iter()));
        file.extend(numbers.flat_map(|&c| (c as f32).to_le_bytes()));
        file.extend([0, 0]);
    }
    file
}
