//! Poses rotated about the axis about which the source is most nearly round.

use crate::surface::round_axis::RoundAxis;
use crate::surface::side::Side;
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::RigidTransform;

/// Rotations by which the best poses are varied, degrees: less than two poses differ that count as different.
const VARIED_DEG: [f64; 4] = [-20.0, 20.0, -40.0, 40.0];
/// Rotations that give other poses, degrees: those of surfaces of two-, three-, four- and sixfold symmetry about an axis, and close enough to each other
/// that a fit finds every pose of one that is round.
const OTHERS_DEG: [f64; 9] = [60.0, 90.0, 120.0, 150.0, 180.0, 210.0, 240.0, 270.0, 300.0];

/// The best of `poses` of either handedness, rotated about the axis about which `source` is most nearly round: a rotation that a rigid
/// refinement hardly sees. Each with the index of the pose that was rotated; none where a number is not finite.
pub(crate) fn rotations_of_best(source: &Side, poses: &[RigidTransform]) -> Vec<(usize, RigidTransform)> {
    let Some(axis) = RoundAxis::of(source.mesh().vertices(), &vertex_areas(source.mesh())) else { return Vec::new() };
    let best = |mirrored: &bool| poses.iter().position(|pose| pose.is_reflection() == *mirrored);
    let rotated = |k: usize| {
        let axis = &axis;
        VARIED_DEG.iter().map(move |angle| (k, axis.rotated(&poses[k], angle.to_radians())))
    };
    [false, true].iter().filter_map(best).flat_map(rotated).collect()
}

/// The poses in which a symmetric surface would lie as well as in the first of `poses` that does not mirror: rotated about the same axis, and half a turn
/// about either of the other two principal axes. None where a number is not finite.
pub(crate) fn symmetric_poses(source: &Side, poses: &[RigidTransform]) -> Vec<RigidTransform> {
    let Some(pose) = poses.iter().find(|pose| !pose.is_reflection()) else { return Vec::new() };
    let Some(axis) = RoundAxis::of(source.mesh().vertices(), &vertex_areas(source.mesh())) else { return Vec::new() };
    OTHERS_DEG.iter().map(|angle| axis.rotated(pose, angle.to_radians())).chain(axis.half_turned(pose)).collect()
}
