//! Settings of a study, apart from its subjects; they are recorded in `study.json`.

use homolog_contract::input::BodySide;
use homolog_contract::parameters::MatchParameters;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Settings of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Origin of the template.
    pub template: TemplateChoice,
    /// Side of the body of the template, if subjects have sides; `None` for the side of the subject from which it is
    /// made, or of most subjects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template_side: Option<BodySide>,
    /// Whether differences in size are part of shape.
    pub size: Size,
    /// Origin of the maps from the template to the subjects; pairs in documents of earlier versions.
    #[serde(default)]
    pub correspondence: Correspondence,
    /// What the visits of one person are matched with.
    #[serde(default, skip_serializing_if = "Visits::is_default")]
    pub visits: Visits,
    /// What becomes of subjects whose pose is ambiguous.
    #[serde(default, skip_serializing_if = "Rivals::is_default")]
    pub rivals: Rivals,
    /// The statistics.
    pub analysis: Analysis,
    /// Number of subjects used to measure the consistency of maps; it is not measured with fewer than 3.
    pub cycle_subjects: usize,
    /// Ids of these subjects; empty for an automatic choice.
    #[serde(default)]
    pub cycle_ring: Vec<String>,
    /// Parameters of every match.
    pub parameters: MatchParameters,
}

/// Origin of the template.
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

/// Options of making a template.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MadeTemplate {
    /// Id of the subject, or of the person with several structures, whose surface is the first template; `None` for the subject of median volume.
    pub start: Option<String>,
    /// Largest number of subjects the template is made from, spread evenly over the table; 0 for all.
    pub subjects: usize,
    /// Ids of these subjects; empty for an automatic choice.
    #[serde(default)]
    pub from: Vec<String>,
    /// Largest number of rounds of matching and averaging.
    pub max_rounds: usize,
    /// RMS movement of the surface in a round, as a share of its mean edge length, below which the template is
    /// finished.
    pub tolerance: f64,
    /// Structures whose template is not made but given, by name: the files.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub given: BTreeMap<String, PathBuf>,
}

impl Default for MadeTemplate {
    fn default() -> Self {
        let (from, given) = (Vec::new(), BTreeMap::new());
        MadeTemplate { start: None, subjects: 12, from, max_rounds: 8, tolerance: 0.05, given }
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

/// Origin of the maps from the template to the subjects.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Correspondence {
    /// Each subject's own match.
    #[default]
    Pairs,
    /// The matches, revised together under a model of the group ([`crate::joint`]).
    Joint,
}

impl Correspondence {
    /// All, the default of the command and of the service first.
    pub const ALL: [Correspondence; 2] = [Correspondence::Pairs, Correspondence::Joint];

    /// The name used in files, options and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Correspondence::Pairs => "pairs",
            Correspondence::Joint => "joint",
        }
    }

    /// The origin with a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|of| of.name() == name)
    }
}

/// What the visits of one person are matched with.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Visits {
    /// The template of the group, each visit separately.
    #[default]
    GroupTemplate,
    /// A template of the person, made from its visits, with which the template of the group is matched
    /// ([`crate::visits`]).
    OwnTemplate,
}

impl Visits {
    /// All, the default of the command and of the service first.
    pub const ALL: [Visits; 2] = [Visits::GroupTemplate, Visits::OwnTemplate];

    /// The name used in files and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Visits::GroupTemplate => "group_template",
            Visits::OwnTemplate => "own_template",
        }
    }

    /// The name used in options of the command.
    pub fn option(self) -> &'static str {
        match self {
            Visits::GroupTemplate => "group-template",
            Visits::OwnTemplate => "own-template",
        }
    }

    /// The choice with a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|of| of.name() == name || of.option() == name)
    }

    fn is_default(&self) -> bool {
        *self == Visits::GroupTemplate
    }
}

/// Fewest reliable subjects from which a group decides about poses: the scale of their differences is a variance, and the farthest
/// of two is no range.
pub(crate) const FEWEST_RELIABLE: usize = 3;

/// What becomes of a subject that several poses explain as well (`ambiguous_pose`).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rivals {
    /// The group decides which of its poses is right, where it can ([`crate::rivals`]).
    #[default]
    Decide,
    /// It is left out, unless a person keeps it.
    LeaveOut,
}

impl Rivals {
    /// All, the default of the command and of the service first.
    pub const ALL: [Rivals; 2] = [Rivals::Decide, Rivals::LeaveOut];

    /// The name used in files and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Rivals::Decide => "decide",
            Rivals::LeaveOut => "leave_out",
        }
    }

    /// The name used in options of the command.
    pub fn option(self) -> &'static str {
        match self {
            Rivals::Decide => "decide",
            Rivals::LeaveOut => "leave-out",
        }
    }

    /// The choice with a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|of| of.name() == name || of.option() == name)
    }

    fn is_default(&self) -> bool {
        *self == Rivals::Decide
    }
}

/// A quantity at each vertex of each subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Displacement from the mean along the outward normal of the mean, mm.
    NormalDisplacement,
    /// Logarithm of the ratio of the area around the vertex to that of the mean.
    LogArea,
    /// Diameter of the largest ball inside the surface that touches it at the vertex, mm.
    Thickness,
}

impl Measure {
    /// All measures.
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
            Measure::Thickness => "local thickness, mm",
        }
    }
}

/// The statistics of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Analysis {
    /// The covariate of interest: its difference between levels, or its slope, is tested. `None` for no statistics,
    /// unless contrasts are given.
    pub effect: Option<String>,
    /// Covariates to adjust for.
    pub adjust: Vec<String>,
    /// Reference level of factors: `(covariate, level)`; otherwise the first in alphabetical order.
    pub reference: Vec<(String, String)>,
    /// Further contrasts: a name, and a sum of columns of the design such as `group:a - group:b`.
    pub contrasts: Vec<(String, String)>,
    /// The tested measures.
    pub measures: Vec<Measure>,
    /// Number of permutations of each test.
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
