//! Findings for each subject.

use crate::folder::Decision;
use crate::record::Facts;
use crate::rivals::GroupDecision;
use serde::Serialize;
use std::collections::BTreeMap;

/// Outcome of a subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SubjectOutcome {
    /// Part of the model.
    Model,
    /// Compared with the model.
    Scored,
    /// Left out by a decision.
    Dropped,
    /// Left out because its match is not reliable, and no decision keeps it.
    Unreliable,
    /// There is no match.
    Failed,
}

impl SubjectOutcome {
    /// The name used in tables and JSON.
    pub fn name(self) -> &'static str {
        match self {
            SubjectOutcome::Model => "model",
            SubjectOutcome::Scored => "scored",
            SubjectOutcome::Dropped => "dropped",
            SubjectOutcome::Unreliable => "unreliable",
            SubjectOutcome::Failed => "failed",
        }
    }
}

/// A reason to look at a subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Flag {
    /// It has no match.
    NoMatch,
    /// Its match is not reliable.
    UnreliableMatch,
    /// The bent template lies farther from its surface than from the surfaces of the others.
    UnusualResidual,
    /// The map to it turns over more triangles than the maps to the others.
    UnusualFolds,
    /// Its shape is unusual relative to a model of the others.
    UnusualShape,
    /// Its size is unusual.
    UnusualSize,
    /// Its match leaves the pose open, and the group decided it.
    PoseByGroup,
}

impl Flag {
    /// Title for people.
    pub fn title(self) -> &'static str {
        match self {
            Flag::NoMatch => "no match",
            Flag::UnreliableMatch => "match not reliable",
            Flag::UnusualResidual => "unusual residual",
            Flag::UnusualFolds => "unusual folds",
            Flag::UnusualShape => "unusual shape",
            Flag::UnusualSize => "unusual size",
            Flag::PoseByGroup => "pose decided by the group",
        }
    }
}

/// Size of a label of one subject.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LabelSize {
    /// Its area on the surface, mm².
    pub area_mm2: f64,
    /// Its volume, mm³, if the input was a label volume.
    pub volume_mm3: Option<f64>,
}

/// Pose of a structure of one person relative to the mean configuration, once the first structure lies on that of the mean.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RelativePose {
    /// Shift of the centroid along the axes of the mean, mm.
    pub shift_mm: [f64; 3],
    /// Angle of the rotation, degrees, from 0 to 180.
    pub rotation_degrees: f64,
}

/// Findings for one structure of a person, in a study of several.
#[derive(Debug, Clone, PartialEq)]
pub struct StructureFindings {
    /// The structure.
    pub name: String,
    /// Facts on its surface and its match.
    pub facts: Facts,
    /// What the group says about its pose, if its match leaves it open.
    pub group: Option<GroupDecision>,
    /// Its pose; `None` for the first structure, and where a structure has no match.
    pub pose: Option<RelativePose>,
}

impl SubjectFindings {
    /// What the group says about the pose, with the name of the structure where there are several.
    pub fn group_decisions(&self) -> impl Iterator<Item = (Option<&str>, &GroupDecision)> {
        let of_structures = self.structures.iter().filter_map(|of| Some((Some(of.name.as_str()), of.group.as_ref()?)));
        self.group.iter().map(|own| (None, own)).chain(of_structures)
    }
}

/// Findings for one subject.
#[derive(Debug, Clone, PartialEq)]
pub struct SubjectFindings {
    /// Outcome.
    pub place: SubjectOutcome,
    /// Facts on its surface and its match.
    pub facts: Facts,
    /// Decision, if any.
    pub decision: Option<Decision>,
    /// What the group says about its pose, if its match leaves it open.
    pub group: Option<GroupDecision>,
    /// Centroid size of its shape, mm.
    pub size_mm: f64,
    /// Scores, mm.
    pub scores: Vec<f64>,
    /// Squared Mahalanobis distance from the model of the other subjects.
    pub distance: Option<f64>,
    /// The p-value of a shape as unusual, from distances of left-out subjects.
    pub unusual_p: Option<f64>,
    /// Reasons to look at the subject.
    pub flags: Vec<Flag>,
    /// Urgency of looking at the subject; larger is more urgent.
    pub urgency: f64,
    /// Size of each label.
    pub labels: BTreeMap<u32, LabelSize>,
    /// Its structures in alphabetical order; empty in a study of one.
    pub structures: Vec<StructureFindings>,
}
