//! The fast versions against slow obvious ones, and the laws of smooth fields.

use super::*;
use faer::{Mat, Side, linalg::solvers::Solve};
use nalgebra::{Matrix3, Point3, Vector3};
use proptest::prelude::*;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    move || (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// Points in a box of 40 × 20 × 10 mm.
fn cloud(seed: u64, n: usize) -> Vec<Point3<f64>> {
    let mut number = numbers(seed);
    (0..n).map(|_| Point3::new(40.0 * number(), 20.0 * number(), 10.0 * number())).collect()
}

fn directions(seed: u64, n: usize) -> Vec<Vector3<f64>> {
    let mut number = numbers(seed);
    (0..n).map(|_| Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5).normalize()).collect()
}

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

/// What the prior says of two points, from its definition.
fn covariance(prior: &SmoothPrior, center: &Point3<f64>, p: &Point3<f64>, q: &Point3<f64>) -> f64 {
    let smooth: f64 = prior
        .kernels
        .iter()
        .map(|k| k.amplitude_mm.powi(2) * (-(p - q).norm_squared() / (2.0 * k.width_mm.powi(2))).exp())
        .sum();
    prior.translation_mm.powi(2) + prior.linear.powi(2) * (p - center).dot(&(q - center)) + smooth
}

fn pulls(seed: u64, n: usize, isotropic: bool) -> Vec<Pull> {
    let mut number = numbers(seed);
    let normals = directions(seed ^ 9, n);
    normals
        .into_iter()
        .map(|normal| {
            let across = 0.1 + number();
            let displacement = Vector3::new(number(), number(), number()) * 3.0;
            Pull { displacement, normal, across, along: if isotropic { across } else { across + 4.0 * number() } }
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
        for i in 0..n {
            for j in 0..n {
                let expected = covariance(&prior(), &center, &points[i], &points[j]);
                prop_assert!((product[(i, j)] - expected).abs() < 1e-4, "{} {expected}", product[(i, j)]);
            }
        }
    }

    #[test]
    fn a_fit_is_the_posterior_of_the_gaussian_process(seed in any::<u64>(), n in 2usize..25, isotropic in any::<bool>()) {
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let pulls = pulls(seed, n, isotropic);
        let fitted = fit(values.as_ref(), &pulls).unwrap();
        // u = K (K + N)⁻¹ d and Cov u = K − K (K + N)⁻¹ K, with K over all points and axes.
        let center = center_of(&points);
        let prior_covariance = Mat::from_fn(3 * n, 3 * n, |a, b| {
            if a % 3 == b % 3 { covariance(&prior(), &center, &points[a / 3], &points[b / 3]) } else { 0.0 }
        });
        let noise: Vec<Matrix3<f64>> = pulls
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
        let seen = Mat::from_fn(3 * n, 1, |a, _| pulls[a / 3].displacement[a % 3]);
        let mean = &prior_covariance * factor.solve(&seen);
        let left = &prior_covariance - &prior_covariance * factor.solve(&prior_covariance);
        let (found, uncertainty) = (fitted.displacements(values.as_ref()), fitted.covariances(values.as_ref()));
        for i in 0..n {
            for a in 0..3 {
                prop_assert!((found[i][a] - mean[(3 * i + a, 0)]).abs() < 1e-4);
                for b in 0..3 {
                    prop_assert!((uncertainty[i][(a, b)] - left[(3 * i + a, 3 * i + b)]).abs() < 1e-4);
                }
            }
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
        let sure = |p: &Point3<f64>| {
            Pull { displacement: affine(p), normal: Vector3::x(), along: precision, across: precision }
        };
        let fitted = fit(values.as_ref(), &points.iter().map(sure).collect::<Vec<_>>()).unwrap();
        // The fit is no worse than the affine motion itself, which has no residual and this cost.
        let cost = shift.norm_squared() / prior().translation_mm.powi(2) + linear.norm_squared() / prior().linear.powi(2);
        let found = fitted.displacements(values.as_ref());
        let squares: f64 = points.iter().zip(&found).map(|(p, u)| (u - affine(p)).norm_squared()).sum();
        prop_assert!(precision * squares + fitted.cost() <= cost * (1.0 + 1e-3) + 1e-6, "{squares}");
    }

    #[test]
    fn the_surer_the_pulls_the_closer_the_field(seed in any::<u64>(), n in 2usize..20) {
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let mut last = f64::INFINITY;
        for factor in [1e-2, 1.0, 1e2, 1e4] {
            let pulls: Vec<Pull> = pulls(seed, n, false)
                .into_iter()
                .map(|p| Pull { along: p.along * factor, across: p.across * factor, ..p })
                .collect();
            let found = fit(values.as_ref(), &pulls).unwrap().displacements(values.as_ref());
            // In the metric of the pulls, less prior leaves less residual.
            let residual: f64 = pulls
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
        // Cauchy and Schwarz in the space of the kernel.
        let points = cloud(seed, n);
        let basis = FieldBasis::new(&points, prior(), n).unwrap();
        let values = basis.values(&points);
        let fitted = fit(values.as_ref(), &pulls(seed, n, false)).unwrap();
        let found = fitted.displacements(values.as_ref());
        let center = center_of(&points);
        for i in 1..n {
            let k = |a: usize, b: usize| covariance(&prior(), &center, &points[a], &points[b]);
            let distance = (k(i, i) + k(0, 0) - 2.0 * k(i, 0)).max(0.0).sqrt();
            prop_assert!((found[i] - found[0]).norm() <= fitted.cost().sqrt() * distance * (1.0 + 1e-3) + 1e-6);
        }
    }

    #[test]
    fn a_grid_finds_what_looking_at_all_points_finds(seed in any::<u64>(), n in 0usize..80, radius in 0.1f64..30.0) {
        let points = cloud(seed, n);
        let grid = NeighborGrid::new(&points, radius);
        for query in cloud(seed ^ 1, 10).iter().map(|p| Point3::from(p.coords * 2.0 - Vector3::repeat(10.0))) {
            let mut found = Vec::new();
            grid.within(&query, radius, |i, squared| found.push((i as usize, squared)));
            found.sort_by_key(|f| f.0);
            let expected: Vec<(usize, f64)> = (0..n)
                .map(|i| (i, (points[i] - query).norm_squared()))
                .filter(|&(_, squared)| squared <= radius * radius)
                .collect();
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn farthest_points_are_those_of_the_definition(seed in any::<u64>(), n in 1usize..400, m in 1usize..60, grid: bool) {
        // On a grid many are equally far, and some coincide.
        let snapped = |p: Point3<f64>| if grid { p.map(|c| (c / 4.0).round() * 4.0) } else { p };
        let points: Vec<Point3<f64>> = cloud(seed, n).into_iter().map(snapped).collect();
        prop_assert_eq!(farthest_points(&points, m), farthest_by_definition(&points, m));
    }
}

/// Each the first of those farthest from all before it, every distance taken anew.
fn farthest_by_definition(points: &[Point3<f64>], n: usize) -> Vec<usize> {
    let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
    let mut chosen: Vec<usize> = Vec::new();
    while chosen.len() < n.min(points.len()) {
        let from_chosen = |p: &Point3<f64>| {
            chosen.iter().map(|&c: &usize| (p - points[c]).norm_squared()).fold(f64::INFINITY, f64::min)
        };
        let distance = |p: &Point3<f64>| {
            if chosen.is_empty() { (p.coords - center).norm_squared() } else { from_chosen(p) }
        };
        let all: Vec<f64> = points.iter().map(distance).collect();
        let largest = all.iter().copied().fold(0.0, f64::max);
        if !chosen.is_empty() && largest == 0.0 {
            break;
        }
        chosen.extend(all.iter().position(|&d| d == largest));
    }
    chosen
}

#[test]
fn coincident_points_are_chosen_once() {
    assert_eq!(farthest_points(&[Point3::origin(); 5], 3), [0]);
    assert!(farthest_points(&[], 3).is_empty());
    assert!(FieldBasis::new(&[], prior(), 5).is_none());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn an_assignment_is_that_of_its_definition(seed in any::<u64>(), n in 1usize..30, m in 1usize..30, sigma in 1.0f64..9.0) {
        let (p, q) = (cloud(seed, n), cloud(seed ^ 1, m));
        let (np, nq) = (directions(seed ^ 2, n), directions(seed ^ 3, m));
        let mut number = numbers(seed ^ 4);
        let mut list = |k: usize| -> Vec<f64> { (0..k).map(|_| 0.1 + number()).collect() };
        let (ap, aq, fp, fq) = (list(n), list(m), list(2 * n), list(2 * m));
        let source = Samples { points: &p, normals: &np, areas: &ap, features: &fp };
        let target = Samples { points: &q, normals: &nq, areas: &aq, features: &fq };
        let likeness = Likeness { sigma_mm: sigma, normal_weight: 1.5, feature_precision: vec![0.7, 2.0], outlier: 0.1 };
        let found = assign(&source, &target, &likeness);
        let g = |i: usize, j: usize| {
            let squared = (p[i] - q[j]).norm_squared();
            let agreement = np[i].dot(&nq[j]);
            if squared > 9.0 * sigma * sigma || agreement <= 0.0 {
                return 0.0;
            }
            let unlike = 0.7 * (fp[2 * i] - fq[2 * j]).powi(2) + 2.0 * (fp[2 * i + 1] - fq[2 * j + 1]).powi(2);
            (-squared / (2.0 * sigma * sigma) - 1.5 * (1.0 - agreement) - 0.5 * unlike).exp()
        };
        let background = 0.1 * std::f64::consts::TAU * sigma * sigma;
        let weight = |i: usize, j: usize| aq[j] * g(i, j) / (background + (0..n).map(|k| ap[k] * g(k, j)).sum::<f64>());
        for (i, point) in p.iter().enumerate() {
            let mass: f64 = (0..m).map(|j| weight(i, j)).sum();
            // Affinities are 32-bit numbers.
            prop_assert!((found.mass[i] - mass).abs() < 1e-5 * (1.0 + mass));
            if mass > 0.0 {
                let mean = (0..m).fold(Vector3::zeros(), |s, j| s + q[j].coords * weight(i, j)) / mass;
                prop_assert!((found.targets[i].coords - mean).norm() < 1e-3);
            } else {
                prop_assert_eq!(found.targets[i], *point);
            }
        }
        // No more of the target is given away than there is.
        let given: f64 = (0..n).map(|i| found.mass[i] * ap[i]).sum();
        prop_assert!(given <= aq.iter().sum::<f64>() * (1.0 + 1e-5));
    }
}

#[test]
fn one_thread_and_many_give_the_same_bits() {
    let points = cloud(3, 400);
    let (normals, areas, features) = (directions(4, 400), vec![1.0; 400], vec![0.5; 400]);
    let target = cloud(5, 300);
    let (target_normals, target_areas, target_features) = (directions(6, 300), vec![1.2; 300], vec![0.4; 300]);
    let all = || {
        let source = Samples { points: &points, normals: &normals, areas: &areas, features: &features };
        let target =
            Samples { points: &target, normals: &target_normals, areas: &target_areas, features: &target_features };
        let likeness = Likeness { sigma_mm: 3.0, normal_weight: 1.0, feature_precision: vec![1.0], outlier: 0.1 };
        let found = assign(&source, &target, &likeness);
        let basis = FieldBasis::new(&points, prior(), 60).unwrap();
        let values = basis.values(&points);
        let fitted = fit(values.as_ref(), &pulls(7, 400, false)).unwrap();
        (found, fitted.displacements(values.as_ref()))
    };
    let on = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(all);
    assert_eq!(on(1), on(4));
}
