//! The standard output: what a command answers. Messages and progress go to the standard error.

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
    let text = serde_json::to_string(value)
        .map_err(|e| CliError::Failed(format!("the answer cannot be written as JSON: {e}")))?;
    print(&text)
}

/// Prints a message for people to the standard error; a closed one is nobody's loss.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
