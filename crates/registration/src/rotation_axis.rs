//! A rigid transform from three point pairs by the axis of its rotation.
//!
//! A rotation `R` maps a centered point `a` to `R a`; its displacement `(R − I) a` is perpendicular to the axis, which
//! `R` leaves fixed. Two displacements that are not parallel therefore determine the axis, and the motion of the points
//! in the plane perpendicular to it determines the angle.
//!
//! The displacements of a triangle are parallel if its plane contains the axis, and zero if there is no rotation. The
//! same `R` rotates the normal of the triangle, and the displacement of the normal is perpendicular to the axis too: it
//! replaces a parallel one, for every angle up to 180°. If it is zero as well, the motion is a translation.
//!
//! Source: the thesis, section 3.4.2 ("critical points", the points that a motion leaves fixed); the formulation by
//! displacements and the use of the normal are original.

use super::triple::triangle_normal;
use super::{RigidTransform, TripleError};
use nalgebra::{Matrix3, Point3, Rotation3, Unit, Vector3};

/// Displacements below this share of the size of the triangle count as rounding: the rotation is the identity.
const STILL_RTOL: f64 = 1e-13;

/// The transform whose axis is perpendicular to the displacements of the centered triples, whose angle is the
/// least-squares angle about that axis, and which maps centroid to centroid; exact for congruent triangles. With
/// `mirrored`, the rotation is followed by the reflection in the plane of the target triple, so `det R = −1`.
///
/// # Errors
/// [`TripleError::Collinear`].
pub(super) fn rotation_axis_estimate(
    source: &[Point3<f64>; 3],
    target: &[Point3<f64>; 3],
    mirrored: bool,
) -> Result<RigidTransform, TripleError> {
    let source_normal = triangle_normal(source)?.normalize();
    let target_normal = triangle_normal(target)?.normalize();
    let (source_mean, from) = centered(source);
    let (target_mean, to) = centered(target);
    // In mm like the others, so that the displacement of the normal weighs as much as the displacement of a corner.
    let size = from.iter().map(Vector3::norm_squared).sum::<f64>().sqrt();
    let normal_displacement = (target_normal - source_normal) * size;
    let displacements = [to[0] - from[0], to[1] - from[1], to[2] - from[2], normal_displacement];
    let mut rotation = match widest_cross_product(&displacements, STILL_RTOL * size) {
        None => Matrix3::identity(),
        Some(axis) => *Rotation3::from_axis_angle(&axis, angle_about(&axis, &from, &to)).matrix(),
    };
    if mirrored {
        rotation = (Matrix3::identity() - 2.0 * target_normal * target_normal.transpose()) * rotation;
    }
    Ok(RigidTransform { rotation, translation: target_mean - rotation * source_mean })
}

fn centered(p: &[Point3<f64>; 3]) -> (Vector3<f64>, [Vector3<f64>; 3]) {
    let mean = (p[0].coords + p[1].coords + p[2].coords) / 3.0;
    (mean, p.map(|p| p.coords - mean))
}

/// Direction of the longest cross product of two of the displacements; `None` if all are shorter than `still`.
fn widest_cross_product(displacements: &[Vector3<f64>; 4], still: f64) -> Option<Unit<Vector3<f64>>> {
    if displacements.iter().all(|d| d.norm() <= still) {
        return None;
    }
    // The three displacements of the corners sum to zero, so any two of them have the same cross product.
    let [a, b, c, normal] = displacements;
    let products = [a.cross(b), a.cross(normal), b.cross(normal), c.cross(normal)];
    let longest = products
        .into_iter()
        .fold(Vector3::zeros(), |long: Vector3<f64>, p| if p.norm_squared() > long.norm_squared() { p } else { long });
    Unit::try_new(longest, 0.0)
}

/// The angle about `axis` that rotates `from` to `to` with the least squared error, radians.
fn angle_about(axis: &Unit<Vector3<f64>>, from: &[Vector3<f64>; 3], to: &[Vector3<f64>; 3]) -> f64 {
    let across = |v: &Vector3<f64>| v - axis.into_inner() * axis.dot(v);
    let (mut sine, mut cosine) = (0.0, 0.0);
    for (a, b) in from.iter().zip(to) {
        let (a, b) = (across(a), across(b));
        sine += axis.dot(&a.cross(&b));
        cosine += a.dot(&b);
    }
    sine.atan2(cosine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use crate::{MinimalEstimator, absolute_orientation};
    use proptest::prelude::*;
    use std::f64::consts::PI;

    const BOTH: [MinimalEstimator; 2] = [MinimalEstimator::Frame, MinimalEstimator::RotationAxis];

    /// A triangle without thin angles, mm.
    fn triple(seed: u64) -> Option<[Point3<f64>; 3]> {
        let p = cloud(seed, 3);
        let p = [p[0], p[1], p[2]];
        triangle_normal(&p).is_ok_and(|n| n.norm() > 4.0).then_some(p)
    }

    proptest! {
        #[test]
        fn both_estimators_recover_an_exact_motion_as_least_squares_does(seed in any::<u64>(), mirrored in any::<bool>()) {
            let Some(source) = triple(seed) else { return Ok(()) };
            let mut truth = pose(seed ^ 1);
            if mirrored {
                truth.rotation = -truth.rotation;
            }
            let target = source.map(|p| truth.apply(&p));
            for estimator in BOTH {
                let found = estimator.estimate(&source, &target, mirrored).unwrap();
                prop_assert!((found.rotation - truth.rotation).norm() < 1e-9, "{estimator:?}");
                prop_assert!((found.translation - truth.translation).norm() < 1e-7, "{estimator:?}");
                if !mirrored {
                    let fitted = absolute_orientation(&source, &target, None, false).unwrap();
                    prop_assert!((found.rotation - fitted.rotation).norm() < 1e-9, "{estimator:?}");
                }
            }
        }

        #[test]
        fn an_axis_in_the_plane_of_the_triangle_is_found(seed in any::<u64>(), along in 0usize..3, angle in 1e-9..PI) {
            let Some(source) = triple(seed) else { return Ok(()) };
            // The displacements are parallel: every corner moves across the plane by its distance from the axis.
            let axis = (source[(along + 1) % 3] - source[along]).normalize();
            for angle in [angle, PI] {
                let rotation = *Rotation3::new(axis * angle).matrix();
                let truth = RigidTransform { rotation, translation: pose(seed).translation };
                let target = source.map(|p| truth.apply(&p));
                let found = rotation_axis_estimate(&source, &target, false).unwrap();
                prop_assert!((found.rotation - rotation).norm() < 1e-9, "angle {angle}");
            }
        }

        #[test]
        fn half_turns_and_translations_are_found(seed in any::<u64>()) {
            let Some(source) = triple(seed) else { return Ok(()) };
            let shift = pose(seed).translation;
            let axis = pose(seed ^ 5).quaternion().axis().unwrap();
            for rotation in [*Rotation3::from_axis_angle(&axis, PI).matrix(), Matrix3::identity()] {
                let truth = RigidTransform { rotation, translation: shift };
                let found = rotation_axis_estimate(&source, &source.map(|p| truth.apply(&p)), false).unwrap();
                prop_assert!((found.rotation - rotation).norm() < 1e-9);
            }
        }

        #[test]
        fn a_little_noise_rotates_the_result_a_little(seed in any::<u64>()) {
            let Some(source) = triple(seed) else { return Ok(()) };
            prop_assume!(triangle_normal(&source).unwrap().norm() > 100.0);
            let (truth, noise) = (pose(seed ^ 1), cloud(seed ^ 2, 3));
            // At most 0.045 mm of noise on triangles with heights above 2 mm.
            let mut target = source.map(|p| truth.apply(&p));
            for (t, n) in target.iter_mut().zip(&noise) {
                *t += n.coords * 1e-3;
            }
            for estimator in BOTH {
                let found = estimator.estimate(&source, &target, false).unwrap();
                prop_assert!(found.angle_to(&truth) < 0.1, "{estimator:?}: {}", found.angle_to(&truth));
            }
        }
    }

    #[test]
    fn thin_triangles_are_rejected_on_either_side() {
        let line = [0.0, 1.0, 2.0].map(|k| Point3::new(k, k, k));
        let wide = [Point3::origin(), Point3::new(3.0, 0.0, 0.0), Point3::new(0.0, 2.0, 0.0)];
        for estimator in BOTH {
            assert_eq!(estimator.estimate(&line, &wide, false), Err(TripleError::Collinear));
            assert_eq!(estimator.estimate(&wide, &line, true), Err(TripleError::Collinear));
        }
    }
}
