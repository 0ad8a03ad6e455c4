//! `/v1/batches`: many jobs submitted in one request.

use super::jobs::job_list;
use super::{batch_id, page};
use crate::http::auth::{Reader, Rights, Submitter};
use crate::http::fields::Fields;
use crate::http::long_poll::{Resource, Snapshot, Version, answer, wait_of};
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::{HttpState, IN_MEMORY};
use crate::http::shares::Origin;
use crate::http::strict_json::{Parameters, SentLabels, objects};
use crate::http::submission::{SentDetails, check_details, media_type, read_json};
use crate::http::upload::Tap;
use crate::http::wire::{BatchDocument, BatchListDocument, BulkCancelDocument, JobListDocument};
use crate::jobs::documents::PartialParameters;
use crate::jobs::follow::Feed;
use crate::jobs::mesh::hash_of_id;
use crate::jobs::metadata::{ExternalRef, Labels};
use crate::jobs::{
    Accepted, Batch, BatchId, BatchPair, BatchSubmission, JobFilter, JobService, Order, PageRequest, Tenant,
};
use async_trait::async_trait;
use axum::Json;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use utoipa::ToSchema;

/// Most faults listed in an answer.
const NAMED_FAULTS: usize = 16;

/// A batch: either `template` and `subjects`, or `pairs`. Meshes are referred to by the ids of uploads.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BatchSubmissionDocument {
    /// The target of every job, or its source with `template_as`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) template: Option<String>,
    /// What the template is in every job; `target` if absent. With `source` the rows of every answer are the vertices of the
    /// template, so that answers can be compared vertex by vertex.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = TemplateSide, required = false)]
    pub(crate) template_as: Option<TemplateSide>,
    /// The other surface of every job, one job each.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "objects")]
    pub(crate) subjects: Vec<SubjectDocument>,
    /// Pairs of source and target, one job each.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "objects")]
    pub(crate) pairs: Vec<PairDocument>,
    /// Parameters of all jobs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = PartialParameters, required = false)]
    pub(crate) parameters: Option<Parameters>,
    /// Labels of the batch and of every job.
    #[serde(default, skip_serializing_if = "SentLabels::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
    pub(crate) labels: SentLabels,
    /// The client's own id of the batch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// Jobs with a higher priority run first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: Option<i32>,
    /// A job expires if it has not started by this time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) deadline_at: Option<Timestamp>,
    /// Longest run time of a job, s, up to the limit of the service.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = 1)]
    pub(crate) max_run_s: Option<u64>,
    /// Whether the result of an equal job may be returned; true if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) use_cache: Option<bool>,
}

/// What the template of a batch is in every job.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum TemplateSide {
    /// Subjects are moved onto it.
    #[default]
    Target,
    /// It is moved onto the subjects.
    Source,
}

/// A subject of a batch.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SubjectDocument {
    /// The surface that is moved onto the template, or onto which the template is moved (`template_as`).
    pub(crate) mesh_id: String,
    /// The client's own id of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// Labels of the job, merged with those of the batch; at most 64 together.
    #[serde(default, skip_serializing_if = "SentLabels::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
    pub(crate) labels: SentLabels,
}

/// A pair of a batch.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PairDocument {
    /// The surface that is moved onto the target.
    pub(crate) source: String,
    /// The surface that stays in place.
    pub(crate) target: String,
    /// The client's own id of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// Labels of the job, merged with those of the batch; at most 64 together.
    #[serde(default, skip_serializing_if = "SentLabels::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
    pub(crate) labels: SentLabels,
}

/// Submit a batch
///
/// One template against many subjects, as the target or the source of every job, or a list of pairs. Either all jobs are created or none. Faults name the pair by its
/// index, counted from 0, as in `/pairs/3/source`.
#[utoipa::path(
    post, path = "/v1/batches", tag = "batches", operation_id = "submit_batch",
    params(("Idempotency-Key" = Option<String>, Header, description = "1 to 128 visible ASCII characters")),
    request_body = BatchSubmissionDocument,
    responses(
        (status = 202, description = "Accepted", body = BatchDocument, headers(
            ("Location" = String, description = "The batch"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "A request with the same Idempotency-Key is in progress", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "More jobs than a batch can have, or pairs that are too large and otherwise suitable", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Not JSON", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields, parameters or meshes, or an Idempotency-Key that was used for another request", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue has no room for all jobs", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 503, description = "Too many uploads at once, or a dependency does not respond", body = ProblemDocument, content_type = "application/problem+json"),
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
    let document = BatchDocument::from(&made);
    let location = [(header::LOCATION, document.links.batch.clone()), (header::RETRY_AFTER, "1".to_owned())];
    Ok(marked((StatusCode::ACCEPTED, location, Json(document)).into_response(), replayed))
}

async fn take(
    state: &HttpState,
    tenant: Tenant,
    request: Request,
    tap: &Tap,
    headers: &HeaderMap,
) -> Result<Accepted<Batch>, Problem> {
    let idempotency_key = idempotency_key(headers)?;
    if media_type(&request) != "application/json" {
        return Err(Problem::new(ProblemKind::UnsupportedMediaType));
    }
    state.begin_reading(tap, &tenant, Origin::of(request.extensions()), IN_MEMORY).await?;
    let reading = read_json(request, tap, &state.limits, state.limits.max_json_bytes);
    let reading = tokio::time::timeout(state.limits.upload_timeout, reading);
    let document: BatchSubmissionDocument = reading.await.map_err(|_| Problem::new(ProblemKind::UploadTimeout))??;
    let BatchSubmissionDocument {
        template,
        template_as,
        subjects,
        pairs,
        parameters,
        labels,
        external_ref,
        priority,
        deadline_at,
        max_run_s,
        use_cache,
    } = document;
    let details = SentDetails { labels, external_ref, priority, deadline_at, max_run_s, use_cache };
    let (parameters, mut details) = check_details(parameters, details, &state.limits, state.service.limits())?;
    details.traceparent = traceparent(headers);
    let pairs = match (template, subjects.is_empty(), pairs.is_empty()) {
        (Some(template), false, true) => subjects
            .into_iter()
            .map(|SubjectDocument { mesh_id, external_ref, labels }| {
                let (source, target) = match template_as.unwrap_or_default() {
                    TemplateSide::Target => (mesh_id, template.clone()),
                    TemplateSide::Source => (template.clone(), mesh_id),
                };
                PairDocument { source, target, external_ref, labels }
            })
            .collect(),
        (None, true, false) if template_as.is_none() => pairs,
        _ => {
            let detail = "either template and subjects, or pairs is required; template_as belongs to the former";
            return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[FieldError::new("", "missing", detail)]));
        }
    };
    let mut faults = Vec::new();
    let mut checked = Vec::with_capacity(pairs.len());
    for (number, pair) in pairs.into_iter().enumerate() {
        match check_pair(pair) {
            Ok(pair) => checked.push(pair),
            Err((field, detail)) => {
                faults.push(FieldError::new(format!("/pairs/{number}/{field}"), "out_of_range", detail));
            }
        }
        if faults.len() >= NAMED_FAULTS {
            break;
        }
    }
    if !faults.is_empty() {
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&faults));
    }
    let pairs = checked;
    let submission = BatchSubmission { tenant, pairs, parameters, details, idempotency_key };
    Ok(state.service.submit_batch(submission).await?)
}

/// A pair whose fields are within their limits; else the field that is not, and what is allowed.
fn check_pair(pair: PairDocument) -> Result<BatchPair, (&'static str, String)> {
    let hash = |side: &'static str, id: &str| match hash_of_id(id) {
        Some(hash) => Ok(hash.to_owned()),
        None => Err((side, "must be blake3: and 64 hexadecimal digits".to_owned())),
    };
    let PairDocument { source, target, external_ref, labels: SentLabels(labels) } = pair;
    Ok(BatchPair {
        source: hash("source", &source)?,
        target: hash("target", &target)?,
        external_ref: ExternalRef::new(external_ref.unwrap_or_default())
            .map_err(|fault| ("external_ref", fault.to_string()))?,
        labels: Labels::new(labels).map_err(|fault| ("labels", fault.to_string()))?,
    })
}

/// List batches
///
/// `fields` selects members of each entry, as in the list of jobs.
#[utoipa::path(
    get, path = "/v1/batches", tag = "batches", operation_id = "list_batches",
    params(
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Maximum number of entries; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page"),
    ),
    responses(
        (status = 200, description = "A page", body = BatchListDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn list(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let (size, after) = page(&mut query);
    let fields = Fields::<BatchDocument>::of(&mut query);
    query.finish()?;
    let page = state.service.batches(&tenant, size, after).await?;
    let batches = page.batches.iter().map(BatchDocument::from).collect();
    let next_page_token = page.next.map(|cursor| cursor.to_token());
    fields.answer(&BatchListDocument { batches, next_page_token }, "batches")
}

/// Get a batch
///
/// With `wait` the answer is delayed until the batch has changed, as for a job. The end of the last job is answered at
/// once, other changes of the counts one second after the request at the earliest. A finished batch is answered at once.
#[utoipa::path(
    get, path = "/v1/batches/{id}", tag = "batches", operation_id = "get_batch",
    params(
        ("id" = String, Path, description = "The batch"),
        ("wait" = Option<u32>, Query, minimum = 0, maximum = 30, description = "Longest time to wait for a change, s; 0 if absent"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer: 304 if the batch has not changed since"),
    ),
    responses(
        (status = 200, description = "The batch, with the number of its jobs in each state", body = BatchDocument, headers(("ETag" = String, description = "Weak; pass it as `If-None-Match`"))),
        (status = 304, description = "The batch has not changed since the version that `If-None-Match` names"),
        (status = 429, description = "Too many event streams and long polls are open", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such batch", body = ProblemDocument, content_type = "application/problem+json"),
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
    query.finish()?;
    let _place = if wait.is_zero() { None } else { Some(state.begin_stream(&tenant, origin)?) };
    let batch = WatchedBatch { service: &state.service, tenant, id: batch_id(&id)? };
    answer(&state, &headers, &rights, wait, &batch).await
}

struct WatchedBatch<'a> {
    service: &'a JobService,
    tenant: Tenant,
    id: BatchId,
}

#[async_trait]
impl Resource for WatchedBatch<'_> {
    type Seen = Batch;

    async fn look(&self) -> Result<Snapshot, Problem> {
        let batch = self.service.batch(&self.tenant, self.id).await?;
        let document = BatchDocument::from(&batch);
        let body = serde_json::to_vec(&document).map_err(|e| Problem::internal(&e))?;
        Ok(Snapshot { version: version(document)?, body, is_final: batch.is_finished() })
    }

    async fn follow(&self) -> Result<Arc<Feed<Batch>>, Problem> {
        Ok(self.service.follow_batch(&self.tenant, self.id).await?)
    }

    fn version(&self, seen: &Batch) -> Result<Version, Problem> {
        version(BatchDocument::from(seen))
    }
}

/// What of a batch counts as a change. Progress: the counts. State: all else, such as whether it is finished.
fn version(mut document: BatchDocument) -> Result<Version, Problem> {
    let counts = std::mem::take(&mut document.counts);
    Version::of(&document, &counts)
}

/// List the jobs of a batch
///
/// `fields` selects members of each job, as in the list of jobs.
#[utoipa::path(
    get, path = "/v1/batches/{id}/jobs", tag = "batches", operation_id = "list_batch_jobs",
    params(
        ("id" = String, Path, description = "The batch"),
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Maximum number of jobs; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page"),
    ),
    responses(
        (status = 200, description = "A page, in the order of submission", body = JobListDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such batch", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn jobs(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let (size, after) = page(&mut query);
    let fields = Fields::of(&mut query);
    query.finish()?;
    let id = state.service.batch(&tenant, batch_id(&id)?).await?.id;
    let filter = JobFilter { batch_id: Some(id), ..JobFilter::default() };
    let page = state.service.list(&tenant, &filter, &PageRequest { size, after, order: Order::OldestFirst }).await?;
    job_list(&page, &fields)
}

/// Cancel a batch
///
/// Cancels all its unfinished jobs: queued ones at once, running ones within a second.
#[utoipa::path(
    post, path = "/v1/batches/{id}/cancel", tag = "batches", operation_id = "cancel_batch",
    params(("id" = String, Path, description = "The batch")),
    responses(
        (status = 202, description = "Cancellation requested", body = BulkCancelDocument),
        (status = 404, description = "No such batch", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn cancel(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<(StatusCode, Json<BulkCancelDocument>), Problem> {
    query.finish()?;
    let id = state.service.batch(&tenant, batch_id(&id)?).await?.id;
    let filter = JobFilter { batch_id: Some(id), ..JobFilter::default() };
    let done = state.service.cancel_all(&tenant, &filter).await?;
    Ok((StatusCode::ACCEPTED, Json(BulkCancelDocument { cancelled: done.cancelled, told: done.told })))
}
