//! Inference in the pipeline: the labels of near isometries of a pair of surfaces, and the labels of an answer.

use crate::energy::inference::{InferenceSettings, IsometryInference, infer};
use crate::energy::model::SiteMeasurements;
use crate::energy::settings::IsometrySettings;
use crate::error::MatchError;
use crate::pair::problem::MatchProblem;
use crate::pair::smooth_pair::SmoothPair;
use crate::poses::copies::align_shortly;
use homolog_mrf::Labeling;
use homolog_primitives::observe::{Observer, Phase};
use homolog_registration::{RigidTransform, SurfaceSide};

/// The alignment of a start ends when a step rotates by less than this, radians, and moves by less than this, in
/// diagonals.
const TOLERANCE: f64 = 1e-4;

/// Infers the labels of near isometries between the surfaces of `prepare_problem`, prepared as `smoothed`, and traces their
/// energy.
///
/// # Errors
/// [`MatchError::Cancelled`].
pub(crate) fn inferred(
    coarse: &MatchProblem<'_>,
    smoothed: &SmoothPair,
    root_mm: f64,
    observer: &dyn Observer,
) -> Result<IsometryInference, MatchError> {
    observer.phase(Phase::Inference);
    let (source, target) = (&coarse.source.middle, &coarse.target.middle);
    let settings = IsometrySettings::default();
    let (of_source, of_target) = rayon::join(
        || SiteMeasurements::of(&smoothed.0, source.sites(), &settings),
        || SiteMeasurements::of(&smoothed.1, target.sites(), &settings),
    );
    let found =
        infer(&of_source, &of_target, root_mm, coarse.full.parameters.seed, &InferenceSettings::default(), observer)?;
    found.trace(observer);
    Ok(found)
}

/// Converts `labeling`, a target vertex for every source vertex, to a label for each variable.
pub(crate) fn labels_of(coarse: &MatchProblem<'_>, labeling: &[u32]) -> Labeling {
    let (source, target) = (coarse.source, coarse.target);
    let (variables, labels) = (source.middle.sites(), target.middle.sites());
    let of_full = source.full_of_middle();
    let label = |&site: &u32| {
        let vertex = of_full[variables.vertices[site as usize] as usize];
        labels.cells[target.middle_of(labeling[vertex as usize]) as usize]
    };
    variables.first(IsometrySettings::default().n_variables).iter().map(label).collect()
}

/// `pose` after a few steps of alignment to closest points in both directions, on lightly smoothed surfaces; `None` if
/// cancelled.
pub(crate) fn aligned_shortly(coarse: &MatchProblem<'_>, pose: &RigidTransform) -> Option<RigidTransform> {
    let [source, target] = [&coarse.source.middle, &coarse.target.middle].map(|side| {
        let light = side.light();
        SurfaceSide { points: light.mesh.vertices(), areas: &light.areas, closest: &light.closest }
    });
    let edge_mm = coarse.target.middle.mesh().mean_edge_length();
    let found = align_shortly(&source, &target, pose, (edge_mm, TOLERANCE), coarse.full.observer).ok()?;
    Some(found.target_from_source)
}
