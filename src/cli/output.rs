//! Output of commands: answers go to the standard output, messages and progress to the standard error.

use super::error::CliError;
use serde::Serialize;
use std::io::{self, Write};

/// Prints text and a line break.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    writeln!(out, "{text}").and_then(|()| out.flush()).map_err(|e| CliError::output(&e))
}

/// Prints a JSON document on one line.
pub(super) fn print_json(value: &impl Serialize) -> Result<(), CliError> {
    let text =
        serde_json::to_string(value).map_err(|e| CliError::Failed(format!("cannot write the answer as JSON: {e}")))?;
    print(&text)
}

/// Prints a message to the standard error; errors are ignored.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
