//! Procrustes analysis: the similarity or rigid transform of given pairs.
//!
//! Source: Gower 1975 (the problem); Umeyama, IEEE PAMI 13(4), 1991 (the scale in closed form, also for a rotation that
//! is kept proper).

use super::absolute_orientation::{Moments, OrientationError};
use super::{OrientationSolver, SimilarityTransform};
use nalgebra::Point3;

/// Options of [`procrustes`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ProcrustesOptions {
    /// Solver of the rotation.
    pub solver: OrientationSolver,
    /// Whether to fit a uniform scale too; otherwise it is 1.
    pub with_scale: bool,
    /// Whether the fit may be a reflection, as between left and right structures.
    pub allow_reflection: bool,
}

/// The result of [`procrustes`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProcrustesReport {
    /// The fitted transform.
    pub target_from_source: SimilarityTransform,
    /// Weighted root mean square of the residuals `‖s R pᵢ + t − qᵢ‖`, mm.
    pub rms_mm: f64,
}

/// The similarity that minimizes `Σ wᵢ‖s R pᵢ + t − qᵢ‖²`, with `s = 1` unless `options.with_scale`.
///
/// `source` (`pᵢ`), `target` (`qᵢ`): `n ≥ 3` paired points, mm, pair `i` at index `i`; `weights`: `n` values `≥ 0`, sum
/// `> 0`, or `None` for equal ones. All residuals are on the target; a fit in the other direction has exactly the
/// inverse scale only if the pairs fit exactly.
///
/// # Errors
/// [`OrientationError`], the same for every solver.
///
/// # Cost
/// `O(n)`; the same order of pairs gives the same bits.
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
    let mut squares = 0.0;
    for i in 0..source.len() {
        let residual = (target_from_source.apply(&source[i]) - target[i]).norm();
        squares += weights.map_or(1.0, |w| w[i]) * residual * residual;
    }
    Ok(ProcrustesReport { target_from_source, rms_mm: (squares / moments.total_weight).sqrt() })
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
            let rigid = pose(seed ^ 1);
            let truth = SimilarityTransform { scale, rotation: rigid.rotation, translation: rigid.translation };
            let source = cloud(seed, n);
            let target: Vec<_> = source.iter().map(|p| truth.apply(p)).collect();
            for solver in OrientationSolver::ALL {
                let options = ProcrustesOptions { solver, with_scale: true, allow_reflection: false };
                let found = procrustes(&source, &target, None, &options).unwrap();
                prop_assert!((found.target_from_source.scale / scale - 1.0).abs() < 1e-9);
                prop_assert!((found.target_from_source.rotation - truth.rotation).norm() < 1e-9);
                prop_assert!(found.rms_mm < 1e-7);
                // Without a scale the rotation is the same, because the covariance is the same.
                let rigid = procrustes(&source, &target, None, &ProcrustesOptions { with_scale: false, ..options });
                let rigid = rigid.unwrap().target_from_source;
                prop_assert!(rigid.scale == 1.0 && (rigid.rotation - truth.rotation).norm() < 1e-9);
            }
        }

        #[test]
        fn no_slightly_different_scale_fits_better(seed in any::<u64>(), n in 4usize..40) {
            let (source, target) = (cloud(seed, n), cloud(seed ^ 7, n));
            let options = ProcrustesOptions { with_scale: true, ..ProcrustesOptions::default() };
            let found = procrustes(&source, &target, None, &options).unwrap();
            let best = found.target_from_source;
            prop_assert!((rms(&best, &source, &target) - found.rms_mm).abs() < 1e-9);
            let center = nalgebra::Point3::from(source.iter().fold(nalgebra::Vector3::zeros(), |s, p| s + p.coords) / n as f64);
            for factor in [0.999, 1.001] {
                let mut other = best;
                other.scale *= factor;
                // About the centroids, where the best translation lies.
                other.translation += best.apply(&center) - other.apply(&center);
                prop_assert!(rms(&other, &source, &target) >= found.rms_mm * (1.0 - 1e-12));
            }
        }
    }

    #[test]
    fn pairs_of_weight_0_are_ignored() {
        let (source, truth) = (cloud(3, 20), pose(4));
        let mut target: Vec<_> = source.iter().map(|p| truth.apply(p)).collect();
        target[5].x += 100.0;
        let mut weights = vec![1.0; 20];
        weights[5] = 0.0;
        let found = procrustes(&source, &target, Some(&weights), &ProcrustesOptions::default()).unwrap();
        assert!(found.rms_mm < 1e-9);
        let all = procrustes(&source, &target, None, &ProcrustesOptions::default()).unwrap();
        assert!(all.rms_mm > 10.0);
    }

    #[test]
    fn a_reflection_is_fitted_only_if_allowed() {
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
