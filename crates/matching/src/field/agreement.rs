//! How well two surfaces agree once one is deformed onto the other.

use super::displacement::Displacement;
use super::settings::RouteSettings;
use crate::surface::smooth::{N_FEATURES, SmoothSurface};
use homolog_mesh::ClosestPoint;
use nalgebra::Point3;
use rayon::prelude::*;

/// Agreement of corresponding points. Copies of one anatomy reach 0.95 and more in both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Agreement {
    /// Correlation of the mean curvatures at the largest scale, in `[−1, 1]`.
    pub curvature: f64,
    /// Mean cosine between the normals over the area of the source, however densely a part of it is sampled.
    pub normals: f64,
}

impl Agreement {
    /// Whether the surfaces may agree better from another start.
    pub(crate) fn is_doubtful(&self, settings: &RouteSettings) -> bool {
        self.curvature < settings.doubtful_curvature || self.normals < settings.doubtful_normals
    }
}

/// The agreement of the source, whose vertices are moved to `moved`, with the closest points of the target, without those on its rim.
///
/// Cost `O(n log n')`; sums in order of the vertices.
pub(crate) fn agreement(displacement: &Displacement<'_>, moved: &[Point3<f64>]) -> Agreement {
    let closest = displacement.target.closest();
    let found: Vec<_> = moved.par_iter().map(|p| closest.index.closest(p)).collect();
    // What lies beyond the rim of the target has no counterpart there.
    let inside = |(_, at): &(usize, &ClosestPoint)| !closest.is_at_rim(at);
    let corresponding = || found.iter().enumerate().filter(inside);
    // Of the features at the largest scale the first is mean curvature.
    let feature = |side: &SmoothSurface, i: usize| side.features[(i + 1) * N_FEATURES - 2];
    let pairs: Vec<(f64, f64)> = corresponding()
        .map(|(i, at)| (feature(&displacement.source, i), at.blend(|k| feature(&displacement.target, k))))
        .collect();
    let normals = match displacement.source.mesh.with_vertices(moved.to_vec()) {
        Ok(mesh) => mesh.vertex_normals(),
        Err(_) => displacement.source.normals.clone(),
    };
    let (mut cosines, mut area) = (0.0, 0.0);
    for (i, at) in corresponding() {
        cosines += displacement.source.areas[i] * at.blend(|k| displacement.target.normals[k].dot(&normals[i]));
        area += displacement.source.areas[i];
    }
    // All faces of a mirrored surface are oriented inwards.
    let mean = if area > 0.0 { cosines / area } else { 0.0 };
    Agreement { curvature: correlation(&pairs), normals: mean.abs() }
}

/// Pearson's correlation; 0 where one side does not vary.
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
