//! Why a study cannot go on.

use crate::cohort::CohortError;
use homolog_mesh::MeshError;
use homolog_primitives::observe::Cancelled;
use homolog_registration::OrientationError;
use std::path::PathBuf;

/// Why a study cannot go on. A subject that cannot be read or matched is no error: it is listed with the reason.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The table of subjects.
    #[error(transparent)]
    Cohort(#[from] CohortError),
    /// A name in the settings is unknown, or what they ask for cannot be computed.
    #[error("{0}")]
    Settings(String),
    /// The surface from which the template begins.
    #[error("the template cannot begin from {what}: {why}; choose another with --start, or give one with --template")]
    Start {
        /// Which surface.
        what: String,
        /// What is wrong with it.
        why: String,
    },
    /// Too few subjects were matched.
    #[error(
        "only {matched} of {all} subjects could be matched, which is too few {purpose}; the first failed with: {reason}"
    )]
    TooFewMatches {
        /// Matched subjects.
        matched: usize,
        /// Subjects that were tried.
        all: usize,
        /// For what.
        purpose: &'static str,
        /// Why the first failed.
        reason: String,
    },
    /// A shape has no orientation.
    #[error("subject {id} cannot be aligned with the mean: {error}; drop it with a decision")]
    Alignment {
        /// The subject.
        id: String,
        /// Why.
        error: OrientationError,
    },
    /// Coordinates overflowed.
    #[error("a mean surface cannot be computed: {0}")]
    Mesh(#[from] MeshError),
    /// An eigenvalue decomposition failed.
    #[error("the shape model cannot be computed: {0} has no eigenvalue decomposition")]
    Decomposition(&'static str),
    /// A file.
    #[error("cannot {what} {}: {source}", path.display())]
    File {
        /// `read` or `write`.
        what: &'static str,
        /// Which file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file of the study's folder is damaged.
    #[error("{} is damaged: {why}", path.display())]
    Damaged {
        /// Which file.
        path: PathBuf,
        /// What is wrong, and what to do.
        why: String,
    },
    /// A file differs from the one that `study.json` names.
    #[error("{} is not the file of the study: its content has changed since; restore it, or begin a new study", path.display())]
    Changed {
        /// Which file.
        path: PathBuf,
    },
    /// The caller asked to stop. What is finished is kept.
    #[error("the study was interrupted; the same command goes on")]
    Interrupted,
}

impl From<Cancelled> for StudyError {
    fn from(_: Cancelled) -> Self {
        StudyError::Interrupted
    }
}
