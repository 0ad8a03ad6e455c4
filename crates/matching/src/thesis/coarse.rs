//! The first stage: the problem to solve, and the levels of the surfaces on which it is solved.

use super::bound::lower_bound;
use super::prepare::build_model;
use crate::error::MatchError;
use crate::pair::problem::{EnergyProblem, MatchProblem, Problem};
use crate::pair::progress::PROGRESS_BEFORE_ROUNDS;
use crate::pair::scene::Scene;
use crate::surface::levels::Levels;
use homolog_contract::parameters::{Algorithm, MatchParameters};
use homolog_primitives::observe::{Observer, checkpoint};

/// Builds the energy that `parameters` ask for, and its lower bound if they ask for that.
pub(crate) fn prepare_problem<'a>(
    source: &'a Levels,
    target: &'a Levels,
    parameters: &'a MatchParameters,
    observer: &'a dyn Observer,
) -> Result<MatchProblem<'a>, MatchError> {
    if parameters.inference.algorithm == Algorithm::None {
        let full = Scene::new(&source.full, &target.full, parameters, observer);
        return Ok(MatchProblem { source, target, full, problem: Problem::Registration });
    }
    // The scene builds its tree of closest points on one thread, which takes about as long as the model on fine
    // surfaces.
    let (full, model) = rayon::join(
        || Scene::new(&source.full, &target.full, parameters, observer),
        || {
            let (source, target) =
                rayon::join(|| source.energy_observed(observer), || target.energy_observed(observer));
            build_model(&source?.side, &target?.side, parameters, observer)
        },
    );
    let model = model?;
    checkpoint(observer)?;
    observer.progress(PROGRESS_BEFORE_ROUNDS);
    let lower_bound = lower_bound(&model, parameters.inference.lower_bound_iterations, observer)?;
    let scene = if source.is_direct() && target.is_direct() {
        full
    } else {
        Scene::new(&source.energy().side, &target.energy().side, parameters, observer)
    };
    Ok(MatchProblem { source, target, full, problem: Problem::Energy(EnergyProblem { model, lower_bound, scene }) })
}
