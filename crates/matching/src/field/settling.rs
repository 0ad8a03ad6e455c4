//! The settling stage: the residual along the normals sets the weight of the observations.

use super::displacement::Displacement;
use super::fine::followed;
use super::fitted::{Fine, Refined};
use crate::error::MatchError;

/// Residual along the normals, in sampling distances, below which two surfaces are copies of one anatomy.
const NOISE: f64 = 0.136;
/// Observations are weighted by `(noise / residual)` to this power: two for the variance, the rest because larger
/// residuals are correlated over larger areas.
const NOISE_POWER: f64 = 6.0;

/// The field after the settling stage.
pub(crate) fn settled(displacement: &Displacement<'_>, mut fine: Fine) -> Result<Option<Refined>, MatchError> {
    let residual_mm = fine.residual_mm;
    let weight = (NOISE * displacement.lengths.sampling_mm / residual_mm).powf(NOISE_POWER).min(1.0);
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
