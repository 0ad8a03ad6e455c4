//! The settings that all stages of a displacement share.

use super::settings::{ChoiceSettings, IsometryFitSettings, LocalSettings, RouteSettings, SlidingSettings};
use crate::error::MatchError;
use crate::pair::prior::PriorOptions;
use homolog_contract::parameters::Uncertainty;
use homolog_registration::alignment::annealed;

/// Whether the match of another form of the same surfaces, given the likeness of the shapes after the coarse stage of
/// this one, leaves this one without an answer.
pub(crate) type IsOutdone<'a> = dyn Fn(f64) -> Result<bool, MatchError> + 'a;

/// One stage of a displacement.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StageSettings {
    /// Vertices of a thinned surface.
    pub n_samples: usize,
    /// Steps.
    pub steps: u32,
    /// Most repetitions of steps that still move the surface.
    pub repetitions: u32,
    /// Width `σ` of the assignment at the start and at the end, in diagonals.
    pub sigma: [f64; 2],
    /// Independent observations per surface at the start and at the end; more observations make the field less stiff.
    pub observations: [f64; 2],
}

impl StageSettings {
    /// Width of the assignment at `progress` through the stage, in diagonals.
    pub(crate) fn sigma_at(&self, progress: f64) -> f64 {
        annealed(self.sigma[0], self.sigma[1], progress)
    }

    /// Independent observations per surface at `progress` through the stage.
    pub(crate) fn observations_at(&self, progress: f64) -> f64 {
        annealed(self.observations[0], self.observations[1], progress)
    }
}

/// Settings of the displacement. The defaults are round numbers; nearby values gave the same accuracy within its spread
/// (docs/findings.md).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DisplacementOptions {
    /// The prior of the field, in diagonals of the source.
    pub prior: PriorOptions,
    /// The coarse stage: both surfaces thinned, assigned means as observations. One fit for each pose.
    pub coarse: StageSettings,
    /// The middle stage: the same from the chosen pose, at smaller scales.
    pub middle: StageSettings,
    /// The fine stage: the whole target, and distances along its normals as observations.
    pub fine: StageSettings,
    /// The choice of the pose.
    pub choice: ChoiceSettings,
    /// The observations of the fine stage.
    pub sliding: SlidingSettings,
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
            coarse: StageSettings {
                n_samples: 700,
                steps: 6,
                repetitions: 10,
                sigma: [0.05, 0.04],
                observations: [48.0, 48.0],
            },
            middle: StageSettings {
                n_samples: 1200,
                steps: 5,
                repetitions: 20,
                sigma: [0.04, 0.025],
                observations: [48.0, 160.0],
            },
            fine: StageSettings {
                n_samples: 1200,
                steps: 5,
                repetitions: 10,
                sigma: [0.025, 0.02],
                observations: [160.0, 480.0],
            },
            choice: ChoiceSettings::default(),
            sliding: SlidingSettings::default(),
            local: LocalSettings::default(),
            isometry: IsometryFitSettings::default(),
            route: RouteSettings::default(),
            uncertainty: Uncertainty::Posterior,
        }
    }
}
