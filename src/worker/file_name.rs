//! Names of files as the formats need them, without the names that uploads had.

/// A file name that reveals only the format.
pub(super) fn file_name(hint: &str) -> String {
    format!("input{hint}")
}
