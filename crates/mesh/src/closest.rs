//! Closest points on the triangles of a surface.

use super::SurfaceMesh;
use nalgebra::Point3;
use parry3d_f64::math::Vector;
use parry3d_f64::query::PointQueryWithLocation;
use parry3d_f64::shape::TriMesh;
use std::ops::{Add, Mul};

/// Upper bound of the memory of the tree per triangle, bytes: its box, the boxes above it, and their places. A test
/// compares it with the actual memory.
const TREE_BYTES_PER_TRIANGLE: usize = 192;

/// Closest-point queries against the triangles of one surface (quads are split along a diagonal).
pub struct ClosestPointIndex {
    tree: TriMesh,
    triangles: Vec<[u32; 3]>,
}

/// The point of a surface that is closest to a query point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosestPoint {
    /// The point, mm.
    pub point: Point3<f64>,
    /// The triangle it lies on, by its corners.
    pub triangle: [u32; 3],
    /// Its barycentric coordinates there, in the order of the corners.
    pub barycentric: [f64; 3],
}

impl ClosestPoint {
    /// `value` at the three corners, interpolated with the barycentric coordinates.
    pub fn blend<T: Mul<f64, Output = T> + Add<Output = T>>(&self, value: impl Fn(usize) -> T) -> T {
        let [a, b, c] = std::array::from_fn(|k| value(self.triangle[k] as usize) * self.barycentric[k]);
        a + b + c
    }

    /// The corner of the triangle with the largest barycentric coordinate, the lowest index of equal ones.
    pub fn nearest_corner(&self) -> u32 {
        let mut best = 0;
        for k in 1..3 {
            let more = self.barycentric[k] > self.barycentric[best];
            let tie = self.barycentric[k] == self.barycentric[best] && self.triangle[k] < self.triangle[best];
            if more || tie {
                best = k;
            }
        }
        self.triangle[best]
    }
}

impl ClosestPointIndex {
    /// A bounding-volume tree over the triangles of `mesh`; `O(n log n)`.
    pub fn new(mesh: &SurfaceMesh) -> Self {
        let vertices = mesh.vertices().iter().map(|p| Vector::new(p.x, p.y, p.z)).collect();
        let triangles = mesh.triangles();
        // The tree rejects only an empty list of triangles, and a `SurfaceMesh` has at least one face.
        let tree = TriMesh::new(vertices, triangles.clone()).unwrap_or_else(|_| unreachable!("a mesh without faces"));
        ClosestPointIndex { tree, triangles }
    }

    /// Upper bound of the memory of an index over `mesh`, bytes.
    pub fn heap_bytes_over(mesh: &SurfaceMesh) -> usize {
        let n_triangles = mesh.n_faces() * (mesh.arity().n_corners() - 2);
        // The tree has a second copy of the triangles, and the vertices.
        let each = TREE_BYTES_PER_TRIANGLE + 2 * size_of::<[u32; 3]>();
        n_triangles * each + size_of_val(mesh.vertices())
    }

    /// Memory that this index takes, bytes.
    pub fn heap_bytes(&self) -> usize {
        self.tree.heap_memory_size() + size_of_val(self.triangles.as_slice())
    }

    /// The closest point of the surface; `O(log n)` on surfaces.
    pub fn closest(&self, query: &Point3<f64>) -> ClosestPoint {
        let at = Vector::new(query.x, query.y, query.z);
        let (projection, (id, location)) = self.tree.project_local_point_and_get_location(at, false);
        let barycentric = location.barycentric_coordinates().unwrap_or([1.0, 0.0, 0.0]);
        ClosestPoint {
            point: Point3::new(projection.point.x, projection.point.y, projection.point.z),
            triangle: self.triangles[id as usize],
            barycentric,
        }
    }
}
