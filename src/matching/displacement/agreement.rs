//! How alike two surfaces are once one is bent onto the other.

use super::surface::{N_FEATURES, SmoothSurface};
use crate::mesh::ClosestPointIndex;
use nalgebra::Point3;
use rayon::prelude::*;

/// Likeness of corresponding points. Copies of one anatomy reach 0.95 and more in both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Correlation of the mean curvatures at the largest scale, in `[−1, 1]`.
    pub curvature: f64,
    /// Mean cosine between the normals.
    pub normals: f64,
}

/// The agreement of `source`, whose vertices are moved to `moved`, with the closest points of `target`.
///
/// Cost `O(n log n')`; sums in order of the vertices.
pub(super) fn agreement(source: &SmoothSurface, target: &SmoothSurface, moved: &[Point3<f64>]) -> Agreement {
    let closest = ClosestPointIndex::new(&target.mesh);
    let found: Vec<_> = moved.par_iter().map(|p| closest.closest(p)).collect();
    // Of the features at the largest scale the first is mean curvature.
    let feature = N_FEATURES - 2;
    let pairs: Vec<(f64, f64)> = found
        .iter()
        .enumerate()
        .map(|(i, at)| {
            let there = (0..3)
                .map(|k| target.features[at.triangle[k] as usize * N_FEATURES + feature] * at.barycentric[k])
                .sum();
            (source.features[i * N_FEATURES + feature], there)
        })
        .collect();
    let normals = match source.mesh.with_vertices(moved.to_vec()) {
        Ok(mesh) => mesh.vertex_normals(),
        Err(_) => source.normals.clone(),
    };
    let cosine = |(i, at): (usize, &crate::mesh::ClosestPoint)| -> f64 {
        (0..3).map(|k| target.normals[at.triangle[k] as usize].dot(&normals[i]) * at.barycentric[k]).sum()
    };
    // The faces of a mirrored surface look inwards, all of them.
    let mean = found.iter().enumerate().map(cosine).sum::<f64>() / found.len() as f64;
    Agreement { curvature: correlation(&pairs), normals: mean.abs() }
}

/// Pearson's; 0 where one side does not vary.
fn correlation(pairs: &[(f64, f64)]) -> f64 {
    let n = pairs.len() as f64;
    let (a, b) = pairs.iter().fold((0.0, 0.0), |(a, b), p| (a + p.0 / n, b + p.1 / n));
    let (ab, aa, bb) = pairs.iter().fold((0.0, 0.0, 0.0), |(ab, aa, bb), p| {
        let (x, y) = (p.0 - a, p.1 - b);
        (ab + x * y, aa + x * x, bb + y * y)
    });
    let spread = (aa * bb).sqrt();
    if spread > 0.0 { ab / spread } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::correlation;

    #[test]
    fn correlation_is_that_of_pearson() {
        let line: Vec<(f64, f64)> = (0..9).map(|k| (f64::from(k), 3.0 - 2.0 * f64::from(k))).collect();
        assert!((correlation(&line) + 1.0).abs() < 1e-12);
        // Hand-computed: x 1 2 3, y 1 3 2.
        assert!((correlation(&[(1.0, 1.0), (2.0, 3.0), (3.0, 2.0)]) - 0.5).abs() < 1e-12);
        assert_eq!(correlation(&[(1.0, 2.0), (1.0, 3.0)]), 0.0);
    }
}
