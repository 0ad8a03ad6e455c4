//! `/v1/jobs`: submit, list, get, cancel, retry, delete.

use super::{accepted, check_priority};
use crate::http::call::{AuthorizedRequest, PageOf, ResourceId};
use crate::http::fields::Fields;
use crate::http::long_poll::{MAX_WAIT_S, Resource, Snapshot, Version, Watched, watch};
use crate::http::preferences::{idempotency_key, marked, traceparent, wanted_wait};
use crate::http::problem::Problem;
use crate::http::query::QueryString;
use crate::http::submission::{self, Request as Submitted, SubmissionDocument, SubmissionForm};
use crate::http::upload::LimitedBody;
use crate::http::wire::{BulkCancelDocument, JobDocument, JobListDocument, SubmissionAnswer, ValidationDocument};
use crate::jobs::follow::{Feed, Seen};
use crate::jobs::job::Cursor;
use crate::jobs::{Accepted, Job, JobFilter, JobId, JobState, Order, PageRequest, Scope, Submission, Validated};
use async_trait::async_trait;
use axum::Json;
use axum::extract::Request;
use axum::http::{StatusCode, header};
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
    post, path = "/v1/jobs",
    params(
        ("validate_only" = Option<bool>, Query, description = "`true` checks everything and creates no job"),
        ("Idempotency-Key" = Option<String>, Header, description = "1 to 128 visible ASCII characters"),
        ("Prefer" = Option<String>, Header, description = "`wait=N`: answer 200 with the finished job if it finishes within N s, at most 30"),
        ("traceparent" = Option<String>, Header, description = "W3C trace context, stored with the job"),
    ),
    request_body(content(
        (SubmissionForm = "multipart/form-data"),
        (SubmissionDocument = "application/json"))),
    responses(
        (status = 200, description = "The job, if it finished within the wait; with `validate_only`, the outcome of the checks", body = SubmissionAnswer),
        (status = 202, description = "Accepted", body = JobDocument, headers(
            ("Idempotency-Replayed" = bool, description = "Present if an earlier request with this Idempotency-Key created the job"))),
    )
)]
pub(crate) async fn submit(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let (request, tap) = LimitedBody::on(request, call.state.limits.max_body_bytes());
    let validate_only = call.query.word("validate_only", &[("true", true), ("false", false)]).unwrap_or(false);
    // A misspelled `validate_only` must not submit a job.
    let taken = async {
        call.query.finish()?;
        take(&call, request, &tap, validate_only).await
    };
    let taken = tap.settle(taken).await?;
    // The slot and the memory of the body are free again before the wait for the job.
    drop(tap);
    match taken {
        SubmissionOutcome::Tried(validated) => Ok(Json(ValidationDocument::from(validated)).into_response()),
        SubmissionOutcome::Accepted(accepted_now) => {
            let Accepted { made, replayed } = *accepted_now;
            let response = match wanted_wait(&call.headers, MAX_WAIT_S) {
                Some(wait) => after_wait(&call, made, wait).await?,
                None => accepted_job(&made),
            };
            Ok(marked(response, replayed))
        }
    }
}

enum SubmissionOutcome {
    Accepted(Box<Accepted<Job>>),
    Tried(Box<Validated>),
}

async fn take(
    call: &AuthorizedRequest,
    request: Request,
    tap: &LimitedBody,
    validate_only: bool,
) -> Result<SubmissionOutcome, Problem> {
    let AuthorizedRequest { state, tenant, headers, .. } = call;
    let idempotency_key = idempotency_key(headers)?;
    state.service.refuse_when_full(tenant).await?;
    // The submission stays in memory, and is counted, until the job is stored.
    call.begin_reading(tap).await?;
    let reading = submission::read(request, tap, &state.limits, state.service.limits());
    let Submitted { source, target, parameters, mut details } = call.in_time(reading).await?;
    details.traceparent = traceparent(headers);
    let submission = Submission { tenant: tenant.clone(), source, target, parameters, details, idempotency_key };
    Ok(if validate_only {
        SubmissionOutcome::Tried(Box::new(state.service.validate(submission).await?))
    } else {
        SubmissionOutcome::Accepted(Box::new(state.service.submit(submission).await?))
    })
}

/// 202 with the job.
fn accepted_job(job: &Job) -> Response {
    let document = JobDocument::from(job);
    accepted(&document.links.job.clone(), document)
}

/// 200 with the job if it finishes in time, else 202.
async fn after_wait(call: &AuthorizedRequest, made: Job, wait: Duration) -> Result<Response, Problem> {
    let feed = call.service().follow(&call.tenant, made.id).await?;
    let mut seen = feed.seen();
    let ended = seen.wait_for(|seen| seen.job.state.is_final() || seen.removed);
    let ended = tokio::select! {
        ended = tokio::time::timeout(wait, ended) => ended.is_ok(),
        () = call.state.stop.cancelled() => false,
    };
    // If the key was revoked during the wait, the answer reveals only what an answer without waiting would have said.
    let mut response = if ended && call.rights.ask(Scope::Submit).await.is_ok() {
        let job = call.service().get(&call.tenant, made.id).await?;
        let document = JobDocument::from(&job);
        let location = [(header::CONTENT_LOCATION, document.links.job.clone())];
        (StatusCode::OK, location, Json(document)).into_response()
    } else {
        accepted_job(&made)
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
    filter.batch_id = named(query, "batch");
    filter.study_id = named(query, "study");
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

/// The id of a resource of this kind that the parameter `kind` names.
fn named<I: ResourceId>(query: &mut QueryString, kind: &str) -> Option<I> {
    let text = query.text(kind)?;
    let id = I::parse(&text);
    if id.is_none() {
        query.fault(kind, "out_of_range", format!("must be the id of a {kind}"));
    }
    id
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

/// A page of the jobs that match a filter.
pub(super) async fn job_list(
    call: &AuthorizedRequest,
    PageOf { size, after, fields }: PageOf<Cursor, JobDocument>,
    filter: &JobFilter,
    order: Order,
) -> Result<Response, Problem> {
    let page = call.service().list(&call.tenant, filter, &PageRequest { size, after, order }).await?;
    fields.answer(&JobListDocument::of(&page, fields.asks_for("parameters")), "jobs")
}

/// List jobs
///
/// `fields=id,state,progress`, which is not among the parameters below because the answer then lacks members that it otherwise
/// has, gives the named members of each job only. The other lists can be asked for in the same way. Jobs have their `parameters` only
/// if `fields` names them, or with `fields=*`, which stands for every member.
#[utoipa::path(
    get, path = "/v1/jobs",
    params(
        ("state" = Option<String>, Query, description = "Only jobs in these states; separated by commas, or repeated"),
        FilterParameters,
        ("order" = Option<String>, Query, description = "`desc` (newest first, the default) or `asc`"),
    ),
    responses((status = 200, description = "A page", body = JobListDocument))
)]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let filter = filter(&mut call.query);
    let order =
        call.query.word("order", &[("desc", Order::NewestFirst), ("asc", Order::OldestFirst)]).unwrap_or_default();
    let page = call.last_page(Cursor::from_token)?;
    job_list(&call, page, &filter, order).await
}

/// Cancel several jobs
///
/// Cancels all unfinished jobs that match the filter: queued ones at once, running ones within a second. Without a filter,
/// `all=true` is required.
#[utoipa::path(
    post, path = "/v1/jobs/cancel",
    params(
        ("state" = Option<String>, Query, description = "Only jobs in this state: `queued` or `running`"),
        FilterParameters,
        ("all" = Option<bool>, Query, description = "`true` to cancel all jobs of the tenant"),
    ),
    responses((status = 202, description = "Cancellation requested", body = BulkCancelDocument))
)]
pub(crate) async fn cancel_many(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let filter = filter(&mut call.query);
    let all = call.query.word("all", &[("true", true), ("false", false)]).unwrap_or(false);
    if filter == JobFilter::default() && !all {
        call.query.fault("all", "missing", "give a filter, or all=true");
    }
    if filter.states.iter().any(|state| state.is_final()) {
        call.query.fault("state", "out_of_range", "only queued and running jobs can be cancelled");
    }
    call.query.finish()?;
    cancel_all(&call, &filter).await
}

/// Cancels the unfinished jobs that match a filter.
pub(super) async fn cancel_all(call: &AuthorizedRequest, filter: &JobFilter) -> Result<Response, Problem> {
    let done = call.service().cancel_all(&call.tenant, filter).await?;
    let document = BulkCancelDocument { cancelled: done.cancelled, told: done.told };
    Ok((StatusCode::ACCEPTED, Json(document)).into_response())
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
    get, path = "/v1/jobs/{id}",
    params(("fields" = Option<String>, Query, description = "Members to be answered, separated by commas, or `*`; all but `parameters` if absent")),
    responses((status = 200, description = "The job", body = JobDocument))
)]
pub(crate) async fn get(call: AuthorizedRequest) -> Result<Response, Problem> {
    watch::<JobId, JobDocument>(call, Fields::of).await
}

#[async_trait]
impl Resource for Watched<JobId, JobDocument> {
    type Seen = Seen;

    async fn look(&self) -> Result<Snapshot, Problem> {
        let job = self.call.service().get(&self.call.tenant, self.id).await?;
        let body = self.fields.json(&JobDocument::of(&job, self.fields.asks_for("parameters")))?;
        Ok(Snapshot { version: version(JobDocument::from(&job))?, body, is_final: job.state.is_final(), memory: None })
    }

    async fn follow(&self) -> Result<Arc<Feed<Seen>>, Problem> {
        Ok(self.call.service().follow(&self.call.tenant, self.id).await?)
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
    patch, path = "/v1/jobs/{id}",
    request_body = JobChangeDocument,
    responses((status = 200, description = "Changed", body = JobDocument))
)]
pub(crate) async fn update(mut call: AuthorizedRequest, request: Request) -> Result<Json<JobDocument>, Problem> {
    let JobChangeDocument { priority } = call.small_json(request).await?;
    check_priority(priority)?;
    let job = call.service().set_priority(&call.tenant, call.id()?, priority).await?;
    Ok(Json(JobDocument::from(&job)))
}

/// Cancel a job
///
/// A queued job is cancelled at once, a running one within a second. Cancelling it again changes nothing.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/cancel",
    responses((status = 202, description = "Cancellation requested; `state` becomes `cancelled`", body = JobDocument))
)]
pub(crate) async fn cancel(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let id: JobId = call.last_id()?;
    Ok(accepted_job(&call.service().cancel(&call.tenant, id).await?))
}

/// Retry a job
///
/// Creates a new job with the inputs and parameters of a finished one, and computes it again. `retry_of` names the finished
/// one.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/retry",
    params(("id" = String, Path, description = "The finished job")),
    responses((status = 202, description = "The new job", body = JobDocument, headers(("Location" = String, description = "The new job"))))
)]
pub(crate) async fn retry(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let id: JobId = call.last_id()?;
    Ok(accepted_job(&call.service().retry(&call.tenant, id, traceparent(&call.headers)).await?))
}

/// Delete a job
///
/// Deletes a finished job with its trace and its result, and its input files unless other jobs use them.
#[utoipa::path(delete, path = "/v1/jobs/{id}", responses((status = 204, description = "Deleted")))]
pub(crate) async fn delete(mut call: AuthorizedRequest) -> Result<StatusCode, Problem> {
    let id: JobId = call.last_id()?;
    call.service().delete(&call.tenant, id).await?;
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
