//! Surfaces that no rigid motion brings close to each other: bent, folded, with limbs moved.

use homolog_contract::parameters::{Bending, Method, preset};
use homolog_contract::result::{PoseOrigin, UnreliableReason};
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::repair::reversed;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use nalgebra::{Isometry3, Point3, Rotation3, Vector3};

/// A long surface with bumps and ridges that break its symmetries.
fn straight() -> SurfaceMesh {
    shaped(&ellipsoid(Vector3::new(24.0, 6.0, 5.0), 4))
}

/// The same surface with its vertices at other places.
fn sampled_again() -> SurfaceMesh {
    let sphere = ellipsoid(Vector3::new(1.0, 1.0, 1.0), 4);
    let turn = Rotation3::new(Vector3::new(0.7, -0.4, 1.1));
    let place = |p: &Point3<f64>| Point3::from((turn * p.coords).component_mul(&Vector3::new(24.0, 6.0, 5.0)));
    shaped(&sphere.with_vertices(sphere.vertices().iter().map(place).collect()).unwrap())
}

/// An ellipsoid with the bumps and ridges.
fn shaped(mesh: &SurfaceMesh) -> SurfaceMesh {
    let bumps = [(-17.0, 0.4, 0.30), (-8.0, 2.6, 0.25), (2.0, 4.5, 0.28), (11.0, 1.4, 0.22), (18.0, 3.5, 0.35)];
    let shaped = |p: &Point3<f64>| {
        let angle = (p.z / 5.0).atan2(p.y / 6.0);
        let bump = |&(x, at, height): &(f64, f64, f64)| {
            let around = (angle - at).sin().atan2((angle - at).cos());
            height * (-((p.x - x).powi(2) / 18.0 + around * around / 0.5)).exp()
        };
        let width = 1.0 + bumps.iter().map(bump).sum::<f64>() + 0.01 * p.x;
        Point3::new(p.x, p.y * width, p.z * width)
    };
    mesh.with_vertices(mesh.vertices().iter().map(shaped).collect()).unwrap()
}

/// The surface with its middle part on an arc of `degrees`, moved rigidly; vertex by vertex.
fn bent(mesh: &SurfaceMesh, degrees: f64) -> SurfaceMesh {
    let half = degrees.to_radians() / 2.0;
    let radius = 13.0 / half;
    let motion = Isometry3::new(Vector3::new(30.0, -7.0, 4.0), Vector3::new(0.4, 1.9, -0.7));
    let on_arc = |p: &Point3<f64>| {
        let phi = (p.x / radius).clamp(-half, half);
        let rest = p.x - radius * phi;
        let along = Vector3::new(phi.cos(), phi.sin(), 0.0);
        let across = Vector3::new(-phi.sin(), phi.cos(), 0.0);
        motion
            * Point3::from(Vector3::new(0.0, radius, 0.0) + across * (p.y - radius) + along * rest + Vector3::z() * p.z)
    };
    mesh.with_vertices(mesh.vertices().iter().map(on_arc).collect()).unwrap()
}

fn matched(source: &SurfaceMesh, target: &SurfaceMesh) -> MatchOutcome {
    matched_by(Bending::NearIsometry, source, target)
}

fn matched_by(bending: Bending, source: &SurfaceMesh, target: &SurfaceMesh) -> MatchOutcome {
    let mut parameters = preset(Method::Balanced);
    parameters.displacement.bending = bending;
    match_surfaces(source, target, &parameters, &Silent).unwrap()
}

/// Mean distance of the target vertices found from the true ones, in roots of the area.
fn mean_error(found: &MatchOutcome, target: &SurfaceMesh) -> f64 {
    let v = target.vertices();
    let away = |(&i, &x): (&u32, &u32)| (v[x as usize] - v[i as usize]).norm();
    let pairs = found.correspondences.source.iter().zip(&found.correspondences.target);
    pairs.map(away).sum::<f64>() / v.len() as f64 / target.area().sqrt()
}

#[test]
fn a_tube_folded_by_150_degrees_is_matched_straightened() {
    let source = straight();
    let target = bent(&source, 150.0);
    for bending in [Bending::Straightened, Bending::NearIsometry] {
        let found = matched_by(bending, &source, &target);
        let error = mean_error(&found, &target);
        let first = &found.poses[0];
        // Half of what was asked of the bending-invariant form before, 0.05.
        assert!(first.origin == PoseOrigin::Form && error < 0.025, "{:?} {error}", first.origin);
        assert!(found.reliability.as_ref().unwrap().reliable, "{:?}", found.reliability);
    }
    let rigid = matched_by(Bending::None, &source, &target);
    assert!(rigid.poses.iter().all(|pose| pose.origin != PoseOrigin::Form));
    // Repeated from its rigid part, the fit without bending finds it too, and distorts more: 0.29 in place of 0.06.
    assert!(mean_error(&rigid, &target) < 0.025, "{}", mean_error(&rigid, &target));
    assert!(rigid.reliability.as_ref().unwrap().distortion > Some(0.2), "{:?}", rigid.reliability);
}

#[test]
fn a_tube_that_is_folded_and_mirrored_is_of_the_other_handedness() {
    let source = straight();
    let mirrored = |p: &Point3<f64>| Point3::new(p.x, p.y, -p.z);
    let flipped = reversed(&source.with_vertices(source.vertices().iter().map(mirrored).collect()).unwrap());
    let found = matched(&source, &bent(&flipped, 150.0)).reliability.unwrap();
    assert!(!found.reliable && found.reasons.contains(&UnreliableReason::OtherHandedness), "{found:?}");
}

#[test]
fn a_tube_of_one_shape_that_is_bent_by_110_degrees_is_matched_straightened_too() {
    let source = straight();
    let target = bent(&source, 110.0);
    let [rigid, found] = [Bending::None, Bending::Straightened].map(|bending| matched_by(bending, &source, &target));
    assert!(rigid.reliability.as_ref().unwrap().reliable, "{:?}", rigid.reliability);
    assert_eq!(found.poses[0].origin, PoseOrigin::Form);
    let [before, after] = [&rigid, &found].map(|found| mean_error(found, &target));
    assert!(after < before, "{after} {before}");
}

#[test]
fn confidences_of_a_folded_surface_are_near_the_share_within_an_edge() {
    let source = straight();
    let (target, images) = (bent(&sampled_again(), 150.0), bent(&source, 150.0));
    let found = matched(&source, &target);
    let table = &found.correspondences;
    let edge = target.mean_edge_length();
    let near = |(&i, &x): (&u32, &u32)| (target.vertices()[x as usize] - images.vertices()[i as usize]).norm() <= edge;
    let n = source.n_vertices() as f64;
    let share = table.source.iter().zip(&table.target).filter(|&pair| near(pair)).count() as f64 / n;
    let mean = table.confidence.iter().sum::<f64>() / n;
    assert_eq!(found.poses[0].origin, PoseOrigin::Form);
    // Capsules are within 0.03. No surface that was looked at is further off than this one, whose bumps agree all the better when
    // they are bent: its error of 0.08 is a known limit (docs/method.md).
    assert!((mean - share).abs() < 0.1, "{mean} {share}");
}

#[test]
fn a_folded_surface_is_matched_to_the_bit_at_any_size_and_on_any_number_of_threads() {
    let source = straight();
    let target = bent(&source, 150.0);
    let found = matched(&source, &target);
    let factor = 2f64.powi(-9);
    let scaled = |mesh: &SurfaceMesh| mesh.with_vertices(mesh.vertices().iter().map(|p| p * factor).collect()).unwrap();
    let small = matched(&scaled(&source), &scaled(&target));
    assert_eq!(small.correspondences.target, found.correspondences.target);
    assert_eq!(small.correspondences.barycentric, found.correspondences.barycentric);
    assert_eq!(small.correspondences.confidence, found.correspondences.confidence);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let alone = one.install(|| matched(&source, &target));
    assert_eq!(alone.correspondences, found.correspondences);
    assert_eq!(alone.transform, found.transform);
}

#[test]
fn surfaces_that_agree_from_a_rigid_start_need_no_form() {
    let source = straight();
    let target = bent(&source, 20.0);
    let found = matched(&source, &target);
    assert!(found.poses.iter().all(|pose| pose.origin != PoseOrigin::Form));
    let error = mean_error(&found, &target);
    assert!(error < 0.03, "{error}");
}
