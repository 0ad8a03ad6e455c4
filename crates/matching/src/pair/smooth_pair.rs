//! Both surfaces prepared for a displacement field, with curvature features standardized together.

use super::role::Role;
use super::surfaces::Surfaces;
use crate::error::MatchError;
use crate::surface::robust::Standard;
use crate::surface::smooth::{Flow, N_FEATURES, SmoothSurface};
use homolog_mesh::SurfaceMesh;
use std::sync::Arc;

/// Median distance by which light smoothing moves the vertices of a surface without noise, in roots of the area: the
/// value for hippocampi from voxels of 1 mm. Surfaces with a larger distance are noisy, and all scales are multiplied
/// by the ratio.
const GRAIN: f64 = 0.00225;
const MAX_COARSENING: f64 = 4.0;

/// Width of the rim of a part where weights are reduced, in roots of the area: about `σ` of the assignment in the
/// coarse stage, 4 to 5 % of the diagonal.
const RIM: f64 = 0.05;

/// Two surfaces prepared for displacement, the source first.
pub(crate) type SmoothPair = (Arc<SmoothSurface>, Arc<SmoothSurface>);

impl Surfaces<'_> {
    /// Both surfaces, prepared; the weights of a part are reduced at its rim.
    ///
    /// # Errors
    /// [`MatchError::ScaleSpace`].
    pub(crate) fn smoothed(&self) -> Result<SmoothPair, MatchError> {
        let Surfaces { source, target, lengths, part, .. } = *self;
        match part {
            // The part is the surface that is deformed.
            Some(Role::Target) => {
                smooth_pair(target, source, lengths.root_mm, true).map(|(target, source)| (source, target))
            }
            _ => smooth_pair(source, target, lengths.root_mm, part == Some(Role::Source)),
        }
    }
}

/// Both surfaces, prepared; the source may be a part. Features are standardized by the median and the median absolute
/// deviation over both surfaces.
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub(crate) fn smooth_pair(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    root_mm: f64,
    source_is_part: bool,
) -> Result<SmoothPair, MatchError> {
    let (a, b) = rayon::join(|| Flow::new(source, root_mm), || Flow::new(target, root_mm));
    let (a, b) = (a?, b?);
    // Both use the same scales: at different ones the smoother surface would have lower curvature.
    let coarsening = (a.grain_mm().max(b.grain_mm()) / (GRAIN * root_mm)).clamp(1.0, MAX_COARSENING);
    let (a, b) = rayon::join(|| a.surface(coarsening), || b.surface(coarsening));
    let ((mut a, a_values), (mut b, b_values)) = (a?, b?);
    for (feature, (of_a, of_b)) in a_values.iter().zip(&b_values).enumerate() {
        let standard = Standard::of_both(of_a, of_b);
        for (values, side) in [(of_a, &mut a), (of_b, &mut b)] {
            for (i, x) in values.iter().enumerate() {
                side.features[i * N_FEATURES + feature] = standard.score(*x);
            }
        }
    }
    if source_is_part {
        a.discount_rim(RIM * root_mm);
    }
    Ok((Arc::new(a), Arc::new(b)))
}
