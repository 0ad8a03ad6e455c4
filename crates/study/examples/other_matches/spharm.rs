//! Correspondence by spherical harmonics, as SPHARM-PDM has it: surfaces of genus 0 are mapped onto the sphere with equal areas,
//! their coordinates are expanded in spherical harmonics, and points correspond that have one direction once the axes of the
//! first-order ellipsoids are aligned.
//!
//! Sources: Brechbühler, Gerig, Kübler 1995; Styner et al., *Framework for the statistical shape analysis of brain structures using
//! SPHARM-PDM*, Insight Journal 2006.

use homolog_geometry::harmonics::{ParametrizationOptions, first_order_ellipsoid, parametrize};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Silent;
use homolog_study::align::area_weights;
use nalgebra::{DMatrix, Matrix3, Point3, Vector3};
use std::f64::consts::PI;

/// Degree of the expansion, that of hippocampi in the literature (Styner et al. 2004).
pub(crate) const DEGREE: usize = 12;

/// A surface in spherical harmonics.
pub(crate) struct Expansion {
    /// Direction of each vertex on the sphere.
    directions: Vec<Vector3<f64>>,
    /// Of each vertex, their sum 1.
    weights: Vec<f64>,
    /// Axes of the first-order ellipsoid on the sphere, as columns, longest first; the signs of two are arbitrary.
    axes: Matrix3<f64>,
    /// A row for each harmonic, mm.
    coefficients: DMatrix<f64>,
}

impl Expansion {
    /// The expansion of a closed surface of genus 0 by weighted least squares over its vertices.
    pub(crate) fn new(mesh: &SurfaceMesh) -> Result<Self, String> {
        let map = parametrize(mesh, &ParametrizationOptions::default(), &Silent).map_err(|error| error.to_string())?;
        let ellipsoid = first_order_ellipsoid(mesh, &map).map_err(|error| error.to_string())?;
        let weights = area_weights(mesh);
        let rows: Vec<Vec<f64>> = map.directions.iter().map(harmonics).collect();
        let basis = DMatrix::from_fn(rows.len(), rows[0].len(), |v, k| rows[v][k] * weights[v].sqrt());
        let values = DMatrix::from_fn(rows.len(), 3, |v, axis| mesh.vertices()[v][axis] * weights[v].sqrt());
        let factor = basis.tr_mul(&basis).cholesky().ok_or("too few vertices for the degree")?;
        let coefficients = factor.solve(&basis.tr_mul(&values));
        Ok(Expansion { directions: map.directions, weights, axes: ellipsoid.parameter_axes, coefficients })
    }

    fn at(&self, direction: &Vector3<f64>) -> Point3<f64> {
        let harmonics = harmonics(direction);
        let of = |axis: usize| harmonics.iter().enumerate().map(|(k, h)| h * self.coefficients[(k, axis)]).sum();
        Point3::new(of(0), of(1), of(2))
    }

    /// Where the vertices of this surface, `own`, lie on another. Of the four ways to align the axes the one counts that leaves the
    /// points nearest to where they were but for a translation: surfaces lie in their scanner's axes, and no head is upside down.
    pub(crate) fn images(&self, own: &[Point3<f64>], other: &Expansion) -> Vec<Point3<f64>> {
        let ways = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let image = |way: [f64; 3]| {
            let turn = other.axes * Matrix3::from_diagonal(&Vector3::from(way)) * self.axes.transpose();
            let points: Vec<Point3<f64>> = self.directions.iter().map(|n| other.at(&(turn * n))).collect();
            let steps = || points.iter().zip(own).map(|(q, p)| q - p).zip(&self.weights);
            let mean: Vector3<f64> = steps().map(|(step, w)| step * *w).sum();
            let spread: f64 = steps().map(|(step, w)| w * (step - mean).norm_squared()).sum();
            (spread, points)
        };
        let found = ways.map(image).into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        found.map(|(_, points)| points).unwrap_or_default()
    }
}

/// Real spherical harmonics up to [`DEGREE`] at a unit vector, orthonormal on the sphere; order `m` of degree `l` at `l² + l + m`.
fn harmonics(n: &Vector3<f64>) -> Vec<f64> {
    let mut all = vec![0.0; (DEGREE + 1) * (DEGREE + 1)];
    // The factor sinᵐ θ of a Legendre function makes, with cos mφ and sin mφ, the real and imaginary part of (x + iy)ᵐ.
    let (mut real, mut imaginary, mut sectoral) = (1.0, 0.0, (1.0 / (4.0 * PI)).sqrt());
    for m in 0..=DEGREE {
        if m > 0 {
            (real, imaginary) = (real * n.x - imaginary * n.y, real * n.y + imaginary * n.x);
            sectoral *= ((2 * m + 1) as f64 / (2 * m) as f64).sqrt();
        }
        let (mut before, mut legendre) = (0.0, sectoral);
        for l in m..=DEGREE {
            if l > m {
                let (l, m) = (l as f64, m as f64);
                let factor = ((4.0 * l * l - 1.0) / (l * l - m * m)).sqrt();
                let last = (((l - 1.0) * (l - 1.0) - m * m) / (4.0 * (l - 1.0) * (l - 1.0) - 1.0)).sqrt();
                (before, legendre) = (legendre, factor * (n.z * legendre - last * before));
            }
            let at = l * l + l;
            if m == 0 {
                all[at] = legendre;
            } else {
                let root = 2.0f64.sqrt() * legendre;
                (all[at + m], all[at - m]) = (root * real, root * imaginary);
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Rotation3;

    #[test]
    fn harmonics_are_orthonormal() {
        // The 10,242 vertices of a subdivided icosahedron integrate nearly evenly over the sphere.
        let sphere = ellipsoid(Vector3::repeat(1.0), 5);
        let weights = area_weights(&sphere);
        let rows: Vec<Vec<f64>> = sphere.vertices().iter().map(|p| harmonics(&p.coords.normalize())).collect();
        for a in 0..rows[0].len() {
            for b in 0..=a {
                let inner: f64 = rows.iter().zip(&weights).map(|(row, w)| 4.0 * PI * w * row[a] * row[b]).sum();
                assert!((inner - f64::from(u8::from(a == b))).abs() < 0.01, "{a}, {b}: {inner}");
            }
        }
    }

    #[test]
    fn a_copy_on_another_grid_corresponds_to_itself() {
        let shape = |turn: f64| {
            let grid = Rotation3::from_euler_angles(turn, -turn, 2.0 * turn);
            let ball = ellipsoid(Vector3::repeat(1.0), 3);
            let points = ball.vertices().iter().map(|p| {
                let p = (grid * p.coords).component_mul(&Vector3::new(12.0, 6.0, 4.0));
                let taper = 1.0 + 0.03 * p.x;
                Point3::new(p.x, taper * p.y + 0.012 * p.x * p.x, taper * p.z)
            });
            ball.with_vertices(points.collect()).unwrap()
        };
        let (a, b) = (shape(0.0), shape(0.4));
        let images = Expansion::new(&a).unwrap().images(a.vertices(), &Expansion::new(&b).unwrap());
        let mut apart: Vec<f64> = images.iter().zip(a.vertices()).map(|(q, p)| (q - p).norm()).collect();
        apart.sort_by(f64::total_cmp);
        assert!(apart[apart.len() / 2] < 0.5 * a.mean_edge_length(), "{} mm", apart[apart.len() / 2]);
    }
}
