//! The misfit by which two complete fits are compared.

use super::displacement::FitContext;
use super::track::placed;
use crate::pair::assignment::comparison_kernel;
use homolog_registration::alignment::{OrientedPoints, misfit};
use nalgebra::Point3;

/// Width of the assignment in this misfit, in roots of the area: the sampling distance of a surface of about 2000
/// vertices.
pub(crate) const COMPARISON_SCALE: f64 = 0.02;
/// Most source vertices that are compared.
pub(crate) const COMPARISON_SAMPLES: usize = 1200;

/// Misfit of the source with its vertices at `moved`, at the scale of its sampling: mean of `−ln` of the likelihood of
/// each point of either surface under the other; lower is better. `mirrored`: whether the pose mirrors the source.
pub(crate) fn fine_misfit(displacement: &FitContext<'_>, moved: &[Point3<f64>], mirrored: bool) -> f64 {
    let thinned = displacement.source.thinned(COMPARISON_SAMPLES);
    let kernel = comparison_kernel(COMPARISON_SCALE * displacement.lengths.root_mm);
    placed(displacement, moved, mirrored, &thinned).map_or(f64::INFINITY, |placed| {
        let samples = OrientedPoints { points: &placed.points, normals: &placed.normals, ..thinned.samples() };
        misfit(&samples, &displacement.target.assignment_target(), &kernel)
    })
}
