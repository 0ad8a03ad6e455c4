//! Reading submissions: a multipart form or JSON, with the same fields and the same checks.

use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use super::router::HttpLimits;
use super::upload::{Tap, name_hint, read_field};
use crate::jobs::mesh::hash_of_id;
use crate::jobs::{Details, SubmissionLimits, SubmittedFile, SubmittedInput};
use axum::extract::multipart::MultipartError;
use axum::extract::{FromRequest, Multipart};
use axum::http::header;
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use bytes::Bytes;
use jiff::Timestamp;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use utoipa::ToSchema;

/// Largest text field, bytes: parameters and labels are small.
const MAX_TEXT_BYTES: usize = 1 << 20;
/// Largest JSON body, bytes: it may contain small meshes.
const MAX_JSON_BYTES: usize = 32 << 20;
/// Most labels of a job, and the longest key and value.
const MAX_LABELS: usize = 64;
const MAX_LABEL_BYTES: usize = 256;
const MAX_EXTERNAL_REF_BYTES: usize = 200;
/// Most unknown fields that are listed in an answer.
const NAMED_UNKNOWN: usize = 16;
const KNOWN: &str =
    "known fields are source, target, parameters, labels, external_ref, priority, deadline_at, max_run_s, use_cache";

/// A submission as a multipart form.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub(crate) struct SubmissionForm {
    /// The surface that is moved onto the target: a surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label
    /// volume (NIfTI, MGZ, NRRD, MetaImage, DICOM SEG).
    #[schema(format = Binary)]
    source: String,
    /// The surface that stays in place.
    #[schema(format = Binary)]
    target: String,
    /// Parameters that differ from the preset that `method` names; `{}` or absent for the defaults.
    #[schema(value_type = Option<Object>)]
    parameters: Option<Value>,
    /// Labels of the client's choice: a JSON object of strings.
    labels: Option<BTreeMap<String, String>>,
    /// The client's own id of the job.
    #[schema(max_length = 200)]
    external_ref: Option<String>,
    /// Jobs with a higher priority run first.
    #[schema(minimum = -100, maximum = 100, default = 0)]
    priority: Option<i32>,
    /// The job expires if it has not started by this RFC 3339 time.
    #[schema(format = DateTime)]
    deadline_at: Option<String>,
    /// Longest run time, s, up to the limit of the service.
    #[schema(minimum = 1)]
    max_run_s: Option<u64>,
    /// Whether the result of an equal job may be returned.
    #[schema(default = true)]
    use_cache: Option<bool>,
}

/// A submission in JSON.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SubmissionDocument {
    /// The surface that is moved onto the target.
    #[serde(deserialize_with = "object")]
    pub(crate) source: SubmittedInputDocument,
    /// The surface that stays in place.
    #[serde(deserialize_with = "object")]
    pub(crate) target: SubmittedInputDocument,
    /// Parameters that differ from the preset that `method` names.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Object>)]
    pub(crate) parameters: Option<Value>,
    /// The other fields.
    #[serde(flatten)]
    pub(crate) details: DetailsDocument,
}

/// An input of a JSON submission: either `mesh_id` or `content_base64`.
#[derive(Debug, Clone, Default, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SubmittedInputDocument {
    /// Id of an upload: `blake3:` and 64 hexadecimal digits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) mesh_id: Option<String>,
    /// The file in base64, if it is small.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) content_base64: Option<String>,
    /// Name of the file; only its extension is kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) file_name: Option<String>,
}

/// The fields of a submission besides inputs and parameters.
#[derive(Debug, Clone, Default, Deserialize, Serialize, ToSchema)]
pub(crate) struct DetailsDocument {
    /// Labels of the client's choice.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) labels: BTreeMap<String, String>,
    /// The client's own id.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 200)]
    pub(crate) external_ref: Option<String>,
    /// Jobs with a higher priority run first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: Option<i32>,
    /// The job expires if it has not started by this time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) deadline_at: Option<Timestamp>,
    /// Longest run time, s, up to the limit of the service.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = 1)]
    pub(crate) max_run_s: Option<u64>,
    /// Whether the result of an equal job may be returned; true if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) use_cache: Option<bool>,
}

/// A submission after reading.
#[derive(Debug)]
pub(crate) struct Request {
    /// The surface that is moved onto the target.
    pub(crate) source: SubmittedInput,
    /// The surface that stays in place.
    pub(crate) target: SubmittedInput,
    /// Parameters as sent.
    pub(crate) parameters: Value,
    /// The other fields.
    pub(crate) details: Details,
}

/// Reads a submission in either form.
///
/// # Errors
/// A problem: unsupported media type, malformed body, a size limit, or all faults of the fields.
pub(super) async fn read(
    request: axum::extract::Request,
    tap: &Tap,
    limits: &HttpLimits,
    accepted: &SubmissionLimits,
) -> Result<Request, Problem> {
    let mut fields = Fields { max_run_s: accepted.max_run.as_secs(), ..Fields::default() };
    match media_type(&request).as_str() {
        "multipart/form-data" => fields.read_form(request, tap, limits).await?,
        "application/json" => {
            let document: SubmissionDocument = read_json(request, tap, limits).await?;
            fields.take_document(document, limits.max_file_bytes);
        }
        _ => return Err(Problem::new(ProblemKind::UnsupportedMediaType)),
    }
    fields.finish()
}

/// The media type of a request without its parameters, in lower case.
pub(super) fn media_type(request: &axum::extract::Request) -> String {
    let sent = request.headers().get(header::CONTENT_TYPE).and_then(|v| v.to_str().ok()).unwrap_or("");
    sent.split(';').next().unwrap_or("").trim().to_ascii_lowercase()
}

/// Reads a JSON body.
///
/// # Errors
/// A problem: too large, not JSON, or a fault in a field.
pub(super) async fn read_json<T: DeserializeOwned>(
    request: axum::extract::Request,
    tap: &Tap,
    limits: &HttpLimits,
) -> Result<T, Problem> {
    let limit = MAX_JSON_BYTES.min(limits.max_body_bytes());
    let too_large = || Problem::new(ProblemKind::BodyTooLarge).member("limit_bytes", limit.into());
    let body = match axum::body::to_bytes(request.into_body(), limit).await {
        Ok(body) => body,
        Err(_) if tap.is_over() => return Err(too_large()),
        Err(error) => {
            let mut source = std::error::Error::source(&error);
            while let Some(cause) = source {
                if cause.is::<http_body_util::LengthLimitError>() {
                    return Err(too_large());
                }
                source = cause.source();
            }
            return Err(Problem::new(ProblemKind::BadRequest).detail("the body ended early"));
        }
    };
    // serde would also read a struct from an array, by the order of its fields.
    if body.iter().find(|b| !b.is_ascii_whitespace()).is_some_and(|&b| b == b'[') {
        let fault = FieldError::new("", "wrong_form", "must be a JSON object");
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]));
    }
    let mut reader = serde_json::Deserializer::from_slice(&body);
    serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let inner = error.inner();
        if inner.is_syntax() || inner.is_eof() {
            let detail = format!("invalid JSON at line {}, column {}", inner.line(), inner.column());
            return Problem::new(ProblemKind::MalformedJson).detail(detail);
        }
        let path = error.path().to_string();
        let pointer =
            if path == "." { String::new() } else { format!("/{}", path.replace(['.', '['], "/").replace(']', "")) };
        // The message of serde may repeat what the client sent; it is truncated.
        let fault = FieldError::new(pointer, "wrong_form", inner.to_string().chars().take(200).collect::<String>());
        Problem::new(ProblemKind::InvalidRequest).errors(&[fault])
    })
}

/// Reads a form from a JSON object only.
fn object<'de, D: Deserializer<'de>, T: DeserializeOwned>(deserializer: D) -> Result<T, D::Error> {
    let members = serde_json::Map::deserialize(deserializer)?;
    T::deserialize(Value::Object(members)).map_err(serde::de::Error::custom)
}

#[derive(Default)]
struct Fields {
    source: Option<SubmittedInput>,
    target: Option<SubmittedInput>,
    texts: BTreeSet<String>,
    parameters: Option<Value>,
    details: Details,
    max_run_s: u64,
    parameter_faults: bool,
    faults: Vec<FieldError>,
}

impl Fields {
    async fn read_form(
        &mut self,
        request: axum::extract::Request,
        tap: &Tap,
        limits: &HttpLimits,
    ) -> Result<(), Problem> {
        let refuse = |error: &MultipartError| {
            if tap.is_over() {
                Problem::new(ProblemKind::BodyTooLarge).member("limit_bytes", limits.max_body_bytes().into())
            } else {
                Problem::new(ProblemKind::MalformedMultipart).detail(error.body_text())
            }
        };
        let too_large = |name: &str, limit: usize| {
            Problem::new(ProblemKind::TooLarge)
                .detail(format!("{name} has more than {limit} bytes"))
                .member("limit_bytes", limit.into())
        };
        let mut form = Multipart::from_request(request, &())
            .await
            .map_err(|e| Problem::new(ProblemKind::MalformedMultipart).detail(e.body_text()))?;
        while let Some(field) = form.next_field().await.map_err(|e| refuse(&e))? {
            let name = field.name().unwrap_or("").to_owned();
            match name.as_str() {
                "source" | "target" => {
                    let name_hint = field.file_name().and_then(name_hint);
                    let limit = limits.max_file_bytes;
                    let bytes = read_field(field, limit).await.map_err(|e| match e {
                        Some(error) => refuse(&error),
                        None => too_large(&name, limit).member("input", name.clone().into()),
                    })?;
                    let slot = if name == "source" { &mut self.source } else { &mut self.target };
                    if slot.replace(SubmittedInput::File(SubmittedFile { bytes, name_hint })).is_some() {
                        self.faults.push(FieldError::new(format!("/{name}"), "repeated", "must be sent once"));
                    }
                }
                "parameters" | "labels" | "external_ref" | "priority" | "deadline_at" | "max_run_s" | "use_cache" => {
                    let bytes = read_field(field, MAX_TEXT_BYTES).await.map_err(|e| match e {
                        Some(error) => refuse(&error),
                        None => too_large(&name, MAX_TEXT_BYTES),
                    })?;
                    self.take_text(&name, &bytes);
                }
                _ => {
                    let shown: String = name.chars().take(64).collect();
                    self.faults.push(FieldError::new(format!("/{shown}"), "unknown_field", KNOWN));
                    if self.faults.len() >= NAMED_UNKNOWN {
                        break; // the list is long enough
                    }
                }
            }
        }
        Ok(())
    }

    fn fault(&mut self, name: &str, code: &str, detail: &str) {
        self.parameter_faults |= name == "parameters";
        self.faults.push(FieldError::new(format!("/{name}"), code, detail));
    }

    /// Takes a text field of a form.
    fn take_text(&mut self, name: &str, bytes: &[u8]) {
        if !self.texts.insert(name.to_owned()) {
            return self.fault(name, "repeated", "must be sent once");
        }
        let Ok(text) = std::str::from_utf8(bytes) else { return self.fault(name, "not_utf8", "must be UTF-8") };
        match name {
            "parameters" => match serde_json::from_str::<Value>(text) {
                Ok(value) => self.take_parameters(value),
                Err(error) => {
                    let place = format!("invalid JSON at line {}, column {}", error.line(), error.column());
                    self.fault(name, "malformed_json", &place);
                }
            },
            "labels" => match serde_json::from_str::<BTreeMap<String, String>>(text) {
                Ok(labels) => self.take_labels(labels),
                Err(_) => self.fault(name, "wrong_type", "must be a JSON object of strings"),
            },
            "external_ref" => self.take_external_ref(text.to_owned()),
            "priority" => self.take_priority(text.trim().parse().ok()),
            "deadline_at" => match text.trim().parse() {
                Ok(time) => self.details.deadline_at = Some(time),
                Err(_) => self.fault(name, "out_of_range", "must be an RFC 3339 time, such as 2026-11-21T08:00:00Z"),
            },
            "max_run_s" => self.take_max_run(text.trim().parse().ok()),
            _ => match text.trim() {
                "true" => self.details.compute_anew = false,
                "false" => self.details.compute_anew = true,
                _ => self.fault(name, "out_of_range", "must be true or false"),
            },
        }
    }

    /// Takes a JSON submission.
    fn take_document(&mut self, document: SubmissionDocument, max_file_bytes: usize) {
        let SubmissionDocument { source, target, parameters, details } = document;
        self.source = self.take_input("source", source, max_file_bytes);
        self.target = self.take_input("target", target, max_file_bytes);
        if let Some(parameters) = parameters {
            self.take_parameters(parameters);
        }
        self.take_details(details);
    }

    fn take_details(&mut self, details: DetailsDocument) {
        self.take_labels(details.labels);
        if let Some(text) = details.external_ref {
            self.take_external_ref(text);
        }
        if let Some(priority) = details.priority {
            self.take_priority(Some(priority));
        }
        self.details.deadline_at = details.deadline_at;
        if let Some(seconds) = details.max_run_s {
            self.take_max_run(Some(seconds));
        }
        self.details.compute_anew = details.use_cache == Some(false);
    }

    fn take_input(
        &mut self,
        name: &str,
        input: SubmittedInputDocument,
        max_file_bytes: usize,
    ) -> Option<SubmittedInput> {
        let SubmittedInputDocument { mesh_id, content_base64, file_name } = input;
        match (mesh_id, content_base64) {
            (Some(id), None) => match hash_of_id(&id) {
                Some(hash) => Some(SubmittedInput::Mesh(hash.to_owned())),
                None => {
                    let detail = "must be the id of an upload: blake3: and 64 hexadecimal digits";
                    self.fault(&format!("{name}/mesh_id"), "out_of_range", detail);
                    None
                }
            },
            (None, Some(text)) => match BASE64_STANDARD.decode(&text) {
                Ok(bytes) if bytes.len() <= max_file_bytes => {
                    let name_hint = file_name.as_deref().and_then(name_hint);
                    Some(SubmittedInput::File(SubmittedFile { bytes: Bytes::from(bytes), name_hint }))
                }
                Ok(_) => {
                    let detail = format!("must have at most {max_file_bytes} bytes");
                    self.fault(&format!("{name}/content_base64"), "out_of_range", &detail);
                    None
                }
                Err(_) => {
                    self.fault(&format!("{name}/content_base64"), "malformed_base64", "must be standard base64");
                    None
                }
            },
            _ => {
                self.fault(name, "out_of_range", "must have exactly one of mesh_id and content_base64");
                None
            }
        }
    }

    fn take_parameters(&mut self, value: Value) {
        match value {
            Value::Object(_) => self.parameters = Some(value),
            _ => self.fault("parameters", "wrong_type", "must be a JSON object"),
        }
    }

    fn take_labels(&mut self, labels: BTreeMap<String, String>) {
        if labels.len() > MAX_LABELS {
            self.fault("labels", "out_of_range", "must have at most 64 labels");
        } else if labels.iter().any(|(k, v)| k.is_empty() || k.len().max(v.len()) > MAX_LABEL_BYTES) {
            self.fault("labels", "out_of_range", "keys must have 1 to 256 bytes, values at most 256");
        } else if labels.iter().any(|(k, v)| k.contains('\0') || v.contains('\0')) {
            self.fault("labels", "out_of_range", "must not contain NUL characters");
        } else {
            self.details.labels = labels;
        }
    }

    fn take_external_ref(&mut self, text: String) {
        if text.len() > MAX_EXTERNAL_REF_BYTES || text.contains('\0') {
            self.fault("external_ref", "out_of_range", "must have at most 200 bytes and no NUL characters");
        } else {
            self.details.external_ref = Some(text).filter(|text| !text.is_empty());
        }
    }

    fn take_priority(&mut self, priority: Option<i32>) {
        match priority {
            Some(priority) if (-100..=100).contains(&priority) => self.details.priority = priority,
            _ => self.fault("priority", "out_of_range", "must be an integer from -100 to 100"),
        }
    }

    fn take_max_run(&mut self, seconds: Option<u64>) {
        match seconds {
            Some(seconds) if (1..=self.max_run_s).contains(&seconds) => {
                self.details.max_run_ms = Some(seconds * 1000);
            }
            _ => {
                let detail = format!("must be an integer from 1 to {}, seconds", self.max_run_s);
                self.fault("max_run_s", "out_of_range", &detail);
            }
        }
    }

    fn finish(mut self) -> Result<Request, Problem> {
        for (name, missing) in [("source", self.source.is_none()), ("target", self.target.is_none())] {
            let named = self.faults.iter().any(|fault| fault.pointer.starts_with(&format!("/{name}")));
            if missing && !named {
                self.faults.push(FieldError::new(format!("/{name}"), "missing", "a file is required"));
            }
        }
        match (self.source, self.target) {
            (Some(source), Some(target)) if self.faults.is_empty() => Ok(Request {
                source,
                target,
                parameters: self.parameters.unwrap_or_else(|| Value::Object(serde_json::Map::new())),
                details: self.details,
            }),
            _ => {
                let only_parameters = self.parameter_faults && self.faults.len() == 1;
                let kind = if only_parameters { ProblemKind::InvalidParameters } else { ProblemKind::InvalidRequest };
                Err(Problem::new(kind).errors(&self.faults))
            }
        }
    }
}

/// Checks the fields of a JSON body other than inputs, like those of a job.
///
/// # Errors
/// All their faults.
pub(super) fn check_details(
    parameters: Option<Value>,
    details: DetailsDocument,
    accepted: &SubmissionLimits,
) -> Result<(Value, Details), Problem> {
    let mut fields = Fields { max_run_s: accepted.max_run.as_secs(), ..Fields::default() };
    if let Some(parameters) = parameters {
        fields.take_parameters(parameters);
    }
    fields.take_details(details);
    if !fields.faults.is_empty() {
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&fields.faults));
    }
    Ok((fields.parameters.unwrap_or_else(|| Value::Object(serde_json::Map::new())), fields.details))
}
