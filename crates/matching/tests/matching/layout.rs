//! The rules of this crate's source tree: no file imports in a circle, and between folders arrows point to lower layers alone.
//!
//! Imports of an ancestor module count too.

use crate::source_tree;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Folders of `src`, each with those that it may import, in reading order: values lie below behavior. The files beside them are free to
/// import folders, but no folder imports them, except `error`.
const LAYERS: &[(&str, &[&str])] = &[
    ("surface", &[]),
    ("pair", &["surface"]),
    ("starts", &["surface", "pair"]),
    ("energy", &["surface", "pair", "starts"]),
    ("poses", &["surface", "pair", "starts"]),
    ("field", &["surface", "pair", "starts", "energy", "poses"]),
    ("answer", &["surface", "pair", "starts", "energy", "poses", "field"]),
    ("thesis", &["surface", "pair", "poses"]),
    ("comparison", &["surface", "pair", "starts", "poses", "answer"]),
    ("pipeline", &["surface", "pair", "starts", "energy", "poses", "field", "answer", "thesis", "comparison"]),
];

fn imports() -> BTreeMap<String, BTreeSet<String>> {
    source_tree::imports(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"))
}

#[test]
fn no_file_imports_in_a_circle() {
    let imports = imports();
    assert_eq!(source_tree::circle(&imports), None);
    // The stages are seen: without arrows there would be no circles either.
    for (file, other) in [
        ("lib", "pipeline"),
        ("pipeline::resized", "pipeline::images"),
        ("pipeline::images", "field::route"),
        ("field::route", "field::finish"),
        ("field::fine", "pair::assignment"),
        ("surface::levels", "surface::side"),
    ] {
        assert!(imports[file].contains(other), "{file} imports {:?}", imports[file]);
    }
}

#[test]
fn folders_import_lower_layers_alone() {
    let folder_of = |file: &str| file.split("::").next().unwrap_or(file).to_owned();
    let mut upward = Vec::new();
    for (file, imported) in imports() {
        let Some((_, lower)) = LAYERS.iter().find(|(folder, _)| *folder == folder_of(&file)) else { continue };
        for other in imported {
            let to = folder_of(&other);
            if to != folder_of(&file) && to != "error" && !lower.contains(&to.as_str()) {
                upward.push(format!("{file} imports {other}"));
            }
        }
    }
    assert_eq!(upward, Vec::<String>::new());
}

#[test]
fn one_file_of_the_field_is_imported_by_others_to_run_it() {
    // Values of the field may be read; only `route` is called.
    let of_field: BTreeSet<String> = imports()
        .into_iter()
        .filter(|(file, _)| !file.starts_with("field"))
        .flat_map(|(_, imported)| imported)
        .filter(|other| other.starts_with("field::"))
        .collect();
    assert_eq!(Vec::from_iter(of_field), ["field::agreement", "field::deformed", "field::options", "field::route"]);
}
