//! Correspondence by spherical harmonics, as SPHARM-PDM has it: surfaces of genus 0 are mapped onto the sphere with equal areas,
//! their coordinates are expanded in spherical harmonics, and points correspond that have one direction once the axes of the
//! first-order ellipsoids are aligned.
//!
//! Sources: Brechbühler, Gerig, Kübler 1995; Styner et al., *Framework for the statistical shape analysis of brain structures using
//! SPHARM-PDM*, Insight Journal 2006.

use homolog_geometry::harmonics::{HarmonicSeries, ParametrizationOptions, first_order_ellipsoid, parametrize};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Silent;
use homolog_study::align::area_weights;
use nalgebra::{Matrix3, Point3, Vector3};

/// Degree of the expansion, that of hippocampi in the literature (Styner et al. 2004).
pub(crate) const DEGREE: u32 = 12;

/// A surface in spherical harmonics.
pub(crate) struct Expansion {
    /// Direction of each vertex on the sphere.
    directions: Vec<Vector3<f64>>,
    /// Of each vertex, their sum 1.
    weights: Vec<f64>,
    /// Axes of the first-order ellipsoid on the sphere, as columns, longest first; the signs of two are arbitrary.
    axes: Matrix3<f64>,
    series: HarmonicSeries,
}

impl Expansion {
    /// The expansion of a closed surface of genus 0 by weighted least squares over its vertices.
    pub(crate) fn new(mesh: &SurfaceMesh) -> Result<Self, String> {
        let map = parametrize(mesh, &ParametrizationOptions::default(), &Silent).map_err(|error| error.to_string())?;
        let ellipsoid = first_order_ellipsoid(mesh, &map).map_err(|error| error.to_string())?;
        let weights = area_weights(mesh);
        let series = HarmonicSeries::fit(&map.directions, mesh.vertices(), &weights, DEGREE)
            .ok_or("too few vertices for the degree")?;
        Ok(Expansion { directions: map.directions, weights, axes: ellipsoid.parameter_axes, series })
    }

    /// Where the vertices of this surface, `own`, lie on another. Of the four ways to align the axes the one counts that leaves the
    /// points nearest to where they were but for a translation: surfaces lie in their scanner's axes, and no head is upside down.
    pub(crate) fn images(&self, own: &[Point3<f64>], other: &Expansion) -> Vec<Point3<f64>> {
        let ways = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let image = |way: [f64; 3]| {
            let turn = other.axes * Matrix3::from_diagonal(&Vector3::from(way)) * self.axes.transpose();
            let points: Vec<Point3<f64>> = self.directions.iter().map(|n| other.series.at(&(turn * n))).collect();
            let steps = || points.iter().zip(own).map(|(q, p)| q - p).zip(&self.weights);
            let mean: Vector3<f64> = steps().map(|(step, w)| step * *w).sum();
            let spread: f64 = steps().map(|(step, w)| w * (step - mean).norm_squared()).sum();
            (spread, points)
        };
        let found = ways.map(image).into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        found.map(|(_, points)| points).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Rotation3;

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
