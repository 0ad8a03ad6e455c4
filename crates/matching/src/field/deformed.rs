//! A surface deformed onto another.

use super::agreement::Agreement;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_registration::RigidTransform;
use nalgebra::Point3;
use rayon::prelude::*;

/// A surface deformed onto another.
pub(crate) struct Deformed {
    /// The vertices of the source, mm.
    pub moved: Vec<Point3<f64>>,
    /// Posterior variance of each, mm².
    pub variances: Vec<f64>,
    /// The rigid transform of these correspondences.
    pub transform: RigidTransform,
    /// Robust standard deviation of the distance from the target along its normals after the fine stage, mm.
    pub residual_mm: f64,
    /// How well the surfaces agree after the deformation.
    pub agreement: Agreement,
    /// Mean angular distortion of the deformation, [`super::strain::distortion`].
    pub distortion: f64,
}

impl Deformed {
    /// The inverse: the vertices of `target` moved to `source`, the surface that was deformed. `None` if a number is
    /// not finite.
    ///
    /// Cost `O(n' log n)`.
    pub(crate) fn inverse(self, source: &SurfaceMesh, target: &SurfaceMesh) -> Option<Deformed> {
        let outwards = if self.transform.is_reflection() { -1.0 } else { 1.0 };
        let deformed = source.with_vertices(self.moved).ok()?;
        let (before, after) = (source.vertex_normals(), deformed.vertex_normals());
        let index = ClosestPointIndex::new(&deformed);
        let on_rim = deformed.boundary_vertices();
        let back = self.transform.inverse();
        let inverse = |q: &Point3<f64>| {
            let at = index.closest(q);
            if on_rim.as_ref().is_some_and(|ends| at.is_between(|k| ends[k])) {
                // A vertex beyond the rim keeps the offset that it has from the deformed surface, rotated back.
                let image = at.blend(|k| source.vertices()[k].coords) + back.rotation * (q - at.point);
                return (Point3::from(image), at.blend(|k| self.variances[k]));
            }
            let height = outwards * at.blend(|k| after[k]).normalize().dot(&(q - at.point));
            let image = at.blend(|k| source.vertices()[k].coords) + at.blend(|k| before[k]).normalize() * height;
            (Point3::from(image), at.blend(|k| self.variances[k]))
        };
        let (moved, variances) = target.vertices().par_iter().map(inverse).unzip();
        Some(Deformed { moved, variances, transform: self.transform.inverse(), ..self })
    }
}
