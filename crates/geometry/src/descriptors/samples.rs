//! A surface as points with normals and areas.

use crate::curvature::vertex_areas;
use homolog_mesh::SurfaceMesh;
use nalgebra::{Point3, Vector3};

/// Largest number of parts per side of a triangle: finer sampling of a ball with only a few triangles adds no
/// information.
const MOST_PARTS: usize = 4;

/// Points that represent the surface around them.
pub(super) struct Samples {
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
    /// Areas, mm².
    pub areas: Vec<f64>,
}

impl Samples {
    /// The vertices.
    pub(super) fn at_vertices(mesh: &SurfaceMesh) -> Self {
        // The area of a vertex between degenerate faces may be NaN, which becomes 0.
        let areas = vertex_areas(mesh).into_iter().map(|area| area.max(0.0)).collect();
        Samples { points: mesh.vertices().to_vec(), normals: mesh.vertex_normals(), areas }
    }

    /// The centers of equal parts of the triangles, `parts²` of each.
    pub(super) fn at_triangles(mesh: &SurfaceMesh, parts: usize) -> Self {
        let p = mesh.vertices();
        let mut samples = Samples { points: Vec::new(), normals: Vec::new(), areas: Vec::new() };
        let step = 1.0 / parts as f64;
        for triangle in mesh.triangles() {
            let [a, b, c] = triangle.map(|v| p[v as usize].coords);
            let across = (b - a).cross(&(c - a));
            let normal = across.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
            let mut add = |u: f64, v: f64| {
                samples.points.push(Point3::from(a + (b - a) * (u * step) + (c - a) * (v * step)));
                samples.normals.push(normal);
                samples.areas.push(0.5 * across.norm() * step * step);
            };
            for row in 0..parts {
                for column in 0..parts - row {
                    let (u, v) = (column as f64, row as f64);
                    add(u + 1.0 / 3.0, v + 1.0 / 3.0);
                    if column + 1 < parts - row {
                        add(u + 2.0 / 3.0, v + 2.0 / 3.0);
                    }
                }
            }
        }
        samples
    }

    /// Divides triangles until their edges are no longer than half of `bin_mm`, into at most 4² parts each.
    pub(super) fn finer_than(mesh: &SurfaceMesh, bin_mm: f64) -> Self {
        let parts = 2.0 * mesh.mean_edge_length() / bin_mm;
        Samples::at_triangles(mesh, (parts.ceil() as usize).clamp(1, MOST_PARTS))
    }
}

/// Two directions that form a right-handed frame with the unit vector `normal`.
pub(super) fn tangents(normal: &Vector3<f64>) -> [Vector3<f64>; 2] {
    // The axis farthest from the normal, so that the cross product is well away from zero.
    let u = normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize();
    [u, normal.cross(&u)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::descriptors::testing::bean;

    #[test]
    fn parts_have_the_area_and_the_moments_of_the_surface() {
        let mesh = bean(2);
        let moments = |parts: usize| {
            let samples = Samples::at_triangles(&mesh, parts);
            assert_eq!(samples.points.len(), parts * parts * mesh.n_faces());
            let sum = |value: &dyn Fn(&Point3<f64>) -> f64| -> f64 {
                samples.points.iter().zip(&samples.areas).map(|(p, a)| a * value(p)).sum()
            };
            [sum(&|_| 1.0), sum(&|p| p.x), sum(&|p| p.y), sum(&|p| p.x * p.x)]
        };
        let (one, four) = (moments(1), moments(4));
        assert!((one[0] - mesh.area()).abs() < 1e-9 && (four[0] - mesh.area()).abs() < 1e-9);
        assert!((1..3).all(|k| (one[k] - four[k]).abs() < 1e-9 * one[3]));
        // The error of a second moment falls with the square of the size of parts.
        let fine = moments(16)[3];
        assert!((four[3] - fine).abs() < 0.1 * (one[3] - fine).abs());
    }
}
