//! Units of work: each is computed once and stored, so that an interrupted report resumes where it stopped.
//!
//! A finished unit is one line of JSON in `units.jsonl`. Its key is a hash of everything on which its numbers depend; a
//! unit whose key is in the file is not computed again. A line that cannot be parsed, such as the last one of an
//! interrupted program, is ignored.

use super::ExperimentError;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, HashMap};
use std::fs::{self, File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// The measurements of a unit.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Measurement {
    /// Numbers by name; the name includes the unit if there is one.
    pub(super) values: BTreeMap<String, f64>,
    /// Curves by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) curves: BTreeMap<String, Vec<[f64; 2]>>,
}

impl Measurement {
    /// Adds a number. Numbers that are not finite cannot be represented in JSON and are left out.
    pub(super) fn set(&mut self, name: &str, value: f64) {
        if value.is_finite() {
            self.values.insert(name.to_owned(), value);
        }
    }

    /// Returns the measurement with one more number.
    #[must_use]
    pub(super) fn with(mut self, name: &str, value: f64) -> Self {
        self.set(name, value);
        self
    }
}

/// The computation of a unit; the error is one line with the reason for its failure.
pub(super) type Work<'a> = Box<dyn Fn() -> Result<Measurement, String> + 'a>;

/// A piece of work that is stored as a whole or not at all.
pub(super) struct Unit<'a> {
    /// The kind of pair or problem.
    pub(super) group: String,
    /// The setting.
    pub(super) configuration: String,
    /// The pair or problem.
    pub(super) case: String,
    /// Everything on which the numbers depend, besides the section and the program.
    pub(super) inputs: Value,
    /// The work.
    pub(super) work: Work<'a>,
}

/// Outcome of a unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Ending {
    /// Measured.
    Measured(Measurement),
    /// Failed, for this reason.
    Failed(String),
}

/// A finished unit as it is stored.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct FinishedUnit {
    pub(super) key: String,
    pub(super) section: String,
    pub(super) group: String,
    pub(super) configuration: String,
    pub(super) case: String,
    pub(super) seconds: f64,
    pub(super) ending: Ending,
}

/// The key of a unit: `blake3` of section, version of the program, and inputs.
pub(super) fn key(section: &str, version: &str, inputs: &Value) -> String {
    // Objects print with sorted keys, so that equal inputs have equal text.
    let text = serde_json::json!([section, version, inputs]).to_string();
    blake3::hash(text.as_bytes()).to_hex().to_string()
}

/// The file of finished units.
pub(super) struct UnitStore {
    path: PathBuf,
    file: File,
    finished: HashMap<String, FinishedUnit>,
}

impl UnitStore {
    /// Opens or creates the file and reads the units in it.
    pub(super) fn open(path: &Path) -> Result<Self, ExperimentError> {
        let fault = |source| ExperimentError::File { path: path.to_owned(), source };
        let text = match fs::read(path) {
            Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
            Err(error) if error.kind() == ErrorKind::NotFound => String::new(),
            Err(error) => return Err(fault(error)),
        };
        let finished = text
            .lines()
            .filter_map(|line| serde_json::from_str::<FinishedUnit>(line).ok())
            .map(|unit| (unit.key.clone(), unit))
            .collect();
        let mut file = OpenOptions::new().create(true).append(true).open(path).map_err(fault)?;
        // After an incomplete line, the next unit must begin on a new line.
        if !text.is_empty() && !text.ends_with('\n') {
            file.write_all(b"\n").map_err(fault)?;
        }
        Ok(UnitStore { path: path.to_owned(), file, finished })
    }

    pub(super) fn find(&self, key: &str) -> Option<&FinishedUnit> {
        self.finished.get(key)
    }

    /// Stores a unit with a single write, so that lines are never interleaved.
    pub(super) fn keep(&mut self, unit: &FinishedUnit) -> Result<(), ExperimentError> {
        let fault = |source| ExperimentError::File { path: self.path.clone(), source };
        let mut line = serde_json::to_string(unit).map_err(|e| fault(e.into()))?;
        line.push('\n');
        self.file.write_all(line.as_bytes()).map_err(fault)?;
        self.finished.insert(unit.key.clone(), unit.clone());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn unit(key: &str) -> FinishedUnit {
        FinishedUnit {
            key: key.to_owned(),
            section: "s".to_owned(),
            group: "g".to_owned(),
            configuration: "c".to_owned(),
            case: "1".to_owned(),
            seconds: 0.25,
            ending: Ending::Measured(Measurement::default().with("error_mm", 0.1 + 0.2).with("bad", f64::NAN)),
        }
    }

    #[test]
    fn a_truncated_line_is_ignored_and_the_others_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("units.jsonl");
        let mut store = UnitStore::open(&path).unwrap();
        store.keep(&unit("a")).unwrap();
        store.keep(&unit("b")).unwrap();
        drop(store);
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, &text[..text.len() - 10]).unwrap();
        let mut store = UnitStore::open(&path).unwrap();
        assert_eq!(store.find("a"), Some(&unit("a")));
        assert_eq!(store.find("b"), None);
        store.keep(&unit("b")).unwrap();
        let again = UnitStore::open(&path).unwrap();
        assert_eq!((again.find("a"), again.find("b")), (Some(&unit("a")), Some(&unit("b"))));
    }

    #[test]
    fn keys_differ_with_section_version_and_inputs() {
        let base = key("s", "1", &json!({"a": 1, "b": 2}));
        assert_eq!(base, key("s", "1", &json!({"b": 2, "a": 1})));
        for other in [key("t", "1", &json!({"a": 1, "b": 2})), key("s", "2", &json!({"a": 1, "b": 2}))] {
            assert_ne!(base, other);
        }
        assert_ne!(base, key("s", "1", &json!({"a": 1, "b": 3})));
    }
}
