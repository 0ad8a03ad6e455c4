//! What is asked of a study, besides its subjects; it is recorded in `study.json`.

use homolog_contract::input::BodySide;
use homolog_contract::parameters::MatchParameters;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What is asked of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Where the template comes from.
    pub template: TemplateChoice,
    /// On which side of the body the template lies, where subjects have sides; `None`: that of the subject from which it is made, or
    /// of most subjects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template_side: Option<BodySide>,
    /// Whether differences in size are part of shape.
    pub size: Size,
    /// The statistics.
    pub analysis: Analysis,
    /// Subjects among which the consistency of maps is measured; fewer than 3: it is not measured.
    pub cycle_subjects: usize,
    /// Ids of these subjects; empty: chosen.
    #[serde(default)]
    pub cycle_ring: Vec<String>,
    /// Parameters of every match.
    pub parameters: MatchParameters,
}

/// Where the template comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum TemplateChoice {
    /// A file.
    Given {
        /// The file.
        file: PathBuf,
    },
    /// The mean of the group.
    Made(MadeTemplate),
}

/// How a template is made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MadeTemplate {
    /// Id of the subject whose surface is the first template; `None`: the one of median volume.
    pub start: Option<String>,
    /// Most subjects that the template is made from, spread evenly over the table; 0: all.
    pub subjects: usize,
    /// Ids of these subjects; empty: chosen.
    #[serde(default)]
    pub from: Vec<String>,
    /// Most rounds of matching and averaging.
    pub max_rounds: usize,
    /// The template is finished when a round moves its surface by less than this share of its mean edge length, RMS.
    pub tolerance: f64,
}

impl Default for MadeTemplate {
    fn default() -> Self {
        MadeTemplate { start: None, subjects: 12, from: Vec::new(), max_rounds: 8, tolerance: 0.05 }
    }
}

/// Whether differences in size are part of shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Size {
    /// Subjects are rotated and moved onto the mean.
    Kept,
    /// They are scaled too.
    Removed,
}

/// A quantity at each vertex of each subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Displacement from the mean along the outward normal of the mean, mm.
    NormalDisplacement,
    /// Logarithm of the area around the vertex over that of the mean.
    LogArea,
    /// Radius of the largest ball inside the surface that touches it at the vertex, mm.
    Thickness,
}

impl Measure {
    /// All of them.
    pub const ALL: [Measure; 3] = [Measure::NormalDisplacement, Measure::LogArea, Measure::Thickness];

    /// The name used in files and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Measure::NormalDisplacement => "normal_displacement",
            Measure::LogArea => "log_area",
            Measure::Thickness => "thickness",
        }
    }

    /// Its unit and meaning, for people.
    pub fn title(self) -> &'static str {
        match self {
            Measure::NormalDisplacement => "displacement along the outward normal, mm",
            Measure::LogArea => "logarithm of the local area over that of the mean",
            Measure::Thickness => "radius of the largest inner ball that touches, mm",
        }
    }
}

/// The statistics of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Analysis {
    /// The covariate of interest: its difference between levels, or its slope, is tested. `None`: no statistics, unless
    /// contrasts are given.
    pub effect: Option<String>,
    /// Covariates that are adjusted for.
    pub adjust: Vec<String>,
    /// Reference level of factors: `(covariate, level)`; otherwise the first in alphabetical order.
    pub reference: Vec<(String, String)>,
    /// Further contrasts: a name, and a sum of columns of the design such as `group:a - group:b`.
    pub contrasts: Vec<(String, String)>,
    /// What is tested.
    pub measures: Vec<Measure>,
    /// Permutations of each test.
    pub permutations: usize,
    /// Seed of the permutations and of the shapes that measure specificity.
    pub seed: u64,
}

impl Default for Analysis {
    fn default() -> Self {
        Analysis {
            effect: None,
            adjust: Vec::new(),
            reference: Vec::new(),
            contrasts: Vec::new(),
            measures: Measure::ALL.to_vec(),
            permutations: 2000,
            seed: 0,
        }
    }
}
