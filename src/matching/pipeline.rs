//! From two surfaces to an outcome: the energy, its rounds, and what is reported.

use super::bending::bend;
use super::parameters::{Algorithm, DisplacementMode, MatchParameters};
use super::prepare::{Side, build_model};
use super::report::outcome;
use super::rounds::Matcher;
use super::scene::Scene;
use super::{MatchError, MatchOutcome, bound, registration_only};
use crate::mesh::SurfaceMesh;
use crate::observe::{Observer, Phase, checkpoint};

pub(super) fn run(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let (source, target) = (Side::new(source), Side::new(target));
    let scene = Scene::new(&source, &target, parameters, observer);
    if parameters.inference.algorithm == Algorithm::None {
        let mut answer = registration_only::register(&scene)?;
        if parameters.displacement.mode == DisplacementMode::Smooth {
            bend(&scene, None, &mut answer)?;
        }
        observer.phase(Phase::Reporting);
        return Ok(outcome(&scene, None, answer));
    }
    let model = build_model(&source, &target, parameters)?;
    checkpoint(observer)?;
    observer.progress(0.05);
    let lower_bound = bound::lower_bound(&model, parameters.inference.lower_bound_iterations, observer)?;
    let mut answer = Matcher { scene: &scene, model: &model, lower_bound }.rounds()?;
    if parameters.displacement.mode == DisplacementMode::Smooth {
        bend(&scene, Some(&model), &mut answer)?;
    }
    observer.phase(Phase::Reporting);
    Ok(outcome(&scene, Some(&model), answer))
}
