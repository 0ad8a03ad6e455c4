//! The configuration file: the settings of the command line, in TOML, each under its name with underscores, such as
//! `max_queue = 500`. Values are checked as on the command line.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// The settings in a file: name, and the values in the form of the command line.
pub type FileSettings = BTreeMap<String, Vec<String>>;

/// Why a configuration file is refused.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The file cannot be read.
    #[error("cannot read the configuration file {}: {error}", path.display())]
    Unreadable {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// The file is no TOML.
    #[error("{} is no TOML: {error}", path.display())]
    Malformed {
        /// Which file.
        path: PathBuf,
        /// Where and why.
        error: Box<toml::de::Error>,
    },
    /// No setting has this name.
    #[error("{}: {key} is no setting; did you mean {nearest}?", path.display())]
    Unknown {
        /// Which file.
        path: PathBuf,
        /// The name in the file.
        key: String,
        /// The known name that is most like it.
        nearest: String,
    },
    /// The value has a type that no setting has.
    #[error("{}: {key} must be a text, a number, true or false, or a list of these", path.display())]
    WrongType {
        /// Which file.
        path: PathBuf,
        /// The name in the file.
        key: String,
    },
}

/// The settings in a file, all of which must be among the `known` names.
///
/// # Errors
/// [`FileError`].
pub fn read(path: &Path, known: &[String]) -> Result<FileSettings, FileError> {
    let text = std::fs::read_to_string(path).map_err(|error| FileError::Unreadable { path: path.to_owned(), error })?;
    let table: Table =
        text.parse().map_err(|error| FileError::Malformed { path: path.to_owned(), error: Box::new(error) })?;
    let mut settings = FileSettings::new();
    for (key, value) in table {
        if !known.contains(&key) {
            let nearest = nearest(&key, known).unwrap_or_default().to_owned();
            return Err(FileError::Unknown { path: path.to_owned(), key, nearest });
        }
        let values = match &value {
            Value::Array(values) => values.iter().map(written).collect(),
            value => written(value).map(|value| vec![value]),
        };
        let values = values.ok_or_else(|| FileError::WrongType { path: path.to_owned(), key: key.clone() })?;
        settings.insert(key, values);
    }
    Ok(settings)
}

/// A value as on the command line.
fn written(value: &Value) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Integer(number) => Some(number.to_string()),
        Value::Float(number) => Some(number.to_string()),
        Value::Boolean(flag) => Some(flag.to_string()),
        Value::Datetime(_) | Value::Array(_) | Value::Table(_) => None,
    }
}

/// The name that takes the fewest edits to reach.
pub fn nearest<'a>(name: &str, known: &'a [String]) -> Option<&'a str> {
    known.iter().map(String::as_str).min_by_key(|candidate| strsim::damerau_levenshtein(name, candidate))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Result<FileSettings, FileError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("homolog.toml");
        std::fs::write(&path, text).unwrap();
        read(&path, &["max_queue", "listen", "tenant_weights", "insecure"].map(str::to_owned))
    }

    #[test]
    fn values_take_the_form_of_the_command_line() {
        let settings =
            parsed("max_queue = 5\nlisten = \"[::1]:80\"\ninsecure = true\ntenant_weights = [\"a=1\", \"b=2\"]")
                .unwrap();
        assert_eq!(settings["max_queue"], ["5"]);
        assert_eq!(settings["listen"], ["[::1]:80"]);
        assert_eq!(settings["insecure"], ["true"]);
        assert_eq!(settings["tenant_weights"], ["a=1", "b=2"]);
    }

    #[test]
    fn what_is_no_setting_is_refused_with_the_nearest_name() {
        let refused = parsed("max_queues = 5").unwrap_err().to_string();
        assert!(refused.ends_with("max_queues is no setting; did you mean max_queue?"), "{refused}");
        assert!(matches!(parsed("[http]\nmax_queue = 5"), Err(FileError::Unknown { .. })));
        assert!(matches!(parsed("max_queue = 2026-11-22"), Err(FileError::WrongType { .. })));
        assert!(matches!(parsed("max_queue = [[1]]"), Err(FileError::WrongType { .. })));
        assert!(matches!(parsed("max_queue = "), Err(FileError::Malformed { .. })));
        assert!(matches!(parsed("max_queue = 1\nmax_queue = 2"), Err(FileError::Malformed { .. })));
        assert!(matches!(read(Path::new("/nonexistent"), &[]), Err(FileError::Unreadable { .. })));
    }
}
