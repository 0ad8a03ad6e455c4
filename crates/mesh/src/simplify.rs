//! Reduces the number of vertices: edges are collapsed onto one of their ends until the requested number is reached.
//!
//! Vertices are dropped but never moved, so each vertex of the result is a vertex of the input ([`super::Numbering`]).
//! Quadrics order the collapses: the cost of an edge is the sum of the squared distances of the kept end from the
//! planes of the faces around both ends, weighted by area. Planes at right angles to the surface hold the boundaries in
//! place.
//!
//! # Source
//! Garland and Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997; the condition under which
//! a collapse preserves the topology: Dey, Edelsbrunner, Guha and Nekhayev, "Topology preserving edge contraction",
//! Publications de l'Institut Mathématique 66(80), 1999.

use super::repair::{RepairedMesh, compacted};
use super::{ClosestPointIndex, FaceArity, SurfaceMesh};
use nalgebra::{Matrix4, Point3, Vector3, Vector4};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Weight of planes at boundaries, relative to those of faces.
const BOUNDARY_WEIGHT: f64 = 10.0;
/// Weight of the length of an edge, relative to the distance from planes. It orders collapses where the surface is
/// flat.
const LENGTH_WEIGHT: f64 = 1e-3;
/// Least cosine of the angle by which a collapse may turn the normal of a face.
const LEAST_COSINE: f64 = 0.2;

/// A mesh with fewer vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Simplified {
    /// The mesh, of triangles, and the vertex of the input for each of its vertices.
    pub repaired: RepairedMesh,
    /// Largest distance of a vertex of the input from the simplified surface, mm.
    pub largest_mm: f64,
}

/// `mesh` with at most `n_vertices` vertices, or as few as its topology allows. Genus, boundaries and pieces are
/// preserved. Edges with more than two faces, and vertices where parts only touch, are kept. A mesh that is small
/// enough is only triangulated.
///
/// # Cost
/// `O(n log n)`.
pub fn simplify(mesh: &SurfaceMesh, n_vertices: usize) -> Simplified {
    let mut state = Collapsing::new(mesh);
    let mut left = state.at_vertex.iter().filter(|faces| !faces.is_empty()).count();
    while left > n_vertices {
        let Some((drop, keep)) = state.next() else { break };
        state.collapse(drop, keep);
        left -= 1;
    }
    let alive = state.triangles.iter().zip(&state.alive).filter(|(_, alive)| **alive);
    let indices: Vec<u32> = alive.flat_map(|(t, _)| *t).collect();
    let repaired = compacted(mesh.vertices(), FaceArity::Triangle, indices);
    let largest_mm = if repaired.mesh.n_vertices() == mesh.n_vertices() {
        0.0
    } else {
        let index = ClosestPointIndex::new(&repaired.mesh);
        mesh.vertices().iter().map(|p| (index.closest(p).point - p).norm()).fold(0.0, f64::max)
    };
    Simplified { repaired, largest_mm }
}

struct Collapsing<'a> {
    vertices: &'a [Point3<f64>],
    triangles: Vec<[u32; 3]>,
    alive: Vec<bool>,
    /// The faces at each vertex.
    at_vertex: Vec<Vec<u32>>,
    quadrics: Vec<Matrix4<f64>>,
    /// Whether each vertex is on the boundary.
    boundary: Vec<bool>,
    /// Vertices that must be kept.
    fixed: Vec<bool>,
    /// Version of each vertex, raised when the cost of one of its collapses may have changed.
    version: Vec<u32>,
    queue: BinaryHeap<Reverse<Collapse>>,
}

/// A candidate: bits of the cost, the vertex to drop, the vertex to keep, the versions of both.
type Collapse = (u64, u32, u32, [u32; 2]);

impl<'a> Collapsing<'a> {
    fn new(mesh: &'a SurfaceMesh) -> Self {
        let (vertices, triangles) = (mesh.vertices(), mesh.triangles());
        let n = vertices.len();
        let mut state = Collapsing {
            vertices,
            alive: vec![true; triangles.len()],
            at_vertex: vec![Vec::new(); n],
            quadrics: vec![Matrix4::zeros(); n],
            boundary: vec![false; n],
            fixed: vec![false; n],
            version: vec![0; n],
            queue: BinaryHeap::new(),
            triangles,
        };
        for (f, t) in (0u32..).zip(&state.triangles) {
            let normal = state.normal(t);
            let plane = plane(&normal.normalize(), &vertices[t[0] as usize]) * (normal.norm() / 2.0);
            for &v in t {
                state.at_vertex[v as usize].push(f);
                if plane.iter().all(|x| x.is_finite()) {
                    state.quadrics[v as usize] += plane;
                }
            }
        }
        state.find_borders();
        for v in 0..n as u32 {
            state.offer(v);
        }
        state
    }

    /// Adds planes at boundaries, and fixes vertices where the surface is not a manifold.
    fn find_borders(&mut self) {
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * self.triangles.len());
        for (f, t) in (0u32..).zip(&self.triangles) {
            sides.extend((0..3).map(|k| (t[k], t[(k + 1) % 3])).map(|(a, b)| ([a.min(b), a.max(b)], f)));
        }
        sides.sort_unstable();
        for uses in sides.chunk_by(|a, b| a.0 == b.0) {
            let ends = uses[0].0;
            match uses.len() {
                1 => {
                    let [a, b] = ends.map(|v| self.vertices[v as usize]);
                    let across = self.normal(&self.triangles[uses[0].1 as usize]).cross(&(b - a));
                    let plane = plane(&across.normalize(), &a) * (BOUNDARY_WEIGHT * (b - a).norm_squared());
                    for v in ends {
                        self.boundary[v as usize] = true;
                        if plane.iter().all(|x| x.is_finite()) {
                            self.quadrics[v as usize] += plane;
                        }
                    }
                }
                2 => {}
                _ => ends.iter().for_each(|&v| self.fixed[v as usize] = true),
            }
        }
        for v in 0..self.vertices.len() as u32 {
            // A fan has as many neighbors as faces, or one more at a boundary.
            let fan = self.at_vertex[v as usize].len() + usize::from(self.boundary[v as usize]);
            if fan > 0 && self.neighbors(v).len() != fan {
                self.fixed[v as usize] = true;
            }
        }
    }

    fn normal(&self, t: &[u32; 3]) -> Vector3<f64> {
        let [a, b, c] = t.map(|v| self.vertices[v as usize]);
        (b - a).cross(&(c - a))
    }

    /// Vertices that share an edge with `v`, ascending.
    fn neighbors(&self, v: u32) -> Vec<u32> {
        let faces = self.at_vertex[v as usize].iter();
        let mut found: Vec<u32> = faces.flat_map(|&f| self.triangles[f as usize]).filter(|&other| other != v).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Puts the cheapest collapse of `v` into the queue.
    fn offer(&mut self, v: u32) {
        if self.fixed[v as usize] || self.at_vertex[v as usize].is_empty() {
            return;
        }
        let cost = |keep: u32| {
            let p = self.vertices[keep as usize];
            let at = Vector4::new(p.x, p.y, p.z, 1.0);
            let planes = (self.quadrics[v as usize] + self.quadrics[keep as usize]) * at;
            let length = (self.vertices[v as usize] - p).norm_squared();
            let area = self.quadrics[v as usize].fixed_view::<3, 3>(0, 0).trace();
            at.dot(&planes).max(0.0) + LENGTH_WEIGHT * area * length
        };
        let costs = self.neighbors(v).into_iter().map(|keep| (cost(keep).to_bits(), keep));
        // Only collapses that are possible now; others may become possible when a neighbor is gone.
        let mut costs: Vec<(u64, u32)> = costs.collect();
        costs.sort_unstable();
        let possible = costs.into_iter().find(|&(_, keep)| self.possible(v, keep));
        if let Some((cost, keep)) = possible {
            let versions = [v, keep].map(|v| self.version[v as usize]);
            self.queue.push(Reverse((cost, v, keep, versions)));
        }
    }

    /// Whether `drop` can be collapsed onto `keep` without a change of topology and without turning a face over.
    fn possible(&self, drop: u32, keep: u32) -> bool {
        let shared = self.at_vertex[drop as usize].iter();
        let shared = shared.filter(|&&f| self.triangles[f as usize].contains(&keep)).count();
        if self.boundary[drop as usize] && !(self.boundary[keep as usize] && shared == 1) {
            return false;
        }
        let (mine, others) = (self.neighbors(drop), self.neighbors(keep));
        let common = mine.iter().filter(|v| others.binary_search(v).is_ok()).count();
        // The last faces of a piece: a tetrahedron, or a single triangle.
        if common != shared || mine.len() < 3 && shared == 1 || mine.len() == 3 && others.len() == 3 {
            return false;
        }
        self.at_vertex[drop as usize].iter().map(|&f| self.triangles[f as usize]).filter(|t| !t.contains(&keep)).all(
            |t| {
                let before = self.normal(&t);
                let after = self.normal(&t.map(|v| if v == drop { keep } else { v }));
                let product = before.norm() * after.norm();
                before.dot(&after) > LEAST_COSINE * product || product == 0.0 && after.norm() > 0.0
            },
        )
    }

    fn next(&mut self) -> Option<(u32, u32)> {
        loop {
            let Reverse((_, drop, keep, versions)) = self.queue.pop()?;
            if self.at_vertex[drop as usize].is_empty() || self.version[drop as usize] != versions[0] {
                continue;
            }
            if self.version[keep as usize] == versions[1] && self.possible(drop, keep) {
                return Some((drop, keep));
            }
            // The neighborhoods have changed.
            self.version[drop as usize] += 1;
            self.offer(drop);
        }
    }

    fn collapse(&mut self, drop: u32, keep: u32) {
        for f in std::mem::take(&mut self.at_vertex[drop as usize]) {
            if self.triangles[f as usize].contains(&keep) {
                self.alive[f as usize] = false;
                for v in self.triangles[f as usize] {
                    self.at_vertex[v as usize].retain(|&other| other != f);
                }
            } else {
                self.triangles[f as usize].iter_mut().filter(|v| **v == drop).for_each(|v| *v = keep);
                self.at_vertex[keep as usize].push(f);
            }
        }
        let quadric = self.quadrics[drop as usize];
        self.quadrics[keep as usize] += quadric;
        for v in std::iter::once(keep).chain(self.neighbors(keep)) {
            self.version[v as usize] += 1;
            self.offer(v);
        }
    }
}

/// The squared distance from the plane through `point` as a quadratic form.
fn plane(normal: &Vector3<f64>, point: &Point3<f64>) -> Matrix4<f64> {
    let p = Vector4::new(normal.x, normal.y, normal.z, -normal.dot(&point.coords));
    p * p.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{ellipsoid, torus};
    use crate::topology::topology_report;
    use proptest::prelude::*;

    #[test]
    fn a_ball_keeps_its_shape_with_a_tenth_of_the_vertices() {
        let ball = ellipsoid(Vector3::new(12.0, 9.0, 6.0), 4);
        let Simplified { repaired: RepairedMesh { mesh, numbering }, largest_mm } = simplify(&ball, 256);
        let report = topology_report(&mesh);
        assert_eq!((report.n_vertices, report.genus), (256, Some(0)));
        for (v, p) in mesh.vertices().iter().enumerate() {
            assert_eq!(ball.vertices()[numbering.original(v as u32) as usize], *p);
        }
        assert!((mesh.signed_volume() / ball.signed_volume() - 1.0).abs() < 0.03, "{}", mesh.signed_volume());
        let index = ClosestPointIndex::new(&mesh);
        let farthest = ball.vertices().iter().map(|p| (index.closest(p).point - p).norm()).fold(0.0, f64::max);
        assert_eq!(farthest, largest_mm);
        assert!(farthest < 0.3, "{farthest}");
    }

    #[test]
    fn a_boundary_stays_where_it_is() {
        // A square sheet of 20 x 20 cells: its corners and sides are kept.
        let vertices = (0..441).map(|k| Point3::new(f64::from(k % 21), f64::from(k / 21), 0.0)).collect();
        let quads = (0..400u32).map(|k| k / 20 * 21 + k % 20);
        let indices = quads.flat_map(|a| [a, a + 1, a + 22, a + 21]).collect();
        let sheet = SurfaceMesh::new(vertices, FaceArity::Quad, indices).unwrap();
        let small = simplify(&sheet, 30);
        assert_eq!(small.repaired.mesh.n_vertices(), 30);
        assert!((small.repaired.mesh.area() - 400.0).abs() < 1e-9);
        assert!((small.repaired.mesh.rim_lengths().iter().sum::<f64>() - 80.0).abs() < 1e-9);
        assert!(small.largest_mm < 1e-9);
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
        #[test]
        fn topology_and_pieces_stay_however_few_vertices_are_wanted(
            around in 5u32..20, across in 5u32..16, wanted in 1usize..200, is_quad in any::<bool>(),
        ) {
            let arity = if is_quad { FaceArity::Quad } else { FaceArity::Triangle };
            let ring = torus(9.0, 3.0, around, across, arity);
            let small = simplify(&ring, wanted).repaired.mesh;
            let report = topology_report(&small);
            prop_assert_eq!((report.genus, report.n_components), (Some(1), 1));
            prop_assert!(small.n_vertices() <= wanted.max(30).min(ring.n_vertices()), "{}", small.n_vertices());
        }
    }

    #[test]
    fn a_mesh_that_is_small_enough_and_one_that_is_no_manifold_are_left() {
        let ring = torus(9.0, 3.0, 8, 6, FaceArity::Triangle);
        assert_eq!(simplify(&ring, 48).repaired.mesh, ring);
        // Three sheets at one edge.
        let places = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.5], [-1.0, 1.0, 0.5], [-1.0, -1.0, 0.5]];
        let faces = vec![0, 1, 2, 1, 0, 3, 0, 1, 4];
        let book = SurfaceMesh::new(places.map(Point3::from).to_vec(), FaceArity::Triangle, faces).unwrap();
        assert_eq!(simplify(&book, 3).repaired.mesh, book);
    }
}
