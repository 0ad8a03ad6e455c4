//! Identifiers of DICOM that a client gives, so that results of other formats can be filed in a study.

use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// Most characters (DICOM PS3.5, section 9.1).
const MAX_LENGTH: usize = 64;

/// A DICOM UID: numbers between dots, none with a leading zero, at most 64 characters.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Uid(String);

/// Not a UID.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "must be a DICOM UID: numbers between dots, without leading zeros, at most 64 characters, such as 1.2.840.10008.1"
)]
pub struct NotAUid;

impl Uid {
    /// As written.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl FromStr for Uid {
    type Err = NotAUid;

    fn from_str(text: &str) -> Result<Self, NotAUid> {
        let is_number = |part: &str| {
            !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit()) && (part == "0" || !part.starts_with('0'))
        };
        let is_uid = text.len() <= MAX_LENGTH && text.contains('.') && text.split('.').all(is_number);
        if is_uid { Ok(Uid(text.to_owned())) } else { Err(NotAUid) }
    }
}

impl TryFrom<String> for Uid {
    type Error = NotAUid;

    fn try_from(text: String) -> Result<Self, NotAUid> {
        text.parse()
    }
}

impl From<Uid> for String {
    fn from(uid: Uid) -> Self {
        uid.0
    }
}

/// The UIDs for a DICOM object of inputs that state none themselves.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct GivenUids {
    /// The study.
    pub study: Option<Uid>,
    /// The frame of reference of the source.
    pub source_frame: Option<Uid>,
    /// The frame of reference of the target.
    pub target_frame: Option<Uid>,
}

impl GivenUids {
    /// The texts of study, source and target.
    pub fn texts(&self) -> [Option<&str>; 3] {
        [&self.study, &self.source_frame, &self.target_frame].map(|uid| uid.as_ref().map(Uid::as_str))
    }
}

/// The particulars of a DICOM object that are in no blob of the result.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct DicomDetails {
    /// When the job ended, `YYYYMMDDHHMMSS`, UTC.
    pub ended_at: String,
    /// For inputs that state none.
    pub uids: GivenUids,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uids_are_numbers_between_dots() {
        for uid in ["1.2", "2.25.329800735698586629295641978511506172918", "1.2.840.10008.5.1.4.1.1.66.4", "0.0"] {
            assert_eq!(uid.parse::<Uid>().unwrap().as_str(), uid);
        }
        let long = format!("1.{}", "2".repeat(63));
        for text in ["", "1", "1.", ".1", "1..2", "1.02", "1.2a", "Doe^Jane", "1.2 ", "1.2\\3", long.as_str()] {
            assert_eq!(text.parse::<Uid>(), Err(NotAUid), "{text}");
        }
    }
}
