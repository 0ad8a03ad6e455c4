//! Metadata of the submitter on a job or a batch: tags and a reference of their own.
//!
//! A value of these types is within its limits, whichever way it came in: a form, JSON, a batch, a retry. A new job or batch
//! has no other fields for them, so no way in can skip the check.

use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Deref;

/// Why tags or a reference are refused. The texts repeat nothing of what was sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum MetadataFault {
    /// Too many tags.
    #[error("must have at most {} tags, those of the batch included", Tags::MAX)]
    TooManyTags,
    /// A key or a value is too long, or a key is empty.
    #[error("keys must have 1 to {n} bytes, values at most {n}", n = Tags::MAX_BYTES)]
    TagLength,
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
            MetadataFault::TooManyTags | MetadataFault::TagLength => "tags",
            MetadataFault::ReferenceLength => "external_ref",
            MetadataFault::Nul => "tags",
        }
    }
}

/// Labels of a job or a batch.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[serde(transparent)]
pub struct Tags(BTreeMap<String, String>);

impl Tags {
    /// Maximum number of tags.
    pub const MAX: usize = 64;
    /// Maximum length of a key and of a value, bytes.
    pub const MAX_BYTES: usize = 256;

    /// These tags.
    ///
    /// # Errors
    /// [`MetadataFault`].
    pub fn new(tags: BTreeMap<String, String>) -> Result<Self, MetadataFault> {
        if tags.len() > Tags::MAX {
            return Err(MetadataFault::TooManyTags);
        }
        if tags.iter().any(|(key, value)| key.is_empty() || key.len().max(value.len()) > Tags::MAX_BYTES) {
            return Err(MetadataFault::TagLength);
        }
        if tags.iter().any(|(key, value)| key.contains('\0') || value.contains('\0')) {
            return Err(MetadataFault::Nul);
        }
        Ok(Tags(tags))
    }

    /// These tags and `own`, which take precedence.
    ///
    /// # Errors
    /// [`MetadataFault::TooManyTags`].
    pub fn with(&self, own: &Tags) -> Result<Self, MetadataFault> {
        let mut all = self.0.clone();
        all.extend(own.0.clone());
        Tags::new(all)
    }
}

impl Deref for Tags {
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

    fn tags(pairs: impl IntoIterator<Item = (String, String)>) -> Result<Tags, MetadataFault> {
        Tags::new(pairs.into_iter().collect())
    }

    #[test]
    fn labels_have_limits() {
        let numbered = |n: usize| (0..n).map(|i| (format!("k{i}"), String::new()));
        assert_eq!(tags(numbered(Tags::MAX)).unwrap().len(), Tags::MAX);
        assert_eq!(tags(numbered(Tags::MAX + 1)), Err(MetadataFault::TooManyTags));
        for (key, value) in [("", "x"), (&"k".repeat(257), "x"), ("k", &"v".repeat(257))] {
            assert_eq!(tags([(key.to_owned(), value.to_owned())]), Err(MetadataFault::TagLength));
        }
        for (key, value) in [("a\0", "x"), ("k", "\0")] {
            assert_eq!(tags([(key.to_owned(), value.to_owned())]), Err(MetadataFault::Nul));
        }
        let (many, other) = (tags(numbered(40)).unwrap(), tags((0..40).map(|i| (format!("o{i}"), String::new()))));
        assert_eq!(many.with(&other.unwrap()), Err(MetadataFault::TooManyTags));
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
