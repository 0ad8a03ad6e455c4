//! Studies: what a group of subjects shows, from matches that are jobs of the queue.
//!
//! A study is a definition (who, and what is asked), the records of its matches and what was found, all of them blobs, so
//! that any process can go on with it. A *step* is a hidden job that reads all of these and either plans the matches that are
//! missing or, when none is, computes the model, the statistics and the report. [`super::study_progress`] makes the jobs,
//! [`super::study_submission`] has the use cases. Ids of subjects and covariates are in blobs only, and so encrypted where
//! blobs are.

use super::admission::Admission;
use super::artifact::ArtifactKey;
use super::documents::{BodySide, LabelChoice};
use super::error::JobError;
use super::ids::{JobId, StudyId};
use super::input_check::InputSummary;
use super::job::{Cursor, Failure, JobInput, NewJob, Tenant};
use super::metadata::{ExternalRef, Tags};
use super::state::JobState;
use super::study_state::StudyState;
use async_trait::async_trait;
use homolog_contract::study::StudySize;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;
use std::time::Duration;

/// Questions about a new subject. They stand in the parameters of its job, under `score`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ScoreQuestions {
    /// On which side of the body it lies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<BodySide>,
    /// Labels of its volume that belong to the structure; `None`: those of the study's parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labels: Option<Vec<LabelChoice>>,
    /// The covariate and the level of the group; `None`: all members of the model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<(String, String)>,
    /// Covariates of the study that are adjusted for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub adjust: Vec<String>,
    /// The values of these covariates, as text; numbers as they were written.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub covariates: BTreeMap<String, String>,
}

/// Names of the blobs of a study. What begins with `matches/` or `template/` is a file of its folder.
pub mod blob {
    /// The definition.
    pub const DEFINITION: &str = "definition.json";
    /// The folder of everything that was found, as a zip archive.
    pub const ARCHIVE: &str = "archive.zip";
    /// The study and its figures.
    pub const DOCUMENT: &str = "study.json";
    /// The page for people.
    pub const REPORT: &str = "report.html";
    /// The record of how the template was made.
    pub const KEPT: &str = "template/kept.json";
    /// The template.
    pub const TEMPLATE: &str = "template/template.ply";

    /// The upload with this hash.
    pub fn input(hash: &str) -> String {
        format!("inputs/{hash}")
    }

    /// Whether it is a file of the folder from which a step goes on.
    pub fn is_of_folder(name: &str) -> bool {
        name.starts_with("matches/") || name.starts_with("template/")
    }
}

/// Role of a subject.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum SubjectRole {
    /// Part of the shape model and of the statistics.
    #[default]
    Model,
    /// Only compared with the model.
    Score,
}

/// Whether a subject stays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum DecisionVerdict {
    /// It stays, whatever its match looks like.
    Kept,
    /// It is left out.
    Dropped,
}

/// A subject of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudySubject {
    /// Its name in all outputs.
    pub id: String,
    /// Who it is, where one person has several visits; the id if `None`.
    pub subject: Option<String>,
    /// Its role in the study.
    pub role: SubjectRole,
    /// On which side of the body it lies; one on the other side than the template is mirrored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<BodySide>,
    /// Labels of its volume that belong to the structure; `None`: those of the parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labels: Option<Vec<LabelChoice>>,
    /// Which structure it is, in a study of several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub structure: Option<String>,
    /// Its covariates, as text; numbers as they were written.
    pub covariates: BTreeMap<String, String>,
    /// Its surface or label volume.
    pub input: JobInput,
}

/// A person's decision about a subject.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SubjectDecision {
    /// The subject.
    pub id: String,
    /// The decision.
    pub decision: DecisionVerdict,
    /// Why.
    pub reason: String,
}

/// Questions of a study, besides its subjects; `None` is the default of the engine.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct StudyQuestions {
    /// On which side of the body the template lies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template_side: Option<BodySide>,
    /// Subject whose surface the template is made from.
    pub start: Option<String>,
    /// Most subjects that the template is made from; 0: all.
    pub template_subjects: Option<u32>,
    /// Most rounds of matching and averaging.
    pub template_rounds: Option<u32>,
    /// Whether size is taken out of shape.
    pub without_size: bool,
    /// Origin of the maps, by name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub correspondence: Option<String>,
    /// What visits of one person are matched with, by name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub visits: Option<String>,
    /// What becomes of subjects whose pose is ambiguous, by name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rivals: Option<String>,
    /// Subjects among which the consistency of maps is measured.
    pub cycles: u32,
    /// The covariate of interest.
    pub effect: Option<String>,
    /// Covariates that are adjusted for.
    pub adjust: Vec<String>,
    /// Reference level of factors, by covariate.
    pub reference: BTreeMap<String, String>,
    /// Further contrasts: name, and sum of columns.
    pub contrasts: BTreeMap<String, String>,
    /// Measures that are tested; empty: all.
    pub measures: Vec<String>,
    /// Permutations of each test.
    pub permutations: Option<u32>,
}

/// Who is in a study, and what is asked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyDefinition {
    /// In the order in which they were added.
    pub subjects: Vec<StudySubject>,
    /// The given template; `None`: one is made.
    pub template: Option<JobInput>,
    /// The questions.
    pub questions: StudyQuestions,
    /// Effective parameters of every match.
    pub parameters: Value,
    /// Decisions, in the order of the first one about each subject.
    pub decisions: Vec<SubjectDecision>,
}

impl StudyDefinition {
    /// The study with a further subject, its last, that is only scored.
    #[must_use]
    pub fn with_scored(mut self, asked: &ScoreQuestions, input: JobInput) -> Self {
        let is_free = |id: &String| !self.subjects.iter().any(|of| of.id == *id || of.subject.as_ref() == Some(id));
        let id = (0..).map(|k: usize| format!("scored-{k}")).find(is_free).unwrap_or_default();
        let (side, labels) = (asked.side, asked.labels.clone());
        let (role, covariates) = (SubjectRole::Score, BTreeMap::new());
        self.subjects.push(StudySubject { id, subject: None, role, side, labels, structure: None, covariates, input });
        self
    }

    /// The surface that the template has the vertices of: the given template, or the largest subject that it may be made from.
    pub fn template_input(&self) -> Option<&JobInput> {
        let of_subject = |start: &String| self.subjects.iter().find(|subject| subject.id == *start);
        match (&self.template, &self.questions.start) {
            (Some(given), _) => Some(given),
            // Of several structures it may name a person.
            (None, Some(start)) => of_subject(start).map(|subject| &subject.input).or_else(|| self.largest_input()),
            (None, None) => self.largest_input(),
        }
    }

    /// The largest surface of a subject.
    pub fn largest_input(&self) -> Option<&JobInput> {
        self.subjects.iter().map(|subject| &subject.input).max_by_key(|input| (input.n_vertices, input.n_faces))
    }

    /// The structures; empty in a study of one.
    pub fn structures(&self) -> BTreeSet<&str> {
        self.subjects.iter().filter_map(|subject| subject.structure.as_deref()).collect()
    }

    /// Subjects of the model and vertices and faces of their template: persons and all structures of theirs, in a study of
    /// several.
    fn extent(&self) -> [u64; 3] {
        let structures = self.structures();
        if structures.is_empty() {
            let of = |number: fn(&JobInput) -> u32| self.template_input().map_or(0, |input| number(input).into());
            return [self.subjects.len() as u64, of(|input| input.n_vertices), of(|input| input.n_faces)];
        }
        let person =
            |of: &StudySubject| (of.subject.clone(), of.side.map(BodySide::name), of.covariates.get("visit").cloned());
        let persons: BTreeSet<_> = self.subjects.iter().map(person).collect();
        let sum = |number: fn(&JobInput) -> u32| -> u64 {
            let largest = |name: &&str| {
                let own = self.subjects.iter().filter(|of| of.structure.as_deref() == Some(name));
                own.map(|of| u64::from(number(&of.input))).max().unwrap_or(0)
            };
            structures.iter().map(largest).sum()
        };
        [persons.len() as u64, sum(|input| input.n_vertices), sum(|input| input.n_faces)]
    }

    /// How large the study is. `O(subjects · covariates · log)`.
    pub fn size(&self) -> StudySize {
        let asked = &self.questions;
        let levels = |name: &String| {
            let values = self.subjects.iter().filter_map(|subject| subject.covariates.get(name));
            let is_number = |text: &&String| text.trim().parse::<f64>().is_ok();
            let is_missing = |text: &str| text.is_empty() || text == "NA" || text.eq_ignore_ascii_case("nan");
            let words: BTreeSet<&String> = values.filter(|text| !is_missing(text.trim())).collect();
            if words.iter().all(is_number) { 1 } else { (words.len() as u64).saturating_sub(1).max(1) }
        };
        let effect = asked.effect.as_ref().map_or(0, levels);
        let inputs = || self.subjects.iter().map(|subject| &subject.input).chain(&self.template);
        let [subjects, vertices, faces] = self.extent();
        // Only volumes have a size of voxels.
        let is_volume = |input: &JobInput| input.report.get("sampling").is_some_and(|sampling| !sampling.is_null());
        StudySize {
            subjects,
            vertices,
            faces,
            cells: self.subjects.iter().map(|subject| subject.covariates.len() as u64).sum(),
            columns: 1 + effect + asked.adjust.iter().map(levels).sum::<u64>(),
            contrasts: effect + asked.contrasts.len() as u64,
            measures: (!asked.measures.is_empty()).then_some(asked.measures.len() as u64),
            permutations: asked.permutations.map(u64::from),
            ring: if asked.cycles < 3 { 0 } else { asked.cycles.into() },
            file_bytes: inputs().map(|input| input.n_bytes).max().unwrap_or(0),
            has_volumes: inputs().any(is_volume),
            joint: asked.correspondence.as_deref() == Some("joint"),
            own_templates: asked.visits.as_deref() == Some("own_template"),
            rivals: asked.rivals.as_deref() != Some("leave_out"),
        }
    }
}

/// A fault of a definition.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StudyFault {
    /// JSON pointer into the submission.
    pub pointer: String,
    /// Stable name of the kind of fault.
    pub code: String,
    /// Description of the fault.
    pub detail: String,
}

/// The matches that a step found missing, with the template of these.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyPlan {
    /// The round of making a template, from 1; 0 for the matches of all subjects.
    pub round: u32,
    /// Matches for the same that are there already.
    pub finished: u32,
    /// The missing ones.
    pub tasks: Vec<PlannedMatch>,
    /// The template.
    pub template: InputSummary,
    /// The templates of persons, in the order in which their files follow each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub own: Vec<PlannedTemplate>,
}

/// The template of a person.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlannedTemplate {
    /// Size of its file, bytes.
    pub n_bytes: u64,
    /// Its surface.
    pub surface: InputSummary,
}

/// A match that is missing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlannedMatch {
    /// Names its record.
    pub key: String,
    /// The subject whose surface moves, by its place; `None`: the template.
    pub source: Option<usize>,
    /// The subject that stays; `None`: the template.
    pub target: Option<usize>,
    /// The template of a person that takes part, by its place: it moves onto the subject, or the template onto it. Or the surface
    /// of a subject in a rival pose, onto which the template moves.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own: Option<usize>,
    /// The subject whose surface that is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rival_of: Option<usize>,
    /// Parameters in which the match differs from those of the study, by JSON pointer.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub parameters: BTreeMap<String, String>,
    /// Whether source and target are mirrored.
    #[serde(default)]
    pub mirrored: [bool; 2],
}

/// Reads the files of subjects during a step, from a thread that may wait.
pub trait StudyInputs: Debug + Send + Sync {
    /// The upload with this hash.
    ///
    /// # Errors
    /// Those of the store.
    fn read(&self, hash: &str) -> std::io::Result<Vec<u8>>;
}

/// The material of a step.
#[derive(Debug)]
pub struct StudyMaterial {
    /// Who, and what is asked.
    pub definition: StudyDefinition,
    /// The files of the study's folder from which it goes on: records and the template that is kept.
    pub files: BTreeMap<String, Vec<u8>>,
    /// Matches without an answer: their keys, and why.
    pub failures: Vec<(String, String)>,
    /// The files of its subjects.
    pub inputs: Box<dyn StudyInputs>,
}

/// A blob of a study.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StudyBlob {
    /// Its name within the study.
    pub name: String,
    /// Its address.
    pub key: ArtifactKey,
    /// Its size, bytes.
    pub n_bytes: u64,
}

/// How far the current matches of a study are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct StudyProgress {
    /// The round of making a template, from 1; 0 for the matches of all subjects.
    pub round: u32,
    /// Matches that were there before.
    pub n_before: u32,
    /// Matches that were planned besides.
    pub n_tasks: u32,
    /// Planned matches that have a job.
    pub n_made: u32,
}

/// A study to be stored.
#[derive(Debug, Clone, PartialEq)]
pub struct NewStudy {
    /// Identity.
    pub id: StudyId,
    /// Owner.
    pub tenant: Tenant,
    /// Name of the method of its matches.
    pub method: String,
    /// Version of this program.
    pub method_version: String,
    /// Subjects.
    pub n_subjects: u32,
    /// Priority of its jobs.
    pub priority: i32,
    /// Tags of the submitter.
    pub tags: Tags,
    /// The submitter's own identifier.
    pub external_ref: Option<ExternalRef>,
    /// Lost workers after which a job of it is dead.
    pub max_attempts: u32,
    /// Most queued jobs of its tenant.
    pub max_queued: u32,
    /// Maximum run time of a match, ms.
    pub max_run_ms: Option<u64>,
    /// W3C trace context of its submission.
    pub traceparent: Option<String>,
}

/// A study as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Identity.
    pub id: StudyId,
    /// Owner.
    pub tenant: Tenant,
    /// Its state.
    pub state: StudyState,
    /// Raised by every change; a change that was decided from an earlier one is not made.
    pub revision: u64,
    /// Name of the method of its matches.
    pub method: String,
    /// Version of the program that accepted it.
    pub method_version: String,
    /// Subjects.
    pub n_subjects: u32,
    /// Priority of its jobs.
    pub priority: i32,
    /// Tags of the submitter.
    pub tags: BTreeMap<String, String>,
    /// The submitter's own identifier.
    pub external_ref: Option<String>,
    /// Lost workers after which a job of it is dead.
    pub max_attempts: u32,
    /// Most queued jobs of its tenant.
    pub max_queued: u32,
    /// Maximum run time of a match, ms.
    pub max_run_ms: Option<u64>,
    /// W3C trace context of its submission.
    pub traceparent: Option<String>,
    /// The current step.
    pub step: Option<JobId>,
    /// How far its matches are.
    pub progress: StudyProgress,
    /// Its matches that are queued or running.
    pub n_active: u32,
    /// Why it has no result.
    pub error: Option<Failure>,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// When it reached its final state.
    pub finished_at: Option<Timestamp>,
    /// When its result will be removed.
    pub expires_at: Option<Timestamp>,
    /// When it was removed.
    pub purged_at: Option<Timestamp>,
}

impl Study {
    /// Matches of the current round that are finished, and all of them.
    pub fn matches(&self) -> (u32, u32) {
        let StudyProgress { n_before, n_tasks, n_made, .. } = self.progress;
        (n_before + n_made.saturating_sub(self.n_active), n_before + n_tasks)
    }
}

/// A page of the list of studies.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyPage {
    /// The studies, newest first.
    pub studies: Vec<Study>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}

/// A change of a study, made as a whole or not at all. Records of its finished matches are taken over with it.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyChange {
    /// The new state.
    pub state: StudyState,
    /// The new current step.
    pub step: Option<JobId>,
    /// How far its matches are.
    pub progress: StudyProgress,
    /// Subjects.
    pub n_subjects: u32,
    /// Why it has no result.
    pub error: Option<Failure>,
    /// How long its result is kept if the new state is final; for ever if `None`.
    pub keep: Option<Duration>,
    /// Jobs that begin.
    pub jobs: Vec<NewJob>,
    /// Blobs to which it refers from now on, instead of those of the same name.
    pub blobs: Vec<StudyBlob>,
    /// A hold that is released.
    pub holder: Option<String>,
}

impl StudyChange {
    /// A change that leaves everything as it is.
    pub fn of(study: &Study) -> Self {
        StudyChange {
            state: study.state,
            step: study.step,
            progress: study.progress,
            n_subjects: study.n_subjects,
            error: study.error.clone(),
            keep: None,
            jobs: Vec::new(),
            blobs: Vec::new(),
            holder: None,
        }
    }
}

/// Records of studies.
#[async_trait]
pub trait StudyStore: Send + Sync {
    /// Stores a study with its blobs, which the holder of the admission holds. [`JobError::QueueFull`] if the tenant's queue
    /// has no room.
    async fn insert_study(
        &self,
        study: &NewStudy,
        blobs: &[StudyBlob],
        admission: &Admission,
    ) -> Result<Study, JobError>;

    /// A study.
    async fn get_study(&self, tenant: &Tenant, id: StudyId) -> Result<Study, JobError>;

    /// A page of the list of studies, newest first.
    async fn list_studies(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<StudyPage, JobError>;

    /// At most `limit` studies that are not in a final state, the oldest first.
    async fn active_studies(&self, limit: u32) -> Result<Vec<(Tenant, StudyId)>, JobError>;

    /// The blobs of a study, by name.
    async fn study_blobs(&self, tenant: &Tenant, id: StudyId) -> Result<Vec<StudyBlob>, JobError>;

    /// The matches of a study that ended without an answer: the keys of their records, and why.
    async fn study_failures(&self, id: StudyId) -> Result<Vec<(String, String)>, JobError>;

    /// How a step is; `None` if it was removed.
    async fn study_step(&self, step: JobId) -> Result<Option<(JobState, Option<Failure>)>, JobError>;

    /// Makes a change that was decided from this state of the study. `false`, and nothing is changed, if it has changed since.
    async fn change_study(&self, study: &Study, change: &StudyChange) -> Result<bool, JobError>;

    /// Cancels a study and its jobs. [`JobError::StudyFinal`] if it has ended otherwise.
    async fn cancel_study(&self, tenant: &Tenant, id: StudyId) -> Result<Study, JobError>;

    /// Changes the priority of a study and of its jobs that have not ended.
    ///
    /// # Errors
    /// [`JobError::StudyFinal`] if it has ended.
    async fn set_study_priority(&self, tenant: &Tenant, id: StudyId, priority: i32) -> Result<Study, JobError>;

    /// Removes a study with its jobs and blobs. [`JobError::StudyActive`] before it and its jobs have ended.
    async fn delete_study(&self, tenant: &Tenant, id: StudyId) -> Result<(), JobError>;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_of_a_study_counts_what_its_arrays_depend_on() {
        let input = |n_vertices: u32| JobInput {
            hash: String::new(),
            n_bytes: u64::from(n_vertices),
            name_hint: None,
            n_vertices,
            n_faces: 2 * n_vertices,
            report: Value::Null,
        };
        let subject = |k: u32| StudySubject {
            id: format!("s{k}"),
            subject: None,
            role: SubjectRole::Model,
            side: None,
            labels: None,
            structure: None,
            covariates: [("group", format!("g{}", k % 3)), ("age", format!("{}.5", k)), ("visit", "NA".to_owned())]
                .map(|(name, value)| (name.to_owned(), value))
                .into(),
            input: input(100 + k),
        };
        let contrasts = BTreeMap::from([("c".to_owned(), "group:g1".to_owned())]);
        let questions = StudyQuestions {
            effect: Some("group".to_owned()),
            adjust: vec!["age".to_owned(), "visit".to_owned()],
            contrasts,
            cycles: 4,
            ..StudyQuestions::default()
        };
        let mut definition = StudyDefinition {
            subjects: (0..10).map(subject).collect(),
            template: None,
            questions,
            parameters: Value::Null,
            decisions: Vec::new(),
        };
        let size = definition.size();
        assert_eq!((size.subjects, size.vertices, size.faces, size.cells), (10, 109, 218, 30), "the largest");
        assert_eq!((size.columns, size.contrasts, size.ring, size.file_bytes), (1 + 2 + 1 + 1, 3, 4, 109));
        assert!(size.rivals, "any subject may turn out to be ambiguous");
        definition.questions.rivals = Some("leave_out".to_owned());
        assert!(!definition.size().rivals);
        definition.questions.start = Some("s2".to_owned());
        assert_eq!(definition.size().vertices, 102, "of the subject that it is made from");
        definition.template =
            Some(JobInput { report: serde_json::json!({"sampling": {"noise_mm": 0.1}}), ..input(7000) });
        let size = definition.size();
        assert_eq!((size.vertices, size.file_bytes, size.has_volumes), (7000, 7000, true), "of the given one");
        for (k, subject) in definition.subjects.iter_mut().enumerate() {
            subject.subject = Some(format!("p{}", k / 2));
            subject.structure = Some(["a", "b"][k % 2].to_owned());
        }
        let of_persons = definition.size();
        assert_eq!((of_persons.subjects, of_persons.vertices), (5, 108 + 109), "of both structures");
        // A job's row keeps it.
        let stored = serde_json::to_value(size).unwrap();
        assert_eq!(serde_json::from_value::<StudySize>(stored).unwrap(), size);
    }
}
