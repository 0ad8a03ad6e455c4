//! All stages after the coarse one: middle, fine, and local or settling.

use super::base::State;
use super::displacement::FitContext;
use super::fine::fine;
use super::fitted::{FinalField, FineStageFit};
use super::local::local;
use super::settling::settle;
use crate::error::MatchError;

/// The field after all stages.
pub(crate) fn run_remaining_stages(
    displacement: &FitContext<'_>,
    start: State,
) -> Result<Option<FinalField>, MatchError> {
    match fine(displacement, start)? {
        Some(fine) => refined_from(displacement, fine),
        None => Ok(None),
    }
}

/// The field after the stages that follow the fine stage, from `fine`.
pub(crate) fn refined_from(
    displacement: &FitContext<'_>,
    fine: FineStageFit,
) -> Result<Option<FinalField>, MatchError> {
    match local(displacement, &fine)? {
        Some(refined) => Ok(Some(refined)),
        None => settle(displacement, fine),
    }
}
