//! The settling stage: the residual along the normals sets the weight of the observations.

use super::displacement::Displacement;
use super::fine::followed;
use super::fitted::{Fine, Refined};
use crate::error::MatchError;

/// The field after the settling stage.
pub(crate) fn settled(displacement: &Displacement<'_>, mut fine: Fine) -> Result<Option<Refined>, MatchError> {
    let residual_mm = fine.residual_mm;
    let weight = (displacement.options.fine.noise * displacement.lengths.sampling_mm / residual_mm)
        .powf(displacement.options.fine.noise_power)
        .min(1.0);
    if !followed(displacement, &mut fine, 3, displacement.options.steps[3], weight)? {
        return Ok(None);
    }
    Ok(Some(Refined {
        base: fine.track.base,
        base_functions: displacement.functions.clone(),
        field: fine.field,
        functions: displacement.functions.clone(),
        residual_mm,
        local: None,
    }))
}
