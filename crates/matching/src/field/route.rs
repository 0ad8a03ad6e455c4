//! From rigid poses to the source deformed by a smooth displacement field. Only this file calls all stages.
//!
//! The source is moved by `T(p) = R p + t + u(p)` with a field `u` of [`homolog_registration::deformation`]: a
//! translation, a linear part and a Gaussian process of width 0.3 diagonals. Expectation and maximization alternate as
//! in coherent point drift: target vertices are softly assigned to moved source vertices by distance, normals and
//! curvature features, whose variances are estimated in every step; then the field is fitted to the means of the
//! assigned points.
//!
//! 1. **Coarse**, on thinned surfaces, `σ` from 5 % to 4 % of the diagonal, from the two to four best poses of each
//!    handedness after a few steps from every pose. The pose of the lowest misfit is kept, so poses with head and tail
//!    exchanged, and poses that mirror, are compared after their deformation.
//! 2. **Middle**, on all vertices, to 2.5 % of the diagonal.
//! 3. **Fine**: along the normal a vertex is pulled towards the closest point of the target, with the small variance of
//!    points on surfaces; across the normal a tenth of the assignment's weight is kept. So the surface can slide,
//!    driven by the smoothness of the field and the pulls along the normals. The full weight of the assignment, which
//!    favors the present place of a vertex, would prevent this.
//! 4. **Local**: if the residual heights show narrower displacement, a second kernel of the most probable width and
//!    variance is added ([`super::local`]).
//! 5. **Reverse**: closed surfaces of two subjects are fitted in the other direction as well, and the mean of the two
//!    maps is the answer ([`super::both_ways`]).
//!
//! If the surfaces then do not agree, or a mirror image fits better, tubular surfaces are matched straightened
//! ([`super::straightened`]), and the stages are run from correspondences of near isometries ([`super::isometry`]).
//! Surfaces that these do not bend are fitted once more from the rigid part of the result.
//!
//! Sources: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010; Hirose, "A
//! Bayesian formulation of coherent point drift", IEEE PAMI 43(7), 2021 (prior, weights); Chen, Medioni 1992 (distance
//! from the tangent plane).

use super::agreement::agreement;
use super::choice::{Chosen, EndsEarly, choose_pose};
use super::coarse::coarse_alone;
use super::deformed::Deformed;
use super::displacement::FitContext;
use super::fine::fine;
use super::finish::{finish_backward_fit, finish_fit, moved_rigidly};
use super::fitted::{FinalField, FineStageFit, pose_of};
use super::functions::Functions;
use super::guides::LandmarkObservations;
use super::isometry::{
    BestBent, OverForm, RefinedIsometry, bent_starts, best_of_lowest, iterate_while_improving, low_energies,
};
use super::options::{DisplacementOptions, IsOutdone};
use super::refine::refined_from;
use super::reverse::{BothWays, ReverseFit, refined_both_ways, reverse_fit, with_backward_fit};
use super::rivals::{PREFERRED, unexplained};
use super::straightened::unstraighten;
use super::trace::FitTrace;
use crate::error::MatchError;
use crate::pair::role::Role;
use crate::pair::smooth_pair::SmoothPair;
use crate::pair::surfaces::{Surfaces, diagonal_mm, differ_in_spread, swapped};
use crate::poses::compared::{ComparedPose, ComparisonOutcome};
use crate::poses::rigid_part::RigidPart;
use crate::starts::limbs::may_branch;
use crate::starts::start_pose::StartPose;
use crate::starts::tubes::Tubes;
use homolog_contract::parameters::{Bending, Landmark};
use homolog_geometry::curvature::vertex_areas;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_registration::{RigidTransform, SamePose};
use nalgebra::Point3;

/// The source deformed onto the target.
pub(crate) struct Fitted {
    pub deformed: Deformed,
    /// The starts that were compared, the one kept first.
    pub compared: Vec<ComparedPose>,
}

/// Parameters that are the same in both directions, and for straightened surfaces.
#[derive(Clone, Copy)]
struct Request<'a> {
    allow_reflection: bool,
    options: &'a DisplacementOptions,
    observer: &'a FitTrace<'a>,
    ends_early: EndsEarly<'a>,
}

/// The source deformed onto the target, from the best of the rigid `poses`. Poses that mirror are compared too, but
/// kept only with `allow_reflection`.
///
/// Closed surfaces of two subjects are fitted from the one that is more spread out, and the map in the other direction
/// is the inverse, so both directions give the same correspondences.
///
/// `None` if no pose may be kept, if the match `is_outdone`, or if a number is not finite. The result is the same to
/// the bit on any number of threads.
///
/// # Errors
/// [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
///
/// # Cost
/// `O(steps · n · (pairs + M²))` for `M` functions of the field, about 30 for the defaults and 140 with a second
/// kernel; twice that for two subjects.
pub(crate) fn displace(
    surfaces: &Surfaces<'_>,
    prepared: SmoothPair,
    poses: &[StartPose],
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &dyn Observer,
    is_outdone: Option<&IsOutdone<'_>>,
) -> Result<Option<Fitted>, MatchError> {
    let observer = FitTrace::new(observer);
    let ends_early = is_outdone.map_or(EndsEarly::Never, EndsEarly::IfOutdone);
    let request = Request { allow_reflection, options, observer: &observer, ends_early };
    match surfaces.part {
        Some(Role::Target) => from_part(surfaces, prepared, poses, request),
        Some(Role::Source) | None => from_source(surfaces, prepared, poses, request),
    }
}

/// [`from_source`] for a target that is a part of the source. The part is deformed onto the whole and the map inverted:
/// a field from the whole would have to press the rest of it into the part.
fn from_part(
    surfaces: &Surfaces<'_>,
    (source, target): SmoothPair,
    poses: &[StartPose],
    request: Request<'_>,
) -> Result<Option<Fitted>, MatchError> {
    let landmarks: Vec<Landmark> = surfaces.landmarks.iter().map(swapped).collect();
    let side_of = |role: Role| (surfaces.side_of)(role.other());
    let poses: Vec<StartPose> = poses.iter().map(|start| StartPose { pose: start.pose.inverse(), ..*start }).collect();
    let swapped = surfaces.swapped(&landmarks, &side_of);
    let Some(found) = from_source(&swapped, (target, source), &poses, request)? else { return Ok(None) };
    let inverse = |start: ComparedPose| ComparedPose { origin: start.origin.inverse(), ..start };
    let compared = found.compared.into_iter().map(inverse).collect();
    let deformed = found.deformed.inverse(surfaces.full_target, surfaces.full_source);
    Ok(deformed.map(|deformed| Fitted { deformed, compared }))
}

/// The source deformed onto the target by the first of these that is acceptable: the fit in the other direction, the
/// rigid motion of a copy, the answer for straightened tubes, the answer from a near isometry, the fit in this
/// direction. `None` also if the match ends early.
fn from_source(
    surfaces: &Surfaces<'_>,
    prepared: SmoothPair,
    poses: &[StartPose],
    request: Request<'_>,
) -> Result<Option<Fitted>, MatchError> {
    let Some(forward) = shared(surfaces, prepared, request)? else { return Ok(None) };
    let may_answer = |pose: &RigidTransform| request.allow_reflection || !pose.is_reflection();
    let Some(Chosen { pose, end, mut compared }) = choose_pose(&forward, poses, request.ends_early, may_answer)? else {
        return Ok(None);
    };
    let Some(fine) = end.fine(&forward)? else { return Ok(None) };
    let wide = fine.moved();
    let mut reverse = reverse_of_subjects(surfaces, &forward, (&fine, &pose))?;
    let evidence = CoarseFindings::of(&compared, surfaces);
    // Doubts are checked before the field is narrow: a narrow field makes surfaces agree even from a wrong start.
    if evidence.may_stand()
        && let Some(reverse) = reverse.take_if(|reverse| !reverse.is_doubtful())
    {
        let deformed = finish_backward_fit(reverse, surfaces)?;
        return Ok(deformed.map(|deformed| Fitted { deformed, compared }));
    }
    if let Some(deformed) = as_copies(surfaces, &forward, (&pose, poses), (&fine, &wide), &mut compared)? {
        return Ok(Some(Fitted { deformed, compared }));
    }
    compared.retain(|start| start.finer != ComparisonOutcome::Same);
    let doubtful = evidence.mirror_image_fits_better || agreement(&forward, &wide).is_doubtful(&request.options.route);
    if may_be_straightened(surfaces, &evidence, doubtful, fine.residual_mm) {
        let to_beat = least_misfit(&compared) - request.options.route.straight;
        let ends_early = EndsEarly::WithoutMisfitBelow(to_beat);
        if let Some(found) = by_tubes(surfaces, Request { ends_early, ..request })?
            && least_misfit(&found.compared) < to_beat
        {
            return Ok(Some(found));
        }
    }
    let (end, route) = if !evidence.is_mirrored && (doubtful || evidence.branching) {
        by_isometry(surfaces, &forward, (fine, wide), doubtful, evidence.branching)?
    } else {
        (RigidEnd::FineStageFit(Box::new(fine)), None)
    };
    let refined = match (route, reverse) {
        (Some(route), _) => {
            // The misfits of rigid poses do not show the handedness of a bent surface.
            compared.retain(|rigid| !(rigid.mirrored && route.is_of_same_handedness));
            // The near isometry has a lower misfit at the scale of the sampling than all rigid poses except mirror
            // images that fit better.
            let outdone = |rigid: &&mut ComparedPose| rigid.finer != ComparisonOutcome::Better;
            compared.iter_mut().filter(outdone).for_each(|rigid| rigid.finer = ComparisonOutcome::Outdone);
            compared = route.compared.into_iter().chain(compared).collect();
            route.refined
        }
        (None, Some(reverse)) => {
            let deformed = finish_backward_fit(reverse, surfaces)?;
            return Ok(deformed.map(|deformed| Fitted { deformed, compared }));
        }
        (None, None) => end.run_remaining_stages(&forward, surfaces)?,
    };
    let deformed = finish_fit(&forward, surfaces, refined, &pose)?;
    Ok(deformed.map(|deformed| Fitted { deformed, compared }))
}

/// Values that all stages from the source onto the target share. `None` if a number is not finite.
fn shared<'a>(
    surfaces: &Surfaces<'_>,
    (smooth_source, smooth_target): SmoothPair,
    request: Request<'a>,
) -> Result<Option<FitContext<'a>>, MatchError> {
    let Surfaces { source, landmarks, part, lengths, .. } = *surfaces;
    checkpoint(request.observer)?;
    let Some(functions) = Functions::over(source, &smooth_source, request.options) else { return Ok(None) };
    let guides = LandmarkObservations::new(landmarks, &functions, lengths.root_mm);
    Ok(Some(FitContext {
        source: smooth_source,
        target: smooth_target,
        functions,
        guides,
        diagonal_mm: diagonal_mm(source),
        lengths,
        same_place: part.is_some().then(|| SamePose::of_place(source.vertices(), &vertex_areas(source))),
        options: request.options,
        observer: request.observer,
    }))
}

/// The fit in the other direction from the inverse of `pose`, for closed surfaces of two subjects whose target is more
/// spread out. `fine`: the fit in this direction.
fn reverse_of_subjects<'a>(
    surfaces: &Surfaces<'_>,
    forward: &'a FitContext<'_>,
    (fine, pose): (&FineStageFit, &RigidTransform),
) -> Result<Option<ReverseFit<'a>>, MatchError> {
    if surfaces.open || !surfaces.is_fitted_backwards() || !forward.lengths.are_of_two_subjects(fine.residual_mm) {
        return Ok(None);
    }
    let is_of_two_subjects = |reverse: &ReverseFit<'_>| forward.lengths.are_of_two_subjects(reverse.fine.residual_mm);
    Ok(reverse_fit(forward, surfaces, pose)?.filter(is_of_two_subjects))
}

/// Findings of the coarse stage.
struct CoarseFindings {
    /// Whether the chosen pose mirrors; straightened surfaces and near isometries are then not tried.
    is_mirrored: bool,
    mirror_image_fits_better: bool,
    /// Whether both surfaces have limbs, and the chosen pose does not mirror.
    branching: bool,
}

impl CoarseFindings {
    fn of(compared: &[ComparedPose], surfaces: &Surfaces<'_>) -> CoarseFindings {
        let best = &compared[0];
        CoarseFindings {
            is_mirrored: best.mirrored,
            mirror_image_fits_better: compared.iter().any(|c| c.mirrored && c.misfit < best.misfit),
            branching: !best.mirrored && may_branch(surfaces),
        }
    }

    /// Whether an answer from the chosen pose is acceptable without other starts.
    fn may_stand(&self) -> bool {
        !self.mirror_image_fits_better && !self.branching
    }
}

/// The source moved rigidly if open surfaces are copies. Copies need no other start, and a field would distort them at
/// their rim.
fn as_copies(
    surfaces: &Surfaces<'_>,
    forward: &FitContext<'_>,
    (pose, poses): (&RigidTransform, &[StartPose]),
    (fine, wide): (&FineStageFit, &[Point3<f64>]),
    compared: &mut [ComparedPose],
) -> Result<Option<Deformed>, MatchError> {
    if !surfaces.open {
        return Ok(None);
    }
    let alignment = forward.alignment(surfaces.target.mean_edge_length());
    let found = alignment.rigid_part(surfaces.source, wide, pose.is_reflection(), surfaces.open)?;
    let Some(RigidPart { transform, copies: true }) = found else { return Ok(None) };
    // Another pose is as good if it is also one of copies.
    for other in &mut compared[1..] {
        let is_other = alignment.copies_elsewhere(&other.origin.rigid(poses), &transform)?;
        other.finer = if is_other { ComparisonOutcome::AsGood } else { ComparisonOutcome::Outdone };
    }
    Ok(Some(moved_rigidly(forward, surfaces, transform, fine.residual_mm)))
}

/// Whether tubular surfaces are straightened: if they may agree better from another start, or if surfaces of one shape,
/// which may agree and still be bent against each other, differ in spread.
fn may_be_straightened(surfaces: &Surfaces<'_>, evidence: &CoarseFindings, doubtful: bool, residual_mm: f64) -> bool {
    let of_one_shape = !surfaces.lengths.are_of_two_subjects(residual_mm);
    // Surfaces with limbs are not tubes.
    let may_bend = !evidence.is_mirrored && !evidence.branching && surfaces.bending != Bending::None;
    may_bend && (doubtful || of_one_shape && differ_in_spread(surfaces))
}

/// The source deformed onto the target by a match of both surfaces straightened; `None` if one is not tubular. Pose
/// search, field, comparison with mirror images and reverse fit are the same as for the surfaces themselves. Cost: a
/// match of both surfaces.
fn by_tubes(surfaces: &Surfaces<'_>, request: Request<'_>) -> Result<Option<Fitted>, MatchError> {
    let tubes = Tubes::of(surfaces);
    checkpoint(request.observer)?;
    let Some(tubes) = tubes else { return Ok(None) };
    // If the target is a part, the roles have been swapped.
    let poses = tubes.poses(surfaces.part.is_some());
    checkpoint(request.observer)?;
    let straight = tubes.straight(surfaces);
    let Some(found) = from_source(&straight, straight.smoothed()?, &poses, request)? else { return Ok(None) };
    let found = unstraighten(surfaces, &tubes, found.deformed, found.compared, &poses);
    Ok(found.map(|(deformed, compared)| Fitted { deformed, compared }))
}

/// The fit from the chosen pose, after some or all stages.
enum RigidEnd {
    FineStageFit(Box<FineStageFit>),
    /// After all stages.
    FinalField(Box<FinalField>),
}

impl RigidEnd {
    fn run_remaining_stages(self, forward: &FitContext<'_>, surfaces: &Surfaces<'_>) -> Result<BothWays, MatchError> {
        match self {
            RigidEnd::FineStageFit(fine) => refined_both_ways(forward, surfaces, *fine),
            RigidEnd::FinalField(refined) => with_backward_fit(forward, surfaces, *refined),
        }
    }
}

/// An answer from a near isometry.
struct IsometryRoute {
    refined: BothWays,
    /// The correspondences that were compared, the one kept first.
    compared: Vec<ComparedPose>,
    /// Whether the energy is no higher than that of the mirrored source, which also holds for a body whose left and
    /// right are alike.
    is_of_same_handedness: bool,
}

/// The best answer from near isometries, if it explains the surfaces clearly better than the fit from the chosen pose.
fn by_isometry(
    surfaces: &Surfaces<'_>,
    forward: &FitContext<'_>,
    (fine, wide): (FineStageFit, Vec<Point3<f64>>),
    doubtful: bool,
    branching: bool,
) -> Result<(RigidEnd, Option<IsometryRoute>), MatchError> {
    let (Some(source), Some(target)) = ((surfaces.side_of)(Role::Source), (surfaces.side_of)(Role::Target)) else {
        return Ok((RigidEnd::FineStageFit(Box::new(fine)), None));
    };
    // The misfit of surfaces that agree is at its lowest only after the local stage.
    let end = if doubtful {
        RigidEnd::FineStageFit(Box::new(fine))
    } else {
        RigidEnd::FinalField(Box::new(refined_from(forward, fine)?))
    };
    let reached = match &end {
        RigidEnd::FinalField(found) => found.moved(&forward.source.mesh),
        RigidEnd::FineStageFit(_) => wide,
    };
    let low = low_energies(forward, source, target, &reached)?;
    // The present answer has the lowest energy. Surfaces with limbs go on: a fit that is smooth along the surface is
    // more accurate for them.
    if low.is_answer_lowest && !branching {
        return Ok((end, None));
    }
    let of_rigid_end = unexplained(forward, &reached, false);
    let Some(over_form) = source.form().and_then(|form| OverForm::new(forward, form)) else { return Ok((end, None)) };
    let starts = bent_starts(&over_form, &low)?;
    let Some(best) = best_of_lowest(&over_form, starts, &low)? else { return Ok((end, None)) };
    let BestBent { end: bent, compared } = best;
    let explains_more = match (&of_rigid_end, &bent.unexplained) {
        (Some(rigid), Some(bent)) => rigid.excess_over(bent) > PREFERRED,
        _ => false,
    };
    if !explains_more {
        return Ok((end, None));
    }
    // A near isometry also finds the pose of surfaces that are not bent. From there the answer has a posterior.
    let from_rigid_part = if branching { None } else { from_rigid_part(surfaces, forward, &bent)? };
    let refined = match from_rigid_part {
        Some(refined) => refined,
        None => BothWays { refined: iterate_while_improving(&over_form, bent.refined, bent.misfit)?, returned: None },
    };
    Ok((end, Some(IsometryRoute { refined, compared, is_of_same_handedness: low.are_of_same_handedness() })))
}

/// The fit from the rigid part of a bent answer; `None` if the surfaces do not agree after it.
fn from_rigid_part(
    surfaces: &Surfaces<'_>,
    forward: &FitContext<'_>,
    bent: &RefinedIsometry,
) -> Result<Option<BothWays>, MatchError> {
    let pose = pose_of(forward, &bent.moved, &bent.refined.base.pose);
    let Some(state) = coarse_alone(forward, &pose) else { return Ok(None) };
    let Some(fine) = fine(forward, state)? else { return Ok(None) };
    if agreement(forward, &fine.moved()).is_doubtful(&forward.options.route) {
        return Ok(None);
    }
    refined_both_ways(forward, surfaces, fine).map(Some)
}

fn least_misfit(compared: &[ComparedPose]) -> f64 {
    compared.iter().map(|start| start.misfit).fold(f64::INFINITY, f64::min)
}
