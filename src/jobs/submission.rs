//! Submissions: one job, a retry, a batch. Checked first, then stored, then answered.

use super::admission::{Admission, Made, Once, OnceStatus};
use super::batch::{Batch, BatchId, NewBatch};
use super::engine::{InputRefusal, InputSummary, ParameterFault, Resolved};
use super::error::JobError;
use super::job::{Job, JobId, JobInput, NewJob, Tenant};
use super::mesh::CheckOutcome;
use super::ports::ArtifactKey;
use super::service::JobService;
use bytes::Bytes;
use jiff::Timestamp;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::time::Duration;

/// How long a submission may take between writing its blobs and storing its job.
const HOLD: Duration = Duration::from_secs(600);
/// How long checking and storing a request with an idempotency key may take before another may take its place: the
/// process that had it may have died.
const BUSY: Duration = Duration::from_secs(240);
/// Faults of a batch that are named; more say nothing new.
const NAMED_FAULTS: usize = 16;

/// A job to be accepted.
#[derive(Debug, Clone)]
pub struct Submission {
    /// Owner.
    pub tenant: Tenant,
    /// The surface that moves.
    pub source: SubmittedInput,
    /// The surface that stays.
    pub target: SubmittedInput,
    /// Parameters as asked for.
    pub parameters: Value,
    /// The rest.
    pub details: Details,
    /// The submitter's idempotency key.
    pub idempotency_key: Option<String>,
}

/// What a submission says besides inputs and parameters.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Details {
    /// −100 to 100, higher first.
    pub priority: i32,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name for it.
    pub external_ref: Option<String>,
    /// When it is too late to begin.
    pub deadline_at: Option<Timestamp>,
    /// Longest run.
    pub max_run_ms: Option<u64>,
    /// Whether it must be computed, also where an equal job has a result.
    pub compute_anew: bool,
    /// W3C trace context.
    pub traceparent: Option<String>,
}

/// An input: sent along, or uploaded before.
#[derive(Debug, Clone)]
pub enum SubmittedInput {
    /// Sent along.
    File(SubmittedFile),
    /// Uploaded before: the hash of its content.
    Mesh(String),
}

/// A file that is sent along.
#[derive(Debug, Clone)]
pub struct SubmittedFile {
    /// All of it.
    pub bytes: Bytes,
    /// The endings of its name.
    pub name_hint: Option<String>,
}

/// A batch to be accepted.
#[derive(Debug, Clone)]
pub struct BatchSubmission {
    /// Owner.
    pub tenant: Tenant,
    /// Its jobs.
    pub pairs: Vec<BatchPair>,
    /// Parameters of all of them.
    pub parameters: Value,
    /// Of all of them; labels are joined with those of each pair.
    pub details: Details,
    /// The submitter's idempotency key.
    pub idempotency_key: Option<String>,
}

/// A job of a batch: hashes of uploads.
#[derive(Debug, Clone)]
pub struct BatchPair {
    /// The surface that moves.
    pub source: String,
    /// The surface that stays.
    pub target: String,
    /// The submitter's own name for the job.
    pub external_ref: Option<String>,
    /// Its own marks.
    pub labels: BTreeMap<String, String>,
}

/// What a submission was answered.
#[derive(Debug, Clone, PartialEq)]
pub struct Accepted<T> {
    /// What was made.
    pub made: T,
    /// Whether an earlier request with the same key had made it.
    pub replayed: bool,
}

/// What a submission that is only tried would do.
#[derive(Debug, Clone, PartialEq)]
pub struct Validated {
    /// Its effective parameters.
    pub resolved: Resolved,
    /// What checking the source found.
    pub source: InputSummary,
    /// What checking the target found.
    pub target: InputSummary,
}

/// Why a job is not accepted.
#[derive(Debug, thiserror::Error)]
pub enum SubmitError {
    /// The parameters are not right.
    #[error("{} faults in the parameters", .0.len())]
    Parameters(Vec<ParameterFault>),
    /// An input is not right.
    #[error("{input}: {}", refusal.detail)]
    Input {
        /// `source` or `target`.
        input: &'static str,
        /// Why.
        refusal: InputRefusal,
    },
    /// Both inputs are right, but not together.
    #[error("{}", .0.detail)]
    Pair(InputRefusal),
    /// Some jobs of a batch are not right: the number of each, and why.
    #[error("{} jobs of the batch are not right", .0.len())]
    Batch(Vec<(usize, &'static str, InputRefusal)>),
    /// More jobs than a batch may have.
    #[error("a batch has at most {limit} jobs")]
    BatchTooLarge {
        /// Most jobs.
        limit: usize,
    },
    /// Too many inputs are being checked.
    #[error("too many inputs are being checked")]
    Busy,
    /// A check ended in a panic.
    #[error("checking {input} failed")]
    CheckFailed {
        /// `source` or `target`.
        input: &'static str,
    },
    /// The same request is being worked on.
    #[error("a request with this idempotency key is in progress")]
    InProgress,
    /// Another request came with the same key.
    #[error("another request was made with this idempotency key")]
    OtherRequest,
    /// The store.
    #[error(transparent)]
    Job(#[from] JobError),
}

/// An input that was checked.
struct CheckedInput {
    key: ArtifactKey,
    n_bytes: u64,
    name_hint: Option<String>,
    summary: InputSummary,
    /// To be written; absent for what was uploaded before.
    bytes: Option<Bytes>,
}

impl CheckedInput {
    fn record(&self) -> JobInput {
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
    /// Accepts a job: checks parameters and both inputs, stores the blobs, then the job. On return it is durable.
    ///
    /// # Errors
    /// [`SubmitError`].
    pub async fn submit(&self, submission: Submission) -> Result<Accepted<Job>, SubmitError> {
        let tenant = submission.tenant.clone();
        let once = submission.idempotency_key.as_ref().map(|key| self.once(&tenant, key, fingerprint(&submission)));
        if let Some(made) = self.begin_once(once.as_ref()).await? {
            let Made::Job(id) = made else { return Err(SubmitError::OtherRequest) };
            let made = self.stores.jobs.get(&tenant, id).await?.as_accepted();
            return Ok(Accepted { made, replayed: true });
        }
        let done = self.submit_once(submission, once.clone()).await;
        self.end_once(once.as_ref(), done).await.map(|made| Accepted { made, replayed: false })
    }

    async fn submit_once(&self, submission: Submission, once: Option<Once>) -> Result<Job, SubmitError> {
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

    /// Makes a new job of a finished one, with the same inputs and parameters. It is computed anew.
    ///
    /// # Errors
    /// [`JobError::StillActive`]; [`JobError::Gone`] if the inputs were removed.
    pub async fn retry(&self, tenant: &Tenant, id: JobId, traceparent: Option<String>) -> Result<Job, SubmitError> {
        let first = self.stores.jobs.get(tenant, id).await?;
        if !first.state.is_final() {
            return Err(JobError::StillActive { state: first.state }.into());
        }
        if first.purged_at.is_some() {
            return Err(JobError::Gone.into());
        }
        self.refuse_when_full(tenant).await?;
        let job = NewJob {
            id: JobId::new(),
            tenant: tenant.clone(),
            method: first.method,
            method_version: first.method_version,
            parameters: first.parameters,
            source: first.source,
            target: first.target,
            priority: first.priority,
            labels: first.labels,
            external_ref: first.external_ref,
            max_attempts: self.limits.max_attempts,
            deadline_at: None,
            max_run_ms: first.max_run_ms,
            retry_of: Some(id),
            batch_id: None,
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
        let done = self.submit_batch_once(submission, once.clone()).await;
        self.end_once(once.as_ref(), done).await.map(|made| Accepted { made, replayed: false })
    }

    async fn submit_batch_once(&self, submission: BatchSubmission, once: Option<Once>) -> Result<Batch, SubmitError> {
        let BatchSubmission { tenant, pairs, parameters, details, .. } = submission;
        if pairs.len() > self.limits.max_batch {
            return Err(SubmitError::BatchTooLarge { limit: self.limits.max_batch });
        }
        let resolved = self.engine.resolve(&parameters).map_err(SubmitError::Parameters)?;
        self.refuse_when_full(&tenant).await?;
        // Each upload is checked once, in however many pairs it stands.
        let mut checked: BTreeMap<String, Result<CheckedInput, InputRefusal>> = BTreeMap::new();
        let mut faults = Vec::new();
        for (number, pair) in pairs.iter().enumerate() {
            for (side, hash) in [("source", &pair.source), ("target", &pair.target)] {
                if !checked.contains_key(hash) {
                    let input = SubmittedInput::Mesh(hash.clone());
                    let found = match self.check(&tenant, side, input, &resolved).await {
                        Ok(input) => Ok(input),
                        Err(SubmitError::Input { refusal, .. }) => Err(refusal),
                        Err(SubmitError::Job(JobError::MeshNotFound)) => Err(InputRefusal {
                            code: "mesh-not-found".to_owned(),
                            detail: "no such mesh".to_owned(),
                            topology: None,
                        }),
                        Err(error) => return Err(error),
                    };
                    checked.insert(hash.clone(), found);
                }
                if let Some(Err(refusal)) = checked.get(hash) {
                    faults.push((number, side, refusal.clone()));
                }
            }
            if faults.len() >= NAMED_FAULTS {
                break;
            }
        }
        let id = BatchId::random();
        let mut jobs = Vec::new();
        for (number, pair) in pairs.iter().enumerate() {
            let (Some(Ok(source)), Some(Ok(target))) = (checked.get(&pair.source), checked.get(&pair.target)) else {
                continue;
            };
            if let Err(refusal) = self.engine.check_pair(&source.summary, &target.summary, &resolved.parameters) {
                faults.push((number, "target", refusal));
            }
            let mut labels = details.labels.clone();
            labels.extend(pair.labels.clone());
            let own = Details { labels, external_ref: pair.external_ref.clone(), ..details.clone() };
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
            labels: details.labels.clone(),
            external_ref: details.external_ref.clone(),
        };
        let holder = id.to_string();
        let keys: Vec<ArtifactKey> = checked.into_values().flatten().map(|input| input.key).collect();
        let admission = self.admission(&holder, once);
        let stored = async {
            self.stores.jobs.hold_blobs(&holder, &keys, HOLD, None).await?;
            for key in &keys {
                // Held from here on; a removal before would have taken the record with it.
                self.stores.meshes.get_mesh(&tenant, key.hash()).await?;
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
        self.engine.check_pair(&source.summary, &target.summary, &resolved.parameters).map_err(SubmitError::Pair)?;
        Ok((resolved, source, target))
    }

    async fn check(
        &self,
        tenant: &Tenant,
        input: &'static str,
        submitted: SubmittedInput,
        resolved: &Resolved,
    ) -> Result<CheckedInput, SubmitError> {
        match submitted {
            SubmittedInput::File(file) => {
                let key = ArtifactKey::of(tenant, &file.bytes);
                let (n_bytes, name_hint) = (file.bytes.len() as u64, file.name_hint.clone());
                let bytes = Some(file.bytes.clone());
                let summary = match self.inspect(input, file, resolved).await? {
                    CheckOutcome::Fit(summary) => summary,
                    CheckOutcome::Unfit(refusal) => return Err(SubmitError::Input { input, refusal }),
                };
                Ok(CheckedInput { key, n_bytes, name_hint, summary, bytes })
            }
            SubmittedInput::Mesh(hash) => {
                let mesh = self.stores.meshes.get_mesh(tenant, &hash).await?;
                let summary = match self.check_mesh(&mesh, input, resolved).await? {
                    CheckOutcome::Fit(summary) => summary,
                    CheckOutcome::Unfit(refusal) => return Err(SubmitError::Input { input, refusal }),
                };
                Ok(CheckedInput {
                    key: mesh.key,
                    n_bytes: mesh.n_bytes,
                    name_hint: mesh.name_hint,
                    summary,
                    bytes: None,
                })
            }
        }
    }

    fn new_job(
        &self,
        tenant: &Tenant,
        resolved: &Resolved,
        [source, target]: [&CheckedInput; 2],
        details: &Details,
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
            labels: details.labels.clone(),
            external_ref: details.external_ref.clone(),
            max_attempts: self.limits.max_attempts,
            deadline_at: details.deadline_at,
            max_run_ms: details.max_run_ms,
            retry_of: None,
            batch_id: None,
            use_cache: !details.compute_anew,
            traceparent: details.traceparent.clone(),
        }
    }

    /// Stores a job and what it was sent with.
    async fn store_job(&self, job: NewJob, inputs: Vec<CheckedInput>, once: Option<Once>) -> Result<Job, SubmitError> {
        let holder = job.id.to_string();
        let keys: Vec<ArtifactKey> = [&job.source, &job.target]
            .into_iter()
            .filter_map(|input| ArtifactKey::of_hash(&job.tenant, &input.hash))
            .collect();
        let admission = self.admission(&holder, once);
        let stored = async {
            // The hold comes before the blobs: a removal that runs meanwhile leaves them alone.
            self.stores.jobs.hold_blobs(&holder, &keys, HOLD, None).await?;
            for input in inputs {
                match input.bytes {
                    Some(bytes) => self.stores.artifacts.put(&input.key, bytes).await?,
                    // Held from here on; a removal before would have taken the record with it.
                    None => self.stores.meshes.get_mesh(&job.tenant, input.key.hash()).await.map(|_| ())?,
                }
            }
            if let Some(first) = job.retry_of {
                // Likewise: its blobs are there as long as it refers to them.
                let kind = super::ports::ArtifactKind::Source;
                self.stores.jobs.artifact(&job.tenant, first, kind).await?;
            }
            self.stores.jobs.insert(&job, &admission).await
        };
        let stored = stored.await;
        self.after_storing(&holder, stored).await
    }

    /// Wakes workers, or ends the hold of what was not stored.
    async fn after_storing<T>(&self, holder: &str, stored: Result<T, JobError>) -> Result<T, SubmitError> {
        match stored {
            Ok(stored) => {
                self.signals.queued.notify_one();
                self.stores.jobs.give_hint().await;
                Ok(stored)
            }
            Err(error) => {
                // The hold lapses by itself if this does not succeed either.
                if self.stores.jobs.drop_hold(holder).await.is_ok() {
                    let _ = self.remove_unreferenced_blobs().await;
                }
                Err(error.into())
            }
        }
    }

    fn admission(&self, holder: &str, once: Option<Once>) -> Admission {
        Admission {
            max_queued: self.limits.max_queued,
            holder: holder.to_owned(),
            keep_result: self.limits.keep_results,
            once,
        }
    }

    fn once(&self, tenant: &Tenant, name: &str, fingerprint: String) -> Once {
        Once {
            tenant: tenant.clone(),
            name: name.to_owned(),
            fingerprint,
            token: uuid::Uuid::new_v4().to_string(),
            keep_for: self.limits.once_for,
        }
    }

    /// What an earlier request with the key made; `None` to go on.
    async fn begin_once(&self, once: Option<&Once>) -> Result<Option<Made>, SubmitError> {
        let Some(once) = once else { return Ok(None) };
        match self.stores.jobs.begin_once(once, BUSY).await? {
            OnceStatus::Begun => Ok(None),
            OnceStatus::InProgress => Err(SubmitError::InProgress),
            OnceStatus::OtherRequest => Err(SubmitError::OtherRequest),
            OnceStatus::Made(made) => Ok(Some(made)),
        }
    }

    /// Frees the key of a request that made nothing, so that it can be sent again, corrected.
    async fn end_once<T>(&self, once: Option<&Once>, done: Result<T, SubmitError>) -> Result<T, SubmitError> {
        if let (Err(_), Some(once)) = (&done, once) {
            // What was made after all, though the answer got lost, keeps its key: nothing is given up then.
            let _ = self.stores.jobs.give_up_once(once).await;
        }
        done
    }
}

/// Hash of all that a request says; `serde_json` writes the members of objects in one order.
fn hash_of(value: &Value) -> String {
    blake3::hash(value.to_string().as_bytes()).to_hex().to_string()
}

fn details_value(details: &Details) -> Value {
    json!([
        details.priority,
        details.labels,
        details.external_ref,
        details.deadline_at,
        details.max_run_ms,
        details.compute_anew,
    ])
}

fn fingerprint(submission: &Submission) -> String {
    let input = |input: &SubmittedInput| match input {
        SubmittedInput::File(file) => json!([blake3::hash(&file.bytes).to_hex().as_str(), file.name_hint]),
        SubmittedInput::Mesh(hash) => json!(hash),
    };
    let details = details_value(&submission.details);
    hash_of(&json!([input(&submission.source), input(&submission.target), submission.parameters, details]))
}

fn fingerprint_of_batch(submission: &BatchSubmission) -> String {
    let pair = |pair: &BatchPair| json!([pair.source, pair.target, pair.external_ref, pair.labels]);
    let pairs: Vec<Value> = submission.pairs.iter().map(pair).collect();
    hash_of(&json!([pairs, submission.parameters, details_value(&submission.details)]))
}

/// Equal keys have equal results: the key names all that a result depends on.
fn cache_key(resolved: &Resolved, source: &JobInput, target: &JobInput) -> String {
    let input = |input: &JobInput| json!([input.hash, input.name_hint]);
    let Resolved { method, result_version, parameters, .. } = resolved;
    hash_of(&json!([method, result_version, parameters, input(source), input(target)]))
}
