//! The general linear model at every vertex, with classical and robust standard errors.
//!
//! The model is `y = X β + ε`. A contrast `c` of the coefficients is a sum of the observations, `c·β̂ = a·y` with `a =
//! X (XᵀX)⁻¹ c`. All its statistics follow from `a`, the residuals `e`, and the leverages `h`: the classical variance
//! is `σ̂² ‖a‖²`, the variance robust to unequal variances (HC3) is `Σ aᵢ² eᵢ² / (1 − hᵢ)²`.
//!
//! Source: MacKinnon, White, *Some heteroskedasticity-consistent covariance matrix estimators*, 1985 (HC3).

use super::VertexValues;
use faer::Mat;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Share of a column that is independent of earlier columns, below which the column counts as dependent.
const DEPENDENT: f64 = 1e-8;

/// A design, decomposed.
#[derive(Debug, Clone)]
pub struct LinearModel {
    n: usize,
    /// Orthonormal columns with the span of the design's columns.
    q: Vec<Vec<f64>>,
    /// `R⁻¹`: coefficients from `Qᵀ y`.
    r_inverse: Mat<f64>,
    /// `1 − hᵢ`.
    free: Vec<f64>,
}

/// Results of a contrast at each vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct ContrastMap {
    /// Value.
    pub effect: Vec<f64>,
    /// Robust standard error (HC3).
    pub robust_se: Vec<f64>,
    /// t with the classical standard error, used by permutation tests.
    pub t: Vec<f64>,
    /// t with the robust standard error.
    pub robust_t: Vec<f64>,
    /// Two-sided p of the robust t.
    pub robust_p: Vec<f64>,
    /// Effect over the standard deviation of the residuals, corrected for small samples (Hedges).
    pub g: Vec<f64>,
}

/// The first column that depends linearly on those before it.
pub(super) fn independent(matrix: &Mat<f64>) -> Option<usize> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for k in 0..matrix.ncols() {
        let column: Vec<f64> = (0..matrix.nrows()).map(|i| matrix[(i, k)]).collect();
        let whole = norm(&column);
        let mut rest = column;
        for _ in 0..2 {
            for other in &basis {
                let along = dot(other, &rest);
                rest.iter_mut().zip(other).for_each(|(x, q)| *x -= along * q);
            }
        }
        let left = norm(&rest);
        if left.is_nan() || left <= DEPENDENT * whole {
            return Some(k);
        }
        basis.push(rest.into_iter().map(|x| x / left).collect());
    }
    None
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// `x (XᵀX)⁻¹ xᵀ` of a row `x` with these weights of the observations ([`LinearModel::observation_weights`]).
pub(crate) fn leverage(weights: &[f64]) -> f64 {
    weights.iter().map(|share| share * share).sum()
}

impl LinearModel {
    /// The model of a design of full rank with more rows than columns.
    pub fn new(matrix: &Mat<f64>) -> Self {
        let (n, p) = (matrix.nrows(), matrix.ncols());
        let qr = matrix.qr();
        let (q, r) = (qr.compute_thin_Q(), qr.thin_R());
        // Back substitution for each unit vector.
        let mut r_inverse = Mat::zeros(p, p);
        for column in 0..p {
            for row in (0..=column).rev() {
                let known: f64 = (row + 1..=column).map(|k| r[(row, k)] * r_inverse[(k, column)]).sum();
                r_inverse[(row, column)] = (f64::from(u8::from(row == column)) - known) / r[(row, row)];
            }
        }
        let q: Vec<Vec<f64>> = (0..p).map(|k| (0..n).map(|i| q[(i, k)]).collect()).collect();
        // A subject that alone determines a coefficient has no residual and carries no information on the variance.
        let free = (0..n).map(|i| (1.0 - q.iter().map(|q| q[i] * q[i]).sum::<f64>()).max(1e-12)).collect();
        LinearModel { n, q, r_inverse, free }
    }

    /// Degrees of freedom of the residuals.
    pub fn degrees(&self) -> f64 {
        (self.n - self.q.len()) as f64
    }

    /// `1 − h` for the leverage `h` of each row.
    pub(crate) fn free(&self) -> &[f64] {
        &self.free
    }

    /// Orthonormal columns that span the design.
    pub(super) fn basis(&self) -> &[Vec<f64>] {
        &self.q
    }

    /// The weights with which observations sum to the contrast.
    pub fn observation_weights(&self, contrast: &[f64]) -> Vec<f64> {
        // a = Q R⁻ᵀ c
        let p = self.q.len();
        let of_q: Vec<f64> = (0..p).map(|k| (0..p).map(|j| self.r_inverse[(j, k)] * contrast[j]).sum()).collect();
        (0..self.n).map(|i| (0..p).map(|k| self.q[k][i] * of_q[k]).sum()).collect()
    }

    /// Residuals of one vertex.
    pub fn residuals(&self, y: &[f64]) -> Vec<f64> {
        let mut rest = y.to_vec();
        for q in &self.q {
            let along = dot(q, y);
            rest.iter_mut().zip(q).for_each(|(x, q)| *x -= along * q);
        }
        rest
    }

    /// A contrast at every vertex; `O(n p)` each.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn contrast(
        &self,
        values: &VertexValues,
        contrast: &[f64],
        observer: &dyn Observer,
    ) -> Result<ContrastMap, Cancelled> {
        let a = self.observation_weights(contrast);
        let (length, degrees) = (norm(&a), self.degrees());
        let student = StudentsT::new(0.0, 1.0, degrees);
        let each: Vec<[f64; 6]> = values
            .vertices()
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|y| {
                checkpoint(observer)?;
                let (effect, e) = (dot(&a, y), self.residuals(y));
                let deviation = norm(&e) / degrees.sqrt();
                let robust = (0..self.n).map(|i| (a[i] * e[i] / self.free[i]).powi(2)).sum::<f64>().sqrt();
                let over = |error: f64| if error > 0.0 { effect / error } else { 0.0 };
                let t = over(robust);
                let p = student.as_ref().map_or(1.0, |student| 2.0 * student.sf(t.abs()));
                Ok([effect, robust, over(deviation * length), t, p, over(deviation) * hedges(degrees)])
            })
            .collect::<Result<_, Cancelled>>()?;
        let column = |k: usize| each.iter().map(|row| row[k]).collect();
        Ok(ContrastMap {
            effect: column(0),
            robust_se: column(1),
            t: column(2),
            robust_t: column(3),
            robust_p: column(4),
            g: column(5),
        })
    }
}

/// Hedges' correction of a standardized difference, by its usual approximation.
pub fn hedges(degrees: f64) -> f64 {
    1.0 - 3.0 / (4.0 * degrees - 1.0)
}
