//! The settling stage: the residual along the normals sets the weight of the observations.

use super::displacement::FitContext;
use super::fine::{Observed, run_stage};
use super::fitted::{FinalField, FineStageFit};
use crate::error::MatchError;

/// The field after the settling stage.
pub(crate) fn settle(displacement: &FitContext<'_>, mut fine: FineStageFit) -> Result<Option<FinalField>, MatchError> {
    let residual_mm = fine.residual_mm;
    let sliding = &displacement.options.sliding;
    let weight = (sliding.noise * displacement.lengths.sampling_mm / residual_mm).powf(sliding.noise_power).min(1.0);
    let observed = Observed::AlongNormals { weight };
    if !run_stage(displacement, &mut fine, &displacement.options.settling, observed)? {
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
