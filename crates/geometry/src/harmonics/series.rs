//! Spherical harmonics of any degree, fitted to a surface over its parameter sphere.
//!
//! Sources: Brechbühler, Gerig, Kübler 1995; Styner et al., "Framework for the statistical shape analysis of brain
//! structures using SPHARM-PDM", Insight Journal, 2006. The associated Legendre functions are computed by the recurrence
//! over degrees with normalized values (Press et al., *Numerical Recipes*, 2007, section 6.7).

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use nalgebra::{Point3, Vector3};
use std::f64::consts::PI;

/// `p(n) = Σ c_lm Y_lm(n)`, real harmonics that are orthonormal on the sphere, in the order `Y₀⁰, Y₁⁻¹, Y₁⁰, Y₁¹, Y₂⁻², …`.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicSeries {
    degree: u32,
    /// `(degree + 1)²` coefficients, mm, each with components x, y and z.
    coefficients_mm: Vec<Vector3<f64>>,
}

impl HarmonicSeries {
    /// The series of `degree` that best fits `points`, mm, at their unit vectors `directions`, with `weights` (areas on
    /// the sphere). `None` if the directions do not determine the series: fewer than `(degree + 1)²`, or numbers that
    /// are not finite.
    ///
    /// # Cost
    /// `O(n d⁴ + d⁶)` for degree `d`.
    pub fn fit(directions: &[Vector3<f64>], points: &[Point3<f64>], weights: &[f64], degree: u32) -> Option<Self> {
        let (n, m) = (directions.len(), count(degree));
        let mut values = Mat::zeros(n, m);
        let mut row = vec![0.0; m];
        for (i, direction) in directions.iter().enumerate() {
            harmonics(direction, degree, &mut row);
            row.iter().enumerate().for_each(|(k, y)| values[(i, k)] = *y);
        }
        let weighted = Mat::from_fn(n, m, |i, k| weights[i] * values[(i, k)]);
        let right = weighted.transpose() * Mat::from_fn(n, 3, |i, a| points[i][a]);
        let system = values.transpose() * &weighted;
        let factor = system.llt(Side::Lower).ok()?;
        let solved = factor.solve(right);
        let coefficients_mm: Vec<_> =
            (0..m).map(|k| Vector3::new(solved[(k, 0)], solved[(k, 1)], solved[(k, 2)])).collect();
        coefficients_mm
            .iter()
            .all(|c| c.iter().all(|x| x.is_finite()))
            .then_some(HarmonicSeries { degree, coefficients_mm })
    }

    /// The degree.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// The coefficients, mm.
    pub fn coefficients_mm(&self) -> &[Vector3<f64>] {
        &self.coefficients_mm
    }

    /// The point at the unit vector `direction`, mm. Cost `O(d²)`.
    pub fn at(&self, direction: &Vector3<f64>) -> Point3<f64> {
        let mut row = vec![0.0; self.coefficients_mm.len()];
        harmonics(direction, self.degree, &mut row);
        Point3::from(row.iter().zip(&self.coefficients_mm).map(|(y, c)| c * *y).sum::<Vector3<f64>>())
    }
}

/// Number of harmonics up to `degree`.
fn count(degree: u32) -> usize {
    (degree as usize + 1).pow(2)
}

/// All harmonics up to `degree` at the unit vector `n`, into `values`.
fn harmonics(n: &Vector3<f64>, degree: u32, values: &mut [f64]) {
    let degree = degree as usize;
    // P̄_m^m sin-free: the factor sin^m θ is part of the real and imaginary parts of (x + iy)^m.
    let (mut real, mut imaginary) = (1.0, 0.0);
    let mut diagonal = (1.0 / (4.0 * PI)).sqrt();
    for m in 0..=degree {
        let (mut before, mut here) = (0.0, diagonal);
        for l in m..=degree {
            let center = l * (l + 1);
            if m == 0 {
                values[center] = here;
            } else {
                let scaled = here * std::f64::consts::SQRT_2;
                values[center + m] = scaled * real;
                values[center - m] = scaled * imaginary;
            }
            // P̄_{l+1}^m = a_{l+1} (z P̄_l^m − P̄_{l−1}^m / a_l)
            let a = |l: usize| {
                let (l, m) = (l as f64, m as f64);
                ((4.0 * l * l - 1.0) / (l * l - m * m)).sqrt()
            };
            let previous = if l == m { 0.0 } else { before / a(l) };
            let next = a(l + 1) * (n.z * here - previous);
            before = here;
            here = next;
        }
        let k = m as f64 + 1.0;
        diagonal *= ((2.0 * k + 1.0) / (2.0 * k)).sqrt();
        (real, imaginary) = (real * n.x - imaginary * n.y, real * n.y + imaginary * n.x);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Matrix3;

    fn sphere(level: u32) -> (Vec<Vector3<f64>>, Vec<f64>) {
        let mesh = ellipsoid(Vector3::new(1.0, 1.0, 1.0), level);
        let directions: Vec<_> = mesh.vertices().iter().map(|p| p.coords).collect();
        (directions, crate::curvature::vertex_areas(&mesh))
    }

    #[test]
    fn harmonics_are_orthonormal_on_the_sphere() {
        let (directions, areas) = sphere(5);
        let total: f64 = areas.iter().sum();
        for (degree, tolerance) in [(5, 5e-3), (12, 1e-2)] {
            let n = count(degree);
            let mut gram = vec![0.0; n * n];
            let mut row = vec![0.0; n];
            for (direction, area) in directions.iter().zip(&areas) {
                harmonics(direction, degree, &mut row);
                for a in 0..n {
                    for b in 0..n {
                        gram[a * n + b] += area / total * 4.0 * PI * row[a] * row[b];
                    }
                }
            }
            for a in 0..n {
                for b in 0..n {
                    let expected = f64::from(u8::from(a == b));
                    assert!((gram[a * n + b] - expected).abs() < tolerance, "{a} {b}: {}", gram[a * n + b]);
                }
            }
        }
    }

    #[test]
    fn harmonics_of_low_degree_are_those_of_the_tables() {
        let n = Vector3::new(0.3, -0.5, 0.2).normalize();
        let mut row = vec![0.0; 9];
        harmonics(&n, 2, &mut row);
        let c = |x: f64| (x / PI).sqrt();
        let table = [
            0.5 * c(1.0),
            c(0.75) * n.y,
            c(0.75) * n.z,
            c(0.75) * n.x,
            0.5 * c(15.0) * n.x * n.y,
            0.5 * c(15.0) * n.y * n.z,
            0.25 * c(5.0) * (3.0 * n.z * n.z - 1.0),
            0.5 * c(15.0) * n.x * n.z,
            0.25 * c(15.0) * (n.x * n.x - n.y * n.y),
        ];
        for (value, expected) in row.iter().zip(table) {
            assert!((value - expected).abs() < 1e-14, "{value} {expected}");
        }
    }

    #[test]
    fn an_ellipsoid_is_a_series_of_degree_one() {
        let (directions, areas) = sphere(3);
        let matrix = Matrix3::new(9.0, 1.0, 0.0, 0.5, 5.0, 0.2, 0.0, -0.3, 3.0);
        let center = Vector3::new(20.0, -3.0, 1.0);
        let points: Vec<_> = directions.iter().map(|n| Point3::from(matrix * n + center)).collect();
        let series = HarmonicSeries::fit(&directions, &points, &areas, 6).unwrap();
        let linear = (4.0 * PI / 3.0).sqrt();
        let [constant, y, z, x] = [0, 1, 2, 3].map(|k| series.coefficients_mm()[k]);
        assert!((constant - center * (4.0 * PI).sqrt()).norm() < 1e-9);
        assert!((Matrix3::from_columns(&[x, y, z]) - matrix * linear).norm() < 1e-9);
        assert!(series.coefficients_mm()[4..].iter().all(|c| c.norm() < 1e-9));
        for (n, p) in directions.iter().zip(&points) {
            assert!((series.at(n) - p).norm() < 1e-9);
        }
    }
}
