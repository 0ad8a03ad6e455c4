//! From two surfaces to an outcome: the energy, its rounds, the displacement, and what is reported.

use super::bending::bend;
use super::levels::Levels;
use super::prepare::build_model;
use super::report::{energy, outcome};
use super::rounds::Matcher;
use super::scene::Scene;
use super::{MatchError, MatchOutcome, bound, registration_only};
use homolog_contract::parameters::{Algorithm, DisplacementMode, MatchParameters};
use homolog_primitives::observe::{Observer, Phase, checkpoint};

pub(super) fn run(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let bends = parameters.displacement.mode == DisplacementMode::Smooth;
    if parameters.inference.algorithm == Algorithm::None {
        let scene = Scene::new(&source.full, &target.full, parameters, observer);
        let mut answer = registration_only::register(&scene)?;
        if bends {
            bend(&scene, (source, target), None, &mut answer)?;
        }
        observer.phase(Phase::Reporting);
        return Ok(outcome(&scene, None, answer));
    }
    // The scene's tree of closest points grows on one thread, and both take about as long on fine surfaces.
    let (scene, model) = rayon::join(
        || Scene::new(&source.full, &target.full, parameters, observer),
        || build_model(&source.energy, &target.energy, parameters),
    );
    let model = model?;
    checkpoint(observer)?;
    observer.progress(0.05);
    let lower_bound = bound::lower_bound(&model, parameters.inference.lower_bound_iterations, observer)?;
    let coarse = (!(source.is_direct() && target.is_direct()))
        .then(|| Scene::new(&source.energy, &target.energy, parameters, observer));
    let level = coarse.as_ref().unwrap_or(&scene);
    let mut answer = Matcher { scene: level, model: &model, lower_bound }.rounds()?;
    let labeling = answer.labeling.clone();
    let bent = if bends { bend(&scene, (source, target), Some(&model), &mut answer)? } else { None };
    // A displacement has answered all vertices; where there is none, those of the energy have to speak for them.
    if coarse.is_some() && answer.moved.is_none() {
        registration_only::answer_all(&scene, &mut answer);
    }
    let labeling = bent.unwrap_or(labeling);
    observer.phase(Phase::Reporting);
    let energy = energy(&model, &labeling, answer.lower_bound);
    Ok(outcome(&scene, Some(energy), answer))
}
