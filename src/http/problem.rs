//! Error answers as problem documents (RFC 9457), and how errors of the use cases map to them.

use super::problem_table::ProblemKind;
use super::request_id::request_id;
use crate::jobs::{Failure, JobError, PresentError, StudyState, SubmitError};
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// The media type of every error.
pub(crate) const PROBLEM_JSON: &str = "application/problem+json";

/// An error answer.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Problem {
    kind: ProblemKind,
    detail: Option<String>,
    retry_after_s: Option<u32>,
    members: Map<String, Value>,
}

/// A fault in one field of a request.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
pub(crate) struct FieldError {
    /// JSON pointer into the form (`/parameters/energy/alpha`, `/source`), or `/query/<name>`, or `/headers/<name>`.
    pub(crate) pointer: String,
    /// Stable name of the kind of fault.
    pub(crate) code: String,
    /// What is allowed, or what is wrong.
    pub(crate) detail: String,
}

impl FieldError {
    /// A fault.
    pub(crate) fn new(pointer: impl Into<String>, code: &str, detail: impl Into<String>) -> Self {
        FieldError { pointer: pointer.into(), code: code.to_owned(), detail: detail.into() }
    }
}

/// A problem. Further members depend on the type.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub(crate) struct ProblemDocument {
    /// Stable URI reference, `/problems/<slug>`.
    pub(crate) r#type: String,
    /// The same for every problem of this type.
    pub(crate) title: String,
    /// HTTP status.
    pub(crate) status: u16,
    /// What is specific to this occurrence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) detail: Option<String>,
    /// Id of the request, as in the log of the service; absent in the `error` of a job.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) request_id: Option<String>,
    /// The faults, each with the field that it is in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) errors: Option<Vec<FieldError>>,
    /// `source` or `target`, if the problem is with one of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) input: Option<String>,
    /// Topology of the rejected surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<crate::jobs::documents::TopologyReport>)]
    pub(crate) topology: Option<Value>,
    /// Where the first fault of the rejected surface is, mm: x, y and z in its coordinates; absent if it is at no one place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) place_mm: Option<[f64; 3]>,
    /// State of the job, if that is the problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) state: Option<crate::jobs::JobState>,
}

impl Problem {
    /// A problem of this kind.
    pub(crate) fn new(kind: ProblemKind) -> Self {
        Problem { kind, detail: None, retry_after_s: None, members: Map::new() }
    }

    /// The kind of the problem.
    pub(super) fn kind(&self) -> ProblemKind {
        self.kind
    }

    /// Adds what is specific to this occurrence.
    #[must_use]
    pub(crate) fn detail(mut self, detail: impl Into<String>) -> Self {
        self.detail = Some(detail.into());
        self
    }

    /// Adds faults in fields.
    #[must_use]
    pub(crate) fn errors(self, errors: &[FieldError]) -> Self {
        self.member("errors", json!(errors))
    }

    /// Adds `Retry-After`, s.
    #[must_use]
    pub(crate) fn retry_after(mut self, seconds: u32) -> Self {
        self.retry_after_s = Some(seconds);
        self
    }

    /// Adds a member.
    #[must_use]
    pub(crate) fn member(mut self, name: &str, value: Value) -> Self {
        self.members.insert(name.to_owned(), value);
        self
    }

    /// An internal error: the cause is logged and not part of the answer.
    pub(crate) fn internal(cause: &dyn std::error::Error) -> Self {
        tracing::error!(request_id = request_id(), cause = %chain(cause), "a request failed");
        Problem::new(ProblemKind::InternalError)
    }

    fn unavailable(cause: &dyn std::error::Error) -> Self {
        tracing::error!(request_id = request_id(), cause = %chain(cause), "a dependency does not answer");
        Problem::new(ProblemKind::Unavailable).retry_after(2)
    }
}

/// An error with its causes, for the log.
fn chain(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut cause = error.source();
    while let Some(source) = cause {
        text = format!("{text}: {source}");
        cause = source.source();
    }
    text
}

/// Begins to count problems of every type: an increase is visible only in a series that already exists.
pub(super) fn begin_to_count() {
    for kind in ProblemKind::ALL {
        metrics::counter!("homolog_problems_total", "type" => kind.entry().slug).increment(0);
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let entry = self.kind.entry();
        metrics::counter!("homolog_problems_total", "type" => entry.slug).increment(1);
        let mut body = Map::new();
        body.insert("type".to_owned(), format!("/problems/{}", entry.slug).into());
        body.insert("title".to_owned(), entry.title.into());
        body.insert("status".to_owned(), entry.status.as_u16().into());
        if let Some(detail) = self.detail {
            body.insert("detail".to_owned(), detail.into());
        }
        if let Some(id) = request_id() {
            body.insert("request_id".to_owned(), id.into());
        }
        body.extend(self.members);
        let mut response = (entry.status, Value::Object(body).to_string()).into_response();
        response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(PROBLEM_JSON));
        if entry.status == StatusCode::UNAUTHORIZED {
            response.headers_mut().insert(header::WWW_AUTHENTICATE, HeaderValue::from_static("Bearer"));
        }
        if let Some(seconds) = self.retry_after_s {
            response.headers_mut().insert(header::RETRY_AFTER, seconds.into());
        }
        response
    }
}

fn of_study(kind: ProblemKind, state: StudyState) -> Problem {
    // Not the member `state`, which is the state of a job.
    Problem::new(kind).detail(format!("the study is {}", state.name())).member("study_state", state.name().into())
}

impl From<JobError> for Problem {
    fn from(error: JobError) -> Self {
        let with_state = |kind, state: crate::jobs::JobState| {
            Problem::new(kind).detail(format!("the job is {}", state.name())).member("state", state.name().into())
        };
        match error {
            JobError::NotFound => Problem::new(ProblemKind::JobNotFound),
            JobError::NotPresented(PresentError::NoInverse) => Problem::new(ProblemKind::RouteNotFound)
                .detail("the job has no inverse correspondences; submit it with both_directions set to true"),
            JobError::NotPresented(PresentError::NotDicom) => Problem::new(ProblemKind::NotAcceptable)
                .detail("neither input of the job is a DICOM object, so there is no study; name one with study_uid, or ask for another format"),
            JobError::NotPresented(PresentError::NoSegmentation) => Problem::new(ProblemKind::NotAcceptable).detail(
                "the surface is open, or would take more than a billion voxels on the grid of the input, so it has no \
                 segmentation; ask for a surface, such as ply",
            ),
            JobError::MeshNotFound => Problem::new(ProblemKind::MeshNotFound),
            JobError::BatchNotFound => Problem::new(ProblemKind::BatchNotFound),
            JobError::WebhookNotFound => Problem::new(ProblemKind::WebhookNotFound),
            JobError::KeyNotFound => Problem::new(ProblemKind::KeyNotFound),
            JobError::StudyNotFound => Problem::new(ProblemKind::StudyNotFound),
            JobError::SubjectNotFound => Problem::new(ProblemKind::SubjectNotFound),
            JobError::StudyActive { state } => of_study(ProblemKind::StudyActive, state),
            JobError::StudyFinal { state } => of_study(ProblemKind::StudyFinished, state),
            JobError::StudyNotReady { state } => of_study(ProblemKind::StudyNotReady, state).retry_after(1),
            JobError::StudyBusy => Problem::new(ProblemKind::Busy).retry_after(1),
            JobError::MeshInUse => Problem::new(ProblemKind::MeshInUse),
            JobError::Gone => Problem::new(ProblemKind::Expired),
            JobError::BeingRemoved => Problem::new(ProblemKind::Unavailable).retry_after(2),
            JobError::QueueFull { limit } => {
                let detail = format!("{limit} jobs are queued, as many as a tenant may have");
                Problem::new(ProblemKind::QueueFull).detail(detail).member("limit", limit.into()).retry_after(10)
            }
            JobError::ShareFull { stored, limit } => Problem::new(ProblemKind::StorageShareFull)
                .detail(format!("{stored} of {limit} bytes are stored"))
                .member("stored_bytes", stored.into())
                .member("limit_bytes", limit.into())
                .retry_after(600),
            JobError::StillActive { state } => with_state(ProblemKind::JobActive, state),
            JobError::AlreadyFinal { state } => with_state(ProblemKind::JobFinished, state),
            JobError::NotReady { state } => with_state(ProblemKind::ResultNotReady, state).retry_after(1),
            JobError::NoResult { state } => with_state(ProblemKind::NoResult, state),
            JobError::Unstorable => {
                let detail = "a text contains a NUL character, which cannot be stored";
                Problem::new(ProblemKind::InvalidRequest).detail(detail)
            }
            JobError::StorageFull => {
                tracing::error!(request_id = request_id(), "out of storage space");
                Problem::new(ProblemKind::StorageFull)
            }
            JobError::Unavailable(_) => Problem::unavailable(&error),
            JobError::NotPresented(PresentError::NotOffered { .. } | PresentError::Unreadable { .. })
            | JobError::LeaseLost
            | JobError::Corrupt { .. } => Problem::internal(&error),
        }
    }
}

impl From<SubmitError> for Problem {
    fn from(error: SubmitError) -> Self {
        match error {
            SubmitError::Parameters(faults) => {
                let errors: Vec<_> = faults
                    .into_iter()
                    .map(|f| FieldError::new(format!("/parameters{}", f.pointer), &f.code, f.detail))
                    .collect();
                Problem::new(ProblemKind::InvalidParameters).errors(&errors)
            }
            SubmitError::Input { input, refusal } => {
                let kind = ProblemKind::from_slug(&refusal.code).unwrap_or(ProblemKind::InvalidInput);
                let error = FieldError::new(format!("/{input}"), &refusal.code, &refusal.detail);
                let problem = Problem::new(kind).detail(refusal.detail).errors(&[error]).member("input", input.into());
                let problem = match refusal.place_mm {
                    Some(place) => problem.member("place_mm", serde_json::json!(place)),
                    None => problem,
                };
                match refusal.topology {
                    Some(topology) => problem.member("topology", topology),
                    None => problem,
                }
            }
            SubmitError::Pair(refusal) => {
                Problem::new(ProblemKind::from_slug(&refusal.code).unwrap_or(ProblemKind::InvalidInput))
                    .detail(refusal.detail)
            }
            SubmitError::Batch(faults) => {
                let is_large = faults.iter().all(|(.., refusal)| refusal.code == "too-large");
                let kind = if is_large { ProblemKind::TooLarge } else { ProblemKind::UnsuitableBatch };
                let errors: Vec<_> = faults
                    .into_iter()
                    .map(|(pointer, refusal)| FieldError::new(pointer, &refusal.code, refusal.detail))
                    .collect();
                Problem::new(kind).errors(&errors)
            }
            SubmitError::Study(faults) => {
                let errors: Vec<_> =
                    faults.into_iter().map(|fault| FieldError::new(fault.pointer, &fault.code, fault.detail)).collect();
                Problem::new(ProblemKind::InvalidRequest).errors(&errors)
            }
            SubmitError::Metadata { job, fault } => {
                let error = FieldError::new(format!("{job}/{}", fault.field()), "out_of_range", fault.to_string());
                Problem::new(ProblemKind::InvalidRequest).errors(&[error])
            }
            SubmitError::BatchTooLarge { limit } => Problem::new(ProblemKind::TooLarge)
                .detail(format!("a batch can have at most {limit} jobs"))
                .member("limit_jobs", limit.into()),
            SubmitError::InProgress => Problem::new(ProblemKind::IdempotencyKeyInProgress).retry_after(1),
            SubmitError::OtherRequest => Problem::new(ProblemKind::IdempotencyKeyReused),
            SubmitError::Busy => Problem::new(ProblemKind::Busy).retry_after(5),
            SubmitError::CheckFailed { .. } => Problem::internal(&error),
            SubmitError::Job(error) => error.into(),
        }
    }
}

/// The `error` of a job.
pub(crate) fn failure_document(failure: &Failure) -> ProblemDocument {
    let entry = ProblemKind::from_slug(&failure.code).unwrap_or(ProblemKind::InvalidInput).entry();
    ProblemDocument {
        r#type: format!("/problems/{}", entry.slug),
        title: entry.title.to_owned(),
        status: entry.status.as_u16(),
        detail: Some(failure.detail.clone()),
        request_id: None,
        errors: None,
        input: failure.input.clone(),
        topology: failure.topology.clone(),
        place_mm: failure.place_mm.as_deref().copied(),
        state: None,
    }
}
