//! Points spread evenly over a set of points.
//!
//! Source: farthest-point sampling, Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985: at
//! most twice as far from any point as the best choice of as many.

use nalgebra::{Point3, Vector3};

/// Indices of up to `n` of `points`, each the farthest from those before it; the first is the farthest from the
/// centroid. Of points equally far the lowest index. Ends early where every other point coincides with a chosen one.
///
/// Cost `O(n · points)`.
pub fn farthest_points(points: &[Point3<f64>], n: usize) -> Vec<usize> {
    let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len().max(1) as f64;
    let mut distance: Vec<f64> = points.iter().map(|p| (p.coords - center).norm_squared()).collect();
    let mut chosen: Vec<usize> = Vec::with_capacity(n.min(points.len()));
    while chosen.len() < n.min(points.len()) {
        let mut next = 0;
        for (i, &d) in distance.iter().enumerate() {
            if d > distance[next] {
                next = i;
            }
        }
        if !chosen.is_empty() && distance[next] <= 0.0 {
            break;
        }
        let at = points[next];
        let first = chosen.is_empty();
        for (d, p) in distance.iter_mut().zip(points) {
            let from_new = (p - at).norm_squared();
            *d = if first { from_new } else { d.min(from_new) };
        }
        chosen.push(next);
    }
    chosen
}
