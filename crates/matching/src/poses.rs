//! Poses worth trying, from the search of all orientations.

use super::side::Side;
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::{OrientedPoints, PoseSearchOptions, ScoredPose, pose_search};

/// Poses that lay `source` on `target`, the best first; with `allow_reflection` of either handedness.
pub(super) fn searched(source: &Side, target: &Side, allow_reflection: bool) -> Vec<ScoredPose> {
    let (source_areas, target_areas) = (vertex_areas(source.mesh()), vertex_areas(target.mesh()));
    pose_search(
        &OrientedPoints { points: source.mesh().vertices(), normals: &source.normals, areas: &source_areas },
        &OrientedPoints { points: target.mesh().vertices(), normals: &target.normals, areas: &target_areas },
        &PoseSearchOptions { allow_reflection, ..PoseSearchOptions::default() },
    )
}
