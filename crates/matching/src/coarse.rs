//! The first stage: what is to be solved, and on which level of the surfaces.

use super::levels::Levels;
use super::prepare::build_model;
use super::rounds::PROGRESS_BEFORE_ROUNDS;
use super::scene::Scene;
use super::{MatchError, bound};
use homolog_contract::parameters::{Algorithm, MatchParameters};
use homolog_mrf::MrfModel;
use homolog_primitives::observe::{Observer, checkpoint};

/// What the first stage hands over.
pub(crate) struct Coarse<'a> {
    pub source: &'a Levels,
    pub target: &'a Levels,
    /// Both surfaces with all their vertices.
    pub full: Scene<'a>,
    pub problem: Problem<'a>,
}

/// How a pose is to be found.
#[expect(clippy::large_enum_variant, reason = "there is one in a match")]
pub(crate) enum Problem<'a> {
    /// By registration alone, as `registration.initial` says.
    Registration,
    /// By RANSAC over the labeling of an energy.
    Energy(EnergyProblem<'a>),
}

/// An energy to be minimised.
pub(crate) struct EnergyProblem<'a> {
    pub model: MrfModel,
    /// No labeling has an energy below this; `None` where no bound was asked for.
    pub lower_bound: Option<f64>,
    /// The surfaces whose vertices are the variables and the labels.
    pub scene: Scene<'a>,
}

/// Builds the energy that `parameters` ask for, and bounds it from below if they ask for that.
pub(crate) fn coarse<'a>(
    source: &'a Levels,
    target: &'a Levels,
    parameters: &'a MatchParameters,
    observer: &'a dyn Observer,
) -> Result<Coarse<'a>, MatchError> {
    if parameters.inference.algorithm == Algorithm::None {
        let full = Scene::new(&source.full, &target.full, parameters, observer);
        return Ok(Coarse { source, target, full, problem: Problem::Registration });
    }
    // The scene's tree of closest points is built on one thread, and both take about as long on fine surfaces.
    let (full, model) = rayon::join(
        || Scene::new(&source.full, &target.full, parameters, observer),
        || {
            let (source, target) = rayon::join(|| source.energy(), || target.energy());
            build_model(&source.side, &target.side, parameters)
        },
    );
    let model = model?;
    checkpoint(observer)?;
    observer.progress(PROGRESS_BEFORE_ROUNDS);
    let lower_bound = bound::lower_bound(&model, parameters.inference.lower_bound_iterations, observer)?;
    let scene = if source.is_direct() && target.is_direct() {
        full
    } else {
        Scene::new(&source.energy().side, &target.energy().side, parameters, observer)
    };
    Ok(Coarse { source, target, full, problem: Problem::Energy(EnergyProblem { model, lower_bound, scene }) })
}

impl Coarse<'_> {
    /// Whether all vertices of both surfaces are variables and labels of the energy.
    pub(crate) fn is_direct(&self) -> bool {
        self.source.is_direct() && self.target.is_direct()
    }
}
