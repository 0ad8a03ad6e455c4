//! Spread of the ends of several fits: from a start that is rotated about the axis about which a surface is most nearly
//! round, and with and without relaxation.
//!
//! The rotation of a surface of revolution about its axis cannot be determined; the rotation of a nearly round surface
//! hardly can. A smooth deformation compensates for a wrong rotation, so that each start ends at a different answer
//! with nearly the same misfit (docs/findings.md). The posterior of one field is that of a linear model and covers only
//! the surroundings of its own answer.
//!
//! So the field is fitted from a rotated start as well, and both fits are relaxed under the same process. Where the
//! surfaces determine the rotation, both end at the same place. A start rotated the other way is taken to end as far
//! away on the other side. The three ends, at `d`, 0 and `−d` from the answer, are draws of where fits of this pair end:
//! their sample variance is `d²`, and the truth, as one more draw, is off by `2 d²` on average. Misfits do not tell
//! which of them is the truth, so they have no part in it.
//!
//! Between two subjects the answer is not relaxed, and the relaxed fit is an estimate of equal standing: where two such
//! estimates are apart, each is off by their sample variance, half of their squared distance, beyond the posterior, which
//! covers what they have in common.

use super::base::State;
use super::coarse::coarse_alone;
use super::displacement::FitContext;
use super::fine::fine_aside;
use super::fitted::pose_of;
use super::relaxation::{Relaxation, RelaxationModel};
use super::uncertainty::spread;
use crate::error::MatchError;
use crate::surface::round_axis::RoundAxis;
use homolog_primitives::observe::checkpoint;
use homolog_registration::RigidTransform;
use nalgebra::Point3;

/// Rotation about the axis from which the field is fitted as well, degrees.
const ANGLE_DEG: f64 = 20.0;
/// Largest number of points at which both fits are relaxed and compared, and number of inducing points of their field.
const MOST_POINTS: usize = 400;
const N_INDUCING: usize = 60;

/// Mean squared distance of the truth from the answer by what the rotation of the start, and relaxation, leave open, at
/// each of the `points` of the source, mm². `own`: the fit from the start after the fine stage; `pose`: the rigid part of
/// the answer; `unrelaxed`: where an answer that is not relaxed moves the vertices of the smooth source. `None` if a number
/// is not finite.
///
/// Cost: the first three stages, and two relaxations at few points.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(super) fn spread_of_fits(
    displacement: &FitContext<'_>,
    model: &RelaxationModel,
    points: &[Point3<f64>],
    (own, pose): (&State, &RigidTransform),
    unrelaxed: Option<&[Point3<f64>]>,
) -> Result<Option<Vec<f64>>, MatchError> {
    let vertices = displacement.source.mesh.vertices();
    let Some(axis) = RoundAxis::of(vertices, &displacement.source.areas) else { return Ok(None) };
    let Some(relaxation) = Relaxation::new(displacement, model, (MOST_POINTS, N_INDUCING)) else { return Ok(None) };
    let relaxed = |moved: &[Point3<f64>]| relaxation.relaxed(&pose_of(displacement, moved, pose), moved);
    let of_own = || relaxed(&displacement.source_moved_by(own));
    let of_rotated = || {
        checkpoint(displacement.observer)?;
        let start = axis.rotated(pose, ANGLE_DEG.to_radians());
        let Some(state) = coarse_alone(displacement, &start) else { return Ok(None) };
        let Some(fine) = fine_aside(displacement, state, None)? else { return Ok(None) };
        relaxed(&fine.moved())
    };
    let (own, rotated) = rayon::join(of_own, of_rotated);
    let (Some(own), Some(rotated)) = (own?, rotated?) else { return Ok(None) };
    let mut squares: Vec<f64> =
        own.places.iter().zip(&rotated.places).map(|(p, q)| 2.0 * (q - p).norm_squared()).collect();
    if let Some(answer) = unrelaxed {
        for ((square, place), &vertex) in squares.iter_mut().zip(&own.places).zip(relaxation.vertices()) {
            *square += 0.5 * (place - answer[vertex]).norm_squared();
        }
    }
    Ok(Some(spread(relaxation.points(), &squares, displacement.source.areas.iter().sum(), points)))
}
