//! How well two surfaces agree once one is deformed onto the other.

use super::displacement::FitContext;
use super::settings::RouteSettings;
use super::strain::distortion;
use crate::surface::robust::correlation;
use crate::surface::smooth::{N_FEATURES, SmoothSurface};
use homolog_mesh::ClosestPoint;
use nalgebra::Point3;
use rayon::prelude::*;

/// Agreement of corresponding points. For copies of one anatomy both values are at least 0.95.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Agreement {
    /// Correlation of the mean curvatures at the largest scale, in `[−1, 1]`.
    pub curvature: f64,
    /// Mean cosine between corresponding normals, weighted by area of the source.
    pub normals: f64,
}

impl Agreement {
    /// Likeness of the two shapes under a map of this angular `distortion`: nearly 1 for copies, below 0 if the map
    /// distorts more than curvatures agree. A smooth field brings any two shapes close to each other, but unlike shapes
    /// only with strong stretching and without agreement of their curvatures.
    pub(crate) fn likeness(&self, distortion: f64) -> f64 {
        self.curvature - distortion
    }

    /// Whether another start may give a better agreement.
    pub(crate) fn is_doubtful(&self, settings: &RouteSettings) -> bool {
        self.normals < settings.doubtful_normals
    }
}

/// Likeness of the two shapes with the vertices of the source at `moved`: see [`Agreement::likeness`].
///
/// Cost `O(n log n')`.
pub(crate) fn likeness(displacement: &FitContext<'_>, moved: &[Point3<f64>]) -> f64 {
    agreement(displacement, moved).likeness(distortion(&displacement.source.mesh, moved))
}

/// Whether the two shapes are more alike than shapes that have nothing in common, the vertices of the source at `moved`.
///
/// Cost `O(n log n')`.
pub(crate) fn are_alike(displacement: &FitContext<'_>, moved: &[Point3<f64>]) -> bool {
    likeness(displacement, moved) > displacement.options.route.least_likeness
}

/// Agreement of the source, its vertices at `moved`, with the closest points of the target. Points closest to the rim
/// of the target are left out.
///
/// Cost `O(n log n')`; sums in order of the vertices.
pub(crate) fn agreement(displacement: &FitContext<'_>, moved: &[Point3<f64>]) -> Agreement {
    let closest = displacement.target.closest();
    let found: Vec<_> = moved.par_iter().map(|p| closest.index.closest(p)).collect();
    // A vertex beyond the rim of the target has no counterpart.
    let inside = |(_, at): &(usize, &ClosestPoint)| !closest.is_at_rim(at);
    let corresponding = || found.iter().enumerate().filter(inside);
    // The first of the two features at the largest scale is mean curvature.
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
