//! Absolute orientation: the rigid transform that best fits weighted point pairs.
//!
//! This file holds the parts shared by all solvers, which are the means and the covariance of the pairs ([`Moments`])
//! and the errors, and the solver by singular value decomposition. `orientation_solvers` has the other solvers.
//!
//! Source: Arun, Huang, Blostein 1987 (singular value decomposition); Umeyama, IEEE PAMI 13(4), 1991 (the sign that
//! keeps `det R = +1` also where the data prefer a reflection).

use super::RigidTransform;
use nalgebra::{Matrix3, Point3, Vector3};

/// Ratio of the second to the first singular value below which pairs count as collinear: the rotation about their line
/// is undetermined. Far above rounding (1e-16), far below any anatomical surface (about 1e-2).
pub(super) const COLLINEAR_RTOL: f64 = 1e-9;

/// Reasons why no transform can be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum OrientationError {
    /// The point lists differ in length.
    #[error("{n_source} source points, {n_target} target points, {n_weights} weights: the numbers must be equal")]
    LengthMismatch {
        /// Source points.
        n_source: usize,
        /// Target points.
        n_target: usize,
        /// Weights.
        n_weights: usize,
    },
    /// Fewer than three pairs.
    #[error("{n} pairs, at least 3 are needed")]
    TooFewPairs {
        /// Pairs given.
        n: usize,
    },
    /// A coordinate or weight is not finite, a weight is negative, or all are 0.
    #[error("a coordinate or weight is not finite, or the weights are negative or sum to 0")]
    NonFinite,
    /// The points lie on a line or coincide.
    #[error("the points lie on a line: the rotation about it is undetermined")]
    Degenerate,
}

/// Rigid transform that minimizes `Σ wᵢ‖R·sᵢ + t − dᵢ‖²`.
///
/// `source`, `target`: `n ≥ 3` paired points, mm, pair `i` at index `i`; `weights`: `n` values `≥ 0`, sum `> 0`, or
/// `None` for equal ones. Returns `target_from_source` with `det R = +1`, also when the data prefer a reflection,
/// unless `allow_reflection`.
///
/// # Errors
/// `LengthMismatch`; `TooFewPairs`; `NonFinite`; `Degenerate` if the pairs are collinear.
///
/// # Cost
/// `O(n)`, no allocation; the same input order gives the same bits.
pub fn absolute_orientation(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    weights: Option<&[f64]>,
    allow_reflection: bool,
) -> Result<RigidTransform, OrientationError> {
    let moments = Moments::of(source, target, weights)?;
    Ok(moments.transform(svd_rotation(&moments.covariance, allow_reflection)?))
}

/// Like [`absolute_orientation`] with known handedness: the best of the transforms that mirror if `mirrored`, otherwise
/// the best of those that do not.
///
/// A transform of the wrong handedness can fit a bent surface better, although nothing mirrors it: for example a flat
/// surface whose limbs turn to its other side.
/// to its other side.
///
/// # Errors
/// The errors of [`absolute_orientation`].
pub fn absolute_orientation_of(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    weights: Option<&[f64]>,
    mirrored: bool,
) -> Result<RigidTransform, OrientationError> {
    let moments = Moments::of(source, target, weights)?;
    let handedness = if mirrored { Handedness::Mirrored } else { Handedness::Kept };
    Ok(moments.transform(nearest_orthogonal(&moments.covariance, handedness)?))
}

/// Weighted means and second moments of point pairs.
pub(super) struct Moments {
    pub source_mean: Vector3<f64>,
    pub target_mean: Vector3<f64>,
    /// `Σ wᵢ d'ᵢ s'ᵢᵀ` of the centered points, mm².
    pub covariance: Matrix3<f64>,
    /// `Σ wᵢ ‖s'ᵢ‖²`, mm².
    pub source_spread: f64,
    /// `Σ wᵢ`.
    pub total_weight: f64,
}

impl Moments {
    /// Checks the lengths, the number of pairs and the values, then sums in the order of the pairs.
    pub(crate) fn of(
        source: &[Point3<f64>],
        target: &[Point3<f64>],
        weights: Option<&[f64]>,
    ) -> Result<Self, OrientationError> {
        let n = source.len();
        let n_weights = weights.map_or(n, <[f64]>::len);
        if target.len() != n || n_weights != n {
            return Err(OrientationError::LengthMismatch { n_source: n, n_target: target.len(), n_weights });
        }
        if n < 3 {
            return Err(OrientationError::TooFewPairs { n });
        }
        let weight = |i: usize| weights.map_or(1.0, |w| w[i]);
        let mut total_weight = 0.0;
        let (mut source_mean, mut target_mean) = (Vector3::zeros(), Vector3::zeros());
        let mut negative = false;
        for i in 0..n {
            let w = weight(i);
            negative |= w < 0.0;
            total_weight += w;
            source_mean += w * source[i].coords;
            target_mean += w * target[i].coords;
        }
        let sums_are_finite = source_mean.iter().chain(&target_mean).all(|c| c.is_finite());
        if negative || !(total_weight > 0.0 && total_weight.is_finite()) || !sums_are_finite {
            return Err(OrientationError::NonFinite);
        }
        source_mean /= total_weight;
        target_mean /= total_weight;
        let mut covariance = Matrix3::zeros();
        let mut source_spread = 0.0;
        for i in 0..n {
            let (s, d) = (source[i].coords - source_mean, target[i].coords - target_mean);
            covariance += weight(i) * d * s.transpose();
            source_spread += weight(i) * s.norm_squared();
        }
        // Squares of finite coordinates can overflow, and no decomposition terminates on infinities.
        if !(covariance.iter().all(|c| c.is_finite()) && source_spread.is_finite()) {
            return Err(OrientationError::NonFinite);
        }
        Ok(Moments { source_mean, target_mean, covariance, source_spread, total_weight })
    }

    /// The transform with rotation `R` that maps the mean of the source to the mean of the target.
    pub(crate) fn transform(&self, rotation: Matrix3<f64>) -> RigidTransform {
        RigidTransform { rotation, translation: self.target_mean - rotation * self.source_mean }
    }
}

/// Set of orthogonal matrices to search.
enum Handedness {
    /// Rotations.
    Kept,
    /// Reflections.
    Mirrored,
    /// Rotations and reflections.
    Any,
}

/// The orthogonal `R` with the largest `tr(Rᵀ C)`, `det R = +1` unless a reflection is allowed and fits better.
pub(super) fn svd_rotation(
    covariance: &Matrix3<f64>,
    allow_reflection: bool,
) -> Result<Matrix3<f64>, OrientationError> {
    nearest_orthogonal(covariance, if allow_reflection { Handedness::Any } else { Handedness::Kept })
}

fn nearest_orthogonal(covariance: &Matrix3<f64>, handedness: Handedness) -> Result<Matrix3<f64>, OrientationError> {
    let svd = covariance.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return Err(OrientationError::Degenerate) };
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
    let [first, second, last] = order;
    if svd.singular_values[second] <= COLLINEAR_RTOL * svd.singular_values[first] || svd.singular_values[first] == 0.0 {
        return Err(OrientationError::Degenerate);
    }
    let mut signs = Vector3::repeat(1.0);
    let planar = svd.singular_values[last] <= COLLINEAR_RTOL * svd.singular_values[first];
    let fits_mirrored = (u * v_t).determinant() < 0.0;
    let mirrored = match handedness {
        Handedness::Kept => false,
        Handedness::Mirrored => true,
        // In a plane a rotation fits as well as its mirror image; the rotation is chosen.
        Handedness::Any => fits_mirrored && !planar,
    };
    if mirrored != fits_mirrored {
        signs[last] = -1.0;
    }
    Ok(u * Matrix3::from_diagonal(&signs) * v_t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_moved_cloud_gives_its_motion(seed in any::<u64>(), n in 3usize..40) {
            let (points, truth) = (cloud(seed, n), pose(seed ^ 1));
            // Three random points can lie close to a line; the rotation about it is lost in rounding.
            let widest = (points[1] - points[0]).cross(&(points[2] - points[0])).norm();
            prop_assume!(n > 5 || widest > 20.0);
            let moved: Vec<_> = points.iter().map(|p| truth.apply(p)).collect();
            let found = absolute_orientation(&points, &moved, None, false).unwrap();
            prop_assert!((found.rotation - truth.rotation).norm() < 1e-9);
            prop_assert!((found.translation - truth.translation).norm() < 1e-7);
        }

        #[test]
        fn moving_the_source_first_is_undone(seed in any::<u64>(), n in 4usize..40) {
            let (source, target, motion) = (cloud(seed, n), cloud(seed ^ 7, n), pose(seed ^ 3));
            let moved: Vec<_> = source.iter().map(|p| motion.apply(p)).collect();
            let plain = absolute_orientation(&source, &target, None, false).unwrap();
            let after_motion = absolute_orientation(&moved, &target, None, false).unwrap();
            let expected = plain.after(&motion.inverse());
            // Unrelated clouds can be nearly ambiguous, so the test compares residuals.
            let cost = |t: &RigidTransform| -> f64 {
                moved.iter().zip(&target).map(|(s, d)| (t.apply(s) - d).norm_squared()).sum()
            };
            prop_assert!((cost(&expected) - cost(&after_motion)).abs() < 1e-9 * cost(&expected));
        }

        #[test]
        fn no_other_rotation_near_by_fits_better(seed in any::<u64>(), n in 3usize..20) {
            let (source, target) = (cloud(seed, n), cloud(seed ^ 7, n));
            let best = absolute_orientation(&source, &target, None, false).unwrap();
            prop_assert!((best.rotation.determinant() - 1.0).abs() < 1e-9);
            let cost = |t: &RigidTransform| -> f64 {
                source.iter().zip(&target).map(|(s, d)| (t.apply(s) - d).norm_squared()).sum()
            };
            for k in 0..8 {
                let mut nudge = pose(seed ^ (100 + k));
                let axis = nudge.quaternion().scaled_axis() * 1e-3;
                nudge.rotation = *nalgebra::Rotation3::new(axis).matrix();
                nudge.translation *= 1e-4;
                prop_assert!(cost(&nudge.after(&best)) >= cost(&best) * (1.0 - 1e-12));
            }
        }
    }

    #[test]
    fn a_reflection_is_fitted_only_if_allowed() {
        let points = cloud(5, 20);
        let mirrored: Vec<_> = points.iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
        assert!(absolute_orientation(&points, &mirrored, None, true).unwrap().is_reflection());
        assert!(!absolute_orientation(&points, &mirrored, None, false).unwrap().is_reflection());
    }

    #[test]
    fn the_handedness_that_is_known_is_kept_whatever_fits_better() {
        let points = cloud(5, 20);
        let images = |x: f64| points.iter().map(|p| Point3::new(x * p.x, p.y, p.z)).collect::<Vec<_>>();
        for (fits, other) in [(images(1.0), false), (images(-1.0), true)].map(|(images, mirrored)| {
            let fitted = |mirrored| absolute_orientation_of(&points, &images, None, mirrored).unwrap();
            assert_eq!([false, true].map(|m| fitted(m).is_reflection()), [false, true]);
            assert_eq!(fitted(mirrored), absolute_orientation(&points, &images, None, true).unwrap());
            let cost = |t: RigidTransform| -> f64 {
                points.iter().zip(&images).map(|(s, d)| (t.apply(s) - d).norm_squared()).sum()
            };
            (cost(fitted(mirrored)), cost(fitted(!mirrored)))
        }) {
            assert!(fits < 1e-18 && other > 1.0, "{fits} {other}");
        }
    }

    #[test]
    fn invalid_pairs_are_rejected_with_their_fault() {
        let line: Vec<_> = (0..5).map(|k| Point3::new(f64::from(k), 2.0 * f64::from(k), 0.0)).collect();
        assert_eq!(absolute_orientation(&line, &line, None, false), Err(OrientationError::Degenerate));
        assert_eq!(
            absolute_orientation(&line[..2], &line[..2], None, false),
            Err(OrientationError::TooFewPairs { n: 2 })
        );
        let mut broken = cloud(1, 5);
        broken[2].x = f64::NAN;
        assert_eq!(absolute_orientation(&broken, &cloud(2, 5), None, false), Err(OrientationError::NonFinite));
    }
}
