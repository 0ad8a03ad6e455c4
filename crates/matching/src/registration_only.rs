//! Registration without an energy: a pose from the search of all orientations, from ellipsoids or from the centroids, and
//! each vertex answered with the nearest.

use super::MatchError;
use super::poses::searched;
use super::report::Answer;
use super::scene::Scene;
use homolog_contract::parameters::{InitialPose, Refinement};
use homolog_contract::result::{PoseDocument, PoseOrigin, StopReason};
use homolog_geometry::harmonics::{
    EllipsoidOptions, EllipsoidRegistration, FirstOrderEllipsoid, HarmonicsError, ParametrizationOptions,
    first_order_ellipsoid, parametrize, register_by_ellipsoids,
};
use homolog_mesh::SurfaceMesh;
use homolog_mrf::inference::belief_spread;
use homolog_primitives::graph::LabelNeighborhoods;
use homolog_primitives::observe::Phase;
use homolog_registration::{IcpMetric, RigidTransform, SurfaceSide, TwoSidedOptions, align_both_ways};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Vertices of each surface at most on which refinement begins.
const REFINE_SAMPLE: usize = 400;
/// Its steps there, and on all vertices.
const SAMPLE_STEPS: u32 = 10;
const FULL_STEPS: u32 = 2;
/// Refinement ends when a step turns by less, radians, and moves by less, mm.
const TOLERANCE: f64 = 1e-5;
/// Robust standard deviation of the residuals along the normals, in mean target edge lengths, below which surfaces are
/// copies of one shape: at most 0.14 for re-sampled copies, also noisy or cut ones; from 0.30 on for different subjects,
/// from 0.54 for warps of 8 % of the diagonal.
const COPY_EDGES: f64 = 0.2;
/// A vertex may be answered with those within this many edges of the closest triangle.
const RINGS: usize = 1;

/// Registers as `registration.initial` asks. Costs no energy and no messages.
pub(super) fn register(scene: &Scene<'_>) -> Result<Answer, MatchError> {
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
    });
    let (labeling, confidence, spread_mm) = nearest(scene, &transform);
    Ok(Answer {
        labeling,
        confidence,
        spread_mm,
        points: None,
        moved: None,
        no_counterpart: Vec::new(),
        reliability: None,
        anatomy: None,
        transform,
        confidence_reached: true,
        trials: 0,
        stop_reason: StopReason::RegistrationOnly,
        rounds: Vec::new(),
        poses: poses.collect(),
        ambiguous_axes,
        lower_bound: None,
    })
}

fn centroid_on_centroid(source: &[Point3<f64>], target: &[Point3<f64>]) -> RigidTransform {
    let center =
        |points: &[Point3<f64>]| points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
    RigidTransform { rotation: Matrix3::identity(), translation: center(target) - center(source) }
}

/// The first-order ellipsoids laid on each other, the closest of the four poses chosen.
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
    let options = EllipsoidOptions::default();
    Ok(register_by_ellipsoids(&source?, &target?, points, scene.closest, &options, scene.observer)?)
}

/// The poses that the search of all orientations found, the best first, with their distances; and the best.
///
/// With reflections allowed the best of either handedness are among them: whichever leads fits better.
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

/// `start` refined both ways on lightly smoothed surfaces where they are copies of one shape.
///
/// Where shapes differ, the search's pose stays: it is the orientation of pairs on a surface that could bend, and closest
/// points would turn it towards the least distance: of 20 real 8 % warps 4 were beyond 10 degrees after that, 1 before.
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
    // Whether these are copies a few steps against planes tell, whatever is asked for after them.
    let first = TwoSidedOptions {
        metric: IcpMetric::PointToPlane,
        max_sample: REFINE_SAMPLE,
        sample_steps: SAMPLE_STEPS,
        full_steps: 0,
        tolerance: TOLERANCE,
    };
    let close = align_both_ways(&of_source, &of_target, start, &first, scene.observer)?;
    if close.residual_mm > COPY_EDGES * scene.edge_mm {
        return Ok(*start);
    }
    let last = TwoSidedOptions { metric, sample_steps: 0, full_steps: FULL_STEPS, ..first };
    let found = align_both_ways(&of_source, &of_target, &close.target_from_source, &last, scene.observer)?;
    Ok(found.target_from_source)
}

/// Answers every vertex of the source with the nearest of the target after the transform of `answer`.
pub(super) fn answer_all(scene: &Scene<'_>, answer: &mut Answer) {
    (answer.labeling, answer.confidence, answer.spread_mm) = nearest(scene, &answer.transform);
}

/// For every source vertex the nearest vertex of the target after the transform, how much nearer it is than those
/// around it, and how far these spread: `p(x) ∝ exp(−d²/2σ²)`, `σ` the root mean square distance of the surfaces.
fn nearest(scene: &Scene<'_>, transform: &RigidTransform) -> (Vec<u32>, Vec<f64>, Vec<f64>) {
    let target = scene.target.mesh().vertices();
    let around = LabelNeighborhoods::new(&scene.target.mesh().edge_graph(), RINGS, |_, _| 0.0);
    let moved: Vec<_> = scene.source.mesh().vertices().iter().map(|p| transform.apply(p)).collect();
    let closest: Vec<_> = moved.par_iter().map(|p| scene.closest.index.closest(p)).collect();
    let squares: f64 = moved.iter().zip(&closest).map(|(p, found)| (found.point - p).norm_squared()).sum();
    // Two copies lie on each other; half an edge is as well as a vertex can be told from the next.
    let sigma = (squares / moved.len() as f64).sqrt().max(0.5 * scene.edge_mm);
    let rows: Vec<(u32, f64, f64)> = moved
        .par_iter()
        .zip(&closest)
        .map(|(p, found)| {
            let mut candidates: Vec<u32> =
                found.triangle.iter().flat_map(|&x| around.members(x as usize)).copied().collect();
            candidates.sort_unstable();
            candidates.dedup();
            let squared = |x: u32| (target[x as usize] - p).norm_squared();
            let best = candidates
                .iter()
                .copied()
                .fold(found.triangle[0], |best, x| if squared(x) < squared(best) { x } else { best });
            let weights: Vec<f32> = candidates
                .iter()
                .map(|&x| ((squared(best) - squared(x)) / (2.0 * sigma * sigma)).exp() as f32)
                .collect();
            let positions: Vec<_> = candidates.iter().map(|&x| target[x as usize]).collect();
            let sum: f32 = weights.iter().sum();
            (best, f64::from(1.0 / sum), belief_spread(&weights, &positions))
        })
        .collect();
    let labeling = rows.iter().map(|r| r.0).collect();
    (labeling, rows.iter().map(|r| r.1).collect(), rows.iter().map(|r| r.2).collect())
}

#[cfg(test)]
mod tests {
    use crate::tests::{bean, motion};
    use crate::{MatchOutcome, match_surfaces};
    use homolog_contract::parameters::resolve;
    use homolog_mesh::SurfaceMesh;
    use homolog_primitives::observe::Silent;
    use nalgebra::{Matrix3, Vector3};
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;
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
    fn noise_of_two_percent_on_every_vertex_is_borne() {
        let target = bean().transformed(&motion());
        let (low, high) = target.bounding_box();
        let mut random = Xoshiro256PlusPlus::seed_from_u64(5);
        let mut uniform = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
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
