//! The smooth displacement field as the last step of a match.

use super::MatchError;
use super::displacement::{DisplacementOptions, displace};
use super::report::Answer;
use super::scene::Scene;
use crate::mrf::MrfModel;
use crate::observe::{Phase, TracePoint};
use crate::registration::principal_axis_poses;

/// Replaces the correspondences and the transform of `answer` by those of a smooth displacement field, judged from the
/// pose found and from the four on the principal axes. Stays as it is where no field can be fitted.
pub(super) fn bend(scene: &Scene<'_>, model: Option<&MrfModel>, answer: &mut Answer) -> Result<(), MatchError> {
    let observer = scene.observer;
    observer.phase(Phase::Refinement);
    let (source, target) = (scene.source.mesh(), scene.target.mesh());
    let mut poses = vec![answer.transform];
    // A mirrored pose has no rivals among proper ones.
    if !answer.transform.is_reflection() {
        poses.extend(principal_axis_poses(source.vertices(), target.vertices()).into_iter().flatten());
    }
    let Some(found) = displace(source, target, &poses, &DisplacementOptions::default(), observer)? else {
        return Ok(());
    };
    answer.labeling = found.images.iter().map(|image| image.label).collect();
    answer.confidence = found.images.iter().map(|image| image.confidence).collect();
    answer.spread_mm = found.images.iter().map(|image| image.spread_mm).collect();
    answer.transform = found.transform;
    if let Some(model) = model {
        let energy = model.energy(&answer.labeling);
        let round = answer.rounds.last().map_or(0, |r| r.round);
        observer.trace(&TracePoint {
            energy: Some(energy.total()),
            energy_unary: Some(energy.unary),
            energy_pairwise: Some(energy.pairwise),
            lower_bound: answer.lower_bound,
            ..TracePoint::new(round, Phase::Refinement, 1)
        });
    }
    Ok(())
}
