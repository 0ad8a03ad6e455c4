//! Moments of the area of a surface.

use homolog_geometry::curvature::vertex_areas;
use homolog_mesh::SurfaceMesh;
use homolog_registration::weighted_moments;
use nalgebra::{Matrix3, Vector3};

/// Moments of the area of a surface.
pub(crate) struct AreaMoments {
    /// The mean of the area, mm.
    pub mean: Vector3<f64>,
    /// Integral over the area of `d dᵀ` for offsets `d` from the mean, mm⁴.
    pub scatter: Matrix3<f64>,
    /// Its area, mm².
    pub area: f64,
}

impl AreaMoments {
    /// The moments of `mesh`; `None` if a number is not finite. Cost `O(n)`.
    pub(crate) fn of(mesh: &SurfaceMesh) -> Option<AreaMoments> {
        let areas = vertex_areas(mesh);
        let area: f64 = areas.iter().sum();
        let (mean, scatter) = weighted_moments(mesh.vertices(), &areas, area)?;
        Some(AreaMoments { mean, scatter, area })
    }

    /// Variance of the points of the surface, mm².
    pub(crate) fn variance(&self) -> Matrix3<f64> {
        self.scatter / self.area
    }
}
