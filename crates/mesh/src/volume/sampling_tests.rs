//! Orientations that are estimated from voxels vary as the normal equations say.

use super::*;
use crate::shapes::ellipsoid;

#[test]
fn scaling_the_shape_or_its_voxels_changes_what_is_known_by_the_square() {
    let at = |axes: f64, voxel: f64| {
        Sampling::of(&ellipsoid(Vector3::new(20.0, 9.0, 7.0) * axes, 4), &Matrix4::new_scaling(voxel))
    };
    let (one, coarse, large) = (at(1.0, 1.0), at(1.0, 3.0), at(2.0, 2.0));
    // Both the noise of a position and the root of the number of positions grow with the voxel.
    assert!((coarse.rotation_rad / one.rotation_rad - 9.0).abs() < 1e-9, "{coarse:?}");
    assert!((coarse.noise_mm / one.noise_mm - 3.0).abs() < 1e-9);
    assert!(
        (large.rotation_rad / one.rotation_rad - 1.0).abs() < 1e-9
            && (large.noise_mm / one.noise_mm - 2.0).abs() < 1e-9
    );
    // An isotropic voxel is as wide in every direction.
    assert!((one.noise_mm - (1.0f64 / 12.0).sqrt()).abs() < 1e-9);
}

#[test]
fn a_sphere_has_no_orientation() {
    let of = |axes: Vector3<f64>| Sampling::of(&ellipsoid(axes, 4), &Matrix4::identity()).rotation_rad.to_degrees();
    let (sphere, egg) = (of(Vector3::repeat(10.0)), of(Vector3::new(14.0, 10.0, 8.0)));
    assert!(egg < 1.0 && sphere > 5.0, "{egg} {sphere}");
}
