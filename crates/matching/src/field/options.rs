//! The settings that all stages of a displacement share.

use super::settings::{ChoiceSettings, FineSettings, IsometryFitSettings, LocalSettings, RouteSettings};
use crate::pair::prior::PriorOptions;
use homolog_contract::parameters::Uncertainty;

/// Settings of the displacement. The defaults are round numbers; nearby values gave the same accuracy within its spread
/// (docs/findings.md).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DisplacementOptions {
    /// The prior of the field, in diagonals of the source.
    pub prior: PriorOptions,
    /// Vertices of the thinned surfaces in each stage. From the fine stage on the target is not thinned.
    pub n_samples: [usize; 4],
    /// Steps of the four stages.
    pub steps: [u32; 4],
    /// Width `σ` of the assignment, in diagonals, at the start and after each of the first three stages.
    pub sigma: [f64; 4],
    /// Independent observations per surface at the start and after each of the first three stages; more observations
    /// make the field less stiff.
    pub density: [f64; 4],
    /// The choice of the pose.
    pub choice: ChoiceSettings,
    /// The fine stage and the settling.
    pub fine: FineSettings,
    /// The local stage.
    pub local: LocalSettings,
    /// The fit from near isometries.
    pub isometry: IsometryFitSettings,
    /// Which starts are tried, and which answer is taken.
    pub route: RouteSettings,
    /// The source of the variances.
    pub uncertainty: Uncertainty,
}

impl Default for DisplacementOptions {
    fn default() -> Self {
        DisplacementOptions {
            prior: PriorOptions::default(),
            n_samples: [700, 1200, 1200, 1200],
            steps: [10, 8, 8, 4],
            sigma: [0.05, 0.04, 0.025, 0.02],
            density: [48.0, 48.0, 160.0, 480.0],
            choice: ChoiceSettings::default(),
            fine: FineSettings::default(),
            local: LocalSettings::default(),
            isometry: IsometryFitSettings::default(),
            route: RouteSettings::default(),
            uncertainty: Uncertainty::Posterior,
        }
    }
}
