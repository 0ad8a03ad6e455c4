//! A pose that may bend: what is left between two shapes in one pose, as a smooth field.
//!
//! Where shapes differ, the rigid transform of least distance is not the one of the anatomy: a bent end turns the whole
//! about its long axis. With a field to take up the difference, the pairs of the assignment tell better what lies on
//! what, and the absolute orientation of those pairs is the pose.
//!
//! The field is a Gaussian process with kernel `s² exp(−‖p − q‖² / 2w²)` by the first terms of its Taylor series,
//! `exp(−‖p‖² / 2w²) pᵅ / (√α! w^|α|)` for all `|α| ≤ 3`: twenty functions about the centroid, each with variance `s²`.
//!
//! Sources: Cotter, Keshet, Srebro, "Explicit approximations of the Gaussian kernel", 2011 (the functions); Hirose, IEEE
//! PAMI 43(7), 2021 (such a prior in point-set registration).

use super::patches::Patch;
use nalgebra::{DMatrix, Point3, Vector3};

/// Largest degree of a function.
const DEGREE: i32 = 3;

/// A field that was fitted.
pub(super) struct Bent {
    /// Displacement of every patch, mm.
    pub displacements: Vec<Vector3<f64>>,
    /// `−ln` of the density of the field under the prior, up to a constant.
    pub cost: f64,
}

/// The functions of the field at every patch of one surface.
pub(super) struct Bending {
    /// `n × 20`, a row a patch.
    values: DMatrix<f64>,
}

impl Bending {
    /// Functions of width `width_mm` and standard deviation `amplitude_mm` about the origin.
    pub fn new(patches: &[Patch], width_mm: f64, amplitude_mm: f64) -> Self {
        let mut powers = Vec::new();
        for degree in 0..=DEGREE {
            for x in 0..=degree {
                for y in 0..=degree - x {
                    powers.push([x, y, degree - x - y]);
                }
            }
        }
        let factorial = |n: i32| f64::from((1..=n).product::<i32>());
        let values = DMatrix::from_fn(patches.len(), powers.len(), |i, k| {
            let p = patches[i].center / width_mm;
            let term = |a: usize| p[a].powi(powers[k][a]) / factorial(powers[k][a]).sqrt();
            amplitude_mm * (-0.5 * p.norm_squared()).exp() * term(0) * term(1) * term(2)
        });
        Bending { values }
    }

    /// The most probable field where patch `i` at `base[i]` is seen at `targets[i]` with precision `weights[i]` (1/mm²)
    /// along each axis. `None` for numbers that are not finite. Cost `O(n)`.
    pub fn fit(&self, base: &[Patch], targets: &[Point3<f64>], weights: &[f64]) -> Option<Bent> {
        let (n, m) = self.values.shape();
        let weighted = DMatrix::from_fn(n, m, |i, k| weights[i] * self.values[(i, k)]);
        let offsets = DMatrix::from_fn(n, 3, |i, a| targets[i][a] - base[i].center[a]);
        let system = weighted.tr_mul(&self.values) + DMatrix::<f64>::identity(m, m);
        let coefficients = system.cholesky()?.solve(&weighted.tr_mul(&offsets));
        let field = &self.values * &coefficients;
        let displacements = field.row_iter().map(|u| Vector3::new(u[0], u[1], u[2])).collect();
        Some(Bent { displacements, cost: 0.5 * coefficients.norm_squared() })
    }
}
