//! The finite basis and the posterior compared with the Gaussian process they represent, and laws of smooth fields.

use super::*;
use crate::testing::{cloud, directions, numbers};
use faer::{Mat, Side, linalg::solvers::Solve};
use nalgebra::{Matrix3, Point3, Vector3};
use proptest::prelude::*;

fn prior() -> SmoothPrior {
    SmoothPrior {
        translation_mm: 4.0,
        linear: 0.2,
        kernels: vec![
            GaussianKernel { width_mm: 9.0, amplitude_mm: 3.0 },
            GaussianKernel { width_mm: 4.0, amplitude_mm: 0.7 },
        ],
    }
}

/// Prior covariance of the displacements at two points, by definition.
fn covariance(prior: &SmoothPrior, center: &Point3<f64>, p: &Point3<f64>, q: &Point3<f64>) -> f64 {
    let smooth: f64 = prior
        .kernels
        .iter()
        .map(|k| k.amplitude_mm.powi(2) * (-(p - q).norm_squared() / (2.0 * k.width_mm.powi(2))).exp())
        .sum();
    prior.translation_mm.powi(2) + prior.linear.powi(2) * (p - center).dot(&(q - center)) + smooth
}

fn observations(seed: u64, n: usize, isotropic: bool) -> Vec<Observation> {
    let mut number = numbers(seed);
    let normals = directions(seed ^ 9, n);
    normals
        .into_iter()
        .map(|normal| {
            let across = 0.1 + number();
            let displacement = Vector3::new(number(), number(), number()) * 3.0;
            Observation {
                displacement,
                normal,
                across,
                along: if isotropic { across } else { across + 4.0 * number() },
            }
        })
        .collect()
}

fn center_of(points: &[Point3<f64>]) -> Point3<f64> {
    Point3::from(points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_basis_has_the_covariance_of_the_prior(seed in any::<u64>(), n in 1usize..40) {
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let product = &values * values.transpose();
        let center = center_of(&points);
        // Eigenvectors left out have less than 1e-5 of the largest variance, which is at most the sum of all.
        let tolerance = 1e-5 * n as f64 * prior().kernels.iter().map(|k| k.amplitude_mm.powi(2)).sum::<f64>() + 1e-9;
        for i in 0..n {
            for j in 0..n {
                let expected = covariance(&prior(), &center, &points[i], &points[j]);
                prop_assert!((product[(i, j)] - expected).abs() < tolerance, "{} {expected}", product[(i, j)]);
            }
        }
    }

    #[test]
    fn what_few_functions_do_not_express_is_the_rest_of_the_variance(seed in any::<u64>(), n in 20usize..40) {
        let (prior, points) = (prior(), cloud(seed, n));
        let center = center_of(&points);
        let mut before = f64::INFINITY;
        for n_inducing in [1, 8, n] {
            let basis = FieldBasis::new(&points, prior.clone(), n_inducing).unwrap();
            let values = basis.values(&points);
            let unexpressed = basis.unexpressed(values.as_ref());
            for (i, p) in points.iter().enumerate() {
                let expressed: f64 = (0..basis.n_functions()).map(|k| values[(i, k)].powi(2)).sum();
                let all = covariance(&prior, &center, p, p);
                prop_assert!((all - expressed - unexpressed[i]).abs() < 1e-4 * all, "{} {}", all - expressed, unexpressed[i]);
            }
            let total: f64 = unexpressed.iter().sum();
            prop_assert!(total <= before + 1e-9);
            before = total;
        }
        prop_assert!(before < 1e-2 * n as f64 * covariance(&prior, &center, &center, &center));
    }

    #[test]
    fn a_fit_is_the_posterior_of_the_gaussian_process(seed in any::<u64>(), n in 2usize..25, isotropic in any::<bool>()) {
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let observed = observations(seed, n, isotropic);
        let fitted = fit_field(values.as_ref(), &observed).unwrap();
        // u = K (K + N)⁻¹ d and Cov u = K − K (K + N)⁻¹ K, with K over all points and axes: the covariance of the
        // basis, which equals that of the prior except for the eigenvectors left out (the test before this one).
        let of_an_axis = &values * values.transpose();
        let prior_covariance =
            Mat::from_fn(3 * n, 3 * n, |a, b| if a % 3 == b % 3 { of_an_axis[(a / 3, b / 3)] } else { 0.0 });
        let noise: Vec<Matrix3<f64>> = observed
            .iter()
            .map(|p| {
                let along = p.normal * p.normal.transpose();
                along / p.along + (Matrix3::identity() - along) / p.across
            })
            .collect();
        let system = Mat::from_fn(3 * n, 3 * n, |a, b| {
            prior_covariance[(a, b)] + if a / 3 == b / 3 { noise[a / 3][(a % 3, b % 3)] } else { 0.0 }
        });
        let factor = system.llt(Side::Lower).unwrap();
        let seen = Mat::from_fn(3 * n, 1, |a, _| observed[a / 3].displacement[a % 3]);
        let mean = &prior_covariance * factor.solve(&seen);
        let found = fitted.displacements(values.as_ref());
        for i in 0..n {
            for a in 0..3 {
                prop_assert!((found[i][a] - mean[(3 * i + a, 0)]).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn components_determine_a_field_as_their_normal_equations_say(seed in any::<u64>(), n in 2usize..25) {
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let (m, mut number) = (values.ncols(), numbers(seed ^ 3));
        // No component at the first point, and one to three at each other one.
        let mut known = vec![Information::none(); n];
        let mut rows: Vec<(usize, Vector3<f64>, f64, f64)> = Vec::new();
        for (i, known) in known.iter_mut().enumerate().skip(1) {
            for direction in directions(seed ^ i as u64, 1 + i % 3) {
                let (value, precision) = (3.0 * number(), 0.1 + 4.0 * number());
                known.add(&direction, value, precision);
                rows.push((i, direction, value, precision));
            }
        }
        let found = fit_field_to(values.as_ref(), &known).unwrap();
        // Observation by observation: `(I + Σ π a aᵀ) c = Σ π y a` for `a = d ⊗ φ`.
        let of_row = |&(i, direction, ..): &(usize, Vector3<f64>, f64, f64), k: usize| direction[k / m] * values[(i, k % m)];
        let system = Mat::from_fn(3 * m, 3 * m, |k, l| {
            let sum: f64 = rows.iter().map(|row| row.3 * of_row(row, k) * of_row(row, l)).sum();
            sum + if k == l { 1.0 } else { 0.0 }
        });
        let right = Mat::from_fn(3 * m, 1, |k, _| rows.iter().map(|row| row.3 * row.2 * of_row(row, k)).sum::<f64>());
        let expected = system.llt(Side::Lower).unwrap().solve(&right);
        for k in 0..3 * m {
            prop_assert!((found.coefficients[(k % m, k / m)] - expected[(k, 0)]).abs() < 1e-9);
        }
    }

    #[test]
    fn an_affine_motion_is_reproduced(seed in any::<u64>(), n in 12usize..60) {
        let points = cloud(seed, n);
        let mut number = numbers(seed ^ 5);
        let linear = Matrix3::from_fn(|_, _| 0.2 * (number() - 0.5));
        let shift = Vector3::new(number(), number(), number());
        let center = center_of(&points);
        let affine = |p: &Point3<f64>| linear * (p - center) + shift;
        let basis = FieldBasis::new(&points, prior(), 20).unwrap();
        let values = basis.values(&points);
        let precision = 1e6;
        let observed = |p: &Point3<f64>| {
            Observation { displacement: affine(p), normal: Vector3::x(), along: precision, across: precision }
        };
        let fitted = fit_field(values.as_ref(), &points.iter().map(observed).collect::<Vec<_>>()).unwrap();
        // The fit is no worse than the affine motion itself, which has no residual and this cost.
        let cost = shift.norm_squared() / prior().translation_mm.powi(2) + linear.norm_squared() / prior().linear.powi(2);
        let found = fitted.displacements(values.as_ref());
        let squares: f64 = points.iter().zip(&found).map(|(p, u)| (u - affine(p)).norm_squared()).sum();
        prop_assert!(precision * squares + fitted.cost() <= cost * (1.0 + 1e-3) + 1e-6, "{squares}");
    }

    #[test]
    fn higher_precision_leaves_a_smaller_residual(seed in any::<u64>(), n in 2usize..20) {
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let mut last = f64::INFINITY;
        for factor in [1e-2, 1.0, 1e2, 1e4] {
            let observed: Vec<Observation> = observations(seed, n, false)
                .into_iter()
                .map(|p| Observation { along: p.along * factor, across: p.across * factor, ..p })
                .collect();
            let found = fit_field(values.as_ref(), &observed).unwrap().displacements(values.as_ref());
            // In the metric of the observations, a weaker prior leaves a smaller residual.
            let residual: f64 = observed
                .iter()
                .zip(&found)
                .map(|(p, u)| {
                    let d = p.displacement - u;
                    (p.across * d.norm_squared() + (p.along - p.across) * d.dot(&p.normal).powi(2)) / factor
                })
                .sum();
            prop_assert!(residual <= last + 1e-9);
            last = residual;
        }
    }

    #[test]
    fn a_field_changes_no_faster_than_its_cost_allows(seed in any::<u64>(), n in 2usize..30) {
        // The Cauchy-Schwarz inequality in the reproducing kernel Hilbert space.
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let fitted = fit_field(values.as_ref(), &observations(seed, n, false)).unwrap();
        let found = fitted.displacements(values.as_ref());
        let center = center_of(&points);
        for i in 1..n {
            let k = |a: usize, b: usize| covariance(&prior(), &center, &points[a], &points[b]);
            let distance = (k(i, i) + k(0, 0) - 2.0 * k(i, 0)).max(0.0).sqrt();
            prop_assert!((found[i] - found[0]).norm() <= fitted.cost().sqrt() * distance * (1.0 + 1e-3) + 1e-6);
        }
    }
}

#[test]
fn no_points_have_no_basis() {
    assert!(FieldBasis::new(&[], prior(), 5).is_none());
}

#[test]
fn one_thread_and_many_give_the_same_bits() {
    let points = cloud(3, 400);
    let all = || {
        let basis = FieldBasis::new(&points, prior(), 60).unwrap();
        let values = basis.values(&points);
        let fitted = fit_field(values.as_ref(), &observations(7, 400, false)).unwrap();
        fitted.displacements(values.as_ref())
    };
    let on = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(all);
    assert_eq!(on(1), on(4));
}
