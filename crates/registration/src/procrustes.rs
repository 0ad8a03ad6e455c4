//! Procrustes analysis of given pairs: the baseline that knows the correspondence.
//!
//! Source: Gower 1975 (the problem); Umeyama, IEEE PAMI 13(4), 1991 (the scale in closed form, for a rotation kept
//! proper too).

use super::absolute_orientation::{Moments, OrientationError};
use super::{OrientationSolver, SimilarityTransform};
use nalgebra::Point3;

/// What is fitted to the pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ProcrustesOptions {
    /// How the rotation is found.
    pub solver: OrientationSolver,
    /// Whether a uniform scale is fitted too; otherwise it is 1.
    pub with_scale: bool,
    /// Whether the fit may mirror, as from left to right structures.
    pub allow_reflection: bool,
}

/// A fit and its residuals `‖s R pᵢ + t − qᵢ‖`, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProcrustesReport {
    /// The fitted transform.
    pub target_from_source: SimilarityTransform,
    /// Pairs of positive weight, the only ones that the residuals below are of.
    pub n_pairs: usize,
    /// Weighted root mean square residual, mm: what was minimised.
    pub rms_mm: f64,
    /// Weighted mean residual, mm.
    pub mean_mm: f64,
    /// Median residual, mm, without weights.
    pub median_mm: f64,
    /// 95th percentile of the residuals, mm, without weights.
    pub p95_mm: f64,
    /// Largest residual, mm.
    pub max_mm: f64,
}

/// The similarity that minimizes `Σ wᵢ‖s R pᵢ + t − qᵢ‖²`, with `s = 1` unless a scale is asked for.
///
/// `source` (`pᵢ`), `target` (`qᵢ`): `n ≥ 3` paired points, mm, pair `i` at index `i`; `weights`: `n` values `≥ 0`, sum
/// `> 0`, or `None` for equal ones. The scale is that of the source's errors against the target; the fit the other way
/// round has not quite the inverse scale unless the pairs fit exactly.
///
/// # Errors
/// [`OrientationError`], the same one for every solver.
///
/// # Cost
/// `O(n log n)` for the percentiles, else `O(n)`; the same order of pairs gives the same bits.
pub fn procrustes(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    weights: Option<&[f64]>,
    options: &ProcrustesOptions,
) -> Result<ProcrustesReport, OrientationError> {
    let moments = Moments::of(source, target, weights)?;
    let rotation = options.solver.rotation(&moments.covariance, options.allow_reflection)?;
    // The trace is positive: the rotation maximizes it, and a covariance of rank two or three has one above zero.
    let scale = if options.with_scale {
        (rotation.transpose() * moments.covariance).trace() / moments.source_spread
    } else {
        1.0
    };
    let translation = moments.target_mean - scale * (rotation * moments.source_mean);
    let target_from_source = SimilarityTransform { scale, rotation, translation };
    let (mut squares, mut sum) = (0.0, 0.0);
    let mut residuals = Vec::with_capacity(source.len());
    for i in 0..source.len() {
        let weight = weights.map_or(1.0, |w| w[i]);
        if weight > 0.0 {
            let residual = (target_from_source.apply(&source[i]) - target[i]).norm();
            squares += weight * residual * residual;
            sum += weight * residual;
            residuals.push(residual);
        }
    }
    residuals.sort_by(f64::total_cmp);
    let at = |share: f64| residuals[((residuals.len() - 1) as f64 * share).round() as usize];
    Ok(ProcrustesReport {
        target_from_source,
        n_pairs: residuals.len(),
        rms_mm: (squares / moments.total_weight).sqrt(),
        mean_mm: sum / moments.total_weight,
        median_mm: at(0.5),
        p95_mm: at(0.95),
        max_mm: at(1.0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use proptest::prelude::*;

    fn rms(transform: &SimilarityTransform, source: &[Point3<f64>], target: &[Point3<f64>]) -> f64 {
        let squares: f64 = source.iter().zip(target).map(|(p, q)| (transform.apply(p) - q).norm_squared()).sum();
        (squares / source.len() as f64).sqrt()
    }

    proptest! {
        #[test]
        fn an_exact_similarity_is_found_by_every_solver(seed in any::<u64>(), n in 6usize..40, scale in 0.3f64..3.0) {
            let truth = SimilarityTransform { scale, ..pose(seed ^ 1).into() };
            let source = cloud(seed, n);
            let target: Vec<_> = source.iter().map(|p| truth.apply(p)).collect();
            for solver in OrientationSolver::ALL {
                let options = ProcrustesOptions { solver, with_scale: true, allow_reflection: false };
                let found = procrustes(&source, &target, None, &options).unwrap();
                prop_assert!((found.target_from_source.scale / scale - 1.0).abs() < 1e-9);
                prop_assert!((found.target_from_source.rotation - truth.rotation).norm() < 1e-9);
                prop_assert!(found.max_mm < 1e-7 && found.n_pairs == n);
                // Without a scale the rotation is the same, because the covariance is.
                let rigid = procrustes(&source, &target, None, &ProcrustesOptions { with_scale: false, ..options });
                let rigid = rigid.unwrap().target_from_source;
                prop_assert!(rigid.scale == 1.0 && (rigid.rotation - truth.rotation).norm() < 1e-9);
            }
        }

        #[test]
        fn no_scale_near_by_fits_better(seed in any::<u64>(), n in 4usize..40) {
            let (source, target) = (cloud(seed, n), cloud(seed ^ 7, n));
            let options = ProcrustesOptions { with_scale: true, ..ProcrustesOptions::default() };
            let found = procrustes(&source, &target, None, &options).unwrap();
            let best = found.target_from_source;
            prop_assert!((rms(&best, &source, &target) - found.rms_mm).abs() < 1e-9);
            let center = nalgebra::Point3::from(source.iter().fold(nalgebra::Vector3::zeros(), |s, p| s + p.coords) / n as f64);
            for factor in [0.999, 1.001] {
                let mut other = best;
                other.scale *= factor;
                // About the centroids, where the best translation is.
                other.translation += best.apply(&center) - other.apply(&center);
                prop_assert!(rms(&other, &source, &target) >= found.rms_mm * (1.0 - 1e-12));
            }
        }
    }

    #[test]
    fn pairs_without_weight_do_not_count() {
        let (source, truth) = (cloud(3, 20), pose(4));
        let mut target: Vec<_> = source.iter().map(|p| truth.apply(p)).collect();
        target[5].x += 100.0;
        let mut weights = vec![1.0; 20];
        weights[5] = 0.0;
        let found = procrustes(&source, &target, Some(&weights), &ProcrustesOptions::default()).unwrap();
        assert!(found.n_pairs == 19 && found.max_mm < 1e-9 && found.rms_mm < 1e-9);
        let all = procrustes(&source, &target, None, &ProcrustesOptions::default()).unwrap();
        assert!(all.max_mm > 50.0 && all.median_mm < all.p95_mm && all.p95_mm <= all.max_mm);
    }

    #[test]
    fn a_mirrored_copy_is_mirrored_only_on_request() {
        let source = cloud(8, 30);
        let target: Vec<_> = source.iter().map(|p| Point3::new(3.0 - p.x, p.y, p.z)).collect();
        for solver in OrientationSolver::ALL {
            let plain = ProcrustesOptions { solver, ..ProcrustesOptions::default() };
            let proper = procrustes(&source, &target, None, &plain).unwrap();
            assert!(proper.target_from_source.rotation.determinant() > 0.0 && proper.rms_mm > 1.0);
            let mirrored = ProcrustesOptions { allow_reflection: true, ..plain };
            assert!(procrustes(&source, &target, None, &mirrored).unwrap().rms_mm < 1e-9);
        }
    }
}
