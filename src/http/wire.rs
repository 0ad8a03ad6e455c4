//! The JSON forms that are answered.

use super::problem::{ProblemDocument, failure_document};
use crate::jobs::documents::{InputReport, MatchParameters, ResultDocument};
use crate::jobs::engine::MethodDescription;
use crate::jobs::{Job, JobInput, JobPage, JobState, NumberedPoint, Progress, TracePage};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// A job. Members without a value are absent.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct JobDocument {
    /// UUIDv7.
    pub id: String,
    /// Where it stands.
    pub state: JobState,
    /// Name of the method.
    pub method: String,
    /// Version of the program that accepted it.
    pub method_version: String,
    /// Effective parameters.
    #[schema(value_type = MatchParameters)]
    pub parameters: Value,
    /// The surface that moves.
    pub source: InputDocument,
    /// The surface that stays.
    pub target: InputDocument,
    /// Seed of everything drawn at random.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// Higher first.
    #[schema(minimum = -100, maximum = 100)]
    pub priority: i32,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name for it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub external_ref: Option<String>,
    /// Times a worker began it, not counting those that gave it back at a shutdown.
    pub attempt: u32,
    /// Lost workers after which it is dead.
    pub max_attempts: u32,
    /// How far the present attempt is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub progress: Option<Progress>,
    /// Remaining time, a guess.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub eta_ms: Option<u64>,
    /// 1 for the next to run; only while queued, and not in lists.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub queue_position: Option<u64>,
    /// Energy of the last trace point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_latest: Option<f64>,
    /// When it was accepted.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// When its present or last attempt began.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub started_at: Option<Timestamp>,
    /// When it reached its final state.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub finished_at: Option<Timestamp>,
    /// When it will be removed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub expires_at: Option<Timestamp>,
    /// When it is too late to begin.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub deadline_at: Option<Timestamp>,
    /// Whether its end was asked for.
    pub cancel_requested: bool,
    /// Whether it was answered from an equal job's result.
    pub cached: bool,
    /// Why it has no result.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ProblemDocument>,
    /// Where to go from here.
    pub links: JobLinks,
}

/// One of a job's inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct InputDocument {
    /// `blake3:` and 64 hexadecimal digits of the bytes as uploaded.
    pub hash: String,
    /// Their number.
    pub n_bytes: u64,
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs.
    #[schema(value_type = InputReport)]
    pub report: Value,
}

/// Paths of what belongs to a job.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct JobLinks {
    /// The job.
    #[serde(rename = "self")]
    pub job: String,
    /// Its energy trace.
    pub trace: String,
    /// Its result, once it has succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub result: Option<String>,
    /// Its dense correspondence, once it has succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correspondences: Option<String>,
    /// To ask for its end, while it has not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cancel: Option<String>,
}

/// A part of the list of jobs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct JobListDocument {
    /// The jobs.
    pub jobs: Vec<JobDocument>,
    /// Hand this back as `page_token` for the next page; absent on the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_page_token: Option<String>,
}

/// A part of a trace.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct TraceDocument {
    /// Points in ascending order of `seq`, each once.
    pub points: Vec<NumberedPoint>,
    /// Hand this back as `after_seq`.
    pub next_after_seq: u64,
    /// Whether the job is finished and no point follows.
    pub complete: bool,
}

/// The result of a job: the result document and where its parts are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct JobResultDocument {
    /// The result.
    #[serde(flatten)]
    pub document: ResultDocument,
    /// Its parts.
    pub links: ResultLinks,
}

/// Paths of the parts of a result.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct ResultLinks {
    /// The job.
    pub job: String,
    /// The rigid transform: JSON, text, ITK or FreeSurfer.
    pub transform: String,
    /// The source surface whose vertices the correspondences count: PLY, VTK, GIFTI or STL.
    pub source_surface: String,
    /// The target surface whose vertices the correspondences count, likewise.
    pub target_surface: String,
    /// The dense correspondence: JSON, CSV, NumPy or Arrow, or PLY, VTK or GIFTI with arrays for the source's vertices.
    pub correspondences: String,
    /// The energy trace.
    pub trace: String,
    /// The source surface moved onto the target: PLY, VTK, GIFTI or STL.
    pub aligned: String,
}

/// The methods there are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MethodListDocument {
    /// The methods, the default first.
    pub methods: Vec<MethodDescription>,
}

/// Whether the service can do its work.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct ReadinessDocument {
    /// `ready` or `not_ready`.
    pub status: String,
    /// `ok` or `failing` for each dependency.
    pub dependencies: BTreeMap<String, String>,
}

/// That the process lives.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct HealthDocument {
    /// `alive`.
    pub status: String,
    /// Version of homolog.
    pub version: String,
}

/// A type of problem.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct ProblemTypeDocument {
    /// URI reference.
    pub r#type: String,
    /// HTTP status.
    pub status: u16,
    /// What it means.
    pub title: String,
    /// What the client can do.
    pub advice: String,
}

/// The form of a submission.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub struct SubmissionForm {
    /// The surface that moves: NIfTI-1 label volume, PLY, STL or legacy VTK.
    #[schema(format = Binary)]
    source: String,
    /// The surface that stays.
    #[schema(format = Binary)]
    target: String,
    /// What differs from the preset that `method` names; `{}` or absent for the default.
    #[schema(value_type = Option<Object>)]
    parameters: Option<Value>,
    /// The submitter's own marks: a JSON object of strings.
    labels: Option<BTreeMap<String, String>>,
    /// The submitter's own name for the job.
    #[schema(max_length = 200)]
    external_ref: Option<String>,
    /// Higher first.
    #[schema(minimum = -100, maximum = 100, default = 0)]
    priority: Option<i32>,
}

impl From<&Job> for JobDocument {
    fn from(job: &Job) -> Self {
        let path = format!("/v1/jobs/{}", job.id);
        let succeeded = job.state == JobState::Succeeded;
        let links = JobLinks {
            trace: format!("{path}/trace"),
            result: succeeded.then(|| format!("{path}/result")),
            correspondences: succeeded.then(|| format!("{path}/correspondences")),
            cancel: (!job.state.is_final()).then(|| format!("{path}/cancel")),
            job: path,
        };
        let mut progress = job.progress.clone();
        if let Some(progress) = progress.as_mut().filter(|_| succeeded) {
            progress.fraction = 1.0;
        }
        JobDocument {
            id: job.id.to_string(),
            state: job.state,
            method: job.method.clone(),
            method_version: job.method_version.clone(),
            parameters: job.parameters.clone(),
            source: (&job.source).into(),
            target: (&job.target).into(),
            seed: job.parameters.get("seed").and_then(Value::as_u64),
            priority: job.priority,
            labels: job.labels.clone(),
            external_ref: job.external_ref.clone(),
            attempt: job.attempt,
            max_attempts: job.max_attempts,
            eta_ms: job.eta_ms(),
            queue_position: job.queue_position,
            energy_latest: progress.as_ref().and_then(|p| p.energy_latest),
            progress,
            created_at: job.created_at,
            started_at: job.started_at,
            finished_at: job.finished_at,
            expires_at: job.expires_at,
            deadline_at: job.deadline_at,
            cancel_requested: job.cancel_requested,
            cached: false,
            error: job.error.as_ref().map(failure_document),
            links,
        }
    }
}

impl From<&JobInput> for InputDocument {
    fn from(input: &JobInput) -> Self {
        InputDocument {
            hash: format!("blake3:{}", input.hash),
            n_bytes: input.n_bytes,
            n_vertices: input.n_vertices,
            n_faces: input.n_faces,
            report: input.report.clone(),
        }
    }
}

impl From<&JobPage> for JobListDocument {
    fn from(page: &JobPage) -> Self {
        JobListDocument {
            jobs: page.jobs.iter().map(JobDocument::from).collect(),
            next_page_token: page.next.map(|cursor| cursor.to_token()),
        }
    }
}

impl From<TracePage> for TraceDocument {
    fn from(page: TracePage) -> Self {
        TraceDocument { points: page.points, next_after_seq: page.next_after_seq, complete: page.complete }
    }
}

impl ResultLinks {
    /// The links of a job's result.
    pub fn of(id: crate::jobs::JobId) -> Self {
        let path = format!("/v1/jobs/{id}");
        ResultLinks {
            transform: format!("{path}/transform"),
            source_surface: format!("{path}/surfaces/source"),
            target_surface: format!("{path}/surfaces/target"),
            correspondences: format!("{path}/correspondences"),
            trace: format!("{path}/trace"),
            aligned: format!("{path}/aligned"),
            job: path,
        }
    }
}
