//! The fit in the other direction, of the target to the source.

use super::agreement::agreement;
use super::choice::choose_pose;
use super::coarse::coarse_alone;
use super::displacement::FitContext;
use super::fine::fine;
use super::fitted::{FineStageFit, LocalKernel};
use super::functions::Functions;
use super::local::locally_from;
use super::refine::run_remaining_stages;
use crate::error::MatchError;
use crate::pair::lengths::ONE_ANATOMY;
use crate::pair::surfaces::{Surfaces, diagonal_mm};
use crate::starts::start_pose::StartPose;
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
    /// Whether the residual is as large as between two subjects.
    pub(crate) fn is_of_two_subjects(&self) -> bool {
        self.fine.residual_mm >= ONE_ANATOMY * self.displacement.lengths.sampling_mm
    }

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
    let Some(start) = choose_pose(&back, &[StartPose::of(pose)], |_| true)? else { return Ok(None) };
    let fine = fine(&back, start.state)?;
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
    let refined = match local {
        Some(local) => locally_from(&back, &inverse, &local)?,
        None => match coarse_alone(&back, &inverse) {
            Some(state) => run_remaining_stages(&back, state)?,
            None => None,
        },
    };
    Ok(refined.map(|refined| refined.moved(surfaces.full_target)))
}
