//! A run of a command on a study: threads, errors, the document of the study, progress.

use super::error::CliError;
use super::interrupt::Interrupt;
use super::output::note;
use super::progress::{Progress, WithoutTerminal};
use homolog_study::StudyError;
use homolog_study::matching::StudyObserver;
use homolog_study::output::{StudyDocument, read_document};
use std::fs;
use std::path::Path;

/// The number of threads, and a pool of them.
///
/// # Errors
/// [`CliError::Failed`] if they cannot be started.
pub(super) fn threads(asked: Option<std::num::NonZeroUsize>) -> Result<(usize, rayon::ThreadPool), CliError> {
    let threads = asked.or_else(|| std::thread::available_parallelism().ok()).map_or(1, usize::from);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| CliError::Failed(format!("cannot start {threads} threads: {error}")))?;
    Ok((threads, pool))
}

/// The error of the command for that of a study.
pub(super) fn said(error: StudyError) -> CliError {
    match error {
        StudyError::Interrupted => CliError::Interrupted,
        StudyError::File { what: "write", path, source } => CliError::Write { path, source },
        StudyError::Cohort(_)
        | StudyError::Settings(_)
        | StudyError::Start { .. }
        | StudyError::TooFewMatches { .. }
        | StudyError::File { .. }
        | StudyError::Changed { .. } => CliError::BadInput(error.to_string()),
        StudyError::Structure { structure, error } => match said(*error) {
            CliError::BadInput(why) => CliError::BadInput(format!("structure {structure}: {why}")),
            error => error,
        },
        error => CliError::Failed(error.to_string()),
    }
}

/// The document of a study, with a note if another build computed it.
///
/// # Errors
/// [`CliError::BadInput`].
pub(super) fn document(path: &Path) -> Result<StudyDocument, CliError> {
    let bytes = fs::read(path);
    let bytes = bytes.map_err(|error| CliError::BadInput(format!("cannot read {}: {error}", path.display())))?;
    let document = read_document(&bytes);
    let document = document.map_err(|why| CliError::BadInput(format!("{}: {why}", path.display())))?;
    if document.version != env!("CARGO_PKG_VERSION") || document.commit != env!("HOMOLOG_COMMIT") {
        note(&format!(
            "note: {} was computed with homolog {}, commit {}; this is another build, so that figures may differ",
            path.display(),
            document.version,
            document.commit
        ));
    }
    Ok(document)
}

/// Progress on the standard error.
pub(super) struct Display {
    progress: Progress,
    interrupt: Interrupt,
}

impl Display {
    pub(super) fn new() -> Self {
        Display { progress: Progress::new(WithoutTerminal::Lines), interrupt: Interrupt::listen() }
    }
}

impl StudyObserver for Display {
    fn progress(&self, what: &str, done: usize, of: usize) {
        self.progress.phase(what);
        self.progress.fraction(done as f64 / of.max(1) as f64);
    }
    fn is_interrupted(&self) -> bool {
        self.interrupt.is_set()
    }
}
