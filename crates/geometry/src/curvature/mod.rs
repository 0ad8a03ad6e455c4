//! Gaussian and mean curvature of a surface, at stated scales.
//!
//! A scale `σ` (mm) means: positions are smoothed by heat flow of time `σ²/2` ([`ScaleSpace`]), then curvature is
//! measured on the smoothed surface ([`gaussian_curvature`], [`mean_curvature`]). Triangles use corner angles and
//! mixed Voronoi areas; quads use corner angles and a quarter of each face's area, so that in both cases
//! `Σ K_i A_i = 2πχ` to rounding. [`curvatures`] offers two further estimators ([`Estimator`]), which use a ball of
//! given radius instead of the faces around a vertex.

mod angle_defect;
mod ball;
mod covariance;
mod estimator;
#[cfg(test)]
mod estimator_tests;
mod laplacian;
mod quadric;
mod scale_space;

pub use angle_defect::{angle_defect_curvatures, gaussian_curvature, mean_curvature, vertex_areas};
pub use estimator::{Curvatures, Estimator, curvatures, default_radius_mm};
pub use laplacian::{Weight, cotangent_weights};
pub use scale_space::{ScaleSpace, ScaleSpaceError};

#[cfg(test)]
mod tests {
    //! Curvature against closed forms for spheres, ellipsoids and tori, and the Gauss-Bonnet theorem.

    use super::*;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_mesh::{FaceArity, SurfaceMesh};
    use nalgebra::{Point3, Vector3};
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn total_curvature(mesh: &SurfaceMesh) -> f64 {
        gaussian_curvature(mesh).iter().zip(vertex_areas(mesh)).map(|(k, a)| k * a).sum()
    }

    /// Moves every vertex by up to `size` mm, by a fixed rule of its index.
    fn bumped(mesh: &SurfaceMesh, size: f64, seed: u64) -> SurfaceMesh {
        let number = |k: u64| ((k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as f64 / (1u64 << 24) as f64 - 0.5) * 2.0;
        let vertices = mesh
            .vertices()
            .iter()
            .enumerate()
            .map(|(i, p)| {
                let k = seed.wrapping_add(i as u64 * 3);
                p + Vector3::new(number(k), number(k + 1), number(k + 2)) * size
            })
            .collect();
        mesh.with_vertices(vertices).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        #[test]
        fn total_curvature_is_two_pi_chi_at_every_scale(seed in any::<u64>(), scale in 0.0f64..4.0) {
            let cases = [
                (ellipsoid(Vector3::new(12.0, 7.0, 5.0), 3), 2.0),
                (torus(10.0, 4.0, 30, 14, FaceArity::Quad), 0.0),
                (torus(10.0, 4.0, 30, 14, FaceArity::Triangle), 0.0),
            ];
            for (mesh, chi) in cases {
                let mesh = bumped(&mesh, 0.2, seed);
                let smoothed = ScaleSpace::new(&mesh).smoothed(scale).unwrap();
                prop_assert!((total_curvature(&smoothed) - TAU * chi).abs() < 1e-8);
                let area: f64 = vertex_areas(&smoothed).iter().sum();
                prop_assert!((area - smoothed.area()).abs() < 1e-9 * area);
            }
        }
    }

    #[test]
    fn one_operator_gives_every_scale_the_same_bits_as_a_new_one() {
        for mesh in [ellipsoid(Vector3::new(9.0, 6.0, 4.0), 3), torus(10.0, 4.0, 30, 14, FaceArity::Quad)] {
            let space = ScaleSpace::new(&mesh);
            for scale_mm in [2.0, 0.7, 4.5] {
                assert_eq!(space.smoothed(scale_mm), ScaleSpace::new(&mesh).smoothed(scale_mm));
            }
        }
    }

    #[test]
    fn a_sphere_has_the_curvature_of_its_radius() {
        for radius in [1.0, 8.0] {
            let sphere = ellipsoid(Vector3::repeat(radius), 4);
            for (k, h) in gaussian_curvature(&sphere).iter().zip(mean_curvature(&sphere)) {
                assert!((k * radius * radius - 1.0).abs() < 0.02, "{k}");
                assert!((h * radius - 1.0).abs() < 0.02, "{h}");
            }
        }
    }

    #[test]
    fn an_ellipsoid_converges_to_its_formula_under_refinement() {
        let axes = Vector3::new(9.0, 6.0, 5.0);
        let exact = |p: &Point3<f64>| {
            let squares = axes.component_mul(&axes);
            let weight = p.coords.component_div(&squares).norm_squared();
            1.0 / ((axes.x * axes.y * axes.z).powi(2) * weight * weight)
        };
        let error = |levels: u32| {
            let mesh = ellipsoid(axes, levels);
            let squares: f64 =
                gaussian_curvature(&mesh).iter().zip(mesh.vertices()).map(|(k, p)| (k / exact(p) - 1.0).powi(2)).sum();
            (squares / mesh.n_vertices() as f64).sqrt()
        };
        let errors: Vec<f64> = (2..6).map(error).collect();
        assert!(errors[3] < 0.01 && errors.windows(2).all(|e| e[1] < e[0] / 1.5), "{errors:?}");
    }

    #[test]
    fn a_torus_has_positive_and_negative_curvature() {
        let (radius, tube) = (10.0, 4.0);
        for arity in [FaceArity::Quad, FaceArity::Triangle] {
            let mesh = torus(radius, tube, 120, 60, arity);
            for ((k, h), p) in gaussian_curvature(&mesh).iter().zip(mean_curvature(&mesh)).zip(mesh.vertices()) {
                let ring = p.x.hypot(p.y);
                let cos = (ring - radius) / tube;
                assert!((k - cos / (tube * ring)).abs() < 1e-3, "{arity:?} {k} {}", cos / (tube * ring));
                let exact_mean = (radius + 2.0 * tube * cos) / (2.0 * tube * ring);
                assert!((h - exact_mean).abs() < 2e-3, "{arity:?} {h} {exact_mean}");
            }
        }
    }

    #[test]
    fn heat_flow_shrinks_a_sphere_as_diffusion_does() {
        // One implicit step multiplies a coordinate, an eigenfunction with eigenvalue 2/r², by 1/(1 + tλ).
        let (radius, sigma): (f64, f64) = (8.0, 2.0);
        let smoothed = ScaleSpace::new(&ellipsoid(Vector3::repeat(radius), 4)).smoothed(sigma).unwrap();
        let expected = radius / (1.0 + sigma * sigma / 2.0 * 2.0 / (radius * radius));
        for p in smoothed.vertices() {
            assert!((p.coords.norm() - expected).abs() < 0.01, "{} {expected}", p.coords.norm());
        }
    }
}
