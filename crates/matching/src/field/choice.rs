//! Choice of the rigid pose: candidate poses are compared after the coarse stage of their displacements.

use super::agreement::likeness;
use super::base::State;
use super::coarse::{CoarseStage, screening};
use super::displacement::FitContext;
use super::fine::fine;
use super::fitted::FineStageFit;
use super::options::IsOutdone;
use super::rivals::{Candidate, Comparison, compare_candidates, unexplained_coarsely};
use super::symmetries::missing_poses;
use crate::error::MatchError;
use crate::poses::compared::{ComparedPose, ComparisonOutcome, Origin};
use crate::starts::start_pose::StartPose;
use homolog_primitives::observe::checkpoint;
use homolog_registration::{RigidTransform, SAME_POSE_ANGLE, SamePose};
use rayon::prelude::*;
use std::cell::OnceCell;

/// A pose after the coarse stage.
struct ScreenedPose {
    index: usize,
    pose: StartPose,
    misfit: f64,
    /// Whether it may be the answer.
    may_answer: bool,
    /// The rigid part of the displaced surface, if poses are also told apart by place.
    end: Option<RigidTransform>,
    /// Whether a pose of lower misfit ended at the same pose.
    is_reached: bool,
}

impl ScreenedPose {
    fn is_rotation_of(&self, other: &ScreenedPose) -> bool {
        self.pose.rotation_of == Some(other.index)
    }

    fn mirrored(&self) -> bool {
        self.pose.pose.is_reflection()
    }

    fn compared(&self) -> ComparedPose {
        ComparedPose {
            origin: Origin::Pose(self.index),
            mirrored: self.mirrored(),
            misfit: self.misfit,
            finer: if self.is_reached { ComparisonOutcome::Same } else { ComparisonOutcome::Undecided },
        }
    }
}

/// When a match ends without an answer after its coarse stage.
#[derive(Clone, Copy)]
pub(crate) enum EndsEarly<'a> {
    Never,
    /// If no start has a misfit below that of another answer.
    WithoutMisfitBelow(f64),
    IfOutdone(&'a IsOutdone<'a>),
}

/// The best of `poses` that may be kept. `None` if there is none, if the match `ends_early`, or if a number is not
/// finite.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn choose_pose(
    displacement: &FitContext<'_>,
    poses: &[StartPose],
    ends_early: EndsEarly<'_>,
    may_answer: impl Fn(&RigidTransform) -> bool,
) -> Result<Option<Chosen>, MatchError> {
    let coarse = CoarseStage::new(displacement);
    let Some(followed) = screened(&coarse, poses)? else { return Ok(None) };
    let found = coarse.fit_all(&followed.iter().map(|start| start.pose).collect::<Vec<_>>())?;
    let mut compared: Vec<(ScreenedPose, State)> = Vec::new();
    for (&FollowedStart { index, .. }, found) in followed.iter().zip(found) {
        let Some((misfit, state)) = found else { return Ok(None) };
        let pose = poses[index];
        let misfit = misfit + pose.excess;
        let end = displacement.same_place.map(|_| coarse.rigid_part(&state));
        let may_answer = may_answer(&pose.pose);
        compared.push((ScreenedPose { index, pose, misfit, may_answer, end, is_reached: false }, state));
    }
    compared.sort_by(|(a, _), (b, _)| {
        (!a.may_answer).cmp(&!b.may_answer).then(a.misfit.total_cmp(&b.misfit)).then(a.index.cmp(&b.index))
    });
    // A start and its rotations count as one pose; the best is kept.
    let (mut kept, mut states): (Vec<ScreenedPose>, Vec<State>) = (Vec::new(), Vec::new());
    for (start, state) in compared {
        if !kept.iter().any(|better| better.is_rotation_of(&start) || start.is_rotation_of(better)) {
            kept.push(start);
            states.push(state);
        }
    }
    for k in 1..kept.len() {
        let (better, others) = kept.split_at_mut(k);
        let other = &mut others[0];
        let is_reached = |better: &ScreenedPose| match (&better.end, &other.end) {
            (Some(a), Some(b)) => better.mirrored() == other.mirrored() && displacement.are_same(a, b, SAME_POSE_ANGLE),
            _ => false,
        };
        other.is_reached = better.iter().any(is_reached);
    }
    if !kept.first().is_some_and(|best| best.may_answer) {
        return Ok(None);
    }
    let ends = match ends_early {
        EndsEarly::Never => false,
        EndsEarly::WithoutMisfitBelow(to_beat) => kept.iter().all(|start| start.misfit >= to_beat),
        EndsEarly::IfOutdone(is_outdone) => {
            is_outdone(likeness(displacement, &displacement.source_moved_by(&states[0])))?
        }
    };
    if ends {
        return Ok(None);
    }
    let candidates = kept
        .iter()
        .zip(states)
        .map(|(start, state)| Candidate { compared: start.compared(), state, fit: None })
        .collect();
    let mut comparison = compare_candidates(&coarse, candidates)?;
    if let Some(symmetric) = best_symmetric(&coarse, &comparison, poses)? {
        // Starts that are no worse than the winner are compared anew, after the symmetric pose.
        let Comparison { mut candidates, .. } = comparison;
        for other in &mut candidates {
            if matches!(other.compared.finer, ComparisonOutcome::AsGood | ComparisonOutcome::Better) {
                other.compared.finer = ComparisonOutcome::Undecided;
            }
        }
        candidates.insert(1, symmetric);
        comparison = compare_candidates(&coarse, candidates)?;
    }
    let compared = comparison.candidates.iter().map(|candidate| candidate.compared).collect();
    let winner = comparison.candidates.into_iter().next();
    Ok(winner.map(|Candidate { state, fit, .. }| {
        let pose = state.base.pose;
        let end = match fit {
            Some(fit) => ChosenEnd::Fine(fit.fine),
            None => ChosenEnd::Coarse(state),
        };
        Chosen { pose, end, compared }
    }))
}

/// The best pose that an approximate symmetry of the surface leads to and that is no start; `None` if it has a higher
/// misfit than the winner after the coarse stage, or if there is none.
fn best_symmetric(
    coarse: &CoarseStage<'_>,
    comparison: &Comparison,
    poses: &[StartPose],
) -> Result<Option<Candidate>, MatchError> {
    let Some(winner) = comparison.candidates.first() else { return Ok(None) };
    let Origin::Pose(of_winner) = winner.compared.origin else { return Ok(None) };
    let displacement = coarse.displacement;
    let are_same = |a: &RigidTransform, b: &RigidTransform| displacement.are_same(a, b, SAME_POSE_ANGLE);
    let missing = missing_poses(&comparison.as_good, are_same);
    let found = coarse.fit_all(&missing)?;
    let found = found.into_iter().filter_map(|found| {
        let (misfit, state) = found?;
        let pose = state.base.pose;
        let (origin, mirrored) = (Origin::Symmetric(of_winner, pose), pose.is_reflection());
        let misfit = misfit + poses[of_winner].excess;
        let compared = ComparedPose { origin, mirrored, misfit, finer: ComparisonOutcome::Undecided };
        (misfit < winner.compared.misfit).then_some(Candidate { compared, state, fit: None })
    });
    Ok(found.min_by(|a, b| a.compared.misfit.total_cmp(&b.compared.misfit)))
}

/// The pose from which the displacement continues.
pub(crate) struct Chosen {
    pub pose: RigidTransform,
    /// The field over it.
    pub end: ChosenEnd,
    /// The starts that were compared, the chosen one first.
    pub compared: Vec<ComparedPose>,
}

/// The field over the chosen pose: after the stage at which it was chosen.
pub(crate) enum ChosenEnd {
    Coarse(State),
    Fine(FineStageFit),
}

impl ChosenEnd {
    /// The field after the fine stage, reported to the energy trace. `None` if a number is not finite.
    ///
    /// # Errors
    /// [`MatchError::Cancelled`].
    pub(crate) fn fine(self, displacement: &FitContext<'_>) -> Result<Option<FineStageFit>, MatchError> {
        match self {
            ChosenEnd::Coarse(state) => fine(displacement, state),
            ChosenEnd::Fine(mut fine) => {
                if let Some(fit) = &mut fine.fit {
                    displacement.observer.keep(fit);
                }
                Ok(Some(fine))
            }
        }
    }
}

/// A start that is followed after the screening.
struct FollowedStart {
    /// Its index among the starts.
    index: usize,
    /// The rigid part of the screened field.
    pose: RigidTransform,
}

/// The poses to follow, by misfit after a few steps on few vertices: the best of each handedness, others that
/// explain about as much, and for a rotation also the pose that was rotated.
fn screened(coarse: &CoarseStage<'_>, poses: &[StartPose]) -> Result<Option<Vec<FollowedStart>>, MatchError> {
    let displacement = coarse.displacement;
    let settings = &displacement.options.choice;
    let screening = screening(displacement);
    let screened: Vec<Option<(f64, State)>> = poses
        .par_iter()
        .map(|pose| {
            checkpoint(displacement.observer)?;
            Ok(screening(&pose.pose).map(|(misfit, state)| (misfit + pose.excess, state)))
        })
        .collect::<Result<_, MatchError>>()?;
    let Some(screened) = screened.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    let mut order: Vec<usize> = (0..poses.len()).collect();
    order.sort_by(|&a, &b| screened[a].0.total_cmp(&screened[b].0).then(a.cmp(&b)));
    let unexplained = |k: usize| unexplained_coarsely(coarse, &screened[k].1);
    // What the best pose of either handedness leaves unexplained, if another is compared with it.
    let of_best = [OnceCell::new(), OnceCell::new()];
    let mut followed: Vec<usize> = Vec::new();
    for k in order {
        let is_reflection = poses[k].pose.is_reflection();
        let same_handedness: Vec<usize> =
            followed.iter().copied().filter(|&other| poses[other].pose.is_reflection() == is_reflection).collect();
        // Rotations of one pose take one place of the list together; the best of them is chosen later.
        let rotated = |index: usize| poses[index].rotation_of.unwrap_or(index);
        let near = |&other: &usize| {
            rotated(other) == rotated(k)
                || displacement.are_same(&poses[other].pose, &poses[k].pose, settings.same_pose_rad)
        };
        if same_handedness.len() >= settings.most_followed || same_handedness.iter().any(near) {
            continue;
        }
        // Poses of one orientation at different places do not take the place of another orientation.
        let has_orientation_of = |other: usize| {
            move |&a: &usize| {
                SamePose::of_orientation().holds(&poses[a].pose, &poses[other].pose, settings.same_pose_rad)
            }
        };
        let has_room = same_handedness.len() < settings.followed
            || same_handedness.len() == settings.followed
                && same_handedness.iter().all(has_orientation_of(same_handedness[0]))
                && !same_handedness.iter().any(has_orientation_of(k));
        let explains_as_much = || {
            let best = of_best[usize::from(is_reflection)].get_or_init(|| unexplained(same_handedness[0]));
            !unexplained(k).is_worse_than(best)
        };
        if has_room || explains_as_much() {
            followed.push(k);
        }
    }
    // Few vertices do not show whether a rotation about the axis lowers the misfit, so the pose that was rotated is
    // followed as well.
    for k in followed.clone() {
        let own = poses[k].rotation_of;
        followed.extend(own.filter(|own| !followed.contains(own)));
    }
    let start = |index: usize| FollowedStart { index, pose: coarse.rigid_part(&screened[index].1) };
    Ok(Some(followed.into_iter().map(start).collect()))
}
