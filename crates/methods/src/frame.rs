//! Coordinates in which the methods work.

use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// Coordinates about the centroid of a surface, in square roots of its area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    center: Point3<f64>,
    unit_mm: f64,
}

impl Frame {
    /// The frame of `mesh`; `None` for a surface without area.
    pub fn of(mesh: &SurfaceMesh) -> Option<Frame> {
        let unit_mm = mesh.area().sqrt();
        (unit_mm.is_finite() && unit_mm > 0.0).then(|| Frame { center: mesh.centroid(), unit_mm })
    }

    /// A point, mm, in this frame.
    pub fn enter(&self, p: &Point3<f64>) -> Point3<f64> {
        Point3::from((p - self.center) / self.unit_mm)
    }

    /// A point of this frame in mm.
    pub fn leave(&self, p: &Point3<f64>) -> Point3<f64> {
        self.center + p.coords * self.unit_mm
    }
}
