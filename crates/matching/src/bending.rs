//! The smooth displacement field as the last step of a match.

use super::displacement::{DisplacementOptions, JudgedPose, StartPose, Surfaces, displace, landmark_pose};
use super::levels::Levels;
use super::poses::searched;
use super::reliability::{UNRELIABLE_CONFIDENCE, reliability, without_counterpart};
use super::report::Answer;
use super::scene::Scene;
use super::{MatchError, rounds};
use homolog_contract::parameters::Anatomy;
use homolog_contract::result::{AnatomyDocument, PoseDocument, PoseOrigin};
use homolog_mrf::{Labeling, MrfModel};
use homolog_primitives::observe::{Phase, TracePoint};
use homolog_registration::{RigidTransform, SAME_POSE_ANGLE, ScoredPose};

/// Replaces the correspondences and the transform of `answer` by those of a smooth displacement field, from whichever
/// pose fits best after bending: the one found, those of a search of all orientations, mirrored too, and that of the landmarks.
/// Says what the answer is as a labeling of `model`. Stays as it is where no field can be fitted.
pub(super) fn bend(
    scene: &Scene<'_>,
    (source, target): (&Levels, &Levels),
    model: Option<&MrfModel>,
    answer: &mut Answer,
) -> Result<Option<Labeling>, MatchError> {
    let observer = scene.observer;
    observer.phase(Phase::Displacement);
    let allow_reflection = scene.parameters.registration.allow_reflection;
    let of_answer = if model.is_some() { PoseOrigin::Inference } else { PoseOrigin::Registration };
    let mut poses = vec![(of_answer, answer.transform)];
    let of_landmarks = landmark_pose(&scene.parameters.landmarks, allow_reflection);
    poses.extend(of_landmarks.map(|pose| (PoseOrigin::Landmarks, pose)));
    // Of either handedness, so that a mirrored image is noticed.
    let of_search = searched(&source.middle, &target.middle, true);
    poses.extend(of_search.iter().map(|p| (PoseOrigin::Search, p.target_from_source)));
    let surfaces = Surfaces {
        source: source.middle.mesh(),
        target: target.middle.mesh(),
        full_source: source.full.mesh(),
        full_target: target.full.mesh(),
        full_closest: &scene.closest.index,
        landmarks: &scene.parameters.landmarks,
    };
    let starts: Vec<StartPose> =
        poses.iter().map(|(_, pose)| StartPose { pose: *pose, excess: excess(pose, &of_search) }).collect();
    let options = DisplacementOptions { anatomy: scene.parameters.displacement.anatomy, ..Default::default() };
    let found = displace(&surfaces, &starts, allow_reflection, &options, observer)?;
    let Some(found) = found else { return Ok(None) };
    answer.labeling = found.images.iter().map(|image| image.label).collect();
    let reliability = reliability(&found, source.full.mesh(), target.full.mesh());
    let trust = if reliability.reliable { 1.0 } else { UNRELIABLE_CONFIDENCE };
    answer.no_counterpart = without_counterpart(target.full.mesh(), scene.edge_mm, &found.images);
    answer.confidence = found
        .images
        .iter()
        .zip(&answer.no_counterpart)
        .map(|(image, &alone)| if alone { 0.0 } else { trust * image.confidence })
        .collect();
    answer.spread_mm = found.images.iter().map(|image| image.spread_mm).collect();
    answer.points = Some(found.images.iter().map(|image| image.closest).collect());
    answer.moved = Some(found.images.iter().map(|image| image.moved).collect());
    answer.poses = found.judged.iter().map(|judged| document(scene, &poses, judged, &found.transform)).collect();
    answer.reliability = Some(reliability);
    answer.anatomy = found.slide.map(|slide| AnatomyDocument {
        structure: Anatomy::Hippocampus,
        source_distance: slide.distances[0],
        target_distance: slide.distances[1],
        slide_mm: slide.rms_mm,
    });
    answer.transform = found.transform;
    observer.progress(rounds::PROGRESS_AT_END);
    let Some(model) = model else { return Ok(None) };
    let mut labeling = vec![0; model.variables.n_vertices()];
    // Of the vertices of a cell its site is one, and it is the one whose image counts.
    for (i, &k) in source.cells.iter().enumerate() {
        if source.full.surface.numbering.original(i as u32) == source.energy.surface.numbering.original(k) {
            labeling[k as usize] = target.cells[answer.labeling[i] as usize];
        }
    }
    let energy = model.energy(&labeling);
    let round = answer.rounds.last().map_or(0, |r| r.round);
    observer.trace(&TracePoint {
        energy: Some(energy.total()),
        energy_unary: Some(energy.unary),
        energy_pairwise: Some(energy.pairwise),
        lower_bound: answer.lower_bound,
        ..TracePoint::new(round, Phase::Displacement, 1)
    });
    Ok(Some(labeling))
}

/// How much worse than the best the search found `pose`: as much as the nearest pose it returned, within 30 degrees; a
/// pose that it did not return is as bad as its last.
fn excess(pose: &RigidTransform, of_search: &[ScoredPose]) -> f64 {
    let alike = of_search.iter().filter(|p| {
        let found = &p.target_from_source;
        found.is_reflection() == pose.is_reflection() && found.angle_to(pose) < SAME_POSE_ANGLE
    });
    let least = alike.map(|p| p.excess).fold(f64::INFINITY, f64::min);
    least.min(of_search.last().map_or(0.0, |p| p.excess))
}

/// A followed pose as the result states it.
fn document(
    scene: &Scene<'_>,
    poses: &[(PoseOrigin, RigidTransform)],
    judged: &JudgedPose,
    answered: &RigidTransform,
) -> PoseDocument {
    let (origin, pose) = poses[judged.pose];
    PoseDocument {
        origin,
        matrix: pose.matrix(),
        angle_deg: pose.angle_to(answered).to_degrees(),
        rms_mm: scene.sample_rms_mm(&pose),
        misfit: Some(judged.misfit),
        mirrored: judged.mirrored,
    }
}
