//! Areas of triangles on the unit sphere, and their target areas.

use homolog_mesh::SurfaceMesh;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Smallest target area as a share of the mean: degenerate triangles get a positive area on the sphere.
const SMALLEST_SHARE: f64 = 1e-2;

/// The triangles of a surface and their target areas on the unit sphere, which sum to `4π`.
pub(super) struct TargetAreas {
    pub triangles: Vec<[usize; 3]>,
    pub areas: Vec<f64>,
    pub n_vertices: usize,
}

impl TargetAreas {
    pub(super) fn new(mesh: &SurfaceMesh) -> Self {
        let triangles: Vec<[usize; 3]> = mesh.triangles().iter().map(|t| t.map(|k| k as usize)).collect();
        let v = mesh.vertices();
        let mut areas: Vec<f64> =
            triangles.iter().map(|&[a, b, c]| (v[b] - v[a]).cross(&(v[c] - v[a])).norm() / 2.0).collect();
        let smallest = SMALLEST_SHARE * areas.iter().sum::<f64>() / areas.len() as f64;
        for area in &mut areas {
            *area = area.max(smallest);
        }
        let scale = 4.0 * PI / areas.iter().sum::<f64>();
        for area in &mut areas {
            *area *= scale;
        }
        TargetAreas { triangles, areas, n_vertices: mesh.n_vertices() }
    }

    /// For every vertex a third of the target areas of its triangles.
    pub(super) fn of_vertices(&self) -> Vec<f64> {
        vertex_shares(&self.triangles, &self.areas, self.n_vertices)
    }

    /// Triangles whose determinant is at most twice `share` of their area: folded for `0`, crushed for slightly larger
    /// values.
    pub(super) fn smaller_than(&self, share: f64, directions: &[Vector3<f64>]) -> Vec<usize> {
        (0..self.triangles.len())
            .filter(|&f| determinant(self.triangles[f].map(|k| directions[k])) <= 2.0 * share * self.areas[f])
            .collect()
    }

    /// Area-weighted root mean square of `area on the sphere / target area − 1`.
    pub(super) fn distortion(&self, directions: &[Vector3<f64>]) -> f64 {
        let squares: f64 = self
            .triangles
            .iter()
            .zip(&self.areas)
            .map(|(t, &wanted)| {
                let share = spherical_area(t.map(|k| directions[k])) / wanted - 1.0;
                wanted * share * share
            })
            .sum();
        (squares / (4.0 * PI)).sqrt()
    }
}

/// `values` of triangles distributed to their corners, a third each.
pub(super) fn vertex_shares(triangles: &[[usize; 3]], values: &[f64], n_vertices: usize) -> Vec<f64> {
    let mut shares = vec![0.0; n_vertices];
    for (t, value) in triangles.iter().zip(values) {
        for &k in t {
            shares[k] += value / 3.0;
        }
    }
    shares
}

/// `a · (b × c)` of three unit vectors: positive if they are counter-clockwise seen from outside the sphere, and nearly
/// twice the area of a small triangle.
pub(super) fn determinant([a, b, c]: [Vector3<f64>; 3]) -> f64 {
    a.dot(&b.cross(&c))
}

/// Signed area of the spherical triangle with these unit vectors as corners, in `(−2π, 2π)`.
///
/// Source: Van Oosterom, Strackee, IEEE Trans. Biomed. Eng. 30(2), 1983.
pub(super) fn spherical_area([a, b, c]: [Vector3<f64>; 3]) -> f64 {
    2.0 * determinant([a, b, c]).atan2(1.0 + a.dot(&b) + b.dot(&c) + c.dot(&a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_octant_is_an_eighth_of_the_sphere() {
        let octant = [Vector3::x(), Vector3::y(), Vector3::z()];
        assert!((spherical_area(octant) - PI / 2.0).abs() < 1e-15);
        assert!((spherical_area([octant[1], octant[0], octant[2]]) + PI / 2.0).abs() < 1e-15);
    }

    #[test]
    fn areas_equal_the_spherical_excess_and_approach_half_the_determinant() {
        // By definition, from the angles between the great circles that bound the triangle.
        let girard = |[a, b, c]: [Vector3<f64>; 3]| {
            let corner = |p: Vector3<f64>, q: Vector3<f64>, r: Vector3<f64>| p.cross(&q).angle(&p.cross(&r));
            corner(a, b, c) + corner(b, c, a) + corner(c, a, b) - PI
        };
        for size in [0.9, 0.3, 0.05] {
            let t = [[0.0, 0.0], [size, 0.1 * size], [0.3 * size, size]]
                .map(|[x, y]: [f64; 2]| Vector3::new(x, y, 1.0).normalize());
            assert!((spherical_area(t) - girard(t)).abs() < 1e-12);
            assert!((determinant(t) / 2.0 / girard(t) - 1.0).abs() < size * size);
        }
    }
}
