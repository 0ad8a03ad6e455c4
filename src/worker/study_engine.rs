//! The steps of a study: which matches are missing, or, when none is, everything that is found.
//!
//! With `opened_study`, `study_demand` and `study_score` the only module of the service that knows [`homolog_study`], but for the record of a match. A step works on a folder in
//! memory with the files that `homolog study` has on disk, so that both end with the same bytes.

use super::file_name::file_name;
use super::opened_study::{
    OWN_COLUMNS, OpenedStudy, Watched, cohort, failure, internal_error, no_match, opened, parameters_of, settings,
};
use super::prediction;
use super::price::PriceLimit;
use super::study_demand::{cores, demand_of};
use super::study_templates::packed;
use crate::jobs::engine::{Answer, Product};
use crate::jobs::study::{PlannedMatch, PlannedTemplate, StudyDefinition, StudyFault, StudyMaterial, StudyPlan, blob};
use crate::jobs::{
    ArtifactKind, Computation, ComputeError, ComputeInputs, Demand, InputBytes, InputRefusal, InputSummary, InputView,
    JobInput, Purpose, SurfaceSize,
};
use homolog_contract::study::StudySize;
use homolog_formats::write_zip;
use homolog_primitives::observe::Observer;
use homolog_run::intake::{IntakeLimits, prepare_surface};
use homolog_study::StudyError;
use homolog_study::cohort::CohortError;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver as _;
use homolog_study::memory::{measures, permutations, step_bytes};
use homolog_study::output::write;
use homolog_study::plan::{Purpose as Matching, RIVAL_PARAMETERS, Task, Template};
use homolog_study::price::step_price;
use homolog_study::settings::{Correspondence, Measure, Rivals, Settings, Visits};
use homolog_study::sides::{is_mirrored, template_side};
use homolog_study::statistics::design::Design;
use homolog_study::structures::{GroupStep, GroupStudy};
use serde::{Deserialize as _, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

/// The column of labels, which are not passed on as text.
const LABEL_COLUMN: &str = "label";

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
    if size.own_templates {
        pairs.push((largest, largest));
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
    // The first name that is none of those known.
    let mut unknown_name = |pointer: &str, names: &[String], known: &[&str]| {
        if let Some(unknown) = names.iter().find(|name| !known.contains(&name.as_str())) {
            let shown: String = unknown.chars().take(64).collect();
            faults.push(fault(pointer.to_owned(), format!("{shown} is none of {}", known.join(", "))));
        }
    };
    let asked = &definition.questions;
    let measures: BTreeSet<&str> = Measure::ALL.into_iter().map(Measure::name).collect();
    unknown_name("/measures", &asked.measures, &Vec::from_iter(measures));
    unknown_name("/correspondence", asked.correspondence.as_slice(), &Correspondence::ALL.map(Correspondence::name));
    unknown_name("/visits", asked.visits.as_slice(), &Visits::ALL.map(Visits::name));
    unknown_name("/rivals", asked.rivals.as_slice(), &Rivals::ALL.map(Rivals::name));
    let unknown_start = |ids: BTreeSet<&String>| {
        let start = definition.questions.start.as_ref().filter(|start| !ids.contains(start))?;
        let shown: String = start.chars().take(64).collect();
        Some(fault("/start".to_owned(), format!("the study has no subject {shown}")))
    };
    if definition.structures().is_empty() {
        faults.extend(unknown_start(definition.subjects.iter().map(|subject| &subject.id).collect()));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let cohort = cohort(definition).map_err(|error| {
        vec![match error {
            // The header is line 1.
            CohortError::Cell { line, column, fault: detail } => {
                let member = if OWN_COLUMNS.contains(&column.as_str()) { column.as_str() } else { "covariates" };
                let detail = if member == column { detail } else { format!("{column} {detail}") };
                fault(format!("/subjects/{}/{member}", line.saturating_sub(2)), detail)
            }
            error => fault("/subjects".to_owned(), error.to_string()),
        }]
    })?;
    let settings = settings(definition).map_err(|error| vec![fault("/parameters".to_owned(), error.to_string())])?;
    template_side(&cohort, &settings).map_err(|error| vec![fault("/template_side".to_owned(), error.to_string())])?;
    if !cohort.structures().is_empty() {
        let persons = cohort.persons();
        let known = cohort.subjects.iter().chain(&persons.subjects).map(|subject| &subject.id).collect();
        if let Some(unknown) = unknown_start(known) {
            return Err(vec![unknown]);
        }
        let why = "of several structures each has its own";
        if definition.template.is_some() {
            let detail = format!(
                "{why} template, made from the group; leave this out, or use the command, which takes given ones"
            );
            return Err(vec![fault("/template".to_owned(), detail)]);
        }
        if definition.questions.cycles > 0 {
            let detail = format!("{why} maps; their consistency is measured in a study of one structure");
            return Err(vec![fault("/cycles".to_owned(), detail)]);
        }
        if settings.visits == Visits::OwnTemplate {
            let detail = "templates of persons are made in a study of one structure; leave visits out".to_owned();
            return Err(vec![fault("/visits".to_owned(), detail)]);
        }
    }
    if settings.analysis.effect.is_some() || !settings.analysis.contrasts.is_empty() {
        let persons = cohort.persons();
        let all: Vec<usize> = (0..persons.subjects.len()).collect();
        Design::new(&persons, &all, &settings.analysis).map_err(|why| vec![fault("/effect".to_owned(), why)])?;
    }
    Ok(())
}

/// One step: the plan of what is missing, or the result.
fn step(material: &Arc<StudyMaterial>, observer: &dyn Observer) -> Result<Vec<Product>, StudyError> {
    let watcher = Watched(observer);
    let OpenedStudy { mut study, folder, decisions } = opened(material, &watcher)?;
    match study.advance(&folder, &watcher)? {
        GroupStep::Match { purpose, template, tasks, finished, own } => {
            planned((&material.definition, &study), &folder, purpose, (&template, &own), &tasks, finished)
        }
        GroupStep::Matched(matched) => {
            let (study, found) = study.find(&matched, &folder, &decisions, &watcher)?;
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

/// What a check of a template as an upload would say.
fn summary(settings: &Settings, template: &Template) -> Result<InputSummary, StudyError> {
    let input = settings.parameters.input.of_source();
    let prepared = prepare_surface(&template.ply, Some(&file_name(".ply")), &input, &IntakeLimits::default());
    let prepared = prepared
        .map_err(|error| StudyError::Start { what: "its template".to_owned(), why: error.for_command_line() })?;
    let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    Ok(InputSummary {
        n_vertices: number(prepared.mesh.n_vertices()),
        n_faces: number(prepared.mesh.n_faces()),
        report: serde_json::to_value(&prepared.report).unwrap_or_default(),
    })
}

fn planned(
    (definition, study): (&StudyDefinition, &GroupStudy),
    folder: &Folder,
    purpose: Matching,
    (template, own): (&Template, &[Template]),
    tasks: &[Task],
    finished: usize,
) -> Result<Vec<Product>, StudyError> {
    let settings = study.settings();
    let side = |subject: usize| definition.subjects.get(subject).and_then(|subject| subject.side);
    let mirrored = |subject: Option<usize>| subject.is_some_and(|k| is_mirrored(side(k), settings.template_side));
    let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    let plan = StudyPlan {
        round: match purpose {
            Matching::Template(round) => number(round),
            Matching::Visits(_) | Matching::Subjects | Matching::Rivals => 0,
        },
        finished: number(finished),
        tasks: tasks
            .iter()
            .map(|task| PlannedMatch {
                key: task.key.clone(),
                source: task.source,
                target: task.target,
                own: task.own,
                mirrored: [task.source, task.target].map(mirrored),
                rival_of: task.rival.map(|rival| rival.subject),
                parameters: match task.rival {
                    Some(_) => RIVAL_PARAMETERS.map(|(at, value)| (at.to_owned(), value.to_owned())).into(),
                    None => BTreeMap::new(),
                },
            })
            .collect(),
        template: summary(settings, template)?,
        own: own
            .iter()
            .map(|of| Ok(PlannedTemplate { n_bytes: of.ply.len() as u64, surface: summary(settings, of)? }))
            .collect::<Result<_, StudyError>>()?,
    };
    let mut products = vec![
        Product { kind: ArtifactKind::StudyPlan, bytes: json(&plan)? },
        Product { kind: ArtifactKind::StudyTemplate, bytes: template.ply.clone() },
    ];
    if !own.is_empty() {
        let bytes = own.iter().flat_map(|of| of.ply.iter().copied()).collect();
        products.push(Product { kind: ArtifactKind::StudyOwnTemplates, bytes });
    }
    let kept = match definition.structures() {
        none if none.is_empty() => folder.read(blob::KEPT)?,
        structures => packed(folder, &structures)?,
    };
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
