//! Equality of two poses of a surface, apart from details.

use super::{RigidTransform, weighted_moments};
use nalgebra::Point3;

/// Angle, radians, within which poses count as the same; 30°.
pub const SAME_POSE_ANGLE: f64 = 0.52;

/// Criterion for equal poses of a surface.
///
/// Two complete surfaces lie on each other in one place for each orientation. A part may fit a whole at several places
/// in one orientation. For a part, poses therefore also differ if they move it, root mean square, as far as a rotation
/// by the angle can.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SamePose {
    center: Point3<f64>,
    /// Radius of gyration: a rotation about the centroid moves points, root mean square, by at most this times its
    /// angle.
    spread_mm: f64,
}

impl SamePose {
    /// Compares orientations only.
    pub fn of_orientation() -> Self {
        SamePose { center: Point3::origin(), spread_mm: f64::INFINITY }
    }

    /// Compares the orientation and the place of the surface with these points, mm, and areas; orientations only if
    /// there is no area, or a number is not finite.
    pub fn of_place(points: &[Point3<f64>], areas: &[f64]) -> Self {
        let total: f64 = areas.iter().sum();
        match weighted_moments(points, areas, total) {
            Some((center, scatter)) if total > 0.0 => {
                SamePose { center: center.into(), spread_mm: (scatter.trace() / total).sqrt() }
            }
            _ => SamePose::of_orientation(),
        }
    }

    /// Distance, mm, equivalent to a rotation by `angle`, radians.
    pub(crate) fn distance_mm(&self, angle: f64) -> f64 {
        angle * self.spread_mm
    }

    /// Whether `a` and `b`, transforms of the surface, have the same handedness and differ by less than `angle`,
    /// radians.
    pub fn holds(&self, a: &RigidTransform, b: &RigidTransform, angle: f64) -> bool {
        let apart = || (a.apply(&self.center) - b.apply(&self.center)).norm();
        a.is_reflection() == b.is_reflection() && a.angle_to(b) < angle && apart() < self.distance_mm(angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{cloud, pose};
    use nalgebra::{Rotation3, Vector3};

    #[test]
    fn a_place_differs_where_the_surface_is_moved_as_far_as_by_a_rotation() {
        let points = cloud(3, 50);
        let areas = vec![2.0; 50];
        let same = SamePose::of_place(&points, &areas);
        let at = pose(4);
        // Root mean square distance of the points from their centroid, by definition.
        let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / 50.0;
        let spread_mm = (points.iter().map(|p| (p.coords - center).norm_squared()).sum::<f64>() / 50.0).sqrt();
        let shifted = |share: f64| RigidTransform {
            translation: at.translation + Vector3::new(0.6, 0.0, -0.8) * (share * 0.3 * spread_mm),
            ..at
        };
        assert!(same.holds(&at, &shifted(0.99), 0.3) && !same.holds(&at, &shifted(1.01), 0.3));
        assert!(SamePose::of_orientation().holds(&at, &shifted(100.0), 0.3));
        let mirror = RigidTransform { rotation: -at.rotation, ..at };
        assert!(!SamePose::of_orientation().holds(&at, &mirror, 3.2));
        // About the centroid, which therefore stays in place.
        let turned = |angle: f64| {
            let rotation = at.rotation * Rotation3::from_axis_angle(&Vector3::z_axis(), angle).matrix();
            RigidTransform { rotation, translation: at.translation + (at.rotation - rotation) * center }
        };
        assert!(same.holds(&at, &turned(0.29), 0.3) && !same.holds(&at, &turned(0.31), 0.3));
        // Without an area there is no centroid.
        assert_eq!(SamePose::of_place(&points, &[0.0; 50]), SamePose::of_orientation());
    }
}
