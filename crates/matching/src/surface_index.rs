//! Closest points of a surface, with normals, for registration.

use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_registration::ClosestSurfacePoint;
use nalgebra::{Point3, Vector3};

/// Closest points of a surface, with the normals of the vertices interpolated over the triangle.
pub(super) struct SurfaceIndex {
    pub index: ClosestPointIndex,
    normals: Vec<Vector3<f64>>,
}

impl SurfaceIndex {
    pub(crate) fn new(surface: &SurfaceMesh) -> Self {
        SurfaceIndex::with_normals(surface, surface.vertex_normals())
    }

    /// As [`SurfaceIndex::new`], with other unit normals of the vertices, such as those of a smoother surface.
    pub(crate) fn with_normals(surface: &SurfaceMesh, normals: Vec<Vector3<f64>>) -> Self {
        SurfaceIndex { index: ClosestPointIndex::new(surface), normals }
    }

    /// Memory that an index over `surface` takes at most, bytes.
    pub(crate) fn heap_bytes_over(surface: &SurfaceMesh) -> usize {
        ClosestPointIndex::heap_bytes_over(surface) + surface.n_vertices() * size_of::<Vector3<f64>>()
    }

    /// Memory of this index, bytes.
    #[cfg(test)]
    pub(crate) fn heap_bytes(&self) -> usize {
        self.index.heap_bytes() + size_of_val(self.normals.as_slice())
    }
}

impl ClosestSurfacePoint for SurfaceIndex {
    fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
        let found = self.index.closest(query);
        let blended = found.blend(|k| self.normals[k]);
        (found.point, blended.try_normalize(1e-12).unwrap_or_else(Vector3::z))
    }
}
