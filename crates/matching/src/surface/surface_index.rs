//! Closest points of a surface, with normals, for registration.

use homolog_mesh::{ClosestPoint, ClosestPointIndex, SurfaceMesh};
use homolog_registration::ClosestSurfacePoint;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// The closest points of points that move step by step. The last step makes the next one faster.
#[derive(Default)]
pub(crate) struct ClosestInSteps(Vec<ClosestPoint>);

impl ClosestInSteps {
    /// The closest points of `points`, which were elsewhere before, on the surface of all steps.
    pub(crate) fn of(&mut self, index: &ClosestPointIndex, points: &[Point3<f64>]) -> &[ClosestPoint] {
        if self.0.len() == points.len() {
            self.0.par_iter_mut().zip(points).for_each(|(at, p)| *at = index.closest_from(p, at));
        } else {
            self.0 = points.par_iter().map(|p| index.closest(p)).collect();
        }
        &self.0
    }
}

/// Closest points of a surface, with the normals of the vertices interpolated over the triangle.
pub(crate) struct SurfaceIndex {
    pub index: ClosestPointIndex,
    normals: Vec<Vector3<f64>>,
    /// For an open surface, whether each vertex is on the boundary.
    on_boundary: Option<Vec<bool>>,
}

impl SurfaceIndex {
    pub(crate) fn new(surface: &SurfaceMesh) -> Self {
        SurfaceIndex::with_normals(surface, surface.vertex_normals())
    }

    /// As [`SurfaceIndex::new`], with other unit normals of the vertices, for example of a smoother surface.
    pub(crate) fn with_normals(surface: &SurfaceMesh, normals: Vec<Vector3<f64>>) -> Self {
        SurfaceIndex { index: ClosestPointIndex::new(surface), normals, on_boundary: surface.boundary_vertices() }
    }

    /// Whether `found` is on the boundary of the surface.
    pub(crate) fn is_at_rim(&self, found: &ClosestPoint) -> bool {
        self.on_boundary.as_ref().is_some_and(|ends| found.is_between(|k| ends[k]))
    }

    fn with_normal(&self, found: &ClosestPoint) -> (Point3<f64>, Vector3<f64>) {
        let blended = found.blend(|k| self.normals[k]);
        (found.point, blended.try_normalize(1e-12).unwrap_or_else(Vector3::z))
    }

    /// Most memory of an index over `surface`, bytes.
    pub(crate) fn heap_bytes_over(surface: &SurfaceMesh) -> usize {
        ClosestPointIndex::heap_bytes_over(surface)
            + surface.n_vertices() * (size_of::<Vector3<f64>>() + size_of::<bool>())
    }

    /// Memory of this index, bytes.
    #[cfg(test)]
    pub(crate) fn heap_bytes(&self) -> usize {
        let on_boundary = self.on_boundary.as_ref().map_or(0, |b| size_of_val(b.as_slice()));
        self.index.heap_bytes() + size_of_val(self.normals.as_slice()) + on_boundary
    }
}

impl ClosestSurfacePoint for SurfaceIndex {
    fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
        self.with_normal(&self.index.closest(query))
    }

    fn closest_inside(&self, query: &Point3<f64>) -> Option<(Point3<f64>, Vector3<f64>)> {
        let found = self.index.closest(query);
        (!self.is_at_rim(&found)).then(|| self.with_normal(&found))
    }
}

#[cfg(test)]
mod tests {
    use super::SurfaceIndex;
    use homolog_mesh::{FaceArity, SurfaceMesh};
    use homolog_registration::ClosestSurfacePoint;
    use nalgebra::Point3;

    #[test]
    fn a_closest_point_on_the_rim_is_none_inside() {
        // A square of 4 × 4 cells in the plane.
        let vertices = (0..25).map(|k| Point3::new(f64::from(k % 5), f64::from(k / 5), 0.0)).collect();
        let cell = |k: u32| {
            let v = k % 4 + 5 * (k / 4);
            [v, v + 1, v + 6, v, v + 6, v + 5]
        };
        let square = SurfaceMesh::new(vertices, FaceArity::Triangle, (0..16).flat_map(cell).collect()).unwrap();
        let index = SurfaceIndex::new(&square);
        for (x, y, inside) in [(1.3, 2.2, true), (0.1, 3.9, true), (-0.1, 2.0, false), (5.0, 5.0, false)] {
            let query = Point3::new(x, y, 0.4);
            assert_eq!(index.closest_inside(&query), inside.then(|| index.closest(&query)), "{x} {y}");
        }
        assert!(index.is_at_rim(&index.index.closest(&Point3::new(2.0, -3.0, 0.0))));
    }
}
