//! `/v1/batches`: many jobs submitted in one request.

use super::jobs::{cancel_all, job_list};
use super::{NAMED_FAULTS, accepted, taken};
use crate::http::call::{AuthorizedRequest, PageOf};
use crate::http::fields::Fields;
use crate::http::input_wire::{SubmittedInputDocument, input, maybe_input};
use crate::http::long_poll::{Resource, Snapshot, Version, Watched, watch};
use crate::http::options::submission_document;
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::state::HttpState;
use crate::http::strict_json::{SentTags, objects, tags_of};
use crate::http::submission::{SentFiles, check_options, referred};
use crate::http::upload::LimitedBody;
use crate::http::wire::{BatchDocument, BatchListDocument, BulkCancelDocument, JobListDocument};
use crate::jobs::follow::Feed;
use crate::jobs::job::Cursor;
use crate::jobs::metadata::ExternalRef;
use crate::jobs::{
    Accepted, Batch, BatchForm as Form, BatchId, BatchPair, BatchSubmission, JobFilter, Order, SubmittedInput,
};
use async_trait::async_trait;
use axum::extract::Request;
use axum::response::Response;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;
use utoipa::ToSchema;

submission_document! {
    /// A batch: either `template` and `subjects`, or `pairs`.
    struct BatchSubmissionDocument {
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
    } options {
        parameters: "Parameters of all jobs.",
        tags: "Tags of the batch and of every job.",
        external_ref: "The client's own id of the batch.",
        priority: "Jobs with a higher priority run first.",
        max_run_s: "Longest run time of a job, s, up to the limit of the service.",
        deadline_at: "A job expires if it has not started by this time.",
        use_cache: "Whether the result of an equal job may be returned; true if absent."
    }
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
    post, path = "/v1/batches",
    request_body(content((BatchForm = "multipart/form-data"), (BatchSubmissionDocument = "application/json"))),
    responses((status = 202, description = "Accepted", body = BatchDocument))
)]
pub(crate) async fn submit(call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let Accepted { made, replayed } = taken(call, request, take).await?;
    let document = BatchDocument::from(&made);
    Ok(marked(accepted(&document.links.batch.clone(), document), replayed))
}

async fn take(call: &AuthorizedRequest, request: Request, tap: &LimitedBody) -> Result<Accepted<Batch>, Problem> {
    let AuthorizedRequest { state, tenant, headers, .. } = call;
    let idempotency_key = idempotency_key(headers)?;
    let (mut document, files): (BatchSubmissionDocument, _) = call.document(request, tap).await?;
    let (parameters, mut details) = check_options(document.take_options(), state)?;
    let BatchSubmissionDocument { template, template_as, subjects, pairs, .. } = document;
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
    let (tenant, inputs) = (tenant.clone(), inputs.taken);
    let submission = BatchSubmission { tenant, inputs, form, pairs, parameters, details, idempotency_key };
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
#[utoipa::path(get, path = "/v1/batches", responses((status = 200, description = "A page", body = BatchListDocument)))]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let PageOf { size, after, fields } = call.last_page::<_, BatchDocument>(Cursor::from_token)?;
    let page = call.service().batches(&call.tenant, size, after).await?;
    let batches = page.batches.iter().map(BatchDocument::from).collect();
    let next_page_token = page.next.map(|cursor| cursor.to_token());
    fields.answer(&BatchListDocument { batches, next_page_token }, "batches")
}

/// Get a batch
///
/// With `wait` the answer is delayed until the batch has changed, as for a job. The end of the last job is answered at
/// once, other changes of the counts one second after the request at the earliest. A finished batch is answered at once.
#[utoipa::path(
    get, path = "/v1/batches/{id}",
    responses((status = 200, description = "The batch, with the number of its jobs in each state", body = BatchDocument))
)]
pub(crate) async fn get(call: AuthorizedRequest) -> Result<Response, Problem> {
    watch::<BatchId, BatchDocument>(call, Fields::all).await
}

#[async_trait]
impl Resource for Watched<BatchId, BatchDocument> {
    type Seen = Batch;

    async fn look(&self) -> Result<Snapshot, Problem> {
        let batch = self.call.service().batch(&self.call.tenant, self.id).await?;
        let document = BatchDocument::from(&batch);
        let body = self.fields.json(&document)?;
        Ok(Snapshot { version: version(document)?, body, is_final: batch.is_finished(), memory: None })
    }

    async fn follow(&self) -> Result<Arc<Feed<Batch>>, Problem> {
        Ok(self.call.service().follow_batch(&self.call.tenant, self.id).await?)
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
    get, path = "/v1/batches/{id}/jobs",
    responses((status = 200, description = "A page, in the order of submission", body = JobListDocument))
)]
pub(crate) async fn jobs(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let page = call.last_page(Cursor::from_token)?;
    let filter = jobs_of(&call).await?;
    job_list(&call, page, &filter, Order::OldestFirst).await
}

/// The jobs of the batch in the path.
async fn jobs_of(call: &AuthorizedRequest) -> Result<JobFilter, Problem> {
    let batch = call.service().batch(&call.tenant, call.id()?).await?;
    Ok(JobFilter { batch_id: Some(batch.id), ..JobFilter::default() })
}

/// Cancel a batch
///
/// Cancels all its unfinished jobs: queued ones at once, running ones within a second.
#[utoipa::path(
    post, path = "/v1/batches/{id}/cancel",
    responses((status = 202, description = "Cancellation requested", body = BulkCancelDocument))
)]
pub(crate) async fn cancel(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    call.query.finish()?;
    cancel_all(&call, &jobs_of(&call).await?).await
}
