//! Real surfaces with a known deformation: a patch that is moved along the normals, most in its middle.

use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use nalgebra::{Point3, Vector3};

/// A deformation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Plant {
    /// Radius of the patch, mm.
    pub(crate) radius_mm: f64,
    /// Displacement of its middle along the outward normal, mm; negative: thinned.
    pub(crate) height_mm: f64,
    /// Place of the middle along the structure, from back (0) to front (1).
    pub(crate) share: f64,
}

impl Plant {
    /// The middle of the patch, which is determined without a correspondence: the highest vertex at this share of the
    /// structure, in the scanner's axes.
    pub(crate) fn middle(&self, mesh: &SurfaceMesh) -> Point3<f64> {
        let ys = || mesh.vertices().iter().map(|p| p.y);
        let (low, high) = (ys().fold(f64::INFINITY, f64::min), ys().fold(f64::NEG_INFINITY, f64::max));
        let is_near = |p: &&Point3<f64>| ((p.y - low) / (high - low) - self.share).abs() < 0.04;
        let highest = mesh.vertices().iter().filter(is_near).max_by(|a, b| a.z.total_cmp(&b.z));
        highest.copied().unwrap_or_else(|| mesh.vertices()[0])
    }

    /// Displacement at a distance from the middle, mm.
    fn height(&self, distance: f64) -> f64 {
        let within = (distance / self.radius_mm).min(1.0);
        self.height_mm * 0.5 * (1.0 + (std::f64::consts::PI * within).cos())
    }

    /// The surface with the deformation.
    pub(crate) fn planted(&self, mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
        let (middle, normals) = (self.middle(mesh), mesh.vertex_normals());
        let moved = |(p, normal): (&Point3<f64>, &Vector3<f64>)| p + self.height((p - middle).norm()) * normal;
        mesh.vertices().iter().zip(&normals).map(moved).collect()
    }

    /// Points on the surface, each with the displacement of the point of the surface: the true correspondence.
    pub(crate) fn carried(&self, mesh: &SurfaceMesh, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let (index, planted) = (ClosestPointIndex::new(mesh), self.planted(mesh));
        let moved = |p: &Point3<f64>| p + index.closest(p).blend(|v| planted[v] - mesh.vertices()[v]);
        points.iter().map(moved).collect()
    }

    /// The displacement at each of these vertices of a mean shape, mm: the deformation as a study should find it.
    pub(crate) fn expected(&self, mean: &SurfaceMesh) -> Vec<f64> {
        let middle = self.middle(mean);
        mean.vertices().iter().map(|p| self.height((p - middle).norm())).collect()
    }
}
