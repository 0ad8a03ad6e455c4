//! JSON documents of scores of new subjects against studies.

use super::input_wire::{SubmittedInputDocument, input};
use super::strict_json::SentTags;
use super::study_wire::{CovariateValue, Covariates, labels};
use crate::jobs::documents::{BodySide, LabelChoice};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// A subject to be scored against a study.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScoreSubmissionDocument {
    /// Its surface or label volume.
    #[serde(deserialize_with = "input")]
    pub(crate) input: SubmittedInputDocument,
    /// The group: members of the model with one level of a covariate; all members if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) group: Option<ScoreGroupDocument>,
    /// Covariates of the study to adjust for: the group is regressed on them, and the subject compared with the prediction at
    /// its own `covariates`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schema(max_items = 256)]
    pub(crate) adjust: Vec<String>,
    /// The values of the subject, a number or a level for each covariate that is adjusted for.
    #[serde(default, skip_serializing_if = "Covariates::is_empty")]
    #[schema(value_type = BTreeMap<String, CovariateValue>, required = false)]
    pub(crate) covariates: Covariates,
    /// On which side of the body it lies; needed if the study has sides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) side: Option<BodySide>,
    /// Labels of its volume that belong to the structure, by number or name; those of the study's parameters if absent. A single
    /// one may stand without brackets.
    #[serde(default, deserialize_with = "labels", skip_serializing_if = "Option::is_none")]
    #[schema(min_items = 1)]
    pub(crate) labels: Option<Vec<LabelChoice>>,
    /// Tags of the job.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = BTreeMap<String, String>, required = false)]
    pub(crate) tags: SentTags,
    /// The client's own id of the subject.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// The job runs before those with a lower priority.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: Option<i32>,
    /// Longest run time, s, up to the limit of the service.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = 1)]
    pub(crate) max_run_s: Option<u64>,
}

/// A subject to be scored, as a multipart form.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub(crate) struct ScoreForm {
    /// The subject; its input refers to a file by its name, as `{"upload": "subject.nii.gz"}`.
    document: ScoreSubmissionDocument,
    /// The file.
    #[schema(value_type = Vec<String>, format = Binary, required = false)]
    files: Vec<String>,
}

/// Members of a model with one level of a covariate.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScoreGroupDocument {
    /// The covariate, a factor.
    #[schema(min_length = 1, max_length = 200)]
    pub(crate) covariate: String,
    /// Its level.
    #[schema(min_length = 1, max_length = 200)]
    pub(crate) level: String,
}

/// The score of a subject against the group of a study.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, ToSchema)]
pub(crate) struct StudyScoreDocument {
    /// Version of homolog.
    pub(crate) version: String,
    /// Commit of the build.
    pub(crate) commit: String,
    /// The group; absent or `null`: all members of the model.
    pub(crate) within: Option<ScoreGroupDocument>,
    /// The adjustment for covariates; absent without one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) adjusted: Option<ScoreAdjustmentDocument>,
    /// Members of the group.
    pub(crate) members: u32,
    /// Whether no reason was found to doubt the match; `null` for methods that do not judge.
    pub(crate) reliable: Option<bool>,
    /// The reasons to doubt it.
    pub(crate) reasons: Vec<String>,
    /// Mean distance of the subject's surface from the map, mm.
    pub(crate) residual_mm: f64,
    /// Squared Mahalanobis distance from the model of the group.
    pub(crate) mahalanobis_squared: f64,
    /// p-value of a shape as unusual, by the rank of its distance among those of left-out members.
    pub(crate) unusual_p: f64,
    /// Largest absolute score.
    pub(crate) largest_score: f64,
    /// p-value of a largest score as large, by its rank among those of left-out members.
    pub(crate) largest_score_p: f64,
    /// Bound of the screening: a member that was left out exceeds it anywhere with probability `level`.
    pub(crate) bound: ScoreBoundDocument,
    /// How far the scores of left-out members are standard normal.
    pub(crate) calibration: ScoreCalibrationDocument,
    /// Regions of vertices beyond the bound in one direction, the largest score first.
    pub(crate) regions: Vec<ScoreRegionDocument>,
    /// Score at each vertex of the template; positive where the subject lies further out than the mean of the group, or than the
    /// prediction at its covariates.
    pub(crate) scores: Vec<f64>,
    /// Deviation from this mean or prediction along the outward normal at each vertex, mm.
    pub(crate) deviation_mm: Vec<f64>,
}

/// An adjustment of a score for covariates.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, ToSchema)]
pub(crate) struct ScoreAdjustmentDocument {
    /// The value of each covariate for the subject, as text.
    pub(crate) covariates: BTreeMap<String, String>,
    /// Members that are left out because such a value is missing.
    pub(crate) incomplete: u32,
    /// Degrees of freedom of the residuals.
    pub(crate) degrees: f64,
    /// Leverage of the subject: 1/n in the middle of the group, and larger away from it.
    pub(crate) leverage: f64,
    /// Covariates of the subject that lie outside of the range of the group.
    pub(crate) warnings: Vec<String>,
}

/// A bound of the largest score.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, ToSchema)]
pub(crate) struct ScoreBoundDocument {
    /// The bound.
    pub(crate) score: f64,
    /// Probability of a larger score anywhere.
    pub(crate) level: f64,
    /// `rank`: a largest score of a left-out member; `fitted`: estimated from all of them, because the group is too small.
    pub(crate) origin: String,
}

/// Scores of members, each left out of its group.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, ToSchema)]
pub(crate) struct ScoreCalibrationDocument {
    /// Members.
    pub(crate) subjects: u32,
    /// Mean of their scores; 0 if calibrated.
    pub(crate) mean: f64,
    /// Root mean square of their scores; 1 if calibrated.
    pub(crate) rms: f64,
    /// Share of the area with an absolute score above 1.96; 0.05 if calibrated.
    pub(crate) beyond_1_96: f64,
    /// Share above 2.576; 0.01 if calibrated.
    pub(crate) beyond_2_576: f64,
}

/// A region of vertices beyond the bound.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, ToSchema)]
pub(crate) struct ScoreRegionDocument {
    /// Its vertices.
    pub(crate) vertices: u32,
    /// Its area on the mean of the group, mm².
    pub(crate) area_mm2: f64,
    /// The vertex of the largest absolute score.
    pub(crate) peak: u32,
    /// Its position in the subject's coordinates, mm.
    pub(crate) peak_mm: [f64; 3],
    /// The score there; positive outwards.
    pub(crate) score: f64,
    /// The deviation there along the outward normal, mm.
    pub(crate) deviation_mm: f64,
}
