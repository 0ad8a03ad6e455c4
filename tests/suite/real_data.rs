//! The folder of real files, which is not part of the project.

use std::path::{Path, PathBuf};

/// A file or folder under the folder of real data; `None`, with a printed reason, where that is absent.
pub fn real(path: &str) -> Option<PathBuf> {
    let found = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data").join(path);
    if !found.exists() {
        println!("skipped: ../shared/data/{path} is absent");
        return None;
    }
    Some(found)
}

/// The files of a folder under the folder of real data, by name; empty where that is absent.
pub fn real_files(folder: &str) -> Vec<PathBuf> {
    let Some(folder) = real(folder) else { return Vec::new() };
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    files
}

/// Contents of the first `n` hippocampus label volumes by name; `None`, with a printed reason, where they are absent.
pub fn hippocampi(n: usize) -> Option<Vec<Vec<u8>>> {
    let files = real_files("hippocampus");
    if files.is_empty() {
        return None;
    }
    assert!(files.len() >= n, "{n} label volumes are needed, {} are there", files.len());
    Some(files[..n].iter().map(|path| std::fs::read(path).unwrap()).collect())
}
