//! Rigid transforms from three point pairs, the minimal sample of RANSAC.
//!
//! Both estimators ([`MinimalEstimator`]) give the same transform on congruent triangles; on triangles that differ
//! slightly they distribute the difference differently. Both reject thin triangles first.

use super::RigidTransform;
use super::rotation_axis::rotation_axis_estimate;
use super::triple::{TripleError, triangle_normal};
use nalgebra::{Matrix3, Point3, Vector3};

/// Method of estimating a rigid transform from three pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MinimalEstimator {
    /// An orthonormal frame on each triple (thesis, section 3.4.1).
    #[default]
    Frame,
    /// The axis that the rotation leaves fixed, then the angle about it (thesis, section 3.4.2).
    RotationAxis,
}

impl MinimalEstimator {
    /// `target_from_source` of three pairs, mm; maps centroid to centroid; `det R = −1` if `mirrored`.
    ///
    /// # Errors
    /// [`TripleError::Collinear`] if either triple is thin, the same for both estimators.
    pub fn estimate(
        self,
        source: &[Point3<f64>; 3],
        target: &[Point3<f64>; 3],
        mirrored: bool,
    ) -> Result<RigidTransform, TripleError> {
        match self {
            MinimalEstimator::Frame => frame_estimate(source, target, mirrored),
            MinimalEstimator::RotationAxis => rotation_axis_estimate(source, target, mirrored),
        }
    }
}

/// An orthonormal frame on a triple: first axis along its first edge, third along its normal.
fn frame(p: &[Point3<f64>; 3]) -> Result<Matrix3<f64>, TripleError> {
    let z = triangle_normal(p)?.normalize();
    let x = (p[1] - p[0]).normalize();
    Ok(Matrix3::from_columns(&[x, z.cross(&x), z]))
}

/// The transform that maps the frame of the source triple to the frame of the target triple, and centroid to centroid;
/// exact for congruent triangles. With `mirrored` the third axis is negated (a triangle is congruent to its mirror
/// image), so `det R = −1`.
///
/// # Errors
/// [`TripleError::Collinear`].
///
/// # Source
/// The thesis, section 3.4.1 (coordinate systems on both triples).
fn frame_estimate(
    source: &[Point3<f64>; 3],
    target: &[Point3<f64>; 3],
    mirrored: bool,
) -> Result<RigidTransform, TripleError> {
    let mut to = frame(target)?;
    if mirrored {
        to.set_column(2, &-to.column(2));
    }
    let rotation = to * frame(source)?.transpose();
    let centroid = |p: &[Point3<f64>; 3]| (p[0].coords + p[1].coords + p[2].coords) / 3.0;
    let translation: Vector3<f64> = centroid(target) - rotation * centroid(source);
    Ok(RigidTransform { rotation, translation })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_motion_of_a_triple_is_recovered(seed in any::<u64>(), mirrored in any::<bool>()) {
            let points = cloud(seed, 3);
            let mut truth = pose(seed ^ 1);
            if mirrored {
                truth.rotation = -truth.rotation;
            }
            let source = [points[0], points[1], points[2]];
            let target = source.map(|p| truth.apply(&p));
            match frame_estimate(&source, &target, mirrored) {
                Ok(found) => {
                    prop_assert!((found.rotation - truth.rotation).norm() < 1e-9);
                    prop_assert!((found.translation - truth.translation).norm() < 1e-7);
                }
                Err(TripleError::Collinear) => prop_assert!(frame(&source).is_err() || frame(&target).is_err()),
            }
        }
    }

    #[test]
    fn three_points_on_a_line_are_rejected() {
        let line = [0.0, 1.0, 2.0].map(|k| Point3::new(k, k, k));
        assert_eq!(frame_estimate(&line, &line, false), Err(TripleError::Collinear));
    }
}
