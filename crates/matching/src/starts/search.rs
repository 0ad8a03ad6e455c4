//! Rigid poses from a search of all orientations.

use crate::pair::part::part;
use crate::pair::role::Role;
use crate::surface::side::SurfaceLevel;
use homolog_geometry::curvature::vertex_areas;
use homolog_registration::alignment::OrientedPoints;
use homolog_registration::{PoseSearchOptions, RigidTransform, SAME_POSE_ANGLE, SamePose, ScoredPose, pose_search};

/// The vertices of `side`, without features: pose search computes its own.
fn oriented<'a>(side: &'a SurfaceLevel, areas: &'a [f64]) -> OrientedPoints<'a> {
    OrientedPoints { points: side.mesh().vertices(), normals: &side.normals, areas, features: &[] }
}

/// Poses that align `source` with `target`, the best first; with `allow_reflection` of either handedness. A part is
/// aligned with the whole, whichever of them is the source.
pub(crate) fn searched(source: &SurfaceLevel, target: &SurfaceLevel, allow_reflection: bool) -> Vec<ScoredPose> {
    let part = part(source, target);
    let (from, to) = if part == Some(Role::Target) { (target, source) } else { (source, target) };
    let (from_areas, to_areas) = (vertex_areas(from.mesh()), vertex_areas(to.mesh()));
    let mut found = pose_search(
        &oriented(from, &from_areas),
        &oriented(to, &to_areas),
        &PoseSearchOptions { allow_reflection, source_is_part: part.is_some(), ..PoseSearchOptions::default() },
    );
    if part == Some(Role::Target) {
        for pose in &mut found {
            pose.target_from_source = pose.target_from_source.inverse();
        }
    }
    found
}

/// Returns whether two poses of `source` on `target` are the same within 30°; poses of a part also have to agree in
/// place.
pub(crate) fn sameness(
    source: &SurfaceLevel,
    target: &SurfaceLevel,
) -> impl Fn(&RigidTransform, &RigidTransform) -> bool {
    let of_place = |side: &SurfaceLevel| SamePose::of_place(side.mesh().vertices(), &vertex_areas(side.mesh()));
    let part = part(source, target);
    let same = match part {
        None => SamePose::of_orientation(),
        Some(Role::Source) => of_place(source),
        Some(Role::Target) => of_place(target),
    };
    move |a, b| match part {
        Some(Role::Target) => same.holds(&a.inverse(), &b.inverse(), SAME_POSE_ANGLE),
        _ => same.holds(a, b, SAME_POSE_ANGLE),
    }
}
