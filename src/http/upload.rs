//! A submission's multipart body, read under limits.
//!
//! Whoever is refused while still sending would see a broken connection instead of the answer; so what follows a
//! refusal is read and thrown away, within bounds.

use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use super::router::HttpLimits;
use crate::jobs::SubmittedFile;
use axum::body::{Body, HttpBody};
use axum::extract::multipart::{Field, MultipartError};
use axum::extract::{FromRequest, Multipart, Request};
use axum::http::header;
use bytes::{Bytes, BytesMut};
use http_body::Frame;
use serde_json::Value;
use std::collections::BTreeMap;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll};
use std::time::Duration;

/// Largest text field: parameters and labels are small.
const MAX_TEXT_BYTES: usize = 1 << 20;
/// Most labels of a job, and the longest key and value.
const MAX_LABELS: usize = 64;
const MAX_LABEL_BYTES: usize = 256;
const MAX_EXTERNAL_REF_BYTES: usize = 200;
/// How long a refused client may go on sending.
const DRAIN: Duration = Duration::from_secs(10);

/// The fields of a submission.
#[derive(Debug)]
pub struct Upload {
    /// The surface that moves.
    pub source: SubmittedFile,
    /// The surface that stays.
    pub target: SubmittedFile,
    /// Parameters as asked for.
    pub parameters: Value,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name.
    pub external_ref: Option<String>,
    /// −100 to 100.
    pub priority: i32,
}

/// A request's body that can still be read after its reader gave up.
#[derive(Clone)]
pub struct Tap(Arc<Mutex<Tapped>>);

struct Tapped {
    body: Body,
    seen: usize,
    limit: usize,
    over: bool,
}

impl Tap {
    /// Splits a request: the rest of it, and its body, of which `limit` bytes are given out.
    pub fn on(request: Request, limit: usize) -> (Request, Tap) {
        let (parts, body) = request.into_parts();
        let tap = Tap(Arc::new(Mutex::new(Tapped { body, seen: 0, limit, over: false })));
        (Request::from_parts(parts, Body::new(tap.clone())), tap)
    }

    /// Whether more than the limit was sent.
    pub fn is_over(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).over
    }

    /// Reads and throws away what is still sent, at most as much again as was allowed.
    pub async fn drain(&self) {
        {
            let mut tapped = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            tapped.limit = tapped.limit.saturating_mul(2);
            tapped.over = false;
        }
        let mut tap = self.clone();
        let reading =
            async { while let Some(Ok(_)) = std::future::poll_fn(|cx| Pin::new(&mut tap).poll_frame(cx)).await {} };
        let _ = tokio::time::timeout(DRAIN, reading).await;
    }
}

impl HttpBody for Tap {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let mut tapped = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let polled = Pin::new(&mut tapped.body).poll_frame(cx);
        if let Poll::Ready(Some(Ok(frame))) = &polled {
            tapped.seen = tapped.seen.saturating_add(frame.data_ref().map_or(0, Bytes::len));
            if tapped.seen > tapped.limit {
                tapped.over = true;
                return Poll::Ready(Some(Err(axum::Error::new("the body is over its limit"))));
            }
        }
        polled
    }
}

/// Reads the fields of a submission.
///
/// # Errors
/// A problem: wrong media type, broken multipart, over a limit, or all faults of the fields.
pub async fn read_submission(request: Request, tap: &Tap, limits: &HttpLimits) -> Result<Upload, Problem> {
    let media_type = request.headers().get(header::CONTENT_TYPE).and_then(|v| v.to_str().ok()).unwrap_or("");
    if !media_type.trim_start().to_ascii_lowercase().starts_with("multipart/form-data") {
        return Err(Problem::new(ProblemKind::UnsupportedMediaType));
    }
    let refuse = |error: &MultipartError| {
        if tap.is_over() {
            Problem::new(ProblemKind::BodyTooLarge).member("limit_bytes", limits.max_body_bytes().into())
        } else {
            Problem::new(ProblemKind::MalformedMultipart).detail(error.body_text())
        }
    };
    let mut form = Multipart::from_request(request, &())
        .await
        .map_err(|e| Problem::new(ProblemKind::MalformedMultipart).detail(e.body_text()))?;
    let mut fields = Fields::default();
    while let Some(field) = form.next_field().await.map_err(|e| refuse(&e))? {
        let name = field.name().unwrap_or("").to_owned();
        match name.as_str() {
            "source" | "target" => {
                let name_hint = field.file_name().and_then(name_hint);
                let bytes = read_field(field, limits.max_file_bytes).await.map_err(|e| match e {
                    Some(error) => refuse(&error),
                    None => Problem::new(ProblemKind::TooLarge)
                        .detail(format!("{name} has more than {} bytes", limits.max_file_bytes))
                        .member("input", name.clone().into())
                        .member("limit_bytes", limits.max_file_bytes.into()),
                })?;
                let slot = if name == "source" { &mut fields.source } else { &mut fields.target };
                if slot.replace(SubmittedFile { bytes, name_hint }).is_some() {
                    fields.faults.push(FieldError::new(format!("/{name}"), "repeated", "send it once"));
                }
            }
            "parameters" | "labels" | "external_ref" | "priority" => {
                let bytes = read_field(field, MAX_TEXT_BYTES).await.map_err(|e| match e {
                    Some(error) => refuse(&error),
                    None => Problem::new(ProblemKind::TooLarge)
                        .detail(format!("{name} has more than {MAX_TEXT_BYTES} bytes"))
                        .member("limit_bytes", MAX_TEXT_BYTES.into()),
                })?;
                fields.take_text(&name, &bytes);
            }
            _ => {
                let shown: String = name.chars().take(64).collect();
                let detail = "known fields are source, target, parameters, labels, external_ref, priority";
                fields.faults.push(FieldError::new(format!("/{shown}"), "unknown_field", detail));
                if fields.faults.len() >= 16 {
                    break; // enough said
                }
            }
        }
    }
    fields.finish()
}

/// The bytes of a field; `Err(None)` if there are more than `limit`.
async fn read_field(mut field: Field<'_>, limit: usize) -> Result<Bytes, Option<MultipartError>> {
    let mut all = BytesMut::new();
    while let Some(chunk) = field.chunk().await.map_err(Some)? {
        if all.len() + chunk.len() > limit {
            return Err(None);
        }
        all.extend_from_slice(&chunk);
    }
    Ok(all.freeze())
}

#[derive(Default)]
struct Fields {
    source: Option<SubmittedFile>,
    target: Option<SubmittedFile>,
    texts: BTreeMap<String, ()>,
    parameters: Option<Value>,
    labels: BTreeMap<String, String>,
    external_ref: Option<String>,
    priority: i32,
    parameter_faults: bool,
    faults: Vec<FieldError>,
}

impl Fields {
    fn take_text(&mut self, name: &str, bytes: &[u8]) {
        let pointer = format!("/{name}");
        let mut fault = |code: &str, detail: &str| {
            self.faults.push(FieldError::new(pointer.as_str(), code, detail));
            self.parameter_faults |= name == "parameters";
        };
        if self.texts.insert(name.to_owned(), ()).is_some() {
            return fault("repeated", "send it once");
        }
        let Ok(text) = std::str::from_utf8(bytes) else { return fault("not_utf8", "send it as UTF-8") };
        match name {
            "parameters" => match serde_json::from_str::<Value>(text) {
                Ok(value @ Value::Object(_)) => self.parameters = Some(value),
                Ok(_) => fault("wrong_type", "a JSON object is needed here"),
                Err(error) => {
                    let place = format!("no valid JSON at line {}, column {}", error.line(), error.column());
                    fault("malformed_json", &place);
                }
            },
            "labels" => match serde_json::from_str::<BTreeMap<String, String>>(text) {
                Ok(labels) if labels.len() > MAX_LABELS => fault("out_of_range", "at most 64 labels"),
                Ok(labels) if labels.iter().any(|(k, v)| k.len().max(v.len()) > MAX_LABEL_BYTES) => {
                    fault("out_of_range", "keys and values have at most 256 bytes");
                }
                Ok(labels) => self.labels = labels,
                Err(_) => fault("wrong_type", "a JSON object of strings is needed here"),
            },
            "external_ref" if text.len() > MAX_EXTERNAL_REF_BYTES => fault("out_of_range", "at most 200 bytes"),
            "external_ref" => self.external_ref = Some(text.to_owned()).filter(|t| !t.is_empty()),
            _ => match text.trim().parse::<i32>() {
                Ok(priority) if (-100..=100).contains(&priority) => self.priority = priority,
                _ => fault("out_of_range", "a whole number from -100 to 100 is needed here"),
            },
        }
    }

    fn finish(mut self) -> Result<Upload, Problem> {
        for (name, missing) in [("source", self.source.is_none()), ("target", self.target.is_none())] {
            if missing {
                self.faults.push(FieldError::new(format!("/{name}"), "missing", "a file is needed here"));
            }
        }
        match (self.source, self.target) {
            (Some(source), Some(target)) if self.faults.is_empty() => Ok(Upload {
                source,
                target,
                parameters: self.parameters.unwrap_or_else(|| Value::Object(serde_json::Map::new())),
                labels: self.labels,
                external_ref: self.external_ref,
                priority: self.priority,
            }),
            _ => {
                let only_parameters = self.parameter_faults && self.faults.len() == 1;
                let kind = if only_parameters { ProblemKind::InvalidParameters } else { ProblemKind::InvalidRequest };
                Err(Problem::new(kind).errors(&self.faults))
            }
        }
    }
}

/// The endings of a file's name, such as `.nii.gz`; the rest of the name may name a patient and is dropped.
fn name_hint(file_name: &str) -> Option<String> {
    let (rest, last) = file_name.rsplit_once('.')?;
    let is_ending = |text: &str| (1..=8).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_alphanumeric());
    if !is_ending(last) {
        return None;
    }
    let last = last.to_ascii_lowercase();
    // Only before a compression's ending does the one before it say more.
    let before = rest.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase()).filter(|e| last == "gz" && is_ending(e));
    Some(before.map_or_else(|| format!(".{last}"), |e| format!(".{e}.{last}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_endings_of_names_are_kept() {
        let hint = |name| name_hint(name);
        assert_eq!(hint("Doe^Jane.1970.nii.gz").as_deref(), Some(".nii.gz"));
        assert_eq!(hint("Doe^Jane.1970.STL").as_deref(), Some(".stl"));
        assert_eq!(hint("JaneDoe"), None);
        assert_eq!(hint("a.Jane Doe"), None);
    }
}
