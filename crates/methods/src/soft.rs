//! The soft assignment of coherent point drift, and the field that moves points.

use crate::MethodError;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use homolog_primitives::exponential::exp_negative;
use homolog_registration::deformation::{FieldBasis, GaussianKernel, SmoothPrior};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Points per chunk, fixed so that the work is divided in the same way on any number of threads.
const CHUNK: usize = 64;

/// Points at which a field is evaluated at once.
const PIECE: usize = 4096;

/// Sums over target points for every moved source point: mixture components `m` at `centers`, points `n`.
pub(crate) struct Assigned {
    /// `Σ_n P(m | x_n)`.
    pub mass: Vec<f64>,
    /// `Σ_m P(m | x_n)`.
    pub explained: Vec<f64>,
    /// `Σ_n P(m | x_n) x_n`.
    pub sums: Vec<Vector3<f64>>,
}

/// `P(m | x_n) = w_m exp(−‖x_n − y_m‖²/2σ²) / (Σ_k w_k exp(−‖x_n − y_k‖²/2σ²) + c)` with the logarithms of `w ≤ 1` in
/// `log_weights` and `c` in `outliers`. Exponentials in 32 bits, sums in 64.
///
/// Cost: two exponentials per pair; memory `O(n + m)`.
pub(crate) fn assign(
    centers: &[Point3<f64>],
    points: &[Point3<f64>],
    variance: f64,
    log_weights: &[f64],
    outliers: f64,
) -> Assigned {
    let inverse = 0.5 / variance;
    let likelihood = |y: &Point3<f64>, x: &Point3<f64>, log: f64| {
        f64::from(exp_negative((log - (x - y).norm_squared() * inverse) as f32))
    };
    let denominators: Vec<f64> = points
        .par_iter()
        .with_min_len(CHUNK)
        .map(|x| centers.iter().zip(log_weights).map(|(y, &log)| likelihood(y, x, log)).sum::<f64>() + outliers)
        .collect();
    // A point so far away that all its exponentials vanish belongs to no component, even without outliers.
    let inverses: Vec<f64> = denominators.iter().map(|&d| if d > 0.0 { 1.0 / d } else { 0.0 }).collect();
    let found: Vec<(f64, Vector3<f64>)> = centers
        .par_iter()
        .zip(log_weights)
        .with_min_len(CHUNK)
        .map(|(y, &log)| {
            let (mut mass, mut sum) = (0.0, Vector3::zeros());
            for (x, inverse) in points.iter().zip(&inverses) {
                let share = likelihood(y, x, log) * inverse;
                mass += share;
                sum += x.coords * share;
            }
            (mass, sum)
        })
        .collect();
    let explained = denominators.iter().zip(&inverses).map(|(d, i)| (d - outliers).max(0.0) * i).collect();
    let (mass, sums) = found.into_iter().unzip();
    Assigned { mass, explained, sums }
}

/// Mean squared distance of all pairs per coordinate: the initial variance of coherent point drift.
pub(crate) fn spread(source: &[Point3<f64>], target: &[Point3<f64>]) -> f64 {
    let moments = |points: &[Point3<f64>]| {
        let n = points.len() as f64;
        let (sum, squares) =
            points.iter().fold((Vector3::zeros(), 0.0), |(s, q), p| (s + p.coords, q + p.coords.norm_squared()));
        (sum / n, squares / n)
    };
    let ((a, aa), (b, bb)) = (moments(source), moments(target));
    (aa + bb - 2.0 * a.dot(&b)) / 3.0
}

/// The functions of a Gaussian-kernel field: `k(p, q) = exp(−‖p − q‖²/2w²)`, by the Nyström approximation over up to
/// `n_functions` points; with as many functions as points it is the kernel itself.
pub(crate) fn kernel_basis(points: &[Point3<f64>], width: f64, n_functions: usize) -> Option<FieldBasis> {
    let kernels = vec![GaussianKernel { width_mm: width, amplitude_mm: 1.0 }];
    FieldBasis::new(points, SmoothPrior { translation_mm: 0.0, linear: 0.0, kernels }, n_functions)
}

/// A smooth displacement field.
#[derive(Debug, Clone)]
pub struct Field {
    basis: FieldBasis,
    /// Coefficients, `M × 3`.
    coefficients: Mat<f64>,
}

impl Field {
    pub(crate) fn new(basis: FieldBasis, coefficients: Mat<f64>) -> Field {
        Field { basis, coefficients }
    }

    /// `points` moved by the field. Cost `O(n M²)` for `M` functions, memory `O(n + M)`.
    pub fn moved(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        // In pieces, so that a large surface needs no matrix over all its vertices.
        let piece = |points: &[Point3<f64>]| moved(points, &self.basis.values(points), &self.coefficients);
        points.chunks(PIECE).flat_map(piece).collect()
    }
}

/// `points` moved by the sum of functions with these `values` times `coefficients`.
pub(crate) fn moved(points: &[Point3<f64>], values: &Mat<f64>, coefficients: &Mat<f64>) -> Vec<Point3<f64>> {
    let u = values * coefficients;
    points.iter().enumerate().map(|(i, p)| p + Vector3::new(u[(i, 0)], u[(i, 1)], u[(i, 2)])).collect()
}

/// `(Φᵀ diag(w) Φ + r I)`, factorized.
pub(crate) fn ridge(
    values: &Mat<f64>,
    weights: &[f64],
    regularizer: f64,
    method: &'static str,
) -> Result<faer::linalg::solvers::Llt<f64>, MethodError> {
    let weighted = Mat::from_fn(values.nrows(), values.ncols(), |i, k| weights[i] * values[(i, k)]);
    let mut system = values.transpose() * weighted;
    for k in 0..values.ncols() {
        system[(k, k)] += regularizer;
    }
    system.llt(Side::Lower).map_err(|_| MethodError::Singular { method })
}

/// The solution of `factor` for the right-hand side `Φᵀ r`, where `r` has a vector for every point.
pub(crate) fn solved(factor: &faer::linalg::solvers::Llt<f64>, values: &Mat<f64>, right: &[Vector3<f64>]) -> Mat<f64> {
    factor.solve(values.transpose() * Mat::from_fn(right.len(), 3, |i, a| right[i][a]))
}
