//! Surfaces of tests.
#![allow(clippy::unwrap_used)]

use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::points::farthest_points;
use nalgebra::{Point3, Vector3};

/// A bent and tapered ellipsoid without symmetry, of area 1 about its centroid.
pub(crate) fn bean(level: u32) -> SurfaceMesh {
    let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
    let bent = |p: &Point3<f64>| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + 0.02 * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    };
    let mesh = mesh.with_vertices(mesh.vertices().iter().map(bent).collect()).unwrap();
    let frame = crate::Frame::of(&mesh).unwrap();
    mesh.with_vertices(mesh.vertices().iter().map(|p| frame.enter(p)).collect()).unwrap()
}

/// A smooth displacement of 5 % of the length of [`bean`].
pub(crate) fn warped(p: &Point3<f64>) -> Point3<f64> {
    p + 0.03 * Vector3::new((7.0 * p.y).sin(), (5.0 * p.x).sin(), (5.0 * p.x + 2.0 * p.y).cos())
}

/// Root mean square distance of corresponding points.
pub(crate) fn rms(a: &[Point3<f64>], b: &[Point3<f64>]) -> f64 {
    (a.iter().zip(b).map(|(p, q)| (p - q).norm_squared()).sum::<f64>() / a.len() as f64).sqrt()
}

/// `n` of `points`, evenly.
pub(crate) fn sampled(points: &[Point3<f64>], n: usize) -> Vec<Point3<f64>> {
    farthest_points(points, n).into_iter().map(|k| points[k]).collect()
}
