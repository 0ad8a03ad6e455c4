//! The solvers agree with each other on well-posed pairs, and return the same error for every fault.

use super::*;
use crate::testing::{cloud, numbers, pose};
use proptest::prelude::*;

/// Pairs, weights and whether reflections are allowed.
struct Problem {
    source: Vec<Point3<f64>>,
    target: Vec<Point3<f64>>,
    weights: Option<Vec<f64>>,
    allow_reflection: bool,
}

/// A well-posed problem: any number of pairs, planar ones, mirrored ones, noise, weights, offsets of up to 10 m.
fn problem(seed: u64) -> Problem {
    let mut number = numbers(seed ^ 0x5eed);
    let n = 4 + (number() * 60.0) as usize;
    let mut source = cloud(seed, n);
    // Four fixed corners keep a small draw from lying close to a line.
    for (p, corner) in source.iter_mut().zip([[0.0, 0.0, 0.0], [40.0, 0.0, 1.0], [0.0, 20.0, 2.0], [0.0, 0.0, 10.0]]) {
        *p = Point3::from(corner);
    }
    let planar = number() < 0.25;
    if planar {
        for p in &mut source {
            p.z = 0.25 * p.x - 0.5 * p.y;
        }
    }
    let mut truth = pose(seed ^ 1);
    let mirrored = !planar && number() < 0.25;
    if mirrored {
        truth.rotation = -truth.rotation;
    }
    let far = if number() < 0.25 { 1e4 } else { 1.0 };
    let offset = Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5) * far;
    let noise = if number() < 0.5 { 0.0 } else { 0.3 };
    let mut target: Vec<_> = source.iter().map(|p| truth.apply(p) + offset).collect();
    for t in &mut target {
        *t += Vector3::new(number() - 0.5, number() - 0.5, number() - 0.5) * noise;
    }
    let weights = (number() < 0.5).then(|| (0..n).map(|_| 0.1 + number()).collect());
    Problem { source, target, weights, allow_reflection: mirrored || number() < 0.25 }
}

#[test]
fn the_three_agree_on_ten_thousand_problems() {
    let mut widest: f64 = 0.0;
    for seed in 0..10_000 {
        let p = problem(seed);
        let solve =
            |solver| solve_orientation(solver, &p.source, &p.target, p.weights.as_deref(), p.allow_reflection).unwrap();
        let svd = solve(OrientationSolver::Svd);
        for solver in OrientationSolver::ALL {
            let found = solve(solver);
            let apart = (found.rotation - svd.rotation).norm();
            assert!(apart < 1e-9, "{solver:?}, seed {seed}: {apart:e}");
            let scale = svd.translation.norm().max(1.0);
            assert!((found.translation - svd.translation).norm() < 1e-9 * scale, "{solver:?}, seed {seed}");
            let square = found.rotation.transpose() * found.rotation;
            assert!((square - Matrix3::identity()).norm() < 1e-12, "{solver:?}, seed {seed}");
            widest = widest.max(apart);
        }
    }
    println!("largest difference of two rotations: {widest:e}");
}

#[test]
fn the_three_agree_where_the_data_prefer_a_reflection() {
    for seed in 0..200 {
        let source = cloud(seed, 30);
        let mirrored: Vec<_> = source.iter().map(|p| pose(seed).apply(&Point3::new(p.x, p.y, -p.z))).collect();
        for allow_reflection in [false, true] {
            let solve = |solver| solve_orientation(solver, &source, &mirrored, None, allow_reflection).unwrap();
            let svd = solve(OrientationSolver::Svd);
            assert_eq!(svd.is_reflection(), allow_reflection);
            for solver in OrientationSolver::ALL {
                assert!((solve(solver).rotation - svd.rotation).norm() < 1e-9, "{solver:?}, seed {seed}");
            }
        }
    }
}

proptest! {
    #[test]
    fn the_default_solver_keeps_the_bits_of_absolute_orientation(seed in any::<u64>(), n in 4usize..30) {
        let (source, target) = (cloud(seed, n), cloud(seed ^ 7, n));
        prop_assert_eq!(
            solve_orientation(OrientationSolver::default(), &source, &target, None, false),
            crate::absolute_orientation(&source, &target, None, false)
        );
    }
}

#[test]
fn every_solver_returns_the_same_errors() {
    let good = cloud(2, 6);
    let line: Vec<_> =
        (0..6).map(|k| Point3::new(0.3 * f64::from(k), 0.7 * f64::from(k), 0.1 * f64::from(k))).collect();
    let one_place = vec![Point3::new(1.0, 2.0, 3.0); 6];
    let mut broken = good.clone();
    broken[2].x = f64::NAN;
    let mut huge = good.clone();
    huge[1].y = 1e200;
    let two_count = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    for solver in OrientationSolver::ALL {
        let solve = |s: &[Point3<f64>], t: &[Point3<f64>], w| solve_orientation(solver, s, t, w, true);
        for (source, target) in
            [(&line, &good), (&good, &line), (&line, &line), (&one_place, &good), (&good, &one_place)]
        {
            assert_eq!(solve(source, target, None), Err(OrientationError::Degenerate), "{solver:?}");
        }
        assert_eq!(solve(&good, &good, Some(&two_count)), Err(OrientationError::Degenerate));
        assert_eq!(solve(&good[..2], &good[..2], None), Err(OrientationError::TooFewPairs { n: 2 }));
        assert_eq!(solve(&broken, &good, None), Err(OrientationError::NonFinite));
        assert_eq!(solve(&huge, &huge, None), Err(OrientationError::NonFinite));
        assert_eq!(solve(&good, &good, Some(&[0.0; 6])), Err(OrientationError::NonFinite));
        assert_eq!(solve(&good, &good, Some(&[1.0, 1.0, 1.0, 1.0, 1.0, -1.0])), Err(OrientationError::NonFinite));
        let expected = OrientationError::LengthMismatch { n_source: 6, n_target: 5, n_weights: 6 };
        assert_eq!(solve(&good, &good[..5], None), Err(expected));
    }
}
