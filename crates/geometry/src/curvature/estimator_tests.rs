//! Every estimator compared with the known curvature of spheres, ellipsoids, tori and balls of voxels.

use super::{Curvatures, Estimator, ScaleSpace, curvatures, default_radius_mm, gaussian_curvature, mean_curvature};
use homolog_mesh::shapes::{ellipsoid, torus};
use homolog_mesh::volume::{LabelVolume, voxel_surface};
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use nalgebra::{Isometry3, Matrix4, Point3, Vector3};
use proptest::prelude::*;

fn all(radius_mm: f64) -> [Estimator; 3] {
    [Estimator::AngleDefect, Estimator::Covariance { radius_mm }, Estimator::Quadric { radius_mm }]
}

fn with_balls(mesh: &SurfaceMesh) -> [Estimator; 3] {
    all(default_radius_mm(mesh))
}

/// `K` and `H` of the ellipsoid with these half axes at `p` on it.
fn of_ellipsoid(axes: &Vector3<f64>, p: &Point3<f64>) -> (f64, f64) {
    let squares = axes.component_mul(axes);
    let weight = p.coords.component_div(&squares).norm_squared();
    let product = squares.product();
    let gaussian = 1.0 / (product * weight * weight);
    let mean = (squares.sum() - p.coords.norm_squared()) / (2.0 * product * weight.powf(1.5));
    (gaussian, mean)
}

/// Root mean square of the errors of `K` and `H`, relative to the root mean square of their true values.
fn errors(mesh: &SurfaceMesh, found: &Curvatures, truth: impl Fn(&Point3<f64>) -> (f64, f64)) -> (f64, f64) {
    let mut sums = [0.0; 4];
    for ((p, k), h) in mesh.vertices().iter().zip(&found.gaussian).zip(&found.mean) {
        let (exact_k, exact_h) = truth(p);
        let terms = [k - exact_k, exact_k, h - exact_h, exact_h];
        (0..4).for_each(|i| sums[i] += terms[i] * terms[i]);
    }
    ((sums[0] / sums[1]).sqrt(), (sums[2] / sums[3]).sqrt())
}

/// The surface of the voxels of 1 mm whose centers lie within `radius` of a point off the lattice.
fn voxel_ball(radius: f64) -> SurfaceMesh {
    let side = 2 * radius as usize + 5;
    let center = side as f64 / 2.0;
    let inside = |at: usize| {
        let place = Vector3::new((at % side) as f64, (at / side % side) as f64, (at / side / side) as f64);
        (place - Vector3::new(center + 0.1, center - 0.2, center + 0.3)).norm() <= radius
    };
    let labels = (0..side.pow(3)).map(|at| u32::from(inside(at))).collect();
    let volume = LabelVolume::new([side; 3], labels, Matrix4::identity()).unwrap();
    voxel_surface(&volume.mask(None).unwrap()).unwrap()
}

#[test]
fn on_a_sphere_every_estimator_gives_its_radius() {
    for radius in [1.0, 8.0] {
        let sphere = ellipsoid(Vector3::repeat(radius), 4);
        for estimator in with_balls(&sphere) {
            let found = curvatures(&sphere, estimator, &Silent).unwrap();
            let mut largest = (0.0f64, 0.0f64);
            for (k, h) in found.gaussian.iter().zip(&found.mean) {
                largest = (largest.0.max((k * radius * radius - 1.0).abs()), largest.1.max((h * radius - 1.0).abs()));
            }
            assert!(largest.0 < 0.04 && largest.1 < 0.02, "{estimator:?} {largest:?}");
        }
    }
}

#[test]
fn on_an_ellipsoid_every_estimator_converges_to_the_formula() {
    let axes = Vector3::new(9.0, 6.0, 5.0);
    for which in 0..3 {
        let at_levels: Vec<(f64, f64)> = (2..6)
            .map(|levels| {
                let mesh = ellipsoid(axes, levels);
                errors(&mesh, &curvatures(&mesh, with_balls(&mesh)[which], &Silent).unwrap(), |p| {
                    of_ellipsoid(&axes, p)
                })
            })
            .collect();
        assert!(at_levels[3].0 < 0.015 && at_levels[3].1 < 0.008, "{at_levels:?}");
        assert!(at_levels.windows(2).all(|e| e[1].0 < e[0].0 / 2.0 && e[1].1 < e[0].1 / 2.0), "{at_levels:?}");
    }
}

#[test]
fn on_a_torus_every_estimator_finds_both_signs_and_converges() {
    let (radius, tube) = (10.0, 4.0);
    let truth = |p: &Point3<f64>| {
        let ring = p.x.hypot(p.y);
        let cos = (ring - radius) / tube;
        (cos / (tube * ring), (radius + 2.0 * tube * cos) / (2.0 * tube * ring))
    };
    for arity in [FaceArity::Quad, FaceArity::Triangle] {
        for which in 0..3 {
            let at_sizes: Vec<(f64, f64)> = [30, 60, 120]
                .map(|around| {
                    let mesh = torus(radius, tube, around, around / 2, arity);
                    errors(&mesh, &curvatures(&mesh, with_balls(&mesh)[which], &Silent).unwrap(), truth)
                })
                .into();
            assert!(at_sizes[2].0 < 0.04 && at_sizes[2].1 < 0.03, "{arity:?} {at_sizes:?}");
            assert!(at_sizes.windows(2).all(|e| e[1].0 < e[0].0 / 2.5 && e[1].1 < e[0].1 / 2.5), "{at_sizes:?}");
        }
    }
}

#[test]
fn estimators_with_a_ball_are_accurate_on_smoothed_voxels_where_angle_defect_is_not() {
    let voxels = voxel_ball(10.0);
    let smooth = ScaleSpace::new(&voxels).smoothed(3.0).unwrap();
    let center = smooth.centroid();
    let radius = smooth.vertices().iter().map(|p| (p - center).norm()).sum::<f64>() / smooth.n_vertices() as f64;
    // Medians, since a few vertices at the poles of the ball have nearly no area.
    let [faces, covariance, quadric] = all(4.0).map(|estimator| {
        let found = curvatures(&smooth, estimator, &Silent).unwrap();
        let median_error = |values: &[f64], exact: f64| {
            let mut errors: Vec<f64> = values.iter().map(|v| (v / exact - 1.0).abs()).collect();
            errors.sort_by(f64::total_cmp);
            errors[errors.len() / 2]
        };
        (median_error(&found.gaussian, 1.0 / (radius * radius)), median_error(&found.mean, 1.0 / radius))
    });
    for (gaussian, mean) in [covariance, quadric] {
        assert!(gaussian < 0.12 && mean < 0.06, "{covariance:?} {quadric:?}");
        assert!(gaussian < faces.0 && mean < faces.1, "{faces:?} {covariance:?} {quadric:?}");
    }
}

#[test]
fn the_opposite_side_of_a_thin_plate_is_not_included() {
    let axes = Vector3::new(10.0, 10.0, 0.4);
    let plate = ellipsoid(axes, 4);
    for estimator in all(2.0) {
        let found = curvatures(&plate, estimator, &Silent).unwrap();
        for (v, p) in plate.vertices().iter().enumerate().filter(|(_, p)| p.x.hypot(p.y) < 5.0) {
            let (k, h) = of_ellipsoid(&axes, p);
            assert!((found.mean[v] / h - 1.0).abs() < 0.1, "{estimator:?} {} {h}", found.mean[v]);
            assert!((found.gaussian[v] / k - 1.0).abs() < 0.2, "{estimator:?} {} {k}", found.gaussian[v]);
        }
    }
}

#[test]
fn a_ball_with_too_few_vertices_falls_back_on_the_angle_defect() {
    let mesh = torus(10.0, 4.0, 30, 14, FaceArity::Quad);
    let around = curvatures(&mesh, Estimator::AngleDefect, &Silent).unwrap();
    assert_eq!(around, Curvatures { gaussian: gaussian_curvature(&mesh), mean: mean_curvature(&mesh) });
    for radius_mm in [0.0, -1.0, 1e-3, f64::NAN] {
        for estimator in all(radius_mm) {
            assert_eq!(curvatures(&mesh, estimator, &Silent).unwrap(), around, "{estimator:?}");
        }
    }
    // Four neighbors and the vertex itself determine no paraboloid.
    assert_eq!(curvatures(&mesh, Estimator::Quadric { radius_mm: 0.0 }, &Silent).unwrap(), around);
}

#[test]
fn faces_without_area_leave_finite_curvatures() {
    let ball = ellipsoid(Vector3::repeat(3.0), 2);
    let mut vertices = ball.vertices().to_vec();
    for &[a, b] in &ball.edges()[..40] {
        vertices[b as usize] = vertices[a as usize];
    }
    let pinched = ball.with_vertices(vertices).unwrap();
    for estimator in &all(1.5)[1..] {
        let found = curvatures(&pinched, *estimator, &Silent).unwrap();
        assert!(found.gaussian.iter().chain(&found.mean).all(|c| c.is_finite()), "{estimator:?}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mesh = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3);
    for estimator in with_balls(&mesh) {
        let with = |n_threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap();
            pool.install(|| curvatures(&mesh, estimator, &Silent).unwrap())
        };
        assert_eq!(with(1), with(3));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn curvature_does_not_depend_on_the_pose_and_scales_with_the_size(
        axis in [-2.0f64..2.0, -2.0..2.0, -2.0..2.0],
        shift in [-50.0f64..50.0, -50.0..50.0, -50.0..50.0],
        size in 0.2f64..5.0,
    ) {
        for mesh in [ellipsoid(Vector3::new(9.0, 6.0, 5.0), 2), torus(10.0, 4.0, 24, 12, FaceArity::Quad)] {
            // Not a radius at which vertices of these regular meshes lie on the rim of the ball.
            let radius_mm = 3.7;
            let moved = mesh.transformed(&Isometry3::new(Vector3::from(shift), Vector3::from(axis)));
            let grown = mesh.with_vertices(mesh.vertices().iter().map(|p| p * size).collect()).unwrap();
            for (here, at_size) in all(radius_mm).into_iter().zip(all(radius_mm * size)) {
                let found = curvatures(&mesh, here, &Silent).unwrap();
                let in_pose = curvatures(&moved, here, &Silent).unwrap();
                let larger = curvatures(&grown, at_size, &Silent).unwrap();
                for v in 0..mesh.n_vertices() {
                    prop_assert!((found.gaussian[v] - in_pose.gaussian[v]).abs() < 1e-9);
                    prop_assert!((found.mean[v] - in_pose.mean[v]).abs() < 1e-9);
                    prop_assert!((found.gaussian[v] - larger.gaussian[v] * size * size).abs() < 1e-9);
                    prop_assert!((found.mean[v] - larger.mean[v] * size).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn the_paraboloid_of_a_quadratic_surface_is_found_exactly(
        form in [-0.2f64..0.2, -0.2..0.2, -0.2..0.2],
    ) {
        // A graph over a grid; only the middle vertex is looked at, whose normal is upright by symmetry.
        let [a, b, c] = form;
        let side = 9u32;
        let vertices = (0..side * side)
            .map(|k| (f64::from(k % side) / 2.0 - 2.0, f64::from(k / side) / 2.0 - 2.0))
            .map(|(u, v)| Point3::new(u, v, a * u * u + b * u * v + c * v * v))
            .collect();
        let faces = (0..(side - 1) * (side - 1)).flat_map(|k| {
            let corner = k / (side - 1) * side + k % (side - 1);
            [corner, corner + 1, corner + side + 1, corner + side]
        });
        let mesh = SurfaceMesh::new(vertices, FaceArity::Quad, faces.collect()).unwrap();
        let found = curvatures(&mesh, Estimator::Quadric { radius_mm: 1.3 }, &Silent).unwrap();
        let middle = (side * side / 2) as usize;
        prop_assert!((found.mean[middle] + a + c).abs() < 1e-9);
        prop_assert!((found.gaussian[middle] - (4.0 * a * c - b * b)).abs() < 1e-9);
    }

    #[test]
    fn the_curvature_of_a_graph_holds_at_any_slope(x in -0.6f64..0.6, y in -0.6f64..0.6) {
        // The upper half of the unit sphere, developed at (x, y).
        let z = (1.0 - x * x - y * y).sqrt();
        let second = [-(1.0 - y * y) / (2.0 * z.powi(3)), -x * y / z.powi(3), -(1.0 - x * x) / (2.0 * z.powi(3))];
        let (k, h) = super::quadric::of_graph(second, [-x / z, -y / z]);
        prop_assert!((k - 1.0).abs() < 1e-9 && (h - 1.0).abs() < 1e-9, "{k} {h}");
    }
}
