//! The fit in the other direction, of the target to the source, and both fits of two subjects.

use super::agreement::agreement;
use super::base::InitialMap;
use super::coarse::coarse_alone;
use super::displacement::FitContext;
use super::fine::fine;
use super::fitted::{FinalField, FineStageFit, LocalKernel, pose_of};
use super::functions::Functions;
use super::local::{MovedLocally, local, moved_locally, shown_kernel};
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
fn backward_positions(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    pose: &RigidTransform,
) -> Result<Option<Vec<Point3<f64>>>, MatchError> {
    let Some(back) = backwards(displacement, surfaces) else { return Ok(None) };
    let Some(state) = coarse_alone(&back, &pose.inverse()) else { return Ok(None) };
    Ok(run_remaining_stages(&back, state)?.map(|refined| refined.moved(surfaces.full_target)))
}

/// The same with the second kernel that the fit in this direction showed, not reported yet.
///
/// # Errors
/// [`MatchError::Cancelled`].
fn backward_positions_locally(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    pose: &RigidTransform,
    kernel: &LocalKernel,
) -> Result<Option<MovedLocally>, MatchError> {
    let Some(back) = backwards(displacement, surfaces) else { return Ok(None) };
    moved_locally(&back, &pose.inverse(), kernel, surfaces.full_target)
}

/// A field after all stages and, for two subjects, where a fit in the other direction moves the target.
pub(crate) struct BothWays {
    pub refined: FinalField,
    /// The vertices of the full target moved onto the source, mm.
    pub returned: Option<Vec<Point3<f64>>>,
}

/// Both fits, from the rigid part of `fine` in either direction and at the same time.
pub(crate) fn refined_both_ways(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    fine: FineStageFit,
) -> Result<BothWays, MatchError> {
    let moved = fine.moved();
    let Some(kernel) = shown_kernel(displacement, &moved) else {
        return with_backward_fit(displacement, surfaces, FinalField::of_fine_stage(displacement, fine));
    };
    if !is_fitted_both_ways(surfaces, &fine.track.base, fine.residual_mm) {
        return Ok(BothWays { refined: local(displacement, (fine, moved), kernel)?, returned: None });
    }
    let pose = pose_of(displacement, &moved, &fine.track.base.pose);
    let (refined, backward) = rayon::join(
        || local(displacement, (fine, moved), kernel),
        || backward_positions_locally(displacement, surfaces, &pose, &kernel),
    );
    // The fit in the other direction is reported after the one in this direction.
    Ok(BothWays { refined: refined?, returned: backward?.map(|backward| backward.reported(displacement)) })
}

/// `refined`, and after it the fit in the other direction, from its rigid part.
pub(crate) fn with_backward_fit(
    displacement: &FitContext<'_>,
    surfaces: &Surfaces<'_>,
    refined: FinalField,
) -> Result<BothWays, MatchError> {
    if !is_fitted_both_ways(surfaces, &refined.base, refined.residual_mm) {
        return Ok(BothWays { refined, returned: None });
    }
    let moved = refined.moved(&displacement.source.mesh);
    let pose = pose_of(displacement, &moved, &refined.base.pose);
    let returned = match &refined.local {
        Some(kernel) => backward_positions_locally(displacement, surfaces, &pose, kernel)?
            .map(|backward| backward.reported(displacement)),
        None => backward_positions(displacement, surfaces, &pose)?,
    };
    Ok(BothWays { refined, returned })
}

/// Whether surfaces are fitted in both directions: closed ones of two subjects, from a rigid base. A region that is missing on
/// one surface would have no counterpart in a fit in the other direction.
fn is_fitted_both_ways(surfaces: &Surfaces<'_>, base: &InitialMap, residual_mm: f64) -> bool {
    !surfaces.open && base.bend.is_none() && surfaces.lengths.are_of_two_subjects(residual_mm)
}
