//! The posterior of a displacement field given observations.

use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::linalg::solvers::{DenseSolveCore, Llt, Solve};
use faer::{Accum, Mat, MatRef, Par, Side};
use nalgebra::{Matrix3, Vector3};

/// An observed displacement at one point, with Gaussian noise that differs along a normal and across it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// Displacement, mm.
    pub displacement: Vector3<f64>,
    /// Unit normal.
    pub normal: Vector3<f64>,
    /// Precision along the normal, 1/mm².
    pub along: f64,
    /// Precision across it, 1/mm².
    pub across: f64,
}

impl Observation {
    /// An observation with the same precision, 1/mm², in every direction.
    pub fn isotropic(displacement: Vector3<f64>, precision: f64) -> Self {
        Observation { displacement, normal: Vector3::x(), along: precision, across: precision }
    }

    fn precision(&self) -> Matrix3<f64> {
        Matrix3::identity() * self.across + self.normal * self.normal.transpose() * (self.along - self.across)
    }
}

/// The posterior of a field: mean and precision of its coefficients.
#[derive(Debug, Clone)]
pub struct FittedField {
    /// `M × 3`.
    pub coefficients: Mat<f64>,
    /// Precision of the coefficients: `3M × 3M`, axis by axis, or `M × M` if it is the same for each axis.
    precision: Llt<f64>,
}

/// The lower triangle of `Φᵀ diag(w) Φ`, which is symmetric; zeros above it. `scaled` is overwritten.
fn weighted_gram(values: MatRef<'_, f64>, weight: impl Fn(usize) -> f64, scaled: &mut Mat<f64>) -> Mat<f64> {
    let weights: Vec<f64> = (0..values.nrows()).map(weight).collect();
    for (mut scaled, values) in scaled.col_iter_mut().zip(values.col_iter()) {
        for (k, weight) in weights.iter().enumerate() {
            scaled[k] = weight * values[k];
        }
    }
    let m = values.ncols();
    let mut gram = Mat::zeros(m, m);
    let (lower, whole) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
    matmul(gram.as_mut(), lower, Accum::Replace, values.transpose(), whole, scaled.as_ref(), whole, 1.0, Par::Seq);
    gram
}

/// The posterior of the field. `values`: every function at every point, `n × M` (see [`super::FieldBasis::values`]);
/// `observations`: one for each point. `None` if the system cannot be solved because a number is not finite.
///
/// # Cost
/// `O(n M² + M³)`; isotropic observations share one `M × M` system between the axes instead of a `3M × 3M` one.
pub fn fit_field(values: MatRef<'_, f64>, observations: &[Observation]) -> Option<FittedField> {
    let (n, m) = (values.nrows(), values.ncols());
    let precision: Vec<Matrix3<f64>> = observations.iter().map(Observation::precision).collect();
    let weighted: Vec<Vector3<f64>> = observations.iter().zip(&precision).map(|(p, w)| w * p.displacement).collect();
    let right_side = values.transpose() * Mat::from_fn(n, 3, |i, a| weighted[i][a]);
    let mut scaled = Mat::zeros(n, m);
    if observations.iter().all(|p| p.along == p.across) {
        let mut system = weighted_gram(values, |i| observations[i].across, &mut scaled);
        for k in 0..m {
            system[(k, k)] += 1.0;
        }
        let factor = system.llt(Side::Lower).ok()?;
        return Some(FittedField { coefficients: factor.solve(&right_side), precision: factor });
    }
    let mut system = Mat::<f64>::identity(3 * m, 3 * m);
    for a in 0..3 {
        for b in 0..=a {
            let block = weighted_gram(values, |i| precision[i][(a, b)], &mut scaled);
            for k in 0..m {
                for l in k..m {
                    system[(a * m + l, b * m + k)] += block[(l, k)];
                    if a != b && l != k {
                        system[(a * m + k, b * m + l)] += block[(l, k)];
                    }
                }
            }
        }
    }
    let factor = system.llt(Side::Lower).ok()?;
    let stacked = Mat::from_fn(3 * m, 1, |k, _| right_side[(k % m, k / m)]);
    let solution = factor.solve(&stacked);
    Some(FittedField { coefficients: Mat::from_fn(m, 3, |k, a| solution[(a * m + k, 0)]), precision: factor })
}

impl FittedField {
    /// Posterior mean of the displacement at every point of `values`, mm.
    pub fn displacements(&self, values: MatRef<'_, f64>) -> Vec<Vector3<f64>> {
        let u = values * &self.coefficients;
        (0..u.nrows()).map(|i| Vector3::new(u[(i, 0)], u[(i, 1)], u[(i, 2)])).collect()
    }

    /// Posterior covariance of the displacement at every point of `values`, mm². Cost `O(n M² + M³)`.
    pub fn covariances(&self, values: MatRef<'_, f64>) -> Vec<Matrix3<f64>> {
        let (n, m) = (values.nrows(), values.ncols());
        let mut found = vec![Matrix3::zeros(); n];
        let covariance = self.precision.inverse();
        let shared = covariance.nrows() == m;
        for a in 0..3 {
            for b in 0..=a {
                if shared && (a, b) != (0, 0) {
                    continue;
                }
                let block = covariance.as_ref().submatrix(a * m, b * m, m, m);
                let product = values * block;
                for (i, c) in found.iter_mut().enumerate() {
                    let value: f64 = (0..m).map(|k| product[(i, k)] * values[(i, k)]).sum();
                    c[(a, b)] = value;
                    c[(b, a)] = value;
                }
            }
        }
        if shared {
            for c in &mut found {
                *c = Matrix3::identity() * c[(0, 0)];
            }
        }
        found
    }

    /// `‖c‖²`: twice the negative logarithm of the field's density under the prior, up to a constant.
    pub fn cost(&self) -> f64 {
        self.coefficients.squared_norm_l2()
    }
}
