//! Poses that are related by approximate symmetries of a surface.
//!
//! If several poses explain two surfaces about as well, the transforms between them are approximate symmetries of the
//! surface. The starts of a search need not contain all poses that these symmetries lead to, and a detail that only one
//! pose explains, such as a bump on a cube, may belong to one that is missing. So the products of the symmetries are
//! tried as well.

use homolog_registration::RigidTransform;

/// Most symmetries of a surface, those of a cube and its mirror image: more are those of a round surface.
const MOST_SYMMETRIES: usize = 48;

/// Poses of the handedness of the first of `as_good` that products of the symmetries between these poses lead to, and
/// that are not among them. Empty if there are as many as those of a round surface.
///
/// Cost `O(symmetries² · as_good)`.
pub(super) fn missing_poses(
    as_good: &[RigidTransform],
    are_same: impl Fn(&RigidTransform, &RigidTransform) -> bool,
) -> Vec<RigidTransform> {
    let Some((own, others)) = as_good.split_first() else { return Vec::new() };
    let back = own.inverse();
    let symmetries: Vec<RigidTransform> = others.iter().map(|other| back.after(other)).collect();
    let are_same = |a: &RigidTransform, b: &RigidTransform| a.is_reflection() == b.is_reflection() && are_same(a, b);
    let mut poses = as_good.to_vec();
    let mut next = 0;
    while next < poses.len() {
        for symmetry in &symmetries {
            let pose = poses[next].after(symmetry);
            if !poses.iter().any(|known| are_same(known, &pose)) {
                poses.push(pose);
            }
        }
        if poses.len() > MOST_SYMMETRIES {
            return Vec::new();
        }
        next += 1;
    }
    poses.drain(..as_good.len());
    poses.retain(|pose| pose.is_reflection() == own.is_reflection());
    poses
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

    fn turn(axis: Vector3<f64>, degrees: f64) -> RigidTransform {
        let rotation = Rotation3::from_axis_angle(&Unit::new_normalize(axis), degrees.to_radians());
        RigidTransform { rotation: *rotation.matrix(), translation: Vector3::zeros() }
    }

    fn found(own: &RigidTransform, symmetries: &[RigidTransform]) -> Vec<RigidTransform> {
        let mut as_good = vec![*own];
        as_good.extend(symmetries.iter().map(|symmetry| own.after(symmetry)));
        missing_poses(&as_good, |a, b| a.angle_to(b) < 0.5)
    }

    #[test]
    fn two_rotations_of_a_cube_lead_to_the_others_from_any_pose() {
        let own =
            RigidTransform { translation: Vector3::new(3.0, -2.0, 9.0), ..turn(Vector3::new(1.0, 2.0, 3.0), 50.0) };
        // A little off, as poses of fits are.
        let symmetries = [turn(Vector3::z(), 91.0), turn(Vector3::new(1.0, 1.0, 1.0), 119.0)];
        let poses = found(&own, &symmetries);
        assert_eq!(poses.len(), 21);
        let is_of_cube = |pose: &RigidTransform| {
            let rotation = own.inverse().after(pose).rotation;
            rotation.iter().all(|x| (x.abs() - x.abs().round()).abs() < 0.2) && !pose.is_reflection()
        };
        assert!(poses.iter().all(is_of_cube));
        assert!(found(&own, &[turn(Vector3::z(), 180.0)]).is_empty());
        assert!(found(&own, &[]).is_empty() && missing_poses(&[], |_, _| false).is_empty());
    }

    #[test]
    fn mirror_images_lead_to_poses_but_are_none_of_them() {
        let mirror = |axis: Vector3<f64>| RigidTransform {
            rotation: Matrix3::identity() - 2.0 * axis * axis.transpose(),
            translation: Vector3::zeros(),
        };
        let poses = found(&RigidTransform::identity(), &[mirror(Vector3::x()), mirror(Vector3::y())]);
        assert_eq!(poses.len(), 1);
        assert!((poses[0].rotation - turn(Vector3::z(), 180.0).rotation).norm() < 1e-9);
    }

    #[test]
    fn a_sphere_has_no_list_of_poses() {
        let symmetries = [turn(Vector3::z(), 40.0), turn(Vector3::new(1.0, 0.3, 0.2), 70.0)];
        assert!(found(&RigidTransform::identity(), &symmetries).is_empty());
    }
}
