//! A part of a structure, open where it was cut, and the whole.

use homolog_contract::parameters::{Method, preset};
use homolog_contract::result::UnreliableReason;
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_mesh::repair::drop_unused;
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Vector3};
use std::f64::consts::FRAC_PI_2;

fn mapped(mesh: &SurfaceMesh, map: impl Fn(&Point3<f64>) -> Point3<f64>) -> SurfaceMesh {
    mesh.with_vertices(mesh.vertices().iter().map(map).collect()).unwrap()
}

/// A long surface with bumps that break its symmetries, of the vertices of a sphere that was turned by `turn`.
fn whole(turn: &Rotation3<f64>) -> SurfaceMesh {
    let bumps = [(-17.0, 0.4, 0.45), (-8.0, 2.6, 0.4), (2.0, 4.5, 0.45), (11.0, 1.4, 0.35), (18.0, 3.5, 0.5)];
    mapped(&ellipsoid(Vector3::repeat(1.0), 4), |p| {
        let p = (turn * p.coords).component_mul(&Vector3::new(24.0, 6.0, 5.0));
        let angle = (p.z / 5.0).atan2(p.y / 6.0);
        let bump = |&(x, at, height): &(f64, f64, f64)| {
            let around = (angle - at).sin().atan2((angle - at).cos());
            height * (-((p.x - x).powi(2) / 18.0 + around * around / 0.5)).exp()
        };
        let width = 1.0 + bumps.iter().map(bump).sum::<f64>() + 0.012 * p.x;
        Point3::new(p.x, p.y * width + 0.012 * p.x * p.x, p.z * width)
    })
}

/// The faces of `mesh` whose corners all have `keep`, without the vertices that they do not use.
fn only(mesh: &SurfaceMesh, keep: impl Fn(&Point3<f64>) -> bool) -> SurfaceMesh {
    let is_kept = |corners: &[u32; 3]| corners.iter().all(|&v| keep(&mesh.vertices()[v as usize]));
    let faces: Vec<[u32; 3]> = mesh.triangles().into_iter().filter(is_kept).collect();
    let kept = SurfaceMesh::new(mesh.vertices().to_vec(), FaceArity::Triangle, faces.into_flattened()).unwrap();
    drop_unused(&kept).mesh
}

fn motion() -> Isometry3<f64> {
    Isometry3::new(Vector3::new(30.0, -7.0, 4.0), Vector3::new(0.4, 1.9, -0.7))
}

fn matched(source: &SurfaceMesh, target: &SurfaceMesh) -> MatchOutcome {
    match_surfaces(source, target, &preset(Method::Balanced), &Silent).unwrap()
}

fn degrees(found: &MatchOutcome, truth: &Rotation3<f64>) -> f64 {
    let m = found.transform.matrix;
    Rotation3::from_matrix_unchecked(Matrix3::from_fn(|i, j| m[i][j])).angle_to(truth).to_degrees()
}

#[test]
fn an_end_or_a_half_is_found_on_the_whole_of_another_sampling_and_the_whole_on_it() {
    let one = whole(&Rotation3::identity());
    let other = mapped(&whole(&Rotation3::new(Vector3::new(0.7, -0.4, 1.1))), |p| motion() * p);
    let truth = motion().rotation.to_rotation_matrix();
    for (name, keep) in [("right end", 9.0..30.0), ("left end", -30.0..-9.0), ("half", 0.0..30.0)] {
        let part = only(&one, |p| keep.contains(&p.x));
        assert!(part.boundary_vertices().is_some() && part.area() < 0.6 * one.area(), "{name}");
        for (found, truth) in [(matched(&part, &other), truth), (matched(&other, &part), truth.inverse())] {
            let off = degrees(&found, &truth);
            assert!(off < 2.0, "{name}: {off} degrees");
            let reliability = found.reliability.as_ref().unwrap();
            assert!(reliability.reliable, "{name}: {reliability:?}");
            assert!(found.transform.similarity.is_none(), "{name}: a part has its own size");
        }
    }
}

#[test]
fn a_part_that_fits_in_several_places_is_ambiguous() {
    // A tube without features: its middle fits anywhere along it, and turned about its axis.
    let tube = |turn: f64| {
        let sphere = ellipsoid(Vector3::repeat(1.0), 4);
        let turn = Rotation3::new(Vector3::new(turn, 0.2 * turn, -turn));
        mapped(&sphere, |p| {
            let p = turn * p;
            Point3::new(24.0 * p.x, 5.0 * p.y, 5.0 * p.z)
        })
    };
    let middle = only(&tube(0.0), |p| p.x.abs() < 7.0);
    let found = matched(&middle, &tube(0.9));
    assert!(!found.reliability.as_ref().unwrap().reliable, "{:?}", found.reliability);
}

#[test]
fn a_part_that_fits_in_several_places_of_one_orientation_is_ambiguous() {
    // A rod with a ridge along it: its middle fits in one orientation, anywhere along it.
    let rod = |turn: f64| {
        let sphere = ellipsoid(Vector3::repeat(1.0), 4);
        let turn = Rotation3::new(Vector3::new(turn, 0.2 * turn, -turn));
        mapped(&sphere, |p| {
            let p = turn * p;
            let x = 26.0 * p.x.clamp(-1.0, 1.0).asin() / FRAC_PI_2;
            let round = (1.0 - ((x.abs() - 20.0) / 6.0).max(0.0).powi(2)).max(0.0).sqrt();
            let angle = p.z.atan2(p.y);
            let ridge = 1.0 + 0.5 * (-(angle / 0.5).powi(2)).exp() + 0.2 * (-((angle - 2.0) / 0.4).powi(2)).exp();
            // The axes differ at its ends, so that it has a front and a back.
            let ends = if x > 20.0 { 1.0 + 0.04 * (x - 20.0) } else { 1.0 };
            Point3::new(x, 5.0 * round * ridge * ends * angle.cos(), 5.0 * round * ridge * angle.sin())
        })
    };
    let middle = only(&rod(0.0), |p| (-12.0..4.0).contains(&p.x));
    let whole = mapped(&rod(0.9), |p| motion() * p);
    for found in [matched(&middle, &whole), matched(&whole, &middle)] {
        let reliability = found.reliability.as_ref().unwrap();
        assert!(reliability.reasons.contains(&UnreliableReason::AmbiguousPose), "{reliability:?}");
    }
}

#[test]
fn what_lies_beyond_the_rim_has_no_counterpart() {
    let one = whole(&Rotation3::identity());
    let target = only(&mapped(&one, |p| *p), |p| p.x < 8.0);
    let found = matched(&one, &target);
    let rows = found.correspondences.source.iter().zip(&found.correspondences.confidence);
    let far = |range: std::ops::Range<f64>| {
        let of: Vec<f64> =
            rows.clone().filter(|(i, _)| range.contains(&one.vertices()[**i as usize].x)).map(|(_, c)| *c).collect();
        of.iter().sum::<f64>() / of.len() as f64
    };
    assert!(far(-30.0..6.0) > 0.9 && far(12.0..30.0) < 0.01, "{} {}", far(-30.0..6.0), far(12.0..30.0));
}
