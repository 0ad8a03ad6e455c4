//! Registration without an energy: poses compared by closest points, each vertex answered with the nearest.

use super::MatchError;
use super::parameters::InitialPose;
use super::report::Answer;
use super::result::{PoseDocument, PoseOrigin, StopReason};
use super::scene::Scene;
use crate::graph::LabelNeighborhoods;
use crate::harmonics::{
    EllipsoidOptions, EllipsoidRegistration, FirstOrderEllipsoid, HarmonicsError, ParametrizationOptions,
    first_order_ellipsoid, parametrize, register_by_ellipsoids,
};
use crate::inference::belief_spread;
use crate::mesh::SurfaceMesh;
use crate::registration::{IcpMetric, IcpOptions, RigidTransform, principal_axis_poses, refine_icp};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Source vertices at most on which poses are compared.
const SAMPLE: usize = 500;
/// Closest-point steps before poses are compared: enough to tell head from tail.
const ITERATIONS: u32 = 30;
/// Share of the sample that counts.
const KEEP: f64 = 0.9;
/// A vertex may be answered with those within this many edges of the closest triangle.
const RINGS: usize = 1;

/// Registers as `registration.initial` asks. Costs no energy and no messages.
pub(super) fn register(scene: &Scene<'_>) -> Result<Answer, MatchError> {
    let (source, target) = (scene.source.mesh().vertices(), scene.target.mesh().vertices());
    let mut ambiguous_axes = false;
    let (start, poses) = match scene.parameters.registration.initial {
        InitialPose::Centroids | InitialPose::Ransac => (centroid_on_centroid(source, target), Vec::new()),
        InitialPose::PrincipalAxes => {
            let poses = principal_poses(source, target, scene.parameters.registration.allow_reflection);
            compared(scene, &poses)?
        }
        InitialPose::FirstOrderEllipsoid => {
            let found = ellipsoids(scene)?;
            ambiguous_axes = found.ambiguous_axes;
            let mut poses = found.poses.map(|p| (PoseOrigin::FirstOrderEllipsoid, p.target_from_source, p.rms_mm));
            poses.sort_by(|a, b| a.2.total_cmp(&b.2));
            (found.pose().target_from_source, poses.to_vec())
        }
    };
    let transform = scene.refine(&start)?;
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

/// The four proper poses, and with `reflections` the four that mirror.
pub(super) fn principal_poses(
    source: &[Point3<f64>],
    target: &[Point3<f64>],
    reflections: bool,
) -> Vec<RigidTransform> {
    let mut poses: Vec<_> = principal_axis_poses(source, target).into_iter().flatten().collect();
    if reflections {
        // A mirrored copy has the same axes, mirrored; what moves it, moves the source after the mirror.
        let mirror = RigidTransform {
            rotation: Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0)),
            translation: Vector3::zeros(),
        };
        let mirrored: Vec<_> = source.iter().map(|p| mirror.apply(p)).collect();
        poses.extend(principal_axis_poses(&mirrored, target).into_iter().flatten().map(|pose| pose.after(&mirror)));
    }
    poses
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
    Ok(register_by_ellipsoids(&source?, &target?, points, &scene.closest, &options, scene.observer)?)
}

type Compared = (RigidTransform, Vec<(PoseOrigin, RigidTransform, f64)>);

/// Each pose after a few closest-point steps, the closest first; and the closest.
fn compared(scene: &Scene<'_>, poses: &[RigidTransform]) -> Result<Compared, MatchError> {
    let source = scene.source.mesh().vertices();
    // Canonical numbering follows a curve through space, so every k-th vertex is an even sample.
    let sample: Vec<Point3<f64>> = source.iter().step_by(source.len().div_ceil(SAMPLE)).copied().collect();
    let options =
        IcpOptions { metric: IcpMetric::PointToPoint, keep: KEEP, max_iterations: ITERATIONS, tolerance: 1e-3 };
    let mut found = Vec::new();
    for pose in poses {
        let report = refine_icp(&sample, &scene.closest, pose, &options, scene.observer)?;
        found.push((PoseOrigin::PrincipalAxes, report.target_from_source, report.rms_mm));
    }
    found.sort_by(|a, b| a.2.total_cmp(&b.2));
    let best = found.first().map(|(_, pose, _)| *pose);
    let best = best.unwrap_or_else(|| centroid_on_centroid(source, scene.target.mesh().vertices()));
    Ok((best, found))
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
