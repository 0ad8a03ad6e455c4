//! Bayesian coherent point drift: coherence is a prior on the displacement, and the posterior has a variance at every
//! point.
//!
//! The moved source is `y'_m = s R (y_m + v_m) + t` with `v ~ N(0, λ⁻¹ G)`. Variational inference alternates between
//! three steps: the assignment, in which points with uncertain displacement have less weight (by `exp(−3 s² σ_m² /
//! 2σ²)`), the posterior of `v`, and the similarity. With `G = F Fᵀ` and `v = F a`:
//!
//! `Σ_a = (λ I + (s²/σ²) Fᵀ diag(ν) F)⁻¹`, `a = (s²/σ²) Σ_a Fᵀ diag(ν) (T⁻¹(x̂) − y)`, `σ_m² = F_m Σ_a F_mᵀ`.
//!
//! Source: Hirose, "A Bayesian formulation of coherent point drift", IEEE PAMI 43(7), 2021, figure 2, for equal mixing
//! coefficients (`κ → ∞`).

use crate::MethodError;
use crate::soft::{Field, assign, kernel_basis, moved, ridge, solved, spread};
use faer::Mat;
use faer::linalg::solvers::Solve;
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::{Matrix3, Point3, Vector3};
use std::f64::consts::TAU;

/// Settings; lengths in square roots of the area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BcpdOptions {
    /// Width `β` of the kernel.
    pub width: f64,
    /// Precision `λ` of the displacement along an axis at a point.
    pub precision: f64,
    /// Share `ω` of target points without a source point.
    pub outliers: f64,
    /// Initial `σ`. The authors start with the `σ` of all pairs of points, which contracts the source to its center
    /// before it unfolds again; a known pose allows a smaller start.
    pub first_sigma: f64,
    /// Largest number of steps.
    pub max_iterations: u32,
    /// Relative change of `σ` in a step below which the iteration ends.
    pub tolerance: f64,
    /// Largest number of functions of the field.
    pub n_functions: usize,
}

impl Default for BcpdOptions {
    fn default() -> Self {
        // As for coherent point drift: a standard deviation of 0.06 square roots of the area.
        BcpdOptions {
            width: 0.3,
            precision: 300.0,
            outliers: 0.05,
            first_sigma: 0.06,
            max_iterations: 150,
            tolerance: 1e-4,
            n_functions: 300,
        }
    }
}

/// Least `σ`.
const LEAST_SIGMA: f64 = 1e-4;

/// The result of [`register`].
#[derive(Debug, Clone)]
pub struct Bcpd {
    field: Field,
    scale: f64,
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
    /// Final `σ`.
    pub sigma: f64,
    /// Posterior standard deviation along an axis at every source point.
    pub uncertainty: Vec<f64>,
    /// Steps taken.
    pub iterations: u32,
    /// Whether `σ` converged.
    pub converged: bool,
}

impl Bcpd {
    /// `points` moved by the field and the similarity. Cost `O(n M²)` for `M` functions.
    pub fn moved(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let placed = |p: Point3<f64>| Point3::from(self.scale * (self.rotation * p.coords) + self.translation);
        self.field.moved(points).into_iter().map(placed).collect()
    }
}

/// Moves `source` onto `target`.
///
/// # Errors
/// [`MethodError::Singular`]; [`MethodError::Cancelled`].
///
/// # Cost
/// Each step `O(n m + m M²)` for `n` target points, `m` source points and `M` functions; memory `O(n + m M)`.
pub fn register(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    options: &BcpdOptions,
    observer: &dyn Observer,
) -> Result<Bcpd, MethodError> {
    let singular = MethodError::Singular { method: "Bayesian coherent point drift" };
    let basis = kernel_basis(source, options.width, options.n_functions).ok_or(singular.clone())?;
    let values = basis.values(source);
    let m = source.len();
    let mut coefficients = Mat::zeros(basis.n_functions(), 3);
    let mut own = vec![0.0; m];
    let (mut scale, mut rotation, mut translation) = (1.0, Matrix3::identity(), Vector3::zeros());
    let mut at = source.to_vec();
    let mut variance = spread(source, target).min(options.first_sigma * options.first_sigma);
    // Outliers are uniform over the box of the target.
    let density = 1.0 / volume(target).max(f64::MIN_POSITIVE.sqrt());
    let (mut iterations, mut converged) = (0, false);
    while iterations < options.max_iterations && !converged {
        checkpoint(observer)?;
        let log_weights: Vec<f64> = own.iter().map(|v| -1.5 * scale * scale * v / variance).collect();
        let outliers = options.outliers * density * (TAU * variance).powf(1.5) * m as f64 / (1.0 - options.outliers);
        let found = assign(&at, target, variance, &log_weights, outliers);
        let total: f64 = found.mass.iter().sum();

        // The posterior of the displacement.
        let share = scale * scale / variance;
        let weights: Vec<f64> = found.mass.iter().map(|nu| nu * share).collect();
        let factor = ridge(&values, &weights, options.precision, "Bayesian coherent point drift")?;
        // ν (T⁻¹(x̂) − y), without a division by ν.
        let right: Vec<Vector3<f64>> = (0..m)
            .map(|i| {
                let back = rotation.transpose() * (found.sums[i] - translation * found.mass[i]) / scale;
                (back - source[i].coords * found.mass[i]) * share
            })
            .collect();
        coefficients = solved(&factor, &values, &right);
        let free = moved(source, &values, &coefficients);
        let whitened = factor.solve(values.transpose());
        own = (0..m)
            .map(|i| (0..values.ncols()).map(|k| values[(i, k)] * whitened[(k, i)]).sum::<f64>().max(0.0))
            .collect();

        // The similarity.
        let mean_x = found.sums.iter().sum::<Vector3<f64>>() / total;
        let mean_u = (0..m).map(|i| free[i].coords * found.mass[i]).sum::<Vector3<f64>>() / total;
        let mean_own = (0..m).map(|i| own[i] * found.mass[i]).sum::<f64>() / total;
        let (mut cross, mut trace) = (Matrix3::zeros(), 3.0 * mean_own);
        for (i, p) in free.iter().enumerate() {
            let u = p.coords - mean_u;
            cross += (found.sums[i] - mean_x * found.mass[i]) * u.transpose() / total;
            trace += found.mass[i] * u.norm_squared() / total;
        }
        let svd = cross.svd(true, true);
        let (Some(left), Some(right)) = (svd.u, svd.v_t) else { return Err(singular) };
        let sign = (left * right).determinant().signum();
        rotation = left * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign)) * right;
        scale = (rotation.transpose() * cross).trace() / trace;
        translation = mean_x - scale * (rotation * mean_u);
        at = free.iter().map(|p| Point3::from(scale * (rotation * p.coords) + translation)).collect();

        let of_target: f64 = target.iter().zip(&found.explained).map(|(x, p)| p * x.coords.norm_squared()).sum();
        let of_source: f64 =
            (0..m).map(|i| found.mass[i] * at[i].coords.norm_squared() - 2.0 * at[i].coords.dot(&found.sums[i])).sum();
        let next = (of_target + of_source) / (3.0 * total) + scale * scale * mean_own;
        let next = next.max(LEAST_SIGMA * LEAST_SIGMA);
        if !(next.is_finite() && scale.is_finite() && scale > 0.0) {
            return Err(singular);
        }
        iterations += 1;
        converged = (next / variance).sqrt().ln().abs() < options.tolerance;
        variance = next;
    }
    let uncertainty = own.iter().map(|v| scale * v.sqrt()).collect();
    let field = Field::new(basis, coefficients);
    Ok(Bcpd { field, scale, rotation, translation, sigma: variance.sqrt(), uncertainty, iterations, converged })
}

/// Volume of the box of `points`.
fn volume(points: &[Point3<f64>]) -> f64 {
    (0..3)
        .map(|axis| {
            let (low, high) = points
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p[axis]), high.max(p[axis])));
            high - low
        })
        .product()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{bean, rms, sampled, warped};
    use homolog_primitives::observe::Silent;
    use nalgebra::DMatrix;

    /// The equations of the paper with full matrices, the prior covariance inverted, and exponentials in 64 bits.
    fn dense(source: &[Point3<f64>], target: &[Point3<f64>], o: &BcpdOptions, steps: u32) -> Vec<Point3<f64>> {
        let (n, m) = (target.len(), source.len());
        // A little noise at every point, because the covariance of a smooth field has no inverse in 64 bits.
        let g =
            DMatrix::from_fn(m, m, |i, j| (-(source[i] - source[j]).norm_squared() / (2.0 * o.width * o.width)).exp())
                + DMatrix::identity(m, m) * 1e-7;
        let inverse = g.try_inverse().unwrap();
        let (mut s, mut r, mut t) = (1.0, Matrix3::<f64>::identity(), Vector3::<f64>::zeros());
        let mut variance: f64 =
            source.iter().flat_map(|p| target.iter().map(move |q| (p - q).norm_squared())).sum::<f64>()
                / (3 * n * m) as f64;
        let mut own = vec![0.0; m];
        let mut at = source.to_vec();
        for _ in 0..steps {
            let c = o.outliers * (TAU * variance).powf(1.5) * m as f64 / (1.0 - o.outliers) / volume(target);
            let mut p = DMatrix::from_fn(m, n, |i, j| {
                (-(at[i] - target[j]).norm_squared() / (2.0 * variance) - 1.5 * s * s * own[i] / variance).exp()
            });
            for mut column in p.column_iter_mut() {
                let sum = column.sum() + c;
                column /= sum;
            }
            let nu: Vec<f64> = (0..m).map(|i| p.row(i).sum()).collect();
            let total: f64 = nu.iter().sum();
            let means: Vec<Vector3<f64>> =
                (0..m).map(|i| (0..n).map(|j| target[j].coords * p[(i, j)]).sum::<Vector3<f64>>() / nu[i]).collect();
            let mut system = &inverse * o.precision;
            for i in 0..m {
                system[(i, i)] += s * s / variance * nu[i];
            }
            let covariance = system.try_inverse().unwrap();
            let residual = DMatrix::from_fn(m, 3, |i, a| {
                s * s / variance * nu[i] * (r.transpose() * (means[i] - t) / s - source[i].coords)[a]
            });
            let v = &covariance * residual;
            let u: Vec<Vector3<f64>> =
                (0..m).map(|i| source[i].coords + Vector3::new(v[(i, 0)], v[(i, 1)], v[(i, 2)])).collect();
            own = (0..m).map(|i| covariance[(i, i)]).collect();
            let x_mean = (0..m).map(|i| means[i] * nu[i]).sum::<Vector3<f64>>() / total;
            let u_mean = (0..m).map(|i| u[i] * nu[i]).sum::<Vector3<f64>>() / total;
            let own_mean = (0..m).map(|i| own[i] * nu[i]).sum::<f64>() / total;
            let mut xu = Matrix3::zeros();
            let mut uu = Matrix3::identity() * own_mean;
            for i in 0..m {
                xu += nu[i] / total * (means[i] - x_mean) * (u[i] - u_mean).transpose();
                uu += nu[i] / total * (u[i] - u_mean) * (u[i] - u_mean).transpose();
            }
            let svd = xu.svd(true, true);
            let (a, b) = (svd.u.unwrap(), svd.v_t.unwrap());
            r = a * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, (a * b).determinant())) * b;
            s = (r * xu.transpose()).trace() / uu.trace();
            t = x_mean - s * r * u_mean;
            at = u.iter().map(|u| Point3::from(s * (r * u) + t)).collect();
            variance = s * s * own_mean;
            for i in 0..m {
                for j in 0..n {
                    variance += p[(i, j)] * (at[i] - target[j]).norm_squared() / (3.0 * total);
                }
            }
        }
        at
    }

    #[test]
    fn the_fast_form_follows_the_equations_with_full_matrices() {
        let mesh = bean(3);
        let source = sampled(mesh.vertices(), 60);
        let target: Vec<_> = sampled(mesh.vertices(), 75).iter().map(warped).collect();
        for steps in [1, 5, 30] {
            let options = BcpdOptions {
                max_iterations: steps,
                tolerance: 0.0,
                first_sigma: f64::INFINITY,
                ..BcpdOptions::default()
            };
            let found = register(&source, &target, &options, &Silent).unwrap();
            let exact = dense(&source, &target, &options, steps);
            let off = rms(&found.moved(&source), &exact);
            // This implementation leaves out functions below 1e-5 of the largest variance; the reference does not.
            assert!(off < 1e-3, "{steps} steps: {off}");
            assert!(rms(&source, &exact) > 5e-3, "the oracle moves the points");
        }
    }

    #[test]
    fn a_warp_with_a_rotation_is_found_to_half_its_size() {
        let mesh = bean(3);
        let rotation = nalgebra::Rotation3::from_euler_angles(0.1, -0.05, 0.1);
        let truth: Vec<_> = mesh.vertices().iter().map(|p| rotation * warped(p)).collect();
        let found = register(&sampled(mesh.vertices(), 400), &truth, &BcpdOptions::default(), &Silent).unwrap();
        let error = rms(&found.moved(mesh.vertices()), &truth);
        assert!(error < 0.5 * rms(mesh.vertices(), &truth), "{error}");
        assert!(found.uncertainty.iter().all(|u| *u > 0.0 && *u < 0.1));
    }
}
