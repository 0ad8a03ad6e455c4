//! What is to be solved for two surfaces, and on which of their levels.

use super::scene::Scene;
use crate::surface::levels::Levels;
use homolog_mrf::MrfModel;

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

/// An energy to be minimized.
pub(crate) struct EnergyProblem<'a> {
    pub model: MrfModel,
    /// No labeling has an energy below this; `None` where no bound was asked for.
    pub lower_bound: Option<f64>,
    /// The surfaces whose vertices are the variables and the labels.
    pub scene: Scene<'a>,
}

impl Coarse<'_> {
    /// Whether all vertices of both surfaces are variables and labels of the energy.
    pub(crate) fn is_direct(&self) -> bool {
        self.source.is_direct() && self.target.is_direct()
    }
}
