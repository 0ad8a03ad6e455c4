//! Maps onto the sphere are one to one and even; first-order ellipsoids find poses up to half turns.

use super::sphere::spherical_area;
use super::*;
use homolog_laboratory::phantom::{PairRecipe, Phantom, PhantomPair, random_permutation, random_pose};
use homolog_mesh::shapes::{ellipsoid, torus};
use homolog_mesh::volume::{LabelVolume, voxel_surface};
use homolog_mesh::{ClosestPointIndex, FaceArity};
use homolog_primitives::observe::Silent;
use homolog_registration::{ClosestSurfacePoint, RigidTransform};
use nalgebra::{Isometry3, Matrix4, Point3};
use std::f64::consts::PI;

struct Surface(ClosestPointIndex);

impl ClosestSurfacePoint for Surface {
    fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
        (self.0.closest(query).point, Vector3::z())
    }
}

fn map(mesh: &SurfaceMesh) -> Parametrization {
    parametrize(mesh, &ParametrizationOptions::default(), &Silent).unwrap()
}

fn foe(mesh: &SurfaceMesh) -> FirstOrderEllipsoid {
    first_order_ellipsoid(mesh, &map(mesh)).unwrap()
}

fn register(source: &SurfaceMesh, target: &SurfaceMesh) -> EllipsoidRegistration {
    let closest = Surface(ClosestPointIndex::new(target));
    let options = EllipsoidOptions::default();
    register_by_ellipsoids(&foe(source), &foe(target), source.vertices(), &closest, &options, &Silent).unwrap()
}

fn rigid(motion: &Isometry3<f64>) -> RigidTransform {
    RigidTransform { rotation: *motion.rotation.to_rotation_matrix().matrix(), translation: motion.translation.vector }
}

/// The angle between `truth` and the nearest of the four poses, and that of the chosen one, degrees.
fn errors(found: &EllipsoidRegistration, truth: &RigidTransform) -> (f64, f64) {
    let angle = |pose: &EllipsoidPose| pose.target_from_source.angle_to(truth).to_degrees();
    (found.poses.iter().map(angle).fold(f64::INFINITY, f64::min), angle(found.pose()))
}

fn assert_one_to_one(mesh: &SurfaceMesh, map: &Parametrization, what: &str) {
    let areas: Vec<f64> =
        mesh.triangles().iter().map(|t| spherical_area(t.map(|k| map.directions[k as usize]))).collect();
    assert!(areas.iter().all(|&a| a > 0.0), "{what}: a triangle is folded");
    // Positive triangles that sum to one sphere cover it once.
    assert!((areas.iter().sum::<f64>() - 4.0 * PI).abs() < 1e-9, "{what}: the sphere is not covered once");
    assert!(map.directions.iter().all(|d| (d.norm() - 1.0).abs() < 1e-12));
}

/// A box of voxels of the given size.
fn voxel_box(size: [usize; 3]) -> SurfaceMesh {
    let n = size.iter().product();
    let volume = LabelVolume::new(size, vec![1; n], Matrix4::identity()).unwrap();
    voxel_surface(&volume.mask(None).unwrap()).unwrap()
}

fn voxel_phantom(seed: u64) -> SurfaceMesh {
    let volume = Phantom::new(seed).volume(1.0).unwrap().into_label_volume().unwrap();
    let filled = homolog_mesh::volume::fill(&volume.mask(None).unwrap(), homolog_mesh::volume::Contacts::Resolve);
    voxel_surface(&filled.mask).unwrap()
}

#[test]
fn maps_are_one_to_one_and_nearly_area_preserving() {
    let mut shapes = vec![
        ("sphere".to_owned(), ellipsoid(Vector3::new(5.0, 5.0, 5.0), 3), 0.02),
        ("ellipsoid".to_owned(), ellipsoid(Vector3::new(20.0, 9.0, 6.0), 4), 0.1),
        ("needle".to_owned(), ellipsoid(Vector3::new(30.0, 3.0, 2.0), 3), 0.15),
        ("cube of voxels".to_owned(), voxel_box([8, 8, 8]), 0.1),
        ("bar of voxels".to_owned(), voxel_box([30, 4, 6]), 0.15),
    ];
    for seed in 0..6 {
        shapes.push((format!("phantom {seed}"), Phantom::new(seed).surface(0.8).unwrap().mesh, 0.1));
    }
    shapes.push(("phantom of voxels".to_owned(), voxel_phantom(3), 0.15));
    for (name, mesh, most) in &shapes {
        let map = map(mesh);
        println!(
            "{name}: {} vertices, {} unfolded, {} steps, distortion {:.4}",
            mesh.n_vertices(),
            map.n_unfolded,
            map.iterations,
            map.area_distortion
        );
        assert_one_to_one(mesh, &map, name);
        assert!(map.converged && map.area_distortion < *most, "{name}: {}", map.area_distortion);
    }
}

#[test]
fn a_sphere_is_its_own_ellipsoid() {
    let ball = ellipsoid(Vector3::new(5.0, 5.0, 5.0), 3).transformed(&random_pose(4));
    let found = foe(&ball);
    for half_axis in found.half_axes_mm {
        assert!((half_axis / 5.0 - 1.0).abs() < 0.01, "{:?}", found.half_axes_mm);
    }
    assert!((found.center - random_pose(4) * Point3::origin()).norm() < 0.02);
    let product = found.matrix() * found.parameter_axes;
    for k in 0..3 {
        let expected = found.axes.column(k) * found.half_axes_mm[k];
        assert!((product.column(k) - expected).norm() < 1e-9);
    }
    assert!((found.axes.determinant() - 1.0).abs() < 1e-9);
    // The coefficients are those of the center and the matrix.
    let c = found.coefficients_mm;
    assert!((Vector3::from(c[0]) / (4.0 * PI).sqrt() - found.center.coords).norm() < 1e-9);
    assert!((Vector3::from(c[2]) * (3.0 / (4.0 * PI)).sqrt() - found.matrix().column(2)).norm() < 1e-9);
}

#[test]
fn the_axes_of_an_ellipsoid_are_found() {
    let motion = random_pose(9);
    let found = foe(&ellipsoid(Vector3::new(20.0, 9.0, 5.0), 3).transformed(&motion));
    for (k, axis) in [Vector3::x(), Vector3::y(), Vector3::z()].iter().enumerate() {
        let cosine = found.axes.column(k).dot(&(motion * axis)).abs();
        assert!(cosine.min(1.0).acos().to_degrees() < 1.0, "axis {k} is {} degrees off", cosine.acos().to_degrees());
    }
}

#[test]
fn a_moved_copy_is_found_up_to_rotations_by_180_degrees() {
    let mut widest: f64 = 0.0;
    let shapes = [
        ellipsoid(Vector3::new(20.0, 9.0, 5.0), 3),
        Phantom::new(1).surface(1.2).unwrap().mesh,
        Phantom::new(2).surface(1.0).unwrap().mesh,
        voxel_box([20, 9, 5]),
    ];
    for (k, mesh) in shapes.iter().enumerate() {
        for seed in 0..2 {
            let motion = random_pose(10 * k as u64 + seed);
            let (nearest, _) = errors(&register(mesh, &mesh.transformed(&motion)), &rigid(&motion));
            widest = widest.max(nearest);
            assert!(nearest < 1.0, "shape {k}, pose {seed}: {nearest} degrees");
        }
    }
    println!("widest error on copies: {widest:e} degrees");
}

/// `mesh` with its vertices shuffled.
fn shuffled(mesh: &SurfaceMesh, seed: u64) -> SurfaceMesh {
    let place = random_permutation(mesh.n_vertices(), seed);
    let mut vertices = mesh.vertices().to_vec();
    for (old, &new) in place.iter().enumerate() {
        vertices[new as usize] = mesh.vertices()[old];
    }
    let indices = mesh.indices().iter().map(|&k| place[k as usize]).collect();
    SurfaceMesh::new(vertices, mesh.arity(), indices).unwrap()
}

#[test]
fn renumbering_the_vertices_does_not_change_the_result() {
    let mesh = Phantom::new(7).surface(1.2).unwrap().mesh;
    let motion = random_pose(3);
    let found = register(&mesh, &shuffled(&mesh.transformed(&motion), 5));
    let (nearest, chosen) = errors(&found, &rigid(&motion));
    assert!(nearest < 1.0 && chosen < 1.0, "{nearest} and {chosen} degrees");
    assert_eq!(found.ambiguous_axes, found.source_axis_ratios[1] < 1.1);
}

#[test]
fn another_mesh_of_the_same_subject_and_a_deformed_one_are_found_approximately() {
    for seed in 0..4 {
        let recipe = PairRecipe {
            subject: seed,
            target_subject: seed,
            deform_share: 0.0,
            deform_seed: 0,
            pose_seed: Some(seed + 20),
            permute_seed: Some(seed),
        };
        let source = Phantom::new(seed).surface(1.3).unwrap().mesh;
        let same = PhantomPair::new(recipe.clone()).unwrap();
        let target = same.target_surface(0.9).unwrap().0.mesh;
        let remeshed = register(&source, &target);
        let (nearest, chosen) = errors(&remeshed, &rigid(same.pose()));
        println!(
            "seed {seed} re-meshed: nearest {nearest:.2}, chosen {chosen:.2}, ratios {:?}",
            remeshed.source_axis_ratios
        );
        assert!(nearest < 2.0 && chosen < 2.0, "seed {seed}: {nearest} and {chosen} degrees");
        let voxels = voxel_phantom(seed).transformed(same.pose());
        let (nearest, chosen) = errors(&register(&source, &voxels), &rigid(same.pose()));
        println!("seed {seed} voxels: nearest {nearest:.2}, chosen {chosen:.2}");
        // Stairs have more area than the slope they stand for, and not everywhere the same share more.
        assert!(nearest < 10.0 && chosen < 10.0, "seed {seed} voxels: {nearest} and {chosen} degrees");
        let bent = PhantomPair::new(PairRecipe { deform_share: 0.02, deform_seed: 5, ..recipe }).unwrap();
        let (nearest, chosen) =
            errors(&register(&source, &bent.target_surface(0.9).unwrap().0.mesh), &rigid(bent.pose()));
        println!("seed {seed} deformed: nearest {nearest:.2}, chosen {chosen:.2}");
        assert!(nearest < 5.0 && chosen < 5.0, "seed {seed} deformed: {nearest} and {chosen} degrees");
    }
}

#[test]
fn residuals_choose_among_the_four_poses_only_with_resolve() {
    let mesh = Phantom::new(5).surface(1.2).unwrap().mesh;
    let motion = random_pose(31);
    let target = mesh.transformed(&motion);
    let found = register(&mesh, &target);
    let (_, chosen) = errors(&found, &rigid(&motion));
    assert!(chosen < 1.0, "{chosen} degrees");
    assert!(found.poses.is_sorted_by(|a, b| a.rotation_angle_rad <= b.rotation_angle_rad));
    assert!(found.poses.iter().all(|p| p.rms_mm >= found.pose().rms_mm));
    let closest = Surface(ClosestPointIndex::new(&target));
    let unresolved = EllipsoidOptions { resolve: false, ..EllipsoidOptions::default() };
    let (a, b) = (foe(&mesh), foe(&target));
    let plain = register_by_ellipsoids(&a, &b, mesh.vertices(), &closest, &unresolved, &Silent).unwrap();
    assert_eq!((plain.chosen, plain.poses), (0, found.poses));
}

#[test]
fn near_spheres_and_cubes_are_reported_as_ambiguous() {
    let ball = ellipsoid(Vector3::new(5.0, 4.9, 4.8), 3);
    assert!(register(&ball, &ball.transformed(&random_pose(1))).ambiguous_axes);
    let cube = voxel_box([9, 9, 9]);
    assert!(register(&cube, &cube.transformed(&random_pose(2))).ambiguous_axes);
    let cigar = ellipsoid(Vector3::new(15.0, 5.0, 5.1), 3);
    assert!(register(&cigar, &cigar).ambiguous_axes);
    let clear = ellipsoid(Vector3::new(15.0, 9.0, 5.0), 3);
    assert!(!register(&clear, &clear).ambiguous_axes);
}

#[test]
fn any_number_of_threads_gives_the_same_map() {
    let mesh = Phantom::new(1).surface(1.5).unwrap().mesh;
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| map(&mesh))
    };
    assert_eq!(with(1), with(4));
}

#[test]
fn surfaces_that_cannot_be_mapped_are_rejected_with_their_fault() {
    let fails = |mesh: &SurfaceMesh| parametrize(mesh, &ParametrizationOptions::default(), &Silent).unwrap_err();
    let ring = torus(9.0, 3.0, 24, 12, FaceArity::Quad);
    assert!(matches!(fails(&ring), HarmonicsError::Surface(SurfaceFault::Genus { genus: 1, tunnel: Some(_) })));
    let ball = ellipsoid(Vector3::new(5.0, 4.0, 3.0), 1);
    let open = ball.indices()[3..].to_vec();
    let open = SurfaceMesh::new(ball.vertices().to_vec(), FaceArity::Triangle, open).unwrap();
    assert!(matches!(fails(&open), HarmonicsError::Surface(SurfaceFault::Boundary { .. })));
    let flat = ball.vertices().iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    assert!(matches!(
        fails(&ball.with_vertices(flat).unwrap()),
        HarmonicsError::Surface(SurfaceFault::NoVolume { .. })
    ));
    let mut spare = ball.vertices().to_vec();
    spare.push(Point3::new(0.0, 0.0, 9.0));
    let n = ball.n_vertices() as u32;
    assert_eq!(fails(&ball.with_vertices(spare).unwrap()), HarmonicsError::UnusedVertex { vertex: n });
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from).to_vec();
    let faces = vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    let tetrahedron = SurfaceMesh::new(corners, FaceArity::Triangle, faces).unwrap();
    assert_eq!(fails(&tetrahedron), HarmonicsError::TooCoarse { n_vertices: 4 });
}
