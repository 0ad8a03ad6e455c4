//! Surfaces with symmetries: several poses fit equally well, and the answer says so.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

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

/// Two samplings of one shape, matched.
fn matched(radius: fn(&Vector3<f64>) -> f64) -> MatchOutcome {
    let source = sampled(radius, Vector3::new(0.3, -0.2, 0.5), &Isometry3::identity());
    let motion = Isometry3::new(Vector3::new(20.0, -9.0, 5.0), Vector3::new(1.1, 0.6, -1.9));
    let target = sampled(radius, Vector3::new(-0.7, 0.4, 0.1), &motion);
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
fn a_shape_with_one_pose_is_reliable() {
    let found = matched(with_bump).reliability.unwrap();
    assert!(found.reliable, "{found:?}");
}
