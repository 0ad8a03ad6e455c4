//! Whether two surfaces are copies of one shape. Copies can be aligned more precisely than two subjects.

use homolog_primitives::observe::{Cancelled, Observer};
use homolog_registration::{IcpMetric, RigidTransform, SurfaceSide, TwoSidedOptions, align_both_ways};

/// Robust standard deviation of residuals along the normals after a rigid alignment up to which surfaces are copies, in
/// mean edge lengths of the target.
const MAX_COPY_RESIDUAL_EDGES: f64 = 0.17;
/// Least share of the area of one surface whose closest points lie inside the rim of the other. Surfaces that only
/// touch give no evidence.
const LEAST_OVERLAP: f64 = 0.5;
/// Points of each surface and steps of this alignment.
const SAMPLE: usize = 400;
const STEPS: u32 = 10;

/// A short alignment of two surfaces.
pub(crate) struct Aligned {
    pub target_from_source: RigidTransform,
    /// Whether the surfaces are copies of one shape.
    pub copies: bool,
}

/// Aligns `source` with `target` from `start` by a few steps of point-to-plane alignment in both directions. `edge_mm`
/// is the mean edge length of the target; the alignment ends when a step rotates by less than `tolerance` radians and
/// moves by less than `tolerance` diagonals of the source.
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
        copies: found.steps > 0
            && found.residual_mm <= MAX_COPY_RESIDUAL_EDGES * edge_mm
            && found.overlap >= LEAST_OVERLAP,
    })
}
