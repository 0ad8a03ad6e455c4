//! Poses worth trying, from the search of all orientations.

use super::side::Side;
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::alignment::OrientedPoints;
use homolog_registration::{PoseSearchOptions, ScoredPose, pose_search};

/// The vertices of `side`; pose search computes features of its own.
fn oriented<'a>(side: &'a Side, areas: &'a [f64]) -> OrientedPoints<'a> {
    OrientedPoints { points: side.mesh().vertices(), normals: &side.normals, areas, features: &[] }
}

/// Poses that lay `source` on `target`, the best first; with `allow_reflection` of either handedness.
pub(super) fn searched(source: &Side, target: &Side, allow_reflection: bool) -> Vec<ScoredPose> {
    let (source_areas, target_areas) = (vertex_areas(source.mesh()), vertex_areas(target.mesh()));
    pose_search(
        &oriented(source, &source_areas),
        &oriented(target, &target_areas),
        &PoseSearchOptions { allow_reflection, ..PoseSearchOptions::default() },
    )
}
