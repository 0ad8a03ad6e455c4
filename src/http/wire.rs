//! The JSON forms that are answered.

use super::problem::{ProblemDocument, failure_document};
use crate::jobs::documents::{InputReport, MatchParameters, ResultDocument};
use crate::jobs::engine::MethodDescription;
use crate::jobs::mesh::content_id;
use crate::jobs::{
    Batch, Change, ChangePage, CheckOutcome, Failure, InputSummary, Job, JobInput, JobPage, JobState, Mesh,
    NumberedPoint, Progress, TracePage, Validated,
};
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
    /// Longest run that its submitter allows, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_run_s: Option<u64>,
    /// The job that this one tries again.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub retry_of: Option<String>,
    /// The batch that it belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub batch_id: Option<String>,
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
    /// Its events as they happen (server-sent events).
    pub events: String,
    /// Its result, once it has succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub result: Option<String>,
    /// Its dense correspondence, once it has succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correspondences: Option<String>,
    /// To ask for its end, while it has not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cancel: Option<String>,
    /// To try it again, once it is finished.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub retry: Option<String>,
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

/// What a submission that is only tried would do.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ValidationDocument {
    /// Always true: what is wrong is answered as a problem.
    pub valid: bool,
    /// Name of the method.
    pub method: String,
    /// Version of the program that would run it.
    pub method_version: String,
    /// Effective parameters.
    #[schema(value_type = MatchParameters)]
    pub parameters: Value,
    /// The surface that moves.
    pub source: ValidatedInputDocument,
    /// The surface that stays.
    pub target: ValidatedInputDocument,
}

/// What a submission is answered with 200.
#[derive(Debug, Clone, ToSchema)]
#[serde(untagged)]
#[allow(dead_code, reason = "describes answers, each of which is made by itself")]
pub enum SubmissionAnswer {
    /// The job, finished within the wait.
    Finished(Box<JobDocument>),
    /// With `validate_only`.
    Tried(Box<ValidationDocument>),
}

/// An input that was checked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ValidatedInputDocument {
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs.
    #[schema(value_type = InputReport)]
    pub report: Value,
}

/// What a cancellation of many jobs did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct BulkCancelDocument {
    /// Jobs that were cancelled at once.
    pub cancelled: u32,
    /// Running jobs whose workers were told.
    pub told: u32,
}

/// An upload.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MeshDocument {
    /// `blake3:` and 64 hexadecimal digits of the bytes.
    pub id: String,
    /// Their number.
    pub n_bytes: u64,
    /// When it was first uploaded.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// Whether it can be matched with default parameters; absent where it was not inspected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub suitable: Option<bool>,
    /// Vertices of the surface that would be matched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n_vertices: Option<u32>,
    /// Its faces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n_faces: Option<u32>,
    /// Format, topology and repairs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<InputReport>)]
    pub report: Option<Value>,
    /// Why it cannot be matched with default parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<ProblemDocument>,
    /// Where its bytes are.
    pub links: MeshLinks,
}

/// Paths of what belongs to an upload.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct MeshLinks {
    /// The upload.
    #[serde(rename = "self")]
    pub mesh: String,
    /// Its bytes.
    pub content: String,
}

/// A part of the list of uploads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MeshListDocument {
    /// The uploads, the newest first.
    pub meshes: Vec<MeshDocument>,
    /// Hand this back as `page_token` for the next page; absent on the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_page_token: Option<String>,
}

/// A batch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct BatchDocument {
    /// UUIDv7.
    pub id: String,
    /// Jobs it was made with.
    pub n_jobs: u32,
    /// How many of its jobs are in each state.
    pub counts: BTreeMap<JobState, u32>,
    /// Whether no job of it waits or runs.
    pub finished: bool,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name for it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub external_ref: Option<String>,
    /// When it was accepted.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// Where to go from here.
    pub links: BatchLinks,
}

/// Paths of what belongs to a batch.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct BatchLinks {
    /// The batch.
    #[serde(rename = "self")]
    pub batch: String,
    /// Its jobs.
    pub jobs: String,
    /// To ask for its end, while it has not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cancel: Option<String>,
}

/// A part of the list of batches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct BatchListDocument {
    /// The batches, the newest first.
    pub batches: Vec<BatchDocument>,
    /// Hand this back as `page_token` for the next page; absent on the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_page_token: Option<String>,
}

/// A part of the feed of state changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ChangesDocument {
    /// Changes in ascending order of `seq`.
    pub changes: Vec<ChangeDocument>,
    /// Hand this back as `since`.
    pub next_since: u64,
    /// Whether more wait.
    pub more: bool,
}

/// A job's change of state.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ChangeDocument {
    /// Its number: none that appears later is smaller.
    pub seq: u64,
    /// The job.
    pub job_id: String,
    /// The batch it belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub batch_id: Option<String>,
    /// The state it came to.
    pub state: JobState,
    /// When.
    #[schema(value_type = String, format = DateTime)]
    pub at: Timestamp,
}

impl From<&Job> for JobDocument {
    fn from(job: &Job) -> Self {
        let path = format!("/v1/jobs/{}", job.id);
        let succeeded = job.state == JobState::Succeeded && job.purged_at.is_none();
        let links = JobLinks {
            trace: format!("{path}/trace"),
            events: format!("{path}/events"),
            result: succeeded.then(|| format!("{path}/result")),
            correspondences: succeeded.then(|| format!("{path}/correspondences")),
            cancel: (!job.state.is_final()).then(|| format!("{path}/cancel")),
            retry: (job.state.is_final() && job.purged_at.is_none()).then(|| format!("{path}/retry")),
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
            max_run_s: job.max_run_ms.map(|ms| ms / 1000),
            retry_of: job.retry_of.map(|id| id.to_string()),
            batch_id: job.batch_id.map(|id| id.to_string()),
            cancel_requested: job.cancel_requested,
            cached: job.cached,
            error: job.error.as_ref().map(failure_document),
            links,
        }
    }
}

impl From<Box<Validated>> for ValidationDocument {
    fn from(validated: Box<Validated>) -> Self {
        let input = |input: InputSummary| ValidatedInputDocument {
            n_vertices: input.n_vertices,
            n_faces: input.n_faces,
            report: input.report,
        };
        let Validated { resolved, source, target } = *validated;
        ValidationDocument {
            valid: true,
            method: resolved.method,
            method_version: resolved.method_version,
            parameters: resolved.parameters,
            source: input(source),
            target: input(target),
        }
    }
}

impl From<&Batch> for BatchDocument {
    fn from(batch: &Batch) -> Self {
        let path = format!("/v1/batches/{}", batch.id);
        BatchDocument {
            id: batch.id.to_string(),
            n_jobs: batch.n_jobs,
            counts: batch.counts.clone(),
            finished: batch.is_finished(),
            labels: batch.labels.clone(),
            external_ref: batch.external_ref.clone(),
            created_at: batch.created_at,
            links: BatchLinks {
                jobs: format!("{path}/jobs"),
                cancel: (!batch.is_finished()).then(|| format!("{path}/cancel")),
                batch: path,
            },
        }
    }
}

impl MeshDocument {
    /// An upload with what checking it found.
    pub fn of(mesh: &Mesh, check: Option<CheckOutcome>) -> Self {
        let id = content_id(mesh.key.hash());
        let path = format!("/v1/meshes/{id}");
        let mut document = MeshDocument {
            id,
            n_bytes: mesh.n_bytes,
            created_at: mesh.created_at,
            suitable: None,
            n_vertices: None,
            n_faces: None,
            report: None,
            problem: None,
            links: MeshLinks { content: format!("{path}/content"), mesh: path },
        };
        match check {
            None => {}
            Some(CheckOutcome::Fit(summary)) => {
                document.suitable = Some(true);
                document.n_vertices = Some(summary.n_vertices);
                document.n_faces = Some(summary.n_faces);
                document.report = Some(summary.report);
            }
            Some(CheckOutcome::Unfit(refusal)) => {
                document.suitable = Some(false);
                let failure =
                    Failure { code: refusal.code, detail: refusal.detail, input: None, topology: refusal.topology };
                document.problem = Some(failure_document(&failure));
            }
        }
        document
    }
}

impl From<&ChangePage> for ChangesDocument {
    fn from(page: &ChangePage) -> Self {
        let change = |change: &Change| ChangeDocument {
            seq: change.seq,
            job_id: change.job_id.to_string(),
            batch_id: change.batch_id.map(|id| id.to_string()),
            state: change.state,
            at: change.at,
        };
        ChangesDocument {
            changes: page.changes.iter().map(change).collect(),
            next_since: page.next_since,
            more: page.more,
        }
    }
}

impl From<&JobInput> for InputDocument {
    fn from(input: &JobInput) -> Self {
        InputDocument {
            hash: content_id(&input.hash),
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
