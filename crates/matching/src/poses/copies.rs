//! Whether two surfaces are copies of one shape: they can then be aligned more finely than two subjects.

use homolog_primitives::observe::{Cancelled, Observer};
use homolog_registration::{IcpMetric, RigidTransform, SurfaceSide, TwoSidedOptions, align_both_ways};

/// Robust standard deviation of the residuals along the normals, in mean target edge lengths, up to which surfaces are
/// copies: at most 0.14 for re-sampled copies, also noisy ones, and 0.11 to 0.15 for forty copies with an end cut off; from
/// 0.30 on for different subjects, and from 0.54 for warps of 8 % of the diagonal.
const COPY_EDGES: f64 = 0.2;
/// Share of the area of one of them whose closest points have to lie inside the rim of the other: surfaces that only touch show
/// nothing of each other.
const LEAST_OVERLAP: f64 = 0.5;
/// Points of each surface, and steps of the alignment that tells.
const SAMPLE: usize = 400;
const STEPS: u32 = 10;

/// A short alignment of two surfaces.
pub(crate) struct Aligned {
    pub target_from_source: RigidTransform,
    /// Whether the surfaces are copies of one shape.
    pub copies: bool,
}

/// Aligns `source` with `target` from `start` by a few steps of points against planes in both directions. `edge_mm` is the
/// mean edge length of the target; the alignment ends when a step rotates by less than `tolerance` radians and moves by
/// less than `tolerance` diagonals of the source.
///
/// # Errors
/// [`Cancelled`].
pub(crate) fn align_shortly(
    source: &SurfaceSide<'_>,
    target: &SurfaceSide<'_>,
    start: &RigidTransform,
    (edge_mm, tolerance): (f64, f64),
    observer: &dyn Observer,
) -> Result<Aligned, Cancelled> {
    let options = TwoSidedOptions {
        metric: IcpMetric::PointToPlane,
        max_sample: SAMPLE,
        sample_steps: STEPS,
        full_steps: 0,
        tolerance,
    };
    let found = align_both_ways(source, target, start, &options, observer)?;
    Ok(Aligned {
        target_from_source: found.target_from_source,
        copies: found.steps > 0 && found.residual_mm <= COPY_EDGES * edge_mm && found.overlap >= LEAST_OVERLAP,
    })
}
