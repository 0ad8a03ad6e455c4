//! Spread of the answers from starts that are rotated about the axis about which a surface is most nearly round.
//!
//! The rotation of a surface of revolution about its axis cannot be determined; the rotation of a nearly round surface
//! hardly can. A smooth deformation compensates for a wrong rotation, so that each start ends at a different answer
//! with nearly the same misfit (docs/findings.md). The posterior of one field is that of a linear model and covers only
//! the surroundings of its own answer. Where displacements along the surface change heights by more than their noise
//! ([`super::uncertainty::DisplacementPosterior::second_order`]), that is not enough: the field is fitted from a rotated
//! start as well, and the spread of the fits, weighted by probability, is added to the variance. A start rotated the other way is taken to
//! end as far away on the other side: fitting it too changes calibration errors by less than they differ between pairs (docs/findings.md).

use super::base::State;
use super::coarse::coarse_alone;
use super::displacement::FitContext;
use super::fine::fine_aside;
use super::fine_misfit::fine_misfit;
use super::options::DisplacementOptions;
use crate::error::MatchError;
use crate::surface::round_axis::RoundAxis;
use homolog_primitives::observe::checkpoint;
use homolog_registration::RigidTransform;
use nalgebra::Point3;

/// Rotation about the axis from which the field is fitted as well, degrees.
const ANGLE_DEG: f64 = 20.0;

/// Mean squared distance from `own`, the fit after the fine stage, at each of the `points` of the source, mm²: of itself and of fits
/// from `pose`, rotated either way about the axis about which the source is most nearly round. `None` if a number is not finite.
///
/// Cost: the first three stages.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn spread_of_rotations(
    displacement: &FitContext<'_>,
    points: &[Point3<f64>],
    (own, pose): (&State, &RigidTransform),
) -> Result<Option<Vec<f64>>, MatchError> {
    let vertices = displacement.source.mesh.vertices();
    let Some(axis) = RoundAxis::of(vertices, &displacement.source.areas) else { return Ok(None) };
    let values = displacement.functions.values(points);
    let misfit =
        |state: &State, moved: &[Point3<f64>]| fine_misfit(displacement, moved, state.base.pose.is_reflection());
    let of_own = || misfit(own, &own.moved(vertices, &displacement.functions.values(vertices)));
    let rotated = || -> Result<Option<(f64, State)>, MatchError> {
        checkpoint(displacement.observer)?;
        let start = axis.rotated(pose, ANGLE_DEG.to_radians());
        let Some(state) = coarse_alone(displacement, &start) else { return Ok(None) };
        let Some(fine) = fine_aside(displacement, state, None)? else { return Ok(None) };
        let state = fine.state();
        Ok(Some((misfit(&state, &fine.moved()), state)))
    };
    let (of_own, rotated) = rayon::join(of_own, rotated);
    let Some((of_rotated, rotated)) = rotated? else { return Ok(None) };
    let share = share_of_others(of_own, of_rotated, displacement.options);
    let (from, to) = (own.moved(points, &values), rotated.moved(points, &values));
    Ok(share.is_finite().then(|| from.iter().zip(to).map(|(p, q)| share * (q - p).norm_squared()).collect()))
}

/// The probability of two fits with the misfit `of_others` beside one with `of_own`. A misfit is the mean of `−ln` of a likelihood;
/// the number of independent observations of a surface is that of the coarse stage.
fn share_of_others(of_own: f64, of_others: f64, options: &DisplacementOptions) -> f64 {
    2.0 / (2.0 + (options.coarse.observations[0] * (of_others - of_own)).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fits_count_by_their_probability() {
        let share = |of_others: f64| share_of_others(1.0, of_others, &DisplacementOptions::default());
        assert_eq!(share(1.0), 2.0 / 3.0);
        assert!(share(1.02) > 0.4 && share(1.02) < share(1.0) && share(2.0) < 1e-12 && share(0.0) > 1.0 - 1e-12);
    }
}
