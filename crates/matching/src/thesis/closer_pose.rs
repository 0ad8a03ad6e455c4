//! A pose on the principal axes that fits clearly better than the present pose.

use crate::pair::scene::even_sample;
use homolog_primitives::observe::{Cancelled, Observer};
use homolog_registration::{
    ClosestSurfacePoint, IcpMetric, IcpOptions, RigidTransform, principal_axis_poses, refine_icp,
};
use nalgebra::Point3;
use rayon::prelude::*;

/// ICP steps of the comparison of poses: enough to distinguish head from tail.
const ITERATIONS: u32 = 30;
/// Share of the sample that ICP keeps.
const KEEP: f64 = 0.9;
/// Largest ratio of the distances of closest points of a candidate and of the present pose at which the candidate is
/// taken.
const RATIO: f64 = 0.93;
/// Angle within which a candidate is the same pose as the present one, radians.
const ANGLE: f64 = 0.5;

/// The best pose on the principal axes, if it brings `source` clearly closer to the surface `closest` than `present`
/// does and is not the same pose. `source` and `target` are vertices, mm. `None` for a `present` that mirrors.
///
/// Elongated structures look alike from both ends, so belief propagation can settle on the wrong one.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// At most five short ICP runs of 500 points, independent of the size of the surfaces.
pub(crate) fn closer_pose(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    closest: &dyn ClosestSurfacePoint,
    present: &RigidTransform,
    observer: &dyn Observer,
) -> Result<Option<RigidTransform>, Cancelled> {
    if present.is_reflection() {
        return Ok(None);
    }
    let Some(poses) = principal_axis_poses(source, target) else { return Ok(None) };
    let sample: Vec<Point3<f64>> = even_sample(source).copied().collect();
    let options =
        IcpOptions { metric: IcpMetric::PointToPoint, keep: KEEP, max_iterations: ITERATIONS, tolerance: 1e-3 };
    let refine = |start: &RigidTransform| refine_icp(&sample, closest, start, &options, observer);
    let starts: Vec<RigidTransform> = poses.iter().chain([present]).copied().collect();
    let mut reports = starts.par_iter().map(refine).collect::<Result<Vec<_>, Cancelled>>()?;
    let Some(own) = reports.pop().map(|report| report.rms_mm) else { return Ok(None) };
    let mut best: Option<(f64, RigidTransform)> = None;
    for report in reports {
        if best.as_ref().is_none_or(|(rms, _)| report.rms_mm < *rms) {
            best = Some((report.rms_mm, report.target_from_source));
        }
    }
    Ok(best.filter(|(rms, pose)| *rms < RATIO * own && pose.angle_to(present) > ANGLE).map(|(_, pose)| pose))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::surface_index::SurfaceIndex;
    use crate::tests::{bean, motion};
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn a_pose_rotated_by_180_degrees_has_a_better_candidate_and_the_right_one_has_none() {
        let source = bean();
        let target = source.transformed(&motion());
        let truth = RigidTransform {
            rotation: *motion().rotation.to_rotation_matrix().matrix(),
            translation: motion().translation.vector,
        };
        let closest = SurfaceIndex::new(&target);
        let candidate = |present: &RigidTransform| {
            closer_pose(source.vertices(), target.vertices(), &closest, present, &Silent).unwrap()
        };
        assert_eq!(candidate(&truth), None);
        let center = source.centroid().coords;
        for axis in [Vector3::y(), Vector3::z()] {
            let half_turn = *nalgebra::Rotation3::new(axis * std::f64::consts::PI).matrix();
            let half_turned = RigidTransform { rotation: half_turn, translation: center - half_turn * center };
            let found = candidate(&truth.after(&half_turned)).unwrap();
            assert!(found.angle_to(&truth).to_degrees() < 2.0, "{} degrees", found.angle_to(&truth).to_degrees());
        }
    }
}
