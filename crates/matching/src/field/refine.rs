//! All stages after the coarse one: middle, fine, and local or settling.

use super::base::State;
use super::displacement::Displacement;
use super::fine::fine;
use super::fitted::{Fine, Refined};
use super::local::local;
use super::settling::settled;
use crate::error::MatchError;

/// The field after all stages.
pub(crate) fn refined(displacement: &Displacement<'_>, start: State) -> Result<Option<Refined>, MatchError> {
    match fine(displacement, start)? {
        Some(fine) => refined_from(displacement, fine),
        None => Ok(None),
    }
}

/// The field after the stages that follow the fine stage, from `fine`.
pub(crate) fn refined_from(displacement: &Displacement<'_>, fine: Fine) -> Result<Option<Refined>, MatchError> {
    match local(displacement, &fine)? {
        Some(refined) => Ok(Some(refined)),
        None => settled(displacement, fine),
    }
}
