//! Laws of displacement on a bean-shaped surface.

use crate::MatchError;
use crate::answer::displacement::DisplacementAnswer;
use crate::field::options::{DisplacementOptions, StageSettings};
use crate::field::route;
use crate::pair::lengths::Lengths;
use crate::pair::surfaces::Surfaces;
use crate::poses::compared::Origin;
use crate::starts::start_pose::StartPose;
use crate::surface::side::SurfaceLevel;
use crate::testing::numbers;
use homolog_mesh::shapes::ellipsoid;
use homolog_mesh::{CanonicalMesh, ClosestPointIndex, FaceArity, SurfaceMesh, canonicalize};
use homolog_primitives::observe::{Observer, Silent};
use homolog_registration::{RigidTransform, absolute_orientation, principal_axis_poses};
use nalgebra::{Point3, Rotation3, Vector3};

/// The displacement of `source` fitted on all its vertices.
fn displace(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    poses: &[RigidTransform],
    options: &DisplacementOptions,
    observer: &dyn Observer,
) -> Result<Option<DisplacementAnswer>, MatchError> {
    let starts: Vec<_> = poses.iter().map(|&pose| StartPose::of(pose)).collect();
    displace_from(source, target, &starts, options, observer)
}

fn displace_from(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    starts: &[StartPose],
    options: &DisplacementOptions,
    observer: &dyn Observer,
) -> Result<Option<DisplacementAnswer>, MatchError> {
    let surfaces = Surfaces {
        source,
        target,
        full_source: source,
        full_target: target,
        source_closest: &ClosestPointIndex::new(source),
        target_closest: &ClosestPointIndex::new(target),
        landmarks: &[],
        part: None,
        open: [source, target].iter().any(|mesh| mesh.boundary_vertices().is_some()),
        lengths: Lengths::of(&SurfaceLevel::new(source), &SurfaceLevel::new(target)),
        bending: homolog_contract::parameters::Bending::None,
        side_of: &|_| None,
    };
    let fitted = route::displace(&surfaces, surfaces.smoothed()?, starts, true, options, observer, None)?;
    Ok(fitted.map(|fitted| DisplacementAnswer::of(fitted, &surfaces)))
}

/// A lopsided bean of 2562 vertices with rounded triangles as cross-sections: round sections would not resist rotation.
pub(crate) fn lopsided_bean() -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(18.0, 7.0, 5.0), 4);
    let bent = mesh
        .vertices()
        .iter()
        .map(|p| {
            let along = p.x / 18.0;
            let ridges = 0.12 * (3.0 * (p.z / 5.0).atan2(p.y / 7.0) + along).cos();
            let width = 1.0 + 0.3 * along + 0.12 * (5.0 * along).sin() + ridges;
            Point3::new(p.x, p.y * width + 5.0 * along * along, p.z * width + (2.0 * along).sin())
        })
        .collect();
    mesh.with_vertices(bent).unwrap()
}

fn motion() -> RigidTransform {
    let rotation = *Rotation3::new(Vector3::new(1.9, -0.7, 2.2)).matrix();
    RigidTransform { rotation, translation: Vector3::new(12.0, -30.0, 7.0) }
}

/// A smooth displacement of about 2 mm.
fn warped(p: &Point3<f64>) -> Point3<f64> {
    let bump = |c: Vector3<f64>, a: Vector3<f64>| a * (-(p.coords - c).norm_squared() / (2.0 * 81.0)).exp();
    p + bump(Vector3::new(10.0, 0.0, 3.0), Vector3::new(1.0, 2.5, -1.0))
        + bump(Vector3::new(-9.0, 4.0, 0.0), Vector3::new(2.0, -1.5, 2.0))
}

/// The smooth displacement, with ripples of individual anatomy.
fn of_another_subject(p: &Point3<f64>) -> Point3<f64> {
    let ripple = |k: Vector3<f64>| 0.5 * k.dot(&p.coords).sin();
    warped(p)
        + Vector3::new(
            ripple(Vector3::new(0.5, 0.9, -0.4)),
            ripple(Vector3::new(0.7, -0.6, 0.8)),
            ripple(Vector3::new(-0.8, 0.4, 0.7)),
        )
}

/// The lopsided bean, its warped copy, and for every canonical vertex of the source its true image.
fn pair(warp: fn(&Point3<f64>) -> Point3<f64>) -> (CanonicalMesh, CanonicalMesh, Vec<Point3<f64>>) {
    pair_of(&lopsided_bean(), warp)
}

/// Source, target, and for every canonical vertex of the source its true image.
fn pair_of(
    source: &SurfaceMesh,
    warp: fn(&Point3<f64>) -> Point3<f64>,
) -> (CanonicalMesh, CanonicalMesh, Vec<Point3<f64>>) {
    let images: Vec<Point3<f64>> = source.vertices().iter().map(|p| motion().apply(&warp(p))).collect();
    let target = canonicalize(&source.with_vertices(images.clone()).unwrap());
    let source = canonicalize(source);
    let images = source.numbering.originals().iter().map(|&k| images[k as usize]).collect();
    (source, target, images)
}

#[test]
fn a_warped_copy_is_followed_where_no_rigid_transform_can() {
    let (source, target, images) = pair(warped);
    let poses = principal_axis_poses(source.mesh.vertices(), target.mesh.vertices()).unwrap();
    let found =
        displace(&source.mesh, &target.mesh, &poses, &DisplacementOptions::default(), &Silent).unwrap().unwrap();
    let n = images.len() as f64;
    let mean = found.images.iter().zip(&images).map(|(i, q)| (i.moved - q).norm()).sum::<f64>() / n;
    let rigid = absolute_orientation(source.mesh.vertices(), &images, None, false).unwrap();
    let best = source.mesh.vertices().iter().zip(&images).map(|(p, q)| (rigid.apply(p) - q).norm()).sum::<f64>() / n;
    assert!(mean < 0.8 * target.mesh.mean_edge_length() && mean < 0.5 * best, "{mean} mm, rigid {best} mm");
    for (image, q) in found.images.iter().zip(&images) {
        assert!((0.0..=1.0).contains(&image.confidence));
        assert!((image.closest.point - image.moved).norm() <= (image.moved - q).norm() + 1e-9);
    }
    assert_eq!(found.compared.len(), 2, "{:?}", found.compared);
}

#[test]
fn the_answer_of_a_nearly_round_surface_is_as_uncertain_as_its_rotation() {
    let spread = |mesh: &SurfaceMesh| {
        let (source, target, _) = pair_of(mesh, warped);
        let pose = motion();
        let found =
            displace(&source.mesh, &target.mesh, &[pose], &DisplacementOptions::default(), &Silent).unwrap().unwrap();
        found.images.iter().map(|image| image.spread_mm).sum::<f64>() / found.images.len() as f64
    };
    let of_width = |y: f64| spread(&ellipsoid(Vector3::new(18.0, y, 6.0), 4));
    let (bean, round, flat) = (spread(&lopsided_bean()), of_width(6.0), of_width(9.0));
    assert!(round > 3.0 * bean && round > 1.5 * flat && flat > bean, "{bean} {flat} {round}");
}

#[test]
fn a_moved_copy_gives_its_motion() {
    let (source, target, _) = pair(|p| *p);
    let poses = principal_axis_poses(source.mesh.vertices(), target.mesh.vertices()).unwrap();
    let found =
        displace(&source.mesh, &target.mesh, &poses, &DisplacementOptions::default(), &Silent).unwrap().unwrap();
    let error = found.transform.angle_to(&motion()).to_degrees();
    assert!(error < 1e-3, "{error} degrees");
    assert!(found.residual_mm < 0.05, "{}", found.residual_mm);
}

#[test]
fn a_rotated_start_and_the_pose_that_was_rotated_are_both_followed_and_one_answer() {
    let (source, target, _) = pair(|p| *p);
    let rotated = |angle: f64| {
        let about = RigidTransform {
            rotation: *Rotation3::from_axis_angle(&Vector3::x_axis(), angle).matrix(),
            ..RigidTransform::identity()
        };
        motion().after(&about)
    };
    for (right, found, rotation) in [(0, motion(), rotated(0.6)), (1, rotated(0.6), motion())] {
        let starts = [StartPose::of(found), StartPose { rotation_of: Some(0), ..StartPose::of(rotation) }];
        let found =
            displace_from(&source.mesh, &target.mesh, &starts, &DisplacementOptions::default(), &Silent).unwrap();
        let compared = found.unwrap().compared;
        assert_eq!(
            compared.iter().map(|start| start.origin).collect::<Vec<_>>(),
            [Origin::Pose(right)],
            "{compared:?}"
        );
    }
}

#[test]
fn of_a_surface_that_is_round_but_for_noise_a_rotated_start_is_not_kept() {
    let source = canonicalize(&ellipsoid(Vector3::new(18.0, 6.0, 6.0), 3));
    let mut uniform = numbers(5);
    let noisy = |p: &Point3<f64>| p + Vector3::from_fn(|_, _| uniform() - 0.5);
    let target = source.mesh.with_vertices(source.mesh.vertices().iter().map(noisy).collect()).unwrap();
    let mut gains = Vec::new();
    for angle in [-0.6, -0.4, -0.2, 0.2, 0.4, 0.6] {
        let about = *Rotation3::from_axis_angle(&Vector3::x_axis(), angle).matrix();
        let rotated = RigidTransform { rotation: about, ..RigidTransform::identity() };
        let starts =
            [StartPose::of(RigidTransform::identity()), StartPose { rotation_of: Some(0), ..StartPose::of(rotated) }];
        let alone = |start| {
            let found = displace_from(&source.mesh, &target, &[start], &DisplacementOptions::default(), &Silent);
            found.unwrap().unwrap().compared[0].misfit
        };
        gains.push(alone(StartPose::of(RigidTransform::identity())) - alone(StartPose::of(rotated)));
        let found = displace_from(&source.mesh, &target, &starts, &DisplacementOptions::default(), &Silent);
        let compared = found.unwrap().unwrap().compared;
        assert_eq!(
            compared.iter().map(|start| start.origin).collect::<Vec<_>>(),
            [Origin::Pose(0)],
            "{angle}: {compared:?}"
        );
    }
    assert!(
        gains.iter().any(|&gain| gain > 0.0),
        "no rotation fits better than the pose, so this shows nothing: {gains:?}"
    );
}

#[test]
fn a_mirrored_copy_is_followed_from_a_mirroring_pose() {
    let mirror = RigidTransform {
        rotation: nalgebra::Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0)),
        translation: Vector3::zeros(),
    };
    let source = lopsided_bean();
    let target = source.moved(&motion().after(&mirror).matrix()).unwrap();
    let (source, target) = (canonicalize(&source), canonicalize(&target));
    let pose = motion().after(&mirror);
    let found =
        displace(&source.mesh, &target.mesh, &[pose], &DisplacementOptions::default(), &Silent).unwrap().unwrap();
    assert!(found.transform.is_reflection());
    let edge = target.mesh.mean_edge_length();
    for (p, image) in source.mesh.vertices().iter().zip(&found.images) {
        assert!((pose.apply(p) - image.moved).norm() < 0.5 * edge);
    }
}

#[test]
fn a_plate_that_bends_to_its_other_side_is_not_mirrored() {
    let plate = ellipsoid(Vector3::new(18.0, 10.0, 1.5), 4);
    let bent = |by: f64| {
        let place = |p: &Point3<f64>| {
            let u = p.x / 18.0;
            // Its outline has no axis of symmetry, so no half turn lays one on the other.
            let y = p.y * (1.0 + 0.5 * u) + 5.0 * u * u;
            Point3::new(p.x, y, p.z + by * (u * u - 0.3))
        };
        canonicalize(&plate.with_vertices(plate.vertices().iter().map(place).collect()).unwrap())
    };
    let (source, target) = (bent(4.0), bent(-4.0));
    let pose = RigidTransform::identity();
    let found =
        displace(&source.mesh, &target.mesh, &[pose], &DisplacementOptions::default(), &Silent).unwrap().unwrap();
    let moved: Vec<Point3<f64>> = found.images.iter().map(|image| image.moved).collect();
    let either = absolute_orientation(source.mesh.vertices(), &moved, None, true).unwrap();
    assert!(either.is_reflection(), "the plate did not follow");
    assert!(!found.transform.is_reflection() && found.transform.angle_to(&pose) < 0.2, "{:?}", found.transform);
}

#[test]
fn a_densely_sampled_end_counts_by_its_area_in_the_agreement_of_normals() {
    let bean = lopsided_bean();
    let mut uniform = numbers(7);
    let mut rough = |p: &Point3<f64>| if p.x > 13.0 { p + Vector3::from_fn(|_, _| 3.0 * uniform() - 1.5) } else { *p };
    let target = canonicalize(&bean.with_vertices(bean.vertices().iter().map(&mut rough).collect()).unwrap());
    // The same surface with four of five vertices at the end where the target is rough.
    let (mut vertices, mut faces) = (bean.vertices().to_vec(), bean.indices().to_vec());
    for _ in 0..3 {
        for at in (0..faces.len()).step_by(3) {
            let [a, b, c] = [0, 1, 2].map(|k| faces[at + k]);
            let sum: Vector3<f64> = [a, b, c].iter().map(|&k| vertices[k as usize].coords).sum();
            let middle = Point3::from(sum / 3.0);
            if middle.x >= 13.0 {
                let new = vertices.len() as u32;
                vertices.push(middle);
                faces[at + 2] = new;
                faces.extend([b, c, new, c, a, new]);
            }
        }
    }
    let dense = SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap();
    let normals = |source: &SurfaceMesh| {
        let (source, pose) = (canonicalize(source), RigidTransform::identity());
        let found = displace(&source.mesh, &target.mesh, &[pose], &DisplacementOptions::default(), &Silent);
        found.unwrap().unwrap().agreement.normals
    };
    let (even, uneven) = (normals(&bean), normals(&dense));
    assert!(even < 0.98 && (even - uneven).abs() < 0.01, "{even} {uneven}");
}

#[test]
fn renumbering_permutes_the_images_and_threads_change_nothing() {
    let (source, target, _) = pair(warped);
    let n = source.mesh.n_vertices();
    let new_of_old: Vec<u32> = (0..n).map(|k| ((k * 31 + 17) % n) as u32).collect();
    let mut vertices = source.mesh.vertices().to_vec();
    for (old, &new) in new_of_old.iter().enumerate() {
        vertices[new as usize] = source.mesh.vertices()[old];
    }
    let faces = source.mesh.indices().iter().map(|&k| new_of_old[k as usize]).collect();
    let renumbered = canonicalize(&SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap());
    let whole = DisplacementOptions::default();
    let options = DisplacementOptions {
        coarse: StageSettings { steps: 4, ..whole.coarse.clone() },
        middle: StageSettings { steps: 2, ..whole.middle.clone() },
        fine: StageSettings { steps: 2, ..whole.fine.clone() },
        ..whole
    };
    let poses = principal_axis_poses(source.mesh.vertices(), target.mesh.vertices()).unwrap();
    let on = |threads: usize, mesh: &SurfaceMesh| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| displace(mesh, &target.mesh, &poses, &options, &Silent).unwrap().unwrap())
    };
    let plain = on(1, &source.mesh);
    assert_eq!(plain, on(3, &source.mesh));
    assert_eq!(plain, on(2, &renumbered.mesh));
}

#[test]
fn without_a_pose_there_is_no_answer() {
    let (source, target, _) = pair(|p| *p);
    let none = displace(&source.mesh, &target.mesh, &[], &DisplacementOptions::default(), &Silent).unwrap();
    assert_eq!(none, None);
}

#[test]
fn there_and_back_is_the_same_place() {
    let (source, target, _) = pair(of_another_subject);
    let (source, target) = (source.mesh, target.mesh);
    let options = DisplacementOptions::default();
    let there = displace(&source, &target, &[motion()], &options, &Silent).unwrap().unwrap();
    let back = displace(&target, &source, &[motion().inverse()], &options, &Silent).unwrap().unwrap();
    let edge = source.mean_edge_length();
    let returned = |i: usize| {
        let at = there.images[i].closest;
        let place = at.blend(|k| back.images[k].closest.point.coords);
        (place - source.vertices()[i].coords).norm() / edge
    };
    // Fits of each direction alone leave 1.6.
    let worst = (0..source.n_vertices()).map(returned).fold(0.0, f64::max);
    assert!(worst < 0.6, "{worst} edges");
}

/// The bean, moved along its normals by a sum of narrow bumps of random height, about 1 mm.
fn bumpy_bean(seed: u64) -> SurfaceMesh {
    let bean = lopsided_bean();
    let mut number = numbers(seed);
    let bumps: Vec<(Point3<f64>, f64)> = (0..40)
        .map(|_| (bean.vertices()[(number() * bean.n_vertices() as f64) as usize], 2.0 * number() - 1.0))
        .collect();
    let height = |p: &Point3<f64>| bumps.iter().map(|(c, a)| a * (-(p - c).norm_squared() / 8.0).exp()).sum::<f64>();
    let moved = bean.vertices().iter().zip(bean.vertex_normals()).map(|(p, n)| p + 1.6 * height(p) * n).collect();
    bean.with_vertices(moved).unwrap()
}

#[test]
fn the_answer_of_two_subjects_hardly_depends_on_where_the_search_began() {
    let (source, target) = (bumpy_bean(1), bumpy_bean(2));
    let options = DisplacementOptions::default();
    let from = |start: RigidTransform| displace(&source, &target, &[start], &options, &Silent).unwrap().unwrap().images;
    let own = from(RigidTransform::identity());
    let apart = |axis: Vector3<f64>| {
        let turn = Rotation3::new(axis * 8f64.to_radians());
        let turned = from(RigidTransform { rotation: *turn.matrix(), translation: Vector3::zeros() });
        let apart = own.iter().zip(&turned).map(|(a, b)| (a.closest.point - b.closest.point).norm()).sum::<f64>();
        apart / (source.n_vertices() as f64 * source.mean_edge_length())
    };
    // Fitted from each start itself, answers are 0.045 edges apart, these 0.007.
    let mean = [Vector3::x(), Vector3::y(), Vector3::z()].map(apart).iter().sum::<f64>() / 3.0;
    assert!(mean < 0.02, "{mean} edges");
}

#[test]
fn differences_along_the_normals_do_not_slide_the_answer_of_two_subjects() {
    let slid = |seed: u64| {
        let (source, target) = (bumpy_bean(seed), bumpy_bean(seed + 1));
        let options = DisplacementOptions::default();
        let found = displace(&source, &target, &[RigidTransform::identity()], &options, &Silent).unwrap().unwrap();
        let off = found.images.iter().zip(target.vertices()).map(|(image, p)| (image.closest.point - p).norm_squared());
        (off.sum::<f64>() / source.n_vertices() as f64).sqrt()
    };
    // Relaxed answers are off by 1.24 mm, these by 1.03 mm.
    let mean = [1, 3, 5].map(slid).iter().sum::<f64>() / 3.0;
    assert!(mean < 1.14, "{mean} mm");
}
