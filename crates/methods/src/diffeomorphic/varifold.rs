//! Surfaces as varifolds: sums over faces of a center, an area and a tangent plane.
//!
//! `⟨S, T⟩ = Σ_fg exp(−‖x_f − y_g‖²/2w²) (n_f · n_g)² a_f a_g`, which does not depend on the orientation of a face. With
//! area vectors `a = a n` a term is `k (a_f · a_g)² / (|a_f| |a_g|)`.

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::ops::{Mul, Sub};

/// Faces per chunk.
const CHUNK: usize = 16;

/// The faces of a surface.
pub(super) struct Varifold {
    centers: Vec<Point3<f64>>,
    /// Normals times areas.
    areas: Vec<Vector3<f64>>,
    /// Lengths of the area vectors.
    sizes: Vec<f64>,
}

/// The gradient of a product with respect to one face.
#[derive(Clone, Copy)]
pub(super) struct OfFace {
    center: Vector3<f64>,
    area: Vector3<f64>,
}

impl Mul<f64> for OfFace {
    type Output = OfFace;
    fn mul(self, factor: f64) -> OfFace {
        OfFace { center: self.center * factor, area: self.area * factor }
    }
}

impl Sub for OfFace {
    type Output = OfFace;
    fn sub(self, other: OfFace) -> OfFace {
        OfFace { center: self.center - other.center, area: self.area - other.area }
    }
}

impl Varifold {
    pub(super) fn of(vertices: &[Point3<f64>], triangles: &[[u32; 3]]) -> Varifold {
        let mut varifold = Varifold { centers: Vec::new(), areas: Vec::new(), sizes: Vec::new() };
        for t in triangles {
            let [a, b, c] = t.map(|k| vertices[k as usize]);
            let area = (b - a).cross(&(c - a)) / 2.0;
            varifold.centers.push(Point3::from((a.coords + b.coords + c.coords) / 3.0));
            varifold.areas.push(area);
            // A face without area has no plane, and its terms are 0.
            varifold.sizes.push(area.norm().max(f64::MIN_POSITIVE.sqrt()));
        }
        varifold
    }

    /// `⟨self, other⟩`.
    pub(super) fn product(&self, other: &Varifold, width: f64) -> f64 {
        self.product_and_gradient(other, width).0
    }

    /// `⟨self, other⟩` and its gradient with respect to the faces of `self`, with `other` fixed.
    pub(super) fn product_and_gradient(&self, other: &Varifold, width: f64) -> (f64, Vec<OfFace>) {
        let inverse = 1.0 / (width * width);
        let found: Vec<(f64, OfFace)> = (0..self.centers.len())
            .into_par_iter()
            .with_min_len(CHUNK)
            .map(|f| {
                let (x, a, size) = (self.centers[f], self.areas[f], self.sizes[f]);
                let (mut sum, mut center, mut area) = (0.0, Vector3::zeros(), Vector3::zeros());
                for g in 0..other.centers.len() {
                    let d = x - other.centers[g];
                    let exponent = -0.5 * d.norm_squared() * inverse;
                    // Below the last digit of the sum.
                    if exponent < -36.0 {
                        continue;
                    }
                    let dot = a.dot(&other.areas[g]);
                    let share = exponent.exp() * dot / (size * other.sizes[g]);
                    let term = share * dot;
                    sum += term;
                    center -= d * (term * inverse);
                    area += other.areas[g] * (2.0 * share) - a * (term / (size * size));
                }
                (sum, OfFace { center, area })
            })
            .collect();
        (found.iter().map(|(sum, _)| sum).sum(), found.into_iter().map(|(_, g)| g).collect())
    }
}

/// Converts the gradient with respect to faces to one with respect to vertices.
pub(super) fn at_vertices(of_faces: &[OfFace], vertices: &[Point3<f64>], triangles: &[[u32; 3]]) -> Vec<Vector3<f64>> {
    let mut gradient = vec![Vector3::zeros(); vertices.len()];
    for (t, g) in triangles.iter().zip(of_faces) {
        for k in 0..3 {
            let [own, next, last] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]].map(|v| v as usize);
            // The area vector is half of (b − a) × (c − a); its derivative with respect to a corner is half the cross
            // product with the opposite edge.
            let edge = vertices[last] - vertices[next];
            gradient[own] += g.center / 3.0 + g.area.cross(&edge) / 2.0;
        }
    }
    gradient
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{bean, warped};

    #[test]
    fn the_distance_of_a_surface_to_itself_is_zero_whatever_its_orientation() {
        let mesh = bean(2);
        let turned: Vec<[u32; 3]> = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
        let (one, other) = (Varifold::of(mesh.vertices(), &mesh.triangles()), Varifold::of(mesh.vertices(), &turned));
        let [aa, ab, bb] = [one.product(&one, 0.1), one.product(&other, 0.1), other.product(&other, 0.1)];
        assert!((aa - 2.0 * ab + bb).abs() < 1e-12 * aa);
        let moved: Vec<_> = mesh.vertices().iter().map(warped).collect();
        let far = Varifold::of(&moved, &mesh.triangles());
        assert!(aa - 2.0 * one.product(&far, 0.1) + far.product(&far, 0.1) > 0.05 * aa);
    }

    #[test]
    fn the_gradient_is_that_of_finite_differences() {
        let mesh = bean(1);
        let triangles = mesh.triangles();
        let other = Varifold::of(&mesh.vertices().iter().map(warped).collect::<Vec<_>>(), &triangles);
        let at = |vertices: &[Point3<f64>]| Varifold::of(vertices, &triangles).product_and_gradient(&other, 0.2);
        let gradient = at_vertices(&at(mesh.vertices()).1, mesh.vertices(), &triangles);
        let largest = gradient.iter().fold(0.0f64, |a, g| a.max(g.norm()));
        for v in 0..mesh.n_vertices() {
            for axis in 0..3 {
                let value = |d: f64| {
                    let mut moved = mesh.vertices().to_vec();
                    moved[v][axis] += d;
                    at(&moved).0
                };
                let difference = (value(1e-5) - value(-1e-5)) / 2e-5;
                assert!((difference - gradient[v][axis]).abs() < 1e-5 * largest);
            }
        }
    }
}
