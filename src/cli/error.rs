//! Errors of commands and their exit codes.

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub(super) enum CliError {
    /// Bad input: a file, a parameter, or a refused surface. Exit code 2, like a usage error.
    #[error("{0}")]
    BadInput(String),
    /// Any other failure. Exit code 1.
    #[error("{0}")]
    Failed(String),
    /// A file could not be written. Exit code 1.
    #[error("cannot write {}: {source}; choose another folder with --out, or free some space", path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// Ctrl-C or SIGTERM. Exit code 130, as shells expect.
    #[error("interrupted")]
    Interrupted,
    /// The reader of the standard output closed it, as `head` does. Exit code 0, no message.
    #[error("the output was closed")]
    OutputClosed,
}

impl CliError {
    /// The exit code of the program.
    pub(super) fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            CliError::BadInput(_) => 2,
            CliError::Failed(_) | CliError::Write { .. } => 1,
            CliError::Interrupted => 130,
            CliError::OutputClosed => 0,
        })
    }

    pub(super) fn write(path: &Path, source: io::Error) -> Self {
        CliError::Write { path: path.to_owned(), source }
    }

    /// An error of writing to the standard output.
    pub(super) fn output(error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => CliError::OutputClosed,
            _ => CliError::Failed(format!("cannot write to the standard output: {error}")),
        }
    }
}
