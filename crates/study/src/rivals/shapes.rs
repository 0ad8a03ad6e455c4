//! Shapes of mapped templates, and their distance: what remains between two maps after a rigid motion and a change of size.
//!
//! The distance is that of full Procrustes analysis, over the mean positions of patches of the template, weighted by area. It does
//! not depend on where a surface lies, so candidates are compared in the coordinates in which they were matched.
//!
//! Source: Dryden, Mardia, *Statistical Shape Analysis*, 2nd edition, 2016, chapter 4.

use crate::align::{area_weights, points};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::points::FarthestPoints;
use nalgebra::{Matrix3, Point3, Vector3};

/// Size of a shape, as a share of its distance from the origin, below which it is a point: the precision of 32 bits.
const ROUNDING: f64 = 1e-6;

/// Patches of a template.
pub(super) struct Patches {
    /// The patch of each vertex.
    of_vertex: Vec<usize>,
    /// The share of the area of each vertex.
    weights: Vec<f64>,
    /// That of each patch.
    areas: Vec<f64>,
}

/// A shape without place and size: centered, of centroid size 1, the position of each patch times the root of its weight.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape(Vec<Vector3<f64>>);

impl Patches {
    /// About `n` patches of equal size.
    pub(super) fn new(template: &SurfaceMesh, n: usize) -> Self {
        let (vertices, weights) = (template.vertices(), area_weights(template));
        let center: Vector3<f64> = vertices.iter().zip(&weights).map(|(p, w)| p.coords * *w).sum();
        let mut sampling = FarthestPoints::new(vertices, Point3::from(center));
        sampling.extend_to(n);
        let of_vertex: Vec<usize> = sampling.nearest_samples().collect();
        let mut areas = vec![0.0; sampling.samples().len()];
        of_vertex.iter().zip(&weights).for_each(|(&patch, w)| areas[patch] += w);
        Patches { of_vertex, weights, areas }
    }

    /// The shape of a mapped template; `None` if it is a point, or a number is not finite.
    pub(super) fn shape(&self, mapped: &[[f32; 3]]) -> Option<Shape> {
        let mut sums = vec![Vector3::zeros(); self.areas.len()];
        let points = points(mapped);
        for ((p, &patch), w) in points.iter().zip(&self.of_vertex).zip(&self.weights) {
            sums[patch] += p.coords * *w;
        }
        let center: Vector3<f64> = sums.iter().sum();
        let rooted = |(sum, &area): (&Vector3<f64>, &f64)| {
            if area > 0.0 { (sum - center * area) / area.sqrt() } else { Vector3::zeros() }
        };
        let mut rooted: Vec<Vector3<f64>> = sums.iter().zip(&self.areas).map(rooted).collect();
        let size = rooted.iter().map(Vector3::norm_squared).sum::<f64>().sqrt();
        let far = points.iter().map(|p| p.coords.norm()).fold(0.0, f64::max);
        if !(size.is_finite() && size > ROUNDING * far) {
            return None;
        }
        rooted.iter_mut().for_each(|p| *p /= size);
        Some(Shape(rooted))
    }
}

impl Shape {
    /// Squared distance of two shapes after the best rotation: from 0 to 2, without a unit.
    pub(super) fn squared_distance(&self, other: &Shape) -> f64 {
        let cross: Matrix3<f64> = self.0.iter().zip(&other.0).map(|(p, q)| p * q.transpose()).sum();
        let handed = cross.determinant().signum();
        let mut values = cross.singular_values();
        values.as_mut_slice().sort_by(|a, b| b.total_cmp(a));
        (2.0 * (1.0 - values[0] - values[1] - handed * values[2])).max(0.0)
    }

    /// Mean squared distance from other shapes; 0 for none.
    pub(super) fn mean_squared_distance<'a>(&self, others: impl Iterator<Item = &'a Shape>) -> f64 {
        let (sum, n) = others.fold((0.0, 0usize), |(sum, n), other| (sum + self.squared_distance(other), n + 1));
        sum / n.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Isometry3, Rotation3};
    use proptest::prelude::*;

    fn stored(points: impl Iterator<Item = Point3<f64>>) -> Vec<[f32; 3]> {
        points.map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect()
    }

    proptest! {
        #[test]
        fn motion_and_size_do_not_count_and_the_distance_is_that_after_the_best_rotation(
            angles in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-50.0..50.0f64), size in 0.5..2.0f64,
            bump in 0.0..0.5f64,
        ) {
            let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
            let patches = Patches::new(&mesh, 40);
            let motion = Isometry3::new(Vector3::from(shift), Vector3::from(angles));
            let bumped = |p: &Point3<f64>| p + Vector3::new(0.0, 0.0, bump * (-(p.x - 5.0).powi(2) / 8.0).exp());
            let first = patches.shape(&stored(mesh.vertices().iter().copied())).unwrap();
            let own = patches.shape(&stored(mesh.vertices().iter().map(bumped))).unwrap();
            let moved = mesh.vertices().iter().map(|p| motion * Point3::from(bumped(p).coords * size));
            let moved = patches.shape(&stored(moved)).unwrap();
            prop_assert!(own.squared_distance(&moved) < 1e-9);
            let (a, b) = (first.squared_distance(&own), own.squared_distance(&first));
            prop_assert!((a - b).abs() < 1e-12 && (first.squared_distance(&moved) - a).abs() < 1e-6);
            // No rotation brings them closer.
            for turn in [angles, [0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, -0.02], [0.0; 3]] {
                let turn = Rotation3::from_euler_angles(turn[0], turn[1], turn[2]);
                let apart: f64 = first.0.iter().zip(&own.0).map(|(p, q)| (turn * p - q).norm_squared()).sum();
                prop_assert!(apart >= a - 1e-12);
            }
        }
    }

    #[test]
    fn a_point_is_no_shape_and_a_mirror_image_is_another() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
        let patches = Patches::new(&mesh, 40);
        assert!(patches.shape(&vec![[1.0; 3]; mesh.n_vertices()]).is_none());
        assert!(patches.shape(&vec![[f32::NAN; 3]; mesh.n_vertices()]).is_none());
        let at = |p: &Point3<f64>| Point3::new(p.x, p.y + 0.1 * p.x * p.x, p.z + 0.2 * p.x * p.y);
        let own = patches.shape(&stored(mesh.vertices().iter().map(at))).unwrap();
        let image = patches.shape(&stored(mesh.vertices().iter().map(|p| {
            let q = at(p);
            Point3::new(-q.x, q.y, q.z)
        })));
        assert!(own.squared_distance(&image.unwrap()) > 0.01);
    }
}
