//! Spread of the answers from starts that are rotated about the axis about which a surface is most nearly round.
//!
//! The rotation of a surface of revolution about its axis cannot be determined; the rotation of a nearly round surface
//! hardly can. A smooth deformation compensates for a wrong rotation, so that each start ends at a different answer
//! with nearly the same misfit (docs/findings.md). The posterior of one field is that of a linear model and covers only
//! the surroundings of its own answer. Where displacements along the surface change heights by more than their noise
//! ([`super::uncertainty::DisplacementPosterior::second_order`]), that is not enough: the field is fitted from several
//! rotations, and their spread, weighted by probability, is added to the variance.

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
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Rotations about the axis from which the field is fitted as well, degrees.
const ANGLES_DEG: [f64; 2] = [-20.0, 20.0];

/// Mean squared distance, at each of the `points` of the source, of several fits from their mean, mm²: of `own`, the fit
/// after the fine stage, and of fits from `pose`, rotated about the axis about which the source is most nearly round.
/// `None` if a number is not finite.
///
/// Cost: twice the first three stages.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn spread_of_rotations(
    displacement: &FitContext<'_>,
    points: &[Point3<f64>],
    (own, pose): (&State, &RigidTransform),
) -> Result<Option<Vec<f64>>, MatchError> {
    let Some(axis) = RoundAxis::of(displacement.source.mesh.vertices(), &displacement.source.areas) else {
        return Ok(None);
    };
    let starts = ANGLES_DEG.map(|angle| axis.rotated(pose, angle.to_radians()));
    let values = displacement.functions.values(points);
    let end = |state: &State, moved: &[Point3<f64>]| {
        let misfit = fine_misfit(displacement, moved, state.base.pose.is_reflection());
        (misfit, state.moved(points, &values))
    };
    let own_end = || {
        let vertices = displacement.source.mesh.vertices();
        end(own, &own.moved(vertices, &displacement.functions.values(vertices)))
    };
    let rotated = |start: &RigidTransform| {
        checkpoint(displacement.observer)?;
        let Some(state) = coarse_alone(displacement, start) else { return Ok(None) };
        let Some(fine) = fine_aside(displacement, state, None)? else { return Ok(None) };
        Ok(Some(end(&fine.state(), &fine.moved())))
    };
    let (own, rotated) =
        rayon::join(own_end, || starts.par_iter().map(rotated).collect::<Result<Vec<_>, MatchError>>());
    let Some(mut fits) = rotated?.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    fits.insert(0, own);
    Ok(spread(&fits, displacement.options))
}

/// Mean squared distance of `fits`, each a misfit and moved points, from their mean at each point, mm², weighted by
/// their probability. A misfit is the mean of `−ln` of a likelihood; the number of independent observations of a
/// surface is that of the coarse stage.
fn spread(fits: &[(f64, Vec<Point3<f64>>)], options: &DisplacementOptions) -> Option<Vec<f64>> {
    let least = fits.iter().map(|fit| fit.0).fold(f64::INFINITY, f64::min);
    let weights: Vec<f64> = fits.iter().map(|fit| (-options.coarse.observations[0] * (fit.0 - least)).exp()).collect();
    let total: f64 = weights.iter().sum();
    let first = &fits.first()?.1;
    let at = |i: usize| {
        let away = || fits.iter().zip(&weights).map(move |((_, moved), w)| (moved[i] - first[i], w / total));
        let mean: Vector3<f64> = away().map(|(d, w)| d * w).sum();
        away().map(|(d, w)| (d - mean).norm_squared() * w).sum()
    };
    total.is_finite().then(|| (0..first.len()).map(at).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fits_count_by_their_probability() {
        let at = |x: f64| vec![Point3::new(x, 0.0, 0.0), Point3::new(0.0, 2.0 * x, 0.0)];
        let options = DisplacementOptions::default();
        let spread = |misfits: [f64; 2]| spread(&[(misfits[0], at(0.0)), (misfits[1], at(4.0))], &options).unwrap();
        assert_eq!(spread([1.0, 1.0]), [4.0, 16.0]);
        let [near, far] = [spread([1.0, 1.02]), spread([1.0, 2.0])];
        assert!(near[0] > 2.0 && near[0] < 4.0 && far[0] < 1e-12, "{near:?} {far:?}");
    }
}
