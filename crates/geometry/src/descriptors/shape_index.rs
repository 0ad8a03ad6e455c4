//! Shape index and curvedness: the kind of shape at a vertex, and its strength.
//!
//! Source: Koenderink, van Doorn, "Surface shape and curvature scales", Image and Vision Computing 10(8), 1992.

use crate::curvature::Curvatures;
use std::f64::consts::FRAC_2_PI;

/// `2/π · atan((k₁ + k₂) / (k₁ − k₂))` in `[−1, 1]`: 1 for a dome, 1/2 for a ridge, 0 for a saddle, −1/2 for a rut, −1 for a
/// cup, seen from outside. 0 where the surface is flat and has no shape.
pub fn shape_index(curvatures: &Curvatures) -> Vec<f64> {
    let of = |(k, h): (&f64, &f64)| {
        // Half the difference of the principal curvatures; errors of the estimates may make its square negative.
        let half = (h * h - k).max(0.0).sqrt();
        FRAC_2_PI * h.atan2(half)
    };
    curvatures.gaussian.iter().zip(&curvatures.mean).map(of).collect()
}

/// `√((k₁² + k₂²) / 2)`, 1/mm.
pub fn curvedness(curvatures: &Curvatures) -> Vec<f64> {
    let of = |(k, h): (&f64, &f64)| (2.0 * h * h - k).max(h * h).sqrt();
    curvatures.gaussian.iter().zip(&curvatures.mean).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::{Estimator, curvatures};
    use homolog_mesh::FaceArity;
    use homolog_mesh::repair::reversed;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn the_five_shapes_have_their_numbers() {
        // Sphere, cylinder, symmetric saddle, rut, cup, plane: principal curvatures of radius 2.
        let both = Curvatures {
            gaussian: vec![0.25, 0.0, -0.25, 0.0, 0.25, 0.0],
            mean: vec![0.5, 0.25, 0.0, -0.25, -0.5, 0.0],
        };
        let root = 0.125f64.sqrt();
        for (found, expected) in shape_index(&both).iter().zip([1.0, 0.5, 0.0, -0.5, -1.0, 0.0]) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
        for (found, expected) in curvedness(&both).iter().zip([0.5, root, 0.5, root, 0.5, 0.0]) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    #[test]
    fn a_torus_has_the_values_of_its_principal_curvatures() {
        let (radius, tube) = (10.0, 4.0);
        let mesh = torus(radius, tube, 160, 80, FaceArity::Triangle);
        let both = curvatures(&mesh, Estimator::AngleDefect, &Silent).unwrap();
        for ((s, c), p) in shape_index(&both).iter().zip(curvedness(&both)).zip(mesh.vertices()) {
            let ring = p.x.hypot(p.y);
            let (k1, k2) = (1.0 / tube, (ring - radius) / (tube * ring));
            assert!((s - FRAC_2_PI * ((k1 + k2) / (k1 - k2)).atan()).abs() < 0.01, "{s}");
            assert!((c - ((k1 * k1 + k2 * k2) / 2.0).sqrt()).abs() < 0.002, "{c}");
        }
    }

    #[test]
    fn a_surface_turned_inside_out_has_the_opposite_index() {
        let mesh = ellipsoid(Vector3::new(5.0, 3.0, 2.0), 3);
        let of = |mesh| curvatures(mesh, Estimator::AngleDefect, &Silent).unwrap();
        let (out, inside) = (of(&mesh), of(&reversed(&mesh)));
        for (a, b) in shape_index(&out).iter().zip(shape_index(&inside)) {
            assert!((a + b).abs() < 1e-9, "{a} {b}");
        }
    }
}
