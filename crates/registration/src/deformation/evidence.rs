//! The required width of a displacement field: the process under which residual heights are most probable.
//!
//! A field `v` whose covariance on every axis is `s² k(p, q)`, with `k` a sum of Gaussian kernels, moves a point along
//! its normal by `n·v`, which has the covariance `s² k(p, q) ⟨n, n'⟩`. With independent noise of variance `σ²` the
//! heights `h` of points over a surface have the marginal likelihood `N(h; 0, s² K + σ² I)`. For one `k`, a single
//! tridiagonal form of `K` gives it for all `s` and `σ`; `σ²` has its maximum in closed form for each ratio `s² / σ²`.
//!
//! Source: Rasmussen, Williams, "Gaussian Processes for Machine Learning", 2006, section 5.4 (model selection by the
//! marginal likelihood).

use super::GaussianKernel;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::evd::tridiag::{tridiag_in_place, tridiag_in_place_scratch};
use faer::linalg::householder::{
    apply_block_householder_sequence_transpose_on_the_left_in_place_scratch,
    apply_block_householder_sequence_transpose_on_the_left_in_place_with_conj,
};
use faer::linalg::qr::no_pivoting::factor::recommended_block_size;
use faer::{Conj, Mat, Par, Spec};
use homolog_primitives::exponential::exp_negative_f64;
use multiversion::multiversion;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Ratios measured at once.
const LANES: usize = 8;
/// Pivots multiplied before a logarithm is taken: products of numbers up to two to the power of 120 are finite.
const PRODUCT: usize = 8;
/// Smallest ratio `s² / σ²` that is tried, as a power of two.
const LEAST_RATIO: i32 = -4;

/// Processes of a displacement field from which the most probable one is found.
#[derive(Debug, Clone, Copy)]
pub struct ProcessSearch<'a> {
    /// Widths `w` of the processes, mm.
    pub widths_mm: &'a [f64],
    /// The kernels whose sum is a process of width 1, each with its width and amplitude: the first has 1 and 1.
    pub shape: &'a [GaussianKernel],
    /// Largest ratio `s² / σ²` that is tried, as a power of two.
    pub largest_ratio: i32,
    /// Least standard deviation of the noise, mm.
    pub least_noise_mm: f64,
}

/// One Gaussian kernel, as the `shape` of a [`ProcessSearch`].
pub const ONE_KERNEL: [GaussianKernel; 1] = [GaussianKernel { width_mm: 1.0, amplitude_mm: 1.0 }];

/// The most probable process of a displacement field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KernelEvidence {
    /// The first kernel of the process: width, and standard deviation along an axis.
    pub kernel: GaussianKernel,
    /// Standard deviation `σ` of the noise, mm.
    pub noise_mm: f64,
    /// Logarithm of the marginal likelihood, minus that of noise alone. At most 0 if a field explains nothing.
    pub gain: f64,
}

/// The process, among those of `search`, under which `heights` (mm) along unit `normals` at `points` are most probable.
/// `None` without points or widths, if all heights are 0, or if a number is not finite.
///
/// # Cost
/// `O(widths · points³)`; widths on all threads.
pub fn most_probable_kernel(
    points: &[Point3<f64>],
    normals: &[Vector3<f64>],
    heights: &[f64],
    search: &ProcessSearch<'_>,
) -> Option<KernelEvidence> {
    let evidence = HeightEvidence::new(points, normals, heights, (search.widths_mm, search.shape))?;
    evidence.most_probable(search.largest_ratio, search.least_noise_mm)
}

/// Heights along normals, prepared for the marginal likelihood under processes of several widths.
#[derive(Debug)]
pub struct HeightEvidence {
    n: f64,
    /// Mean square of the heights, mm².
    variance: f64,
    /// Widths in mm, with the covariance of each.
    of_widths: Vec<(f64, Tridiagonal)>,
}

impl HeightEvidence {
    /// For `heights` (mm) along unit `normals` at `points`, and processes of `widths_mm` and this shape, as in
    /// [`ProcessSearch`]. `None` without points, if all heights are 0, or if a number is not finite.
    ///
    /// # Cost
    /// `O(widths · points³)`; widths on all threads.
    pub fn new(
        points: &[Point3<f64>],
        normals: &[Vector3<f64>],
        heights: &[f64],
        (widths_mm, shape): (&[f64], &[GaussianKernel]),
    ) -> Option<HeightEvidence> {
        let n = points.len() as f64;
        let variance = heights.iter().map(|h| h * h).sum::<f64>() / n;
        if !(variance.is_finite() && variance > 0.0) {
            return None;
        }
        let of_width =
            |&width_mm: &f64| (width_mm, Tridiagonal::of(covariance(points, normals, width_mm, shape), heights));
        Some(HeightEvidence { n, variance, of_widths: widths_mm.par_iter().map(of_width).collect() })
    }

    /// The most probable process and noise of a standard deviation of at least `least_noise_mm`. Ratios `s² / σ²` up to
    /// two to the power of `largest_ratio` are tried. `None` without widths, or if a number is not finite. Cost
    /// `O(widths · ratios · points)`.
    pub fn most_probable(&self, largest_ratio: i32, least_noise_mm: f64) -> Option<KernelEvidence> {
        let least = least_noise_mm * least_noise_mm;
        // Minus twice the logarithm of a likelihood, without its constant, of the most probable noise.
        let deviance = |squares: f64, log_determinant: f64| {
            let noise = (squares / self.n).max(least);
            (noise, self.n * noise.ln() + squares / noise + log_determinant)
        };
        let (_, of_noise_alone) = deviance(self.n * self.variance, 0.0);
        let ratios: Vec<f64> = (LEAST_RATIO..=largest_ratio).map(|power| 2f64.powi(power)).collect();
        let of_width = |(width_mm, tridiagonal): &(f64, Tridiagonal)| {
            let of_ratio = |(ratio, (log_determinant, squares)): (&f64, (f64, f64))| {
                let (noise, deviance) = deviance(squares, log_determinant);
                let kernel = GaussianKernel { width_mm: *width_mm, amplitude_mm: (ratio * noise).sqrt() };
                KernelEvidence { kernel, noise_mm: noise.sqrt(), gain: 0.5 * (of_noise_alone - deviance) }
            };
            let found = ratios.iter().zip(tridiagonal.measured(&ratios)).map(of_ratio).filter(|e| e.gain.is_finite());
            found.max_by(|a, b| a.gain.total_cmp(&b.gain))
        };
        let found: Vec<Option<KernelEvidence>> = self.of_widths.iter().map(of_width).collect();
        found.into_iter().flatten().max_by(|a, b| a.gain.total_cmp(&b.gain))
    }

    /// Logarithm of the marginal likelihood of the heights, without the constant `−n ln √2π`, for noise of standard
    /// deviation `noise_mm` and the most probable field whose standard deviation is at least `least_mm`, in steps of √2
    /// up to `largest_ratio` steps. Cost `O(widths · steps · points)`.
    pub fn log_likelihood(&self, noise_mm: f64, least_mm: f64, largest_ratio: i32) -> f64 {
        let noise_variance = noise_mm * noise_mm;
        let least = least_mm * least_mm / noise_variance;
        let ratios: Vec<f64> = (0..=largest_ratio).map(|power| least * 2f64.powi(power)).collect();
        let all = self.of_widths.iter().flat_map(|(_, tridiagonal)| tridiagonal.measured(&ratios));
        let of = |(log_determinant, squares): (f64, f64)| {
            -0.5 * (log_determinant + squares / noise_variance) - self.n * noise_mm.ln()
        };
        all.map(of).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The lower triangle of the covariance of the heights of a process of this width and shape, for `s = 1`.
fn covariance(points: &[Point3<f64>], normals: &[Vector3<f64>], width_mm: f64, shape: &[GaussianKernel]) -> Mat<f64> {
    let kernels = shape.iter().map(|k| (k.amplitude_mm.powi(2), -0.5 / (k.width_mm * width_mm).powi(2)));
    let kernels: Vec<(f64, f64)> = kernels.collect();
    Mat::from_fn(points.len(), points.len(), |i, j| {
        if i < j {
            return 0.0;
        }
        let squared = (points[i] - points[j]).norm_squared();
        let sum: f64 = kernels.iter().map(|(variance, scale)| variance * exp_negative_f64(scale * squared)).sum();
        sum * normals[i].dot(&normals[j])
    })
}

/// A symmetric matrix `K = Q T Qᵀ` with tridiagonal `T`, and `Qᵀ h` for a vector `h`. They suffice for the marginal
/// likelihood for any ratio of variances, at a fraction of the cost of eigenvectors.
#[derive(Debug)]
struct Tridiagonal {
    diagonal: Vec<f64>,
    /// The entries below the diagonal.
    off: Vec<f64>,
    turned: Vec<f64>,
}

impl Tridiagonal {
    /// The form of the matrix with this lower triangle, for `h`. Cost `O(n³)`.
    fn of(mut matrix: Mat<f64>, h: &[f64]) -> Tridiagonal {
        let n = h.len();
        let mut turned = Mat::from_fn(n, 1, |i, _| h[i]);
        if n > 1 {
            let block = recommended_block_size::<f64>(n, n);
            let mut reflections = Mat::zeros(block, n - 1);
            let mut memory = MemBuffer::new(StackReq::any_of(&[
                tridiag_in_place_scratch::<f64>(n, Par::Seq, Spec::default()),
                apply_block_householder_sequence_transpose_on_the_left_in_place_scratch::<f64>(n - 1, block, 1),
            ]));
            let stack = MemStack::new(&mut memory);
            tridiag_in_place(matrix.as_mut(), reflections.as_mut(), Par::Seq, stack, Spec::default());
            apply_block_householder_sequence_transpose_on_the_left_in_place_with_conj(
                matrix.as_ref().submatrix(1, 0, n - 1, n - 1),
                reflections.as_ref(),
                Conj::No,
                turned.as_mut().subrows_mut(1, n - 1),
                Par::Seq,
                stack,
            );
        }
        Tridiagonal {
            diagonal: (0..n).map(|i| matrix[(i, i)]).collect(),
            off: (1..n).map(|i| matrix[(i, i - 1)]).collect(),
            turned: (0..n).map(|i| turned[(i, 0)]).collect(),
        }
    }

    /// `ln det (I + ratio K)` and `hᵀ (I + ratio K)⁻¹ h` for each of the `ratios`, for `K` without negative eigenvalues. Cost
    /// `O(n)` for each ratio; [`LANES`] of them at once.
    fn measured(&self, ratios: &[f64]) -> Vec<(f64, f64)> {
        let mut measured = Vec::with_capacity(ratios.len());
        for some in ratios.chunks(LANES) {
            let mut lanes = [0.0; LANES];
            lanes[..some.len()].copy_from_slice(some);
            let (log_determinants, squares) = measured_at(self, &lanes);
            measured.extend(log_determinants.into_iter().zip(squares).take(some.len()));
        }
        measured
    }
}

/// [`Tridiagonal::measured`] for a few ratios: by `L D Lᵀ` of the tridiagonal matrix.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn measured_at(of: &Tridiagonal, ratios: &[f64; LANES]) -> ([f64; LANES], [f64; LANES]) {
    let (mut log_determinant, mut squares) = ([0.0; LANES], [0.0; LANES]);
    let (mut pivot, mut solved) = ([1.0; LANES], [0.0; LANES]);
    // The product of a few pivots: a logarithm takes longer than everything else.
    let mut product = [1.0; LANES];
    for (i, (diagonal, turned)) in of.diagonal.iter().zip(&of.turned).enumerate() {
        let below = if i == 0 { 0.0 } else { of.off[i - 1] };
        for k in 0..LANES {
            let off = ratios[k] * below;
            let factor = off / pivot[k];
            solved[k] = turned - factor * solved[k];
            // No eigenvalue, and so no pivot, is below 1 except by rounding.
            let next = 1.0 + ratios[k] * diagonal - factor * off;
            pivot[k] = if next > 1.0 { next } else { 1.0 };
            squares[k] += solved[k] * solved[k] / pivot[k];
            product[k] *= pivot[k];
        }
        if i % PRODUCT == PRODUCT - 1 {
            for k in 0..LANES {
                log_determinant[k] += product[k].ln();
                product[k] = 1.0;
            }
        }
    }
    for k in 0..LANES {
        log_determinant[k] += product[k].ln();
    }
    (log_determinant, squares)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, directions, numbers};
    use nalgebra::{DMatrix, DVector};

    /// Two kernels, of which the second is half as wide.
    const TWO_KERNELS: [GaussianKernel; 2] = [ONE_KERNEL[0], GaussianKernel { width_mm: 0.5, amplitude_mm: 0.3 }];

    fn search<'a>(widths_mm: &'a [f64], shape: &'a [GaussianKernel]) -> ProcessSearch<'a> {
        ProcessSearch { widths_mm, shape, largest_ratio: 12, least_noise_mm: 0.0 }
    }

    /// Covariance of the heights of a process of this shape with noise, by definition. `first`: its first kernel.
    fn with_noise(
        (points, normals): (&[Point3<f64>], &[Vector3<f64>]),
        first: GaussianKernel,
        shape: &[GaussianKernel],
        noise_mm: f64,
    ) -> DMatrix<f64> {
        DMatrix::from_fn(points.len(), points.len(), |i, j| {
            let squared = (points[i] - points[j]).norm_squared();
            let of = |k: &GaussianKernel| {
                let (width, amplitude) = (k.width_mm * first.width_mm, k.amplitude_mm * first.amplitude_mm);
                amplitude * amplitude * (-squared / (2.0 * width * width)).exp()
            };
            let noise = if i == j { noise_mm * noise_mm } else { 0.0 };
            shape.iter().map(of).sum::<f64>() * normals[i].dot(&normals[j]) + noise
        })
    }

    /// Heights drawn from that distribution, through the Cholesky factor.
    fn drawn(covariance: &DMatrix<f64>) -> Vec<f64> {
        let mut number = numbers(77);
        // Twelve uniform numbers, each of variance 1/12.
        let white = DVector::from_fn(covariance.nrows(), |_, _| (0..12).map(|_| number()).sum::<f64>() - 6.0);
        (covariance.clone().cholesky().unwrap().l() * white).iter().copied().collect()
    }

    fn log_density(covariance: &DMatrix<f64>, heights: &[f64]) -> f64 {
        let h = DVector::from_column_slice(heights);
        let log_determinant = 2.0 * covariance.clone().cholesky().unwrap().l().diagonal().map(f64::ln).sum();
        -0.5 * (h.dot(&covariance.clone().lu().solve(&h).unwrap()) + log_determinant)
    }

    #[test]
    fn the_gain_is_the_difference_of_two_log_densities() {
        let (points, normals) = (cloud(3, 60), directions(4, 60));
        let of = (points.as_slice(), normals.as_slice());
        let truth = GaussianKernel { width_mm: 5.0, amplitude_mm: 2.0 };
        for shape in [ONE_KERNEL.as_slice(), &TWO_KERNELS] {
            for least_noise_mm in [0.0, 0.3, 0.9, 20.0] {
                let heights = drawn(&with_noise(of, truth, shape, 0.5));
                let search = ProcessSearch { least_noise_mm, ..search(&[5.0], shape) };
                let found = most_probable_kernel(&points, &normals, &heights, &search).unwrap();
                assert!(found.noise_mm >= least_noise_mm);
                let field = log_density(&with_noise(of, found.kernel, shape, found.noise_mm), &heights);
                let variance = heights.iter().map(|h| h * h).sum::<f64>() / 60.0;
                let least = least_noise_mm * least_noise_mm;
                let noise = log_density(&(DMatrix::identity(60, 60) * variance.max(least)), &heights);
                let tolerance = 1e-6 * (1.0 + found.gain.abs());
                assert!((field - noise - found.gain).abs() < tolerance, "{} {found:?}", field - noise);
            }
        }
    }

    #[test]
    fn no_process_and_no_noise_above_the_least_is_more_probable() {
        let (points, normals) = (cloud(3, 60), directions(4, 60));
        let of = (points.as_slice(), normals.as_slice());
        let truth = GaussianKernel { width_mm: 5.0, amplitude_mm: 2.0 };
        let heights = drawn(&with_noise(of, truth, &TWO_KERNELS, 0.05));
        let widths = [3.0, 5.0, 9.0];
        let search = ProcessSearch { least_noise_mm: 0.2, ..search(&widths, &TWO_KERNELS) };
        let found = most_probable_kernel(&points, &normals, &heights, &search).unwrap();
        let best = log_density(&with_noise(of, found.kernel, &TWO_KERNELS, found.noise_mm), &heights);
        for width_mm in widths {
            for power in -4..=12 {
                for noise_mm in [0.2, 0.25, 0.4, 0.8] {
                    let kernel = GaussianKernel { width_mm, amplitude_mm: noise_mm * 2f64.powi(power).sqrt() };
                    let other = log_density(&with_noise(of, kernel, &TWO_KERNELS, noise_mm), &heights);
                    assert!(other <= best + 1e-9, "{kernel:?} {noise_mm}: {other} {best}");
                }
            }
        }
    }

    #[test]
    fn the_log_likelihood_is_that_of_the_most_probable_field_of_a_least_amplitude() {
        let (points, normals) = (cloud(3, 60), directions(4, 60));
        let of = (points.as_slice(), normals.as_slice());
        let truth = GaussianKernel { width_mm: 5.0, amplitude_mm: 2.0 };
        let heights = drawn(&with_noise(of, truth, &ONE_KERNEL, 0.5));
        let widths = [3.0, 5.0, 9.0];
        let evidence = HeightEvidence::new(&points, &normals, &heights, (&widths, &ONE_KERNEL)).unwrap();
        for (noise_mm, least_mm) in [(0.5, 0.1), (0.3, 0.3), (0.7, 4.0)] {
            let found = evidence.log_likelihood(noise_mm, least_mm, 12);
            let by_definition = |width_mm: f64, power: i32| {
                let kernel = GaussianKernel { width_mm, amplitude_mm: least_mm * 2f64.powi(power).sqrt() };
                log_density(&with_noise(of, kernel, &ONE_KERNEL, noise_mm), &heights)
            };
            let all = widths.iter().flat_map(|width| (0..=12).map(move |power| by_definition(*width, power)));
            let expected = all.fold(f64::NEG_INFINITY, f64::max);
            assert!(
                (found - expected).abs() < 1e-6 * (1.0 + expected.abs()),
                "{noise_mm} {least_mm}: {found} {expected}"
            );
        }
    }

    #[test]
    fn the_kernel_of_drawn_heights_is_found_and_noise_needs_none() {
        let (points, normals) = (cloud(5, 300), directions(6, 300));
        let of = (points.as_slice(), normals.as_slice());
        let widths = [1.0, 2.0, 4.0, 8.0, 16.0];
        let truth = GaussianKernel { width_mm: 4.0, amplitude_mm: 1.5 };
        for shape in [ONE_KERNEL.as_slice(), &TWO_KERNELS] {
            let heights = drawn(&with_noise(of, truth, shape, 0.2));
            let found = most_probable_kernel(&points, &normals, &heights, &search(&widths, shape)).unwrap();
            assert!(found.kernel.width_mm == 4.0 && found.gain > 20.0, "{found:?}");
            assert!((1.0..2.3).contains(&found.kernel.amplitude_mm), "{found:?}");
        }
        let noise = drawn(&(DMatrix::identity(300, 300) * 0.04));
        let found = most_probable_kernel(&points, &normals, &noise, &search(&widths, &ONE_KERNEL)).unwrap();
        assert!(found.gain < 4.0, "{found:?}");
    }

    #[test]
    fn no_heights_no_widths_and_numbers_that_are_not_finite_have_no_kernel() {
        let (points, normals) = (cloud(1, 10), directions(2, 10));
        let found = |heights: &[f64], widths: &[f64]| {
            most_probable_kernel(&points, &normals, heights, &search(widths, &ONE_KERNEL))
        };
        assert_eq!(found(&[0.0; 10], &[1.0]), None);
        assert_eq!(found(&[f64::NAN; 10], &[1.0]), None);
        assert_eq!(found(&[1.0; 10], &[]), None);
    }
}
