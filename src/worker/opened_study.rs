//! A study over the material of a step: its cohort, its settings, its folder in memory, and the failures with which it ends.

use super::study_templates::unpack;
use crate::jobs::study::{DecisionVerdict, StudyDefinition, StudyMaterial, SubjectRole};
use crate::jobs::{Failure, InputRefusal};
use homolog_contract::input::BodySide;
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_primitives::observe::Observer;
use homolog_study::StudyError;
use homolog_study::cohort::{Cohort, CohortError};
use homolog_study::folder::{Decision, Folder, Verdict, decisions_table, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::plan::Study;
use homolog_study::record::Record;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use homolog_study::sides::template_side;
use homolog_study::storage::Inputs;
use homolog_study::structures::GroupStudy;
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Columns of the table of subjects that are no covariates. A study without sides has no column `side`, and one of one structure no
/// column `structure`.
pub(super) const OWN_COLUMNS: [&str; 6] = ["file", "id", "subject", "role", "side", "structure"];

pub(super) fn no_match() -> InputRefusal {
    let detail = "a step of a study takes no surfaces".to_owned();
    InputRefusal { code: "unsuitable-surface".to_owned(), detail, topology: None, place_mm: None }
}

pub(super) fn internal_error() -> Failure {
    Failure::new("internal-error", "the study cannot be computed; the cause is in the service's log")
}

/// Why a study ends without a result; without ids of subjects.
pub(super) fn failure(error: &StudyError) -> Failure {
    match error {
        StudyError::TooFewMatches { .. } | StudyError::Settings(_) | StudyError::Cohort(_) => {
            Failure::new("study-failed", error.to_string())
        }
        StudyError::Start { why, .. } => Failure::new(
            "study-failed",
            format!("the template cannot begin from the surface that it is made from: {why}"),
        ),
        StudyError::Alignment { .. } => Failure::new(
            "study-failed",
            "the shape of a subject cannot be aligned with the mean; its match is degenerate",
        ),
        StudyError::Structure { error, .. } => failure(error),
        StudyError::Mesh(_) | StudyError::Decomposition(_) => Failure::new("study-failed", error.to_string()),
        StudyError::File { source, .. } => {
            tracing::error!(cause = %source, "a file of a study cannot be read");
            internal_error()
        }
        StudyError::Internal(cause) => {
            tracing::error!(cause, "a study cannot be computed");
            internal_error()
        }
        StudyError::Damaged { .. } | StudyError::Changed { .. } | StudyError::Interrupted => internal_error(),
    }
}

/// Reads the files of subjects, by the names that they have in the study.
#[derive(Debug)]
struct Uploads {
    hashes: BTreeMap<PathBuf, String>,
    material: Arc<StudyMaterial>,
}

impl Inputs for Uploads {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        self.material.inputs.read(&self.hash(file)?)
    }

    fn hash(&self, file: &Path) -> io::Result<String> {
        self.hashes.get(file).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// Tells the observer of a job how a step goes on.
pub(super) struct Watched<'a>(pub(super) &'a dyn Observer);

impl StudyObserver for Watched<'_> {
    fn progress(&self, what: &str, done: usize, of: usize) {
        // Parts of a step, by how long they take: the model, the statistics, and what is written.
        let (from, to) = match what {
            "joint maps" => (0.0, 0.05),
            "shape model" => (0.05, 0.2),
            "labels" => (0.2, 0.4),
            "statistics" => (0.4, 0.8),
            _ => (0.8, 1.0),
        };
        self.0.progress(from + (to - from) * done as f64 / of.max(1) as f64);
    }

    fn is_interrupted(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// The file of a subject, as the study names it: relative, by the subject's id.
fn subject_file(id: &str, hint: Option<&str>) -> String {
    format!("{id}{}", hint.unwrap_or_default())
}

/// The file of a given template; no id of a subject contains a slash.
fn template_file(hint: Option<&str>) -> PathBuf {
    PathBuf::from(format!("given/template{}", hint.unwrap_or_default()))
}

pub(super) fn parameters_of(definition: &StudyDefinition) -> Result<MatchParameters, StudyError> {
    resolve(&definition.parameters).map_err(|faults| {
        let first = faults.first().map(|fault| format!("{}: {}", fault.pointer, fault.detail)).unwrap_or_default();
        StudyError::Settings(format!("this version does not take the stored parameters: {first}"))
    })
}

/// The cohort of a definition: the same as from a table of its subjects whose covariates are in alphabetical order.
pub(super) fn cohort(definition: &StudyDefinition) -> Result<Cohort, CohortError> {
    let names: BTreeSet<&String> = definition.subjects.iter().flat_map(|subject| subject.covariates.keys()).collect();
    // Where no subject has a side, there is no such covariate.
    let has_sides = definition.subjects.iter().any(|subject| subject.side.is_some());
    let has_structures = !definition.structures().is_empty();
    let is_there = [true, true, true, true, has_sides, has_structures];
    let there =
        |own: [String; 6]| own.into_iter().zip(is_there).filter(|(_, is_there)| *is_there).map(|(text, _)| text);
    let header = there(OWN_COLUMNS.map(str::to_owned)).chain(names.iter().map(|name| (*name).clone())).collect();
    let rows = definition.subjects.iter().map(|subject| {
        let file = subject_file(&subject.id, subject.input.name_hint.as_deref());
        let role = match subject.role {
            SubjectRole::Model => "model",
            SubjectRole::Score => "score",
        };
        let side = subject.side.map_or("", BodySide::name);
        let own = [
            file,
            subject.id.clone(),
            subject.subject.clone().unwrap_or_default(),
            role.to_owned(),
            side.to_owned(),
            subject.structure.clone().unwrap_or_default(),
        ];
        let covariates = names.iter().map(|name| subject.covariates.get(*name).cloned().unwrap_or_default());
        there(own).chain(covariates).collect()
    });
    let mut cohort = Cohort::from_rows(std::iter::once(header).chain(rows))?;
    for (subject, defined) in cohort.subjects.iter_mut().zip(&definition.subjects) {
        subject.labels.clone_from(&defined.labels);
    }
    Ok(cohort)
}

pub(super) fn settings(definition: &StudyDefinition) -> Result<Settings, StudyError> {
    let parameters = parameters_of(definition)?;
    let asked = &definition.questions;
    let made = MadeTemplate::default();
    let template = match &definition.template {
        Some(given) => TemplateChoice::Given { file: template_file(given.name_hint.as_deref()) },
        None => TemplateChoice::Made(MadeTemplate {
            start: asked.start.clone(),
            subjects: asked.template_subjects.map_or(made.subjects, |n| n as usize),
            max_rounds: asked.template_rounds.map_or(made.max_rounds, |n| n as usize),
            ..made
        }),
    };
    let pairs = |of: &BTreeMap<String, String>| of.iter().map(|(a, b)| (a.clone(), b.clone())).collect();
    let is_asked = |measure: &Measure| asked.measures.is_empty() || asked.measures.iter().any(|m| m == measure.name());
    let analysis = Analysis {
        effect: asked.effect.clone(),
        adjust: asked.adjust.clone(),
        reference: pairs(&asked.reference),
        contrasts: pairs(&asked.contrasts),
        measures: Measure::ALL.into_iter().filter(is_asked).collect(),
        permutations: asked.permutations.map_or(Analysis::default().permutations, |n| n as usize),
        seed: parameters.seed,
    };
    Ok(Settings {
        template,
        template_side: asked.template_side,
        size: if asked.without_size { Size::Removed } else { Size::Kept },
        correspondence: asked.correspondence.as_deref().and_then(Correspondence::of_name).unwrap_or_default(),
        visits: asked.visits.as_deref().and_then(Visits::of_name).unwrap_or_default(),
        rivals: asked.rivals.as_deref().and_then(Rivals::of_name).unwrap_or_default(),
        analysis,
        cycle_subjects: asked.cycles as usize,
        cycle_ring: Vec::new(),
        parameters,
    })
}

/// A study over the files of its material.
pub(super) struct OpenedStudy<S> {
    pub(super) study: S,
    pub(super) folder: Folder,
    pub(super) decisions: Vec<Decision>,
}

/// Opens the study of a step.
///
/// # Errors
/// [`StudyError`].
pub(super) fn opened(
    material: &Arc<StudyMaterial>,
    watcher: &dyn StudyObserver,
) -> Result<OpenedStudy<GroupStudy>, StudyError> {
    let definition = &material.definition;
    let (cohort, settings) = (cohort(definition)?, settings(definition)?);
    let (folder, decisions) = folder(material);
    let study = GroupStudy::open(cohort, settings, &[], &folder, watcher)?;
    Ok(OpenedStudy { study, folder, decisions })
}

/// Opens a study of one structure whose last subject is not one of its own, and does not decide on the side of the template.
///
/// # Errors
/// [`StudyError`].
pub(super) fn opened_with_new(
    material: &Arc<StudyMaterial>,
    watcher: &dyn StudyObserver,
) -> Result<OpenedStudy<Study>, StudyError> {
    let definition = &material.definition;
    let (cohort, mut settings) = (cohort(definition)?, settings(definition)?);
    let mut own = cohort.clone();
    own.subjects.pop();
    settings.template_side = template_side(&own, &settings)?;
    let (folder, decisions) = folder(material);
    let study = Study::open(cohort, settings, &[], &folder, watcher)?;
    Ok(OpenedStudy { study, folder, decisions })
}

/// The folder of a study in memory, and the decisions in it.
fn folder(material: &Arc<StudyMaterial>) -> (Folder, Vec<Decision>) {
    let definition = &material.definition;
    let hint = |k: usize| definition.subjects[k].input.name_hint.as_deref();
    let mut hashes: BTreeMap<PathBuf, String> = (0..definition.subjects.len())
        .map(|k| {
            let subject = &definition.subjects[k];
            (PathBuf::from(subject_file(&subject.id, hint(k))), subject.input.hash.clone())
        })
        .collect();
    if let Some(given) = &definition.template {
        hashes.insert(template_file(given.name_hint.as_deref()), given.hash.clone());
    }
    let mut files = material.files.clone();
    unpack(&mut files);
    for (key, why) in &material.failures {
        files.entry(record_name(key)).or_insert_with(|| Record::failed(why.clone()).to_bytes());
    }
    let decisions: Vec<Decision> = definition
        .decisions
        .iter()
        .map(|of| Decision {
            id: of.id.clone(),
            decision: match of.decision {
                DecisionVerdict::Kept => Verdict::Kept,
                DecisionVerdict::Dropped => Verdict::Dropped,
            },
            reason: of.reason.clone(),
        })
        .collect();
    files.insert("decisions.csv".to_owned(), decisions_table(&decisions).into_bytes());
    let folder = Folder::in_memory(files, Box::new(Uploads { hashes, material: Arc::clone(material) }));
    (folder, decisions)
}
