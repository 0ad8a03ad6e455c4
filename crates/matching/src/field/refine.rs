//! All stages after the coarse one: middle, fine and local.

use super::base::State;
use super::displacement::FitContext;
use super::fine::fine;
use super::fitted::{FinalField, FineStageFit};
use super::local::{local, shown_kernel};
use crate::error::MatchError;

/// The field after all stages.
pub(crate) fn run_remaining_stages(
    displacement: &FitContext<'_>,
    start: State,
) -> Result<Option<FinalField>, MatchError> {
    match fine(displacement, start)? {
        Some(fine) => refined_from(displacement, fine).map(Some),
        None => Ok(None),
    }
}

/// The field after the local stage, from `fine`.
pub(crate) fn refined_from(displacement: &FitContext<'_>, fine: FineStageFit) -> Result<FinalField, MatchError> {
    let moved = fine.moved();
    match shown_kernel(displacement, &moved) {
        Some(kernel) => local(displacement, (fine, moved), kernel),
        None => Ok(FinalField::of_fine_stage(displacement, fine)),
    }
}
