//! Messages between a process and its children.
//!
//! Numbers are sent as JSON with enough digits to restore the same bits, so a child computes the same bits as the
//! process itself.

use crate::jobs::study::StudyDefinition;
use crate::jobs::{ArtifactKind, Failure, InputRefusal, InputSummary, InputView, PartFormat, PresentError, ResultPart};
use crate::worker::error_text::with_sources;
use homolog_contract::verdict::Verdict;
use homolog_primitives::observe::{Phase, TracePoint};
use homolog_run::intake::IntakeLimits;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The first message to a child.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Handshake {
    /// The version of the parent; a child of another version ends.
    pub(super) version: String,
    /// Limits on inputs.
    pub(super) limits: IntakeLimits,
    /// Memory for prepared surfaces, bytes.
    pub(super) prepared_bytes: u64,
}

/// A request to a child. The next request follows the last answer to this one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Request {
    /// Check or show the input in the body.
    Input {
        /// Effective parameters.
        parameters: Value,
        /// Extensions of the file name.
        name_hint: Option<String>,
        /// Whether the input is the target.
        is_target: bool,
        /// The requested view; `None` for a check.
        view: Option<InputView>,
    },
    /// Match the two files in the body, the source first.
    Match {
        /// Effective parameters.
        parameters: Value,
        /// Extensions of the file names.
        hints: [Option<String>; 2],
        /// Bytes of the source.
        source_bytes: usize,
        /// Whether the record that a study keeps is also requested.
        record: bool,
        /// Threads to compute on.
        n_threads: usize,
    },
    /// Compute a step of a study.
    Step {
        /// Effective parameters.
        parameters: Value,
        /// The study and the step.
        definition: Box<StudyDefinition>,
        /// The files of the study's folder in the body: names and lengths, in order.
        files: Vec<(String, usize)>,
        /// Matches without an answer, and the reasons.
        failures: Vec<(String, String)>,
        /// Threads to compute on.
        n_threads: usize,
    },
    /// The fetched upload, in the body.
    Fetched {
        /// Why the upload cannot be read.
        error: Option<String>,
    },
    /// Convert the blobs in the body.
    Present {
        /// The part.
        part: ResultPart,
        /// The format.
        format: PartFormat,
        /// The lengths of the blobs, in order.
        lengths: Vec<usize>,
    },
    /// Try the actions that a computation must not be able to perform.
    Attempt,
}

/// A message from a child. Every message after the first one belongs to a request.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ChildMessage {
    /// The child takes requests.
    Ready {
        /// The confinement of the child.
        confinement: Confinement,
        /// Memory that each of its threads reserves for matrix products, bytes.
        scratch_bytes: u64,
    },
    /// A phase of the computation begins.
    Phase(Phase),
    /// The share of the work that is done, from 0 to 1.
    Progress(f64),
    /// A point of the energy trace.
    Trace(TracePoint),
    /// The child needs the upload with this hash.
    Fetch(String),
    /// A blob of the result, in the body.
    Product(ArtifactKind),
    /// The last answer to a request.
    Done {
        /// The outcome of the request.
        outcome: Outcome,
        /// Use of the kept surfaces by this request.
        kept: KeptSurfaces,
    },
}

/// How a request ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Outcome {
    /// The result is in the products.
    Answered(Option<Verdict>),
    /// The computation failed.
    Failed(Failure),
    /// The input can be matched.
    Fit(InputSummary),
    /// The input cannot be matched, or has no such view.
    Unfit(InputRefusal),
    /// The view or the converted part is in the body.
    Made,
    /// The part cannot be converted.
    NotMade(NotMade),
    /// The computation panicked at this location.
    Panicked(Option<String>),
    /// The system provided no threads.
    NoThreads(String),
    /// The attempted actions that succeeded.
    Attempted(Vec<String>),
}

/// The wire form of [`PresentError`].
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum NotMade {
    /// As in [`PresentError`].
    NotOffered,
    /// As in [`PresentError`].
    NoInverse,
    /// As in [`PresentError`].
    NotDicom,
    /// As in [`PresentError`].
    NoSegmentation,
    /// As in [`PresentError`], with its cause.
    Unreadable(String),
}

impl From<PresentError> for NotMade {
    fn from(error: PresentError) -> Self {
        match error {
            PresentError::NotOffered { .. } => NotMade::NotOffered,
            PresentError::NoInverse => NotMade::NoInverse,
            PresentError::NotDicom => NotMade::NotDicom,
            PresentError::NoSegmentation => NotMade::NoSegmentation,
            error @ PresentError::Unreadable { .. } => NotMade::Unreadable(with_sources(&error)),
        }
    }
}

impl NotMade {
    /// The error of this part in this format.
    pub(super) fn error(self, part: ResultPart, format: PartFormat) -> PresentError {
        match self {
            NotMade::NotOffered => PresentError::NotOffered { part, format },
            NotMade::NoInverse => PresentError::NoInverse,
            NotMade::NotDicom => PresentError::NotDicom,
            NotMade::NoSegmentation => PresentError::NoSegmentation,
            NotMade::Unreadable(why) => {
                PresentError::Unreadable { what: "a stored part of a result", source: Some(why.into()) }
            }
        }
    }
}

/// Lookups of a child among the surfaces that it keeps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct KeptSurfaces {
    /// Lookups of this request that found a surface.
    pub(super) hits: u64,
    /// Lookups of this request that found none.
    pub(super) misses: u64,
    /// Memory of the kept surfaces, bytes.
    pub(super) bytes: u64,
}

/// The confinement of a child.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Confinement {
    /// Landlock: the child can open neither files nor connections.
    pub(super) landlock: bool,
    /// Seccomp: the kernel refuses system calls that reach other processes, files and machines.
    pub(super) seccomp: bool,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::jobs::{WarpDirection, WarpSpace};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn trace_points_cross_with_the_same_bits(
            numbers in prop::array::uniform4(any::<f64>().prop_filter("the trace has no other numbers", |x| x.is_finite())),
            iteration in any::<u32>(),
        ) {
            let [energy, energy_unary, temperature, lower_bound] = numbers.map(Some);
            let point = TracePoint { energy, energy_unary, temperature, lower_bound, ..TracePoint::new(1, Phase::Inference, iteration) };
            let text = serde_json::to_string(&ChildMessage::Trace(point.clone())).unwrap();
            let ChildMessage::Trace(read) = serde_json::from_str(&text).unwrap() else { panic!("{text}") };
            prop_assert_eq!(format!("{read:?}"), format!("{point:?}"));
        }
    }

    #[test]
    fn parts_of_a_result_cross_unchanged() {
        let directions = [WarpDirection::Forward, WarpDirection::Inverse];
        let spaces = [WarpSpace::Source, WarpSpace::Target];
        let warped = directions.map(|direction| spaces.map(|space| ResultPart::Warped { direction, space }));
        let pairs = directions.map(|direction| ResultPart::Correspondences { direction });
        let others = [
            ResultPart::Transform,
            ResultPart::SourceSurface,
            ResultPart::TargetSurface,
            ResultPart::Aligned,
            ResultPart::Report,
        ];
        for part in warped.into_iter().flatten().chain(pairs).chain(others) {
            let text = serde_json::to_string(&part).unwrap();
            assert_eq!(serde_json::from_str::<ResultPart>(&text).unwrap(), part, "{text}");
        }
    }

    #[test]
    fn limits_cross_unchanged() {
        let limits =
            IntakeLimits { max_voxels: 7, max_inflation: 3, max_match_bytes: u64::MAX, ..IntakeLimits::default() };
        let beginning = Handshake { version: "v".to_owned(), limits, prepared_bytes: 1 };
        let text = serde_json::to_string(&beginning).unwrap();
        assert_eq!(serde_json::from_str::<Handshake>(&text).unwrap(), beginning);
        // A program with one field more or fewer has another version.
        let other = text.replacen("max_voxels", "most_voxels", 1);
        assert!(serde_json::from_str::<Handshake>(&other).is_err());
    }
}
