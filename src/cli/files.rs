//! Files of commands: inputs are read under a size limit, outputs are written atomically.

use super::error::CliError;
use homolog_formats::write_zip;
use homolog_run::intake::IntakeLimits;
use serde::Serialize;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The bytes of an input; a file that is too large is refused before it is read. The DICOM files of a folder are read
/// as a zip archive, the form that the service accepts.
pub(super) fn read_input(path: &Path, limits: &IntakeLimits) -> Result<Vec<u8>, CliError> {
    let unreadable = |error: io::Error| CliError::BadInput(format!("cannot read {}: {error}", path.display()));
    let metadata = fs::metadata(path).map_err(unreadable)?;
    if metadata.is_dir() {
        return read_folder(path, limits);
    }
    if metadata.len() > limits.max_bytes as u64 {
        return Err(CliError::BadInput(format!(
            "{} has {} bytes; the limit is {}",
            path.display(),
            metadata.len(),
            limits.max_bytes
        )));
    }
    fs::read(path).map_err(unreadable)
}

/// The DICOM files of a folder and its subfolders, in one archive.
fn read_folder(folder: &Path, limits: &IntakeLimits) -> Result<Vec<u8>, CliError> {
    let unreadable = |path: &Path, e: io::Error| CliError::BadInput(format!("cannot read {}: {e}", path.display()));
    let (mut files, mut left) = (Vec::new(), limits.max_bytes as u64);
    let mut folders = vec![folder.to_owned()];
    while let Some(at) = folders.pop() {
        for entry in fs::read_dir(&at).map_err(|e| unreadable(&at, e))? {
            let entry = entry.map_err(|e| unreadable(&at, e))?;
            let path = entry.path();
            // Links to folders could form a cycle.
            if entry.file_type().map_err(|e| unreadable(&path, e))?.is_dir() {
                folders.push(path);
                continue;
            }
            let mut head = [0; 132];
            let opened = fs::File::open(&path).and_then(|mut file| io::Read::read_exact(&mut file, &mut head));
            if opened.is_err() || !head.ends_with(b"DICM") {
                continue;
            }
            let bytes = fs::read(&path).map_err(|e| unreadable(&path, e))?;
            left = left.checked_sub(bytes.len() as u64).ok_or_else(|| {
                let limit = limits.max_bytes;
                CliError::BadInput(format!("the DICOM files of {} have more than {limit} bytes", folder.display()))
            })?;
            let name = path.strip_prefix(folder).unwrap_or(&path).to_string_lossy().into_owned();
            files.push((name, bytes));
        }
    }
    if files.is_empty() {
        let advice = "name a file, or a folder of DICOM segmentations";
        return Err(CliError::BadInput(format!("{} is a folder without DICOM files; {advice}", folder.display())));
    }
    files.sort();
    write_zip(&files).map_err(|e| CliError::Failed(format!("cannot pack {}: {e}", folder.display())))
}

/// The last part of a path, like the file name of an upload.
pub(super) fn file_name(path: &Path) -> Option<&str> {
    path.file_name().and_then(|n| n.to_str())
}

/// Writes a temporary file beside `path` and renames it, so that no reader sees an incomplete file.
pub(super) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let unfinished = path.with_file_name(format!(".{name}.{}.tmp", std::process::id()));
    let written = (|| {
        let mut file = fs::File::create(&unfinished)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&unfinished, path)
    })();
    written.map_err(|error| {
        // The write has already failed; a leftover temporary file is harmless.
        let _ = fs::remove_file(&unfinished);
        CliError::write(path, error)
    })
}

/// Fails if no file can be created in a folder, so that the error is reported before a computation and not after it.
pub(super) fn check_writable(folder: &Path) -> Result<(), CliError> {
    let tried = folder.join(format!(".homolog.{}.tmp", std::process::id()));
    fs::File::create(&tried).and_then(|_| fs::remove_file(&tried)).map_err(|e| CliError::write(folder, e))
}

/// A folder for results, created if it does not exist.
pub(super) struct OutputFolder {
    path: PathBuf,
}

impl OutputFolder {
    pub(super) fn create(path: &Path) -> Result<Self, CliError> {
        if path.is_file() {
            return Err(CliError::BadInput(format!("{} is a file; choose a folder with --out", path.display())));
        }
        fs::create_dir_all(path).map_err(|e| CliError::write(path, e))?;
        check_writable(path)?;
        Ok(OutputFolder { path: path.to_owned() })
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file of the folder; see [`write_file`].
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, CliError> {
        let path = self.path.join(name);
        write_file(&path, bytes).map(|()| path)
    }

    pub(super) fn write_json(&self, name: &str, value: &impl Serialize) -> Result<PathBuf, CliError> {
        let mut text = serde_json::to_vec_pretty(value)
            .map_err(|e| CliError::Failed(format!("{name} cannot be written as JSON: {e}")))?;
        text.push(b'\n');
        self.write(name, &text)
    }
}
