//! Surfaces with symmetries: several poses fit equally well, and the answer says so.

use homolog_contract::parameters::{Method, preset};
use homolog_contract::result::UnreliableReason;
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use nalgebra::{Isometry3, Point3, Rotation3, Vector3};

/// The surface that `radius` gives over the sphere, sampled at the vertices of a sphere rotated by `turn`, and then moved.
fn sampled(radius: fn(&Vector3<f64>) -> f64, turn: Vector3<f64>, motion: &Isometry3<f64>) -> SurfaceMesh {
    let sphere = ellipsoid(Vector3::new(1.0, 1.0, 1.0), 4);
    let at = |p: &Point3<f64>| {
        let direction = Rotation3::new(turn) * p.coords.normalize();
        motion * Point3::from(direction * radius(&direction))
    };
    sphere.with_vertices(sphere.vertices().iter().map(at).collect()).unwrap()
}

/// Two samplings of one shape, and the motion from the first to the second.
fn two_samplings(radius: fn(&Vector3<f64>) -> f64) -> (SurfaceMesh, SurfaceMesh, Isometry3<f64>) {
    let source = sampled(radius, Vector3::new(0.3, -0.2, 0.5), &Isometry3::identity());
    let motion = Isometry3::new(Vector3::new(20.0, -9.0, 5.0), Vector3::new(1.1, 0.6, -1.9));
    let target = sampled(radius, Vector3::new(-0.7, 0.4, 0.1), &motion);
    (source, target, motion)
}

/// Two samplings of one shape, matched.
fn matched(radius: fn(&Vector3<f64>) -> f64) -> MatchOutcome {
    let (source, target, _) = two_samplings(radius);
    match_surfaces(&source, &target, &preset(Method::Balanced), &Silent).unwrap()
}

fn prolate(n: &Vector3<f64>) -> f64 {
    ((n.x / 22.0).powi(2) + (n.y / 11.0).powi(2) + (n.z / 11.0).powi(2)).powf(-0.5)
}

/// Three different axes: four poses, none of them a reflection, fit equally well.
fn triaxial(n: &Vector3<f64>) -> f64 {
    ((n.x / 22.0).powi(2) + (n.y / 13.0).powi(2) + (n.z / 8.0).powi(2)).powf(-0.5)
}

/// The prolate spheroid with a bump that leaves one pose.
fn with_bump(n: &Vector3<f64>) -> f64 {
    let bump = |at: Vector3<f64>, height: f64| height * (-(n - at.normalize()).norm_squared() / 0.15).exp();
    prolate(n) * (1.0 + bump(Vector3::new(0.6, 0.8, 0.1), 0.35) + bump(Vector3::new(-0.7, 0.1, 0.7), 0.25))
}

#[test]
fn samplings_of_a_symmetric_shape_have_an_ambiguous_pose() {
    for (name, shape) in [("prolate spheroid", prolate as fn(&Vector3<f64>) -> f64), ("triaxial ellipsoid", triaxial)] {
        let found = matched(shape).reliability.unwrap();
        assert!(found.reasons.contains(&UnreliableReason::AmbiguousPose), "{name}: {found:?}");
    }
}

#[test]
fn a_confidence_is_divided_among_all_poses_that_explain_the_surfaces_as_well() {
    let found = matched(triaxial);
    assert_eq!(found.poses.iter().filter(|pose| pose.as_good).count(), 3, "{:?}", found.poses);
    assert!(found.correspondences.confidence.iter().all(|&confidence| (0.1..=0.25).contains(&confidence)));
}

#[test]
fn a_shape_with_one_pose_is_reliable() {
    let found = matched(with_bump).reliability.unwrap();
    assert!(found.reliable, "{found:?}");
}

/// The prolate spheroid with one bump: all that tells a rotation about the axis.
fn with_one_bump(n: &Vector3<f64>) -> f64 {
    prolate(n) * (1.0 + 0.3 * (-(n - Vector3::new(0.4, 0.9, 0.1).normalize()).norm_squared() / 0.12).exp())
}

#[test]
fn points_of_a_copy_do_not_slide_where_the_surface_says_nothing() {
    for (name, shape) in [("one bump", with_one_bump as fn(&Vector3<f64>) -> f64), ("two bumps", with_bump)] {
        let (source, target, motion) = two_samplings(shape);
        let found = match_surfaces(&source, &target, &preset(Method::Balanced), &Silent).unwrap();
        let vertices = target.vertices();
        let pairs = found.correspondences;
        let mut total = 0.0;
        for ((&s, corners), weights) in pairs.source.iter().zip(&pairs.triangle).zip(&pairs.barycentric) {
            let point: Vector3<f64> = (0..3).map(|k| vertices[corners[k] as usize].coords * weights[k]).sum();
            total += (Point3::from(point) - motion * source.vertices()[s as usize]).norm();
        }
        let error = total / pairs.source.len() as f64 / target.mean_edge_length();
        assert!(error < 0.15, "{name}: {error} edges");
    }
}
