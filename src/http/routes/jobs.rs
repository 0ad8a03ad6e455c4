//! `/v1/jobs`: submit, list, get, cancel, retry, delete.

use super::{batch_id, check_priority, job_id, page, small_json, study_id};
use crate::http::auth::{Reader, Rights, Submitter};
use crate::http::fields::Fields;
use crate::http::long_poll::{MAX_WAIT_S, Resource, Snapshot, Version, answer, wait_of};
use crate::http::preferences::{idempotency_key, marked, traceparent, wanted_wait};
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::{HttpState, IN_MEMORY};
use crate::http::shares::Origin;
use crate::http::submission::{self, Request as Submitted, SubmissionDocument, SubmissionForm};
use crate::http::upload::Tap;
use crate::http::wire::{BulkCancelDocument, JobDocument, JobListDocument, SubmissionAnswer, ValidationDocument};
use crate::jobs::follow::{Feed, Seen};
use crate::jobs::{
    Accepted, Job, JobFilter, JobId, JobPage, JobService, JobState, Order, PageRequest, Scope, Submission, Tenant,
    Validated,
};
use async_trait::async_trait;
use axum::Json;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::Duration;
use utoipa::openapi::path::{Parameter, ParameterBuilder, ParameterIn};
use utoipa::openapi::{Deprecated, Required};
use utoipa::{IntoParams, PartialSchema, ToSchema};

/// Submit a job
///
/// One request is the whole submission: multipart with two files, or JSON that names uploaded meshes by id or contains small
/// files in base64. Parameters and both inputs are checked before the answer. A job that is answered with 202 survives a
/// crash of the service.
///
/// A request with an `Idempotency-Key` can be repeated if its answer was lost: it creates one job, and each repetition gets
/// the first answer. With `Prefer: wait=N` the answer is delayed until the job has finished. A request that equals an
/// earlier one of the same tenant is answered with the result of that one (`cached`), unless `use_cache` is false.
#[utoipa::path(
    post, path = "/v1/jobs", tag = "jobs", operation_id = "submit_job",
    params(
        ("validate_only" = Option<bool>, Query, description = "`true` checks everything and creates no job"),
        ("Idempotency-Key" = Option<String>, Header, description = "1 to 128 visible ASCII characters"),
        ("Prefer" = Option<String>, Header, description = "`wait=N`: answer 200 with the finished job if it finishes within N s, at most 30"),
        ("traceparent" = Option<String>, Header, description = "W3C trace context, stored with the job"),
    ),
    request_body(content(
        (SubmissionForm = "multipart/form-data"),
        (SubmissionDocument = "application/json"),
    )),
    responses(
        (status = 200, description = "The job, if it finished within the wait; with `validate_only`, the outcome of the checks", body = SubmissionAnswer),
        (status = 202, description = "Accepted", body = JobDocument, headers(
            ("Location" = String, description = "The job"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"),
            ("Idempotency-Replayed" = bool, description = "Present if an earlier request with this Idempotency-Key created the job"))),
        (status = 400, description = "The body or the query is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 401, description = "No valid API key", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 403, description = "The API key lacks the scope `submit`", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "A mesh does not exist", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 408, description = "The body took too long to arrive", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "A request with the same Idempotency-Key is in progress", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "Larger than a limit of the service", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Neither multipart nor JSON, or an unknown file format", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields, parameters or inputs, or an Idempotency-Key that was used for another request", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue is full", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 503, description = "Too many uploads at once, or a dependency does not respond", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 507, description = "Out of storage space", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn submit(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    rights: Rights,
    mut query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let headers = request.headers().clone();
    let (request, tap) = Tap::on(request, state.limits.max_body_bytes());
    let validate_only = query.word("validate_only", &[("true", true), ("false", false)]).unwrap_or(false);
    // A misspelled `validate_only` must not submit a job.
    let taken = match query.finish() {
        Ok(()) => take(&state, tenant.clone(), request, &tap, &headers, validate_only).await,
        Err(problem) => Err(problem),
    };
    let taken = tap.settle(taken).await?;
    // The slot and the memory of the body are free again before the wait for the job.
    drop(tap);
    match taken {
        Taken::Tried(validated) => Ok(Json(ValidationDocument::from(validated)).into_response()),
        Taken::Accepted(accepted_now) => {
            let Accepted { made, replayed } = *accepted_now;
            let wait = wanted_wait(&headers, MAX_WAIT_S);
            let response = match wait {
                Some(wait) => after_wait(&state, &tenant, &rights, made, wait).await?,
                None => accepted(&made),
            };
            Ok(marked(response, replayed))
        }
    }
}

enum Taken {
    Accepted(Box<Accepted<Job>>),
    Tried(Box<Validated>),
}

async fn take(
    state: &HttpState,
    tenant: Tenant,
    request: Request,
    tap: &Tap,
    headers: &HeaderMap,
    validate_only: bool,
) -> Result<Taken, Problem> {
    let idempotency_key = idempotency_key(headers)?;
    state.service.refuse_when_full(&tenant).await?;
    // The submission stays in memory, and is counted, until the job is stored.
    state.begin_reading(tap, &tenant, Origin::of(request.extensions()), IN_MEMORY).await?;
    let reading = submission::read(request, tap, &state.limits, state.service.limits());
    let reading = tokio::time::timeout(state.limits.upload_timeout, reading);
    let Submitted { source, target, parameters, mut details } =
        reading.await.map_err(|_| Problem::new(ProblemKind::UploadTimeout))??;
    details.traceparent = traceparent(headers);
    let submission = Submission { tenant, source, target, parameters, details, idempotency_key };
    Ok(if validate_only {
        Taken::Tried(Box::new(state.service.validate(submission).await?))
    } else {
        Taken::Accepted(Box::new(state.service.submit(submission).await?))
    })
}

/// 202 with the job.
fn accepted(job: &Job) -> Response {
    let document = JobDocument::from(job);
    let headers = [(header::LOCATION, document.links.job.clone()), (header::RETRY_AFTER, "1".to_owned())];
    (StatusCode::ACCEPTED, headers, Json(document)).into_response()
}

/// 200 with the job if it finishes in time, else 202.
async fn after_wait(
    state: &HttpState,
    tenant: &Tenant,
    rights: &Rights,
    made: Job,
    wait: Duration,
) -> Result<Response, Problem> {
    let feed = state.service.follow(tenant, made.id).await?;
    let mut seen = feed.seen();
    let ended = seen.wait_for(|seen| seen.job.state.is_final() || seen.removed);
    let ended = tokio::select! {
        ended = tokio::time::timeout(wait, ended) => ended.is_ok(),
        () = state.stop.cancelled() => false,
    };
    // If the key was revoked during the wait, the answer reveals only what an answer without waiting would have said.
    let mut response = if ended && rights.ask(Scope::Submit).await.is_ok() {
        let job = state.service.get(tenant, made.id).await?;
        let document = JobDocument::from(&job);
        let location = [(header::CONTENT_LOCATION, document.links.job.clone())];
        (StatusCode::OK, location, Json(document)).into_response()
    } else {
        accepted(&made)
    };
    if let Ok(applied) = header::HeaderValue::from_str(&format!("wait={}", wait.as_secs())) {
        response.headers_mut().insert("preference-applied", applied);
    }
    Ok(response)
}

/// The former name of the query parameter `tag`.
const FORMER_TAG: &str = "label";

/// The query parameters that [`filter`] reads, except `state`, which each operation describes itself.
struct FilterParameters;

impl IntoParams for FilterParameters {
    fn into_params(_: impl Fn() -> Option<ParameterIn>) -> Vec<Parameter> {
        let documented = [
            ("method", "Only jobs of this method"),
            ("external_ref", "Only jobs with this external reference"),
            ("batch", "Only jobs of this batch"),
            ("study", "Only matches of this study"),
            (
                "tag",
                "Only jobs with this tag, as `name:value`; may be repeated, at most 4 tags. A colon in the name is written `\\:`, a backslash `\\\\`",
            ),
            (FORMER_TAG, "The former name of `tag`, accepted until 0.3"),
            ("created_from", "Only jobs created at this RFC 3339 time or later"),
            ("created_before", "Only jobs created before this RFC 3339 time"),
        ];
        let parameter = |(name, description)| {
            ParameterBuilder::new()
                .name(name)
                .parameter_in(ParameterIn::Query)
                .required(Required::False)
                .description(Some(description))
                .deprecated((name == FORMER_TAG).then_some(Deprecated::True))
                .schema(Some(String::schema()))
                .build()
        };
        documented.map(parameter).into()
    }
}

/// The filter in a query string.
pub(in crate::http) fn filter(query: &mut QueryString) -> JobFilter {
    let mut filter = JobFilter { method: query.text("method"), ..JobFilter::default() };
    for name in query.all("state").iter().flat_map(|list| list.split(',')) {
        match JobState::from_name(name.trim()) {
            Some(state) if filter.states.contains(&state) => {}
            Some(state) => filter.states.push(state),
            None => {
                let known: Vec<_> = JobState::ALL.iter().map(|s| s.name()).collect();
                query.fault("state", "out_of_range", format!("states are {}", known.join(", ")));
            }
        }
    }
    filter.external_ref = query.text("external_ref");
    if let Some(batch) = query.text("batch") {
        match batch_id(&batch) {
            Ok(id) => filter.batch_id = Some(id),
            Err(_) => query.fault("batch", "out_of_range", "must be the id of a batch"),
        }
    }
    if let Some(study) = query.text("study") {
        match study_id(&study) {
            Ok(id) => filter.study_id = Some(id),
            Err(_) => query.fault("study", "out_of_range", "must be the id of a study"),
        }
    }
    for parameter in ["tag", FORMER_TAG] {
        for tag in query.all(parameter) {
            match tag_of(&tag) {
                Some((name, value)) => {
                    filter.tags.insert(name, value);
                }
                None => query.fault(parameter, "out_of_range", "must be name:value"),
            }
        }
    }
    if filter.tags.len() > JobFilter::MAX_TAGS {
        query.fault("tag", "out_of_range", format!("at most {} tags", JobFilter::MAX_TAGS));
    }
    for (name, time) in [("created_from", &mut filter.created_from), ("created_before", &mut filter.created_before)] {
        if let Some(text) = query.text(name) {
            match text.parse() {
                Ok(parsed) => *time = Some(parsed),
                Err(_) => query.fault(name, "out_of_range", "must be an RFC 3339 time, such as 2026-11-21T08:00:00Z"),
            }
        }
    }
    filter
}

/// The name and the value of a tag in a query: `name:value`, with `\:` for a colon in the name and `\\` for a backslash.
fn tag_of(text: &str) -> Option<(String, String)> {
    let mut name = String::new();
    let mut characters = text.chars();
    while let Some(c) = characters.next() {
        match c {
            ':' => return Some((name, characters.as_str().to_owned())),
            '\\' if characters.as_str().starts_with([':', '\\']) => name.extend(characters.next()),
            c => name.push(c),
        }
    }
    None
}

/// A page of a list of jobs.
pub(super) fn job_list(page: &JobPage, fields: &Fields<JobDocument>) -> Result<Response, Problem> {
    fields.answer(&JobListDocument::of(page, fields.asks_for("parameters")), "jobs")
}

/// List jobs
///
/// `fields=id,state,progress`, which is not among the parameters below because the answer then lacks members that it otherwise
/// has, gives the named members of each job only. The other lists can be asked for in the same way. Jobs have their `parameters` only
/// if `fields` names them, or with `fields=*`, which stands for every member.
#[utoipa::path(
    get, path = "/v1/jobs", tag = "jobs", operation_id = "list_jobs",
    params(
        ("state" = Option<String>, Query, description = "Only jobs in these states; separated by commas, or repeated"),
        FilterParameters,
        ("order" = Option<String>, Query, description = "`desc` (newest first, the default) or `asc`"),
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Maximum number of jobs; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page"),
    ),
    responses(
        (status = 200, description = "A page", body = JobListDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn list(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let filter = filter(&mut query);
    let order = query.word("order", &[("desc", Order::NewestFirst), ("asc", Order::OldestFirst)]).unwrap_or_default();
    let (size, after) = page(&mut query);
    let fields = Fields::of(&mut query);
    query.finish()?;
    let page = state.service.list(&tenant, &filter, &PageRequest { size, after, order }).await?;
    job_list(&page, &fields)
}

/// Cancel several jobs
///
/// Cancels all unfinished jobs that match the filter: queued ones at once, running ones within a second. Without a filter,
/// `all=true` is required.
#[utoipa::path(
    post, path = "/v1/jobs/cancel", tag = "jobs", operation_id = "cancel_jobs",
    params(
        ("state" = Option<String>, Query, description = "Only jobs in this state: `queued` or `running`"),
        FilterParameters,
        ("all" = Option<bool>, Query, description = "`true` to cancel all jobs of the tenant"),
    ),
    responses(
        (status = 202, description = "Cancellation requested", body = BulkCancelDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn cancel_many(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    mut query: QueryString,
) -> Result<(StatusCode, Json<BulkCancelDocument>), Problem> {
    let filter = filter(&mut query);
    let all = query.word("all", &[("true", true), ("false", false)]).unwrap_or(false);
    if filter == JobFilter::default() && !all {
        query.fault("all", "missing", "give a filter, or all=true");
    }
    if filter.states.iter().any(|state| state.is_final()) {
        query.fault("state", "out_of_range", "only queued and running jobs can be cancelled");
    }
    query.finish()?;
    let done = state.service.cancel_all(&tenant, &filter).await?;
    Ok((StatusCode::ACCEPTED, Json(BulkCancelDocument { cancelled: done.cancelled, told: done.told })))
}

/// Get a job
///
/// With `wait` the answer is delayed until the job has changed: since the version that `If-None-Match` names, else since
/// the request. At the end of the wait an unchanged job is answered with 304 if there is an `If-None-Match`, else with 200.
/// A finished job is answered at once.
///
/// The ETag is weak. It stands for everything but the details of progress, the estimated remaining time and the queue
/// position: progress counts in whole percent and by phase. A change of progress alone is answered one second after the
/// request at the earliest, any other change at once; so a client may send the next request as soon as it has an answer.
///
/// `fields` selects members: `?fields=id,state,progress` is enough to follow the job, and `?fields=*` has the `parameters` too.
#[utoipa::path(
    get, path = "/v1/jobs/{id}", tag = "jobs", operation_id = "get_job",
    params(
        ("id" = String, Path, description = "The job"),
        ("fields" = Option<String>, Query, description = "Members to be answered, separated by commas, or `*`; all but `parameters` if absent"),
        ("wait" = Option<u32>, Query, minimum = 0, maximum = 30, description = "Longest time to wait for a change, s; 0 if absent"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer: 304 if the job has not changed since"),
    ),
    responses(
        (status = 200, description = "The job", body = JobDocument, headers(("ETag" = String, description = "Weak; pass it as `If-None-Match`"))),
        (status = 304, description = "The job has not changed since the version that `If-None-Match` names"),
        (status = 429, description = "Too many event streams and long polls are open", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn get(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    rights: Rights,
    Path(id): Path<String>,
    origin: Origin,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let wait = wait_of(&mut query, &state);
    let fields = Fields::of(&mut query);
    query.finish()?;
    let _place = if wait.is_zero() { None } else { Some(state.begin_stream(&tenant, origin)?) };
    let job = WatchedJob { service: &state.service, tenant, id: job_id(&id)?, fields };
    answer(&state, &headers, &rights, wait, &job).await
}

struct WatchedJob<'a> {
    service: &'a JobService,
    tenant: Tenant,
    id: JobId,
    fields: Fields<JobDocument>,
}

#[async_trait]
impl Resource for WatchedJob<'_> {
    type Seen = Seen;

    async fn look(&self) -> Result<Snapshot, Problem> {
        let job = self.service.get(&self.tenant, self.id).await?;
        let body = self.fields.json(&JobDocument::of(&job, self.fields.asks_for("parameters")))?;
        Ok(Snapshot { version: version(JobDocument::from(&job))?, body, is_final: job.state.is_final(), memory: None })
    }

    async fn follow(&self) -> Result<Arc<Feed<Seen>>, Problem> {
        Ok(self.service.follow(&self.tenant, self.id).await?)
    }

    fn version(&self, seen: &Seen) -> Result<Version, Problem> {
        version(JobDocument::from(&seen.job))
    }
}

/// The version of a job. Progress: whole percent, and the phase. State: all other members except the estimates, the
/// queue position, which every job ahead changes, and the details of progress.
fn version(mut document: JobDocument) -> Result<Version, Problem> {
    let progress = document.progress.take().map(|p| ((p.fraction * 100.0).floor() as u32, p.phase));
    document.eta_ms = None;
    document.energy_latest = None;
    document.queue_position = None;
    Version::of(&document, &progress)
}

/// Changes to a job.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct JobChangeDocument {
    /// Jobs with a higher priority run first.
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: i32,
}

/// Change the priority of a job
///
/// Takes effect while the job is queued; one that runs already goes on.
#[utoipa::path(
    patch, path = "/v1/jobs/{id}", tag = "jobs", operation_id = "update_job",
    params(("id" = String, Path, description = "The job")),
    request_body = JobChangeDocument,
    responses(
        (status = 200, description = "Changed", body = JobDocument),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is finished", body = ProblemDocument, content_type = "application/problem+json"),
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
) -> Result<Json<JobDocument>, Problem> {
    let JobChangeDocument { priority } = small_json(&state, &tenant, request, query).await?;
    check_priority(priority)?;
    let job = state.service.set_priority(&tenant, job_id(&id)?, priority).await?;
    Ok(Json(JobDocument::from(&job)))
}

/// Cancel a job
///
/// A queued job is cancelled at once, a running one within a second. Cancelling it again changes nothing.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/cancel", tag = "jobs", operation_id = "cancel_job",
    params(("id" = String, Path, description = "The job")),
    responses(
        (status = 202, description = "Cancellation requested; `state` becomes `cancelled`", body = JobDocument, headers(
            ("Location" = String, description = "The job"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is finished", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn cancel(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    Ok(accepted(&state.service.cancel(&tenant, job_id(&id)?).await?))
}

/// Retry a job
///
/// Creates a new job with the inputs and parameters of a finished one, and computes it again. `retry_of` names the finished
/// one.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/retry", tag = "jobs", operation_id = "retry_job",
    params(("id" = String, Path, description = "The finished job")),
    responses(
        (status = 202, description = "The new job", body = JobDocument, headers(
            ("Location" = String, description = "The new job"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "Its inputs were deleted at the end of their retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue is full", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn retry(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    Ok(accepted(&state.service.retry(&tenant, job_id(&id)?, traceparent(&headers)).await?))
}

/// Delete a job
///
/// Deletes a finished job with its trace and its result, and its input files unless other jobs use them.
#[utoipa::path(
    delete, path = "/v1/jobs/{id}", tag = "jobs", operation_id = "delete_job",
    params(("id" = String, Path, description = "The job")),
    responses(
        (status = 204, description = "Deleted"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn delete(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<StatusCode, Problem> {
    query.finish()?;
    state.service.delete(&tenant, job_id(&id)?).await?;
    Ok(StatusCode::NO_CONTENT)
}

#[cfg(test)]
mod tests {
    use super::tag_of;

    #[test]
    fn tags_in_queries_may_contain_colons() {
        for (text, expected) in [
            ("study:x", Some(("study", "x"))),
            ("study:x:y", Some(("study", "x:y"))),
            ("a\\:b:c", Some(("a:b", "c"))),
            ("a\\\\:c", Some(("a\\", "c"))),
            ("a\\b:c", Some(("a\\b", "c"))),
            (":x", Some(("", "x"))),
            ("study", None),
            ("a\\:b", None),
        ] {
            let found = tag_of(text);
            assert_eq!(found.as_ref().map(|(name, value)| (name.as_str(), value.as_str())), expected, "{text}");
        }
    }
}
