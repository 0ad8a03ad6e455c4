//! RANSAC: the rigid transform with the largest support among point pairs, most of which may be wrong.
//!
//! Source: Fischler, Bolles 1981; adaptive number of trials `ln(1−c)/ln(1−w³)`; local optimization on each new best
//! as in Chum, Matas, Kittler 2003 (LO-RANSAC).
//!
//! Trial `k` draws from its own generator, seeded by `(seed, k)`, and trials are evaluated in batches of fixed size.
//! The result therefore does not depend on the number of threads.

use super::{MinimalEstimator, OrientationSolver, RigidTransform, solve_orientation};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use nalgebra::Point3;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use rayon::prelude::*;

/// Trials between two evaluations of the stopping rule.
const BATCH: u64 = 512;
/// Largest number of least-squares fits over the support of a new best hypothesis; more gain nothing.
const LOCAL_STEPS: usize = 10;

/// Options of RANSAC.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RansacOptions {
    /// Largest residual of an inlier, mm.
    pub tolerance_mm: f64,
    /// Required probability that at least one trial drew only inliers, in `[0, 1)`.
    pub confidence: f64,
    /// Largest number of trials.
    pub max_trials: u64,
    /// Whether reflections are tried too.
    pub allow_reflection: bool,
    /// Seed of the draws.
    pub seed: u64,
}

/// Methods of estimating hypotheses and of fitting them to their support.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RansacMethods {
    /// Estimates a hypothesis from three pairs.
    pub estimator: MinimalEstimator,
    /// Fits the transform to the support of a new best hypothesis, and finally the result.
    pub solver: OrientationSolver,
}

/// The result of [`ransac()`].
#[derive(Debug, Clone, PartialEq)]
pub struct RansacReport {
    /// The transform, least squares over its support.
    pub target_from_source: RigidTransform,
    /// Which pairs are inliers of the transform.
    pub inlier_mask: Vec<bool>,
    /// Number of inliers.
    pub support: usize,
    /// Root mean square residual of the support, mm.
    pub rms_mm: f64,
    /// Number of trials.
    pub trials: u64,
    /// Whether the required confidence was reached within the largest number of trials.
    pub confidence_reached: bool,
}

/// Finds the transform with the largest support among the pairs `source[i] ↔ target[i]`, mm.
///
/// `None` if no trial had a support of three. Equals [`ransac_with`] with the default methods: frames and singular
/// value decomposition.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// `O(trials · n)`, on all threads; allocates `O(n)`.
pub fn ransac(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    options: &RansacOptions,
    observer: &dyn Observer,
) -> Result<Option<RansacReport>, Cancelled> {
    ransac_with(source, target, options, RansacMethods::default(), observer)
}

/// [`ransac()`] with a choice of the minimal estimator and of the solver of the local optimization. The draws, and
/// hence the triples, do not depend on the methods.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// The cost of [`ransac()`].
pub fn ransac_with(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    options: &RansacOptions,
    methods: RansacMethods,
    observer: &dyn Observer,
) -> Result<Option<RansacReport>, Cancelled> {
    search((source, target), None, options, methods, observer)
}

/// [`ransac()`] with triples whose pairs are drawn with probabilities in proportion to their weights: with beliefs as
/// weights a triple of inliers is found sooner. The support counts pairs. The number of trials is that of even draws,
/// an upper bound if heavy pairs are inliers more often.
///
/// `None` if fewer than three pairs have a positive weight, or if no trial had a support of three.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// The cost of [`ransac()`].
pub fn ransac_weighted(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    weights: &[f64],
    options: &RansacOptions,
    observer: &dyn Observer,
) -> Result<Option<RansacReport>, Cancelled> {
    let cumulative: Vec<f64> = weights
        .iter()
        .scan(0.0, |sum, weight| {
            *sum += weight.max(0.0);
            Some(*sum)
        })
        .collect();
    if !cumulative.last().is_some_and(|total| total.is_finite() && *total > 0.0) {
        return Ok(None);
    }
    search((source, target), Some(&cumulative), options, RansacMethods::default(), observer)
}

fn search(
    (source, target): (&[Point3<f64>], &[Point3<f64>]),
    cumulative_weights: Option<&[f64]>,
    options: &RansacOptions,
    methods: RansacMethods,
    observer: &dyn Observer,
) -> Result<Option<RansacReport>, Cancelled> {
    let n = source.len().min(target.len()).min(cumulative_weights.map_or(usize::MAX, <[f64]>::len));
    if n < 3 {
        return Ok(None);
    }
    let pairs = Pairs { source: &source[..n], target: &target[..n], cumulative_weights, options, methods };
    let mut best: Option<(usize, RigidTransform)> = None;
    let mut trials = 0;
    let mut needed = options.max_trials;
    while trials < needed.min(options.max_trials) {
        checkpoint(observer)?;
        let batch = trials..(trials + BATCH).min(options.max_trials);
        trials = batch.end;
        let found = batch
            .into_par_iter()
            .filter_map(|trial| pairs.evaluate(trial))
            // Largest support, then earliest trial: independent of the order of evaluation.
            .max_by(|a, b| a.0.cmp(&b.0).then(b.1.cmp(&a.1)));
        let Some((support, _, hypothesis)) = found else { continue };
        if best.as_ref().is_none_or(|(most, _)| support > *most) {
            let improved = pairs.optimize_locally(hypothesis);
            let support = pairs.support(&improved);
            if best.as_ref().is_none_or(|(most, _)| support > *most) {
                best = Some((support, improved));
            }
        }
        if let Some((support, _)) = best {
            needed = needed_trials(support as f64 / n as f64, options.confidence);
        }
    }
    let Some((support, target_from_source)) = best.filter(|(support, _)| *support >= 3) else { return Ok(None) };
    let inlier_mask: Vec<bool> = (0..n).map(|i| pairs.is_inlier(&target_from_source, i)).collect();
    let squares: f64 = (0..n).filter(|&i| inlier_mask[i]).map(|i| pairs.squared_residual(&target_from_source, i)).sum();
    Ok(Some(RansacReport {
        target_from_source,
        inlier_mask,
        support,
        rms_mm: (squares / support as f64).sqrt(),
        trials,
        confidence_reached: trials >= needed,
    }))
}

/// Number of trials such that one draws only inliers with probability `confidence`, if their share is `ratio`.
fn needed_trials(ratio: f64, confidence: f64) -> u64 {
    let all_inliers = ratio.powi(3);
    if all_inliers >= 1.0 {
        return 1;
    }
    // `ln_1p` stays accurate for a tiny share; a share of 0 gives infinity.
    let needed = (1.0 - confidence).ln() / (-all_inliers).ln_1p();
    // The cast saturates if more trials are needed than can be counted.
    needed.abs().ceil().max(1.0) as u64
}

struct Pairs<'a> {
    source: &'a [Point3<f64>],
    target: &'a [Point3<f64>],
    /// Cumulative sums of the weights of the pairs; `None` for even draws.
    cumulative_weights: Option<&'a [f64]>,
    options: &'a RansacOptions,
    methods: RansacMethods,
}

impl Pairs<'_> {
    /// Draws a triple, rejects it if its edge lengths disagree, and counts the support of its transform.
    fn evaluate(&self, trial: u64) -> Option<(usize, u64, RigidTransform)> {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(self.options.seed ^ trial.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let n = self.source.len();
        let mut draw = || match self.cumulative_weights {
            None => ((u128::from(rng.next_u64()) * n as u128) >> 64) as usize,
            Some(sums) => {
                let drawn = (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64 * sums[n - 1];
                sums[..n - 1].partition_point(|sum| *sum <= drawn)
            }
        };
        let triple = [draw(), draw(), draw()];
        if triple[0] == triple[1] || triple[0] == triple[2] || triple[1] == triple[2] {
            return None;
        }
        let (source, target) = (triple.map(|i| self.source[i]), triple.map(|i| self.target[i]));
        // Two inliers are each within the tolerance, so the lengths between them agree within twice the tolerance.
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let difference = (source[a] - source[b]).norm() - (target[a] - target[b]).norm();
            if difference.abs() > 2.0 * self.options.tolerance_mm {
                return None;
            }
        }
        let plain = self.methods.estimator.estimate(&source, &target, false).ok()?;
        let support = self.support(&plain);
        if self.options.allow_reflection {
            let mirrored = self.methods.estimator.estimate(&source, &target, true).ok()?;
            let mirrored_support = self.support(&mirrored);
            if mirrored_support > support {
                return Some((mirrored_support, trial, mirrored));
            }
        }
        Some((support, trial, plain))
    }

    fn squared_residual(&self, transform: &RigidTransform, i: usize) -> f64 {
        (transform.apply(&self.source[i]) - self.target[i]).norm_squared()
    }

    fn is_inlier(&self, transform: &RigidTransform, i: usize) -> bool {
        self.squared_residual(transform, i) <= self.options.tolerance_mm * self.options.tolerance_mm
    }

    fn support(&self, transform: &RigidTransform) -> usize {
        (0..self.source.len()).filter(|&i| self.is_inlier(transform, i)).count()
    }

    /// Repeats least squares over the support and then over the new support, while the support grows.
    fn optimize_locally(&self, start: RigidTransform) -> RigidTransform {
        let mut best = (self.support(&start), start);
        for _ in 0..LOCAL_STEPS {
            let inliers: Vec<usize> = (0..self.source.len()).filter(|&i| self.is_inlier(&best.1, i)).collect();
            let source: Vec<_> = inliers.iter().map(|&i| self.source[i]).collect();
            let target: Vec<_> = inliers.iter().map(|&i| self.target[i]).collect();
            // A reflection stays a reflection: the sign is that of the hypothesis.
            let mirrored = best.1.is_reflection();
            let Ok(fitted) = solve_orientation(self.methods.solver, &source, &target, None, mirrored) else { break };
            let support = self.support(&fitted);
            if support < best.0 || fitted.is_reflection() != mirrored {
                break;
            }
            let grown = support > best.0;
            best = (support, fitted);
            if !grown {
                break;
            }
        }
        best.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use homolog_primitives::observe::Silent;
    use proptest::prelude::*;

    fn options(seed: u64) -> RansacOptions {
        RansacOptions { tolerance_mm: 0.5, confidence: 0.999, max_trials: 100_000, allow_reflection: false, seed }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn the_motion_is_found_among_outliers(seed in any::<u64>(), outliers in 0usize..80) {
            let n = 100;
            let (source, truth, wrong) = (cloud(seed, n), pose(seed ^ 1), cloud(seed ^ 2, n));
            let target: Vec<_> =
                (0..n).map(|i| if i < outliers { wrong[i] } else { truth.apply(&source[i]) }).collect();
            let report = ransac(&source, &target, &options(seed), &Silent).unwrap().unwrap();
            prop_assert!(report.support >= n - outliers);
            prop_assert!((report.target_from_source.rotation - truth.rotation).norm() < 0.05);
            prop_assert_eq!(report.support, report.inlier_mask.iter().filter(|&&m| m).count());
        }
    }

    #[test]
    fn one_thread_and_many_give_the_same_bits() {
        let (source, truth, wrong) = (cloud(1, 300), pose(2), cloud(3, 300));
        let target: Vec<_> = (0..300).map(|i| if i % 3 > 0 { wrong[i] } else { truth.apply(&source[i]) }).collect();
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| ransac(&source, &target, &options(9), &Silent))
        };
        assert_eq!(with(1), with(4));
    }

    #[test]
    fn every_choice_of_methods_finds_the_same_inliers() {
        let (source, truth, wrong) = (cloud(1, 200), pose(2), cloud(3, 200));
        let target: Vec<_> = (0..200).map(|i| if i % 3 > 0 { wrong[i] } else { truth.apply(&source[i]) }).collect();
        let plain = ransac(&source, &target, &options(9), &Silent).unwrap().unwrap();
        for estimator in [MinimalEstimator::Frame, MinimalEstimator::RotationAxis] {
            for solver in OrientationSolver::ALL {
                let methods = RansacMethods { estimator, solver };
                let found = ransac_with(&source, &target, &options(9), methods, &Silent).unwrap().unwrap();
                assert_eq!(found.inlier_mask, plain.inlier_mask, "{methods:?}");
                let apart = (found.target_from_source.rotation - plain.target_from_source.rotation).norm();
                assert!(apart < 1e-9, "{methods:?}: {apart}");
            }
        }
    }

    #[test]
    fn pairs_without_weight_are_never_drawn_and_count_for_the_support() {
        let (source, truth, wrong) = (cloud(1, 200), pose(2), cloud(3, 200));
        let target: Vec<_> = (0..200).map(|i| if i < 100 { truth.apply(&source[i]) } else { wrong[i] }).collect();
        let weights: Vec<f64> = (0..200).map(|i| f64::from(u8::from((80..100).contains(&i)))).collect();
        let report = ransac_weighted(&source, &target, &weights, &options(9), &Silent).unwrap().unwrap();
        assert!(report.support >= 100 && report.inlier_mask[..100].iter().all(|&inlier| inlier));
        // Wrong pairs alone: nothing that many pairs agree with.
        let weights: Vec<f64> = weights.iter().rev().copied().collect();
        let report = ransac_weighted(&source, &target, &weights, &options(9), &Silent).unwrap();
        assert!(report.is_none_or(|report| report.support < 50));
        assert_eq!(ransac_weighted(&source, &target, &[0.0; 200], &options(9), &Silent).unwrap(), None);
    }

    #[test]
    fn trials_follow_the_formula() {
        assert_eq!(needed_trials(1.0, 0.999), 1);
        assert_eq!(needed_trials(0.5, 0.999), 52);
        assert_eq!(needed_trials(1e-9, 0.999), u64::MAX);
        assert_eq!(needed_trials(0.0, 0.999), u64::MAX);
    }

    #[test]
    fn a_mirrored_copy_is_found_if_reflections_are_allowed() {
        let source = cloud(4, 50);
        let target: Vec<_> = source.iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
        let report = ransac(&source, &target, &RansacOptions { allow_reflection: true, ..options(1) }, &Silent)
            .unwrap()
            .unwrap();
        assert!(report.target_from_source.is_reflection());
        assert_eq!(report.support, 50);
    }
}
