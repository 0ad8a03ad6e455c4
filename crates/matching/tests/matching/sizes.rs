//! Surfaces of unlike sizes: of one shape, and a part with the whole.

use homolog_contract::parameters::{Landmark, Method, preset};
use homolog_geometry::curvature::vertex_areas;
use homolog_matching::{MatchOutcome, match_surfaces};
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};

fn mapped(mesh: &SurfaceMesh, map: impl Fn(&Point3<f64>) -> Point3<f64>) -> SurfaceMesh {
    mesh.with_vertices(mesh.vertices().iter().map(map).collect()).unwrap()
}

const LENGTH: f64 = 18.0;

fn rounded() -> SurfaceMesh {
    ellipsoid(Vector3::new(LENGTH, 8.0, 6.0), 4)
}

/// A bent and tapered ellipsoid without symmetry.
fn bean() -> SurfaceMesh {
    bent(&rounded())
}

fn bent(mesh: &SurfaceMesh) -> SurfaceMesh {
    mapped(mesh, |p| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + 0.02 * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    })
}

fn motion() -> Isometry3<f64> {
    Isometry3::new(Vector3::new(30.0, -7.0, 4.0), Vector3::new(0.4, 1.9, -0.7))
}

/// A smooth deformation of `mesh`, moved rigidly.
fn deformed(mesh: &SurfaceMesh) -> SurfaceMesh {
    mapped(mesh, |p| {
        let by = Vector3::new(0.8 * (0.1 * p.y).sin(), 0.9 * (0.12 * p.x).sin(), 0.7 * (0.15 * p.x).cos());
        motion() * (p + by)
    })
}

fn scaled(mesh: &SurfaceMesh, factor: f64) -> SurfaceMesh {
    mapped(mesh, |p| p * factor)
}

fn matched(source: &SurfaceMesh, target: &SurfaceMesh) -> MatchOutcome {
    match_surfaces(source, target, &preset(Method::Balanced), &Silent).unwrap()
}

/// Share of the images, vertex by vertex, within one edge of the target vertex of the same number.
fn within_an_edge(found: &MatchOutcome, target: &SurfaceMesh) -> f64 {
    let (table, v) = (&found.correspondences, target.vertices());
    let image = |i: usize| {
        let of = |k: usize| v[table.triangle[i][k] as usize].coords * table.barycentric[i][k];
        Point3::from(of(0) + of(1) + of(2))
    };
    let near = |i: &usize| (image(*i) - v[table.source[*i] as usize]).norm() <= target.mean_edge_length();
    (0..v.len()).filter(near).count() as f64 / v.len() as f64
}

#[test]
fn a_deformed_copy_of_any_size_is_matched_at_the_size_of_the_target() {
    let source = bean();
    let target = deformed(&source);
    for size in [0.4, 2.5] {
        let of_another_size = scaled(&source, size);
        let found = matched(&of_another_size, &target);
        let similarity = found.transform.similarity.as_ref().unwrap();
        assert!((similarity.scale * size - 1.0).abs() < 0.03, "{}", similarity.scale);
        let reliability = found.reliability.as_ref().unwrap();
        assert!(reliability.reliable, "{reliability:?}");
        assert!(within_an_edge(&found, &target) > 0.95, "{}", within_an_edge(&found, &target));
        // Rigid, and the rotation of the truth.
        let m = found.transform.matrix;
        let rotation = Matrix3::from_fn(|i, j| m[i][j]);
        assert!((rotation * rotation.transpose() - Matrix3::identity()).norm() < 1e-9);
        let truth = motion().rotation.to_rotation_matrix();
        let angle = nalgebra::Rotation3::from_matrix_unchecked(rotation).angle_to(&truth);
        assert!(angle.to_degrees() < 5.0, "{}", angle.to_degrees());
        // The center of the area of the source comes to lie on that of the target.
        let middle = |mesh: &SurfaceMesh| {
            let areas = vertex_areas(mesh);
            let sum = mesh.vertices().iter().zip(&areas).fold(Vector3::zeros(), |s, (p, &a)| s + p.coords * a);
            sum / areas.iter().sum::<f64>()
        };
        let translation = Vector3::from_fn(|i, _| m[i][3]);
        let off = (rotation * middle(&of_another_size) + translation - middle(&target)).norm();
        assert!(off < 0.02 * target.area().sqrt(), "{off}");
        // Poses are rigid as well.
        for pose in &found.poses {
            let r = Matrix3::from_fn(|i, j| pose.matrix[i][j]);
            assert!((r * r.transpose() - Matrix3::identity()).norm() < 1e-9);
        }
    }
}

#[test]
fn a_part_stays_at_its_size() {
    let whole = bean();
    let target = deformed(&whole);
    let kept = |t: &[u32; 3]| t.iter().all(|&k| whole.vertices()[k as usize].x > 3.0);
    let faces: Vec<u32> = whole.triangles().into_iter().filter(kept).flatten().collect();
    let part = SurfaceMesh::new(whole.vertices().to_vec(), FaceArity::Triangle, faces).unwrap();
    assert!(target.area().sqrt() > 1.25 * part.area().sqrt(), "else there is nothing to decide");
    let found = matched(&part, &target);
    assert!(found.transform.similarity.is_none());
}

/// The part of [`bean`] beyond the plane `x = cut`, which closes it.
fn closed_part(cut: f64) -> SurfaceMesh {
    let radius = |x: f64| (1.0 - (x / LENGTH).powi(2)).max(0.0).sqrt();
    bent(&mapped(&rounded(), |p| {
        if p.x >= cut {
            return *p;
        }
        // The rest is pressed into the plane, its pole at the center.
        let to = radius(cut) * (p.x + LENGTH) / (cut + LENGTH) / radius(p.x).max(1e-9);
        Point3::new(cut, to * p.y, to * p.z)
    }))
}

#[test]
fn a_closed_part_is_more_alike_at_its_size() {
    let target = deformed(&bean());
    for cut in [1.0, 4.0] {
        let part = closed_part(cut);
        assert!(target.area().sqrt() > 1.25 * part.area().sqrt(), "else there is nothing to decide");
        let found = matched(&part, &target);
        assert!(found.transform.similarity.is_none(), "{cut}");
    }
}

#[test]
fn an_answer_at_another_size_scales_to_the_bit() {
    let source = scaled(&bean(), 1.9);
    let target = deformed(&bean());
    let found = matched(&source, &target);
    assert!(found.transform.similarity.is_some());
    let factor = 2f64.powi(-8);
    let small = matched(&scaled(&source, factor), &scaled(&target, factor));
    let [a, b] = [&found, &small].map(|found| &found.correspondences);
    assert_eq!(a.target, b.target);
    assert_eq!(a.barycentric, b.barycentric);
    assert_eq!(a.confidence, b.confidence);
    let scale = |found: &MatchOutcome| found.transform.similarity.as_ref().unwrap().scale;
    assert_eq!(scale(&found), scale(&small));
}

#[test]
fn renumbering_the_source_permutes_an_answer_at_another_size() {
    let source = scaled(&bean(), 1.9);
    let target = deformed(&bean());
    let n = source.n_vertices() as u32;
    // Its vertices in the opposite order.
    let vertices = source.vertices().iter().rev().copied().collect();
    let faces = source.triangles().into_iter().flatten().map(|k| n - 1 - k).collect();
    let reversed = SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap();
    let [found, other] = [&source, &reversed].map(|source| matched(source, &target));
    assert!(found.transform.similarity.is_some());
    let mut targets = other.correspondences.target.clone();
    targets.reverse();
    assert_eq!(found.correspondences.target, targets);
}

#[test]
fn landmarks_are_given_at_the_size_of_the_source() {
    let plain = bean();
    let (source, target) = (scaled(&plain, 1.9), deformed(&plain));
    let mut parameters = preset(Method::Balanced);
    let at = |i: usize| Landmark {
        source_mm: source.vertices()[i].coords.into(),
        target_mm: target.vertices()[i].coords.into(),
        sigma_mm: 0.05,
    };
    let given = [5usize, 400, 1500, 2300];
    parameters.landmarks = given.iter().map(|&i| at(i)).collect();
    let found = match_surfaces(&source, &target, &parameters, &Silent).unwrap();
    assert!(found.transform.similarity.is_some());
    for i in given {
        let off = (target.vertices()[found.correspondences.target[i] as usize] - target.vertices()[i]).norm();
        assert!(off <= target.mean_edge_length(), "{i}: {off}");
    }
}
