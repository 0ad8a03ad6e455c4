//! Submissions: a job, a retry, a batch. Each is checked first, then stored, then answered.

use super::admission::{Admission, IdempotencyKey, Made, OnceStatus};
use super::artifact::{ArtifactKey, ArtifactKind, BLOB_HOLD};
use super::batch::{Batch, NewBatch};
use super::engine::{ParameterFault, Resolved};
use super::error::JobError;
use super::ids::{BatchId, JobId};
use super::input_check::{InputRefusal, InputSummary};
use super::job::{Job, JobInput, NewJob, Tenant};
use super::mesh::{CheckOutcome, Mesh};
use super::metadata::{ExternalRef, MetadataFault, Tags};
use super::service::JobService;
use super::study::StudyFault;
use bytes::Bytes;
use jiff::Timestamp;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::time::Duration;

/// How long an idempotency key stays reserved for the request that is carried out. The process extends it as long as it lives;
/// when it has ended in the middle, another request may take the key this soon.
pub(crate) const BUSY: Duration = Duration::from_secs(10);
/// How often it is extended.
const EXTENDED_EVERY: Duration = Duration::from_secs(3);
/// Maximum number of faults of a batch that are reported.
const NAMED_FAULTS: usize = 16;

/// A job to be submitted.
#[derive(Debug, Clone)]
pub struct Submission {
    /// Owner.
    pub tenant: Tenant,
    /// The surface that is moved.
    pub source: SubmittedInput,
    /// The surface that stays fixed.
    pub target: SubmittedInput,
    /// Parameters as requested.
    pub parameters: Value,
    /// Everything else.
    pub details: JobOptions,
    /// The submitter's idempotency key.
    pub idempotency_key: Option<String>,
}

/// Options of a submission besides inputs and parameters.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct JobOptions {
    /// −100 to 100, higher first.
    pub priority: i32,
    /// Tags of the submitter.
    pub tags: Tags,
    /// The submitter's own identifier.
    pub external_ref: Option<ExternalRef>,
    /// Deadline for its start.
    pub deadline_at: Option<Timestamp>,
    /// Maximum run time, ms.
    pub max_run_ms: Option<u64>,
    /// Whether it must be computed even if an equal job has a result.
    pub compute_anew: bool,
    /// W3C trace context.
    pub traceparent: Option<String>,
}

/// An input: sent with the submission, or uploaded before.
#[derive(Debug, Clone)]
pub enum SubmittedInput {
    /// Sent with the submission.
    File(SubmittedFile),
    /// Instances of one DICOM series, sent with the submission as several files.
    Series(Vec<Bytes>),
    /// Uploaded before; the hash of its content.
    Mesh(String),
}

/// A file sent with a submission.
#[derive(Debug, Clone)]
pub struct SubmittedFile {
    /// Its content.
    pub bytes: Bytes,
    /// Extensions of its file name.
    pub name_hint: Option<String>,
}

/// A batch to be submitted.
#[derive(Debug, Clone)]
pub struct BatchSubmission {
    /// Owner.
    pub tenant: Tenant,
    /// Inputs of its jobs; an input that several jobs have is here once.
    pub inputs: Vec<SubmittedInput>,
    /// How its jobs were written.
    pub form: BatchForm,
    /// Its jobs.
    pub pairs: Vec<BatchPair>,
    /// Parameters of all of them.
    pub parameters: Value,
    /// Details of all of them; the tags of each pair are added.
    pub details: JobOptions,
    /// The submitter's idempotency key.
    pub idempotency_key: Option<String>,
}

/// How a batch was written, by which its faults are named.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BatchForm {
    /// A list of pairs.
    Pairs,
    /// Subjects that are moved onto a template.
    TemplateAsTarget,
    /// Subjects onto which a template is moved.
    TemplateAsSource,
}

impl BatchForm {
    /// The JSON pointer of a job.
    pub fn job(self, number: usize) -> String {
        let list = if self == BatchForm::Pairs { "pairs" } else { "subjects" };
        format!("/{list}/{number}")
    }

    /// The JSON pointer of an input, `source` or `target`, of a job.
    pub fn input(self, number: usize, side: &str) -> String {
        match (self, side) {
            (BatchForm::Pairs, side) => format!("/pairs/{number}/{side}"),
            (BatchForm::TemplateAsTarget, "target") | (BatchForm::TemplateAsSource, "source") => "/template".to_owned(),
            _ => format!("/subjects/{number}/input"),
        }
    }
}

/// A job of a batch.
#[derive(Debug, Clone)]
pub struct BatchPair {
    /// The surface that is moved: its place in the inputs of the batch.
    pub source: usize,
    /// The surface that stays fixed: its place in the inputs of the batch.
    pub target: usize,
    /// The submitter's own identifier of the job.
    pub external_ref: Option<ExternalRef>,
    /// Its own tags.
    pub tags: Tags,
}

/// The answer to a submission.
#[derive(Debug, Clone, PartialEq)]
pub struct Accepted<T> {
    /// The job or the batch.
    pub made: T,
    /// Whether an earlier request with the same idempotency key created it.
    pub replayed: bool,
}

/// The outcome of checking a submission without storing it.
#[derive(Debug, Clone)]
pub struct Validated {
    /// Its effective parameters.
    pub resolved: Resolved,
    /// Outcome of the check of the source.
    pub source: InputSummary,
    /// Outcome of the check of the target.
    pub target: InputSummary,
}

/// Why a job is not accepted.
#[derive(Debug, thiserror::Error)]
pub enum SubmitError {
    /// The parameters have faults.
    #[error("{} faults in the parameters", .0.len())]
    Parameters(Vec<ParameterFault>),
    /// An input cannot be matched.
    #[error("{input}: {}", refusal.detail)]
    Input {
        /// `source` or `target`.
        input: &'static str,
        /// Why.
        refusal: InputRefusal,
    },
    /// Each input could be matched, but not this pair.
    #[error("{}", .0.detail)]
    Pair(InputRefusal),
    /// Some inputs of a batch cannot be matched: the JSON pointer of each, and why.
    #[error("{} inputs of the batch are not right", .0.len())]
    Batch(Vec<(String, InputRefusal)>),
    /// Who is in a study, or what is asked, is wrong, or inputs of it cannot be matched.
    #[error("{} faults of the study", .0.len())]
    Study(Vec<StudyFault>),
    /// Tags or references beyond their limits: of one job of a batch, by its index, or of the job.
    #[error("{fault}")]
    Metadata {
        /// JSON pointer of the job in its batch; empty for a job of its own.
        job: String,
        /// Why.
        fault: MetadataFault,
    },
    /// The batch has too many jobs.
    #[error("a batch has at most {limit} jobs")]
    BatchTooLarge {
        /// Maximum number of jobs.
        limit: usize,
    },
    /// Too many inputs are being checked at the moment.
    #[error("too many inputs are being checked")]
    Busy,
    /// The check of an input panicked.
    #[error("checking {input} failed")]
    CheckFailed {
        /// `source` or `target`.
        input: &'static str,
    },
    /// The same request is in progress.
    #[error("a request with this idempotency key is in progress")]
    InProgress,
    /// The key was used for another request.
    #[error("another request was made with this idempotency key")]
    OtherRequest,
    /// An error of the stores.
    #[error(transparent)]
    Job(#[from] JobError),
}

/// An input that has passed its check.
pub(super) struct CheckedInput {
    pub(super) key: ArtifactKey,
    pub(super) n_bytes: u64,
    name_hint: Option<String>,
    summary: InputSummary,
    /// Content to be stored; `None` for what was uploaded before.
    pub(super) bytes: Option<Bytes>,
}

impl CheckedInput {
    /// Its form in the record of a job.
    pub(super) fn record(&self) -> JobInput {
        JobInput {
            hash: self.key.hash().to_owned(),
            n_bytes: self.n_bytes,
            name_hint: self.name_hint.clone(),
            n_vertices: self.summary.n_vertices,
            n_faces: self.summary.n_faces,
            report: self.summary.report.clone(),
        }
    }
}

impl JobService {
    /// Accepts a job: checks its parameters and inputs, stores its blobs and then the job. When this returns, the job survives a
    /// loss of power.
    ///
    /// # Errors
    /// [`SubmitError`].
    pub async fn submit(&self, submission: Submission) -> Result<Accepted<Job>, SubmitError> {
        let tenant = submission.tenant.clone();
        let once = submission.idempotency_key.as_ref().map(|key| self.once(&tenant, key, fingerprint(&submission)));
        if let Some(made) = self.begin_once(once.as_ref()).await? {
            let Made::Job(id) = made else { return Err(SubmitError::OtherRequest) };
            let made = self.forecast.of(self.stores.jobs.get_job(&tenant, id).await?.as_accepted());
            return Ok(Accepted { made, replayed: true });
        }
        let done = self.keeping(once.as_ref(), self.submit_once(submission, once.clone())).await;
        self.end_once(once.as_ref(), done).await.map(|made| Accepted { made, replayed: false })
    }

    async fn submit_once(&self, submission: Submission, once: Option<IdempotencyKey>) -> Result<Job, SubmitError> {
        let Submission { tenant, source, target, parameters, details, .. } = submission;
        let (resolved, source, target) = self.check_all(&tenant, source, target, &parameters).await?;
        let inputs = [source, target];
        let job = self.new_job(&tenant, &resolved, [&inputs[0], &inputs[1]], &details);
        let [source, target] = inputs;
        self.store_job(job, vec![source, target], once).await
    }

    /// Checks a submission and stores nothing.
    ///
    /// # Errors
    /// [`SubmitError`].
    pub async fn validate(&self, submission: Submission) -> Result<Validated, SubmitError> {
        let Submission { tenant, source, target, parameters, .. } = submission;
        let (resolved, source, target) = self.check_all(&tenant, source, target, &parameters).await?;
        Ok(Validated { resolved, source: source.summary, target: target.summary })
    }

    /// Submits a finished job again, with the same inputs and parameters. It is computed again.
    ///
    /// # Errors
    /// [`JobError::StillActive`]; [`JobError::Gone`] if the inputs were removed.
    pub async fn retry(&self, tenant: &Tenant, id: JobId, traceparent: Option<String>) -> Result<Job, SubmitError> {
        let first = self.stores.jobs.get_job(tenant, id).await?;
        if !first.state.is_final() {
            return Err(JobError::StillActive { state: first.state }.into());
        }
        if first.purged_at.is_some() {
            return Err(JobError::Gone.into());
        }
        self.refuse_when_full(tenant).await?;
        let is_score = first.is_score();
        // An earlier version may have stored what is not allowed any more.
        let refused = |fault| SubmitError::Metadata { job: String::new(), fault };
        let tags = Tags::new(first.tags).map_err(refused)?;
        let external_ref = ExternalRef::new(first.external_ref.unwrap_or_default()).map_err(refused)?;
        let job = NewJob {
            id: JobId::new(),
            tenant: tenant.clone(),
            method: first.method,
            method_version: first.method_version,
            parameters: first.parameters,
            source: first.source,
            target: first.target,
            priority: first.priority,
            tags,
            external_ref,
            max_attempts: self.limits.max_attempts,
            deadline_at: None,
            max_run_ms: first.max_run_ms,
            retry_of: Some(id),
            batch_id: None,
            // A score is nothing without its study; the match of a study is repeated by itself.
            study_id: first.study_id.filter(|_| is_score),
            study_task: None,
            cache_key: None,
            use_cache: false,
            traceparent,
        };
        self.store_job(job, Vec::new(), None).await
    }

    /// Accepts a batch: all of its jobs, or none.
    ///
    /// # Errors
    /// [`SubmitError`].
    pub async fn submit_batch(&self, submission: BatchSubmission) -> Result<Accepted<Batch>, SubmitError> {
        let tenant = submission.tenant.clone();
        let print = fingerprint_of_batch(&submission);
        let once = submission.idempotency_key.as_ref().map(|key| self.once(&tenant, key, print));
        if let Some(made) = self.begin_once(once.as_ref()).await? {
            let Made::Batch(id) = made else { return Err(SubmitError::OtherRequest) };
            return Ok(Accepted { made: self.stores.jobs.get_batch(&tenant, id).await?, replayed: true });
        }
        let done = self.keeping(once.as_ref(), self.submit_batch_once(submission, once.clone())).await;
        self.end_once(once.as_ref(), done).await.map(|made| Accepted { made, replayed: false })
    }

    async fn submit_batch_once(
        &self,
        submission: BatchSubmission,
        once: Option<IdempotencyKey>,
    ) -> Result<Batch, SubmitError> {
        let BatchSubmission { tenant, inputs, form, pairs, parameters, details, .. } = submission;
        if pairs.len() > self.limits.max_batch {
            return Err(SubmitError::BatchTooLarge { limit: self.limits.max_batch });
        }
        let resolved = self.engine.resolve(&parameters).map_err(SubmitError::Parameters)?;
        self.refuse_when_full(&tenant).await?;
        // Each input is checked once, however many pairs contain it.
        let mut inputs: Vec<Option<SubmittedInput>> = inputs.into_iter().map(Some).collect();
        let mut checked: BTreeMap<usize, Result<CheckedInput, InputRefusal>> = BTreeMap::new();
        let mut faults = Vec::new();
        for (number, pair) in pairs.iter().enumerate() {
            for (side, place) in [("source", pair.source), ("target", pair.target)] {
                if let Some(input) = inputs.get_mut(place).and_then(Option::take) {
                    let found = match self.check(&tenant, side, input, &resolved).await {
                        Ok(input) => Ok(input),
                        Err(SubmitError::Input { refusal, .. }) => Err(refusal),
                        Err(SubmitError::Job(JobError::MeshNotFound)) => Err(InputRefusal {
                            code: "mesh-not-found".to_owned(),
                            detail: "no such mesh".to_owned(),
                            topology: None,
                            place_mm: None,
                        }),
                        Err(error) => return Err(error),
                    };
                    checked.insert(place, found);
                }
                if let Some(Err(refusal)) = checked.get(&place) {
                    let pointer = form.input(number, side);
                    // The template is in every pair.
                    if faults.iter().all(|(known, _)| *known != pointer) {
                        faults.push((pointer, refusal.clone()));
                    }
                }
            }
            if faults.len() >= NAMED_FAULTS {
                break;
            }
        }
        let id = BatchId::new();
        let mut jobs = Vec::new();
        for (number, pair) in pairs.iter().enumerate() {
            let (Some(Ok(source)), Some(Ok(target))) = (checked.get(&pair.source), checked.get(&pair.target)) else {
                continue;
            };
            if let Err(refusal) = resolved.computation.check_pair(&source.summary, &target.summary) {
                faults.push((
                    form.input(number, if form == BatchForm::TemplateAsTarget { "source" } else { "target" }),
                    refusal,
                ));
            }
            let tags = details.tags.with(&pair.tags);
            let tags = tags.map_err(|fault| SubmitError::Metadata { job: form.job(number), fault })?;
            let own = JobOptions { tags, external_ref: pair.external_ref.clone(), ..details.clone() };
            let job = self.new_job(&tenant, &resolved, [source, target], &own);
            jobs.push(NewJob { batch_id: Some(id), ..job });
        }
        if !faults.is_empty() {
            faults.truncate(NAMED_FAULTS);
            return Err(SubmitError::Batch(faults));
        }
        let batch = NewBatch {
            id,
            tenant: tenant.clone(),
            tags: details.tags.clone(),
            external_ref: details.external_ref.clone(),
        };
        let holder = id.to_string();
        // Files of equal content are one blob.
        let inputs: BTreeMap<String, CheckedInput> =
            checked.into_values().flatten().map(|input| (input.key.hash().to_owned(), input)).collect();
        let keys: Vec<ArtifactKey> = inputs.values().map(|input| input.key.clone()).collect();
        let n_bytes = inputs.values().filter_map(|input| input.bytes.as_ref()).map(|bytes| bytes.len() as u64).sum();
        self.refuse_over_share(&tenant, n_bytes).await?;
        self.note_stored(&tenant, n_bytes);
        let admission = self.admission(&tenant, &holder, once);
        let stored = async {
            self.stores.jobs.hold_blobs(&holder, &keys, BLOB_HOLD, None).await?;
            for input in inputs.into_values() {
                match input.bytes {
                    Some(bytes) => self.stores.artifacts.put(&input.key, bytes).await?,
                    // The hold protects it from here on; an earlier removal would have deleted its record.
                    None => drop(self.stores.meshes.get_mesh(&tenant, input.key.hash()).await?),
                }
            }
            self.stores.jobs.insert_batch(&batch, &jobs, &admission).await
        };
        let stored = stored.await;
        self.after_storing(&holder, stored).await
    }

    /// Resolves the parameters and checks both inputs and their pair.
    async fn check_all(
        &self,
        tenant: &Tenant,
        source: SubmittedInput,
        target: SubmittedInput,
        parameters: &Value,
    ) -> Result<(Resolved, CheckedInput, CheckedInput), SubmitError> {
        let resolved = self.engine.resolve(parameters).map_err(SubmitError::Parameters)?;
        self.refuse_when_full(tenant).await?;
        let source = self.check(tenant, "source", source, &resolved).await?;
        let target = self.check(tenant, "target", target, &resolved).await?;
        resolved.computation.check_pair(&source.summary, &target.summary).map_err(SubmitError::Pair)?;
        Ok((resolved, source, target))
    }

    pub(super) async fn check(
        &self,
        tenant: &Tenant,
        input: &'static str,
        submitted: SubmittedInput,
        resolved: &Resolved,
    ) -> Result<CheckedInput, SubmitError> {
        let file = match submitted {
            SubmittedInput::File(file) => file,
            SubmittedInput::Series(instances) => {
                let joined = self.engine.join_instances(instances);
                let bytes = joined.map_err(|refusal| SubmitError::Input { input, refusal })?;
                SubmittedFile { bytes, name_hint: None }
            }
            SubmittedInput::Mesh(hash) => {
                let mesh = self.stores.meshes.get_mesh(tenant, &hash).await?;
                let summary = fit(input, self.check_mesh(&mesh, input, resolved).await?)?;
                let Mesh { key, n_bytes, name_hint, .. } = mesh;
                return Ok(CheckedInput { key, n_bytes, name_hint, summary, bytes: None });
            }
        };
        let key = ArtifactKey::of(tenant, &file.bytes);
        let (n_bytes, name_hint) = (file.bytes.len() as u64, file.name_hint.clone());
        let bytes = Some(file.bytes.clone());
        let summary = fit(input, self.inspect(input, file, resolved).await?)?;
        Ok(CheckedInput { key, n_bytes, name_hint, summary, bytes })
    }

    fn new_job(
        &self,
        tenant: &Tenant,
        resolved: &Resolved,
        [source, target]: [&CheckedInput; 2],
        details: &JobOptions,
    ) -> NewJob {
        let (source, target) = (source.record(), target.record());
        NewJob {
            id: JobId::new(),
            tenant: tenant.clone(),
            method: resolved.method.clone(),
            method_version: resolved.method_version.clone(),
            parameters: resolved.parameters.clone(),
            cache_key: Some(cache_key(resolved, &source, &target)),
            source,
            target,
            priority: details.priority,
            tags: details.tags.clone(),
            external_ref: details.external_ref.clone(),
            max_attempts: self.limits.max_attempts,
            deadline_at: details.deadline_at,
            max_run_ms: details.max_run_ms,
            retry_of: None,
            batch_id: None,
            study_id: None,
            study_task: None,
            use_cache: !details.compute_anew,
            traceparent: details.traceparent.clone(),
        }
    }

    /// Stores the inputs of a job and then the job.
    pub(super) async fn store_job(
        &self,
        job: NewJob,
        inputs: Vec<CheckedInput>,
        once: Option<IdempotencyKey>,
    ) -> Result<Job, SubmitError> {
        let holder = job.id.to_string();
        let keys: Vec<ArtifactKey> = [&job.source, &job.target]
            .into_iter()
            .filter_map(|input| ArtifactKey::of_hash(&job.tenant, &input.hash))
            .collect();
        let n_bytes = inputs.iter().filter_map(|input| input.bytes.as_ref()).map(|bytes| bytes.len() as u64).sum();
        self.refuse_over_share(&job.tenant, n_bytes).await?;
        self.note_stored(&job.tenant, n_bytes);
        let admission = self.admission(&job.tenant, &holder, once);
        let stored = async {
            // The hold comes before the blobs, so that a concurrent removal spares them.
            self.stores.jobs.hold_blobs(&holder, &keys, BLOB_HOLD, None).await?;
            for input in inputs {
                match input.bytes {
                    Some(bytes) => self.stores.artifacts.put(&input.key, bytes).await?,
                    // The hold protects it from here on; an earlier removal would have deleted its record.
                    None => self.stores.meshes.get_mesh(&job.tenant, input.key.hash()).await.map(|_| ())?,
                }
            }
            if let Some(first) = job.retry_of {
                // The hold protects its blobs too; they exist as long as the job refers to them.
                let kind = ArtifactKind::Source;
                self.stores.jobs.get_artifact(&job.tenant, first, kind).await?;
            }
            self.stores.jobs.insert_job(&job, &admission).await
        };
        let stored = stored.await;
        self.after_storing(&holder, stored).await.map(|job| self.forecast.of(job))
    }

    /// Wakes workers if the submission was stored; releases its hold if it was not.
    pub(super) async fn after_storing<T>(&self, holder: &str, stored: Result<T, JobError>) -> Result<T, SubmitError> {
        match stored {
            Ok(stored) => {
                self.signals.queued.notify_one();
                self.stores.jobs.announce_queued().await;
                Ok(stored)
            }
            Err(error) => {
                // If this fails too, the hold lapses by itself.
                if self.stores.jobs.drop_hold(holder).await.is_ok() {
                    let _ = self.remove_unreferenced_blobs().await;
                }
                Err(error.into())
            }
        }
    }

    pub(super) fn admission(&self, tenant: &Tenant, holder: &str, once: Option<IdempotencyKey>) -> Admission {
        Admission {
            max_queued: self.limits.max_queued,
            holder: holder.to_owned(),
            keep_result: self.limits.retention.of(tenant).results,
            once,
        }
    }

    pub(super) fn once(&self, tenant: &Tenant, name: &str, fingerprint: String) -> IdempotencyKey {
        IdempotencyKey {
            tenant: tenant.clone(),
            name: name.to_owned(),
            fingerprint,
            token: uuid::Uuid::new_v4().to_string(),
            keep_for: self.limits.once_for,
        }
    }

    /// The job, batch or study that an earlier request with the key created; `None` if this request is the first.
    pub(super) async fn begin_once(&self, once: Option<&IdempotencyKey>) -> Result<Option<Made>, SubmitError> {
        let Some(once) = once else { return Ok(None) };
        match self.stores.jobs.begin_once(once, BUSY).await? {
            OnceStatus::Begun => Ok(None),
            OnceStatus::InProgress => Err(SubmitError::InProgress),
            OnceStatus::OtherRequest => Err(SubmitError::OtherRequest),
            OnceStatus::Made(made) => Ok(Some(made)),
        }
    }

    /// Carries out a request and keeps its key reserved meanwhile.
    pub(super) async fn keeping<T>(&self, once: Option<&IdempotencyKey>, work: impl Future<Output = T>) -> T {
        let Some(once) = once else { return work.await };
        let extending = async {
            loop {
                tokio::time::sleep(EXTENDED_EVERY).await;
                if let Err(error) = self.stores.jobs.extend_once(once, BUSY).await {
                    tracing::warn!(%error, "the idempotency key of a request could not be extended");
                }
            }
        };
        tokio::select! {
            done = work => done,
            () = extending => unreachable!("it goes on until the request is carried out"),
        }
    }

    /// Frees the key of a request that failed, so that the request can be corrected and sent again.
    pub(super) async fn end_once<T>(
        &self,
        once: Option<&IdempotencyKey>,
        done: Result<T, SubmitError>,
    ) -> Result<T, SubmitError> {
        if let (Err(_), Some(once)) = (&done, once) {
            // If the job was stored and only the answer of the store was lost, the key is not freed.
            let _ = self.stores.jobs.give_up_once(once).await;
        }
        done
    }
}

/// The summary of an input, unless it cannot be matched.
#[allow(clippy::result_large_err)] // moved once for each submission
fn fit(input: &'static str, outcome: CheckOutcome) -> Result<InputSummary, SubmitError> {
    match outcome {
        CheckOutcome::Fit(summary) => Ok(summary),
        CheckOutcome::Unfit(refusal) => Err(SubmitError::Input { input, refusal }),
    }
}

/// Hash of everything that a request states; `serde_json` writes the members of objects in a fixed order.
pub(super) fn hash_of(value: &Value) -> String {
    blake3::hash(value.to_string().as_bytes()).to_hex().to_string()
}

pub(super) fn details_value(details: &JobOptions) -> Value {
    json!([
        details.priority,
        details.tags,
        details.external_ref,
        details.deadline_at,
        details.max_run_ms,
        details.compute_anew,
    ])
}

pub(super) fn input_value(input: &SubmittedInput) -> Value {
    match input {
        SubmittedInput::File(file) => json!([blake3::hash(&file.bytes).to_hex().as_str(), file.name_hint]),
        SubmittedInput::Series(instances) => {
            let mut hashes: Vec<_> = instances.iter().map(|bytes| blake3::hash(bytes).to_hex().to_string()).collect();
            // Files of a series are in no order.
            hashes.sort_unstable();
            json!({"series": hashes})
        }
        SubmittedInput::Mesh(hash) => json!(hash),
    }
}

fn fingerprint(submission: &Submission) -> String {
    let details = details_value(&submission.details);
    let [source, target] = [&submission.source, &submission.target].map(input_value);
    hash_of(&json!([source, target, submission.parameters, details]))
}

fn fingerprint_of_batch(submission: &BatchSubmission) -> String {
    let inputs: Vec<Value> = submission.inputs.iter().map(input_value).collect();
    let pair =
        |pair: &BatchPair| json!([inputs.get(pair.source), inputs.get(pair.target), pair.external_ref, pair.tags]);
    let pairs: Vec<Value> = submission.pairs.iter().map(pair).collect();
    hash_of(&json!([pairs, submission.parameters, details_value(&submission.details)]))
}

/// Jobs with equal keys have equal results: the key contains everything on which a result depends.
fn cache_key(resolved: &Resolved, source: &JobInput, target: &JobInput) -> String {
    let input = |input: &JobInput| json!([input.hash, input.name_hint]);
    let Resolved { method, result_version, parameters, .. } = resolved;
    hash_of(&json!([method, result_version, parameters, input(source), input(target)]))
}
