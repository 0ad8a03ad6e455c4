//! The axis about which a surface is most nearly round, and rotations about it, which change the surface least.

use homolog_registration::{RigidTransform, weighted_moments};
use nalgebra::{Point3, Rotation3, Unit, Vector3};
use std::f64::consts::PI;

/// The principal axis about which the other two moments of a surface are closest to each other.
pub(crate) struct RoundAxis {
    center: Vector3<f64>,
    direction: Unit<Vector3<f64>>,
    /// The other two principal axes.
    across: [Unit<Vector3<f64>>; 2],
}

impl RoundAxis {
    /// The axis of a surface with these vertices, mm, and their areas. `None` if a number is not finite.
    pub(crate) fn of(vertices: &[Point3<f64>], areas: &[f64]) -> Option<Self> {
        let (center, scatter) = weighted_moments(vertices, areas, areas.iter().sum())?;
        let eigen = scatter.symmetric_eigen();
        let unlike = |k: usize| {
            let (a, b) = (eigen.eigenvalues[(k + 1) % 3], eigen.eigenvalues[(k + 2) % 3]);
            a.max(b) / a.min(b).max(f64::MIN_POSITIVE)
        };
        let k = (0..3).min_by(|&a, &b| unlike(a).total_cmp(&unlike(b)))?;
        let axis = |k: usize| Unit::try_new(eigen.eigenvectors.column(k % 3).into_owned(), 0.0);
        Some(RoundAxis { center, direction: axis(k)?, across: [axis(k + 1)?, axis(k + 2)?] })
    }

    /// `pose` after a rotation of the surface by `angle` radians.
    pub(crate) fn rotated(&self, pose: &RigidTransform, angle: f64) -> RigidTransform {
        self.about(&self.direction, pose, angle)
    }

    /// `pose` after half a turn of the surface about either of the other two principal axes.
    pub(crate) fn half_turned(&self, pose: &RigidTransform) -> [RigidTransform; 2] {
        [0, 1].map(|k| self.about(&self.across[k], pose, PI))
    }

    fn about(&self, axis: &Unit<Vector3<f64>>, pose: &RigidTransform, angle: f64) -> RigidTransform {
        let rotation = pose.rotation * Rotation3::from_axis_angle(axis, angle).matrix();
        let translation = pose.rotation * self.center + pose.translation - rotation * self.center;
        RigidTransform { rotation, translation }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_geometry::curvature::vertex_areas;
    use homolog_mesh::shapes::ellipsoid;

    #[test]
    fn a_rotation_about_the_axis_of_a_surface_of_revolution_leaves_it_in_its_place() {
        let mesh = ellipsoid(Vector3::new(9.0, 4.0, 4.0), 3);
        let axis = RoundAxis::of(mesh.vertices(), &vertex_areas(&mesh)).unwrap();
        assert!(axis.direction.x.abs() > 0.999);
        let pose = RigidTransform { translation: Vector3::new(3.0, 2.0, 1.0), ..RigidTransform::identity() };
        let found = axis.rotated(&pose, 0.7);
        assert!((found.apply(&axis.center.into()) - pose.apply(&axis.center.into())).norm() < 1e-12);
        assert!((found.angle_to(&pose) - 0.7).abs() < 1e-12);
    }

    #[test]
    fn half_turns_exchange_the_ends_of_the_axis_and_leave_the_center() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 4.0), 3);
        let axis = RoundAxis::of(mesh.vertices(), &vertex_areas(&mesh)).unwrap();
        let end = Point3::from(axis.center + 9.0 * axis.direction.into_inner());
        for pose in axis.half_turned(&RigidTransform::identity()) {
            assert!((pose.apply(&end).coords + end.coords - 2.0 * axis.center).norm() < 1e-9);
            assert!((pose.apply(&axis.center.into()).coords - axis.center).norm() < 1e-9);
        }
    }
}
