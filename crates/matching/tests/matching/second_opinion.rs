//! Answers of methods that fit no smooth field have a verdict: that of the default method, if the two agree.

use homolog_contract::parameters::{Method, preset};
use homolog_contract::result::{ReliabilityDocument, UNRELIABLE_CONFIDENCE, UnreliableReason};
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use homolog_registration::RigidTransform;
use nalgebra::{Isometry3, Point3, Rotation3, Vector3};

/// Methods of each kind: labels of an energy, rigid registration, a map of a published method.
const METHODS: [Method; 4] = [Method::Thesis, Method::Rigid, Method::Foe, Method::Cpd];

/// A spheroid, with a bump and a dent that leave one pose if `bumps`, sampled at directions rotated by `turn`, and moved.
fn spheroid(bumps: bool, turn: Vector3<f64>, motion: &Isometry3<f64>) -> SurfaceMesh {
    let sphere = ellipsoid(Vector3::new(1.0, 1.0, 1.0), 3);
    let bump =
        |n: &Vector3<f64>, at: Vector3<f64>, height: f64| height * (-(n - at.normalize()).norm_squared() / 0.15).exp();
    let at = |p: &Point3<f64>| {
        let n = Rotation3::new(turn) * p.coords.normalize();
        let radius = ((n.x / 22.0).powi(2) + (n.y / 11.0).powi(2) + (n.z / 10.9).powi(2)).powf(-0.5);
        let grown = bump(&n, Vector3::new(0.6, 0.8, 0.1), 0.35) + bump(&n, Vector3::new(-0.7, 0.1, 0.7), 0.25);
        motion * Point3::from(n * radius * (1.0 + if bumps { grown } else { 0.0 }))
    };
    sphere.with_vertices(sphere.vertices().iter().map(at).collect()).unwrap()
}

fn matched(bumps: bool, method: Method, rotation: Vector3<f64>) -> MatchOutcome {
    let source = spheroid(bumps, Vector3::zeros(), &Isometry3::identity());
    let target = spheroid(bumps, Vector3::new(0.3, -0.2, 0.5), &Isometry3::new(Vector3::new(5.0, 3.0, -8.0), rotation));
    match_surfaces(&source, &target, &preset(method), &Silent).unwrap()
}

fn verdict(found: &MatchOutcome) -> ReliabilityDocument {
    let reliability = found.reliability.clone().unwrap();
    assert_eq!(reliability.reliable, reliability.reasons.is_empty());
    assert!(reliability.second_opinion.is_some());
    reliability
}

#[test]
fn an_answer_of_any_method_is_reliable_if_its_pose_is_right() {
    let rotation = Vector3::new(0.2, -0.1, 0.15);
    let truth = RigidTransform { rotation: Rotation3::new(rotation).into_inner(), translation: Vector3::zeros() };
    let mut seen = [false; 2];
    for method in METHODS {
        let found = matched(true, method, rotation);
        let verdict = verdict(&found);
        let right = RigidTransform::of_matrix(&found.transform.matrix).angle_to(&truth).to_degrees() < 10.0;
        let reasons: &[UnreliableReason] = if right { &[] } else { &[UnreliableReason::SecondOpinion] };
        assert_eq!(verdict.reasons, reasons, "{}: {verdict:?}", method.name());
        seen[usize::from(right)] = true;
    }
    // Nearest vertices decide for a half turn here.
    assert_eq!(seen, [true; 2]);
}

#[test]
fn an_answer_in_another_pose_is_refused_and_its_confidence_lowered() {
    // Closest points from aligned centroids stay near the half turn that they begin with.
    let found = matched(true, Method::Icp, Vector3::new(0.0, 0.0, 3.0));
    let verdict = verdict(&found);
    assert_eq!(verdict.reasons, [UnreliableReason::SecondOpinion]);
    assert!(verdict.second_opinion.unwrap().angle_deg > 90.0, "{verdict:?}");
    assert!(found.correspondences.confidence.iter().all(|&confidence| confidence <= UNRELIABLE_CONFIDENCE));
}

#[test]
fn a_shape_that_fits_in_several_poses_is_refused_by_any_method() {
    for method in METHODS {
        let verdict = verdict(&matched(false, method, Vector3::new(0.2, -0.1, 0.15)));
        assert!(!verdict.reliable, "{}: {verdict:?}", method.name());
    }
}

#[test]
fn the_default_method_judges_itself() {
    let found = matched(true, Method::Balanced, Vector3::new(0.2, -0.1, 0.15));
    assert!(found.reliability.unwrap().second_opinion.is_none());
}
