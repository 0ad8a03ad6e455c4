//! The rule of every source tree, of the program and of each crate: no file imports in a circle. Imports of an ancestor module do
//! not count: a folder may hold what its files share, and name them.

use crate::source_tree::{circle, imports};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The source folders of the program and of each crate.
fn source_folders() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src"));
    let mut folders: Vec<PathBuf> = crates.chain([root.join("src")]).collect();
    folders.sort();
    folders
}

/// Whether the file `other` is an ancestor module of `file`.
fn is_ancestor(other: &str, file: &str) -> bool {
    other == "lib" || file.strip_prefix(other).is_some_and(|below| below.starts_with("::"))
}

/// The imports of each file of a source folder, except those of its ancestors.
fn imports_of_others(src: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let mut found = imports(src);
    for (file, imported) in &mut found {
        imported.retain(|other| !is_ancestor(other, file));
    }
    found
}

#[test]
fn no_file_imports_in_a_circle() {
    let circles: Vec<(PathBuf, Vec<String>)> = source_folders()
        .into_iter()
        .filter_map(|src| circle(&imports_of_others(&src)).map(|found| (src, found)))
        .collect();
    assert_eq!(circles, []);
}

#[test]
fn imports_of_the_program_are_seen_and_those_of_ancestors_do_not_count() {
    let imports = imports_of_others(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    for (file, other) in [
        ("http", "http::router"),
        ("http::router", "http::handlers"),
        ("http::handlers", "http::routes::jobs"),
        ("http::routes::jobs", "http::call"),
        ("http::call", "http::state"),
        ("http::state", "jobs"),
        ("cli::match_many", "cli::pair"),
    ] {
        assert!(imports[file].contains(other), "{file} imports {:?}", imports[file]);
    }
    assert!(!imports["http::routes::jobs"].contains("http::routes"));
    assert!(!imports["http::call"].contains("lib"));
}
