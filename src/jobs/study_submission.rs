//! The use cases of studies: submit, read, add subjects, decide, cancel, delete.

use super::admission::Made;
use super::artifact::{ArtifactKey, ArtifactKind, ArtifactRef, BLOB_HOLD};
use super::documents::{BodySide, LabelChoice};
use super::engine::{ParameterFault, Resolved};
use super::error::JobError;
use super::ids::StudyId;
use super::input_check::InputRefusal;
use super::job::{Cursor, JobInput, Tenant};
use super::service::JobService;
use super::study::{
    DecisionVerdict, NewStudy, Study, StudyBlob, StudyChange, StudyDefinition, StudyFault, StudyPage, StudyQuestions,
    StudySubject, SubjectDecision, SubjectRole, blob,
};
use super::study_progress::read_definition;
use super::study_state::StudyState;
use super::submission::{
    Accepted, CheckedInput, JobOptions, SubmitError, SubmittedInput, details_value, hash_of, input_value,
};
use bytes::Bytes;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Most faults of a submission that are reported.
const NAMED_FAULTS: usize = 16;
/// How often a change is tried when others change the study at the same time.
const TRIES: usize = 8;

/// A study to be submitted.
#[derive(Debug, Clone)]
pub struct StudySubmission {
    /// Owner.
    pub tenant: Tenant,
    /// Who.
    pub subjects: Vec<SubmittedSubject>,
    /// The given template.
    pub template: Option<SubmittedInput>,
    /// Questions about the group.
    pub questions: StudyQuestions,
    /// Parameters of every match, as requested.
    pub parameters: Value,
    /// Everything else.
    pub details: JobOptions,
    /// The submitter's idempotency key.
    pub idempotency_key: Option<String>,
}

/// A subject to be submitted.
#[derive(Debug, Clone)]
pub struct SubmittedSubject {
    /// Its name in all outputs.
    pub id: String,
    /// Who it is; the id if `None`.
    pub subject: Option<String>,
    /// Its role in the study.
    pub role: SubjectRole,
    /// On which side of the body it lies.
    pub side: Option<BodySide>,
    /// Labels of its volume that belong to the structure; `None`: those of the parameters.
    pub labels: Option<Vec<LabelChoice>>,
    /// Which structure it is, in a study of several.
    pub structure: Option<String>,
    /// Its covariates.
    pub covariates: BTreeMap<String, String>,
    /// Its surface or label volume.
    pub input: SubmittedInput,
}

/// An input that is not checked yet.
fn unchecked(name_hint: Option<String>) -> JobInput {
    JobInput { hash: String::new(), n_bytes: 0, name_hint, n_vertices: 0, n_faces: 0, report: Value::Null }
}

fn named(subject: &SubmittedSubject) -> StudySubject {
    StudySubject {
        id: subject.id.clone(),
        subject: subject.subject.clone(),
        role: subject.role,
        side: subject.side,
        labels: subject.labels.clone(),
        structure: subject.structure.clone(),
        covariates: subject.covariates.clone(),
        input: unchecked(None),
    }
}

fn fault(pointer: String, refusal: &InputRefusal) -> StudyFault {
    StudyFault { pointer, code: refusal.code.clone(), detail: refusal.detail.clone() }
}

fn fingerprint(submission: &StudySubmission) -> String {
    let subject = |of: &SubmittedSubject| {
        let mut parts =
            vec![json!([of.id, of.subject, of.role, of.side, of.labels, of.covariates, input_value(&of.input)])];
        // As before there were structures, for requests that are repeated after an upgrade.
        parts.extend(of.structure.as_ref().map(|name| json!(name)));
        if parts.len() == 1 { parts.remove(0) } else { Value::from(parts) }
    };
    let subjects: Vec<Value> = submission.subjects.iter().map(subject).collect();
    let template = submission.template.as_ref().map(input_value);
    let details = details_value(&submission.details);
    hash_of(&json!([subjects, template, submission.questions, submission.parameters, details]))
}

/// A blob that is written with a change of a study.
#[derive(Clone)]
struct Written {
    blob: StudyBlob,
    /// Its content; `None` for what was uploaded before.
    bytes: Option<Bytes>,
}

impl Written {
    fn of_input(input: CheckedInput) -> Self {
        let name = blob::input(input.key.hash());
        Written { blob: StudyBlob { name, key: input.key, n_bytes: input.n_bytes }, bytes: input.bytes }
    }

    fn of_definition(tenant: &Tenant, definition: &StudyDefinition) -> Result<Self, JobError> {
        let bytes = serde_json::to_vec(definition);
        let bytes = bytes.map_err(|error| JobError::corrupt("the definition of a study", error))?;
        let (key, n_bytes) = (ArtifactKey::of(tenant, &bytes), bytes.len() as u64);
        let blob = StudyBlob { name: blob::DEFINITION.to_owned(), key, n_bytes };
        Ok(Written { blob, bytes: Some(bytes.into()) })
    }
}

impl JobService {
    /// Accepts a study: checks what is asked and every input, stores the blobs and then the study. When this returns, the study
    /// survives a loss of power.
    ///
    /// # Errors
    /// [`SubmitError`].
    pub async fn submit_study(&self, submission: StudySubmission) -> Result<Accepted<Study>, SubmitError> {
        let tenant = submission.tenant.clone();
        let once = submission.idempotency_key.as_ref().map(|key| self.once(&tenant, key, fingerprint(&submission)));
        if let Some(made) = self.begin_once(once.as_ref()).await? {
            let Made::Study(id) = made else { return Err(SubmitError::OtherRequest) };
            return Ok(Accepted { made: self.stores.studies.get_study(&tenant, id).await?, replayed: true });
        }
        let done = self.keeping(once.as_ref(), self.submit_study_once(submission, once.clone())).await;
        let made = self.end_once(once.as_ref(), done).await?;
        self.go_on(&made).await;
        Ok(Accepted { made, replayed: false })
    }

    async fn submit_study_once(
        &self,
        submission: StudySubmission,
        once: Option<super::admission::IdempotencyKey>,
    ) -> Result<Study, SubmitError> {
        let StudySubmission { tenant, subjects, template, questions, parameters, details, .. } = submission;
        if subjects.len() > self.limits.max_batch {
            return Err(SubmitError::BatchTooLarge { limit: self.limits.max_batch });
        }
        let resolved = self.engine.resolve(&parameters).map_err(SubmitError::Parameters)?;
        self.refuse_when_full(&tenant).await?;
        let mut definition = StudyDefinition {
            subjects: subjects.iter().map(named).collect(),
            template: template.as_ref().map(|_| unchecked(None)),
            questions,
            parameters: resolved.parameters.clone(),
            decisions: Vec::new(),
        };
        self.engine.check_study(&definition).map_err(SubmitError::Study)?;
        let mut written = Vec::new();
        if let Some(template) = template {
            let checked = match self.check(&tenant, "source", template, &resolved).await {
                Err(SubmitError::Input { refusal, .. }) => {
                    return Err(SubmitError::Study(vec![fault("/template".to_owned(), &refusal)]));
                }
                checked => checked?,
            };
            definition.template = Some(checked.record());
            written.push(Written::of_input(checked));
        }
        let inputs = subjects.into_iter().map(|subject| (subject.labels, subject.input)).collect();
        let (records, more) = self.check_subjects(&tenant, inputs, &resolved).await?;
        written.extend(more);
        for (subject, record) in definition.subjects.iter_mut().zip(records) {
            subject.input = record;
        }
        self.engine.check_study_size(&definition).map_err(SubmitError::Pair)?;
        written.push(Written::of_definition(&tenant, &definition)?);
        let id = StudyId::new();
        let study = NewStudy {
            id,
            tenant: tenant.clone(),
            method: resolved.method,
            method_version: resolved.method_version,
            n_subjects: u32::try_from(definition.subjects.len()).unwrap_or(u32::MAX),
            priority: details.priority,
            tags: details.tags,
            external_ref: details.external_ref,
            max_attempts: self.limits.max_attempts,
            max_queued: self.limits.max_queued,
            max_run_ms: details.max_run_ms,
            traceparent: details.traceparent,
        };
        let holder = id.to_string();
        let admission = self.admission(&tenant, &holder, once);
        let blobs: Vec<StudyBlob> = written.iter().map(|written| written.blob.clone()).collect();
        let stored = async {
            self.write_held(&tenant, &holder, written).await?;
            self.stores.studies.insert_study(&study, &blobs, &admission).await
        };
        let stored = stored.await;
        self.after_storing(&holder, stored).await
    }

    /// Checks the inputs of subjects, each with its own labels if it states some, as what a template is matched to. Returns their
    /// records, in order, and what is to be stored.
    async fn check_subjects(
        &self,
        tenant: &Tenant,
        inputs: Vec<(Option<Vec<LabelChoice>>, SubmittedInput)>,
        resolved: &Resolved,
    ) -> Result<(Vec<JobInput>, Vec<Written>), SubmitError> {
        let (mut records, mut written, mut faults) = (Vec::new(), Vec::new(), Vec::new());
        // By the labels as JSON: a study has few different ones.
        let mut by_labels: BTreeMap<String, Resolved> = BTreeMap::new();
        for (number, (labels, input)) in inputs.into_iter().enumerate() {
            let pointer = format!("/subjects/{number}/input");
            let resolved = match labels {
                None => resolved,
                Some(labels) => match by_labels.entry(json!(labels).to_string()) {
                    Entry::Occupied(known) => &*known.into_mut(),
                    Entry::Vacant(new) => {
                        let mut parameters = resolved.parameters.clone();
                        parameters["input"]["target"]["labels"] = json!(labels);
                        match self.engine.resolve(&parameters) {
                            Ok(own) => &*new.insert(own),
                            Err(wrong) => {
                                let of_labels = |wrong: ParameterFault| StudyFault {
                                    pointer: format!("/subjects/{number}/labels"),
                                    code: wrong.code,
                                    detail: wrong.detail,
                                };
                                faults.extend(wrong.into_iter().map(of_labels));
                                continue;
                            }
                        }
                    }
                },
            };
            match self.check(tenant, "target", input, resolved).await {
                Ok(checked) => {
                    records.push(checked.record());
                    written.push(Written::of_input(checked));
                }
                Err(SubmitError::Input { refusal, .. }) => faults.push(fault(pointer, &refusal)),
                Err(SubmitError::Job(JobError::MeshNotFound)) => faults.push(StudyFault {
                    pointer,
                    code: "mesh-not-found".to_owned(),
                    detail: "no such mesh".to_owned(),
                }),
                Err(error) => return Err(error),
            }
            if faults.len() >= NAMED_FAULTS {
                break;
            }
        }
        if faults.is_empty() { Ok((records, written)) } else { Err(SubmitError::Study(faults)) }
    }

    /// Holds blobs and writes those that are new.
    async fn write_held(&self, tenant: &Tenant, holder: &str, written: Vec<Written>) -> Result<(), JobError> {
        let n_bytes = written.iter().filter_map(|written| written.bytes.as_ref()).map(|bytes| bytes.len() as u64).sum();
        self.refuse_over_share(tenant, n_bytes).await?;
        self.note_stored(tenant, n_bytes);
        let keys: Vec<ArtifactKey> = written.iter().map(|written| written.blob.key.clone()).collect();
        self.stores.jobs.hold_blobs(holder, &keys, BLOB_HOLD, None).await?;
        for Written { blob, bytes } in written {
            match bytes {
                Some(bytes) => self.stores.artifacts.put(&blob.key, bytes).await?,
                // The hold protects it from here on; an earlier removal would have deleted its record.
                None => drop(self.stores.meshes.get_mesh(tenant, blob.key.hash()).await?),
            }
        }
        Ok(())
    }

    /// Begins the next jobs of a study now; otherwise housekeeping would.
    async fn go_on(&self, study: &Study) {
        if let Err(error) = self.progression().advance(&study.tenant, study.id).await {
            tracing::warn!(study_id = %study.id, %error, "a study goes on later");
        }
    }

    /// A study.
    ///
    /// # Errors
    /// [`JobError::StudyNotFound`].
    pub async fn study(&self, tenant: &Tenant, id: StudyId) -> Result<Study, JobError> {
        self.stores.studies.get_study(tenant, id).await
    }

    /// Bytes of the stored definition of a study, which is a small part of what it takes when it is read; 0 if it has outlived
    /// its retention.
    ///
    /// # Errors
    /// [`JobError::StudyNotFound`], and those of the store.
    pub async fn study_definition_bytes(&self, tenant: &Tenant, id: StudyId) -> Result<u64, JobError> {
        let blobs = self.stores.studies.study_blobs(tenant, id).await?;
        Ok(blobs.iter().find(|found| found.name == blob::DEFINITION).map_or(0, |found| found.n_bytes))
    }

    /// Who is in a study, and what is asked; `None` if that has outlived its retention.
    ///
    /// # Errors
    /// [`JobError::StudyNotFound`], and those of the stores.
    pub async fn study_definition(&self, tenant: &Tenant, id: StudyId) -> Result<Option<StudyDefinition>, JobError> {
        match read_definition(self.stores.studies.as_ref(), self.stores.artifacts.as_ref(), tenant, id).await {
            Ok(definition) => Ok(Some(definition)),
            Err(JobError::Gone) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// A page of the list of studies, newest first.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn studies(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<StudyPage, JobError> {
        self.stores.studies.list_studies(tenant, size, after).await
    }

    /// Cancels a study and its jobs.
    ///
    /// # Errors
    /// [`JobError::StudyFinal`] if it has ended otherwise.
    pub async fn cancel_study(&self, tenant: &Tenant, id: StudyId) -> Result<Study, JobError> {
        self.stores.studies.cancel_study(tenant, id).await
    }

    /// Changes the priority of a study: of its queued jobs and of those to come.
    ///
    /// # Errors
    /// [`JobError::StudyFinal`] if it has ended.
    pub async fn set_study_priority(&self, tenant: &Tenant, id: StudyId, priority: i32) -> Result<Study, JobError> {
        self.stores.studies.set_study_priority(tenant, id, priority).await
    }

    /// Deletes a study with its jobs, its inputs unless they are uploads, and its results.
    ///
    /// # Errors
    /// [`JobError::StudyActive`].
    pub async fn delete_study(&self, tenant: &Tenant, id: StudyId) -> Result<(), JobError> {
        self.stores.studies.delete_study(tenant, id).await?;
        if let Err(error) = self.remove_unreferenced_blobs().await {
            tracing::warn!(study_id = %id, %error, "blobs of a deleted study could not be removed yet");
        }
        Ok(())
    }

    /// A part of the result of a finished study.
    ///
    /// # Errors
    /// [`JobError::StudyNotReady`]; [`JobError::Gone`] if it has outlived its retention.
    pub async fn study_part(&self, tenant: &Tenant, id: StudyId, kind: ArtifactKind) -> Result<ArtifactRef, JobError> {
        let study = self.study(tenant, id).await?;
        if study.purged_at.is_some() {
            return Err(JobError::Gone);
        }
        if study.state != StudyState::Finished {
            return Err(JobError::StudyNotReady { state: study.state });
        }
        let name = match kind {
            ArtifactKind::StudyReport => blob::REPORT,
            ArtifactKind::StudyArchive => blob::ARCHIVE,
            _ => blob::DOCUMENT,
        };
        let blobs = self.stores.studies.study_blobs(tenant, id).await?;
        let found = blobs.into_iter().find(|found| found.name == name);
        let StudyBlob { key, n_bytes, .. } =
            found.ok_or(JobError::Corrupt { what: "a finished study without its result", source: None })?;
        Ok(ArtifactRef { kind, key, n_bytes })
    }

    /// Adds subjects to a study, which goes on with their matches.
    ///
    /// # Errors
    /// [`SubmitError`].
    #[allow(clippy::result_large_err)] // moved once for each change
    pub async fn add_subjects(
        &self,
        tenant: &Tenant,
        id: StudyId,
        subjects: Vec<SubmittedSubject>,
    ) -> Result<Study, SubmitError> {
        let definition = self.study_definition(tenant, id).await?.ok_or(JobError::Gone)?;
        if definition.subjects.len() + subjects.len() > self.limits.max_batch {
            return Err(SubmitError::BatchTooLarge { limit: self.limits.max_batch });
        }
        let resolved = self.engine.resolve(&definition.parameters).map_err(SubmitError::Parameters)?;
        self.refuse_when_full(tenant).await?;
        let first = definition.subjects.len();
        let mut larger = definition;
        larger.subjects.extend(subjects.iter().map(named));
        self.engine.check_study(&larger).map_err(|faults| SubmitError::Study(from_first(faults, first)))?;
        let named: Vec<StudySubject> = subjects.iter().map(named).collect();
        let inputs = subjects.into_iter().map(|subject| (subject.labels, subject.input)).collect();
        let (records, written) = self.check_subjects(tenant, inputs, &resolved).await?;
        let added: Vec<StudySubject> =
            named.into_iter().zip(records).map(|(subject, input)| StudySubject { input, ..subject }).collect();
        self.edit(tenant, id, written, |definition| {
            definition.subjects.extend(added.iter().cloned());
            self.engine.check_study(definition).map_err(|faults| SubmitError::Study(from_first(faults, first)))?;
            self.engine.check_study_size(definition).map_err(SubmitError::Pair)?;
            Ok(Some(StudyState::Matching))
        })
        .await
    }

    /// Records what was decided about a subject, or that nothing is; the study is computed again, without a match.
    ///
    /// # Errors
    /// [`JobError::SubjectNotFound`]; [`SubmitError`].
    #[allow(clippy::result_large_err)] // moved once for each change
    pub async fn decide(
        &self,
        tenant: &Tenant,
        id: StudyId,
        subject: &str,
        decision: Option<(DecisionVerdict, String)>,
    ) -> Result<Study, SubmitError> {
        self.edit(tenant, id, Vec::new(), |definition| {
            if !definition.subjects.iter().any(|known| known.id == subject) {
                return Err(JobError::SubjectNotFound.into());
            }
            let before = definition.decisions.clone();
            match &decision {
                None => definition.decisions.retain(|known| known.id != subject),
                Some((verdict, reason)) => {
                    let new = SubjectDecision { id: subject.to_owned(), decision: *verdict, reason: reason.clone() };
                    match definition.decisions.iter_mut().find(|known| known.id == subject) {
                        Some(known) => *known = new,
                        None => definition.decisions.push(new),
                    }
                }
            }
            Ok((definition.decisions != before).then_some(StudyState::Modeling))
        })
        .await
    }

    /// Changes the definition of a study, which then goes on in the state that `edit` returns; `None`: nothing is changed.
    async fn edit(
        &self,
        tenant: &Tenant,
        id: StudyId,
        written: Vec<Written>,
        edit: impl Fn(&mut StudyDefinition) -> Result<Option<StudyState>, SubmitError> + Send + Sync,
    ) -> Result<Study, SubmitError> {
        for _ in 0..TRIES {
            let study = self.study(tenant, id).await?;
            let mut definition = self.study_definition(tenant, id).await?.ok_or(JobError::Gone)?;
            let Some(state) = edit(&mut definition)? else { return Ok(study) };
            let n_subjects = u32::try_from(definition.subjects.len()).unwrap_or(u32::MAX);
            let holder = format!("study:{id}:{}", uuid::Uuid::new_v4());
            let owner = tenant.clone();
            let made = tokio::task::spawn_blocking(move || Written::of_definition(&owner, &definition)).await;
            let definition_blob = made.map_err(|join| JobError::Unavailable(Box::new(join)))??;
            let mut blobs: Vec<StudyBlob> = written.iter().map(|written| written.blob.clone()).collect();
            blobs.push(definition_blob.blob.clone());
            let change = StudyChange {
                // One that is at work finishes what runs, and then goes on with the new definition.
                state: if study.state.is_final() { state } else { study.state },
                step: None,
                n_subjects,
                error: None,
                blobs,
                holder: Some(holder.clone()),
                ..StudyChange::of(&study)
            };
            let all = written.iter().cloned().chain([definition_blob]).collect();
            let stored = async {
                self.write_held(tenant, &holder, all).await?;
                self.stores.studies.change_study(&study, &change).await
            };
            let stored = stored.await;
            if self.after_storing(&holder, stored).await? {
                self.go_on(&study).await;
                return Ok(self.study(tenant, id).await?);
            }
            self.stores.jobs.drop_hold(&holder).await?;
        }
        Err(JobError::StudyBusy.into())
    }
}

/// Faults of added subjects, by their places among those that were sent.
fn from_first(faults: Vec<StudyFault>, first: usize) -> Vec<StudyFault> {
    let moved = |fault: StudyFault| {
        let rest = fault.pointer.strip_prefix("/subjects/").map(|rest| rest.split_once('/').unwrap_or((rest, "")));
        let place = rest.and_then(|(place, rest)| Some((place.parse::<usize>().ok()?.checked_sub(first)?, rest)));
        match place {
            Some((place, rest)) => StudyFault { pointer: format!("/subjects/{place}/{rest}"), ..fault },
            None => fault,
        }
    };
    faults.into_iter().map(moved).collect()
}
