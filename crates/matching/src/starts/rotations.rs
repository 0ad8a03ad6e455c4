//! Rotations of poses about the axis about which the source is most nearly round.

use crate::surface::round_axis::RoundAxis;
use crate::surface::side::SurfaceLevel;
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::RigidTransform;

/// Small rotations of the best poses, degrees: within the angle at which two poses count as one.
const VARIED_DEG: [f64; 4] = [-20.0, 20.0, -40.0, 40.0];
/// Large rotations that give other poses, degrees: the symmetries of order two, three, four and six about an axis,
/// spaced closely enough that a fit finds every pose of a round surface.
const OTHERS_DEG: [f64; 9] = [60.0, 90.0, 120.0, 150.0, 180.0, 210.0, 240.0, 270.0, 300.0];

/// The best of `poses` of each handedness, rotated about the axis about which `source` is most nearly round; rigid
/// refinement hardly changes this rotation. Each with the index of the pose that was rotated. Empty if a number is not
/// finite.
pub(crate) fn rotations_of_best(source: &SurfaceLevel, poses: &[RigidTransform]) -> Vec<(usize, RigidTransform)> {
    let Some(axis) = RoundAxis::of(source.mesh().vertices(), &vertex_areas(source.mesh())) else { return Vec::new() };
    let best = |mirrored: &bool| poses.iter().position(|pose| pose.is_reflection() == *mirrored);
    let rotated = |k: usize| {
        let axis = &axis;
        VARIED_DEG.iter().map(move |angle| (k, axis.rotated(&poses[k], angle.to_radians())))
    };
    [false, true].iter().filter_map(best).flat_map(rotated).collect()
}

/// The possible symmetric counterparts of the first of `poses` that does not mirror: rotations about the same axis, and
/// half a turn about either of the other two principal axes. Empty if a number is not finite.
pub(crate) fn symmetric_poses(source: &SurfaceLevel, poses: &[RigidTransform]) -> Vec<RigidTransform> {
    let Some(pose) = poses.iter().find(|pose| !pose.is_reflection()) else { return Vec::new() };
    let Some(axis) = RoundAxis::of(source.mesh().vertices(), &vertex_areas(source.mesh())) else { return Vec::new() };
    OTHERS_DEG.iter().map(|angle| axis.rotated(pose, angle.to_radians())).chain(axis.half_turned(pose)).collect()
}
