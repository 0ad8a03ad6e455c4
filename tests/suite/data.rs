//! Where the real inputs are, and what is said where they are not.

use std::path::PathBuf;

/// The folder with real data beside the project, if it is there.
pub fn folder() -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    folder.is_dir().then_some(folder)
}

/// Contents of the first `n` hippocampus label volumes by name; `None`, with a printed reason, where there are none.
pub fn hippocampi(n: usize, test: &str) -> Option<Vec<Vec<u8>>> {
    let Some(folder) = folder() else {
        println!("SKIPPED {test}: needs the hippocampus label volumes in ../shared/data, which are not here");
        return None;
    };
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder.join("hippocampus"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.to_string_lossy().ends_with(".nii.gz"))
        .collect();
    files.sort();
    assert!(files.len() >= n, "{n} label volumes are needed, {} are there", files.len());
    Some(files[..n].iter().map(|path| std::fs::read(path).unwrap()).collect())
}
