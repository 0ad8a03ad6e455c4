//! The uncertainty of a displacement field with observations of single components.
//!
//! Distances along normals and differences of features observe one component of a displacement each, `⟨d_i, u(p_i)⟩ +
//! ε_i`. For this number of observations the posterior of a Gaussian process can be computed exactly, without a basis:
//! with `G_ij = k(p_i, p_j) ⟨d_i, d_j⟩ + δ_ij σ_i²` and `c_i(p) = k(p_i, p) d_i` the covariance of `u(p)` is `k(p, p) I
//! − Cᵀ G⁻¹ C`.
//!
//! Source: Rasmussen, Williams, "Gaussian Processes for Machine Learning", 2006, section 2.2.

use super::SmoothPrior;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, Mat, Par, Side};
use nalgebra::{Point3, Vector3};
use std::collections::HashMap;

/// A component of a displacement that can be observed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Component {
    /// Position of the displacement, mm.
    pub at: Point3<f64>,
    /// Direction whose product with the displacement is observed: a unit normal for a height in mm, a gradient for the
    /// difference of a feature.
    pub direction: Vector3<f64>,
}

/// A Gaussian process of displacements with observed components, prepared for their noise.
#[derive(Debug)]
pub struct ComponentPosterior {
    /// Covariances of the components without noise, the lower triangle.
    gram: Mat<f64>,
    /// Covariances of each component with the displacement at each point, by axis.
    with_points: [Mat<f64>; 3],
    /// Traces of the covariances of the displacements at each two of the points before any observation, mm².
    before: Mat<f64>,
}

impl ComponentPosterior {
    /// For observations of these `components`, and displacements at `points`. The linear part of `prior` is about
    /// `center`.
    ///
    /// # Cost
    /// `O(N² + N points + points²)` for `N` components; `O(M² + M points + points²)` exponentials for the `M` different
    /// places of observation.
    pub fn new(
        prior: &SmoothPrior,
        center: &Point3<f64>,
        components: &[Component],
        points: &[Point3<f64>],
    ) -> ComponentPosterior {
        let n = components.len();
        // Several components are observed at one place, and covariances depend only on places, so exponentials are
        // computed per place.
        let (places, place_of) = places(components);
        let covariance = |p: &Point3<f64>, q: &Point3<f64>| prior.covariance_of(p, q, center);
        let among = Mat::from_fn(places.len(), places.len(), |i, j| {
            if i < j {
                return 0.0;
            }
            covariance(&places[i], &places[j])
        });
        let gram = Mat::from_fn(n, n, |i, j| {
            if i < j {
                return 0.0;
            }
            let (a, b) = (place_of[i].max(place_of[j]), place_of[i].min(place_of[j]));
            among[(a, b)] * components[i].direction.dot(&components[j].direction)
        });
        let of_points = Mat::from_fn(places.len(), points.len(), |i, k| covariance(&places[i], &points[k]));
        let with_points = std::array::from_fn(|axis| {
            Mat::from_fn(n, points.len(), |i, k| of_points[(place_of[i], k)] * components[i].direction[axis])
        });
        let before = Mat::from_fn(points.len(), points.len(), |k, l| 3.0 * covariance(&points[k], &points[l]));
        ComponentPosterior { gram, with_points, before }
    }

    /// The trace of the posterior covariance of the displacements at each two of the points, mm², if the noise of each
    /// component has the variance in `noise`; the diagonal has the variances. `None` if a number is not finite, or if
    /// observations without noise contradict each other.
    ///
    /// # Cost
    /// `O(N³ + N² points + N points²)` for `N` components.
    pub fn covariances(&self, noise: &[f64]) -> Option<Mat<f64>> {
        let mut gram = self.gram.clone();
        for (i, variance) in noise.iter().enumerate() {
            gram[(i, i)] += variance;
        }
        let factor = gram.llt(Side::Lower).ok()?;
        let mut traces = self.before.clone();
        for covariances in &self.with_points {
            let mut known = covariances.clone();
            solve_lower_triangular_in_place(factor.L(), known.as_mut(), Par::Seq);
            matmul(traces.as_mut(), Accum::Add, known.transpose(), known.as_ref(), -1.0, Par::Seq);
        }
        let is_finite = traces.col_iter().all(|column| column.iter().all(|trace| trace.is_finite()));
        is_finite.then_some(traces)
    }
}

/// The different places of `components`, and the index of the place of each.
fn places(components: &[Component]) -> (Vec<Point3<f64>>, Vec<usize>) {
    let mut places = Vec::new();
    let mut known = HashMap::new();
    let place_of = components.iter().map(|component| {
        *known.entry(component.at.coords.map(f64::to_bits)).or_insert_with(|| {
            places.push(component.at);
            places.len() - 1
        })
    });
    let place_of = place_of.collect();
    (places, place_of)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deformation::GaussianKernel;
    use crate::testing::{cloud, directions, numbers};
    use nalgebra::DMatrix;
    use proptest::prelude::*;

    fn prior(width_mm: f64, amplitude_mm: f64) -> SmoothPrior {
        SmoothPrior { translation_mm: 0.7, linear: 0.05, kernels: vec![GaussianKernel { width_mm, amplitude_mm }] }
    }

    fn observed(n: usize, seed: u64) -> Vec<Component> {
        let points = cloud(seed, n);
        let normals = directions(seed + 1, n);
        // Two components at a place, as for a height and a feature.
        let at = |i: usize| points[i - i % 2];
        normals.iter().enumerate().map(|(i, d)| Component { at: at(i), direction: *d }).collect()
    }

    fn covariances(
        prior: &SmoothPrior,
        center: &Point3<f64>,
        (components, variance): (&[Component], f64),
        points: &[Point3<f64>],
    ) -> Mat<f64> {
        let noise = vec![variance; components.len()];
        ComponentPosterior::new(prior, center, components, points).covariances(&noise).unwrap()
    }

    /// By definition: the covariance of all observations and of the displacements at `p` and `q`, and its Schur complement.
    fn slow(
        prior: &SmoothPrior,
        center: &Point3<f64>,
        (components, variance): (&[Component], f64),
        p: &Point3<f64>,
        q: &Point3<f64>,
    ) -> f64 {
        let n = components.len();
        let joint = DMatrix::from_fn(n + 6, n + 6, |i, j| {
            let part = |k: usize| match components.get(k) {
                Some(c) => (c.at, c.direction),
                None if k < n + 3 => (*p, Vector3::ith(k - n, 1.0)),
                None => (*q, Vector3::ith(k - n - 3, 1.0)),
            };
            let ((at, direction), (other, across)) = (part(i), part(j));
            let noise = if i == j && i < n { variance } else { 0.0 };
            prior.covariance_of(&at, &other, center) * direction.dot(&across) + noise
        });
        let (g, c) = (joint.view((0, 0), (n, n)).into_owned(), joint.view((0, n), (n, 6)).into_owned());
        let rest = joint.view((n, n), (6, 6)) - c.transpose() * g.try_inverse().unwrap() * c;
        rest.view((0, 3), (3, 3)).trace()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn covariances_are_those_of_the_joint_distribution(seed in 0u64..1000, n in 1usize..20, width in 2.0..20.0) {
            let (prior, components) = (prior(width, 1.3), observed(n, seed));
            let center = Point3::new(0.5, -0.5, 1.0);
            let points = cloud(seed + 7, 4);
            let found = covariances(&prior, &center, (&components, 0.2), &points);
            for (k, p) in points.iter().enumerate() {
                for (l, q) in points.iter().enumerate() {
                    let expected = slow(&prior, &center, (&components, 0.2), p, q);
                    let tolerance = 1e-8 * (1.0 + expected.abs());
                    prop_assert!((found[(k, l)] - expected).abs() < tolerance, "{} {}", found[(k, l)], expected);
                }
            }
        }

        #[test]
        fn more_observations_and_less_noise_never_raise_a_variance(seed in 0u64..1000, noise in 0.01..1.0) {
            let (prior, center) = (prior(6.0, 1.0), Point3::origin());
            let points = cloud(seed + 3, 5);
            let of = |n: usize, noise: f64| covariances(&prior, &center, (&observed(24, seed)[..n], noise), &points);
            let (few, many, clear) = (of(12, noise), of(24, noise), of(24, 0.5 * noise));
            for k in 0..points.len() {
                prop_assert!(many[(k, k)] <= few[(k, k)] + 1e-9 && clear[(k, k)] <= many[(k, k)] + 1e-9);
            }
        }
    }

    #[test]
    fn what_no_component_observes_keeps_the_variance_of_the_prior() {
        // Heights over a plane carry no information on displacements within it, except through the linear part.
        let prior = SmoothPrior { linear: 0.0, ..prior(5.0, 1.0) };
        let mut number = numbers(3);
        let components: Vec<Component> = (0..200)
            .map(|_| {
                let at = Point3::new(20.0 * number(), 20.0 * number(), 0.0);
                Component { at, direction: Vector3::z() }
            })
            .collect();
        let found = covariances(&prior, &Point3::origin(), (&components, 1e-4), &[Point3::new(10.0, 10.0, 0.0)]);
        let alone = prior.covariance_of(&Point3::origin(), &Point3::origin(), &Point3::origin());
        assert!((found[(0, 0)] - 2.0 * alone).abs() < 0.01 * alone, "{} {alone}", found[(0, 0)]);
    }

    #[test]
    fn without_observations_the_variance_is_that_of_the_prior() {
        let (prior, p) = (prior(4.0, 2.0), Point3::new(1.0, 2.0, 3.0));
        let found = covariances(&prior, &Point3::origin(), (&[], 0.0), &[p]);
        let expected = 3.0 * (0.7 * 0.7 + 0.05 * 0.05 * 14.0 + 4.0);
        assert!((found[(0, 0)] - expected).abs() < 1e-12);
    }
}
