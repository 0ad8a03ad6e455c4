//! Basis functions of a smooth displacement field by the Taylor series of one Gaussian kernel, and the field fitted
//! with them.
//!
//! The kernel is `s² exp(−‖p − q‖² / 2w²)`; its functions are `s exp(−‖p‖² / 2w²) pᵅ / (√α! w^|α|)` for all `|α| ≤ 3`:
//! twenty, with independent standard normal coefficients.
//!
//! Sources: Cotter, Keshet, Srebro, "Explicit approximations of the Gaussian kernel", 2011 (the functions); Hirose,
//! IEEE PAMI 43(7), 2021 (such a prior in point-set registration).

use super::GaussianKernel;
use nalgebra::{DMatrix, Point3, Vector3};

/// Largest degree of a function.
const DEGREE: i32 = 3;

/// A fitted field.
pub(crate) struct TaylorField {
    /// Displacement of every point, mm.
    pub displacements: Vec<Vector3<f64>>,
    /// `−ln` of the density of the field under the prior, up to a constant.
    pub cost: f64,
}

/// The values of the functions at the points of one surface.
pub(crate) struct TaylorBasis {
    /// `n × 20`, a row per point.
    values: DMatrix<f64>,
}

impl TaylorBasis {
    /// The functions of `kernel`, expanded about the origin, at `points`, mm.
    pub(crate) fn new(points: &[Point3<f64>], kernel: GaussianKernel) -> Self {
        let mut powers = Vec::new();
        for degree in 0..=DEGREE {
            for x in 0..=degree {
                for y in 0..=degree - x {
                    powers.push([x, y, degree - x - y]);
                }
            }
        }
        let factorial = |n: i32| f64::from((1..=n).product::<i32>());
        let values = DMatrix::from_fn(points.len(), powers.len(), |i, k| {
            let p = points[i].coords / kernel.width_mm;
            let term = |a: usize| p[a].powi(powers[k][a]) / factorial(powers[k][a]).sqrt();
            kernel.amplitude_mm * (-0.5 * p.norm_squared()).exp() * term(0) * term(1) * term(2)
        });
        TaylorBasis { values }
    }

    /// The most probable field if `displacement(i)`, mm, is observed at point `i` with `precision[i]`, 1/mm², along
    /// each axis. `None` if a number is not finite. Cost `O(n)`.
    pub(crate) fn fit(&self, displacement: impl Fn(usize) -> Vector3<f64>, precision: &[f64]) -> Option<TaylorField> {
        let (n, m) = self.values.shape();
        let weighted = DMatrix::from_fn(n, m, |i, k| precision[i] * self.values[(i, k)]);
        let observed = DMatrix::from_fn(n, 3, |i, a| displacement(i)[a]);
        let system = weighted.tr_mul(&self.values) + DMatrix::<f64>::identity(m, m);
        let coefficients = system.cholesky()?.solve(&weighted.tr_mul(&observed));
        let field = &self.values * &coefficients;
        let displacements = field.row_iter().map(|u| Vector3::new(u[0], u[1], u[2])).collect();
        Some(TaylorField { displacements, cost: 0.5 * coefficients.norm_squared() })
    }
}
