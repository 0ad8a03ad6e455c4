//! The basis functions of a displacement field, and the coordinates in which they are smooth.

use super::options::DisplacementOptions;
use super::unbending::Unbending;
use crate::pair::surfaces::diagonal_mm;
use crate::surface::smooth::SmoothSurface;
use faer::Mat;
use homolog_mesh::SurfaceMesh;
use homolog_registration::deformation::{FieldBasis, SmoothPrior};
use nalgebra::Point3;
use std::sync::Arc;

/// Basis functions over the source.
#[derive(Clone)]
pub(crate) struct Functions {
    basis: FieldBasis,
    /// Map to the bending-invariant form, in whose coordinates the functions are then smooth: places far apart along
    /// the surface are far apart there even if they are close in space. `None`: the functions are smooth in space.
    unbending: Option<Arc<Unbending>>,
}

impl Functions {
    /// The functions over `points` of the source, mm. `None` without points, or if a number is not finite.
    pub(crate) fn new(
        points: &[Point3<f64>],
        prior: SmoothPrior,
        n_inducing: usize,
        unbending: Option<Arc<Unbending>>,
    ) -> Option<Functions> {
        let basis = match &unbending {
            None => FieldBasis::new(points, prior, n_inducing)?,
            Some(unbending) => FieldBasis::new(&unbending.of(points), prior, n_inducing)?,
        };
        Some(Functions { basis, unbending })
    }

    /// The functions of the displacement of `mesh`, on its smooth version.
    pub(crate) fn over(mesh: &SurfaceMesh, smooth: &SmoothSurface, options: &DisplacementOptions) -> Option<Functions> {
        let prior = options.prior.of(diagonal_mm(mesh));
        Functions::new(smooth.mesh.vertices(), prior, options.prior.n_inducing, None)
    }

    /// Functions with another prior, in the same coordinates.
    pub(crate) fn with_prior(
        &self,
        points: &[Point3<f64>],
        prior: SmoothPrior,
        n_inducing: usize,
    ) -> Option<Functions> {
        Functions::new(points, prior, n_inducing, self.unbending.clone())
    }

    /// The value of every function at every point, `n × M`.
    pub(crate) fn values(&self, points: &[Point3<f64>]) -> Mat<f64> {
        match &self.unbending {
            None => self.basis.values(points),
            Some(unbending) => self.basis.values(&unbending.of(points)),
        }
    }

    /// Variance of the prior along an axis, mm², that the functions do not express at points where these are their
    /// `values`.
    pub(crate) fn unexpressed(&self, values: &Mat<f64>) -> Vec<f64> {
        self.basis.unexpressed(values.as_ref())
    }

    /// `points` in the coordinates in which the functions are smooth, mm.
    pub(crate) fn coordinates(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        match &self.unbending {
            None => points.to_vec(),
            Some(unbending) => unbending.of(points),
        }
    }
}
