//! Files that commands read and write: inputs under a limit, outputs whole or not at all.

use super::error::CliError;
use homolog_run::intake::IntakeLimits;
use serde::Serialize;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The bytes of an input, refused before reading if there are too many.
pub(super) fn read_input(path: &Path, limits: &IntakeLimits) -> Result<Vec<u8>, CliError> {
    let unreadable = |error: io::Error| CliError::BadInput(format!("cannot read {}: {error}", path.display()));
    let metadata = fs::metadata(path).map_err(unreadable)?;
    if metadata.is_dir() {
        return Err(CliError::BadInput(format!("{} is a folder; name a file", path.display())));
    }
    if metadata.len() > limits.max_bytes as u64 {
        return Err(CliError::BadInput(format!(
            "{} has {} bytes; at most {} are read",
            path.display(),
            metadata.len(),
            limits.max_bytes
        )));
    }
    fs::read(path).map_err(unreadable)
}

/// The last part of a path, as an upload would name the file.
pub(super) fn file_name(path: &Path) -> Option<&str> {
    path.file_name().and_then(|n| n.to_str())
}

/// A folder for results, made if it is not there.
pub(super) struct OutputFolder {
    path: PathBuf,
}

impl OutputFolder {
    pub(super) fn create(path: &Path) -> Result<Self, CliError> {
        fs::create_dir_all(path).map_err(|e| CliError::write(path, e))?;
        Ok(OutputFolder { path: path.to_owned() })
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file beside its final name and renames it, so that nobody ever reads half of it.
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, CliError> {
        let path = self.path.join(name);
        let unfinished = self.path.join(format!(".{name}.{}.tmp", std::process::id()));
        let written = (|| {
            let mut file = fs::File::create(&unfinished)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            fs::rename(&unfinished, &path)
        })();
        if let Err(error) = written {
            // Already failing; what cannot be removed is harmless.
            let _ = fs::remove_file(&unfinished);
            return Err(CliError::write(&path, error));
        }
        Ok(path)
    }

    pub(super) fn write_json(&self, name: &str, value: &impl Serialize) -> Result<PathBuf, CliError> {
        let mut text = serde_json::to_vec_pretty(value)
            .map_err(|e| CliError::Failed(format!("{name} cannot be written as JSON: {e}")))?;
        text.push(b'\n');
        self.write(name, &text)
    }
}
