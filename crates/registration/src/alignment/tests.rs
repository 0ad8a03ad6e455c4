//! The Gaussian assignment against its formula; the compact one is tested on patches, in pose search.

use super::*;
use crate::testing::{cloud, directions, numbers};
use nalgebra::Vector3;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_gaussian_assignment_equals_its_formula(seed in any::<u64>(), n in 1usize..30, m in 1usize..30, sigma in 1.0f64..9.0) {
        let (p, q) = (cloud(seed, n), cloud(seed ^ 1, m));
        let (np, nq) = (directions(seed ^ 2, n), directions(seed ^ 3, m));
        let mut number = numbers(seed ^ 4);
        let mut list = |k: usize| -> Vec<f64> { (0..k).map(|_| 0.1 + number()).collect() };
        let (ap, aq, fp, fq) = (list(n), list(m), list(2 * n), list(2 * m));
        let source = OrientedPoints { points: &p, normals: &np, areas: &ap, features: &fp };
        let target = OrientedPoints { points: &q, normals: &nq, areas: &aq, features: &fq };
        let kernel =
            AssignmentKernel { sigma_mm: sigma, normal_weight: 1.5, feature_precision: vec![0.7, 2.0], outlier_share: 0.1 };
        let found = assign(&source, &AssignmentTarget::new(&target), &kernel);
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
        // The assigned part of the target does not exceed the whole.
        let assigned: f64 = (0..n).map(|i| found.mass[i] * ap[i]).sum();
        prop_assert!(assigned <= aq.iter().sum::<f64>() * (1.0 + 1e-5));
    }
}

#[test]
fn one_thread_and_many_give_the_same_bits() {
    let (points, target) = (cloud(3, 400), cloud(5, 300));
    let (normals, target_normals) = (directions(4, 400), directions(6, 300));
    let all = || {
        let source = OrientedPoints { points: &points, normals: &normals, areas: &[1.0; 400], features: &[0.5; 400] };
        let target =
            OrientedPoints { points: &target, normals: &target_normals, areas: &[1.2; 300], features: &[0.4; 300] };
        let kernel =
            AssignmentKernel { sigma_mm: 3.0, normal_weight: 1.0, feature_precision: vec![1.0], outlier_share: 0.1 };
        assign(&source, &AssignmentTarget::new(&target), &kernel)
    };
    let on = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(all);
    assert_eq!(on(1), on(4));
}

#[test]
fn annealing_is_geometric_and_ends_where_it_says() {
    let values = |progress: fn(u32, u32) -> f64| (0..5).map(move |k| annealed(16.0, 1.0, progress(k, 5)));
    let ends: Vec<f64> = values(progress_to_end).collect();
    assert_eq!(ends, [16.0, 8.0, 4.0, 2.0, 1.0]);
    assert!(values(progress_short_of_end).all(|v| v > 1.5));
    assert_eq!(progress_to_end(0, 1), 0.0);
}
