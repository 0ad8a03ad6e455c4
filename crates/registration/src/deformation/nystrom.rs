//! Basis functions of a smooth displacement field by the Nyström approximation.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, Side};
use homolog_primitives::exponential::exp_negative_f64;
use homolog_primitives::points::farthest_points;
use multiversion::multiversion;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Variance of an eigenvector of the covariance, as a share of the largest, below which it is left out. Displacements
/// of 0.3 % of those along the first are less than surfaces can determine, and the cost of a fit grows with the cube of
/// the number of functions. With 1e-7, twice as many functions of two kernels gave the same errors on seven sets.
const RANK_TOLERANCE: f64 = 1e-5;

/// The prior of a displacement field: `u(p) = a + B (p − c) + v(p)`, each part normal with mean 0 and independent for
/// each axis.
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothPrior {
    /// Standard deviation of the translation `a`, mm.
    pub translation_mm: f64,
    /// Standard deviation of each entry of `B`.
    pub linear: f64,
    /// Kernels of the independent Gaussian processes whose sum is `v`.
    pub kernels: Vec<GaussianKernel>,
}

/// `k(p, q) = s² exp(−‖p − q‖² / 2w²)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussianKernel {
    /// Width `w`, mm.
    pub width_mm: f64,
    /// Standard deviation `s` of the displacement along an axis, mm.
    pub amplitude_mm: f64,
}

impl SmoothPrior {
    fn covariance(&self, squared_distance: f64) -> f64 {
        self.kernels
            .iter()
            .map(|k| k.amplitude_mm.powi(2) * exp_negative_f64(-squared_distance / (2.0 * k.width_mm * k.width_mm)))
            .sum()
    }

    /// The covariance of the displacements at `p` and `q` along one axis, mm², with the linear part about `center`.
    pub(super) fn covariance_of(&self, p: &Point3<f64>, q: &Point3<f64>, center: &Point3<f64>) -> f64 {
        let linear = self.linear * self.linear * (p - center).dot(&(q - center));
        self.translation_mm * self.translation_mm + linear + self.covariance((p - q).norm_squared())
    }
}

/// Functions `φ_1 … φ_M` of position, scaled so that under the prior the coefficients of each axis of `u(p) = Σ_k
/// φ_k(p) c_k` are independent standard normal variables.
#[derive(Debug, Clone)]
pub struct FieldBasis {
    prior: SmoothPrior,
    center: Point3<f64>,
    inducing: Vec<Point3<f64>>,
    /// `m × r`: maps covariances with the inducing points to basis functions.
    whitening: Mat<f64>,
}

impl FieldBasis {
    /// The basis for fields over `points`, mm, with up to `n_inducing` of them as inducing points. `None` without
    /// points, or if the covariance has no eigendecomposition because a number is not finite.
    ///
    /// # Cost
    /// `O(n_inducing · points + n_inducing³)`.
    pub fn new(points: &[Point3<f64>], prior: SmoothPrior, n_inducing: usize) -> Option<Self> {
        if points.is_empty() {
            return None;
        }
        let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
        let inducing: Vec<Point3<f64>> = farthest_points(points, n_inducing).iter().map(|&i| points[i]).collect();
        let m = inducing.len();
        // Dimensionless, so that thresholds inside the decomposition mean the same for surfaces of any size.
        let variance = prior.covariance(0.0).max(f64::MIN_POSITIVE);
        let covariance =
            Mat::from_fn(m, m, |i, j| prior.covariance((inducing[i] - inducing[j]).norm_squared()) / variance);
        let eigen = covariance.self_adjoint_eigen(Side::Lower).ok()?;
        let (vectors, values) = (eigen.U(), eigen.S().column_vector());
        let largest = (0..m).map(|k| values[k]).fold(0.0, f64::max);
        let kept: Vec<usize> = (0..m).rev().filter(|&k| values[k] > RANK_TOLERANCE * largest).collect();
        let whitening = Mat::from_fn(m, kept.len(), |i, k| vectors[(i, kept[k])] / (values[kept[k]] * variance).sqrt());
        Some(FieldBasis { prior, center: Point3::from(center), inducing, whitening })
    }

    /// Variance of the prior along an axis, mm², that the functions do not express at each point, given their `values`
    /// there, `n × M`. Cost `O(n M)`.
    ///
    /// Source: Snelson, Ghahramani, "Sparse Gaussian processes using pseudo-inputs", Advances in Neural Information
    /// Processing Systems 18, 2006 (the approximation known as FITC).
    pub fn unexpressed(&self, values: MatRef<'_, f64>) -> Vec<f64> {
        let variance = self.prior.covariance(0.0);
        let of_point = |i| (4..values.ncols()).map(|k| values[(i, k)].powi(2)).sum::<f64>();
        (0..values.nrows()).map(|i| (variance - of_point(i)).max(0.0)).collect()
    }

    /// Number of functions `M`.
    pub fn n_functions(&self) -> usize {
        4 + self.whitening.ncols()
    }

    /// The value of every function at every point, `n × M`. Cost `O(n · m · M)`.
    pub fn values(&self, points: &[Point3<f64>]) -> Mat<f64> {
        let (n, m) = (points.len(), self.inducing.len());
        let axes: [Vec<f64>; 3] = std::array::from_fn(|axis| points.iter().map(|p| p[axis]).collect());
        let mut covariances = vec![0.0; n * m];
        covariances.par_chunks_mut(n.max(1)).zip(&self.inducing).for_each(|(column, inducing)| {
            for kernel in &self.prior.kernels {
                add_covariances(&axes, inducing, kernel, column);
            }
        });
        let mut values = Mat::zeros(n, self.n_functions());
        matmul(
            values.as_mut().subcols_mut(4, self.whitening.ncols()),
            Accum::Replace,
            MatRef::from_column_major_slice(&covariances, n, m),
            self.whitening.as_ref(),
            1.0,
            Par::Seq,
        );
        for i in 0..n {
            values[(i, 0)] = self.prior.translation_mm;
            for axis in 0..3 {
                values[(i, 1 + axis)] = self.prior.linear * (axes[axis][i] - self.center[axis]);
            }
        }
        values
    }
}

/// Adds `k(p, z)` of every point `p`, given by its coordinates along the three axes, with `inducing` to `sums`.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn add_covariances(axes: &[Vec<f64>; 3], inducing: &Point3<f64>, kernel: &GaussianKernel, sums: &mut [f64]) {
    let [x, y, z] = axes;
    let inverse = -0.5 / (kernel.width_mm * kernel.width_mm);
    let variance = kernel.amplitude_mm * kernel.amplitude_mm;
    for (((sum, x), y), z) in sums.iter_mut().zip(x).zip(y).zip(z) {
        let (dx, dy, dz) = (x - inducing.x, y - inducing.y, z - inducing.z);
        *sum += variance * exp_negative_f64(inverse * (dx * dx + dy * dy + dz * dz));
    }
}
