//! Scores of synthetic groups against what their distributions say.

use super::*;
use homolog_primitives::observe::Silent;
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;

/// Independent normal values of `n` subjects, with a deviation of its own at each vertex if `uneven`.
fn drawn(n: usize, vertices: usize, uneven: bool, seed: u64) -> Vec<Vec<f64>> {
    let (normal, mut random) = (Normal::standard(), Xoshiro256PlusPlus::seed_from_u64(seed));
    let mut draw = || normal.inverse_cdf(((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64);
    let deviations: Vec<f64> = (0..vertices).map(|_| if uneven { (0.7 * draw()).exp() } else { 1.0 }).collect();
    (0..n).map(|_| deviations.iter().map(|deviation| 3.0 + deviation * draw()).collect()).collect()
}

fn norm(values: Vec<Vec<f64>>) -> Norm {
    let weights = vec![1.0 / values[0].len() as f64; values[0].len()];
    Norm::new(values, weights).unwrap()
}

#[test]
fn leaving_out_is_a_norm_of_the_others() {
    let values = drawn(9, 40, true, 3);
    let whole = norm(values.clone());
    let found = whole.leave_one_out(&Silent).unwrap();
    for (left, own) in values.iter().enumerate() {
        let others: Vec<_> = values.iter().enumerate().filter(|(k, _)| *k != left).map(|(_, of)| of.clone()).collect();
        let slow = norm(others).scores(own);
        assert!((found.largest[left] - largest(&slow)).abs() < 1e-9);
    }
}

/// A design of the mean, a number and a level, of `n` rows.
fn design(n: usize) -> Vec<[f64; 3]> {
    (0..n).map(|k| [1.0, ((7 * k) % n) as f64 - 4.0, f64::from(u8::from(k % 3 == 0))]).collect()
}

fn regressed(values: &[Vec<f64>], rows: &[[f64; 3]], own: [f64; 3]) -> Norm {
    let model = LinearModel::new(&faer::Mat::from_fn(rows.len(), 3, |i, k| rows[i][k]));
    let weights = vec![1.0 / values[0].len() as f64; values[0].len()];
    Norm::adjusted(values, weights, &model, &own).unwrap()
}

#[test]
fn leaving_out_is_a_regression_of_the_others() {
    let (values, rows) = (drawn(12, 40, true, 5), design(12));
    let found = regressed(&values, &rows, rows[0]).leave_one_out(&Silent).unwrap();
    for left in 0..12 {
        let without = |k: &usize| *k != left;
        let others: Vec<_> = (0..12).filter(without).map(|k| values[k].clone()).collect();
        let of_others: Vec<_> = (0..12).filter(without).map(|k| rows[k]).collect();
        let slow = regressed(&others, &of_others, rows[left]).scores(&values[left]);
        assert!((found.largest[left] - largest(&slow)).abs() < 1e-8, "{left}");
    }
}

#[test]
fn a_regression_on_nothing_is_the_mean() {
    let values = drawn(9, 40, true, 6);
    let plain = norm(values.clone());
    let model = LinearModel::new(&faer::Mat::from_fn(9, 1, |_, _| 1.0));
    let same = Norm::adjusted(&values, vec![1.0 / 40.0; 40], &model, &[1.0]).unwrap();
    let own = vec![4.0; 40];
    assert!(plain.scores(&own).iter().zip(same.scores(&own)).all(|(a, b)| (a - b).abs() < 1e-9));
    let left_out = |norm: &Norm| norm.leave_one_out(&Silent).unwrap().largest;
    assert!(left_out(&plain).iter().zip(left_out(&same)).all(|(a, b)| (a - b).abs() < 1e-9));
}

#[test]
fn without_moderation_a_score_is_the_quantile_of_a_predictive_t() {
    // Many members leave the variances to themselves.
    let values: Vec<Vec<f64>> = drawn(300, 400, true, 8);
    let found = norm(values.clone());
    let own: Vec<f64> = vec![4.0; 400];
    let scores = found.scores(&own);
    let students = StudentsT::new(0.0, 1.0, 299.0).unwrap();
    for v in 0..400 {
        let mean = values.iter().map(|of| of[v]).sum::<f64>() / 300.0;
        let variance = values.iter().map(|of| (of[v] - mean).powi(2)).sum::<f64>() / 299.0;
        let t = (4.0 - mean) / (variance * (1.0 + 1.0 / 300.0)).sqrt();
        let plain = Normal::standard().inverse_cdf(students.cdf(t));
        let is_small = variance < 0.2;
        assert!(is_small || (scores[v] - plain).abs() < 0.05 + 0.05 * plain.abs(), "{} {plain}", scores[v]);
    }
}

#[test]
fn scores_of_left_out_members_are_standard() {
    for (n, uneven) in [(8, false), (8, true), (20, true), (60, true)] {
        let found = norm(drawn(n, 3000, uneven, n as u64)).leave_one_out(&Silent).unwrap().calibration;
        assert!(found.mean.abs() < 0.05 && (found.rms - 1.0).abs() < 0.05, "{n} {found:?}");
        assert!((found.beyond_1_96 - 0.05).abs() < 0.01, "{n} {found:?}");
        assert!((found.beyond_2_576 - 0.01).abs() < 0.005, "{n} {found:?}");
    }
}

#[test]
fn a_further_subject_exceeds_the_bound_as_often_as_it_says() {
    for (n, origin) in [(8, BoundOrigin::Fitted), (19, BoundOrigin::Rank), (60, BoundOrigin::Rank)] {
        let (mut above, mut unlikely, tries) = (0, 0, 600);
        for seed in 0..tries {
            let mut values = drawn(n + 1, 60, false, 1000 + seed);
            let own = values.pop().unwrap();
            let norm = norm(values);
            let found = norm.leave_one_out(&Silent).unwrap();
            let (bound, most) = (found.bound(0.05), largest(&norm.scores(&own)));
            assert_eq!(bound.origin, origin);
            above += usize::from(most > bound.score);
            unlikely += usize::from(found.p_of_largest(most) <= 0.2);
        }
        // Three standard errors are 0.027 and 0.05.
        let share = |count: usize| count as f64 / tries as f64;
        assert!((share(above) - 0.05).abs() < 0.03, "{n}: {}", share(above));
        let possible = (0.2 * (n + 1) as f64).floor() / (n + 1) as f64;
        assert!((share(unlikely) - possible).abs() < 0.06, "{n}: {}", share(unlikely));
    }
}

#[test]
fn quantiles_hold_far_in_the_tail() {
    for z in [0.0, 0.3, 1.96, 5.0, 12.0, 30.0] {
        let found = quantile(Normal::standard().sf(z));
        assert!((found - z).abs() < 1e-6, "{z} {found}");
    }
    assert_eq!(quantile(0.0), LARGEST);
}

#[test]
fn few_or_equal_members_are_no_norm() {
    assert!(Norm::new(vec![vec![1.0, 2.0]; 3], vec![0.5; 2]).is_none());
    assert!(Norm::new(vec![vec![1.0, 2.0]; 9], vec![0.5; 2]).is_none());
}
