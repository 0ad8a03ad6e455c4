//! Nearly round surfaces: how far answers from starts that are rotated about an axis lie apart.
//!
//! How far a surface of revolution is rotated about its axis cannot be seen, and that of one that is nearly so hardly can. A smooth
//! deformation takes up a wrong rotation, and each start ends at an answer of its own: of four synthetic beans with warps of 8 %,
//! starts rotated by 20° about the long axis ended 8° to 23° from the pose they were rotated from, the others 3° to 8°, with misfits
//! that differed by 0.02 at most. The posterior of one field knows its own surroundings alone. So where the misfit hardly rises with
//! a rotation, the field is fitted from several, and their spread, each weighted by how probable it is, is part of the uncertainty.
//! Hippocampi with the same warps come to one answer from all of them, within 1.5°.

use super::coarse::{coarse_alone, screening};
use super::displacement::Displacement;
use super::fine::fine_aside;
use super::fine_misfit::fine_misfit;
use super::options::DisplacementOptions;
use crate::error::MatchError;
use crate::pair::assignment::displaced;
use crate::surface::round_axis::RoundAxis;
use homolog_primitives::observe::checkpoint;
use homolog_registration::RigidTransform;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Rotations about the axis from which the field is fitted, degrees; of ten beans the answer was wrong by more in none.
const ANGLES_DEG: [f64; 5] = [0.0, -20.0, 20.0, -40.0, 40.0];
/// Those of them by which it is known whether the misfit rises.
const PROBED: usize = 3;
/// Mean rise of the misfit at the probed angles below which the rotation is poorly determined: of four beans it was 0.02 at most, of
/// three hippocampi with warps of 8 % and two pairs of subjects 0.026 at least. Where it lies between, time is lost, as the fits decide.
const FLAT: f64 = 0.024;

/// Mean squared distance, at each of the `points` of the source, of fits from `pose` rotated about the axis about which the
/// source is most nearly round from the mean of these fits, mm². `None` where the misfit shows that the rotation is determined,
/// or where a number is not finite.
///
/// Cost that of six steps on few points where it is determined, otherwise five times that of the first three stages.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn spread_of_rotations(
    displacement: &Displacement<'_>,
    points: &[Point3<f64>],
    pose: &RigidTransform,
) -> Result<Option<Vec<f64>>, MatchError> {
    let Some(axis) = RoundAxis::of(displacement.source.mesh.vertices(), &displacement.source.areas) else {
        return Ok(None);
    };
    let starts = ANGLES_DEG.map(|angle| axis.rotated(pose, angle.to_radians()));
    if !is_flat(displacement, &starts[..PROBED]) {
        return Ok(None);
    }
    let values = displacement.functions.values(points);
    let fits: Vec<Option<(f64, Vec<Point3<f64>>)>> = starts
        .par_iter()
        .map(|start| {
            checkpoint(displacement.observer)?;
            let Some(state) = coarse_alone(displacement, start) else { return Ok(None) };
            let Some(fine) = fine_aside(displacement, state)? else { return Ok(None) };
            let misfit = fine_misfit(displacement, fine.moved(), start.is_reflection());
            let base = fine.track.base.moved(points, &values);
            Ok(Some((misfit, displaced(&base, &fine.field, &values))))
        })
        .collect::<Result<_, MatchError>>()?;
    let Some(fits) = fits.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    Ok(spread(&fits, displacement.options))
}

/// Whether the misfit of the first of the `starts` is hardly lower than the mean of those of the others.
fn is_flat(displacement: &Displacement<'_>, starts: &[RigidTransform]) -> bool {
    let Some(found) = starts.par_iter().map(screening(displacement)).collect::<Option<Vec<f64>>>() else {
        return false;
    };
    let others = &found[1..];
    others.iter().sum::<f64>() / (others.len() as f64) < found[0] + FLAT
}

/// Mean squared distance of `fits` from their mean at each point, mm², each fit, its misfit and where it moves the points, weighted by its
/// probability. A misfit is the mean of `−ln` of a likelihood, and a surface counts as so many independent observations as in the
/// coarse stage.
fn spread(fits: &[(f64, Vec<Point3<f64>>)], options: &DisplacementOptions) -> Option<Vec<f64>> {
    let least = fits.iter().map(|fit| fit.0).fold(f64::INFINITY, f64::min);
    let weights: Vec<f64> = fits.iter().map(|fit| (-options.density[0] * (fit.0 - least)).exp()).collect();
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
