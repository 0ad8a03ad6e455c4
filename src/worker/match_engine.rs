//! The engine of this service: checks the two inputs of a match and computes it.
//!
//! The only place where jobs meet [`homolog_run`], [`homolog_run::intake`] and [`homolog_matching`].

use super::{prediction, presentation};
use crate::jobs::engine::{MethodDescription, Product, Resolved};
use crate::jobs::uploads::input_key;
use crate::jobs::{
    ArtifactKind, ComputeError, ComputeTask, Demand, Engine, Failure, InputBytes, InputRefusal, InputSummary,
    ParameterFault, PartFormat, PresentError, ResultPart, SurfaceSize,
};
use homolog_contract::parameters::{MatchParameters, Method, preset, resolve};
use homolog_formats::ply::write_ply;
use homolog_matching::MatchError;
use homolog_primitives::observe::Observer;
use homolog_run::intake::{IntakeError, IntakeLimits, prepare_surface};
use homolog_run::{InputFile, RunError, RunOutput, SurfaceCache, check_size, run_match_with};
use serde_json::{Value, json};
use utoipa::{PartialSchema, ToSchema};

/// An [`Engine`] that matches surfaces.
#[derive(Debug)]
pub struct MatchEngine {
    limits: IntakeLimits,
    surfaces: SurfaceCache,
}

impl MatchEngine {
    /// An engine that reads inputs within `limits` and keeps up to `prepared_bytes` of prepared surfaces for further matches.
    pub fn new(limits: IntakeLimits, prepared_bytes: u64) -> Self {
        MatchEngine { limits, surfaces: SurfaceCache::new(prepared_bytes) }
    }
}

impl Engine for MatchEngine {
    fn methods(&self) -> Vec<MethodDescription> {
        let schema = parameters_schema();
        Method::ALL
            .into_iter()
            .map(|method| MethodDescription {
                name: method.name().to_owned(),
                version: env!("CARGO_PKG_VERSION").to_owned(),
                description: method.description().to_owned(),
                defaults: serde_json::to_value(preset(method)).unwrap_or(Value::Null),
                parameters_schema: schema.clone(),
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
        Ok(Resolved {
            method: parameters.method.name().to_owned(),
            method_version: env!("CARGO_PKG_VERSION").to_owned(),
            input_key: input_key(&stored),
            result_version: concat!(env!("CARGO_PKG_VERSION"), "+", env!("HOMOLOG_COMMIT")).to_owned(),
            parameters: stored,
        })
    }

    fn check_input(&self, input: &InputBytes<'_>, parameters: &Value) -> Result<InputSummary, InputRefusal> {
        let parameters = effective(parameters).map_err(|failure| InputRefusal {
            code: failure.code,
            detail: failure.detail,
            topology: None,
        })?;
        let name = input.name_hint.map(file_name);
        let prepared = prepare_surface(input.bytes, name.as_deref(), &parameters.input, &self.limits)
            .map_err(|error| refusal(&error))?;
        Ok(InputSummary {
            n_vertices: u32::try_from(prepared.mesh.n_vertices()).unwrap_or(u32::MAX),
            n_faces: u32::try_from(prepared.mesh.n_faces()).unwrap_or(u32::MAX),
            report: serde_json::to_value(&prepared.report).unwrap_or(Value::Null),
        })
    }

    fn check_pair(&self, source: &InputSummary, target: &InputSummary, parameters: &Value) -> Result<(), InputRefusal> {
        let parameters = effective(parameters).map_err(|failure| InputRefusal {
            code: failure.code,
            detail: failure.detail,
            topology: None,
        })?;
        let source = (source.n_vertices as usize, source.n_faces as usize);
        check_size(source, target.n_vertices as usize, &parameters, &self.limits).map_err(|error| InputRefusal {
            code: "too-large".to_owned(),
            detail: error.to_string(),
            topology: None,
        })
    }

    fn demand(&self, parameters: &Value, source: SurfaceSize, target: SurfaceSize) -> Demand {
        // A job whose parameters this version does not accept fails as soon as it starts.
        let nothing = Demand { cores: 1, memory_bytes: 0 };
        effective(parameters).map_or(nothing, |parameters| prediction::predict(&parameters, source, target))
    }

    fn compute(&self, task: &ComputeTask, observer: &dyn Observer) -> Result<Vec<Product>, ComputeError> {
        let parameters = effective(&task.parameters).map_err(ComputeError::Failed)?;
        let (source_name, target_name) =
            (task.source_hint.as_deref().map(file_name), task.target_hint.as_deref().map(file_name));
        let source = InputFile { bytes: &task.source, name: source_name.as_deref() };
        let target = InputFile { bytes: &task.target, name: target_name.as_deref() };
        let output = run_match_with(&self.surfaces, source, target, &parameters, &self.limits, observer);
        products(output.map_err(compute_error)?).map_err(ComputeError::Failed)
    }

    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        presentation::present(part, format, stored)
    }
}

/// The blobs of a result. Correspondences have a blob of their own, so that they are read only when requested.
fn products(output: RunOutput) -> Result<Vec<Product>, Failure> {
    let aligned = output
        .aligned()
        .map_err(|_| Failure::new("internal-error", "the aligned surface has coordinates that are not finite"))?;
    let RunOutput { mut document, source, target } = output;
    let correspondences = document.correspondences.take().unwrap_or_default();
    let written = |e: serde_json::Error| Failure::new("internal-error", format!("the result cannot be written: {e}"));
    Ok(vec![
        Product { kind: ArtifactKind::Result, bytes: serde_json::to_vec(&document).map_err(written)? },
        Product { kind: ArtifactKind::Correspondences, bytes: serde_json::to_vec(&correspondences).map_err(written)? },
        Product { kind: ArtifactKind::SourceSurface, bytes: write_ply(&source) },
        Product { kind: ArtifactKind::TargetSurface, bytes: write_ply(&target) },
        Product { kind: ArtifactKind::Aligned, bytes: write_ply(&aligned) },
    ])
}

/// Parameters as stored with a job. They resolve to themselves, unless another version of this program stored them.
fn effective(stored: &Value) -> Result<MatchParameters, Failure> {
    resolve(stored).map_err(|faults| {
        let first = faults.first().map(|f| format!("{}: {}", f.pointer, f.detail)).unwrap_or_default();
        Failure::new("invalid-parameters", format!("this version does not accept the stored parameters: {first}"))
    })
}

/// A file name that shows the format and nothing else.
fn file_name(hint: &str) -> String {
    format!("input{hint}")
}

fn refusal(error: &IntakeError) -> InputRefusal {
    InputRefusal {
        code: error.code().to_owned(),
        detail: error.to_string(),
        topology: error.topology().and_then(|report| serde_json::to_value(report).ok()),
    }
}

fn compute_error(error: RunError) -> ComputeError {
    if error.is_cancelled() {
        return ComputeError::Cancelled;
    }
    ComputeError::Failed(match error {
        RunError::Input { side, error } => {
            let InputRefusal { code, detail, topology } = refusal(&error);
            Failure { code, detail, input: Some(side.name().to_owned()), topology }
        }
        RunError::TooLarge { .. } => Failure::new("too-large", error.to_string()),
        RunError::Match(MatchError::NoRegistration { .. }) => Failure::new("no-registration", error.to_string()),
        RunError::Match(_) => Failure::new("match-failed", error.to_string()),
    })
}

fn unwritable(error: &serde_json::Error) -> ParameterFault {
    ParameterFault { pointer: String::new(), code: "out_of_range".to_owned(), detail: error.to_string() }
}

/// The JSON Schema of the parameters, self-contained. Every value may be omitted; the preset's value is then used.
fn parameters_schema() -> Value {
    let mut named = Vec::new();
    MatchParameters::schemas(&mut named);
    let definitions: serde_json::Map<String, Value> = named
        .into_iter()
        .filter_map(|(name, schema)| serde_json::to_value(schema).ok().map(|value| (name, value)))
        .collect();
    let mut schema = serde_json::to_value(MatchParameters::schema()).unwrap_or(Value::Null);
    if let Value::Object(root) = &mut schema {
        root.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
        root.insert("$defs".to_owned(), Value::Object(definitions));
    }
    make_self_contained(&mut schema);
    schema
}

/// Redirects references to `$defs` and removes lists of required keys, except from entries of `features`.
fn make_self_contained(schema: &mut Value) {
    match schema {
        Value::Object(map) => {
            if let Some(Value::String(reference)) = map.get_mut("$ref") {
                *reference = reference.replace("#/components/schemas/", "#/$defs/");
            }
            // A request's `features` replace the preset's list, so each entry must be complete.
            let is_entry = map.get("properties").is_some_and(|p| p.get("kind").is_some());
            if !is_entry {
                map.remove("required");
            }
            map.values_mut().for_each(make_self_contained);
        }
        Value::Array(items) => items.iter_mut().for_each(make_self_contained),
        _ => {}
    }
}
