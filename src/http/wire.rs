//! JSON documents of the answers.

use super::problem::{ProblemDocument, failure_document};
use crate::jobs::InputRefusal;
use crate::jobs::documents::{InputReport, MatchParameters, ResultDocument, SurfaceDistanceDocument, UnreliableReason};
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

/// A job. Members without a value are omitted, except `reliable`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct JobDocument {
    /// Tells a job from the outcome of `validate_only`.
    pub(crate) kind: JobKind,
    /// UUIDv7.
    pub(crate) id: String,
    /// State of the job.
    pub(crate) state: JobState,
    /// Name of the method.
    pub(crate) method: String,
    /// Version of the program that accepted the job.
    pub(crate) method_version: String,
    /// All parameters, with defaults filled in; only if `fields` names them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<MatchParameters>)]
    pub(crate) parameters: Option<Value>,
    /// The surface that is moved onto the target.
    pub(crate) source: InputDocument,
    /// The surface that stays in place.
    pub(crate) target: InputDocument,
    /// Seed of the random numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) seed: Option<u64>,
    /// Jobs with a higher priority run first.
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: i32,
    /// Tags of the client's choice.
    pub(crate) tags: BTreeMap<String, String>,
    /// The former name of `tags`, until 0.3.
    #[schema(deprecated)]
    pub(crate) labels: BTreeMap<String, String>,
    /// The client's own id.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) external_ref: Option<String>,
    /// How often a worker has started it, not counting workers that returned it at a shutdown.
    pub(crate) attempt: u32,
    /// Crashes of its workers after which it is `dead`.
    pub(crate) max_attempts: u32,
    /// Progress of the current attempt.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) progress: Option<Progress>,
    /// Estimated remaining time of the computation, ms, without the time in the queue. Of a job that waits or has just begun, a prediction
    /// from its parameters and the sizes of its surfaces, mostly within a factor of 4 and not in lists; from 5 % of progress on, extrapolated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) eta_ms: Option<u64>,
    /// Position among the tenant's queued jobs, 1 for its next one; only while queued, and not in lists. Tenants take turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) queue_position: Option<u64>,
    /// Energy of the answer (`energy.final` of the result) once there is one; until then, and for an answer without an energy, that of the
    /// last trace point, whose `quantity` says what it measures.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) energy_latest: Option<f64>,
    /// When it was accepted.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// When its current or last attempt started.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) started_at: Option<Timestamp>,
    /// When it finished, in whichever state.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) finished_at: Option<Timestamp>,
    /// When it will be deleted.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) expires_at: Option<Timestamp>,
    /// It expires if it has not started by this time.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) deadline_at: Option<Timestamp>,
    /// Longest run time that the client allows, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) max_run_s: Option<u64>,
    /// The job of which this one is a retry.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) retry_of: Option<String>,
    /// The batch that it belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) batch_id: Option<String>,
    /// The study that it is part of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) study_id: Option<String>,
    /// Whether it was cancelled, also while its worker has not stopped yet.
    pub(crate) cancel_requested: bool,
    /// The process that runs it, only while it runs: a random name, another one after each start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) worker: Option<String>,
    /// Whether it has the result of an earlier, equal job.
    pub(crate) cached: bool,
    /// Whether its answer can be relied on. `null` until it has succeeded, where no displacement field could be fitted
    /// to say so, and for jobs that ended before verdicts were stored.
    #[schema(required = true)]
    pub(crate) reliable: Option<bool>,
    /// Why its answer cannot be relied on; the result has more.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) unreliable_reasons: Option<Vec<UnreliableReason>>,
    /// What was found in its inputs and done to them that bears on the answer, a sentence each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) warnings: Vec<String>,
    /// Symmetric distance between the registered surfaces.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) surface_distance: Option<SurfaceDistanceDocument>,
    /// Why it finished without a result.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<ProblemDocument>,
    /// Paths of related resources.
    pub(crate) links: JobLinks,
}

/// What a job has for `kind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum JobKind {
    /// A job.
    Job,
}

/// What the outcome of `validate_only` has for `kind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum ValidationKind {
    /// The outcome of the checks of a submission.
    Validation,
}

/// An input of a job.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct InputDocument {
    /// Hash of the uploaded bytes: `blake3:` and 64 hexadecimal digits.
    pub(crate) hash: String,
    /// Size of the upload, bytes.
    pub(crate) n_bytes: u64,
    /// Vertices of the surface that is matched.
    pub(crate) n_vertices: u32,
    /// Its faces.
    pub(crate) n_faces: u32,
    /// Format, topology and repairs.
    #[schema(value_type = InputReport)]
    pub(crate) report: Value,
}

/// Paths of the resources of a job.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct JobLinks {
    /// The job.
    #[serde(rename = "self")]
    pub(crate) job: String,
    /// Its energy trace.
    pub(crate) trace: String,
    /// Its events as they happen (server-sent events).
    pub(crate) events: String,
    /// Its result, if it has succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) result: Option<String>,
    /// Its dense correspondence, if it has succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) correspondences: Option<String>,
    /// Its rigid transform, if it has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) transform: Option<String>,
    /// Its matched source surface, if it has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) source_surface: Option<String>,
    /// Its matched target surface, if it has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) target_surface: Option<String>,
    /// The source moved rigidly onto the target, if it has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) aligned: Option<String>,
    /// The source deformed onto the target, if it has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) warped: Option<String>,
    /// A page about its result, for browsers, if it has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) report: Option<String>,
    /// The batch that it belongs to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) batch: Option<String>,
    /// The study that it is part of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) study: Option<String>,
    /// The score of a new subject against this study, if it scores one and has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) score: Option<String>,
    /// The job of which it is a retry.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) retry_of: Option<String>,
    /// Cancels it, until it is finished.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) cancel: Option<String>,
    /// Retries it, once it is finished.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) retry: Option<String>,
}

/// A page of the list of jobs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct JobListDocument {
    /// The jobs.
    pub(crate) jobs: Vec<JobDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// A page of an energy trace.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct TraceDocument {
    /// Points in ascending order of `seq`.
    pub(crate) points: Vec<NumberedPoint>,
    /// `after_seq` of the next page.
    pub(crate) next_after_seq: u64,
    /// Whether the job is finished and this is its last page.
    pub(crate) complete: bool,
}

/// The result of a job, with the paths of its parts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct JobResultDocument {
    /// The result.
    #[serde(flatten)]
    pub(crate) document: ResultDocument,
    /// Paths of its parts.
    pub(crate) links: ResultLinks,
}

/// Paths of the parts of a result, with their formats.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ResultLinks {
    /// The job.
    pub(crate) job: String,
    /// The rigid transform: JSON, text, ITK or FreeSurfer.
    pub(crate) transform: String,
    /// The matched source surface, whose vertices the correspondences refer to: PLY, VTK, GIFTI or STL.
    pub(crate) source_surface: String,
    /// The matched target surface, in the same formats.
    pub(crate) target_surface: String,
    /// The dense correspondence: JSON, CSV, NumPy or Arrow; or the source surface with arrays: PLY, VTK, VTP or GIFTI.
    pub(crate) correspondences: String,
    /// The energy trace.
    pub(crate) trace: String,
    /// The source surface moved rigidly onto the target: PLY, VTK, VTP, GIFTI or STL.
    pub(crate) aligned: String,
    /// The source surface deformed onto the target, with the deformation at each vertex; also as a table.
    pub(crate) warped: String,
    /// A page with the verdict, both surfaces and all numbers, for browsers.
    pub(crate) report: String,
}

/// Readiness of the service.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ReadinessDocument {
    /// `ready` or `not_ready`.
    pub(crate) status: String,
    /// `ok`, `full` or `failing` for each dependency; `ok` or `jumped` for the `clock`.
    pub(crate) dependencies: BTreeMap<String, String>,
}

/// Liveness of the process.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct HealthDocument {
    /// `alive`.
    pub(crate) status: String,
    /// Version of homolog.
    pub(crate) version: String,
}

/// A problem type.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ProblemTypeDocument {
    /// URI reference.
    pub(crate) r#type: String,
    /// HTTP status.
    pub(crate) status: u16,
    /// Meaning.
    pub(crate) title: String,
    /// What the client can do.
    pub(crate) advice: String,
}

/// Outcome of the checks of a submission with `validate_only`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ValidationDocument {
    /// Tells the outcome of `validate_only` from a job.
    pub(crate) kind: ValidationKind,
    /// Always true: an invalid submission is answered with a problem.
    pub(crate) valid: bool,
    /// Name of the method.
    pub(crate) method: String,
    /// Version of the program.
    pub(crate) method_version: String,
    /// All parameters, with defaults filled in.
    #[schema(value_type = MatchParameters)]
    pub(crate) parameters: Value,
    /// The surface that is moved onto the target.
    pub(crate) source: ValidatedInputDocument,
    /// The surface that stays in place.
    pub(crate) target: ValidatedInputDocument,
}

/// An answer of 200 to a submission: the job, if it finished within the wait, or the outcome of `validate_only`; `kind` says which.
#[derive(Debug, Clone, ToSchema)]
#[serde(untagged)]
#[schema(discriminator(property_name = "kind", mapping(
    ("job" = "#/components/schemas/JobDocument"),
    ("validation" = "#/components/schemas/ValidationDocument"),
)))]
#[allow(dead_code, reason = "describes answers, each of which is made by itself")]
pub(crate) enum SubmissionAnswer {
    Finished(Box<JobDocument>),
    Tried(Box<ValidationDocument>),
}

/// A checked input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ValidatedInputDocument {
    /// Vertices of the surface that is matched.
    pub(crate) n_vertices: u32,
    /// Its faces.
    pub(crate) n_faces: u32,
    /// Format, topology and repairs.
    #[schema(value_type = InputReport)]
    pub(crate) report: Value,
}

/// Outcome of the cancellation of several jobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct BulkCancelDocument {
    /// Queued jobs, which are cancelled now.
    pub(crate) cancelled: u32,
    /// Running jobs, which their workers will stop.
    pub(crate) told: u32,
}

/// An upload.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct MeshDocument {
    /// Hash of the bytes: `blake3:` and 64 hexadecimal digits.
    pub(crate) id: String,
    /// Size, bytes.
    pub(crate) n_bytes: u64,
    /// When it was first uploaded.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// Whether it can be matched with default parameters; absent if it was not inspected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) suitable: Option<bool>,
    /// Vertices of the surface that a job would match.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) n_vertices: Option<u32>,
    /// Its faces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) n_faces: Option<u32>,
    /// Format, topology and repairs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<InputReport>)]
    pub(crate) report: Option<Value>,
    /// Why it cannot be matched with default parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) problem: Option<ProblemDocument>,
    /// Paths of related resources.
    pub(crate) links: MeshLinks,
}

/// Paths of the resources of an upload.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct MeshLinks {
    /// The upload.
    #[serde(rename = "self")]
    pub(crate) mesh: String,
    /// Its bytes.
    pub(crate) content: String,
}

/// A page of the list of uploads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct MeshListDocument {
    /// The uploads, newest first.
    pub(crate) meshes: Vec<MeshDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// A batch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct BatchDocument {
    /// UUIDv7.
    pub(crate) id: String,
    /// Number of jobs that it was created with.
    pub(crate) n_jobs: u32,
    /// Number of its jobs in each state; deleted jobs are not counted.
    pub(crate) counts: BTreeMap<JobState, u32>,
    /// Whether none of its jobs is queued or running.
    pub(crate) finished: bool,
    /// Tags of the client's choice.
    pub(crate) tags: BTreeMap<String, String>,
    /// The former name of `tags`, until 0.3.
    #[schema(deprecated)]
    pub(crate) labels: BTreeMap<String, String>,
    /// The client's own id.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) external_ref: Option<String>,
    /// When it was accepted.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// Paths of related resources.
    pub(crate) links: BatchLinks,
}

/// Paths of the resources of a batch.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct BatchLinks {
    /// The batch.
    #[serde(rename = "self")]
    pub(crate) batch: String,
    /// Its jobs.
    pub(crate) jobs: String,
    /// Cancels it, until it is finished.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) cancel: Option<String>,
}

/// A page of the list of batches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct BatchListDocument {
    /// The batches, newest first.
    pub(crate) batches: Vec<BatchDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// A page of the feed of state changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ChangesDocument {
    /// Changes in ascending order of `seq`.
    pub(crate) changes: Vec<ChangeDocument>,
    /// `since` of the next page.
    pub(crate) next_since: u64,
    /// Whether there are more changes.
    pub(crate) more: bool,
    /// `page_token` of the next page; absent if there are no more changes now.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// A change of the state of a job.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct ChangeDocument {
    /// Its number; changes that appear later have larger numbers.
    pub(crate) seq: u64,
    /// The job.
    pub(crate) job_id: String,
    /// The batch it belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) batch_id: Option<String>,
    /// The new state.
    pub(crate) state: JobState,
    /// Time of the change.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) at: Timestamp,
}

impl From<&Job> for JobDocument {
    fn from(job: &Job) -> Self {
        let succeeded = job.state == JobState::Succeeded && job.purged_at.is_none();
        let mut progress = job.progress.clone();
        if let Some(progress) = progress.as_mut().filter(|_| succeeded) {
            progress.fraction = 1.0;
        }
        JobDocument {
            kind: JobKind::Job,
            id: job.id.to_string(),
            state: job.state,
            method: job.method.clone(),
            method_version: job.method_version.clone(),
            parameters: None,
            source: (&job.source).into(),
            target: (&job.target).into(),
            seed: job.parameters.get("seed").and_then(Value::as_u64),
            priority: job.priority,
            tags: job.tags.clone(),
            labels: job.tags.clone(),
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
            study_id: job.study_id.map(|id| id.to_string()),
            cancel_requested: job.cancel_requested,
            worker: job.worker.clone(),
            cached: job.cached,
            reliable: job.verdict.as_ref().and_then(|verdict| verdict.reliable),
            unreliable_reasons: job.verdict.as_ref().map(|verdict| verdict.reasons.clone()),
            warnings: job.verdict.as_ref().map(|verdict| verdict.warnings.clone()).unwrap_or_default(),
            surface_distance: job.verdict.as_ref().map(|verdict| verdict.surface_distance.clone()),
            error: job.error.as_ref().map(failure_document),
            links: JobLinks::of(job),
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
            kind: ValidationKind::Validation,
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
            tags: batch.tags.clone(),
            labels: batch.tags.clone(),
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
    /// An upload with the outcome of its check.
    pub(crate) fn of(mesh: &Mesh, check: Option<CheckOutcome>) -> Self {
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
                let InputRefusal { code, detail, topology, place_mm } = refusal;
                let failure = Failure { code, detail, input: None, topology, place_mm: place_mm.map(Box::new) };
                document.problem = Some(failure_document(&failure));
            }
        }
        document
    }
}

impl From<&Change> for ChangeDocument {
    fn from(change: &Change) -> Self {
        ChangeDocument {
            seq: change.seq,
            job_id: change.job_id.to_string(),
            batch_id: change.batch_id.map(|id| id.to_string()),
            state: change.state,
            at: change.at,
        }
    }
}

impl From<&ChangePage> for ChangesDocument {
    fn from(page: &ChangePage) -> Self {
        ChangesDocument {
            changes: page.changes.iter().map(ChangeDocument::from).collect(),
            next_since: page.next_since,
            more: page.more,
            next_page_token: page.more.then(|| page.next_since.to_string()),
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

impl JobDocument {
    /// A job with its parameters, if they are asked for.
    pub(crate) fn of(job: &Job, with_parameters: bool) -> Self {
        JobDocument { parameters: with_parameters.then(|| job.parameters.clone()), ..JobDocument::from(job) }
    }
}

impl JobListDocument {
    /// A page of jobs, with their parameters if they are asked for.
    pub(crate) fn of(page: &JobPage, with_parameters: bool) -> Self {
        JobListDocument {
            jobs: page.jobs.iter().map(|job| JobDocument::of(job, with_parameters)).collect(),
            next_page_token: page.next.map(|cursor| cursor.to_token()),
        }
    }
}

impl From<TracePage> for TraceDocument {
    fn from(page: TracePage) -> Self {
        TraceDocument { points: page.points, next_after_seq: page.next_after_seq, complete: page.complete }
    }
}
