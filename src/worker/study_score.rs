//! The score of a new subject against a study: its match with the template, and its comparison with the model.
//!
//! The subject is the last of the study's material and has the role `score`. Nothing of the study is stored again.

use super::opened_study::{OpenedStudy, Watched, cohort, failure, internal_error, no_match, opened_with_new, settings};
use super::prediction::predict;
use super::study_demand::demand_of;
use crate::jobs::engine::{Answer, Product};
use crate::jobs::study::{ScoreQuestions, StudyDefinition, StudyFault, StudyMaterial};
use crate::jobs::{
    ArtifactKind, Computation, ComputeError, ComputeInputs, Demand, Failure, InputBytes, InputRefusal, InputSummary,
    InputView, Purpose, SurfaceSize,
};
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_contract::study::StudySize;
use homolog_primitives::observe::Observer;
use homolog_run::SurfaceCache;
use homolog_study::StudyError;
use homolog_study::adjustment::Adjustment;
use homolog_study::folder::record_name;
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Purpose as Matching, Records as _, Step, Task};
use homolog_study::record::Record;
use homolog_study::score::{NewSubject, Reference, Subgroup, add, check_group, score};
use serde::Deserialize as _;
use serde_json::Value;
use std::path::PathBuf;
use std::sync::Arc;

/// The part of a job's work that the match is.
const MATCH_SHARE: f64 = 0.7;
/// Memory of an adjustment for each vertex of each subject, bytes.
const RESIDUALS: u64 = 36;

/// The score of a new subject.
#[derive(Debug)]
pub(super) struct ScoreStep {
    size: StudySize,
    asked: ScoreQuestions,
    /// Those of the match with the template.
    parameters: MatchParameters,
}

/// Questions about a new subject in stored parameters.
///
/// # Errors
/// That of `serde_json`, if the parameters have none.
pub(super) fn asked(parameters: &Value) -> serde_json::Result<ScoreQuestions> {
    ScoreQuestions::deserialize(&parameters["score"])
}

impl ScoreStep {
    /// The computation of stored parameters.
    ///
    /// # Errors
    /// `invalid-parameters`.
    pub(super) fn restored(parameters: &Value) -> Result<Self, Failure> {
        let unknown = |error: &dyn std::fmt::Display| {
            Failure::new("invalid-parameters", format!("this version does not take the stored parameters: {error}"))
        };
        let size = StudySize::deserialize(&parameters["size"]).map_err(|error| unknown(&error))?;
        let asked = asked(parameters).map_err(|error| unknown(&error))?;
        let parameters = resolve(&parameters["match"])
            .map_err(|faults| unknown(&faults.first().map_or("match", |fault| fault.detail.as_str())))?;
        Ok(ScoreStep { size, asked, parameters })
    }
}

/// What the subject is compared with.
fn reference(asked: &ScoreQuestions) -> Reference {
    Reference {
        within: asked.group.clone().map(|(covariate, level)| Subgroup { covariate, level }),
        adjustment: Adjustment { covariates: asked.adjust.clone(), values: asked.covariates.clone() },
    }
}

/// Checks what is asked, but not the file.
///
/// # Errors
/// Every fault that can be seen before the match.
pub(super) fn check(definition: &StudyDefinition, asked: &ScoreQuestions) -> Result<(), Vec<StudyFault>> {
    let fault = |pointer: &str, error: &dyn std::fmt::Display| {
        let code = "out_of_range".to_owned();
        vec![StudyFault { pointer: pointer.to_owned(), code, detail: error.to_string() }]
    };
    let mut cohort = cohort(definition).map_err(|error| fault("", &error))?;
    if !cohort.structures().is_empty() {
        let why =
            "a new subject is compared in a study of one structure, and this one has several; submit a study of each";
        return Err(fault("", &why));
    }
    let mut settings = settings(definition).map_err(|error| fault("", &error))?;
    let reference = reference(asked);
    check_group(&cohort, reference.within.as_ref()).map_err(|error| fault("/group", &error))?;
    let names = &asked.adjust;
    let is_sound = |(k, name): (usize, &String)| cohort.covariate(name).is_some() && !names[..k].contains(name);
    let place = if names.iter().enumerate().all(is_sound) { "/covariates" } else { "/adjust" };
    reference.adjustment.check(&cohort).map_err(|error| fault(place, &error))?;
    let new = NewSubject { file: PathBuf::new(), side: asked.side, labels: None };
    add(&mut cohort, &mut settings, new).map_err(|error| fault("/side", &error))?;
    Ok(())
}

impl Computation for ScoreStep {
    fn check_input(&self, _: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        Err(no_match())
    }

    fn show_input(&self, _: &InputBytes<'_>, _: InputView) -> Result<Vec<u8>, InputRefusal> {
        Err(no_match())
    }

    /// That of the match with the template, and that of a step of the study without its statistics.
    fn demand(&self, subject: SurfaceSize, _: SurfaceSize) -> Demand {
        let number = |n: u64| u32::try_from(n).unwrap_or(u32::MAX);
        let template = SurfaceSize { n_vertices: number(self.size.vertices), n_faces: number(self.size.faces) };
        let of_match = predict(&self.parameters, template, subject);
        let of_step = demand_of(&StudySize { contrasts: 0, permutations: Some(0), ..self.size });
        // The residuals of all members, of values and of shapes.
        let of_residuals = if self.asked.adjust.is_empty() { 0 } else { RESIDUALS };
        let of_residuals = self.size.subjects.saturating_mul(self.size.vertices).saturating_mul(of_residuals);
        Demand {
            cores: of_match.cores.max(of_step.cores),
            memory_bytes: of_match.memory_bytes.saturating_add(of_step.memory_bytes).saturating_add(of_residuals),
            processor_time: of_match.processor_time + of_step.processor_time,
        }
    }

    fn compute(&self, inputs: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError> {
        let Purpose::Step(material) = &inputs.purpose else {
            return Err(ComputeError::Failed(internal_error()));
        };
        let product = scored(material, &self.asked, observer).map_err(|error| match error {
            StudyError::Interrupted => ComputeError::Cancelled,
            error => ComputeError::Failed(failure(&error)),
        })?;
        Ok(Answer { products: vec![product], verdict: None })
    }
}

fn scored(
    material: &Arc<StudyMaterial>,
    asked: &ScoreQuestions,
    observer: &dyn Observer,
) -> Result<Product, StudyError> {
    let watcher = Watched(observer);
    let OpenedStudy { mut study, folder, decisions } = opened_with_new(material, &watcher)?;
    let k = study.cohort.subjects.len() - 1;
    let surfaces = SurfaceCache::new(0);
    let mut step = study.advance(&folder, &watcher)?;
    while let Step::Match { purpose, template, tasks, own, .. } = &step
        && !matches!(purpose, Matching::Template(_))
    {
        // Whatever else is missing was removed since: its subject has no match, as in a study without it.
        let is_own = |task: &Task| {
            task.target == Some(k) && task.source.is_none() || task.rival.is_some_and(|rival| rival.subject == k)
        };
        for task in tasks {
            let record = match is_own(task) {
                true => study.compute(task, (template, own), &surfaces, &folder, &watcher)?,
                false => Record::failed("the match was removed".to_owned()),
            };
            folder.keep(&task.key, &record)?;
        }
        observer.progress(MATCH_SHARE);
        step = study.advance(&folder, &watcher)?;
    }
    let Step::Matched(matched) = step else {
        return Err(StudyError::Settings("the template of the study is not there any more".to_owned()));
    };
    debug_assert!(folder.has(&matched.keys[k]), "{}", record_name(&matched.keys[k]));
    if watcher.is_interrupted() {
        return Err(StudyError::Interrupted);
    }
    let found = score(&study, &matched, &folder, &decisions, (k, &reference(asked)), &watcher)?;
    let bytes = serde_json::to_vec(&found.document(env!("HOMOLOG_COMMIT")))
        .map_err(|error| StudyError::Internal(format!("a score cannot be written: {error}")))?;
    Ok(Product { kind: ArtifactKind::StudyScore, bytes })
}
