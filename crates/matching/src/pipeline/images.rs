//! The third stage: an image on the target for every source vertex, through a smooth displacement field or rigidly.

use super::counting::DisplacementProgress;
use super::inferred::{aligned_shortly, inferred, labels_of};
use crate::answer::displaced::{Images, VertexImages};
use crate::answer::displacement::DisplacementAnswer;
use crate::answer::of_field::answered;
use crate::answer::reliability::reliability;
use crate::comparison::field_methods::by_method;
use crate::comparison::registration_only::register;
use crate::error::MatchError;
use crate::field::options::{DisplacementOptions, IsOutdone};
use crate::field::route::displace;
use crate::pair::lengths::Lengths;
use crate::pair::part::part;
use crate::pair::problem::MatchProblem;
use crate::pair::progress::{PROGRESS_AT_END, PROGRESS_BEFORE_DISPLACEMENT, PROGRESS_BEFORE_ROUNDS};
use crate::pair::role::Role;
use crate::pair::surfaces::Surfaces;
use crate::pair::vertex_map::VertexMap;
use crate::poses::posed::{InferredPose, PoseResult};
use crate::starts::candidates::Starts;
use crate::starts::search::sameness;
use homolog_contract::parameters::{Bending, DisplacementMode, FieldStarts};
use homolog_contract::result::PoseOrigin;
use homolog_primitives::observe::Phase;
use homolog_registration::RigidTransform;
use parking_lot::Mutex;
use std::cell::RefCell;

/// What follows from the likeness of the shapes after the coarse stage of a field.
pub(crate) enum AfterCoarseStage {
    GoOn,
    /// Another form of the same surfaces is more alike; its answer, if it has one.
    End(Option<Box<VertexImages>>),
}

/// Decides what follows from the likeness of the shapes after the coarse stage of a field.
pub(crate) type Decision<'a> = dyn Fn(f64) -> Result<AfterCoarseStage, MatchError> + 'a;

/// An image for every source vertex of `prepare_problem`, from the pose of `find_pose`.
///
/// With a displacement field the compared poses are the pose of `find_pose`, the pose of the landmarks, the poses that the
/// labels of an energy support and, if these leave a doubt, the poses of a search of all orientations, including poses
/// that mirror; or the first two alone (`displacement.starts`). The pose that fits best after the deformation is kept. If no field can be fitted, the images are those
/// of the pose of `find_pose`, of registration alone if the pose was left to the field, or else of the first of the other
/// poses. A published method starts from the first of these poses. After the coarse stage of a field the `decision` may
/// give another answer.
///
/// # Errors
/// [`MatchError::NoRegistration`] if `find_pose` has no pose and there is no other one: without a displacement field, or if
/// neither landmarks nor the search give one. [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
pub(crate) fn find_images(
    coarse: &MatchProblem<'_>,
    posed: &PoseResult<'_>,
    decision: Option<&Decision<'_>>,
) -> Result<VertexImages, MatchError> {
    let starts = match coarse.full.parameters.displacement.mode {
        DisplacementMode::None => Starts::of(own_pose(posed)),
        DisplacementMode::Smooth => {
            let mut starts = Starts::known(coarse, own_pose(posed));
            if let Some(found) = by_field(coarse, posed, &mut starts, decision)? {
                return Ok(found);
            }
            if matches!(posed, PoseResult::ByField) {
                let registered = PoseResult::Registration(register(&coarse.full)?);
                return rigid(coarse, &registered, &starts);
            }
            starts
        }
        _ => {
            coarse.full.observer.phase(Phase::Displacement);
            let mut starts = Starts::of(own_pose(posed));
            if starts.poses.is_empty() {
                starts = Starts::known(coarse, None);
                starts.add_searched(coarse);
            }
            if let Some(pose) = starts.first(coarse) {
                let poses = match posed {
                    PoseResult::Registration(registered) => registered.poses.clone(),
                    PoseResult::Inference { .. } | PoseResult::ByField => Vec::new(),
                };
                if let Some(found) = by_method(coarse, &pose, poses)? {
                    coarse.full.observer.progress(PROGRESS_AT_END);
                    return Ok(found);
                }
            }
            starts
        }
    };
    rigid(coarse, posed, &starts)
}

/// [`find_images()`] by a displacement field. `None` if no field can be fitted, or if the `decision` ends without images.
///
/// # Errors
/// As [`find_images()`].
pub(super) fn find_field_images(
    coarse: &MatchProblem<'_>,
    posed: &PoseResult<'_>,
    decision: &Decision<'_>,
) -> Result<Option<VertexImages>, MatchError> {
    let mut starts = Starts::known(coarse, own_pose(posed));
    by_field(coarse, posed, &mut starts, Some(decision))
}

/// The pose of `find_pose`, and its origin.
fn own_pose(posed: &PoseResult<'_>) -> Option<(PoseOrigin, RigidTransform)> {
    let origin = match posed {
        PoseResult::Inference { .. } => PoseOrigin::Inference,
        PoseResult::Registration(_) | PoseResult::ByField => PoseOrigin::Registration,
    };
    posed.transform().map(|pose| (origin, pose))
}

/// Whether the field begins from the pose of `find_pose` alone.
fn keeps_pose(coarse: &MatchProblem<'_>, posed: &PoseResult<'_>) -> bool {
    coarse.full.parameters.displacement.starts == FieldStarts::Initial && posed.transform().is_some()
}

/// The images of a rigid pose.
fn rigid(coarse: &MatchProblem<'_>, posed: &PoseResult<'_>, starts: &Starts) -> Result<VertexImages, MatchError> {
    let scene = &coarse.full;
    let found = posed.transform().or_else(|| starts.first(coarse));
    let transform = found.ok_or(MatchError::NoRegistration { tolerance_mm: scene.tolerance_mm })?;
    let (map, poses) = match posed {
        // If all vertices are variables and labels of the energy, the labels are the answer.
        PoseResult::Inference { inferred, .. }
            if coarse.is_direct() && matches!(inferred.pose, InferredPose::Supported { .. }) =>
        {
            (inferred.map.clone(), Vec::new())
        }
        PoseResult::Inference { .. } | PoseResult::ByField => (VertexMap::nearest(scene, &transform), Vec::new()),
        PoseResult::Registration(registered) => (VertexMap::nearest(scene, &transform), registered.poses.clone()),
    };
    let VertexMap { labeling, confidence, spread_mm } = map;
    Ok(VertexImages {
        transform,
        labeling,
        confidence,
        spread_mm,
        poses,
        images: Images::OnVertices,
        reliability: None,
        resized: false,
        inference: None,
    })
}

/// The images of a smooth displacement field, from the start that fits best after the deformation, or those of the
/// `decision`. `None` if no field can be fitted, or if the decision ends without images.
fn by_field(
    coarse: &MatchProblem<'_>,
    posed: &PoseResult<'_>,
    starts: &mut Starts,
    decision: Option<&Decision<'_>>,
) -> Result<Option<VertexImages>, MatchError> {
    let (scene, source, target) = (&coarse.full, coarse.source, coarse.target);
    let observer = scene.observer;
    let (done_before, last_round) = match posed {
        PoseResult::Inference { inferred, .. } => {
            (PROGRESS_BEFORE_DISPLACEMENT, inferred.rounds.last().map(|r| r.round))
        }
        PoseResult::Registration(_) | PoseResult::ByField => (PROGRESS_BEFORE_ROUNDS, None),
    };
    let counting = DisplacementProgress { observer, done_before, n_steps: Mutex::default(), last_round };
    let surfaces = Surfaces {
        source: source.middle.mesh(),
        target: target.middle.mesh(),
        full_source: source.full.mesh(),
        full_target: target.full.mesh(),
        source_closest: &source.full.closest().index,
        target_closest: &scene.closest.index,
        landmarks: &scene.parameters.landmarks,
        open: source.full.is_open || target.full.is_open,
        part: part(&source.full, &target.full),
        lengths: Lengths::of(&source.middle, &target.middle),
        bending: scene.parameters.displacement.bending,
        side_of: &|role| match (scene.parameters.displacement.bending, role) {
            (Bending::None | Bending::Straightened, _) => None,
            (Bending::NearIsometry, Role::Source) => Some(&source.middle),
            (Bending::NearIsometry, Role::Target) => Some(&target.middle),
        },
    };
    let smoothed = surfaces.smoothed()?;
    // Inference runs only if the request asks for no other energy.
    let inferred = match (posed, scene.parameters.displacement.bending) {
        (PoseResult::ByField, Bending::NearIsometry) => {
            Some(inferred(coarse, &smoothed, surfaces.lengths.root_mm, &counting)?)
        }
        _ => None,
    };
    // If one surface is open, some labels or variables may have no counterpart.
    let may_begin = !surfaces.open && scene.parameters.displacement.starts == FieldStarts::Inference;
    match inferred.as_ref().filter(|inferred| may_begin && inferred.is_clear()) {
        Some(inferred) => {
            let poses: Vec<RigidTransform> = inferred.poses().collect();
            starts.add_inferred(coarse, &poses, |pose| aligned_shortly(coarse, pose));
        }
        None if keeps_pose(coarse, posed) => {}
        None => starts.add_searched(coarse),
    }
    observer.phase(Phase::Displacement);
    // Bending does not turn the source into its mirror image.
    let surfaces = match &inferred {
        Some(inferred) if inferred.is_of_other_handedness() => {
            Surfaces { bending: Bending::None, side_of: &|_| None, ..surfaces }
        }
        _ => surfaces,
    };
    let poses = starts.with_excess(sameness(&source.middle, &target.middle));
    let options = DisplacementOptions {
        uncertainty: scene.parameters.displacement.uncertainty,
        ..DisplacementOptions::default()
    };
    let allow_reflection = scene.parameters.registration.allow_reflection;
    let elsewhere: RefCell<Option<Box<VertexImages>>> = RefCell::new(None);
    let is_outdone = decision.map(|decide| {
        |likeness: f64| match decide(likeness)? {
            AfterCoarseStage::GoOn => Ok(false),
            AfterCoarseStage::End(found) => {
                elsewhere.replace(found);
                Ok(true)
            }
        }
    });
    let is_outdone = is_outdone.as_ref().map(|f| f as &IsOutdone<'_>);
    let fitted = displace(&surfaces, smoothed, &poses, allow_reflection, &options, &counting, is_outdone)?;
    let Some(fitted) = fitted else { return Ok(elsewhere.into_inner().map(|found| *found)) };
    let found = DisplacementAnswer::of(fitted, &surfaces);
    let mut displaced = answered(scene, &starts.poses, &found, reliability(&found));
    displaced.inference =
        inferred.map(|inferred| inferred.clamped(labels_of(coarse, &displaced.labeling), &displaced.transform));
    observer.progress(PROGRESS_AT_END);
    Ok(Some(displaced))
}
