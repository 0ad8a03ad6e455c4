//! The port to the computation: what jobs need from the engine that checks inputs and computes results.
//!
//! Parameters cross this port as JSON only where they come in: a request's in [`Engine::resolve`], a stored job's in
//! [`Engine::restore`]. Both return a [`Computation`], which holds them in the engine's own types, so that nothing is
//! parsed again afterwards. The real engine is [`crate::worker::match_engine`]; tests substitute others.

use super::artifact::ArtifactKind;
use super::demand::{Demand, SurfaceSize};
use super::documents::Verdict;
use super::input_check::{InputRefusal, InputSummary};
use super::job::Failure;
use super::result_part::{PartFormat, PresentError, ResultPart};
use super::study::{ScoreQuestions, StudyDefinition, StudyFault, StudyMaterial};
use bytes::Bytes;
use homolog_primitives::observe::Observer;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::fmt::Debug;
use std::sync::Arc;
use std::time::Duration;

/// Resolves parameters to computations, and converts results.
pub trait Engine: Send + Sync {
    /// The available methods, the default first.
    fn methods(&self) -> Vec<MethodDescription>;

    /// The effective parameters of a request.
    ///
    /// # Errors
    /// Every fault with its location.
    fn resolve(&self, request: &Value) -> Result<Resolved, Vec<ParameterFault>>;

    /// The computation of a stored job, from its effective parameters. An earlier version of this program may have stored
    /// them; what that version did not know takes its default.
    ///
    /// # Errors
    /// The failure with which the job ends, if this version does not accept the parameters.
    fn restore(&self, parameters: &Value) -> Result<Arc<dyn Computation>, Failure>;

    /// The instances of a DICOM series as one file, equal for equal instances in any order.
    ///
    /// # Errors
    /// If the engine takes one file only.
    fn join_instances(&self, instances: Vec<Bytes>) -> Result<Bytes, InputRefusal> {
        let detail = format!("one file is taken, not {}", instances.len());
        Err(InputRefusal { code: "unknown-format".to_owned(), detail, topology: None, place_mm: None })
    }

    /// Checks who is in a study and what is asked, but not the files. Quick.
    ///
    /// # Errors
    /// Every fault that can be seen before the first match.
    fn check_study(&self, study: &StudyDefinition) -> Result<(), Vec<StudyFault>> {
        let _ = study;
        let detail = "this engine computes no studies".to_owned();
        Err(vec![StudyFault { pointer: String::new(), code: "out_of_range".to_owned(), detail }])
    }

    /// Checks whether the matches and the steps of a study, whose inputs have been checked, fit the limits. Quick.
    ///
    /// # Errors
    /// Why they do not.
    fn check_study_size(&self, study: &StudyDefinition) -> Result<(), InputRefusal> {
        let _ = study;
        Ok(())
    }

    /// Checks what is asked about a new subject of a study, but not its file. Quick.
    ///
    /// # Errors
    /// Every fault that can be seen before its match.
    fn check_score(&self, study: &StudyDefinition, asked: &ScoreQuestions) -> Result<(), Vec<StudyFault>> {
        let _ = asked;
        self.check_study(study)
    }

    /// A part of a result in another format than the stored one, from its stored blobs in the order in which the part
    /// lists them; for a report, the energy trace as JSON comes last, for DICOM,
    /// [`DicomDetails`](super::uid::DicomDetails). Called on a blocking thread.
    ///
    /// # Errors
    /// [`PresentError`].
    fn present(&self, part: ResultPart, format: PartFormat, stored: &[&[u8]]) -> Result<Vec<u8>, PresentError> {
        let _ = stored;
        Err(PresentError::NotOffered { part, format })
    }
}

/// The effective parameters of a job in the engine's own types, and what the engine does under them.
pub trait Computation: Debug + Send + Sync {
    /// Checks whether an input can be matched. May take seconds; called on a blocking thread.
    ///
    /// # Errors
    /// Why it cannot.
    fn check_input(&self, input: &InputBytes<'_>) -> Result<InputSummary, InputRefusal>;

    /// A view of an input. May take seconds; called on a blocking thread.
    ///
    /// # Errors
    /// Why there is none.
    fn show_input(&self, input: &InputBytes<'_>, view: InputView) -> Result<Vec<u8>, InputRefusal>;

    /// Checks whether two inputs, each of which has passed its own check, can be matched within the limits. Quick.
    ///
    /// # Errors
    /// Why they cannot.
    fn check_pair(&self, source: &InputSummary, target: &InputSummary) -> Result<(), InputRefusal> {
        let _ = (source, target);
        Ok(())
    }

    /// The predicted demand of a match of surfaces of these sizes. Quick.
    fn demand(&self, source: SurfaceSize, target: SurfaceSize) -> Demand {
        let _ = (source, target);
        Demand::UNKNOWN
    }

    /// Computes a result. Called on a thread of a rayon pool that belongs to the job alone; may panic, which fails this
    /// job only. The result must not depend on the number of threads of the pool.
    ///
    /// # Errors
    /// Why there is no result.
    fn compute(&self, inputs: &ComputeInputs, observer: &dyn Observer) -> Result<Answer, ComputeError>;

    /// The same in a process of its own, if the engine has such processes; then this is called in place of
    /// [`Computation::compute`].
    fn apart(&self) -> Option<&dyn OutOfProcess> {
        None
    }
}

/// Computes in a process of its own.
pub trait OutOfProcess: Send + Sync {
    /// Computes the result of [`Computation::compute`], the same bytes. Called on a thread that may wait; returns soon after the
    /// observer asks to stop, and then nothing of the computation runs any more.
    ///
    /// # Errors
    /// Why there is no result.
    fn compute(
        &self,
        inputs: &ComputeInputs,
        allotted: &Allotted<'_>,
        observer: &dyn Observer,
    ) -> Result<Answer, ComputeError>;
}

/// The resources of a computation in a process of its own.
#[derive(Debug, Clone, Copy)]
pub struct Allotted<'a> {
    /// Threads.
    pub n_threads: usize,
    /// The memory that was planned for it, bytes; 0 if that could not be predicted.
    pub memory_bytes: u64,
    /// Longest run; its processor time is bounded by this on each thread.
    pub max_run: Duration,
    /// Whose it is: a process computes for one owner only.
    pub owner: &'a str,
}

/// A method, for clients to choose.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodDescription {
    /// Name, as in the parameters.
    pub name: String,
    /// Version.
    pub version: String,
    /// One sentence for people.
    pub description: String,
    /// Effective parameters of a request that states nothing else.
    pub defaults: Value,
}

/// The effective parameters of a request: every value, those of the preset included.
#[derive(Debug, Clone)]
pub struct Resolved {
    /// Name of the method.
    pub method: String,
    /// Its version.
    pub method_version: String,
    /// The parameters as JSON, for the store and for clients; [`Engine::restore`] reads them back.
    pub parameters: Value,
    /// The same parameters in the engine's own types.
    pub computation: Arc<dyn Computation>,
    /// The parameters on which the check of the source and that of the target depend: checks of one file under equal keys
    /// have equal outcomes.
    pub input_keys: [String; 2],
    /// Version of everything that a result depends on besides inputs and parameters: equal versions give equal bytes.
    pub result_version: String,
}

/// A fault in the parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParameterFault {
    /// JSON pointer into the parameters.
    pub pointer: String,
    /// Stable name of the kind of fault.
    pub code: String,
    /// Description of the fault, with the allowed values.
    pub detail: String,
}

/// A view of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum InputView {
    /// Its surface as binary PLY, mm; of a refused input, the surface as it is in the file.
    Surface,
    /// Its label volume as NIfTI, compressed with gzip.
    Volume,
}

/// An input as uploaded.
#[derive(Debug, Clone, Copy)]
pub struct InputBytes<'a> {
    /// Content of the file.
    pub bytes: &'a [u8],
    /// Extensions of its file name, such as `.nii.gz`.
    pub name_hint: Option<&'a str>,
    /// Whether it is the target: source and target may have labels of their own.
    pub is_target: bool,
}

/// The two files of a job.
#[derive(Debug, Clone)]
pub struct ComputeInputs {
    /// Content of the source as uploaded.
    pub source: Vec<u8>,
    /// Extensions of its file name.
    pub source_hint: Option<String>,
    /// Content of the target as uploaded.
    pub target: Vec<u8>,
    /// Extensions of its file name.
    pub target_hint: Option<String>,
    /// Purpose of the computation.
    pub purpose: Purpose,
}

/// Purpose of a computation.
#[derive(Debug, Clone, Default)]
pub enum Purpose {
    /// Its result.
    #[default]
    Result,
    /// Its result, and the record that a study keeps of it.
    Record,
    /// A step of a study, from this.
    Step(Arc<StudyMaterial>),
}

/// A result, as it is stored.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Its blobs.
    pub products: Vec<Product>,
    /// Whether it can be relied on, if the engine says so.
    pub verdict: Option<Verdict>,
}

/// One of the blobs of a result.
#[derive(Debug, Clone, PartialEq)]
pub struct Product {
    /// Kind of its content.
    pub kind: ArtifactKind,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Why there is no result.
#[derive(Debug, Clone, PartialEq)]
pub enum ComputeError {
    /// The observer requested cancellation.
    Cancelled,
    /// The computation failed.
    Failed(Failure),
    /// It could not begin, for a reason that may pass.
    NotStarted(String),
}
