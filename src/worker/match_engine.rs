//! The engine of this service, which checks surfaces and matches pairs of them.
//!
//! The only module that connects jobs with [`homolog_run`], [`homolog_run::intake`] and [`homolog_matching`];
//! `study_engine` connects them with `homolog_study`.

use super::file_name::file_name;
use super::price::PriceLimit;
use super::study_engine::{self, StudyStep};
use super::study_score::{self, ScoreStep};
use super::{prediction, presentation};
use crate::jobs::engine::{Answer, MethodDescription, Product, Resolved};
use crate::jobs::study::{ScoreQuestions, StudyDefinition, StudyFault};
use crate::jobs::{
    ArtifactKind, Computation, ComputeError, ComputeInputs, Demand, Engine, Failure, InputBytes, InputRefusal,
    InputSummary, InputView, ParameterFault, PartFormat, PresentError, Purpose, ResultPart, SCORE_METHOD, STEP_METHOD,
    SurfaceSize,
};
use bytes::Bytes;
use homolog_contract::parameters::{MatchParameters, Method, preset, resolve};
use homolog_formats::ply::write_ply;
use homolog_formats::{write_nifti_gz, write_zip};
use homolog_matching::MatchError;
use homolog_primitives::observe::Observer;
use homolog_run::intake::{IntakeError, IntakeLimits, prepare_surface, shown_surface, shown_volume};
use homolog_run::{InputFile, RunError, RunOutput, SurfaceCache, check_size, run_match_with};
use homolog_study::record::Record;
use serde_json::Value;
use std::sync::Arc;

/// An [`Engine`] that matches surfaces.
#[derive(Debug)]
pub struct MatchEngine {
    shared: Arc<Shared>,
}

/// State that all computations of an engine share.
#[derive(Debug)]
struct Shared {
    limits: IntakeLimits,
    price: PriceLimit,
    surfaces: SurfaceCache,
}

/// A match with these effective parameters.
#[derive(Debug)]
struct Match {
    parameters: MatchParameters,
    shared: Arc<Shared>,
}

impl MatchEngine {
    /// An engine with these limits on inputs, which keeps up to `prepared_bytes` of prepared surfaces for later matches.
    pub fn new(limits: IntakeLimits, prepared_bytes: u64) -> Self {
        MatchEngine::priced(limits, PriceLimit::NONE, prepared_bytes)
    }

    /// The same, which refuses what is predicted to cost more processor time than `price` allows.
    pub fn priced(limits: IntakeLimits, price: PriceLimit, prepared_bytes: u64) -> Self {
        MatchEngine { shared: Arc::new(Shared { limits, price, surfaces: SurfaceCache::new(prepared_bytes) }) }
    }

    fn computation(&self, parameters: MatchParameters) -> Arc<dyn Computation> {
        Arc::new(Match { parameters, shared: Arc::clone(&self.shared) })
    }
}

impl Engine for MatchEngine {
    fn join_instances(&self, mut instances: Vec<Bytes>) -> Result<Bytes, InputRefusal> {
        // The files of a series have no order; sorting them by hash gives equal bytes.
        instances.sort_by_cached_key(|bytes| *blake3::hash(bytes).as_bytes());
        let files: Vec<(String, Bytes)> =
            instances.into_iter().zip(1..).map(|(bytes, k)| (format!("{k:05}.dcm"), bytes)).collect();
        write_zip(&files).map(Bytes::from).map_err(|_| InputRefusal {
            code: "too-large".to_owned(),
            detail: "the instances are too many or too large for one series; send those of one segmentation".to_owned(),
            topology: None,
            place_mm: None,
        })
    }

    fn methods(&self) -> Vec<MethodDescription> {
        Method::ALL
            .into_iter()
            .map(|method| MethodDescription {
                name: method.name().to_owned(),
                version: env!("CARGO_PKG_VERSION").to_owned(),
                description: method.description().to_owned(),
                defaults: serde_json::to_value(preset(method)).unwrap_or(Value::Null),
            })
            .collect()
    }

    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>> {
        let parameters = resolve(request).map_err(|faults| {
            faults
                .into_iter()
                .map(|f| ParameterFault { pointer: f.pointer, code: f.code, detail: f.detail })
                .collect::<Vec<_>>()
        })?;
        let stored = serde_json::to_value(&parameters).map_err(|e| vec![unwritable(&e)])?;
        let inputs = [parameters.input.of_source(), parameters.input.of_target()];
        let [source, target] = inputs.map(|input| serde_json::to_value(input).map(|value| value.to_string()));
        let input_keys = [source.map_err(|e| vec![unwritable(&e)])?, target.map_err(|e| vec![unwritable(&e)])?];
        Ok(Resolved {
            method: parameters.method.name().to_owned(),
            method_version: env!("CARGO_PKG_VERSION").to_owned(),
            parameters: stored,
            input_keys,
            result_version: concat!(env!("CARGO_PKG_VERSION"), "+", env!("HOMOLOG_COMMIT")).to_owned(),
            computation: self.computation(parameters),
        })
    }

    fn restore(&self, parameters: &Value) -> Result<Arc<dyn Computation>, Failure> {
        if parameters.get("method").and_then(Value::as_str) == Some(STEP_METHOD) {
            return Ok(Arc::new(StudyStep::restored(parameters)));
        }
        if parameters.get("method").and_then(Value::as_str) == Some(SCORE_METHOD) {
            return Ok(Arc::new(ScoreStep::restored(parameters)?));
        }
        // Effective parameters resolve to themselves, unless another version stored them.
        let parameters = resolve(parameters).map_err(|faults| {
            let first = faults.first().map(|f| format!("{}: {}", f.pointer, f.detail)).unwrap_or_default();
            Failure::new("invalid-parameters", format!("this version does not take the stored parameters: {first}"))
        })?;
        Ok(self.computation(parameters))
    }

    fn check_study(&self, study: &StudyDefinition) -> Result<(), Vec<StudyFault>> {
        study_engine::check(study)
    }

    fn check_score(&self, study: &StudyDefinition, asked: &ScoreQuestions) -> Result<(), Vec<StudyFault>> {
        study_score::check(study, asked)
    }

    fn check_study_size(&self, study: &StudyDefinition) -> Result<(), InputRefusal> {
        study_engine::check_size(study, &self.shared.limits, &self.shared.price)
    }

    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        presentation::present(part, format, stored)
    }
}

impl Computation for Match {
    fn check_input(&self, input: &InputBytes<'_>) -> Result<InputSummary, InputRefusal> {
        let name = input.name_hint.map(file_name);
        let parameters = &self.parameters.input;
        let parameters = if input.is_target { parameters.of_target() } else { parameters.of_source() };
        let prepared = prepare_surface(input.bytes, name.as_deref(), &parameters, &self.shared.limits)
            .map_err(|error| refusal(&error))?;
        Ok(InputSummary {
            n_vertices: u32::try_from(prepared.mesh.n_vertices()).unwrap_or(u32::MAX),
            n_faces: u32::try_from(prepared.mesh.n_faces()).unwrap_or(u32::MAX),
            report: serde_json::to_value(&prepared.report).unwrap_or(Value::Null),
        })
    }

    fn show_input(&self, input: &InputBytes<'_>, view: InputView) -> Result<Vec<u8>, InputRefusal> {
        let name = input.name_hint.map(file_name);
        let parameters = &self.parameters.input;
        let parameters = if input.is_target { parameters.of_target() } else { parameters.of_source() };
        let limits = &self.shared.limits;
        let shown = match view {
            InputView::Surface => {
                shown_surface(input.bytes, name.as_deref(), &parameters, limits).map(|mesh| Some(write_ply(&mesh)))
            }
            InputView::Volume => shown_volume(input.bytes, name.as_deref(), &parameters, limits)
                .map(|volume| volume.as_ref().map(write_nifti_gz)),
        };
        let no_volume = || {
            let (code, detail) = ("not-labels".to_owned(), "the file has a surface and no label volume".to_owned());
            InputRefusal { code, detail, topology: None, place_mm: None }
        };
        shown.map_err(|error| refusal(&error))?.ok_or_else(no_volume)
    }

    fn check_pair(&self, source: &InputSummary, target: &InputSummary) -> Result<(), InputRefusal> {
        let refusal = |detail| InputRefusal { code: "too-large".to_owned(), detail, topology: None, place_mm: None };
        let vertices = (source.n_vertices as usize, source.n_faces as usize);
        check_size(vertices, target.n_vertices as usize, &self.parameters, &self.shared.limits)
            .map_err(|error| refusal(error.to_string()))?;
        let size = |input: &InputSummary| SurfaceSize { n_vertices: input.n_vertices, n_faces: input.n_faces };
        self.shared
            .price
            .check(&self.demand(size(source), size(target)))
            .map_err(|over| refusal(prediction::too_dear(&self.parameters, size(source), size(target), over)))
    }

    fn demand(&self, source: SurfaceSize, target: SurfaceSize) -> Demand {
        prediction::predict(&self.parameters, source, target)
    }

    fn compute(&self, inputs: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError> {
        let (source_name, target_name) =
            (inputs.source_hint.as_deref().map(file_name), inputs.target_hint.as_deref().map(file_name));
        let source = InputFile { bytes: &inputs.source, name: source_name.as_deref() };
        let target = InputFile { bytes: &inputs.target, name: target_name.as_deref() };
        let Shared { limits, surfaces, .. } = self.shared.as_ref();
        let output = run_match_with(surfaces, source, target, &self.parameters, limits, observer);
        let output = output.map_err(compute_error)?;
        let record = matches!(inputs.purpose, Purpose::Record).then(|| Record::of(&output).to_bytes());
        let mut answer = answer(output).map_err(ComputeError::Failed)?;
        answer.products.extend(record.map(|bytes| Product { kind: ArtifactKind::StudyRecord, bytes }));
        Ok(answer)
    }
}

/// The blobs of a result. The correspondences have their own blob, because they are large and rarely needed.
fn answer(output: RunOutput) -> Result<Answer, Failure> {
    let aligned = output
        .aligned()
        .map_err(|_| Failure::new("internal-error", "the aligned surface has coordinates that are not finite"))?;
    let RunOutput { mut document, source, target } = output;
    env!("HOMOLOG_COMMIT").clone_into(&mut document.provenance.commit);
    let correspondences = document.correspondences.take().unwrap_or_default();
    let written = |e: serde_json::Error| Failure::new("internal-error", format!("the result cannot be written: {e}"));
    let products = vec![
        Product { kind: ArtifactKind::Result, bytes: serde_json::to_vec(&document).map_err(written)? },
        Product { kind: ArtifactKind::Correspondences, bytes: serde_json::to_vec(&correspondences).map_err(written)? },
        Product { kind: ArtifactKind::SourceSurface, bytes: write_ply(&source) },
        Product { kind: ArtifactKind::TargetSurface, bytes: write_ply(&target) },
        Product { kind: ArtifactKind::Aligned, bytes: write_ply(&aligned) },
    ];
    Ok(Answer { products, verdict: Some(document.verdict()) })
}

fn refusal(error: &IntakeError) -> InputRefusal {
    InputRefusal {
        code: error.code().to_owned(),
        detail: error.to_string(),
        topology: error.topology().and_then(|report| serde_json::to_value(report).ok()),
        place_mm: error.place_mm(),
    }
}

fn compute_error(error: RunError) -> ComputeError {
    if error.is_cancelled() {
        return ComputeError::Cancelled;
    }
    ComputeError::Failed(match error {
        RunError::Input { side, error } => {
            let InputRefusal { code, detail, topology, place_mm } = refusal(&error);
            Failure { code, detail, input: Some(side.name().to_owned()), topology, place_mm: place_mm.map(Box::new) }
        }
        RunError::TooLarge { .. } => Failure::new("too-large", error.to_string()),
        RunError::Match(MatchError::NoRegistration { .. }) => Failure::new("no-registration", error.to_string()),
        RunError::Match(_) => Failure::new("match-failed", error.to_string()),
    })
}

fn unwritable(error: &serde_json::Error) -> ParameterFault {
    ParameterFault { pointer: String::new(), code: "out_of_range".to_owned(), detail: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn stored_parameters_are_restored_as_they_were_resolved() {
        let engine = MatchEngine::new(IntakeLimits::default(), 0);
        let size = |n_vertices| SurfaceSize { n_vertices, n_faces: 2 * n_vertices - 4 };
        for method in Method::ALL {
            let resolved = engine.resolve(&json!({"method": method.name(), "seed": 7})).unwrap();
            let restored = engine.restore(&resolved.parameters).unwrap();
            // The types are opaque; their debug texts show every parameter.
            assert_eq!(format!("{restored:?}"), format!("{:?}", resolved.computation));
            let demand = restored.demand(size(20_000), size(10_000));
            assert_eq!(
                demand,
                prediction::predict(&MatchParameters { seed: 7, ..preset(method) }, size(20_000), size(10_000))
            );
        }
    }

    #[test]
    fn parameters_of_an_earlier_version_take_defaults_and_unknown_ones_end_the_job() {
        let engine = MatchEngine::new(IntakeLimits::default(), 0);
        let mut stored = engine.resolve(&json!({})).unwrap().parameters;
        let whole = format!("{:?}", engine.restore(&stored).unwrap());
        stored.as_object_mut().unwrap().remove("input").unwrap();
        assert_eq!(format!("{:?}", engine.restore(&stored).unwrap()), whole);
        stored["later"] = json!(1);
        let failure = engine.restore(&stored).unwrap_err();
        assert_eq!(failure.code, "invalid-parameters");
        assert!(failure.detail.contains("/later"), "{}", failure.detail);
    }
}
