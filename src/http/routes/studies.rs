//! `/v1/studies`: studies of groups of subjects.

use super::{check_priority, page, small_json, study_id};
use crate::http::auth::{Reader, Rights, Submitter};
use crate::http::content::{Counted, Wanted, streamed, wanted};
use crate::http::fields::Fields;
use crate::http::long_poll::{Resource, Snapshot, Version, answer, wait_of};
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::representation::PAGE_POLICY;
use crate::http::router::{HttpState, IN_MEMORY};
use crate::http::shares::{Origin, Taken};
use crate::http::study_wire::{
    StudyChangeDocument, StudyDocument, StudyForm, StudyListDocument, StudyProgressDocument, StudyResultDocument,
    StudySubjectDocument, StudySubmissionDocument,
};
use crate::http::submission::{SentDetails, SentFiles, check_details, read_with_files, referred};
use crate::http::upload::Tap;
use crate::jobs::follow::Feed;
use crate::jobs::study_submission::{StudySubmission, SubmittedSubject};
use crate::jobs::{Accepted, ArtifactKind, Study, StudyId, Tenant};
use async_trait::async_trait;
use axum::Json;
use axum::body::Body;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::de::DeserializeOwned;
use std::sync::Arc;

/// Longest id of a subject, bytes; file names contain the id.
const MAX_ID: usize = 200;
/// Subjects in the document of a study; the list of its subjects has the others.
const SHOWN_SUBJECTS: usize = 500;
/// Most faults listed in an answer.
const NAMED_FAULTS: usize = 16;

/// Submit a study
///
/// A template, given or made from the group, is matched to every subject; from that come a shape model, statistics at every
/// vertex, volumes and labels, a list for quality control and a report. Inputs are uploads, by their ids, small files in
/// base64, or files of the form. What is asked and all inputs are checked before the answer. The matches are jobs, `GET /v1/jobs?study=ID`. The result
/// is that of `homolog study` with the same inputs, to the bit.
#[utoipa::path(
    post, path = "/v1/studies", tag = "studies", operation_id = "submit_study",
    params(("Idempotency-Key" = Option<String>, Header, description = "1 to 128 visible ASCII characters")),
    request_body(content((StudyForm = "multipart/form-data"), (StudySubmissionDocument = "application/json"))),
    responses(
        (status = 202, description = "Accepted", body = StudyDocument, headers(
            ("Location" = String, description = "The study"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 408, description = "The body took too long to arrive", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "A request with the same Idempotency-Key is in progress", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "More subjects than a study can have, or a body beyond the limits", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Neither multipart nor JSON, or an unknown file format", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields, parameters or inputs, or an Idempotency-Key that was used for another request", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue is full", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 507, description = "Out of storage space", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn submit(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let headers = request.headers().clone();
    let (request, tap) = Tap::on(request, state.limits.max_body_bytes());
    let taken = match query.finish() {
        Ok(()) => take(&state, tenant, request, &tap, &headers).await,
        Err(problem) => Err(problem),
    };
    let Accepted { made, replayed } = tap.settle(taken).await?;
    Ok(marked(accepted(&made), replayed))
}

async fn take(
    state: &HttpState,
    tenant: Tenant,
    request: Request,
    tap: &Tap,
    headers: &HeaderMap,
) -> Result<Accepted<Study>, Problem> {
    let idempotency_key = idempotency_key(headers)?;
    let (document, files): (StudySubmissionDocument, _) = body(state, &tenant, request, tap).await?;
    let questions = document.questions();
    let StudySubmissionDocument {
        subjects,
        template,
        template_rounds,
        permutations,
        parameters,
        tags,
        labels,
        external_ref,
        priority,
        max_run_s,
        ..
    } = document;
    let details = SentDetails { tags, labels, external_ref, priority, deadline_at: None, max_run_s, use_cache: None };
    let (parameters, mut details) = check_details(parameters, details, &state.limits, state.service.limits())?;
    details.traceparent = traceparent(headers);
    let mut faults = Vec::new();
    for (name, is_right, allowed) in [
        ("template_rounds", template_rounds.is_none_or(|n| (1..=20).contains(&n)), "must be an integer from 1 to 20"),
        (
            "permutations",
            permutations.is_none_or(|n| (1..=1_000_000).contains(&n)),
            "must be an integer from 1 to 1000000",
        ),
        ("cycles", questions.cycles <= 1000, "must be an integer from 0 to 1000"),
    ] {
        if !is_right {
            faults.push(FieldError::new(format!("/{name}"), "out_of_range", allowed));
        }
    }
    let template = template.and_then(|template| match referred("template", template, &files, &state.limits) {
        Ok(template) => Some(template),
        Err(more) => {
            faults.extend(more);
            None
        }
    });
    let subjects = checked(subjects, &files, state, faults)?;
    let submission = StudySubmission { tenant, subjects, template, questions, parameters, details, idempotency_key };
    Ok(state.service.submit_study(submission).await?)
}

/// The document in a body that may contain files.
pub(super) async fn body<T: DeserializeOwned>(
    state: &HttpState,
    tenant: &Tenant,
    request: Request,
    tap: &Tap,
) -> Result<(T, SentFiles), Problem> {
    state.begin_reading(tap, tenant, Origin::of(request.extensions()), IN_MEMORY).await?;
    let reading = read_with_files(request, tap, &state.limits);
    let reading = tokio::time::timeout(state.limits.upload_timeout, reading);
    reading.await.map_err(|_| Problem::new(ProblemKind::UploadTimeout))?
}

/// Subjects whose fields are within their limits.
pub(super) fn checked(
    subjects: Vec<StudySubjectDocument>,
    files: &SentFiles,
    state: &HttpState,
    mut faults: Vec<FieldError>,
) -> Result<Vec<SubmittedSubject>, Problem> {
    let mut taken = Vec::with_capacity(subjects.len());
    for (number, document) in subjects.into_iter().enumerate() {
        let StudySubjectDocument { id, input, subject, role, side, labels, covariates } = document;
        if id.len() > MAX_ID {
            let detail = format!("must have at most {MAX_ID} characters");
            faults.push(FieldError::new(format!("/subjects/{number}/id"), "out_of_range", detail));
        }
        match referred(&format!("subjects/{number}/input"), input, files, &state.limits) {
            Ok(input) => {
                let (role, covariates) = (role.unwrap_or_default(), covariates.0);
                taken.push(SubmittedSubject { id, subject, role, side, labels, covariates, input });
            }
            Err(more) => faults.extend(more),
        }
        if faults.len() >= NAMED_FAULTS {
            break;
        }
    }
    if faults.is_empty() { Ok(taken) } else { Err(Problem::new(ProblemKind::InvalidRequest).errors(&faults)) }
}

/// 202 with the study.
pub(super) fn accepted(study: &Study) -> Response {
    let document = StudyDocument::of(study, None);
    let headers = [(header::LOCATION, document.links.study.clone()), (header::RETRY_AFTER, "1".to_owned())];
    (StatusCode::ACCEPTED, headers, Json(document)).into_response()
}

/// List studies
///
/// `fields` selects members of each entry, as in the list of jobs.
#[utoipa::path(
    get, path = "/v1/studies", tag = "studies", operation_id = "list_studies",
    params(
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Maximum number of entries; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page"),
    ),
    responses(
        (status = 200, description = "A page", body = StudyListDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn list(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let (size, after) = page(&mut query);
    let fields = Fields::<StudyDocument>::of(&mut query);
    query.finish()?;
    let page = state.service.studies(&tenant, size, after).await?;
    let studies = page.studies.iter().map(|study| StudyDocument::of(study, None)).collect();
    let next_page_token = page.next.map(|cursor| cursor.to_token());
    fields.answer(&StudyListDocument { studies, next_page_token }, "studies")
}

/// Get a study
///
/// Its state, how far its matches are, and the first of its subjects with what was decided about them. `fields` selects members:
/// `?fields=id,state,progress` is enough to follow it. With `wait` the answer is delayed until the study has changed, as for a job; a
/// change of progress alone is answered one second after the request at the earliest. A study that has ended is answered at once.
#[utoipa::path(
    get, path = "/v1/studies/{id}", tag = "studies", operation_id = "get_study",
    params(
        ("id" = String, Path, description = "The study"),
        ("fields" = Option<String>, Query, description = "Members to be answered, separated by commas; all if absent"),
        ("wait" = Option<u32>, Query, minimum = 0, maximum = 30, description = "Longest time to wait for a change, s; 0 if absent"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer: 304 if the study has not changed since"),
    ),
    responses(
        (status = 200, description = "The study", body = StudyDocument, headers(("ETag" = String, description = "Weak; pass it as `If-None-Match`"))),
        (status = 304, description = "The study has not changed since the version that `If-None-Match` names"),
        (status = 429, description = "Too many event streams and long polls are open", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn get(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    rights: Rights,
    origin: Origin,
    Path(id): Path<String>,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let wait = wait_of(&mut query, &state);
    let fields = Fields::<StudyDocument>::of(&mut query);
    query.finish()?;
    let _place = if wait.is_zero() { None } else { Some(state.begin_stream(&tenant, origin)?) };
    let study = WatchedStudy { state: &state, tenant, origin, id: study_id(&id)?, fields };
    answer(&state, &headers, &rights, wait, &study).await
}

struct WatchedStudy<'a> {
    state: &'a HttpState,
    tenant: Tenant,
    origin: Origin,
    id: StudyId,
    fields: Fields<StudyDocument>,
}

#[async_trait]
impl Resource for WatchedStudy<'_> {
    type Seen = Study;

    async fn look(&self) -> Result<Snapshot, Problem> {
        let WatchedStudy { state, tenant, origin, id, fields } = self;
        let memory = match fields.wants("subjects") || fields.wants("parameters") {
            true => Some(definition_memory(state, tenant, *origin, *id, OUTLINE_MEMORY).await?),
            false => None,
        };
        let study = state.service.study(tenant, *id).await?;
        let places = 0..if fields.wants("subjects") { SHOWN_SUBJECTS } else { 0 };
        let outline = match memory {
            Some(_) => state.service.study_outline(tenant, *id, places).await?,
            None => None,
        };
        let body = fields.json(&StudyDocument::of(&study, outline.as_ref()))?;
        Ok(Snapshot { version: version(&study)?, body, is_final: study.state.is_final(), memory })
    }

    async fn follow(&self) -> Result<Arc<Feed<Study>>, Problem> {
        Ok(self.state.service.follow_study(&self.tenant, self.id).await?)
    }

    fn version(&self, seen: &Study) -> Result<Version, Problem> {
        version(seen)
    }
}

/// What of a study counts as a change. Progress: its matches, and every revision, such as one with a decision. State: all else.
fn version(study: &Study) -> Result<Version, Problem> {
    let mut document = StudyDocument::of(study, None);
    let StudyProgressDocument { template_round, matches_done, matches_total } = std::mem::take(&mut document.progress);
    Version::of(&document, &(template_round, matches_done, matches_total, study.revision))
}

/// Change the priority of a study
///
/// Takes effect on its jobs that are queued and on those to come; what runs already goes on.
#[utoipa::path(
    patch, path = "/v1/studies/{id}", tag = "studies", operation_id = "update_study",
    params(("id" = String, Path, description = "The study")),
    request_body = StudyChangeDocument,
    responses(
        (status = 200, description = "Changed", body = StudyDocument),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study is finished", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Not JSON", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn update(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
    request: Request,
) -> Result<Json<StudyDocument>, Problem> {
    let StudyChangeDocument { priority } = small_json(&state, &tenant, request, query).await?;
    check_priority(priority)?;
    let study = state.service.set_study_priority(&tenant, study_id(&id)?, priority).await?;
    Ok(Json(StudyDocument::of(&study, None)))
}

const JSON: [(header::HeaderName, &str); 1] = [(header::CONTENT_TYPE, "application/json")];

/// A JSON answer whose memory is counted until it is sent.
pub(super) fn counted(json: Vec<u8>, memory: Taken) -> Response {
    (JSON, Body::new(Counted::new(json.into(), memory))).into_response()
}

/// Memory of a change to a definition for each stored byte: names, numbers and texts of covariates are separate
/// allocations, and a change holds the definition twice.
pub(super) const CHANGE_MEMORY: u64 = 64;
/// Memory of a page of subjects for each stored byte: the stored bytes, the decisions and the page.
pub(super) const OUTLINE_MEMORY: u64 = 4;

/// Memory for reading the definition of a study, `factor` times its stored size, taken before it is read.
pub(super) async fn definition_memory(
    state: &HttpState,
    tenant: &Tenant,
    origin: Origin,
    id: StudyId,
    factor: u64,
) -> Result<Taken, Problem> {
    let n_bytes = state.service.study_definition_bytes(tenant, id).await?.saturating_mul(factor);
    state.answer_memory(tenant, origin, usize::try_from(n_bytes).unwrap_or(usize::MAX)).await
}

/// Delete a study
///
/// Deletes a finished study with its matches and everything that was found, and with those of its inputs that are no uploads.
#[utoipa::path(
    delete, path = "/v1/studies/{id}", tag = "studies", operation_id = "delete_study",
    params(("id" = String, Path, description = "The study")),
    responses(
        (status = 204, description = "Deleted"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study, or a match of it, is not finished", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn delete(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<StatusCode, Problem> {
    query.finish()?;
    state.service.delete_study(&tenant, study_id(&id)?).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Cancel a study
///
/// Cancels the study and its matches: queued ones at once, running ones within a second. What is finished is kept: when a
/// subject is added or a decision changes, the study goes on from there.
#[utoipa::path(
    post, path = "/v1/studies/{id}/cancel", tag = "studies", operation_id = "cancel_study",
    params(("id" = String, Path, description = "The study")),
    responses(
        (status = 202, description = "Cancelled", body = StudyDocument, headers(
            ("Location" = String, description = "The study"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study is finished", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn cancel(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    Ok(accepted(&state.service.cancel_study(&tenant, study_id(&id)?).await?))
}

/// Get the result of a study
///
/// The `study.json` that `homolog study` writes: subjects, settings, decisions, and under `found` the main figures.
#[utoipa::path(
    get, path = "/v1/studies/{id}/result", tag = "studies", operation_id = "get_study_result",
    params(
        ("id" = String, Path, description = "The study"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The result", body = StudyResultDocument, headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn result(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    method: Method,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    part(&state, &tenant, &id, ArtifactKind::StudyDocument, "application/json", &method, &headers).await
}

/// Get the report of a study
///
/// One HTML page for people, which loads nothing from anywhere: quality control with pictures, maps and modes to turn with the
/// mouse, effects, the model, consistency, labels, and methods with versions and parameters. It contains the ids of the subjects.
#[utoipa::path(
    get, path = "/v1/studies/{id}/report", tag = "studies", operation_id = "get_study_report",
    params(
        ("id" = String, Path, description = "The study"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The page", content((String = "text/html")), headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn report(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    method: Method,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let kind = ArtifactKind::StudyReport;
    let mut response = part(&state, &tenant, &id, kind, "text/html; charset=utf-8", &method, &headers).await?;
    response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, PAGE_POLICY);
    response.headers_mut().insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    Ok(response)
}

/// Get everything that a study found
///
/// The folder that `homolog study` writes, as a zip archive: tables, surfaces, modes, maps, labels, the report, and the records of
/// the matches.
#[utoipa::path(
    get, path = "/v1/studies/{id}/archive", tag = "studies", operation_id = "get_study_archive",
    params(
        ("id" = String, Path, description = "The study"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The archive", content((String = "application/zip")), headers(
            ("ETag" = String, description = "Pass it as `If-None-Match`"), ("Content-Disposition" = String, description = "Suggested file name"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn archive(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    method: Method,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let kind = ArtifactKind::StudyArchive;
    let mut response = part(&state, &tenant, &id, kind, "application/zip", &method, &headers).await?;
    let name = format!("attachment; filename=\"homolog-study-{}.zip\"", study_id(&id)?);
    if let Ok(value) = HeaderValue::from_str(&name) {
        response.headers_mut().insert(header::CONTENT_DISPOSITION, value);
    }
    Ok(response)
}

/// A part of a study's result in its stored form, or a range of it.
async fn part(
    state: &HttpState,
    tenant: &Tenant,
    id: &str,
    kind: ArtifactKind,
    content_type: &'static str,
    method: &Method,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    let found = state.service.study_part(tenant, study_id(id)?, kind).await?;
    let etag = format!("\"{}\"", &found.key.hash()[..32]);
    Ok(match wanted(method, headers, &etag, found.n_bytes) {
        Wanted::Nothing(response) => *response,
        Wanted::Content { range, with_body } => {
            let stream = if with_body { Some(state.service.open(&found, range.clone()).await?) } else { None };
            streamed(headers, &etag, content_type, found.n_bytes, range.as_ref(), stream)
        }
    })
}
