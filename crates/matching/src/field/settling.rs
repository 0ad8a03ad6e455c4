//! The settling stage: the residual along the normals sets the weight of the observations.

use super::displacement::FitContext;
use super::fine::run_stage;
use super::fitted::{FinalField, FineStageFit};
use crate::error::MatchError;

/// The field after the settling stage.
pub(crate) fn settle(displacement: &FitContext<'_>, mut fine: FineStageFit) -> Result<Option<FinalField>, MatchError> {
    let residual_mm = fine.residual_mm;
    let weight = (displacement.options.fine.noise * displacement.lengths.sampling_mm / residual_mm)
        .powf(displacement.options.fine.noise_power)
        .min(1.0);
    if !run_stage(displacement, &mut fine, 3, displacement.options.steps[3], weight)? {
        return Ok(None);
    }
    Ok(Some(FinalField {
        base: fine.track.base,
        base_functions: displacement.functions.clone(),
        field: fine.field,
        functions: displacement.functions.clone(),
        residual_mm,
        local: None,
    }))
}
