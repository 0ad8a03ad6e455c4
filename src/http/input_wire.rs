//! How inputs are written in JSON: the id of an upload, a small file, or the name of a file of the form.

use super::json_fault::INPUT_SHAPE;
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use bytes::Bytes;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use utoipa::ToSchema;

/// An input of a job, a batch or a study: exactly one of `mesh_id`, `content_base64` and `upload`.
#[derive(Debug, Clone, Default, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SubmittedInputDocument {
    /// Id of an upload: `blake3:` and 64 hexadecimal digits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) mesh_id: Option<String>,
    /// The file in base64, if it is small.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>)]
    pub(crate) content_base64: Option<Content>,
    /// Name of a file in the field `files` of the form, for batches and studies that are sent as forms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) upload: Option<String>,
    /// Name of the file in `content_base64`; only its extension is kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) file_name: Option<String>,
}

/// Reads an input from a JSON object.
pub(super) fn input<'de, D: Deserializer<'de>>(deserializer: D) -> Result<SubmittedInputDocument, D::Error> {
    deserializer.deserialize_any(InputReader)
}

/// Reads an input as [`input`] does, or `null` as none.
pub(super) fn maybe_input<'de, D: Deserializer<'de>>(d: D) -> Result<Option<SubmittedInputDocument>, D::Error> {
    d.deserialize_any(MaybeInputReader)
}

struct MaybeInputReader;

impl<'de> Visitor<'de> for MaybeInputReader {
    type Value = Option<SubmittedInputDocument>;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        InputReader.expecting(f)
    }

    fn visit_unit<E: serde::de::Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<Self::Value, A::Error> {
        InputReader.visit_map(object).map(Some)
    }
}

struct InputReader;

impl<'de> Visitor<'de> for InputReader {
    type Value = SubmittedInputDocument;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(INPUT_SHAPE)
    }

    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<SubmittedInputDocument, A::Error> {
        SubmittedInputDocument::deserialize(MapAccessDeserializer::new(object))
    }
}

/// A file in base64, decoded as it is read, so that it is in memory once; `None` if it is not base64.
#[derive(Debug, Clone)]
pub(crate) struct Content(pub(super) Option<Bytes>);

impl<'de> Deserialize<'de> for Content {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;

        impl Visitor<'_> for Reader {
            type Value = Content;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a file in base64")
            }

            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Content, E> {
                Ok(Content(BASE64_STANDARD.decode(text).ok().map(Bytes::from)))
            }
        }

        deserializer.deserialize_str(Reader)
    }
}

impl Serialize for Content {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&BASE64_STANDARD.encode(self.0.as_deref().unwrap_or_default()))
    }
}
