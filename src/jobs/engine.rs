//! The port to the computation: what jobs need from whoever checks inputs and computes results.
//!
//! The one real implementation is [`crate::worker::match_engine`]; tests put others in its place.

use super::demand::{Demand, SurfaceSize};
use super::ports::ArtifactKind;
use super::presentation::{PartFormat, PresentError, ResultPart};
use homolog_primitives::observe::Observer;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Checks and computes.
pub trait Engine: Send + Sync {
    /// The methods there are, the default first.
    fn methods(&self) -> Vec<MethodDescription>;

    /// The effective parameters of a request.
    ///
    /// # Errors
    /// Every fault with its place.
    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>>;

    /// Whether an input can be matched under these effective parameters. May take seconds; called on a blocking thread.
    ///
    /// # Errors
    /// Why not.
    fn check_input(&self, input: &InputBytes<'_>, parameters: &Value) -> Result<InputSummary, InputRefusal>;

    /// Whether two inputs, each fine by itself, can be matched within the limits. Quick.
    ///
    /// # Errors
    /// Why not.
    fn check_pair(&self, source: &InputSummary, target: &InputSummary, parameters: &Value) -> Result<(), InputRefusal> {
        let _ = (source, target, parameters);
        Ok(())
    }

    /// What computing a job with these effective parameters on surfaces of these sizes will take. Quick.
    fn demand(&self, parameters: &Value, source: SurfaceSize, target: SurfaceSize) -> Demand {
        let _ = (parameters, source, target);
        Demand::UNKNOWN
    }

    /// Computes a result. Called on a thread of a rayon pool that is the job's own; may panic, which fails this job
    /// only. The result must not depend on the number of the pool's threads.
    ///
    /// # Errors
    /// Why there is none.
    fn compute(&self, task: &ComputeTask, observer: &dyn Observer) -> Result<Vec<Product>, ComputeError>;

    /// A part of a result in another format than the stored one, from its stored blobs in the order in which the part
    /// names them. Called on a blocking thread.
    ///
    /// # Errors
    /// [`PresentError`].
    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        let _ = stored;
        Err(PresentError::NotOffered { part, format })
    }
}

/// A method, for clients to choose.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct MethodDescription {
    /// Name, as in the parameters.
    pub name: String,
    /// Version.
    pub version: String,
    /// One sentence for people.
    pub description: String,
    /// Effective parameters of a request that states nothing else.
    pub defaults: Value,
    /// JSON Schema of the parameters: ranges, units, what each does.
    pub parameters_schema: Value,
}

/// Effective parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Resolved {
    /// Name of the method.
    pub method: String,
    /// Its version.
    pub method_version: String,
    /// Every value.
    pub parameters: Value,
    /// What the check of an input depends on, as a text: checks of one file under equal keys find the same.
    pub input_key: String,
    /// Version of all that a result depends on besides inputs and parameters; equal ones give the same bytes.
    pub result_version: String,
}

/// A fault in the parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParameterFault {
    /// JSON pointer into the parameters.
    pub pointer: String,
    /// Which kind.
    pub code: String,
    /// What is wrong and what is allowed.
    pub detail: String,
}

/// The bytes of an input.
#[derive(Debug, Clone, Copy)]
pub struct InputBytes<'a> {
    /// The whole file.
    pub bytes: &'a [u8],
    /// The endings of its name, such as `.nii.gz`.
    pub name_hint: Option<&'a str>,
}

/// An input that can be matched.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputSummary {
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs.
    pub report: Value,
}

/// An input that cannot be matched.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputRefusal {
    /// Stable name of the problem.
    pub code: String,
    /// Where and why.
    pub detail: String,
    /// Topology of the surface that was refused.
    pub topology: Option<Value>,
}

/// What is to be computed.
#[derive(Debug, Clone)]
pub struct ComputeTask {
    /// Effective parameters.
    pub parameters: Value,
    /// Bytes of the source as uploaded.
    pub source: Vec<u8>,
    /// Endings of its name.
    pub source_hint: Option<String>,
    /// Bytes of the target as uploaded.
    pub target: Vec<u8>,
    /// Endings of its name.
    pub target_hint: Option<String>,
}

/// One of the blobs that make a result.
#[derive(Debug, Clone, PartialEq)]
pub struct Product {
    /// Which.
    pub kind: ArtifactKind,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// Why there is no result.
#[derive(Debug, Clone, PartialEq)]
pub enum ComputeError {
    /// The observer asked for the end.
    Cancelled,
    /// It cannot be computed.
    Failed(super::job::Failure),
}
