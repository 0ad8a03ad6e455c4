//! The fit in the other direction, of the target to the source.

use super::agreement::agreement;
use super::coarse::coarse_alone;
use super::displacement::FitContext;
use super::fine::fine;
use super::fitted::{FineStageFit, LocalKernel};
use super::functions::Functions;
use super::local::moved_locally;
use super::refine::run_remaining_stages;
use crate::error::MatchError;
use crate::pair::surfaces::{Surfaces, diagonal_mm};
use homolog_registration::RigidTransform;
use nalgebra::Point3;
use std::sync::Arc;

/// The fit of the target to the source after the fine stage.
pub(crate) struct ReverseFit<'a> {
    pub displacement: FitContext<'a>,
    /// The pose from which the fit began.
    pub pose: RigidTransform,
    pub fine: FineStageFit,
}

impl ReverseFit<'_> {
    /// Whether another start may give a better agreement.
    pub(crate) fn is_doubtful(&self) -> bool {
        agreement(&self.displacement, &self.fine.moved()).is_doubtful(&self.displacement.options.route)
    }
}

/// The target moved towards the source from the inverse of `pose`. `None` if a number is not finite.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn reverse_fit<'a>(
    displacement: &'a FitContext<'_>,
    surfaces: &Surfaces<'_>,
    pose: &RigidTransform,
) -> Result<Option<ReverseFit<'a>>, MatchError> {
    let Some(back) = backwards(displacement, surfaces) else { return Ok(None) };
    let pose = pose.inverse();
    let Some(state) = coarse_alone(&back, &pose) else { return Ok(None) };
    let fine = fine(&back, state)?;
    Ok(fine.map(|fine| ReverseFit { displacement: back, pose, fine }))
}

/// The displacement of the target onto the source. `None` if a number is not finite.
fn backwards<'a>(displacement: &'a FitContext<'_>, surfaces: &Surfaces<'_>) -> Option<FitContext<'a>> {
    let functions = Functions::over(surfaces.target, &displacement.target, displacement.options)?;
    Some(FitContext {
        source: Arc::clone(&displacement.target),
        target: Arc::clone(&displacement.source),
        guides: displacement.guides.swapped(&functions),
        functions,
        diagonal_mm: diagonal_mm(surfaces.target),
        ..*displacement
    })
}

/// The vertices of the full target moved onto the source by a fit in that direction, from the inverse of `pose`.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn backward_positions(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    pose: &RigidTransform,
    local: Option<LocalKernel>,
) -> Result<Option<Vec<Point3<f64>>>, MatchError> {
    let Some(back) = backwards(displacement, surfaces) else { return Ok(None) };
    let inverse = pose.inverse();
    match local {
        Some(local) => moved_locally(&back, &inverse, &local, surfaces.full_target),
        None => match coarse_alone(&back, &inverse) {
            Some(state) => Ok(run_remaining_stages(&back, state)?.map(|refined| refined.moved(surfaces.full_target))),
            None => Ok(None),
        },
    }
}
