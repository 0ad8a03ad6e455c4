//! STL, ASCII and binary. The format has no shared vertices, so they are welded on reading.
//!
//! A binary file is recognized by its length (84 bytes, and 50 per facet), since its free text may begin with "solid" too.

use super::polygons::{MeshFile, Polygons};
use super::text::Scanner;
use super::{FormatError, ReadLimits};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::repair::weld;
use nalgebra::Point3;

const HEADER_BYTES: usize = 84;
const FACET_BYTES: usize = 50;

/// Whether these bytes look like STL of either kind.
pub(super) fn is_stl(bytes: &[u8]) -> bool {
    is_binary(bytes) || starts_with_solid(bytes)
}

fn is_binary(bytes: &[u8]) -> bool {
    n_facets(bytes).is_some_and(|n| n > 0 && bytes.len() as u64 == HEADER_BYTES as u64 + n * FACET_BYTES as u64)
}

fn n_facets(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..HEADER_BYTES)?.first_chunk::<4>()?;
    Some(u32::from_le_bytes(*count).into())
}

fn starts_with_solid(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().get(..5).is_some_and(|head| head.eq_ignore_ascii_case(b"solid"))
}

/// Reads a mesh of triangles, welded. Normals are ignored: the order of the corners gives the orientation.
///
/// # Errors
/// [`FormatError`].
///
/// # Cost
/// Linear in the file's length.
pub fn read_stl(bytes: &[u8], limits: &ReadLimits) -> Result<MeshFile, FormatError> {
    let ascii = !is_binary(bytes) && starts_with_solid(bytes);
    let corners = if ascii { ascii_corners(bytes, limits)? } else { binary_corners(bytes, limits)? };
    if let Some(vertex) = corners.iter().position(|p| !p.iter().all(|c| c.is_finite())) {
        return Err(homolog_mesh::MeshError::NonFinite { vertex }.into());
    }
    let mut polygons = Polygons::default();
    polygons.vertices = corners;
    for k in (0..polygons.vertices.len() as i64).step_by(3) {
        polygons.push([k, k + 1, k + 2])?;
    }
    let mut file = polygons.into_mesh()?;
    file.mesh = weld(&file.mesh)?.mesh;
    file.welded = true;
    Polygons::check_count(file.mesh.n_vertices() as u64, limits)?;
    Ok(file)
}

fn binary_corners(bytes: &[u8], limits: &ReadLimits) -> Result<Vec<Point3<f64>>, FormatError> {
    let available = bytes.len() as u64;
    let n = n_facets(bytes).ok_or(FormatError::Truncated { part: "the STL header", needed: 84, available })?;
    let needed = HEADER_BYTES as u64 + n * FACET_BYTES as u64;
    if needed > available {
        return Err(FormatError::Truncated { part: "the list of STL facets", needed, available });
    }
    Polygons::check_faces(n, limits)?;
    let facets = bytes[HEADER_BYTES..needed as usize].chunks_exact(FACET_BYTES);
    // A facet: normal, three corners, two bytes of attributes.
    let number = |b: &[u8]| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let corner = |b: &[u8]| Point3::new(number(b), number(&b[4..]), number(&b[8..]));
    Ok(facets.flat_map(|f| [12, 24, 36].map(|at| corner(&f[at..at + 12]))).collect())
}

fn ascii_corners(bytes: &[u8], limits: &ReadLimits) -> Result<Vec<Point3<f64>>, FormatError> {
    let mut scanner = Scanner::new(bytes);
    let mut corners = Vec::new();
    // The free text after "solid" may hold any word.
    scanner.line();
    let mut in_loop = None;
    while let Some(word) = scanner.word() {
        if word.eq_ignore_ascii_case(b"vertex") {
            corner(&mut scanner, &mut corners)?;
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
            scanner.line();
        } else if in_loop.is_some() {
            return Err(scanner.expected("\"vertex\" or \"endloop\""));
        }
    }
    if in_loop.is_some() || !corners.len().is_multiple_of(3) {
        return Err(scanner.expected("the end of a facet"));
    }
    Ok(corners)
}

fn corner(scanner: &mut Scanner<'_>, corners: &mut Vec<Point3<f64>>) -> Result<(), FormatError> {
    let mut p = Point3::origin();
    for c in p.iter_mut() {
        *c = scanner.number("a coordinate")?;
    }
    corners.push(p);
    Ok(())
}

/// A binary STL file, single precision; quads are split along their first diagonal.
pub fn write_stl(mesh: &SurfaceMesh) -> Vec<u8> {
    let triangles = mesh.triangles();
    let mut file = b"binary STL, millimetres".to_vec();
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
