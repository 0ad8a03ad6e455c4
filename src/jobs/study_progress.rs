//! How a study goes on: from a step to the matches that it found missing, from the last of these to the next step, and from
//! the step that finds none missing to the result.
//!
//! Every process does this for every study, every second and whenever a job of one ends. What is decided from one revision of
//! a study is stored only if that is still its revision, so that each job is made once, whoever is first.

use super::artifact::{ArtifactKey, ArtifactKind, ArtifactRef, BLOB_HOLD};
use super::error::JobError;
use super::ids::{JobId, STEP_METHOD, StudyId};
use super::input_check::InputSummary;
use super::job::{Failure, JobInput, NewJob, Tenant};
use super::metadata::{ExternalRef, Tags};
use super::ports::{ArtifactStore, JobStore};
use super::retention::Retentions;
use super::signals::Signals;
use super::state::JobState;
use super::study::{
    PlannedMatch, Study, StudyBlob, StudyChange, StudyDefinition, StudyPlan, StudyProgress, StudyStore, blob,
};
use super::study_state::StudyState;
use bytes::Bytes;
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Studies that are looked at in one round.
const AT_ONCE: u32 = 200;
/// Changes of one study in one round, so that no fault can keep a process busy.
const MOST_CHANGES: usize = 8;
/// Matches that are made in one transaction.
const MADE_AT_ONCE: u32 = 500;

/// The progress of studies: the jobs and the result that follow from each step.
#[derive(Clone)]
pub struct StudyProgression {
    /// Jobs.
    pub jobs: Arc<dyn JobStore>,
    /// Studies.
    pub studies: Arc<dyn StudyStore>,
    /// Blobs.
    pub artifacts: Arc<dyn ArtifactStore>,
    /// Wakes the workers of this process.
    pub signals: Arc<Signals>,
    /// How long results are kept.
    pub retention: Retentions,
}

/// Templates of persons by their place in a plan: their files, and as inputs of jobs.
type OwnTemplates = BTreeMap<usize, (Bytes, JobInput)>;

/// A template as an input of a job.
fn template_input(tenant: &Tenant, bytes: &[u8], surface: &InputSummary) -> JobInput {
    JobInput {
        hash: ArtifactKey::of(tenant, bytes).hash().to_owned(),
        n_bytes: bytes.len() as u64,
        name_hint: Some(".ply".to_owned()),
        n_vertices: surface.n_vertices,
        n_faces: surface.n_faces,
        report: surface.report.clone(),
    }
}

impl StudyProgression {
    /// Goes on with every study that can go on.
    ///
    /// # Errors
    /// Those of the store, of the first study that fails.
    pub async fn advance_studies(&self) -> Result<(), JobError> {
        let mut first = Ok(());
        for (tenant, id) in self.studies.active_studies(AT_ONCE).await? {
            let done = self.advance(&tenant, id).await;
            if first.is_ok() {
                first = done;
            }
        }
        first
    }

    /// Advances a study as far as possible.
    ///
    /// # Errors
    /// Those of the stores.
    pub async fn advance(&self, tenant: &Tenant, id: StudyId) -> Result<(), JobError> {
        for _ in 0..MOST_CHANGES {
            let study = match self.studies.get_study(tenant, id).await {
                Err(JobError::StudyNotFound) => return Ok(()),
                study => study?,
            };
            let Some(change) = self.next(&study).await? else { return Ok(()) };
            let begins = !change.jobs.is_empty();
            if self.studies.change_study(&study, &change).await? {
                let (from, to) = (study.state.name(), change.state.name());
                tracing::info!(study_id = %id, from, to, jobs = change.jobs.len(), "a study goes on");
            }
            if begins {
                self.signals.queued.notify_one();
                self.jobs.announce_queued().await;
            }
        }
        Ok(())
    }

    /// The next change of a study; `None` if the study has to wait for its jobs, or is in a final state.
    async fn next(&self, study: &Study) -> Result<Option<StudyChange>, JobError> {
        if study.state.is_final() {
            return Ok(None);
        }
        let StudyProgress { n_tasks, n_made, round, .. } = study.progress;
        let Some(step) = study.step else {
            // Matches that still run are of an earlier plan; their records count.
            return if study.n_active > 0 { Ok(None) } else { self.begin_step(study, study.state).await.map(Some) };
        };
        if n_tasks > 0 && n_made >= n_tasks {
            let state = if round == 0 { StudyState::Modeling } else { StudyState::Matching };
            return if study.n_active > 0 { Ok(None) } else { self.begin_step(study, state).await.map(Some) };
        }
        match self.studies.study_step(step).await? {
            None => Ok(Some(StudyChange { step: None, ..StudyChange::of(study) })),
            Some((JobState::Queued | JobState::Running, _)) => Ok(None),
            Some((JobState::Succeeded, _)) => self.after_step(study, step).await,
            Some((state, failure)) => {
                let detail = format!("a step of the study was {}", state.name());
                let error = failure.unwrap_or_else(|| Failure::new("study-failed", detail));
                Ok(Some(self.ended(study, StudyState::Failed, Some(error))))
            }
        }
    }

    fn ended(&self, study: &Study, state: StudyState, error: Option<Failure>) -> StudyChange {
        let keep = self.retention.of(&study.tenant).results;
        StudyChange { state, error, keep, step: None, ..StudyChange::of(study) }
    }

    /// Starts the next step; tasks matched so far count as done.
    async fn begin_step(&self, study: &Study, state: StudyState) -> Result<StudyChange, JobError> {
        let _alone = self.signals.planning.lock().await;
        let definition = self.definition(study).await?;
        let size = |of: fn(&JobInput) -> u32| definition.subjects.iter().map(|s| of(&s.input)).max().unwrap_or(0);
        let first =
            definition.subjects.first().ok_or(JobError::Corrupt { what: "a study's subjects", source: None })?;
        // A job has two inputs, whose sizes say what it needs: the largest surface, and as many as there are subjects.
        let largest = JobInput {
            n_vertices: size(|input| input.n_vertices),
            n_faces: size(|input| input.n_faces),
            ..first.input.clone()
        };
        let all = JobInput { n_vertices: study.n_subjects, n_faces: study.n_subjects, ..first.input.clone() };
        let job = NewJob {
            method: STEP_METHOD.to_owned(),
            method_version: env!("CARGO_PKG_VERSION").to_owned(),
            parameters: json!({"method": STEP_METHOD, "size": definition.size()}),
            tags: Tags::default(),
            max_run_ms: None,
            ..self.job(study, largest, all)
        };
        let StudyProgress { round, n_before, n_tasks, .. } = study.progress;
        let progress = StudyProgress { round, n_before: n_before + n_tasks, n_tasks: 0, n_made: 0 };
        Ok(StudyChange { state, step: Some(job.id), progress, jobs: vec![job], ..StudyChange::of(study) })
    }

    fn job(&self, study: &Study, source: JobInput, target: JobInput) -> NewJob {
        NewJob {
            id: JobId::new(),
            tenant: study.tenant.clone(),
            method: study.method.clone(),
            method_version: study.method_version.clone(),
            parameters: serde_json::Value::Null,
            source,
            target,
            priority: study.priority,
            // An earlier version may have stored what is not allowed any more.
            tags: Tags::new(study.tags.clone()).unwrap_or_default(),
            external_ref: None,
            max_attempts: study.max_attempts,
            deadline_at: None,
            max_run_ms: study.max_run_ms,
            retry_of: None,
            batch_id: None,
            study_id: Some(study.id),
            study_task: None,
            cache_key: None,
            use_cache: false,
            traceparent: study.traceparent.clone(),
        }
    }

    /// The change after a step that has succeeded: the result, or the matches that it found missing.
    async fn after_step(&self, study: &Study, step: JobId) -> Result<Option<StudyChange>, JobError> {
        let mut blobs = Vec::new();
        for (kind, name) in [
            (ArtifactKind::StudyKept, blob::KEPT),
            (ArtifactKind::StudyTemplate, blob::TEMPLATE),
            (ArtifactKind::StudyDocument, blob::DOCUMENT),
            (ArtifactKind::StudyReport, blob::REPORT),
            (ArtifactKind::StudyArchive, blob::ARCHIVE),
        ] {
            if let Some(found) = self.product(study, step, kind).await? {
                blobs.push(StudyBlob { name: name.to_owned(), key: found.key, n_bytes: found.n_bytes });
            }
        }
        let has = |name: &str| blobs.iter().any(|found| found.name == name);
        if has(blob::DOCUMENT) {
            let change = self.ended(study, StudyState::Finished, None);
            return Ok(Some(StudyChange { blobs, ..change }));
        }
        if !has(blob::KEPT) {
            // The template of a round is that of its matches, and no more.
            blobs.clear();
        }
        self.plan(study, step, blobs).await
    }

    async fn product(&self, study: &Study, step: JobId, kind: ArtifactKind) -> Result<Option<ArtifactRef>, JobError> {
        match self.jobs.get_artifact(&study.tenant, step, kind).await {
            Ok((_, found)) => Ok(found),
            Err(JobError::NotFound | JobError::Gone) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Matches that a step found missing, as many as the queue of the tenant has room for.
    async fn plan(&self, study: &Study, step: JobId, blobs: Vec<StudyBlob>) -> Result<Option<StudyChange>, JobError> {
        let (Some(plan), Some(template)) = (
            self.product(study, step, ArtifactKind::StudyPlan).await?,
            self.product(study, step, ArtifactKind::StudyTemplate).await?,
        ) else {
            // It was removed before it was read: another step makes it again.
            return Ok(Some(StudyChange { step: None, ..StudyChange::of(study) }));
        };
        let plan = self.artifacts.get(&plan.key).await?;
        let plan: StudyPlan = serde_json::from_slice(&plan).map_err(|e| JobError::corrupt("a study's plan", e))?;
        let n_tasks = u32::try_from(plan.tasks.len()).unwrap_or(u32::MAX);
        if n_tasks == 0 {
            return Err(JobError::Corrupt { what: "a study's plan", source: None });
        }
        let waiting = self.jobs.queue_length(&study.tenant, study.max_queued).await?;
        let room = study.max_queued.saturating_sub(waiting).min(MADE_AT_ONCE);
        let n_made = study.progress.n_made;
        let next = plan.tasks.iter().skip(n_made as usize).take(room as usize);
        if room == 0 {
            return Ok(None);
        }
        let bytes = self.artifacts.get(&template.key).await?;
        let given = template_input(&study.tenant, &bytes, &plan.template);
        let used: BTreeSet<usize> = next.clone().filter_map(|task| task.own).collect();
        let of_persons = self.own_templates(study, step, &plan, &used).await?;
        let mut jobs = Vec::new();
        {
            let _alone = self.signals.planning.lock().await;
            let definition = self.definition(study).await?;
            for task in next {
                jobs.push(self.match_job(study, &definition, (&given, &of_persons), task)?);
            }
        }
        let holder = format!("study:{}:{}", study.id, uuid::Uuid::new_v4());
        let files: Vec<(ArtifactKey, Bytes)> = std::iter::once(bytes)
            .chain(of_persons.into_values().map(|(bytes, _)| bytes))
            .map(|bytes| (ArtifactKey::of(&study.tenant, &bytes), bytes))
            .collect();
        let keys: Vec<ArtifactKey> = files.iter().map(|(key, _)| key.clone()).collect();
        self.jobs.hold_blobs(&holder, &keys, BLOB_HOLD, None).await?;
        for (key, bytes) in files {
            self.artifacts.put(&key, bytes).await?;
        }
        let n_made = n_made + u32::try_from(jobs.len()).unwrap_or(u32::MAX);
        Ok(Some(StudyChange {
            state: StudyState::Matching,
            step: Some(step),
            progress: StudyProgress { round: plan.round, n_before: plan.finished, n_tasks, n_made },
            jobs,
            blobs,
            holder: Some(holder),
            ..StudyChange::of(study)
        }))
    }

    /// The templates of persons of a plan at these places: their files, and as inputs of jobs.
    async fn own_templates(
        &self,
        study: &Study,
        step: JobId,
        plan: &StudyPlan,
        used: &BTreeSet<usize>,
    ) -> Result<OwnTemplates, JobError> {
        if used.is_empty() {
            return Ok(OwnTemplates::new());
        }
        let corrupt = || JobError::Corrupt { what: "a study's plan", source: None };
        let found = self.product(study, step, ArtifactKind::StudyOwnTemplates).await?.ok_or_else(corrupt)?;
        let all = self.artifacts.get(&found.key).await?;
        let (mut templates, mut begin) = (OwnTemplates::new(), 0);
        for (place, template) in plan.own.iter().enumerate() {
            let end = usize::try_from(template.n_bytes).ok().and_then(|n| n.checked_add(begin)).ok_or_else(corrupt)?;
            if end > all.len() {
                return Err(corrupt());
            }
            if used.contains(&place) {
                let bytes = all.slice(begin..end);
                let input = template_input(&study.tenant, &bytes, &template.surface);
                templates.insert(place, (bytes, input));
            }
            begin = end;
        }
        if templates.len() == used.len() { Ok(templates) } else { Err(corrupt()) }
    }

    fn match_job(
        &self,
        study: &Study,
        definition: &StudyDefinition,
        (template, of_persons): (&JobInput, &OwnTemplates),
        task: &PlannedMatch,
    ) -> Result<NewJob, JobError> {
        let own = task.own.and_then(|place| of_persons.get(&place)).map_or(template, |(_, input)| input);
        // The template of a person moves onto a subject, or that of the group onto it.
        let moving = if task.target.is_some() { own } else { template };
        let input = |side: Option<usize>, template: &JobInput| match side {
            None => Ok(template.clone()),
            Some(k) => match definition.subjects.get(k) {
                Some(subject) => Ok(subject.input.clone()),
                None => Err(JobError::Corrupt { what: "a study's plan", source: None }),
            },
        };
        let id = task
            .target
            .or(task.source)
            .or(task.rival_of)
            .and_then(|k| definition.subjects.get(k))
            .map(|subject| subject.id.clone());
        let mut parameters = definition.parameters.clone();
        for (side, is_mirrored) in ["source", "target"].into_iter().zip(task.mirrored) {
            if is_mirrored {
                parameters["input"][side]["mirror"] = true.into();
            }
        }
        for (side, subject) in [("source", task.source), ("target", task.target)] {
            if let Some(labels) = subject.and_then(|k| definition.subjects.get(k)?.labels.as_ref()) {
                parameters["input"][side]["labels"] = json!(labels);
            }
        }
        for (pointer, value) in &task.parameters {
            let place =
                parameters.pointer_mut(pointer).ok_or(JobError::Corrupt { what: "a study's plan", source: None })?;
            *place = json!(value);
        }
        Ok(NewJob {
            parameters,
            external_ref: ExternalRef::new(id.unwrap_or_default()).ok().flatten(),
            study_task: Some(task.key.clone()),
            ..self.job(study, input(task.source, moving)?, input(task.target, own)?)
        })
    }

    async fn definition(&self, study: &Study) -> Result<StudyDefinition, JobError> {
        read_definition(self.studies.as_ref(), self.artifacts.as_ref(), &study.tenant, study.id).await
    }
}

/// The definition of a study.
///
/// # Errors
/// [`JobError::StudyNotFound`]; [`JobError::Gone`] if it has outlived its retention; those of the stores.
pub async fn read_definition(
    studies: &dyn StudyStore,
    artifacts: &dyn ArtifactStore,
    tenant: &Tenant,
    id: StudyId,
) -> Result<StudyDefinition, JobError> {
    let bytes = definition_bytes(studies, artifacts, tenant, id).await?;
    // Megabytes take a while, for which this thread has others to serve.
    let parsed = tokio::task::spawn_blocking(move || serde_json::from_slice(&bytes)).await;
    let parsed = parsed.map_err(|join| JobError::Unavailable(Box::new(join)))?;
    parsed.map_err(|error| JobError::corrupt("the definition of a study", error))
}

/// The stored definition of a study.
///
/// # Errors
/// As [`read_definition`].
pub(super) async fn definition_bytes(
    studies: &dyn StudyStore,
    artifacts: &dyn ArtifactStore,
    tenant: &Tenant,
    id: StudyId,
) -> Result<Bytes, JobError> {
    let blobs = studies.study_blobs(tenant, id).await?;
    let found = blobs.iter().find(|found| found.name == blob::DEFINITION).ok_or(JobError::Gone)?;
    artifacts.get(&found.key).await
}
