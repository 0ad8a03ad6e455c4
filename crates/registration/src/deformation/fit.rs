//! The posterior of a displacement field given observations.

use super::gram::weighted_gram;
use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::linalg::solvers::Solve;
use faer::{Accum, Col, Mat, MatRef, Par, Side, unzip, zip};
use nalgebra::{Matrix3, Vector3};

/// An observed displacement at one point, with Gaussian noise that differs along and across a normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// Displacement, mm.
    pub displacement: Vector3<f64>,
    /// Unit normal.
    pub normal: Vector3<f64>,
    /// Precision along the normal, 1/mm².
    pub along: f64,
    /// Precision across the normal, 1/mm².
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

/// Observation of the displacement at one point: a normal distribution in information form, which may say nothing in
/// some directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Information {
    /// Precision, symmetric and positive semi-definite, 1/mm².
    pub precision: Matrix3<f64>,
    /// Precision times displacement, 1/mm.
    pub vector: Vector3<f64>,
}

impl Information {
    /// No information.
    pub fn none() -> Self {
        Information { precision: Matrix3::zeros(), vector: Vector3::zeros() }
    }

    /// Adds the observation that the product of the displacement with `direction` is `value`, with this precision (1
    /// over the squared unit of `value`).
    pub fn add(&mut self, direction: &Vector3<f64>, value: f64, precision: f64) {
        self.precision += precision * direction * direction.transpose();
        self.vector += precision * value * direction;
    }
}

impl From<&Observation> for Information {
    fn from(observed: &Observation) -> Self {
        let precision = observed.precision();
        Information { precision, vector: precision * observed.displacement }
    }
}

/// The posterior mean of a field.
#[derive(Debug, Clone)]
pub struct FittedField {
    /// Coefficients, `M × 3`.
    pub coefficients: Mat<f64>,
}

/// The posterior mean of the field. `values`: every function at every point, `n × M` (see
/// [`super::FieldBasis::values`]); `observations`: one per point. `None` if the system cannot be solved because a
/// number is not finite.
///
/// # Cost
/// `O(n M² + M³)`; with isotropic observations the axes share one `M × M` system instead of a `3M × 3M` system.
pub fn fit_field(values: MatRef<'_, f64>, observations: &[Observation]) -> Option<FittedField> {
    if observations.iter().any(|p| p.along != p.across) {
        let known: Vec<Information> = observations.iter().map(Information::from).collect();
        return fit_field_to(values, &known);
    }
    let (n, m) = (values.nrows(), values.ncols());
    let right_side =
        values.transpose() * Mat::from_fn(n, 3, |i, a| observations[i].across * observations[i].displacement[a]);
    let weights: Col<f64> = observations.iter().map(|p| p.across).collect();
    let mut scaled = values.to_owned();
    for scaled in scaled.col_iter_mut() {
        zip!(scaled, &weights).for_each(|unzip!(scaled, weight)| *scaled *= weight);
    }
    let mut system = Mat::zeros(m, m);
    let (lower, whole) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
    let (left, right) = (values.transpose(), scaled.as_ref());
    matmul(system.as_mut(), lower, Accum::Replace, left, whole, right, whole, 1.0, Par::Seq);
    for k in 0..m {
        system[(k, k)] += 1.0;
    }
    let factor = system.llt(Side::Lower).ok()?;
    Some(FittedField { coefficients: factor.solve(&right_side) })
}

/// [`fit_field`] with any [`Information`] at each point. Cost `O(n M² + M³)`, with a `3M × 3M` system.
pub fn fit_field_to(values: MatRef<'_, f64>, known: &[Information]) -> Option<FittedField> {
    let (n, m) = (values.nrows(), values.ncols());
    let right_side = values.transpose() * Mat::from_fn(n, 3, |i, a| known[i].vector[a]);
    let precision: Vec<Matrix3<f64>> = known.iter().map(|known| known.precision).collect();
    let mut system = weighted_gram(values, &precision);
    for k in 0..3 * m {
        system[(k, k)] += 1.0;
    }
    let factor = system.llt(Side::Lower).ok()?;
    let stacked = Mat::from_fn(3 * m, 1, |k, _| right_side[(k % m, k / m)]);
    let solution = factor.solve(&stacked);
    Some(FittedField { coefficients: Mat::from_fn(m, 3, |k, a| solution[(a * m + k, 0)]) })
}

impl FittedField {
    /// Posterior mean of the displacement at every point of `values`, mm.
    pub fn displacements(&self, values: MatRef<'_, f64>) -> Vec<Vector3<f64>> {
        let u = values * &self.coefficients;
        (0..u.nrows()).map(|i| Vector3::new(u[(i, 0)], u[(i, 1)], u[(i, 2)])).collect()
    }

    /// `‖c‖²`: twice the negative logarithm of the field's density under the prior, up to a constant.
    pub fn cost(&self) -> f64 {
        self.coefficients.squared_norm_l2()
    }
}
