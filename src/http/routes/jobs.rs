//! `/v1/jobs`: submit, list, look, cancel, delete.

use super::{job_id, tenant};
use crate::http::conditional::{etag_of, is_fresh, respond};
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::upload::{Tap, read_submission};
use crate::http::wire::{JobDocument, JobListDocument, SubmissionForm};
use crate::jobs::job::Cursor;
use crate::jobs::{Details, Job, JobFilter, JobState, Order, PageRequest, Submission, SubmittedInput, Tenant};
use axum::Json;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::sync::Arc;
use std::time::Duration;

const DEFAULT_PAGE: u32 = 50;
const MAX_PAGE: u32 = 500;
/// Longest long poll, s.
const MAX_WAIT_S: u32 = 30;
/// How often a long poll looks: a read by primary key.
const LOOK: Duration = Duration::from_millis(200);

/// Submit a job
///
/// One multipart request with two files is the whole submission. Parameters and both inputs are checked before the
/// answer; a 202 is durable.
#[utoipa::path(
    post, path = "/v1/jobs", tag = "jobs", operation_id = "submit_job",
    request_body(content = SubmissionForm, content_type = "multipart/form-data"),
    responses(
        (status = 202, description = "Accepted", body = JobDocument, headers(
            ("Location" = String, description = "The job"), ("Retry-After" = u32, description = "When to look, s"))),
        (status = 400, description = "The multipart body cannot be read", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 408, description = "The body took too long", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "Over a limit", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "No multipart, or an unknown file format", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Faults in fields, parameters or inputs", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue is full", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 503, description = "Busy, or a dependency does not answer", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 507, description = "No room", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn submit(State(state): State<HttpState>, query: QueryString, request: Request) -> Result<Response, Problem> {
    let (request, tap) = Tap::on(request, state.limits.max_body_bytes());
    // A parameter that is not known must not submit what was meant to be tried only.
    let accepted = match query.finish() {
        Ok(()) => accept(&state, request, &tap).await,
        Err(problem) => Err(problem),
    };
    if accepted.is_err() {
        tap.drain().await;
    }
    let document = JobDocument::from(&accepted?);
    let headers = [(header::LOCATION, document.links.job.clone()), (header::RETRY_AFTER, "1".to_owned())];
    Ok((StatusCode::ACCEPTED, headers, Json(document)).into_response())
}

async fn accept(state: &HttpState, request: Request, tap: &Tap) -> Result<Job, Problem> {
    let tenant = Tenant::default();
    state.service.refuse_when_full(&tenant).await?;
    let place = tokio::time::timeout(state.limits.max_upload_wait, Arc::clone(&state.uploads).acquire_owned()).await;
    // Held until the job is stored: so many submissions are in memory at most.
    let Ok(Ok(_place)) = place else { return Err(Problem::new(ProblemKind::Busy).retry_after(5)) };
    let reading = tokio::time::timeout(state.limits.upload_timeout, read_submission(request, tap, &state.limits));
    let upload = reading.await.map_err(|_| Problem::new(ProblemKind::UploadTimeout))??;
    let submission = Submission {
        tenant,
        source: SubmittedInput::File(upload.source),
        target: SubmittedInput::File(upload.target),
        parameters: upload.parameters,
        details: Details {
            priority: upload.priority,
            labels: upload.labels,
            external_ref: upload.external_ref,
            compute_anew: true,
            ..Details::default()
        },
        idempotency_key: None,
    };
    Ok(state.service.submit(submission).await?.made)
}

/// List jobs
#[utoipa::path(
    get, path = "/v1/jobs", tag = "jobs", operation_id = "list_jobs",
    params(
        ("state" = Option<String>, Query, description = "Only these states; separate several by commas, or repeat"),
        ("method" = Option<String>, Query, description = "Only this method"),
        ("external_ref" = Option<String>, Query, description = "Only this external reference"),
        ("order" = Option<String>, Query, description = "`desc` (the newest first, the default) or `asc`"),
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Most jobs of a page; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the page before"),
    ),
    responses(
        (status = 200, description = "A page", body = JobListDocument),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn list(State(state): State<HttpState>, mut query: QueryString) -> Result<Json<JobListDocument>, Problem> {
    let mut states = Vec::new();
    for name in query.all("state").iter().flat_map(|list| list.split(',')) {
        match JobState::from_name(name.trim()) {
            Some(state) => states.push(state),
            None => {
                let known: Vec<_> = JobState::ALL.iter().map(|s| s.name()).collect();
                query.fault("state", "out_of_range", format!("states are {}", known.join(", ")));
            }
        }
    }
    let filter = JobFilter { states, method: query.text("method"), external_ref: query.text("external_ref"), ..JobFilter::default() };
    let order = query.word("order", &[("desc", Order::NewestFirst), ("asc", Order::OldestFirst)]).unwrap_or_default();
    let size = query.number("page_size", 1..=MAX_PAGE).unwrap_or(DEFAULT_PAGE);
    let token = query.text("page_token").filter(|token| !token.is_empty());
    let after = token.as_deref().and_then(Cursor::from_token);
    if token.is_some() && after.is_none() {
        query.fault("page_token", "out_of_range", "hand back a next_page_token as it was given");
    }
    query.finish()?;
    let page = state.service.list(&tenant(), &filter, &PageRequest { size, after, order }).await?;
    Ok(Json(JobListDocument::from(&page)))
}

/// Look at a job
///
/// With `wait` the answer comes when the job changes (from what `If-None-Match` names, else from what it is now), or
/// when the time is over, or when it is finished.
#[utoipa::path(
    get, path = "/v1/jobs/{id}", tag = "jobs", operation_id = "get_job",
    params(
        ("id" = String, Path, description = "The job"),
        ("wait" = Option<u32>, Query, minimum = 0, maximum = 30, description = "Longest wait for a change, s"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The job", body = JobDocument, headers(("ETag" = String))),
        (status = 304, description = "Unchanged"),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn get(
    State(state): State<HttpState>,
    Path(id): Path<String>,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let wait = query.number("wait", 0..=MAX_WAIT_S).unwrap_or(0);
    query.finish()?;
    let id = job_id(&id)?;
    let until = tokio::time::Instant::now() + Duration::from_secs(wait.into());
    let conditional = headers.contains_key(header::IF_NONE_MATCH);
    let mut first: Option<String> = None;
    loop {
        let job = state.service.get(&tenant(), id).await?;
        let body = json_body(&JobDocument::from(&job))?;
        let etag = etag_of(&body);
        let changed =
            if conditional { !is_fresh(&headers, &etag) } else { *first.get_or_insert_with(|| etag.clone()) != etag };
        let over = tokio::time::Instant::now() >= until || state.stop.is_cancelled();
        if changed || over || job.state.is_final() {
            return Ok(respond(&headers, &etag, "application/json", body));
        }
        tokio::select! {
            () = tokio::time::sleep_until(until.min(tokio::time::Instant::now() + LOOK)) => {}
            () = state.stop.cancelled() => {}
        }
    }
}

/// Ask for a job's end
///
/// A waiting job is cancelled at once, a running one within a second. Asking again changes nothing.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/cancel", tag = "jobs", operation_id = "cancel_job",
    params(("id" = String, Path, description = "The job")),
    responses(
        (status = 202, description = "Asked for; look at `state`", body = JobDocument, headers(
            ("Location" = String, description = "The job"), ("Retry-After" = u32, description = "When to look, s"))),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Finished already", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn cancel(
    State(state): State<HttpState>,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let job = state.service.cancel(&tenant(), job_id(&id)?).await?;
    let document = JobDocument::from(&job);
    let headers = [(header::LOCATION, document.links.job.clone()), (header::RETRY_AFTER, "1".to_owned())];
    Ok((StatusCode::ACCEPTED, headers, Json(document)).into_response())
}

/// Delete a job
///
/// Removes the job, its trace, its result, and its files unless other jobs have the same.
#[utoipa::path(
    delete, path = "/v1/jobs/{id}", tag = "jobs", operation_id = "delete_job",
    params(("id" = String, Path, description = "The job")),
    responses(
        (status = 204, description = "Gone"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn delete(
    State(state): State<HttpState>,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<StatusCode, Problem> {
    query.finish()?;
    state.service.delete(&tenant(), job_id(&id)?).await?;
    Ok(StatusCode::NO_CONTENT)
}

fn json_body(document: &JobDocument) -> Result<Vec<u8>, Problem> {
    serde_json::to_vec(document).map_err(|e| Problem::internal(&e))
}
