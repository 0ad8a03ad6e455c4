//! An answer does not depend on the unit of length: scaling both inputs by a power of two scales it to the bit.

use homolog_contract::parameters::{Method, preset};
use homolog_contract::result::Correspondences;
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use nalgebra::{Isometry3, Point3, Vector3};

/// A bent and tapered ellipsoid without symmetry.
fn bean(level: u32) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
    let bent = |p: &Point3<f64>| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + 0.02 * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    };
    mesh.with_vertices(mesh.vertices().iter().map(bent).collect()).unwrap()
}

/// A smooth deformation of `mesh`, and a narrow one, moved rigidly.
fn deformed(mesh: &SurfaceMesh) -> SurfaceMesh {
    let motion = Isometry3::new(Vector3::new(30.0, -7.0, 4.0), Vector3::new(0.4, 1.9, -0.7));
    let moved = |p: &Point3<f64>| {
        let wide = Vector3::new(0.8 * (0.1 * p.y).sin(), 0.9 * (0.12 * p.x).sin(), 0.7 * (0.15 * p.x).cos());
        let narrow = Vector3::new((1.1 * p.y).sin(), (0.9 * p.x).cos(), (1.0 * p.x).sin()) * 0.4;
        motion * (p + wide + narrow)
    };
    mesh.with_vertices(mesh.vertices().iter().map(moved).collect()).unwrap()
}

fn scaled(mesh: &SurfaceMesh, factor: f64) -> SurfaceMesh {
    mesh.with_vertices(mesh.vertices().iter().map(|p| p * factor).collect()).unwrap()
}

fn matched(method: Method, pair: &[SurfaceMesh; 2], factor: f64) -> MatchOutcome {
    let [source, target] = pair.each_ref().map(|mesh| scaled(mesh, factor));
    match_surfaces(&source, &target, &preset(method), &Silent).unwrap()
}

fn check(of_unit: &MatchOutcome, found: &MatchOutcome, factor: f64, what: &str) {
    let (a, b): (&Correspondences, &Correspondences) = (&of_unit.correspondences, &found.correspondences);
    assert_eq!(a.target, b.target, "{what}: target");
    assert_eq!(a.triangle, b.triangle, "{what}: triangle");
    assert_eq!(a.barycentric, b.barycentric, "{what}: barycentric");
    assert_eq!(a.confidence, b.confidence, "{what}: confidence");
    assert_eq!(a.inlier, b.inlier, "{what}: inlier");
    let spread: Vec<f64> = a.spread_mm.iter().map(|s| s * factor).collect();
    assert_eq!(spread, b.spread_mm, "{what}: spread_mm");
    for (row, of_unit) in found.transform.matrix.iter().zip(&of_unit.transform.matrix).take(3) {
        assert_eq!(row[..3], of_unit[..3], "{what}: rotation");
        assert_eq!(row[3], of_unit[3] * factor, "{what}: translation");
    }
    assert_eq!(found.surface_distance.max_mm, of_unit.surface_distance.max_mm * factor, "{what}: surface distance");
    let reasons = |outcome: &MatchOutcome| outcome.reliability.as_ref().map(|r| (r.reliable, r.reasons.clone()));
    assert_eq!(reasons(found), reasons(of_unit), "{what}: reliability");
}

#[test]
fn scaling_by_powers_of_two_scales_every_answer_to_the_bit() {
    let coarse = bean(3);
    let pair = [coarse.clone(), deformed(&coarse)];
    for method in Method::ALL {
        let of_unit = matched(method, &pair, 1.0);
        for power in [-10, 7] {
            let factor = 2f64.powi(power);
            check(&of_unit, &matched(method, &pair, factor), factor, &format!("{} at 2^{power}", method.name()));
        }
    }
}

#[test]
fn the_default_scales_on_surfaces_with_coarse_levels_and_with_a_boundary() {
    let whole = bean(4);
    let open = {
        let faces: Vec<u32> = whole
            .triangles()
            .into_iter()
            .filter(|t| t.iter().all(|&k| whole.vertices()[k as usize].x < 14.0))
            .flatten()
            .collect();
        SurfaceMesh::new(whole.vertices().to_vec(), homolog_mesh::FaceArity::Triangle, faces).unwrap()
    };
    let target = deformed(&whole);
    for (source, what) in [(&whole, "closed"), (&open, "open")] {
        let pair = [source.clone(), target.clone()];
        let of_unit = matched(Method::Balanced, &pair, 1.0);
        for power in [-7, 9] {
            let factor = 2f64.powi(power);
            check(&of_unit, &matched(Method::Balanced, &pair, factor), factor, &format!("{what} at 2^{power}"));
        }
    }
}

#[test]
fn scaling_by_other_factors_changes_an_answer_by_rounding_alone() {
    let mesh = bean(4);
    let pair = [mesh.clone(), deformed(&mesh)];
    let of_unit = matched(Method::Balanced, &pair, 1.0);
    for factor in [0.001, 0.3, 1000.0] {
        let found = matched(Method::Balanced, &pair, factor);
        let labels = of_unit.correspondences.target.iter().zip(&found.correspondences.target);
        let same = labels.filter(|(a, b)| a == b).count();
        assert!(same * 1000 >= mesh.n_vertices() * 999, "{factor}: {same} of {}", mesh.n_vertices());
        let linear = |o: &MatchOutcome| nalgebra::Matrix3::from_fn(|i, k| o.transform.matrix[i][k]);
        assert!((linear(&found) - linear(&of_unit)).norm() < 1e-6, "{factor}");
    }
}
