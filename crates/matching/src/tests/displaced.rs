//! Additions of a displacement field to a match: images between vertices, the inverse map, reliability.

use super::displacement::lopsided_bean;
use super::{bean, motion};
use crate::{MatchOutcome, match_surfaces};
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_contract::result::{OutlierReason, UnreliableReason};
use homolog_mesh::{FaceArity, SurfaceMesh, repair};
use homolog_primitives::observe::Silent;
use nalgebra::{Matrix4, Point3, Vector3};
use serde_json::{Value, json};

fn run(source: &SurfaceMesh, target: &SurfaceMesh, request: Value) -> MatchOutcome {
    let parameters: MatchParameters = resolve(&request).unwrap();
    match_surfaces(source, target, &parameters, &Silent).unwrap()
}

/// The target point of row `k` of the correspondences.
fn point(target: &SurfaceMesh, triangle: [u32; 3], weights: [f64; 3]) -> Point3<f64> {
    let corners = triangle.map(|c| target.vertices()[c as usize].coords);
    Point3::from(corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2])
}

fn bent(p: &Point3<f64>) -> Point3<f64> {
    Point3::new(p.x, p.y + 1.5 * (0.12 * p.x).sin(), p.z + 1.0 * (0.1 * p.x).cos())
}

#[test]
fn images_lie_between_vertices_and_the_map_back_inverts_the_map() {
    let source = bean();
    let images: Vec<_> = source.vertices().iter().map(|p| motion() * bent(p)).collect();
    let target = source.with_vertices(images.clone()).unwrap();
    let outcome = run(&source, &target, json!({"both_directions": true}));
    let found = &outcome.correspondences;
    let edge = target.mean_edge_length();
    let mut sum = 0.0;
    for (i, image) in images.iter().enumerate() {
        let weights = found.barycentric[i];
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9 && weights.iter().all(|w| *w >= -1e-9), "{weights:?}");
        sum += (point(&target, found.triangle[i], weights) - image).norm();
    }
    let mean = sum / images.len() as f64;
    assert!(mean < 0.5 * edge, "{mean} mm, an edge is {edge} mm");
    let inverse = found.inverse.as_ref().unwrap();
    assert_eq!(inverse.source.len(), target.n_vertices());
    // From a target vertex to the source, and back by the images of the corners of that triangle.
    let back: f64 = (0..target.n_vertices())
        .map(|j| (point(&source, inverse.triangle[j], inverse.barycentric[j]) - source.vertices()[j]).norm())
        .sum::<f64>()
        / target.n_vertices() as f64;
    assert!(back < 0.5 * edge, "{back} mm");
    let reliability = outcome.reliability.unwrap();
    assert!(reliability.reliable, "{reliability:?}");
}

#[test]
fn a_match_with_a_mirrored_target_is_reported_as_unreliable() {
    let source = lopsided_bean();
    let mirror = Matrix4::new_nonuniform_scaling(&Vector3::new(-1.0, 1.0, 1.0));
    let mirrored = source.moved(&std::array::from_fn(|r| std::array::from_fn(|c| mirror[(r, c)]))).unwrap();
    let reliability = run(&source, &mirrored, json!({})).reliability.unwrap();
    assert!(!reliability.reliable, "{reliability:?}");
    assert!(reliability.reasons.contains(&UnreliableReason::OtherHandedness), "{reliability:?}");
    let allowed = run(&source, &mirrored, json!({"registration": {"allow_reflection": true}}));
    assert!(allowed.reliability.unwrap().reliable);
    assert!(allowed.surface_distance.max_mm < 0.2, "{}", allowed.surface_distance.max_mm);
}

#[test]
fn vertices_beyond_the_end_of_an_open_target_have_no_counterpart() {
    let source = bean();
    let (low, high) = source.bounding_box();
    let limit = high.x - 0.2 * (high.x - low.x);
    let kept: Vec<u32> = source
        .triangles()
        .into_iter()
        .filter(|t| t.iter().all(|&k| source.vertices()[k as usize].x < limit))
        .flatten()
        .collect();
    let cut = SurfaceMesh::new(source.vertices().to_vec(), FaceArity::Triangle, kept).unwrap();
    let cut = repair::drop_unused(&cut).mesh.transformed(&motion());
    let outcome = run(&source, &cut, json!({}));
    let edge = source.mean_edge_length();
    let (mut beyond, mut within) = ((0, 0), (0, 0));
    for (p, reason) in source.vertices().iter().zip(&outcome.correspondences.outlier) {
        let alone = usize::from(*reason == OutlierReason::NoCounterpart);
        // Near the rim both are acceptable.
        if p.x > limit + 3.0 * edge {
            beyond = (beyond.0 + alone, beyond.1 + 1);
        } else if p.x < limit - 3.0 * edge {
            within = (within.0 + alone, within.1 + 1);
        }
    }
    assert!(beyond.1 > 20 && beyond.0 as f64 > 0.8 * beyond.1 as f64, "{beyond:?}");
    assert!((within.0 as f64) < 0.02 * within.1 as f64, "{within:?}");
}

#[test]
fn landmarks_decide_between_poses_that_fit_equally_well() {
    // An ellipsoid also fits after half a turn about its long axis.
    let source = homolog_mesh::shapes::ellipsoid(Vector3::new(16.0, 8.0, 6.0), 3);
    let target = source.transformed(&motion());
    let landmark = |p: [f64; 3]| json!({"source_mm": p, "target_mm": (motion() * Point3::from(p)).coords.as_slice()});
    let given = [[16.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 6.0], [-16.0, 0.0, 0.0]].map(landmark);
    let outcome = run(&source, &target, json!({"landmarks": given}));
    let found = Matrix4::from_fn(|r, c| outcome.transform.matrix[r][c]);
    for p in source.vertices() {
        assert!((found.transform_point(p) - motion() * p).norm() < 0.5);
    }
    let free = run(&source, &target, json!({})).reliability.unwrap();
    assert!(free.reasons.contains(&UnreliableReason::AmbiguousPose), "{free:?}");
}

#[test]
fn a_coarse_level_gives_the_answer_of_all_vertices() {
    let source = bean();
    let images: Vec<_> = source.vertices().iter().map(|p| motion() * bent(p)).collect();
    let target = source.with_vertices(images).unwrap();
    let of = |n: Value| run(&source, &target, json!({"inference": {"coarse_vertices": n}}));
    let (coarse, direct) = (of(json!(200)), of(Value::Null));
    let (a, b) = (coarse.energy.unwrap(), direct.energy.unwrap());
    assert!(a.n_variables <= 200 && a.n_target_vertices <= 200, "{a:?}");
    assert_eq!(b.n_variables as usize, source.n_vertices());
    let edge = target.mean_edge_length();
    let images =
        |o: &homolog_contract::result::Correspondences, i: usize| point(&target, o.triangle[i], o.barycentric[i]);
    for i in 0..source.n_vertices() {
        let apart = (images(&coarse.correspondences, i) - images(&direct.correspondences, i)).norm();
        assert!(apart < edge, "{apart} mm");
    }
}
