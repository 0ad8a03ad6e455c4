//! Weights of features, learned from the two surfaces alone.
//!
//! A feature is worth as much as it separates true pairs from others. In units of its scale, let `b_f` be the mean
//! difference of the feature between corresponding points and `r_f` the mean difference between any two points. If
//! differences have Laplace distributions of these means, the logarithm of the odds that a pair corresponds falls by
//! `1/b_f − 1/r_f` per unit of difference. This is the weight of the feature; a feature that differs between
//! corresponding points as between any two has weight 0. The rule is that of record linkage (Fellegi, Sunter), which
//! also learns the distributions without known pairs, by expectation and maximization over the label of each variable.
//!
//! A feature that chooses the pairs on which it is judged looks precise: noise picks the labels that happen to agree
//! with it. A feature that has no say looks as imprecise as the others are. A feature therefore counts half where it is
//! judged itself. With three or more groups all features of its group count half too, because they share their errors,
//! like the components of one descriptor. On synthetic features of known noise, half was right. With full weight, noise
//! could win over two features beside it; with none, precise features were not told from noisy ones.
//!
//! Sources: Fellegi, Sunter, "A theory for record linkage", JASA 64, 1969; Dempster, Laird, Rubin 1977.

use super::Feature;
use rayon::prelude::*;

/// Steps of expectation and maximization.
const STEPS: usize = 10;
/// Initial mean difference of corresponding points, as a share of the mean difference of any two.
const FIRST: f64 = 0.2;
/// Weight of a feature where it is judged itself.
const OWN_SAY: f64 = 0.5;
/// Largest number of variables considered, evenly spread over their numbers.
const MOST_VARIABLES: usize = 400;
/// Least mean difference of corresponding points, as a share of the mean difference of any two: a feature of rational
/// numbers may agree exactly.
const LEAST: f64 = 0.02;
/// Number of features beyond which weights count in the probabilities as if only this many were independent: features
/// of several scales or of one descriptor are not independent.
const INDEPENDENT: f64 = 6.0;

/// Weights of `features` for [`unary_potentials`](super::unary_potentials): the product of each feature's own weight
/// and the learned one, scaled to the sum of the own weights. `groups` has the group number of each feature, `cap` is
/// `τ`. Returns the own weights if no feature is informative.
///
/// # Cost
/// `O(variables · labels · features)` per step, for ten steps with at most 400 variables, on all threads; any number of
/// threads gives the same bits.
pub fn learned_weights(features: &[Feature], groups: &[usize], cap: f64) -> Vec<f64> {
    let own: Vec<f64> = features.iter().map(|f| f.weight).collect();
    let random = differences(features, cap);
    let mut mean: Vec<f64> = random.iter().map(|r| FIRST * r).collect();
    let mut weights = own.clone();
    for _ in 0..STEPS {
        let slopes: Vec<f64> = mean.iter().zip(&random).map(|(b, r)| slope(*b, *r)).collect();
        let total: f64 = own.iter().zip(&slopes).map(|(w, s)| w * s).sum();
        if !(total.is_finite() && total > 0.0) {
            return own;
        }
        let sum: f64 = own.iter().sum();
        weights = own.iter().zip(&slopes).map(|(w, s)| w * s * sum / total).collect();
        mean = expected(features, groups, &slopes, cap, &random);
    }
    weights
}

/// `1/b − 1/r`, or 0 where the feature is uninformative.
fn slope(b: f64, r: f64) -> f64 {
    if r > 0.0 { (1.0 / b.max(LEAST * r) - 1.0 / r).max(0.0) } else { 0.0 }
}

/// Values of a feature in units of its scale at the considered variables, and at all labels.
fn scaled(feature: &Feature) -> (Vec<f64>, Vec<f64>) {
    let scale = feature.robust_scale();
    let step = feature.source.len().div_ceil(MOST_VARIABLES).max(1);
    (
        feature.source.iter().step_by(step).map(|v| v / scale).collect(),
        feature.target.iter().map(|v| v / scale).collect(),
    )
}

/// Mean capped difference of each feature between any variable and any label.
fn differences(features: &[Feature], cap: f64) -> Vec<f64> {
    let of = |feature: &Feature| {
        let (source, target) = scaled(feature);
        let sum: f64 = source.iter().map(|a| target.iter().map(|b| (a - b).abs().min(cap)).sum::<f64>()).sum();
        sum / (source.len() * target.len()).max(1) as f64
    };
    features.par_iter().map(of).collect()
}

/// Mean capped difference of each feature under the label probabilities from all features, with the judged feature at
/// half weight.
fn expected(features: &[Feature], groups: &[usize], slopes: &[f64], cap: f64, random: &[f64]) -> Vec<f64> {
    let values: Vec<_> = features.iter().map(scaled).collect();
    let (n, m) = values.first().map_or((0, 0), |(source, target)| (source.len(), target.len()));
    let n_groups = groups.iter().collect::<std::collections::BTreeSet<_>>().len();
    // Features that are judged together: those of a group, or each alone.
    let judged: Vec<usize> = if n_groups >= 3 { groups.to_vec() } else { (0..features.len()).collect() };
    let kinds: std::collections::BTreeSet<usize> = judged.iter().copied().collect();
    let exponent = (INDEPENDENT / slopes.iter().filter(|s| **s > 0.0).count().max(1) as f64).min(1.0);
    let rows: Vec<Vec<f64>> = (0..n)
        .into_par_iter()
        .map(|i| {
            // A row of differences for each feature.
            let differences: Vec<Vec<f64>> = values
                .iter()
                .map(|(source, target)| target.iter().map(|value| (value - source[i]).abs().min(cap)).collect())
                .collect();
            let add = |sums: &mut [f64], f: usize, slope: f64| {
                sums.iter_mut().zip(&differences[f]).for_each(|(sum, d)| *sum += slope * d);
            };
            let mut all = vec![0.0; m];
            slopes.iter().enumerate().for_each(|(f, slope)| add(&mut all, f, *slope));
            let mut row = vec![0.0; slopes.len()];
            for &kind in &kinds {
                let members: Vec<usize> = (0..slopes.len()).filter(|&f| judged[f] == kind).collect();
                let mut sums = all.clone();
                members.iter().for_each(|&f| add(&mut sums, f, -(1.0 - OWN_SAY) * slopes[f]));
                let least = sums.iter().copied().fold(f64::INFINITY, f64::min);
                sums.iter_mut().for_each(|sum| *sum = (-exponent * (*sum - least)).exp());
                let total: f64 = sums.iter().sum();
                for f in members {
                    row[f] = sums.iter().zip(&differences[f]).map(|(p, d)| p * d).sum::<f64>() / total;
                }
            }
            row
        })
        .collect();
    let mean = |f: usize| rows.iter().map(|row| row[f]).sum::<f64>() / n.max(1) as f64;
    (0..features.len()).map(|f| mean(f).min(random[f])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in `[−1, 1)` by a fixed rule.
    fn draw(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Features that are smooth functions of a place in the plane, with Laplace noise of these sizes (infinite: noise alone), at 300
    /// places of one surface and 350 others of a second.
    fn features(noise: &[f64], seed: u64) -> Vec<Feature> {
        let mut state = seed;
        let mut places = |n: usize| (0..n).map(|_| [draw(&mut state), draw(&mut state)]).collect::<Vec<_>>();
        let (source, target) = (places(300), places(350));
        let mut state = seed + 1;
        noise
            .iter()
            .enumerate()
            .map(|(k, size)| {
                let angle = 0.3 + 1.3 * k as f64;
                let mut value = |[u, v]: &[f64; 2]| {
                    let smooth = (2.5 * (u * angle.cos() + v * angle.sin()) + k as f64).sin();
                    let uniform = draw(&mut state);
                    let laplace = -uniform.signum() * (1.0 - uniform.abs()).ln();
                    if size.is_finite() { smooth + size * laplace } else { laplace }
                };
                let (source, target) =
                    (source.iter().map(&mut value).collect(), target.iter().map(&mut value).collect());
                Feature { weight: 1.0, source, target }
            })
            .collect()
    }

    #[test]
    fn a_feature_of_noise_gets_little_weight_and_precise_ones_most() {
        for seed in [3, 17, 40] {
            let found = learned_weights(&features(&[0.05, 0.05, 0.3, 0.05, f64::INFINITY], seed), &[0; 5], 3.0);
            assert!((found.iter().sum::<f64>() - 5.0).abs() < 1e-9, "{found:?}");
            for precise in [0, 1, 3] {
                assert!(found[precise] > 1.5 * found[2], "{found:?}");
            }
            assert!(found[4] < 0.1 && found[4] < 0.5 * found[2], "{found:?}");
        }
    }

    #[test]
    fn it_learns_about_what_the_true_pairs_would_teach() {
        // The second surface is the first, with noise of its own.
        let noise = [0.02, 0.05, 0.1, 0.2, 0.4];
        let mut state = 5;
        let mut all = features(&[0.0; 5], 9);
        let mut differences = Vec::new();
        for (feature, size) in all.iter_mut().zip(noise) {
            feature.target = feature.source.iter().map(|v| v + size * draw(&mut state)).collect();
            let scale = feature.robust_scale();
            let sum: f64 = feature.source.iter().zip(&feature.target).map(|(a, b)| (a - b).abs() / scale).sum();
            differences.push(sum / feature.source.len() as f64);
        }
        let random = super::differences(&all, 3.0);
        let slopes: Vec<f64> = differences.iter().zip(&random).map(|(b, r)| slope(*b, *r)).collect();
        let found = learned_weights(&all, &[0; 5], 3.0);
        let total: f64 = slopes.iter().sum();
        for (found, slope) in found.iter().zip(&slopes) {
            let expected = 5.0 * slope / total;
            assert!((found - expected).abs() < 0.3 * expected + 0.05, "{found} {expected}");
        }
    }

    #[test]
    fn three_groups_judge_each_other() {
        // Two copies of noise agree with each other, and with no other group.
        let mut all = features(&[0.05, 0.05, f64::INFINITY, 0.05, 0.05], 8);
        all.insert(3, all[2].clone());
        let found = learned_weights(&all, &[0, 0, 1, 1, 2, 3], 3.0);
        assert!(found[2] < 0.1 && found[3] < 0.1, "{found:?}");
    }

    #[test]
    fn features_that_tell_nothing_keep_their_weights() {
        let constant = Feature { weight: 2.0, source: vec![1.0; 5], target: vec![1.0; 4] };
        assert_eq!(learned_weights(&[constant.clone(), constant], &[0, 1], 3.0), [2.0, 2.0]);
        assert_eq!(learned_weights(&[], &[], 3.0), [0.0; 0]);
    }
}
