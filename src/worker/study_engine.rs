//! The steps of a study: which matches are missing, or, when none is, everything that is found.
//!
//! With `study_score` the only module of the service that knows [`homolog_study`], but for the record of a match. A step works on a folder in
//! memory with the files that `homolog study` has on disk, so that both end with the same bytes.

use super::machine;
use super::match_engine::file_name;
use super::prediction;
use super::price::PriceLimit;
use crate::jobs::engine::{Answer, Product};
use crate::jobs::study::{
    DecisionVerdict, PlannedMatch, StudyDefinition, StudyFault, StudyMaterial, StudyPlan, SubjectRole, blob,
};
use crate::jobs::{
    ArtifactKind, Computation, ComputeError, ComputeInputs, Demand, Failure, InputBytes, InputRefusal, InputSummary,
    InputView, JobInput, Purpose, SurfaceSize,
};
use homolog_contract::input::BodySide;
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_contract::study::StudySize;
use homolog_formats::write_zip;
use homolog_primitives::observe::Observer;
use homolog_run::intake::{IntakeLimits, prepare_surface};
use homolog_study::StudyError;
use homolog_study::cohort::{Cohort, CohortError};
use homolog_study::findings::find;
use homolog_study::folder::{Decision, Folder, Verdict, decisions_table, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::memory::{measures, permutations, step_bytes};
use homolog_study::output::write;
use homolog_study::place::Inputs;
use homolog_study::plan::{Purpose as Matching, Step, Study, Task, Template};
use homolog_study::price::step_price;
use homolog_study::record::Record;
use homolog_study::settings::{Analysis, Correspondence, MadeTemplate, Measure, Settings, Size, TemplateChoice};
use homolog_study::sides::template_side;
use homolog_study::statistics::design::Design;
use serde::{Deserialize as _, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Columns of the table of subjects that are no covariates. `side` is last, because a study without sides has no such column.
const OWN_COLUMNS: [&str; 5] = ["file", "id", "subject", "role", "side"];
/// The column of labels, which are not passed on as text.
const LABEL_COLUMN: &str = "label";
/// Most cores that a step is given.
const CORES: usize = 8;
/// What a step takes besides the arrays that depend on its size: stacks of threads, and what the allocator keeps.
const BESIDES: u64 = 64 << 20;

/// A step of a study.
#[derive(Debug)]
pub(super) struct StudyStep {
    /// How large the study is; `None` for a step that an earlier version queued.
    size: Option<StudySize>,
}

impl StudyStep {
    /// The step of stored parameters.
    pub(super) fn restored(parameters: &Value) -> Self {
        StudyStep { size: parameters.get("size").and_then(|size| StudySize::deserialize(size).ok()) }
    }
}

/// Refuses a study whose largest match or whose steps would take more memory than `limits` allow or more processor time than `price`
/// does.
///
/// # Errors
/// `too-large`, with the numbers.
pub(super) fn check_size(
    definition: &StudyDefinition,
    limits: &IntakeLimits,
    price: &PriceLimit,
) -> Result<(), InputRefusal> {
    let refusal =
        |detail: String| InputRefusal { code: "too-large".to_owned(), detail, topology: None, place_mm: None };
    let size = definition.size();
    let StudySize { subjects, vertices, contrasts, .. } = size;
    let (measures, permutations) = (measures(&size), permutations(&size));
    let (needed, limit) = (step_bytes(&size, cores()), limits.max_match_bytes);
    if needed > limit {
        return Err(refusal(format!(
            "{subjects} subjects with a template of {vertices} vertices, {measures} measures and {contrasts} contrasts would take \
             {needed} bytes, which exceeds the limit of {limit}; a smaller template or fewer contrasts take less"
        )));
    }
    price.check(&demand_of(&size)).map_err(|exceeded| {
        let what = format!(
            "{subjects} subjects with a template of {vertices} vertices, {measures} measures, {contrasts} contrasts and {permutations} \
             permutations"
        );
        refusal(exceeded.said_of(&what, step_price(&size).advice))
    })?;
    let parameters = parameters_of(definition).map_err(|error| refusal(error.to_string()))?;
    let (Some(template), Some(largest)) = (definition.template_input(), definition.largest_input()) else {
        return Ok(());
    };
    let vertices = |input: &JobInput| (input.n_vertices as usize, input.n_faces as usize);
    let mut pairs = vec![(template, largest)];
    if size.ring > 0 {
        pairs.extend([(largest, template), (largest, largest)]);
    }
    for (source, target) in pairs {
        let checked = homolog_run::check_size(vertices(source), vertices(target).0, &parameters, limits);
        checked.map_err(|error| refusal(format!("the largest match of the study: {error}")))?;
        let size = |input: &JobInput| SurfaceSize { n_vertices: input.n_vertices, n_faces: input.n_faces };
        let demand = prediction::predict(&parameters, size(source), size(target));
        price.check(&demand).map_err(|exceeded| {
            let said = prediction::too_dear(&parameters, size(source), size(target), exceeded);
            refusal(format!("the largest match of the study: {said}"))
        })?;
    }
    Ok(())
}

/// Threads that a step may have: a job that is alone on a large machine gets every core.
fn cores() -> usize {
    CORES.max(machine::cores())
}

/// The demand of the largest step of a study.
pub(super) fn demand_of(size: &StudySize) -> Demand {
    Demand {
        cores: usize::try_from(size.subjects).unwrap_or(CORES).clamp(1, CORES),
        memory_bytes: step_bytes(size, cores()).saturating_add(BESIDES),
        processor_time: step_price(size).processor_time,
    }
}

impl Computation for StudyStep {
    fn check_input(&self, _: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        Err(no_match())
    }

    fn show_input(&self, _: &InputBytes<'_>, _: InputView) -> Result<Vec<u8>, InputRefusal> {
        Err(no_match())
    }

    /// `source` is the largest surface; `target` has as many vertices as there are subjects. Both are used for steps of earlier
    /// versions, which say nothing else.
    fn demand(&self, source: SurfaceSize, target: SurfaceSize) -> Demand {
        let of_surfaces = || StudySize {
            subjects: target.n_vertices.into(),
            vertices: source.n_vertices.into(),
            faces: source.n_faces.into(),
            contrasts: 1,
            ..StudySize::default()
        };
        demand_of(&self.size.unwrap_or_else(of_surfaces))
    }

    fn compute(&self, inputs: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError> {
        let Purpose::Step(material) = &inputs.purpose else {
            return Err(ComputeError::Failed(internal_error()));
        };
        let products = step(material, observer).map_err(|error| match error {
            StudyError::Interrupted => ComputeError::Cancelled,
            error => ComputeError::Failed(failure(&error)),
        })?;
        Ok(Answer { products, verdict: None })
    }
}

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

fn parameters_of(definition: &StudyDefinition) -> Result<MatchParameters, StudyError> {
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
    let n_own = OWN_COLUMNS.len() - usize::from(!has_sides);
    let header =
        OWN_COLUMNS.into_iter().take(n_own).chain(names.iter().map(|name| name.as_str())).map(str::to_owned).collect();
    let rows = definition.subjects.iter().map(|subject| {
        let file = subject_file(&subject.id, subject.input.name_hint.as_deref());
        let role = match subject.role {
            SubjectRole::Model => "model",
            SubjectRole::Score => "score",
        };
        let side = subject.side.map_or("", BodySide::name);
        let own =
            [file, subject.id.clone(), subject.subject.clone().unwrap_or_default(), role.to_owned(), side.to_owned()];
        let covariates = names.iter().map(|name| subject.covariates.get(*name).cloned().unwrap_or_default());
        own.into_iter().take(n_own).chain(covariates).collect()
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
        analysis,
        cycle_subjects: asked.cycles as usize,
        cycle_ring: Vec::new(),
        parameters,
    })
}

/// Checks who is in a study and what is asked, but not the files.
///
/// # Errors
/// Every fault that can be seen before the first match.
pub(super) fn check(definition: &StudyDefinition) -> Result<(), Vec<StudyFault>> {
    let fault = |pointer: String, detail: String| StudyFault { pointer, code: "out_of_range".to_owned(), detail };
    let mut faults = Vec::new();
    for (place, subject) in definition.subjects.iter().enumerate() {
        let is_taken = |name: &str| OWN_COLUMNS.contains(&name) || name == LABEL_COLUMN || name.is_empty();
        let taken = subject.covariates.keys().find(|name| is_taken(name));
        if let Some(name) = taken {
            let detail = format!("a covariate cannot be called {name:?}; give it another name");
            faults.push(fault(format!("/subjects/{place}/covariates"), detail));
        }
        let texts = subject.covariates.iter().flat_map(|(name, value)| [name, value]).chain(&subject.subject);
        if texts.into_iter().any(|text| text.chars().any(char::is_control)) {
            let detail = "names and values of covariates and subjects have no control characters".to_owned();
            faults.push(fault(format!("/subjects/{place}"), detail));
        }
    }
    let measures: BTreeSet<&str> = Measure::ALL.into_iter().map(Measure::name).collect();
    if let Some(unknown) = definition.questions.measures.iter().find(|name| !measures.contains(name.as_str())) {
        let known: Vec<&str> = measures.into_iter().collect();
        let shown: String = unknown.chars().take(64).collect();
        faults.push(fault("/measures".to_owned(), format!("{shown} is none of {}", known.join(", "))));
    }
    let correspondence = definition.questions.correspondence.as_deref();
    if let Some(unknown) = correspondence.filter(|name| Correspondence::of_name(name).is_none()) {
        let shown: String = unknown.chars().take(64).collect();
        let known = Correspondence::ALL.map(Correspondence::name).join(", ");
        faults.push(fault("/correspondence".to_owned(), format!("{shown} is none of {known}")));
    }
    let ids = || definition.subjects.iter().map(|subject| &subject.id);
    if let Some(start) = definition.questions.start.as_ref().filter(|start| !ids().any(|id| id == *start)) {
        let shown: String = start.chars().take(64).collect();
        faults.push(fault("/start".to_owned(), format!("the study has no subject {shown}")));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let cohort = cohort(definition).map_err(|error| {
        vec![match error {
            // The header is line 1.
            CohortError::Cell { line, column, fault: detail } => {
                fault(format!("/subjects/{}/{column}", line.saturating_sub(2)), detail)
            }
            error => fault("/subjects".to_owned(), error.to_string()),
        }]
    })?;
    let settings = settings(definition).map_err(|error| vec![fault("/parameters".to_owned(), error.to_string())])?;
    template_side(&cohort, &settings).map_err(|error| vec![fault("/template_side".to_owned(), error.to_string())])?;
    if settings.analysis.effect.is_some() || !settings.analysis.contrasts.is_empty() {
        let all: Vec<usize> = (0..cohort.subjects.len()).collect();
        Design::new(&cohort, &all, &settings.analysis).map_err(|why| vec![fault("/effect".to_owned(), why)])?;
    }
    Ok(())
}

/// A study over the files of its material.
pub(super) struct OpenedStudy {
    pub(super) study: Study,
    pub(super) folder: Folder,
    pub(super) decisions: Vec<Decision>,
}

/// Opens the study of a step. With `new`, the last subject is not one of its own, and does not decide on the side of the
/// template.
///
/// # Errors
/// [`StudyError`].
pub(super) fn opened(
    material: &Arc<StudyMaterial>,
    new: bool,
    watcher: &dyn StudyObserver,
) -> Result<OpenedStudy, StudyError> {
    let definition = &material.definition;
    let (cohort, mut settings) = (cohort(definition)?, settings(definition)?);
    if new {
        let mut own = cohort.clone();
        own.subjects.pop();
        settings.template_side = template_side(&own, &settings)?;
    }
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
    let study = Study::open(cohort, settings, &[], &folder, watcher)?;
    Ok(OpenedStudy { study, folder, decisions })
}

/// One step: the plan of what is missing, or the result.
fn step(material: &Arc<StudyMaterial>, observer: &dyn Observer) -> Result<Vec<Product>, StudyError> {
    let watcher = Watched(observer);
    let OpenedStudy { mut study, folder, decisions } = opened(material, false, &watcher)?;
    match study.advance(&folder, &watcher)? {
        Step::Match { purpose, template, tasks, finished } => {
            planned(&study, &folder, purpose, &template, &tasks, finished)
        }
        Step::Matched(matched) => {
            let found = find(&study, &matched, &folder, &decisions, &watcher)?;
            write(&study, &found, &decisions, &folder, env!("HOMOLOG_COMMIT"), &watcher)?;
            // Before the archive, which holds every file once more.
            drop(found);
            if watcher.is_interrupted() {
                return Err(StudyError::Interrupted);
            }
            modeled(folder)
        }
    }
}

fn planned(
    study: &Study,
    folder: &Folder,
    purpose: Matching,
    template: &Template,
    tasks: &[Task],
    finished: usize,
) -> Result<Vec<Product>, StudyError> {
    let input = study.settings.parameters.input.of_source();
    let prepared = prepare_surface(&template.ply, Some(&file_name(".ply")), &input, &IntakeLimits::default());
    let prepared = prepared
        .map_err(|error| StudyError::Start { what: "its template".to_owned(), why: error.for_command_line() })?;
    let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    let plan = StudyPlan {
        round: match purpose {
            Matching::Template(round) => number(round),
            Matching::Subjects => 0,
        },
        finished: number(finished),
        tasks: tasks
            .iter()
            .map(|task| PlannedMatch {
                key: task.key.clone(),
                source: task.source,
                target: task.target,
                mirrored: study.mirrored(task),
            })
            .collect(),
        template: InputSummary {
            n_vertices: number(prepared.mesh.n_vertices()),
            n_faces: number(prepared.mesh.n_faces()),
            report: serde_json::to_value(&prepared.report).unwrap_or_default(),
        },
    };
    let mut products = vec![
        Product { kind: ArtifactKind::StudyPlan, bytes: json(&plan)? },
        Product { kind: ArtifactKind::StudyTemplate, bytes: template.ply.clone() },
    ];
    let kept = folder.read(blob::KEPT)?;
    products.extend(kept.map(|bytes| Product { kind: ArtifactKind::StudyKept, bytes }));
    Ok(products)
}

fn json(value: &impl Serialize) -> Result<Vec<u8>, StudyError> {
    serde_json::to_vec(value).map_err(|error| StudyError::Internal(format!("a plan cannot be written: {error}")))
}

/// The products of a folder that is finished.
fn modeled(folder: Folder) -> Result<Vec<Product>, StudyError> {
    let files: Vec<(String, Vec<u8>)> = folder.into_files().into_iter().collect();
    let archive = write_zip(&files).map_err(|source| StudyError::File {
        what: "write",
        path: PathBuf::from(blob::ARCHIVE),
        source,
    })?;
    let mut products = vec![Product { kind: ArtifactKind::StudyArchive, bytes: archive }];
    for (name, bytes) in files {
        let kind = match name.as_str() {
            blob::DOCUMENT => ArtifactKind::StudyDocument,
            blob::REPORT => ArtifactKind::StudyReport,
            blob::KEPT => ArtifactKind::StudyKept,
            blob::TEMPLATE => ArtifactKind::StudyTemplate,
            _ => continue,
        };
        products.push(Product { kind, bytes });
    }
    Ok(products)
}
