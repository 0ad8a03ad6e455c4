//! Registration without an energy: a pose from a search of all orientations, from ellipsoids or from the centroids.

use crate::error::MatchError;
use crate::pair::scene::Scene;
use crate::poses::copies::align_shortly;
use crate::poses::posed::Registered;
use crate::starts::search::searched;
use homolog_contract::parameters::{InitialPose, Refinement};
use homolog_contract::result::{PoseDocument, PoseOrigin};
use homolog_geometry::harmonics::{
    EllipsoidOptions, EllipsoidRegistration, FirstOrderEllipsoid, HarmonicsError, ParametrizationOptions,
    first_order_ellipsoid, parametrize, register_by_ellipsoids,
};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Phase;
use homolog_registration::{IcpMetric, RigidTransform, SurfaceSide, TwoSidedOptions, align_both_ways};
use nalgebra::{Matrix3, Point3, Vector3};

/// Steps of refinement on all vertices.
const FULL_STEPS: u32 = 2;
/// Refinement ends when a step rotates by less than this, radians, and moves by less than this, in diagonals of the
/// source.
const TOLERANCE: f64 = 1e-5;

/// Registers according to `registration.initial`, without an energy.
pub(crate) fn register(scene: &Scene<'_>) -> Result<Registered, MatchError> {
    let (source, target) = (scene.source.mesh().vertices(), scene.target.mesh().vertices());
    let mut ambiguous_axes = false;
    let (start, poses) = match scene.parameters.registration.initial {
        InitialPose::Centroids | InitialPose::Ransac => (centroid_on_centroid(source, target), Vec::new()),
        InitialPose::Search => {
            scene.observer.phase(Phase::Registration);
            of_search(scene)
        }
        InitialPose::FirstOrderEllipsoid => {
            let found = ellipsoids(scene)?;
            ambiguous_axes = found.ambiguous_axes;
            let mut poses = found.poses.map(|p| (PoseOrigin::FirstOrderEllipsoid, p.target_from_source, p.rms_mm));
            poses.sort_by(|a, b| a.2.total_cmp(&b.2));
            (found.pose().target_from_source, poses.to_vec())
        }
    };
    let transform = match scene.parameters.registration.initial {
        InitialPose::Search => refined(scene, &start)?,
        _ => scene.refine(&start)?,
    };
    let poses = poses.into_iter().map(|(origin, pose, rms_mm)| PoseDocument {
        origin,
        matrix: pose.matrix(),
        angle_deg: pose.angle_to(&transform).to_degrees(),
        rms_mm,
        misfit: None,
        mirrored: pose.is_reflection(),
        as_good: false,
    });
    Ok(Registered { transform, poses: poses.collect(), ambiguous_axes })
}

fn centroid_on_centroid(source: &[Point3<f64>], target: &[Point3<f64>]) -> RigidTransform {
    let center =
        |points: &[Point3<f64>]| points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
    RigidTransform { rotation: Matrix3::identity(), translation: center(target) - center(source) }
}

/// Aligns the first-order ellipsoids: by the pose of least rotation, or by the closest pose if the parameters ask for
/// it.
fn ellipsoids(scene: &Scene<'_>) -> Result<EllipsoidRegistration, MatchError> {
    let of = |mesh: &SurfaceMesh, surface: &'static str| -> Result<FirstOrderEllipsoid, MatchError> {
        let found = parametrize(mesh, &ParametrizationOptions::default(), scene.observer)
            .and_then(|parametrization| first_order_ellipsoid(mesh, &parametrization));
        found.map_err(|error| match error {
            HarmonicsError::Cancelled(cancelled) => MatchError::Cancelled(cancelled),
            error => MatchError::NoEllipsoid { surface, error },
        })
    };
    let (source, target) = rayon::join(|| of(scene.source.mesh(), "source"), || of(scene.target.mesh(), "target"));
    let points = scene.source.mesh().vertices();
    let options =
        EllipsoidOptions { resolve: scene.parameters.registration.resolve_ambiguity, ..EllipsoidOptions::default() };
    Ok(register_by_ellipsoids(&source?, &target?, points, scene.closest, &options, scene.observer)?)
}

/// The best pose of the search of all orientations, and all poses that it found, the best first, with their distances.
/// With reflections allowed these include the best of either handedness.
fn of_search(scene: &Scene<'_>) -> (RigidTransform, Vec<(PoseOrigin, RigidTransform, f64)>) {
    let (source, target) = (scene.source.mesh(), scene.target.mesh());
    let found = searched(scene.source, scene.target, scene.parameters.registration.allow_reflection);
    let poses: Vec<_> = found
        .iter()
        .map(|p| (PoseOrigin::Search, p.target_from_source, scene.sample_rms_mm(&p.target_from_source)))
        .collect();
    let best = poses.first().map(|(_, pose, _)| *pose);
    (best.unwrap_or_else(|| centroid_on_centroid(source.vertices(), target.vertices())), poses)
}

/// `start` refined in both directions on lightly smoothed surfaces, if these are copies of one shape.
///
/// If shapes differ, the pose of the search is kept: alignment to closest points would rotate it towards the least
/// distance, not towards the correspondences of a surface that deforms.
fn refined(scene: &Scene<'_>, start: &RigidTransform) -> Result<RigidTransform, MatchError> {
    let metric = match scene.parameters.registration.refine {
        Refinement::None => return Ok(*start),
        Refinement::PointToPoint => IcpMetric::PointToPoint,
        Refinement::PointToPlane => IcpMetric::PointToPlane,
    };
    scene.observer.phase(Phase::Refinement);
    let (source, target) = rayon::join(|| scene.source.light(), || scene.target.light());
    let [of_source, of_target] = [source, target].map(|side| SurfaceSide {
        points: side.mesh.vertices(),
        areas: &side.areas,
        closest: &side.closest,
    });
    let first = align_shortly(&of_source, &of_target, start, (scene.edge_mm, TOLERANCE), scene.observer)?;
    if !first.copies {
        return Ok(*start);
    }
    let options = TwoSidedOptions {
        metric,
        max_sample: usize::MAX,
        sample_steps: 0,
        full_steps: FULL_STEPS,
        tolerance: TOLERANCE,
    };
    let found = align_both_ways(&of_source, &of_target, &first.target_from_source, &options, scene.observer)?;
    Ok(found.target_from_source)
}

#[cfg(test)]
mod tests {
    use crate::testing::numbers;
    use crate::tests::{bean, motion};
    use crate::{MatchOutcome, match_surfaces};
    use homolog_contract::parameters::resolve;
    use homolog_mesh::SurfaceMesh;
    use homolog_primitives::observe::Silent;
    use nalgebra::{Matrix3, Vector3};
    use serde_json::json;

    fn register(source: &SurfaceMesh, target: &SurfaceMesh, registration: serde_json::Value) -> MatchOutcome {
        let parameters = resolve(&json!({"method": "rigid", "registration": registration})).unwrap();
        match_surfaces(source, target, &parameters, &Silent).unwrap()
    }

    fn linear(matrix: &[[f64; 4]; 4]) -> Matrix3<f64> {
        Matrix3::from_fn(|i, k| matrix[i][k])
    }

    #[test]
    fn a_copy_is_found_by_points_and_by_planes() {
        let (source, target) = (bean(), bean().transformed(&motion()));
        for refine in ["point_to_point", "point_to_plane"] {
            let found = register(&source, &target, json!({"refine": refine}));
            let off = (linear(&found.transform.matrix) - motion().rotation.to_rotation_matrix().matrix()).norm();
            assert!(off < 1e-3, "{refine}: {off}");
            assert!(found.poses[0].angle_deg < 2.0 && found.poses.len() > 1);
        }
    }

    #[test]
    fn the_pose_is_found_under_noise_of_two_percent_on_every_vertex() {
        let target = bean().transformed(&motion());
        let (low, high) = target.bounding_box();
        let mut uniform = numbers(5);
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
        let size = 0.02 * (high - low).norm();
        let noisy = target.vertices().iter().map(|p| p + Vector3::from_fn(|_, _| size * normal())).collect();
        let found = register(&bean(), &target.with_vertices(noisy).unwrap(), json!({"refine": "point_to_plane"}));
        let off = linear(&found.transform.matrix).transpose() * motion().rotation.to_rotation_matrix().matrix();
        let degrees = ((off.trace() - 1.0) / 2.0).clamp(-1.0, 1.0).acos().to_degrees();
        assert!(degrees < 5.0, "{degrees} degrees");
    }

    #[test]
    fn a_mirrored_copy_is_recognized_and_both_hands_are_listed() {
        let mirror = [[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let target = bean().moved(&mirror).unwrap().transformed(&motion());
        let found = register(&bean(), &target, json!({"allow_reflection": true}));
        assert!(linear(&found.transform.matrix).determinant() < 0.0 && found.surface_distance.max_mm < 0.1);
        let proper = found.poses.iter().find(|p| linear(&p.matrix).determinant() > 0.0).unwrap();
        assert!(proper.rms_mm > 2.0 * found.poses[0].rms_mm);
    }
}
