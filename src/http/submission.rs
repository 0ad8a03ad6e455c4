//! Reading submissions: a multipart form or JSON, with the same fields and the same checks.

use super::input_wire::{Content, SubmittedInputDocument, input};
use super::options::{SentOptions, submission_document};
use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use super::state::{HttpLimits, HttpState};
use super::strict_json::{FORMER_TAGS, Parameters, SentTags, parse, parse_parameters, tags_of};
use super::upload::{LimitedBody, name_hint, read_field};
use crate::jobs::documents::PartialParameters;
use crate::jobs::mesh::hash_of_id;
use crate::jobs::metadata::{ExternalRef, MetadataFault};
use crate::jobs::{JobOptions, SubmissionLimits, SubmittedFile, SubmittedInput};
use axum::body::HttpBody as _;
use axum::extract::multipart::MultipartError;
use axum::extract::{FromRequest, Multipart};
use axum::http::header;
use bytes::{Bytes, BytesMut};
use http_body_util::BodyExt as _;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use utoipa::ToSchema;

/// Allowed priorities, and what is said of another one.
pub(super) const PRIORITIES: RangeInclusive<i32> = -100..=100;
pub(super) const ALLOWED_PRIORITIES: &str = "must be an integer from -100 to 100";
/// Largest field of a form for tags, bytes: they may be written with escapes.
const MAX_TAGS_TEXT: usize = 256 << 10;
/// Largest other text field of a form but parameters, bytes.
const MAX_TEXT_BYTES: usize = 4 << 10;
/// Most faults that are listed in an answer; a form is read no further.
const MAX_FAULTS: usize = 16;
/// Most DICOM instances of an input.
const MAX_INSTANCES: usize = 20_000;
const REPEATED: &str = "must be sent once, unless every file is an instance of a DICOM series";
const KNOWN: &str =
    "known fields are source, target, parameters, tags, external_ref, priority, deadline_at, max_run_s, use_cache";

// The examples are what the page at /docs fills in: without them it makes up a deadline that is now, and extremes of all parameters.
/// A submission as a multipart form. A text field that is empty is the same as none, except `parameters`.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub(crate) struct SubmissionForm {
    /// The surface that is moved onto the target: a surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label
    /// volume (NIfTI, MGZ, NRRD, MetaImage, DICOM SEG). The instances of a DICOM series may be sent as one zip or in several fields of this name.
    #[schema(format = Binary)]
    source: String,
    /// The surface that stays in place.
    #[schema(format = Binary)]
    target: String,
    /// Parameters that differ from the preset that `method` names; `{}` or absent for the defaults.
    #[schema(value_type = PartialParameters, required = false)]
    parameters: Option<Value>,
    /// Tags of the client's choice: a JSON object of strings.
    #[schema(value_type = BTreeMap<String, String>, required = false, example = json!({}))]
    tags: Option<BTreeMap<String, String>>,
    /// The former name of `tags`, accepted until 0.3.
    #[schema(value_type = BTreeMap<String, String>, required = false, deprecated, example = "")]
    labels: Option<BTreeMap<String, String>>,
    /// The client's own id of the job.
    #[schema(value_type = String, required = false, max_length = 200, example = "")]
    external_ref: Option<String>,
    /// Jobs with a higher priority run first; 0 if absent.
    #[schema(value_type = i32, required = false, minimum = -100, maximum = 100, example = 0)]
    priority: Option<i32>,
    /// The job expires if it has not started by this RFC 3339 time.
    #[schema(value_type = String, required = false, format = DateTime, example = "")]
    deadline_at: Option<String>,
    /// Longest run time, s, up to the limit of the service.
    #[schema(value_type = u64, required = false, minimum = 1, example = 3600)]
    max_run_s: Option<u64>,
    /// Whether the result of an equal job may be returned: `true` or `false`; `true` if absent.
    #[schema(value_type = bool, required = false, example = true)]
    use_cache: Option<bool>,
}

submission_document! {
    /// A submission in JSON.
    struct SubmissionDocument {
        /// The surface that is moved onto the target.
        #[serde(deserialize_with = "input")]
        pub(crate) source: SubmittedInputDocument,
        /// The surface that stays in place.
        #[serde(deserialize_with = "input")]
        pub(crate) target: SubmittedInputDocument,
    } options {
        parameters: "Parameters that differ from the preset that `method` names.",
        tags: "Tags of the client's choice: at most 64, keys of 1 to 256 bytes, values of at most 256.",
        external_ref: "The client's own id.",
        priority: "Jobs with a higher priority run first.",
        max_run_s: "Longest run time, s, up to the limit of the service.",
        deadline_at: "The job expires if it has not started by this time.",
        use_cache: "Whether the result of an equal job may be returned; true if absent."
    }
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
    pub(crate) details: JobOptions,
}

/// Reads a submission in either form.
///
/// # Errors
/// A problem: unsupported media type, malformed body, a size limit, or all faults of the fields.
pub(super) async fn read(
    request: axum::extract::Request,
    tap: &LimitedBody,
    limits: &HttpLimits,
    accepted: &SubmissionLimits,
) -> Result<Request, Problem> {
    let mut fields = Fields::under(limits, accepted);
    match media_type(&request).as_str() {
        "multipart/form-data" => fields.read_form(request, tap, limits).await?,
        "application/json" => {
            let document: SubmissionDocument = read_json(request, tap, limits, limits.max_json_bytes).await?;
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

/// Reads a JSON body of at most `limit` bytes.
///
/// # Errors
/// A problem: too large, too slow, not JSON, or a fault in a field.
pub(super) async fn read_json<T: DeserializeOwned>(
    request: axum::extract::Request,
    tap: &LimitedBody,
    limits: &HttpLimits,
    limit: usize,
) -> Result<T, Problem> {
    let limit = limit.min(limits.max_body_bytes());
    tap.limit_to(limit);
    let mut body = request.into_body();
    let mut text = BytesMut::new();
    // The whole at once, where its size is known: a buffer that grows is in memory twice while it does.
    text.reserve(usize::try_from(body.size_hint().lower()).unwrap_or(usize::MAX).min(limit));
    while let Some(frame) = body.frame().await {
        let ended_early = || Problem::new(ProblemKind::BadRequest).detail("the body ended early");
        let frame = frame.map_err(|_| tap.refusal().unwrap_or_else(ended_early))?;
        if let Ok(part) = frame.into_data() {
            text.extend_from_slice(&part);
        }
    }
    parse(&text, limits.max_parameters_bytes, limits.max_batch)
}

/// A file that does not go with those before it.
struct Unjoined;

/// An input with a further file of the same field: several DICOM instances are one series.
fn with_another(before: Option<SubmittedInput>, file: SubmittedFile) -> Result<SubmittedInput, Unjoined> {
    let is_dicom = |bytes: &Bytes| bytes.get(128..132) == Some(b"DICM");
    let mut instances = match before {
        None => return Ok(SubmittedInput::File(file)),
        Some(SubmittedInput::File(first)) if is_dicom(&first.bytes) => vec![first.bytes],
        Some(SubmittedInput::Series(instances)) if instances.len() < MAX_INSTANCES => instances,
        Some(_) => return Err(Unjoined),
    };
    if !is_dicom(&file.bytes) {
        return Err(Unjoined);
    }
    instances.push(file.bytes);
    Ok(SubmittedInput::Series(instances))
}

/// The files of a form, by their names, to which its document refers.
#[derive(Debug, Default)]
pub(super) struct SentFiles(BTreeMap<String, SubmittedInput>);

/// The field of a form with the document, which refers to the files by their names.
const DOCUMENT: &str = "document";
/// The field of a form with a file; it may be repeated.
const FILES: &str = "files";

/// A document in JSON, or a form with the document and files that it names.
///
/// # Errors
/// A problem: unsupported media type, malformed body, a size limit, or faults of the fields.
pub(super) async fn read_with_files<T: DeserializeOwned>(
    request: axum::extract::Request,
    tap: &LimitedBody,
    limits: &HttpLimits,
) -> Result<(T, SentFiles), Problem> {
    match media_type(&request).as_str() {
        "application/json" => Ok((read_json(request, tap, limits, limits.max_json_bytes).await?, SentFiles::default())),
        "multipart/form-data" => read_form_with_files(request, tap, limits).await,
        _ => Err(Problem::new(ProblemKind::UnsupportedMediaType)),
    }
}

async fn read_form_with_files<T: DeserializeOwned>(
    request: axum::extract::Request,
    tap: &LimitedBody,
    limits: &HttpLimits,
) -> Result<(T, SentFiles), Problem> {
    let refuse = |error: &MultipartError| form_fault(tap, error);
    let mut form = open_form(request).await?;
    let (mut document, mut files, mut faults) = (None, BTreeMap::new(), Vec::new());
    while let Some(field) = form.next_field().await.map_err(|e| refuse(&e))? {
        let field_name = field.name().unwrap_or("").to_owned();
        let file_name = field.file_name().unwrap_or("").to_owned();
        let limit = match field_name.as_str() {
            DOCUMENT if document.is_some() => {
                faults.push(FieldError::new("/document", "repeated", "must be sent once"));
                break;
            }
            DOCUMENT => limits.max_json_bytes,
            FILES if file_name.is_empty() => {
                faults.push(FieldError::new(
                    "/files",
                    "missing",
                    "each file must have a name, to which the document refers",
                ));
                break;
            }
            FILES => limits.max_file_bytes,
            other => {
                let shown: String = other.chars().take(64).collect();
                faults.push(FieldError::new(
                    format!("/{shown}"),
                    "unknown_field",
                    "known fields are document and files",
                ));
                break;
            }
        };
        let bytes = read_field(field, limit).await.map_err(|e| match e {
            Some(error) => refuse(&error),
            None => field_too_large(&field_name, limit),
        })?;
        if field_name == DOCUMENT {
            document = Some(parse(&bytes, limits.max_parameters_bytes, limits.max_batch)?);
            continue;
        }
        let file = SubmittedFile { bytes, name_hint: name_hint(&file_name) };
        match with_another(files.remove(&file_name), file) {
            Ok(input) if files.len() <= limits.max_batch => drop(files.insert(file_name, input)),
            Ok(_) => {
                return Err(Problem::new(ProblemKind::TooLarge)
                    .detail(format!("a form can have at most {} files", limits.max_batch + 1))
                    .member("limit_files", (limits.max_batch + 1).into()));
            }
            Err(Unjoined) => {
                faults.push(FieldError::new("/files", "repeated", "files must have different names"));
                break;
            }
        }
    }
    match document {
        Some(document) if faults.is_empty() => Ok((document, SentFiles(files))),
        None if faults.is_empty() => {
            let fault =
                FieldError::new("/document", "missing", "is required: the JSON document that refers to the files");
            Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]))
        }
        _ => Err(Problem::new(ProblemKind::InvalidRequest).errors(&faults)),
    }
}

async fn open_form(request: axum::extract::Request) -> Result<Multipart, Problem> {
    let opened = Multipart::from_request(request, &()).await;
    opened.map_err(|e| Problem::new(ProblemKind::MalformedMultipart).detail(e.body_text()))
}

fn form_fault(tap: &LimitedBody, error: &MultipartError) -> Problem {
    let malformed = || Problem::new(ProblemKind::MalformedMultipart).detail(error.body_text());
    tap.refusal().unwrap_or_else(malformed)
}

fn field_too_large(name: &str, limit: usize) -> Problem {
    Problem::new(ProblemKind::TooLarge)
        .detail(format!("{name} has more than {limit} bytes"))
        .member("limit_bytes", limit.into())
}

/// An input that a document refers to.
///
/// # Errors
/// Its faults, with their places below `name`.
pub(super) fn referred(
    name: &str,
    input: SubmittedInputDocument,
    files: &SentFiles,
    limits: &HttpLimits,
) -> Result<SubmittedInput, Vec<FieldError>> {
    let mut fields = Fields::default();
    let taken = fields.take_input(name, input, files, limits.max_file_bytes);
    taken.ok_or(fields.faults)
}

#[derive(Default)]
struct Fields {
    source: Option<SubmittedInput>,
    target: Option<SubmittedInput>,
    texts: BTreeSet<String>,
    parameters: Option<Value>,
    details: JobOptions,
    max_run_s: u64,
    max_parameters_bytes: usize,
    parameter_faults: bool,
    faults: Vec<FieldError>,
}

impl Fields {
    fn under(limits: &HttpLimits, accepted: &SubmissionLimits) -> Self {
        let (max_run_s, max_parameters_bytes) = (accepted.max_run.as_secs(), limits.max_parameters_bytes);
        Fields { max_run_s, max_parameters_bytes, ..Fields::default() }
    }

    async fn read_form(
        &mut self,
        request: axum::extract::Request,
        tap: &LimitedBody,
        limits: &HttpLimits,
    ) -> Result<(), Problem> {
        let refuse = |error: &MultipartError| form_fault(tap, error);
        let mut form = open_form(request).await?;
        // Bytes that source and target may still have.
        let mut left = [limits.max_file_bytes; 2];
        while let Some(field) = form.next_field().await.map_err(|e| refuse(&e))? {
            let name = field.name().unwrap_or("").to_owned();
            match name.as_str() {
                "source" | "target" => {
                    let name_hint = field.file_name().and_then(name_hint);
                    let limit = limits.max_file_bytes;
                    let left = &mut left[usize::from(name == "target")];
                    let bytes = read_field(field, *left).await.map_err(|e| match e {
                        Some(error) => refuse(&error),
                        None => field_too_large(&name, limit).member("input", name.clone().into()),
                    })?;
                    *left -= bytes.len();
                    let slot = if name == "source" { &mut self.source } else { &mut self.target };
                    match with_another(slot.take(), SubmittedFile { bytes, name_hint }) {
                        Ok(input) => *slot = Some(input),
                        Err(Unjoined) => self.faults.push(FieldError::new(format!("/{name}"), "repeated", REPEATED)),
                    }
                }
                "parameters" | "tags" | FORMER_TAGS | "external_ref" | "priority" | "deadline_at" | "max_run_s"
                | "use_cache" => {
                    let limit = match name.as_str() {
                        "parameters" => limits.max_parameters_bytes,
                        "tags" | FORMER_TAGS => MAX_TAGS_TEXT,
                        _ => MAX_TEXT_BYTES,
                    };
                    let bytes = read_field(field, limit).await.map_err(|e| match e {
                        Some(error) => refuse(&error),
                        None => field_too_large(&name, limit),
                    })?;
                    self.take_text(&name, &bytes);
                }
                _ => {
                    let shown: String = name.chars().take(64).collect();
                    self.faults.push(FieldError::new(format!("/{shown}"), "unknown_field", KNOWN));
                }
            }
            if self.faults.len() >= MAX_FAULTS {
                break; // the list is long enough
            }
        }
        Ok(())
    }

    fn fault(&mut self, name: &str, code: &str, detail: &str) {
        self.parameter_faults |= name == "parameters";
        self.faults.push(FieldError::new(format!("/{name}"), code, detail));
    }

    fn metadata_fault(&mut self, name: &str, fault: MetadataFault) {
        self.fault(name, "out_of_range", &fault.to_string());
    }

    /// Takes a text field of a form.
    fn take_text(&mut self, name: &str, bytes: &[u8]) {
        if !self.texts.insert(name.to_owned()) {
            return self.fault(name, "repeated", "must be sent once");
        }
        let Ok(text) = std::str::from_utf8(bytes) else { return self.fault(name, "not_utf8", "must be UTF-8") };
        // Forms of browsers send every field, also those that nobody filled in.
        if name != "parameters" && text.trim().is_empty() {
            return;
        }
        match name {
            "parameters" => match parse_parameters(text, self.max_parameters_bytes) {
                Ok(parameters) => self.take_parameters(parameters),
                Err(fault) => {
                    self.parameter_faults = true;
                    self.faults.push(fault);
                }
            },
            "tags" | FORMER_TAGS if self.texts.contains("tags") && self.texts.contains(FORMER_TAGS) => {
                self.fault(FORMER_TAGS, "repeated", "is the former name of tags; send tags only");
            }
            "tags" => match serde_json::from_str(text) {
                Ok(tags) => self.take_tags(tags, SentTags::default()),
                Err(_) => self.fault(name, "wrong_type", "must be a JSON object of strings, each key once"),
            },
            FORMER_TAGS => match serde_json::from_str(text) {
                Ok(former) => self.take_tags(SentTags::default(), former),
                Err(_) => self.fault(name, "wrong_type", "must be a JSON object of strings, each key once"),
            },
            "external_ref" => self.take_external_ref(text.to_owned()),
            "priority" => self.take_priority(text.trim().parse().ok()),
            "deadline_at" => match text.trim().parse() {
                Ok(time) => self.details.deadline_at = Some(time),
                Err(_) => self.fault(name, "out_of_range", "must be an RFC 3339 time, such as 2026-11-21T08:00:00Z"),
            },
            "max_run_s" => self.take_max_run(text.trim().parse().ok()),
            // Clients write the words as their languages do, such as True.
            _ => match text.trim().to_ascii_lowercase().as_str() {
                "true" => self.details.compute_anew = false,
                "false" => self.details.compute_anew = true,
                _ => self.fault(name, "out_of_range", "must be true or false"),
            },
        }
    }

    /// Takes a JSON submission.
    fn take_document(&mut self, mut document: SubmissionDocument, max_file_bytes: usize) {
        let options = document.take_options();
        let files = SentFiles::default();
        self.source = self.take_input("source", document.source, &files, max_file_bytes);
        self.target = self.take_input("target", document.target, &files, max_file_bytes);
        self.take_options(options);
    }

    fn take_options(&mut self, options: SentOptions) {
        if let Some(parameters) = options.parameters {
            self.take_parameters(parameters);
        }
        self.take_tags(options.tags, options.labels);
        if let Some(text) = options.external_ref {
            self.take_external_ref(text);
        }
        if let Some(priority) = options.priority {
            self.take_priority(Some(priority));
        }
        self.details.deadline_at = options.deadline_at;
        if let Some(seconds) = options.max_run_s {
            self.take_max_run(Some(seconds));
        }
        self.details.compute_anew = options.use_cache == Some(false);
    }

    fn take_input(
        &mut self,
        name: &str,
        input: SubmittedInputDocument,
        files: &SentFiles,
        max_file_bytes: usize,
    ) -> Option<SubmittedInput> {
        let SubmittedInputDocument { mesh_id, content_base64, upload, file_name } = input;
        match (mesh_id, content_base64, upload) {
            (Some(id), None, None) => match hash_of_id(&id) {
                Some(hash) => Some(SubmittedInput::Mesh(hash.to_owned())),
                None => {
                    let detail = "must be the id of an upload: blake3: and 64 hexadecimal digits";
                    self.fault(&format!("{name}/mesh_id"), "out_of_range", detail);
                    None
                }
            },
            (None, None, Some(sent)) => {
                let found = files.0.get(&sent).cloned();
                if found.is_none() {
                    let detail = "must be the name of a file in the field files of the form";
                    self.fault(&format!("{name}/upload"), "missing", detail);
                }
                found
            }
            (None, Some(Content(decoded)), None) => match decoded {
                Some(bytes) if bytes.len() <= max_file_bytes => {
                    let name_hint = file_name.as_deref().and_then(name_hint);
                    Some(SubmittedInput::File(SubmittedFile { bytes, name_hint }))
                }
                Some(_) => {
                    let detail = format!("must have at most {max_file_bytes} bytes");
                    self.fault(&format!("{name}/content_base64"), "out_of_range", &detail);
                    None
                }
                None => {
                    self.fault(&format!("{name}/content_base64"), "malformed_base64", "must be standard base64");
                    None
                }
            },
            _ => {
                self.fault(name, "out_of_range", "must have exactly one of mesh_id, content_base64 and upload");
                None
            }
        }
    }

    fn take_parameters(&mut self, Parameters(value): Parameters) {
        match value {
            Value::Object(_) => self.parameters = Some(value),
            _ => self.fault("parameters", "wrong_type", "must be a JSON object"),
        }
    }

    fn take_tags(&mut self, tags: SentTags, former: SentTags) {
        match tags_of(tags, former) {
            Ok(tags) => self.details.tags = tags,
            Err((name, allowed)) => self.fault(name, "out_of_range", &allowed),
        }
    }

    fn take_external_ref(&mut self, text: String) {
        match ExternalRef::new(text) {
            Ok(reference) => self.details.external_ref = reference,
            Err(fault) => self.metadata_fault("external_ref", fault),
        }
    }

    fn take_priority(&mut self, priority: Option<i32>) {
        match priority {
            Some(priority) if PRIORITIES.contains(&priority) => self.details.priority = priority,
            _ => self.fault("priority", "out_of_range", ALLOWED_PRIORITIES),
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

/// Checks the members of a JSON body other than inputs, like those of a job.
///
/// # Errors
/// All their faults.
pub(super) fn check_options(options: SentOptions, state: &HttpState) -> Result<(Value, JobOptions), Problem> {
    let mut fields = Fields::under(&state.limits, state.service.limits());
    fields.take_options(options);
    if !fields.faults.is_empty() {
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&fields.faults));
    }
    Ok((fields.parameters.unwrap_or_else(|| Value::Object(serde_json::Map::new())), fields.details))
}
