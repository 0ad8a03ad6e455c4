//! The problem of a match: how a pose is found, and on which levels of the surfaces.

use super::scene::Scene;
use crate::surface::levels::Levels;
use homolog_mrf::MrfModel;

/// The two surfaces at the level on which a match begins, with their features: the result of the first stage.
pub(crate) struct MatchProblem<'a> {
    pub source: &'a Levels,
    pub target: &'a Levels,
    /// Both surfaces with all their vertices.
    pub full: Scene<'a>,
    pub problem: Problem<'a>,
}

/// How a pose is found.
#[expect(clippy::large_enum_variant, reason = "there is one in a match")]
pub(crate) enum Problem<'a> {
    /// By registration alone, according to `registration.initial`.
    Registration,
    /// By RANSAC over the labeling of an energy.
    Energy(EnergyProblem<'a>),
}

/// An energy to minimize.
pub(crate) struct EnergyProblem<'a> {
    pub model: MrfModel,
    /// Lower bound of the energy of all labelings; `None` if no bound was asked for.
    pub lower_bound: Option<f64>,
    /// The surfaces whose vertices are the variables and the labels.
    pub scene: Scene<'a>,
}

impl MatchProblem<'_> {
    /// Whether the variables and labels of the energy are all vertices of the surfaces.
    pub(crate) fn is_direct(&self) -> bool {
        self.source.is_direct() && self.target.is_direct()
    }
}
