//! `/v1/batches`: many jobs submitted in one request.

use super::jobs::job_list;
use super::{batch_id, page};
use crate::http::auth::{Reader, Rights, Submitter};
use crate::http::fields::Fields;
use crate::http::input_wire::{SubmittedInputDocument, input, maybe_input};
use crate::http::long_poll::{Resource, Snapshot, Version, answer, wait_of};
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::{HttpState, IN_MEMORY};
use crate::http::shares::Origin;
use crate::http::strict_json::{Parameters, SentTags, objects, tags_of};
use crate::http::submission::{SentDetails, SentFiles, check_details, read_with_files, referred};
use crate::http::upload::Tap;
use crate::http::wire::{BatchDocument, BatchListDocument, BulkCancelDocument, JobListDocument};
use crate::jobs::documents::PartialParameters;
use crate::jobs::follow::Feed;
use crate::jobs::metadata::ExternalRef;
use crate::jobs::{
    Accepted, Batch, BatchForm as Form, BatchId, BatchPair, BatchSubmission, JobFilter, JobService, Order, PageRequest,
    SubmittedInput, Tenant,
};
use async_trait::async_trait;
use axum::Json;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;
use utoipa::ToSchema;

/// Most faults listed in an answer.
const NAMED_FAULTS: usize = 16;

/// A batch: either `template` and `subjects`, or `pairs`.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BatchSubmissionDocument {
    /// The target of every job, or its source with `template_as`.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "maybe_input")]
    #[schema(value_type = Option<SubmittedInputDocument>)]
    pub(crate) template: Option<SubmittedInputDocument>,
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
    /// Tags of the batch and of every job.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
    pub(crate) tags: SentTags,
    /// The former name of `tags`, accepted until 0.3.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false, deprecated)]
    pub(crate) labels: SentTags,
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
    #[serde(deserialize_with = "input")]
    pub(crate) input: SubmittedInputDocument,
    /// The client's own id of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// Tags of the job, merged with those of the batch; at most 64 together.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
    pub(crate) tags: SentTags,
    /// The former name of `tags`, accepted until 0.3.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false, deprecated)]
    pub(crate) labels: SentTags,
}

/// A pair of a batch.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PairDocument {
    /// The surface that is moved onto the target.
    #[serde(deserialize_with = "input")]
    pub(crate) source: SubmittedInputDocument,
    /// The surface that stays in place.
    #[serde(deserialize_with = "input")]
    pub(crate) target: SubmittedInputDocument,
    /// The client's own id of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// Tags of the job, merged with those of the batch; at most 64 together.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
    pub(crate) tags: SentTags,
    /// The former name of `tags`, accepted until 0.3.
    #[serde(default, skip_serializing_if = "SentTags::is_empty")]
    #[schema(value_type = std::collections::BTreeMap<String, String>, required = false, deprecated)]
    pub(crate) labels: SentTags,
}

/// A batch as a multipart form.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub(crate) struct BatchForm {
    /// The batch; its inputs refer to files by their names, as `{"upload": "subject-1.nii.gz"}`.
    document: BatchSubmissionDocument,
    /// The files, under different names.
    #[schema(value_type = Vec<String>, format = Binary, required = false)]
    files: Vec<String>,
}

/// Submit a batch
///
/// One template against many subjects, as the target or the source of every job, or a list of pairs. Either all jobs are created or none. Inputs
/// are uploads, by their ids, small files in base64, or files of the form. Faults name the pair or the subject by its index,
/// counted from 0, as in `/pairs/3/source`.
#[utoipa::path(
    post, path = "/v1/batches", tag = "batches", operation_id = "submit_batch",
    params(("Idempotency-Key" = Option<String>, Header, description = "1 to 128 visible ASCII characters")),
    request_body(content((BatchForm = "multipart/form-data"), (BatchSubmissionDocument = "application/json"))),
    responses(
        (status = 202, description = "Accepted", body = BatchDocument, headers(
            ("Location" = String, description = "The batch"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "A request with the same Idempotency-Key is in progress", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "More jobs than a batch can have, or pairs that are too large and otherwise suitable", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Neither multipart nor JSON, or an unknown file format", body = ProblemDocument, content_type = "application/problem+json"),
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
    state.begin_reading(tap, &tenant, Origin::of(request.extensions()), IN_MEMORY).await?;
    let reading = read_with_files(request, tap, &state.limits);
    let reading = tokio::time::timeout(state.limits.upload_timeout, reading);
    let (document, files): (BatchSubmissionDocument, SentFiles) =
        reading.await.map_err(|_| Problem::new(ProblemKind::UploadTimeout))??;
    let BatchSubmissionDocument {
        template,
        template_as,
        subjects,
        pairs,
        parameters,
        tags,
        labels,
        external_ref,
        priority,
        deadline_at,
        max_run_s,
        use_cache,
    } = document;
    let details = SentDetails { tags, labels, external_ref, priority, deadline_at, max_run_s, use_cache };
    let (parameters, mut details) = check_details(parameters, details, &state.limits, state.service.limits())?;
    details.traceparent = traceparent(headers);
    let form = match (template.is_some(), template_as) {
        (false, _) => Form::Pairs,
        (true, None | Some(TemplateSide::Target)) => Form::TemplateAsTarget,
        (true, Some(TemplateSide::Source)) => Form::TemplateAsSource,
    };
    let mut inputs = Inputs { state, files, form, taken: Vec::new(), places: BTreeMap::new(), faults: Vec::new() };
    let pairs = match (template, subjects.is_empty(), pairs.is_empty()) {
        (Some(template), false, true) => {
            let template = inputs.take("template", template);
            inputs.pairs(subjects, |inputs, number, subject| inputs.subject(number, subject, template))
        }
        (None, true, false) if template_as.is_none() => inputs.pairs(pairs, Inputs::pair),
        (Some(_), true, true) => {
            let error = FieldError::new("/subjects", "invalid-value", "must not be empty");
            return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[error]));
        }
        _ => {
            let detail = "either template and subjects, or pairs is required; template_as belongs to the former";
            return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[FieldError::new("", "missing", detail)]));
        }
    };
    if !inputs.faults.is_empty() {
        inputs.faults.truncate(NAMED_FAULTS);
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&inputs.faults));
    }
    let submission =
        BatchSubmission { tenant, inputs: inputs.taken, form, pairs, parameters, details, idempotency_key };
    Ok(state.service.submit_batch(submission).await?)
}

/// The inputs of a batch while its pairs are read. Uploads and files of the form are taken once.
struct Inputs<'a> {
    state: &'a HttpState,
    files: SentFiles,
    form: Form,
    taken: Vec<SubmittedInput>,
    /// The places of those that have a name: the id of an upload, or the name of a file.
    places: BTreeMap<(Option<String>, Option<String>), usize>,
    faults: Vec<FieldError>,
}

impl Inputs<'_> {
    /// The pairs of a list, until too many have faults.
    fn pairs<T>(&mut self, list: Vec<T>, of: impl Fn(&mut Self, usize, T) -> Option<BatchPair>) -> Vec<BatchPair> {
        let mut pairs = Vec::with_capacity(list.len());
        for (number, entry) in list.into_iter().enumerate() {
            pairs.extend(of(self, number, entry));
            if self.faults.len() >= NAMED_FAULTS {
                break;
            }
        }
        pairs
    }

    /// The place of an input.
    fn take(&mut self, name: &str, input: SubmittedInputDocument) -> Option<usize> {
        let key = (input.mesh_id.clone(), input.upload.clone());
        let has_name = input.content_base64.is_none();
        if let Some(place) = self.places.get(&key).filter(|_| has_name) {
            return Some(*place);
        }
        match referred(name, input, &self.files, &self.state.limits) {
            Ok(input) => self.taken.push(input),
            Err(faults) => {
                self.faults.extend(faults);
                return None;
            }
        }
        let place = self.taken.len() - 1;
        if has_name {
            self.places.insert(key, place);
        }
        Some(place)
    }

    fn pair(&mut self, number: usize, pair: PairDocument) -> Option<BatchPair> {
        let PairDocument { source, target, external_ref, tags, labels } = pair;
        let source = self.take(&format!("pairs/{number}/source"), source);
        let target = self.take(&format!("pairs/{number}/target"), target);
        self.described(number, [source, target], external_ref, tags, labels)
    }

    fn subject(&mut self, number: usize, subject: SubjectDocument, template: Option<usize>) -> Option<BatchPair> {
        let SubjectDocument { input, external_ref, tags, labels } = subject;
        let input = self.take(&format!("subjects/{number}/input"), input);
        let inputs = if self.form == Form::TemplateAsSource { [template, input] } else { [input, template] };
        self.described(number, inputs, external_ref, tags, labels)
    }

    /// A pair whose fields are within their limits.
    fn described(
        &mut self,
        number: usize,
        [source, target]: [Option<usize>; 2],
        external_ref: Option<String>,
        tags: SentTags,
        labels: SentTags,
    ) -> Option<BatchPair> {
        let job = self.form.job(number);
        let mut fault = |field: &str, allowed: String| {
            self.faults.push(FieldError::new(format!("{job}/{field}"), "out_of_range", allowed));
        };
        let external_ref = ExternalRef::new(external_ref.unwrap_or_default())
            .map_err(|refused| fault("external_ref", refused.to_string()));
        let tags = tags_of(tags, labels).map_err(|(name, allowed)| fault(name, allowed));
        let (Some(source), Some(target), Ok(external_ref), Ok(tags)) = (source, target, external_ref, tags) else {
            return None;
        };
        Some(BatchPair { source, target, external_ref, tags })
    }
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
        Ok(Snapshot { version: version(document)?, body, is_final: batch.is_finished(), memory: None })
    }

    async fn follow(&self) -> Result<Arc<Feed<Batch>>, Problem> {
        Ok(self.service.follow_batch(&self.tenant, self.id).await?)
    }

    fn version(&self, seen: &Batch) -> Result<Version, Problem> {
        version(BatchDocument::from(seen))
    }
}

/// The version of a batch. Progress: the counts. State: all other members, such as whether the batch is finished.
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
