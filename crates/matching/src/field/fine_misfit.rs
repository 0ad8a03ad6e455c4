//! The misfit by which the ends of two attempts are compared.

use super::displacement::Displacement;
use super::track::placed;
use crate::pair::assignment::comparison_kernel;
use homolog_registration::alignment::{OrientedPoints, misfit};
use nalgebra::Point3;

/// Width of the assignment by which the ends of two attempts are compared, in roots of the area: that of the sampling of a
/// surface of about two thousand vertices.
pub(crate) const COMPARISON_SCALE: f64 = 0.02;
/// Vertices of the source that are compared.
pub(crate) const COMPARISON_SAMPLES: usize = 1200;

/// Misfit at the scale of the sampling of the source with its vertices at `moved`, by a pose that may have mirrored it: mean
/// of `−ln` of the likelihood of the other surface at each point; lower is better.
pub(crate) fn fine_misfit(displacement: &Displacement<'_>, moved: Vec<Point3<f64>>, mirrored: bool) -> f64 {
    let thinned = displacement.source.thinned(COMPARISON_SAMPLES);
    let kernel = comparison_kernel(COMPARISON_SCALE * displacement.lengths.root_mm);
    placed(displacement, &moved, mirrored, &thinned).map_or(f64::INFINITY, |placed| {
        let samples = OrientedPoints { points: &placed.points, normals: &placed.normals, ..thinned.samples() };
        misfit(&samples, &displacement.target.packed(), &kernel)
    })
}
