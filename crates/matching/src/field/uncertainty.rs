//! Uncertainty of an answer: how precisely the surfaces determine a field.
//!
//! The covariance of the fit is too small, because the fit treats its assignments as observations: on a smooth surface
//! a field may slide along the surface, and its assignments slide with it. Two surfaces determine the components of a
//! displacement along the normals and, along the surface, in the directions in which a feature changes. Each such
//! component is one scalar observation, with noise estimated from this pair, and the uncertainty is the posterior of a
//! Gaussian process under these observations alone, [`homolog_registration::deformation::ComponentPosterior`].
//!
//! All parameters are estimated from the pair. Width and variance of the process are those under which the normal
//! components of the displacement, without its rigid part, are most probable. The noise along the normals is the
//! residual of this process, and at least the distance of a curved surface from its triangles; the noise of features is
//! their difference at corresponding points. Residuals of neighbors are correlated, so the weight of a point is its area over the area within which they are correlated. On a curved target
//! a height also has a linearization error, which grows with the posterior variance along the surface: both are
//! iterated to a fixed point ([`ObservationSample::variances`]).

use super::deformation_evidence::{EVIDENCE_MAX_LOG2_RATIO, Observed, WIDTHS, every, observed};
use super::displacement::FitContext;
use crate::pair::assignment::FEATURE_SHARE;
use crate::surface::smooth::N_FEATURES;
use homolog_primitives::exponential::exp_negative_f64;
use homolog_registration::deformation::{
    Component, ComponentPosterior, GaussianKernel, ONE_KERNEL, ProcessSearch, SmoothPrior, most_probable_kernel,
};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Features that are observed: those at the largest scale, whose gradients have the least noise.
const FEATURES: std::ops::Range<usize> = N_FEATURES - 2..N_FEATURES;
/// Kernels of the process, and the exponent by which their amplitude falls with their width, as for a Matérn process of
/// smoothness 5/2 (Rasmussen, Williams 2006, section 4.2.1).
const N_OCTAVES: i32 = 3;
const SMOOTHNESS: f64 = 2.5;
/// Most iterations between the variances and the error of heights, and the growth of variances at which they stop.
const MOST_PASSES: usize = 12;
const CONVERGED_GROWTH: f64 = 1.05;
/// Most points at which heights are observed, of these most at which the process is found and its variance computed,
/// and most at which features are observed. Heights have the finest detail; features change slowly, as they are means
/// over large areas.
const MOST_HEIGHTS: usize = 400;
pub(super) const MOST_VARIANCES: usize = 200;
const MOST_FEATURES: usize = 100;
/// Bins of distance in an autocorrelation, and their width in roots of the area.
const N_BINS: usize = 60;
const BIN: f64 = 0.02;

/// A sample of the points of the source, and the observations there.
pub(super) struct ObservationSample {
    points: Vec<Point3<f64>>,
    /// Area of each, mm².
    areas: Vec<f64>,
    /// Unit normals of the target at the images.
    normals: Vec<Vector3<f64>>,
    /// Displacement along the normals, relative to the bent base or without its rigid part, plus the remaining distance
    /// from the target, mm.
    shifts: Vec<f64>,
    /// Remaining distance from the target along the normals, mm.
    heights: Vec<f64>,
    /// Mean square of the distance of the target from its tangent plane after a displacement along it, over the fourth
    /// power of the standard deviation of that displacement along each axis, 1/mm².
    bending: Vec<f64>,
    /// For each feature the difference between a point and its image, and the gradient of the feature on the target,
    /// 1/mm.
    features: Vec<Vec<(f64, Vector3<f64>)>>,
}

/// A Gaussian process of displacements.
#[derive(Debug, Clone)]
pub(super) struct Process {
    pub prior: SmoothPrior,
    /// Standard deviation of the noise along the normals, mm.
    pub noise_mm: f64,
}

/// The posterior variance of the displacement, mm², at each of the `points` of the source, where the vertices of its
/// smooth version are displaced from `start` to `moved`, under `process`, or if it is not known under that of this
/// displacement. `None` if a number is not finite.
///
/// # Cost
/// `O(N³ + N · points)` for `N` observed components, at most `MOST_HEIGHTS + 2 MOST_FEATURES`.
pub(super) fn posterior(
    displacement: &FitContext<'_>,
    (start, moved): (&[Point3<f64>], &[Point3<f64>]),
    points: &[Point3<f64>],
    process: Option<Process>,
) -> Option<Vec<f64>> {
    let sample = ObservationSample::of(displacement, (start, moved), MOST_HEIGHTS);
    // Copies have no displacement, so no kernel is found.
    let Some(Process { prior, noise_mm }) = process.or_else(|| sample.process(displacement)) else {
        return Some(vec![0.0; points.len()]);
    };
    let at = displacement.functions.coordinates(&sample.points);
    let of_sample = sample.variances(&at, &prior, noise_mm, displacement.lengths.root_mm)?;
    Some(sample.spread_to(points, &of_sample))
}

/// This kernel and the octaves below it. A process with one Gaussian kernel has infinitely many derivatives, and
/// observations without noise determine it nearly everywhere; real warps are less smooth.
fn octaves(first: GaussianKernel) -> Vec<GaussianKernel> {
    let below = |octave| GaussianKernel {
        width_mm: first.width_mm * 0.5f64.powi(octave),
        amplitude_mm: first.amplitude_mm * 0.5f64.powf(SMOOTHNESS * f64::from(octave)),
    };
    (0..N_OCTAVES).map(below).collect()
}

/// The noise of an observed quantity.
pub(super) struct Noise {
    /// Mean square, in squared units of the quantity.
    pub variance: f64,
    /// Area over which it is correlated, mm².
    pub correlated: f64,
}

impl Noise {
    /// The variance that a point of this `area`, mm², has as one of independent observations.
    pub(super) fn at(&self, area: f64) -> f64 {
        self.variance * (self.correlated / area).max(1.0)
    }
}

impl ObservationSample {
    /// The observations at `most` points at most, where the vertices of the smooth source are displaced from `start` to
    /// `moved`.
    pub(super) fn of(
        displacement: &FitContext<'_>,
        (start, moved): (&[Point3<f64>], &[Point3<f64>]),
        most: usize,
    ) -> ObservationSample {
        let (source, target) = (&displacement.source, &displacement.target);
        let vertices = source.mesh.vertices();
        let mut sample = ObservationSample {
            points: Vec::new(),
            areas: Vec::new(),
            normals: Vec::new(),
            shifts: Vec::new(),
            heights: Vec::new(),
            bending: Vec::new(),
            features: vec![Vec::new(); N_FEATURES],
        };
        let (observed, step) = observed(displacement, moved, most);
        for Observed { vertex: i, image, normal } in observed {
            let height = normal.dot(&(image.point - moved[i]));
            sample.points.push(vertices[i]);
            sample.areas.push(source.areas[i] * step as f64);
            sample.normals.push(normal);
            sample.heights.push(height);
            let turning = Matrix3::from_rows(&[0, 1, 2].map(|axis| {
                gradient(target.mesh.vertices(), &image.triangle, |k| target.normals[k][axis]).transpose()
            }));
            sample.bending.push(mean_square_of_bending(&turning));
            sample.shifts.push(normal.dot(&(moved[i] - start[i])) + height);
            for (feature, differences) in sample.features.iter_mut().enumerate() {
                let of_target = |k: usize| target.features[k * N_FEATURES + feature];
                let difference = source.features[i * N_FEATURES + feature] - image.blend(of_target);
                differences.push((difference, gradient(target.mesh.vertices(), &image.triangle, of_target)));
            }
        }
        sample
    }

    /// The process under which the normal components of the displacement are most probable, and the noise along the
    /// normals under it, mm. `None` without a displacement, or if a number is not finite.
    pub(super) fn process(&self, displacement: &FitContext<'_>) -> Option<Process> {
        let widths = WIDTHS.map(|width| width * displacement.diagonal_mm);
        let every = every(self.points.len(), MOST_VARIANCES);
        let points: Vec<Point3<f64>> = self.points.iter().step_by(every).copied().collect();
        let normals: Vec<Vector3<f64>> = self.normals.iter().step_by(every).copied().collect();
        let shifts: Vec<f64> = self.shifts.iter().step_by(every).copied().collect();
        let at = displacement.functions.coordinates(&points);
        let search = ProcessSearch {
            widths_mm: &widths,
            shape: &octaves(ONE_KERNEL[0]),
            largest_ratio: EVIDENCE_MAX_LOG2_RATIO,
            least_noise_mm: self.sag_mm(displacement.target.mesh.mean_edge_length()),
        };
        let found = most_probable_kernel(&at, &normals, &shifts, &search)?;
        let kernels = octaves(found.kernel);
        let prior = SmoothPrior { kernels, ..displacement.options.prior.of(displacement.diagonal_mm) };
        Some(Process { prior, noise_mm: found.noise_mm })
    }

    /// Root mean square of the distance between the target and its tangent plane at the center of a triangle with edges
    /// of `edge_mm`, over the triangle, mm. Triangles are flat, so heights are not more precise, however well a process
    /// with many degrees of freedom explains those of a sample.
    fn sag_mm(&self, edge_mm: f64) -> f64 {
        let total = self.areas.iter().sum::<f64>().max(f64::MIN_POSITIVE);
        let bending = self.bending.iter().zip(&self.areas).map(|(bending, area)| bending * area).sum::<f64>() / total;
        // Points of an equilateral triangle have this variance along each axis; squares of them are taken for those of
        // normal numbers, which raises the root by a twentieth.
        bending.sqrt() * edge_mm * edge_mm / 24.0
    }

    /// The noise of heights with this standard deviation along the normals, mm.
    pub(super) fn noise_of_heights(&self, noise_mm: f64, root_mm: f64) -> Noise {
        Noise { variance: noise_mm * noise_mm, correlated: self.correlated_area(&self.heights, root_mm) }
    }

    /// The noise of a feature; `None` for a feature without differences (planes, exact copies), which has no reliable
    /// gradient.
    pub(super) fn noise_of_feature(&self, feature: usize, root_mm: f64) -> Option<Noise> {
        let differences: Vec<f64> = self.features[feature].iter().map(|(difference, _)| *difference).collect();
        let variance = self.variance(&differences);
        (variance > 0.0).then(|| Noise { variance, correlated: self.correlated_area(&differences, root_mm) })
    }

    /// The posterior variance of the displacement, mm², at every few of the points, at most [`MOST_VARIANCES`], for this
    /// prior and noise along the normals. `at`: the points in the coordinates of the prior.
    ///
    /// A height equals the component of the displacement along the normal only where the target is flat: if its point
    /// is off by `δ` along the surface, the height is off by `½ δᵀ W δ`. This error is noise of the height, whose
    /// variance follows from the posterior variance of `δ`, at the nearest point where it is computed. Both are iterated
    /// from zero error, growing until they converge.
    fn variances(&self, at: &[Point3<f64>], prior: &SmoothPrior, noise_mm: f64, root_mm: f64) -> Option<Vec<f64>> {
        let center = Point3::from(at.iter().map(|p| p.coords).sum::<Vector3<f64>>() / at.len().max(1) as f64);
        let every = every(at.len(), MOST_VARIANCES);
        let of: Vec<Point3<f64>> = at.iter().step_by(every).copied().collect();
        let areas: Vec<f64> = self.areas.iter().step_by(every).map(|area| area * every as f64).collect();
        let nearest: Vec<usize> = self.points.iter().map(|p| self.nearest(p, every)).collect();
        let (components, mut noise) = self.components(at, noise_mm, root_mm);
        let of_heights = noise[..at.len()].to_vec();
        let process = ComponentPosterior::new(prior, &center, &components, &of);
        let (mut variances, mut before) = (Vec::new(), 0.0);
        for _ in 0..MOST_PASSES {
            let covariances = process.covariances(&noise)?;
            variances = (0..of.len()).map(|k| covariances[(k, k)].max(0.0)).collect();
            let total = variances.iter().sum::<f64>();
            if total <= CONVERGED_GROWTH * before {
                break;
            }
            before = total;
            // The area over which squares of displacements are correlated: that correlation is the square of the
            // displacements' own.
            let correlated = |k: usize| {
                let scale = |l: usize| (variances[k] * variances[l]).max(f64::MIN_POSITIVE);
                areas.iter().enumerate().map(|(l, area)| area * covariances[(k, l)].powi(2) / scale(l)).sum::<f64>()
            };
            let correlated: Vec<f64> = (0..of.len()).map(correlated).collect();
            for (i, of_height) in of_heights.iter().enumerate() {
                let k = nearest[i];
                let slid = 0.5 * variances[k];
                noise[i] = of_height + self.bending[i] * slid * slid * (correlated[k] / self.areas[i]).max(1.0);
            }
        }
        Some(variances)
    }

    /// The index of the nearest to `p` among every `every`-th point.
    fn nearest(&self, p: &Point3<f64>, every: usize) -> usize {
        let distances = self.points.iter().step_by(every).map(|q| (p - q).norm_squared()).enumerate();
        distances.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k)
    }

    /// The components that are observed at these points, heights first, and the variance of the noise of each; `noise_mm`
    /// is the noise along the normals.
    fn components(&self, at: &[Point3<f64>], noise_mm: f64, root_mm: f64) -> (Vec<Component>, Vec<f64>) {
        let of_heights = self.noise_of_heights(noise_mm, root_mm);
        let heights = (0..at.len()).map(|k| Component { at: at[k], direction: self.normals[k] });
        let mut components: Vec<Component> = heights.collect();
        let mut variances: Vec<f64> = self.areas.iter().map(|area| of_heights.at(*area)).collect();
        let every = every(at.len(), MOST_FEATURES);
        for (order, feature) in FEATURES.enumerate() {
            let Some(noise) = self.noise_of_feature(feature, root_mm) else { continue };
            // Features are highly correlated with each other.
            let noise = Noise { variance: noise.variance / FEATURE_SHARE, ..noise };
            // Each at the points between those of the others.
            for k in (order * every / FEATURES.len()..at.len()).step_by(every) {
                components.push(Component { at: at[k], direction: self.features[feature][k].1 });
                variances.push(noise.at(self.areas[k] * every as f64));
            }
        }
        (components, variances)
    }

    /// Mean square of residuals, weighted by area.
    fn variance(&self, residuals: &[f64]) -> f64 {
        let squares: f64 = residuals.iter().zip(&self.areas).map(|(r, area)| area * r * r).sum();
        squares / self.areas.iter().sum::<f64>().max(f64::MIN_POSITIVE)
    }

    /// The area over which residuals are correlated, mm²: the integral of their autocorrelation up to its first zero,
    /// and at least the area of a point. Cost `O(points²)`.
    fn correlated_area(&self, residuals: &[f64], root_mm: f64) -> f64 {
        let (mut products, mut weights) = ([0.0; N_BINS], [0.0; N_BINS]);
        for (i, p) in self.points.iter().enumerate() {
            for (j, q) in self.points.iter().enumerate().skip(i + 1) {
                let bin = ((p - q).norm() / (BIN * root_mm)) as usize;
                if bin < N_BINS {
                    let weight = 2.0 * self.areas[i] * self.areas[j];
                    weights[bin] += weight;
                    products[bin] += weight * residuals[i] * residuals[j];
                }
            }
        }
        let (variance, total) = (self.variance(residuals), self.areas.iter().sum::<f64>());
        let own = self.areas.iter().map(|area| area * area).sum::<f64>() / total;
        let positive = (0..N_BINS).filter(|&bin| weights[bin] > 0.0).take_while(|&bin| products[bin] > 0.0);
        own + positive.map(|bin| products[bin] / (variance * total)).sum::<f64>()
    }

    /// Values of every few points of the sample, as from [`ObservationSample::variances`], at `points`.
    fn spread_to(&self, points: &[Point3<f64>], values: &[f64]) -> Vec<f64> {
        let every = every(self.points.len(), MOST_VARIANCES);
        let of: Vec<Point3<f64>> = self.points.iter().step_by(every).copied().collect();
        spread(&of, values, self.areas.iter().sum(), points)
    }
}

/// The `values` at the points `of` a surface of `area_mm2`, each of which stands for an equal part of it, at other
/// `points`: means weighted by distance.
pub(super) fn spread(of: &[Point3<f64>], values: &[f64], area_mm2: f64, points: &[Point3<f64>]) -> Vec<f64> {
    let spacing = area_mm2 / values.len().max(1) as f64;
    let at = |p: &Point3<f64>| {
        let nearest = of.iter().map(|q| (p - q).norm_squared()).fold(f64::INFINITY, f64::min);
        let (mut sum, mut total) = (0.0, 0.0);
        for (q, value) in of.iter().zip(values) {
            let weight = exp_negative_f64(-0.5 * ((p - q).norm_squared() - nearest) / spacing);
            sum += weight * value;
            total += weight;
        }
        if total > 0.0 { sum / total } else { 0.0 }
    };
    points.par_iter().map(at).collect()
}

/// `E (½ δᵀ W δ)²` for `δ` of variance 1 along each axis of the tangent plane, where `W` is the derivative of the
/// normals.
fn mean_square_of_bending(turning: &Matrix3<f64>) -> f64 {
    let symmetric = 0.5 * (turning + turning.transpose());
    0.25 * (2.0 * (symmetric * symmetric).trace() + symmetric.trace().powi(2))
}

/// The gradient on a triangle of the linear interpolation of the values at its corners; 0 on a triangle
/// without area.
pub(super) fn gradient(vertices: &[Point3<f64>], triangle: &[u32; 3], value: impl Fn(usize) -> f64) -> Vector3<f64> {
    let corners = triangle.map(|k| k as usize);
    let [a, b, c] = corners.map(|k| vertices[k]);
    let [fa, fb, fc] = corners.map(value);
    let (e, f) = (b - a, c - a);
    let normal = e.cross(&f);
    let squared = normal.norm_squared();
    if squared > 0.0 {
        (f.cross(&normal) * (fb - fa) + normal.cross(&e) * (fc - fa)) / squared
    } else {
        Vector3::zeros()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::numbers;

    /// Points of a square grid of spacing 1, without observations.
    fn grid(side: usize) -> ObservationSample {
        let points = (0..side * side).map(|k| Point3::new((k % side) as f64, (k / side) as f64, 0.0)).collect();
        let n = side * side;
        ObservationSample {
            points,
            areas: vec![1.0; n],
            normals: vec![Vector3::z(); n],
            shifts: vec![0.0; n],
            heights: vec![0.0; n],
            bending: vec![0.0; n],
            features: vec![vec![(0.0, Vector3::zeros()); n]; N_FEATURES],
        }
    }

    #[test]
    fn independent_residuals_count_for_a_point_each_and_alike_ones_for_all() {
        let sample = grid(14);
        let mut number = numbers(5);
        let noise: Vec<f64> = sample.points.iter().map(|_| number() - 0.5).collect();
        let root_mm = 14.0;
        assert!(sample.correlated_area(&noise, root_mm) < 4.0);
        let alike = vec![0.3; sample.points.len()];
        assert!(sample.correlated_area(&alike, root_mm) > 0.9 * 14.0 * 14.0);
        // Between the two: waves of a length of seven points.
        let wave: Vec<f64> = sample.points.iter().map(|p| (p.x * 0.9).sin() * (p.y * 0.9).cos()).collect();
        let area = sample.correlated_area(&wave, root_mm);
        assert!((4.0..60.0).contains(&area), "{area}");
    }

    /// Heights over an open cap of a sphere of this radius, sampled about as densely as a structure.
    fn cap(radius_mm: f64) -> (ObservationSample, Vec<Point3<f64>>) {
        let mut sample = grid(12);
        sample.points.iter_mut().for_each(|p| {
            let (x, y) = (p.x - 5.5, p.y - 5.5);
            *p = Point3::new(x, y, (radius_mm * radius_mm - x * x - y * y).sqrt() - radius_mm);
        });
        sample.normals = sample.points.iter().map(|p| (p - Point3::new(0.0, 0.0, -radius_mm)) / radius_mm).collect();
        let turning = Matrix3::from_diagonal_element(1.0 / radius_mm);
        sample.bending =
            sample.normals.iter().map(|n| mean_square_of_bending(&(turning - n * n.transpose() / radius_mm))).collect();
        let at = sample.points.clone();
        (sample, at)
    }

    #[test]
    fn what_a_height_says_of_sliding_is_worth_less_where_the_surface_is_curved() {
        let kernel = GaussianKernel { width_mm: 6.0, amplitude_mm: 1.5 };
        let prior = SmoothPrior { translation_mm: 1.0, linear: 0.05, kernels: vec![kernel] };
        for radius_mm in [9.0, 12.0, 30.0] {
            let (mut sample, at) = cap(radius_mm);
            let curved: f64 = sample.variances(&at, &prior, 0.02, 12.0).unwrap().iter().sum();
            sample.bending.fill(0.0);
            let linear: f64 = sample.variances(&at, &prior, 0.02, 12.0).unwrap().iter().sum();
            let none = ComponentPosterior::new(&prior, &Point3::origin(), &[], &at).covariances(&[]).unwrap();
            let of_prior: f64 = (0..at.len()).map(|k| none[(k, k)]).sum();
            assert!(curved > 1.02 * linear && curved < of_prior, "{radius_mm}: {linear} {curved} {of_prior}");
        }
        // Without sliding there is no error of linearization.
        let still = SmoothPrior { translation_mm: 0.0, linear: 0.0, kernels: Vec::new() };
        let (sample, at) = cap(9.0);
        assert!(sample.variances(&at, &still, 0.02, 12.0).unwrap().iter().all(|variance| *variance < 1e-12));
    }

    #[test]
    fn the_mean_square_of_bending_is_that_of_draws() {
        let turning = Matrix3::new(0.3, 0.1, 0.0, 0.1, -0.2, 0.0, 0.0, 0.0, 0.0);
        let mut number = numbers(11);
        // The sum of twelve uniform numbers is nearly normal, of variance 1.
        let mut normal = || (0..12).map(|_| number()).sum::<f64>() - 6.0;
        let n = 40_000;
        let total: f64 = (0..n)
            .map(|_| {
                let slid = Vector3::new(normal(), normal(), 0.0);
                (0.5 * slid.dot(&(turning * slid))).powi(2)
            })
            .sum();
        let (expected, drawn) = (mean_square_of_bending(&turning), total / f64::from(n));
        assert!((drawn - expected).abs() < 0.05 * expected, "{drawn} {expected}");
    }

    #[test]
    fn the_sag_is_the_root_mean_square_distance_of_a_sphere_from_its_tangent_plane_over_a_triangle() {
        let (mut sample, _) = cap(9.0);
        let edge_mm = 0.8;
        let height = edge_mm * 0.75f64.sqrt();
        let mut number = numbers(7);
        let draws: Vec<f64> = std::iter::repeat_with(|| (number() - 0.5, number()))
            .map(|(x, y)| (x * edge_mm, y * height))
            .filter(|(x, y)| x.abs() <= 0.5 * edge_mm * (1.0 - y / height))
            .map(|(x, y)| (x * x + (y - height / 3.0).powi(2)) / (2.0 * 9.0))
            .take(20_000)
            .collect();
        let expected = (draws.iter().map(|sag| sag * sag).sum::<f64>() / draws.len() as f64).sqrt();
        let found = sample.sag_mm(edge_mm);
        assert!((found / expected - 1.0).abs() < 0.15, "{found} {expected}");
        sample.bending.fill(0.0);
        assert!(sample.sag_mm(edge_mm) == 0.0);
    }

    #[test]
    fn a_gradient_is_that_of_the_linear_function_along_the_triangle() {
        let vertices = [Point3::new(0.0, 0.0, 0.0), Point3::new(3.0, 0.0, 1.0), Point3::new(1.0, 2.0, -1.0)];
        let slope = Vector3::new(0.4, -1.2, 0.7);
        let found = gradient(&vertices, &[0, 1, 2], |k| slope.dot(&vertices[k].coords) + 5.0);
        for [a, b] in [[0, 1], [1, 2], [2, 0]] {
            let edge = vertices[b] - vertices[a];
            assert!((found.dot(&edge) - slope.dot(&edge)).abs() < 1e-12);
        }
        let normal = (vertices[1] - vertices[0]).cross(&(vertices[2] - vertices[0]));
        assert!(found.dot(&normal).abs() < 1e-12);
        let flat = [vertices[0]; 3];
        assert_eq!(gradient(&flat, &[0, 1, 2], |k| k as f64), Vector3::zeros());
    }

    #[test]
    fn values_are_spread_to_points_between_and_no_further_than_they_reach() {
        let sample = grid(5);
        let values: Vec<f64> = sample.points.iter().map(|p| p.x).collect();
        let found = sample.spread_to(&[Point3::new(2.0, 2.0, 0.0), Point3::new(-50.0, 2.0, 0.0)], &values);
        assert!((found[0] - 2.0).abs() < 1e-9 && found[1] < 0.1, "{found:?}");
        assert!(grid(0).spread_to(&[Point3::origin()], &[]) == [0.0]);
    }

    #[test]
    fn octaves_fall_as_those_of_a_process_of_that_smoothness() {
        let of = octaves(GaussianKernel { width_mm: 8.0, amplitude_mm: 1.0 });
        assert_eq!(of.iter().map(|kernel| kernel.width_mm).collect::<Vec<_>>(), [8.0, 4.0, 2.0]);
        assert!((of[1].amplitude_mm - 0.5f64.powf(2.5)).abs() < 1e-12);
    }
}
