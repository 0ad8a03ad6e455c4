//! Repairs of a mesh that move no vertex: welding, keeping the largest piece, dropping pieces inside others,
//! triangulating, reversing all faces, dropping unused vertices.
//!
//! Vertices keep their order, and every repair returns the input index of each kept vertex, so that results can be
//! given in the numbering of the file. ([`super::tunnels`] closes tunnels.)

use super::elements::vertex_components;
use super::{FaceArity, MeshError, Numbering, SurfaceMesh};
use nalgebra::Point3;
use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

/// A repaired mesh with the map to its input.
#[derive(Debug, Clone, PartialEq)]
pub struct RepairedMesh {
    /// The mesh.
    pub mesh: SurfaceMesh,
    /// For each vertex of the mesh, its vertex in the input; for merged vertices, the first one.
    pub numbering: Numbering,
}

/// Distance below which vertices are merged, as a share of the diagonal of the bounding box. It is far below the
/// resolution of any mesh, and above the rounding of single-precision files whose coordinates are of the size of the
/// diagonal.
pub const WELD_RTOL: f64 = 1e-7;

/// Changes made by [`weld_reported`].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct WeldReport {
    /// Vertices that were merged into another.
    pub n_merged: usize,
    /// Merged vertices that shared a face with their replacement: ends of an edge shorter than the tolerance.
    pub n_collapsed: usize,
    /// Largest distance of a merged vertex from its replacement, mm.
    pub largest_mm: f64,
    /// Faces that were dropped because they used a vertex twice, before or after merging.
    pub n_degenerate: usize,
    /// Faces that were dropped because an earlier face is the same, with the same orientation.
    pub n_duplicate: usize,
}

/// [`weld_reported`] without the report.
///
/// # Errors
/// [`MeshError::Empty`] if no face is left.
pub fn weld(mesh: &SurfaceMesh) -> Result<RepairedMesh, MeshError> {
    weld_reported(mesh).map(|(repaired, _)| repaired)
}

/// Merges vertices at the same position (to [`WELD_RTOL`] of the diagonal); drops faces that thereby lose a corner,
/// repeated faces of the same orientation, and unused vertices.
///
/// If a quad becomes a triangle, the whole mesh is returned as triangles. Each vertex is merged into the kept vertex of
/// lowest index within the tolerance.
///
/// # Errors
/// [`MeshError::Empty`] if no face is left.
///
/// # Cost
/// `O(n)` expected.
pub fn weld_reported(mesh: &SurfaceMesh) -> Result<(RepairedMesh, WeldReport), MeshError> {
    let (low, high) = mesh.bounding_box();
    merged(mesh, &nearest_kept(mesh, (high - low).norm() * WELD_RTOL, |_| true))
}

/// Like [`weld_reported`], but merges only vertices of edges with one face, within `tolerance_mm` of each other. For
/// surfaces whose faces lie side by side without sharing vertices.
///
/// # Errors
/// [`MeshError::Empty`] if no face is left.
///
/// # Cost
/// `O(n log n)`; more where many vertices lie within the tolerance.
pub fn weld_boundary(mesh: &SurfaceMesh, tolerance_mm: f64) -> Result<(RepairedMesh, WeldReport), MeshError> {
    let on_boundary = mesh.boundary_vertices();
    let may_merge = |vertex: usize| on_boundary.as_ref().is_some_and(|on_boundary| on_boundary[vertex]);
    merged(mesh, &nearest_kept(mesh, tolerance_mm, may_merge))
}

/// The mesh in which vertex `v` is replaced by vertex `kept[v]`.
fn merged(mesh: &SurfaceMesh, kept: &[u32]) -> Result<(RepairedMesh, WeldReport), MeshError> {
    let mut report = WeldReport::default();
    for (at, &other) in kept.iter().enumerate().filter(|&(at, &other)| at != other as usize) {
        report.n_merged += 1;
        let distance = (mesh.vertices()[at] - mesh.vertices()[other as usize]).norm();
        report.largest_mm = report.largest_mm.max(distance);
    }
    let mut collapsed = vec![false; kept.len()];
    for face in mesh.faces() {
        let is_collapsed = |v: u32| kept[v as usize] != v && face.contains(&kept[v as usize]);
        face.iter().filter(|&&v| is_collapsed(v)).for_each(|&v| collapsed[v as usize] = true);
    }
    report.n_collapsed = collapsed.iter().filter(|&&is| is).count();
    let renamed = |face: &[u32]| Corners::of(face, kept);
    let collapsed_quad = mesh.arity() == FaceArity::Quad && mesh.faces().any(|f| renamed(f).repeat());
    let arity = if collapsed_quad { FaceArity::Triangle } else { mesh.arity() };
    let mut seen = HashSet::with_capacity(mesh.n_faces());
    let mut indices = Vec::with_capacity(mesh.n_faces() * arity.n_corners());
    let mut add = |face: Corners| {
        if face.repeat() {
            report.n_degenerate += 1;
        } else if seen.insert(face.beginning_with_lowest()) {
            indices.extend(face.all());
        } else {
            report.n_duplicate += 1;
        }
    };
    if collapsed_quad {
        mesh.triangles().iter().for_each(|t| add(renamed(t)));
    } else {
        mesh.faces().for_each(|f| add(renamed(f)));
    }
    if indices.is_empty() {
        return Err(MeshError::Empty { n_vertices: mesh.n_vertices(), n_faces: 0 });
    }
    Ok((compacted(mesh.vertices(), arity, indices), report))
}

/// The corners of a triangle or a quad, stored without an allocation; the fourth corner of a triangle is `u32::MAX`.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Corners([u32; 4]);

impl Corners {
    fn of(face: &[u32], names: &[u32]) -> Self {
        let mut corners = [u32::MAX; 4];
        corners.iter_mut().zip(face).for_each(|(corner, &v)| *corner = names[v as usize]);
        Corners(corners)
    }

    fn all(&self) -> &[u32] {
        &self.0[..if self.0[3] == u32::MAX { 3 } else { 4 }]
    }

    fn repeat(&self) -> bool {
        let corners = self.all();
        (0..corners.len()).any(|k| corners[k + 1..].contains(&corners[k]))
    }

    /// The same face, starting with its lowest corner.
    fn beginning_with_lowest(self) -> Self {
        let corners = self.all();
        let first = (0..corners.len()).min_by_key(|&k| corners[k]).unwrap_or(0);
        let mut turned = self;
        turned.0[..corners.len()].rotate_left(first);
        turned
    }
}

/// For every vertex that `may_merge`, the kept vertex of lowest index within the tolerance, mm. Kept vertices, and
/// vertices that may not merge, map to themselves.
fn nearest_kept(mesh: &SurfaceMesh, tolerance: f64, may_merge: impl Fn(usize) -> bool) -> Vec<u32> {
    let (low, _) = mesh.bounding_box();
    // Cells are much larger than the tolerance, so that only the few vertices near a cell boundary search a second
    // cell.
    let width = (tolerance * 64.0).max(f64::MIN_POSITIVE);
    let v = mesh.vertices();
    let cell = |p: &Point3<f64>, off: [f64; 3]| -> [i64; 3] {
        [0, 1, 2].map(|k| (((p[k] - low[k]) + off[k] * tolerance) / width).floor() as i64)
    };
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let mut kept: Vec<u32> = Vec::with_capacity(v.len());
    // Formats without shared vertices repeat positions. Later vertices at exactly the same position share the answer of
    // the first: vertices added in between have a higher index.
    let mut exact: HashMap<[u64; 3], u32> = HashMap::with_capacity(v.len() / 4);
    for (i, p) in v.iter().enumerate() {
        if !may_merge(i) {
            kept.push(i as u32);
            continue;
        }
        let position = exact.entry([p.x.to_bits(), p.y.to_bits(), p.z.to_bits()]);
        let place = match position {
            Entry::Occupied(earlier) => {
                kept.push(*earlier.get());
                continue;
            }
            Entry::Vacant(place) => place,
        };
        let mut found = u32::MAX;
        let mut looked = [[i64::MIN; 3]; 8];
        for corner in 0..8 {
            let off = [0, 1, 2].map(|k| if corner >> k & 1 == 0 { -1.0 } else { 1.0 });
            let c = cell(p, off);
            if looked[..corner].contains(&c) {
                continue;
            }
            looked[corner] = c;
            for &k in cells.get(&c).into_iter().flatten() {
                if k < found && (v[k as usize] - p).norm() <= tolerance {
                    found = k;
                }
            }
        }
        if found == u32::MAX {
            found = i as u32;
            cells.entry(cell(p, [0.0; 3])).or_default().push(found);
        }
        place.insert(found);
        kept.push(found);
    }
    kept
}

/// The connected piece (by shared vertices) with the most vertices; ties go to the first.
///
/// Cost `O(n)`.
pub fn largest_component(mesh: &SurfaceMesh) -> RepairedMesh {
    let components = vertex_components(mesh);
    let largest = components.largest();
    let indices = mesh
        .faces()
        .filter(|f| components.of_vertex[f[0] as usize] == largest)
        .flat_map(|f| f.iter().copied())
        .collect();
    compacted(&mesh.vertices, mesh.arity, indices)
}

/// Drops pieces of `mesh` that lie inside another piece, such as the walls of cavities, and returns how many were
/// dropped; `None` if there are none. A piece lies inside another if the winding number of the other around one of its
/// vertices exceeds a half.
///
/// # Cost
/// `O(n)` for each pair of pieces with nested bounding boxes.
///
/// # Source
/// Van Oosterom and Strackee, "The solid angle of a plane triangle", IEEE Transactions on Biomedical Engineering 30(2), 1983.
pub fn without_inner_pieces(mesh: &SurfaceMesh) -> Option<(RepairedMesh, usize)> {
    let components = vertex_components(mesh);
    let n_pieces = components.sizes.len();
    if n_pieces < 2 {
        return None;
    }
    let mut triangles: Vec<Vec<[u32; 3]>> = vec![Vec::new(); n_pieces];
    for t in mesh.triangles() {
        triangles[components.of_vertex[t[0] as usize] as usize].push(t);
    }
    let v = mesh.vertices();
    let boxes: Vec<(Point3<f64>, Point3<f64>)> = triangles
        .iter()
        .map(|piece| {
            let corners = || piece.iter().flatten().map(|&k| v[k as usize]);
            let first = corners().next().unwrap_or_default();
            corners().fold((first, first), |(low, high), p| (low.inf(&p), high.sup(&p)))
        })
        .collect();
    let within = |inner: usize, outer: usize| {
        let ((low, high), (outer_low, outer_high)) = (boxes[inner], boxes[outer]);
        (0..3).all(|k| outer_low[k] <= low[k] && high[k] <= outer_high[k]) && boxes[inner] != boxes[outer]
    };
    let inside = |inner: usize| {
        let Some(&[vertex, ..]) = triangles[inner].first() else { return false };
        let at = v[vertex as usize];
        (0..n_pieces)
            .any(|outer| outer != inner && within(inner, outer) && winding(v, &triangles[outer], &at).abs() > 0.5)
    };
    let dropped: Vec<bool> = (0..n_pieces).map(inside).collect();
    let n_dropped = dropped.iter().filter(|&&dropped| dropped).count();
    let kept = mesh.faces().filter(|f| !dropped[components.of_vertex[f[0] as usize] as usize]);
    (n_dropped > 0).then(|| (compacted(v, mesh.arity, kept.flatten().copied().collect()), n_dropped))
}

/// The winding number of a piece around a point.
fn winding(vertices: &[Point3<f64>], triangles: &[[u32; 3]], at: &Point3<f64>) -> f64 {
    let solid_angle = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|k| vertices[k as usize] - at);
        let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
        2.0 * a.dot(&b.cross(&c)).atan2(la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb)
    };
    triangles.iter().map(solid_angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
}

/// `mesh` with every quad split along its first diagonal. Cost `O(n)`.
pub fn triangulated(mesh: &SurfaceMesh) -> SurfaceMesh {
    SurfaceMesh { vertices: mesh.vertices.clone(), arity: FaceArity::Triangle, indices: mesh.triangles().concat() }
}

/// `mesh` without the vertices that no face uses. Cost `O(n)`.
pub fn drop_unused(mesh: &SurfaceMesh) -> RepairedMesh {
    compacted(&mesh.vertices, mesh.arity, mesh.indices.clone())
}

/// `mesh` with every face reversed, so that inside becomes outside. Cost `O(n)`.
pub fn reversed(mesh: &SurfaceMesh) -> SurfaceMesh {
    reversed_where(mesh, |_| true)
}

/// `mesh` with the faces reversed for which `reverse` holds. Cost `O(n)`.
pub(crate) fn reversed_where(mesh: &SurfaceMesh, reverse: impl Fn(usize) -> bool) -> SurfaceMesh {
    let mut mesh = mesh.clone();
    let faces = mesh.indices.chunks_exact_mut(mesh.arity.n_corners()).enumerate();
    // The first corner stays first, so a quad keeps its first diagonal.
    faces.filter(|(f, _)| reverse(*f)).for_each(|(_, face)| face[1..].reverse());
    mesh
}

/// The faces `indices` with only the vertices they use, in the old order.
pub(crate) fn compacted(vertices: &[Point3<f64>], arity: FaceArity, mut indices: Vec<u32>) -> RepairedMesh {
    let mut number = vec![u32::MAX; vertices.len()];
    indices.iter().for_each(|&v| number[v as usize] = 0);
    let original: Vec<u32> = (0..vertices.len() as u32).filter(|&v| number[v as usize] == 0).collect();
    for (new, &old) in original.iter().enumerate() {
        number[old as usize] = new as u32;
    }
    indices.iter_mut().for_each(|v| *v = number[*v as usize]);
    let vertices = original.iter().map(|&v| vertices[v as usize]).collect();
    RepairedMesh { mesh: SurfaceMesh { vertices, arity, indices }, numbering: Numbering::new(original) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::topology_report;

    /// A cube of quads in which every face has its own corners, far from the origin, and a stray quad.
    fn split_cube() -> SurfaceMesh {
        let corner = |k: u32| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2 & 1));
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let mut v: Vec<Point3<f64>> = faces.iter().flatten().map(|&k| corner(k) * 1.0).collect();
        v.extend([0u32, 1, 3, 2].map(|k| corner(k) + nalgebra::Vector3::new(0.0, 0.0, 7.0)));
        let n = v.len() as u32;
        SurfaceMesh::new(v, FaceArity::Quad, (0..n).collect()).unwrap()
    }

    #[test]
    fn a_short_edge_of_a_boundary_is_told_from_a_seam() {
        let at = |points: &[[f64; 2]]| points.iter().map(|p| Point3::new(p[0], p[1], 0.0)).collect::<Vec<_>>();
        // A sheet of two triangles, one with a short edge on the boundary.
        let sheet = SurfaceMesh::new(
            at(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1e-3, 1.0]]),
            FaceArity::Triangle,
            vec![0, 1, 2, 1, 3, 2],
        )
        .unwrap();
        let (_, found) = weld_boundary(&sheet, 0.01).unwrap();
        assert_eq!((found.n_merged, found.n_collapsed), (1, 1));
        // The same triangles side by side, without shared vertices.
        let seam = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.001, 0.0], [1.0, 1.0], [0.001, 1.0]];
        let seam = SurfaceMesh::new(at(&seam), FaceArity::Triangle, (0..6).collect()).unwrap();
        let (welded, found) = weld_boundary(&seam, 0.01).unwrap();
        assert_eq!((found.n_merged, found.n_collapsed, welded.mesh.n_vertices()), (2, 0, 4));
    }

    #[test]
    fn weld_closes_a_split_cube_and_returns_the_first_of_merged_vertices() {
        let split = split_cube();
        let welded = weld(&split).unwrap();
        assert_eq!(welded.mesh.n_vertices(), 12);
        let one = largest_component(&welded.mesh);
        let report = topology_report(&one.mesh);
        assert_eq!((report.genus, report.volume_mm3), (Some(0), Some(1.0)));
        for (new, &uploaded) in one.numbering.over(&welded.numbering).originals().iter().enumerate() {
            assert_eq!(split.vertices()[uploaded as usize], one.mesh.vertices()[new]);
            let first = split.vertices().iter().position(|p| *p == one.mesh.vertices()[new]);
            assert_eq!(first, Some(uploaded as usize));
        }
    }

    #[test]
    fn each_vertex_is_merged_into_the_lowest_kept_one_within_the_tolerance() {
        // Copies of few places, some exactly there, some moved by more or less than the tolerance.
        let places: Vec<Point3<f64>> =
            (0..40).map(|k| Point3::new(f64::from(k % 5), f64::from(k / 5 % 4), f64::from(k / 20))).collect();
        let tolerance = (places[39] - places[0]).norm() * WELD_RTOL;
        let steps = [0.0, 0.0, 0.4, -0.4, 0.9, 1.3, 0.0, -0.9];
        let vertices: Vec<Point3<f64>> = (0..600)
            .map(|k| {
                let step = steps[k * 7 % 8] * tolerance;
                let mut p = places[k * 17 % 40];
                p[k % 3] += step;
                p
            })
            .collect();
        let faces = (0..600).collect();
        let mesh = SurfaceMesh::new(vertices.clone(), FaceArity::Triangle, faces).unwrap();
        let (low, high) = mesh.bounding_box();
        let tolerance = (high - low).norm() * WELD_RTOL;
        let mut kept: Vec<u32> = Vec::new();
        for (i, p) in vertices.iter().enumerate() {
            let near = |k: &usize| kept[*k] as usize == *k && (vertices[*k] - p).norm() <= tolerance;
            kept.push((0..i).find(near).unwrap_or(i) as u32);
        }
        assert_eq!(nearest_kept(&mesh, tolerance, |_| true), kept);
        assert!(kept.iter().enumerate().filter(|&(k, &other)| k == other as usize).count() > 40, "some are apart");
    }

    #[test]
    fn weld_is_the_identity_on_a_welded_mesh() {
        let once = weld(&split_cube()).unwrap();
        let twice = weld(&once.mesh).unwrap();
        assert_eq!(twice.mesh, once.mesh);
        assert_eq!(twice.numbering, Numbering::identity(once.mesh.n_vertices()));
    }

    #[test]
    fn weld_drops_collapsed_and_repeated_faces() {
        let v = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1e-9, 0.0]].map(Point3::from).to_vec();
        let mesh = SurfaceMesh::new(v, FaceArity::Triangle, vec![0, 1, 2, 1, 3, 2, 3, 2, 0]).unwrap();
        let (welded, report) = weld_reported(&mesh).unwrap();
        assert_eq!((report.n_merged, report.n_degenerate, report.n_duplicate), (1, 1, 1));
        assert!((report.largest_mm - 1e-9).abs() < 1e-15, "{report:?}");
        assert_eq!(welded.mesh.indices(), [0, 1, 2]);
        assert_eq!(welded.numbering.originals(), [0, 1, 2]);
    }

    #[test]
    fn pieces_inside_another_are_dropped_and_those_beside_it_stay() {
        use crate::shapes::{ellipsoid, torus};
        use nalgebra::Vector3;
        let outer = ellipsoid(Vector3::new(9.0, 8.0, 7.0), 3);
        let cavity = reversed(&ellipsoid(Vector3::new(4.0, 3.0, 2.0), 2));
        // Inside the box of the first, and outside of it.
        let beside = ellipsoid(Vector3::repeat(0.4), 1)
            .with_vertices(
                ellipsoid(Vector3::repeat(0.4), 1).vertices().iter().map(|p| p + Vector3::new(8.0, 7.0, 6.0)).collect(),
            )
            .unwrap();
        let ring = torus(30.0, 2.0, 20, 8, FaceArity::Triangle);
        let (mut vertices, mut indices) = (Vec::new(), Vec::new());
        for piece in [&cavity, &outer, &beside, &ring] {
            let first = vertices.len() as u32;
            vertices.extend_from_slice(piece.vertices());
            indices.extend(piece.indices().iter().map(|v| v + first));
        }
        let all = SurfaceMesh::new(vertices, FaceArity::Triangle, indices).unwrap();
        let (kept, n_dropped) = without_inner_pieces(&all).unwrap();
        assert_eq!((n_dropped, kept.numbering.original(0) as usize), (1, cavity.n_vertices()));
        assert_eq!(topology_report(&kept.mesh).n_components, 3);
        assert_eq!(without_inner_pieces(&kept.mesh), None);
    }

    #[test]
    fn reversing_twice_is_the_identity() {
        let mesh = largest_component(&weld(&split_cube()).unwrap().mesh).mesh;
        assert_eq!(reversed(&mesh).signed_volume(), -mesh.signed_volume());
        assert_eq!(reversed(&reversed(&mesh)), mesh);
    }
}
