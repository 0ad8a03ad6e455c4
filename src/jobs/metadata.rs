//! What a submitter writes on a job or a batch: labels and a reference of their own.
//!
//! A value of these types is within its limits, whichever way it came in: a form, JSON, a batch, a retry. A new job or batch
//! has no other fields for them, so no way in can skip the check.

use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Deref;

/// Why labels or a reference are refused. The texts repeat nothing of what was sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum MetadataFault {
    /// Too many labels.
    #[error("must have at most {} labels, those of the batch included", Labels::MAX)]
    TooManyLabels,
    /// A key or a value is too long, or a key is empty.
    #[error("keys must have 1 to {n} bytes, values at most {n}", n = Labels::MAX_BYTES)]
    LabelLength,
    /// A reference is too long.
    #[error("must have at most {} bytes", ExternalRef::MAX_BYTES)]
    ReferenceLength,
    /// A NUL character, which not every database stores.
    #[error("must not contain NUL characters")]
    Nul,
}

impl MetadataFault {
    /// The field that it is in.
    pub fn field(self) -> &'static str {
        match self {
            MetadataFault::TooManyLabels | MetadataFault::LabelLength => "labels",
            MetadataFault::ReferenceLength => "external_ref",
            MetadataFault::Nul => "labels",
        }
    }
}

/// Labels of a job or a batch.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[serde(transparent)]
pub struct Labels(BTreeMap<String, String>);

impl Labels {
    /// Maximum number of labels.
    pub const MAX: usize = 64;
    /// Maximum length of a key and of a value, bytes.
    pub const MAX_BYTES: usize = 256;

    /// These labels.
    ///
    /// # Errors
    /// [`MetadataFault`].
    pub fn new(labels: BTreeMap<String, String>) -> Result<Self, MetadataFault> {
        if labels.len() > Labels::MAX {
            return Err(MetadataFault::TooManyLabels);
        }
        if labels.iter().any(|(key, value)| key.is_empty() || key.len().max(value.len()) > Labels::MAX_BYTES) {
            return Err(MetadataFault::LabelLength);
        }
        if labels.iter().any(|(key, value)| key.contains('\0') || value.contains('\0')) {
            return Err(MetadataFault::Nul);
        }
        Ok(Labels(labels))
    }

    /// These labels and `own`, which take precedence.
    ///
    /// # Errors
    /// [`MetadataFault::TooManyLabels`].
    pub fn with(&self, own: &Labels) -> Result<Self, MetadataFault> {
        let mut all = self.0.clone();
        all.extend(own.0.clone());
        Labels::new(all)
    }
}

impl Deref for Labels {
    type Target = BTreeMap<String, String>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// A submitter's own identifier of a job or a batch.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct ExternalRef(String);

impl ExternalRef {
    /// Maximum length, bytes.
    pub const MAX_BYTES: usize = 200;

    /// This reference; `None` if it is empty.
    ///
    /// # Errors
    /// [`MetadataFault`].
    pub fn new(text: String) -> Result<Option<Self>, MetadataFault> {
        if text.len() > ExternalRef::MAX_BYTES {
            return Err(MetadataFault::ReferenceLength);
        }
        if text.contains('\0') {
            return Err(MetadataFault::Nul);
        }
        Ok(Some(text).filter(|text| !text.is_empty()).map(ExternalRef))
    }

    /// Its text.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(pairs: impl IntoIterator<Item = (String, String)>) -> Result<Labels, MetadataFault> {
        Labels::new(pairs.into_iter().collect())
    }

    #[test]
    fn labels_have_limits() {
        let numbered = |n: usize| (0..n).map(|i| (format!("k{i}"), String::new()));
        assert_eq!(labels(numbered(Labels::MAX)).unwrap().len(), Labels::MAX);
        assert_eq!(labels(numbered(Labels::MAX + 1)), Err(MetadataFault::TooManyLabels));
        for (key, value) in [("", "x"), (&"k".repeat(257), "x"), ("k", &"v".repeat(257))] {
            assert_eq!(labels([(key.to_owned(), value.to_owned())]), Err(MetadataFault::LabelLength));
        }
        for (key, value) in [("a\0", "x"), ("k", "\0")] {
            assert_eq!(labels([(key.to_owned(), value.to_owned())]), Err(MetadataFault::Nul));
        }
        let (many, other) = (labels(numbered(40)).unwrap(), labels((0..40).map(|i| (format!("o{i}"), String::new()))));
        assert_eq!(many.with(&other.unwrap()), Err(MetadataFault::TooManyLabels));
        assert_eq!(many.with(&many).unwrap(), many);
    }

    #[test]
    fn references_have_limits() {
        assert_eq!(ExternalRef::new(String::new()), Ok(None));
        assert_eq!(ExternalRef::new("r".repeat(200)).unwrap().unwrap().as_str().len(), 200);
        assert_eq!(ExternalRef::new("r".repeat(201)), Err(MetadataFault::ReferenceLength));
        assert_eq!(ExternalRef::new("a\0b".to_owned()), Err(MetadataFault::Nul));
    }
}
