//! Poses of the search rotated about the axis about which the source is most nearly round.

use crate::surface::round_axis::RoundAxis;
use crate::surface::side::Side;
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::{RigidTransform, ScoredPose};

/// Rotations by which the best poses of the search are varied, degrees: less than two poses differ that count as different.
const VARIED_DEG: [f64; 4] = [-20.0, 20.0, -40.0, 40.0];

/// The best pose of either handedness among those of a search, rotated about the axis about which `source` is most nearly round: a
/// rotation that a rigid refinement hardly sees. Each with the index of the pose that was rotated; none where a number is not finite.
pub(crate) fn rotations_of_best(source: &Side, found: &[ScoredPose]) -> Vec<(usize, RigidTransform)> {
    let Some(axis) = RoundAxis::of(source.mesh().vertices(), &vertex_areas(source.mesh())) else { return Vec::new() };
    let best = |mirrored: bool| found.iter().position(|p| p.target_from_source.is_reflection() == mirrored);
    let rotations = |k: usize| {
        let axis = &axis;
        VARIED_DEG.map(move |angle| (k, axis.rotated(&found[k].target_from_source, angle.to_radians())))
    };
    [false, true].into_iter().filter_map(best).flat_map(rotations).collect()
}
