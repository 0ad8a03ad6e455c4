//! Reasons why a study cannot continue.

use crate::cohort::CohortError;
use homolog_mesh::MeshError;
use homolog_primitives::observe::Cancelled;
use homolog_registration::OrientationError;
use std::path::PathBuf;

/// Reasons why a study cannot continue. A subject that cannot be read or matched is not an error: it is listed with the
/// reason.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The table of subjects is faulty.
    #[error(transparent)]
    Cohort(#[from] CohortError),
    /// A name in the settings is unknown, or the requested computation is impossible.
    #[error("{0}")]
    Settings(String),
    /// The operating system or the program failed.
    #[error("{0}")]
    Internal(String),
    /// The first surface of the template is unsuitable.
    #[error("the template cannot begin from {what}: {why}; choose another with --start, or give one with --template")]
    Start {
        /// The surface.
        what: String,
        /// The reason.
        why: String,
    },
    /// Too few subjects were matched.
    #[error(
        "only {matched} of {all} subjects could be matched, which is too few {purpose}; the first failed with: {reason}"
    )]
    TooFewMatches {
        /// Matched subjects.
        matched: usize,
        /// Subjects tried.
        all: usize,
        /// Purpose of the matches.
        purpose: &'static str,
        /// Reason of the first failure.
        reason: String,
    },
    /// A structure of a study of several cannot be studied.
    #[error("structure {structure}: {error}")]
    Structure {
        /// The structure.
        structure: String,
        /// The reason.
        error: Box<StudyError>,
    },
    /// A shape has no orientation.
    #[error("subject {id} cannot be aligned with the mean: {error}; drop it with a decision")]
    Alignment {
        /// The subject.
        id: String,
        /// The reason.
        error: OrientationError,
    },
    /// Coordinates overflowed.
    #[error("a mean surface cannot be computed: {0}")]
    Mesh(#[from] MeshError),
    /// An eigenvalue decomposition failed.
    #[error("the shape model cannot be computed: {0} has no eigenvalue decomposition")]
    Decomposition(&'static str),
    /// A file cannot be read or written.
    #[error("cannot {what} {}: {source}", path.display())]
    File {
        /// `read` or `write`.
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
    /// A file of the study's folder is damaged.
    #[error("{} is damaged: {why}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The fault and its remedy.
        why: String,
    },
    /// A file differs from the one named in `study.json`.
    #[error("{} is not the file of the study: its content has changed since; restore it, or begin a new study", path.display())]
    Changed {
        /// The file.
        path: PathBuf,
    },
    /// The caller asked to stop. Finished results are kept.
    #[error("the study was interrupted; the same command goes on")]
    Interrupted,
}

impl From<Cancelled> for StudyError {
    fn from(_: Cancelled) -> Self {
        StudyError::Interrupted
    }
}
