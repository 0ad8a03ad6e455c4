//! The axis about which a surface is most nearly round, and rotations about it: the motion that shows least.

use homolog_registration::{RigidTransform, weighted_moments};
use nalgebra::{Point3, Rotation3, Unit, Vector3};

/// The principal axis about which the other two moments of a surface are closest to each other.
pub(crate) struct RoundAxis {
    center: Vector3<f64>,
    direction: Unit<Vector3<f64>>,
}

impl RoundAxis {
    /// That of a surface with these vertices, mm, and their areas. `None` where a number is not finite.
    pub(crate) fn of(vertices: &[Point3<f64>], areas: &[f64]) -> Option<Self> {
        let (center, scatter) = weighted_moments(vertices, areas, areas.iter().sum())?;
        let eigen = scatter.symmetric_eigen();
        let unlike = |k: usize| {
            let (a, b) = (eigen.eigenvalues[(k + 1) % 3], eigen.eigenvalues[(k + 2) % 3]);
            a.max(b) / a.min(b).max(f64::MIN_POSITIVE)
        };
        let k = (0..3).min_by(|&a, &b| unlike(a).total_cmp(&unlike(b)))?;
        let direction = Unit::try_new(eigen.eigenvectors.column(k).into_owned(), 0.0)?;
        Some(RoundAxis { center, direction })
    }

    /// `pose` after a rotation of the surface by `angle` radians.
    pub(crate) fn rotated(&self, pose: &RigidTransform, angle: f64) -> RigidTransform {
        let rotation = pose.rotation * Rotation3::from_axis_angle(&self.direction, angle).matrix();
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
}
