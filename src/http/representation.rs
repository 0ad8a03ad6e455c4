//! Representations of results: `?format=` chooses the format, otherwise `Accept`; each format has its own ETag.

use super::accept::preferred;
use super::call::AuthorizedRequest;
use super::compression::{Gains, gains};
use super::conditional::{is_fresh, not_modified, respond};
use super::content::{Counted, Stored};
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::query::QueryString;
use crate::jobs::{GivenUids, JobId, PartFormat, Presented, ResultPart, Uid};
use axum::body::Body;
use axum::http::{HeaderValue, header};
use axum::response::{IntoResponse, Response};
use serde_json::json;

/// A page of this service may run its own scripts, as its own policy says, but not in the name of this service.
const PAGE_POLICY: HeaderValue =
    HeaderValue::from_static("sandbox allow-scripts allow-downloads; frame-ancestors 'none'");

/// The headers of a format.
struct Form {
    /// The type that is compared with `Accept`.
    media_type: &'static str,
    /// `Content-Type`.
    content_type: &'static str,
    /// File extension, for formats that clients save as files.
    ending: Option<&'static str>,
}

fn form(format: PartFormat) -> Form {
    let (media_type, content_type, ending) = match format {
        PartFormat::Json => ("application/json", "application/json", None),
        PartFormat::Csv => ("text/csv", "text/csv; charset=utf-8; header=present", Some("csv")),
        PartFormat::Npy => ("application/x-npy", "application/x-npy", Some("npy")),
        PartFormat::Arrow => ("application/vnd.apache.arrow.file", "application/vnd.apache.arrow.file", Some("arrow")),
        PartFormat::Ply => ("model/ply", "model/ply", Some("ply")),
        PartFormat::Vtk => ("model/vtk", "model/vtk", Some("vtk")),
        PartFormat::Vtp => ("application/vnd.vtk.vtp", "application/vnd.vtk.vtp", Some("vtp")),
        PartFormat::Gifti => ("application/gifti+xml", "application/gifti+xml", Some("surf.gii")),
        PartFormat::Stl => ("model/stl", "model/stl", Some("stl")),
        PartFormat::Text => ("text/plain", "text/plain; charset=utf-8", None),
        PartFormat::Itk => ("application/x-itk-transform", "application/x-itk-transform", Some("tfm")),
        PartFormat::Npz => ("application/x-npz", "application/x-npz", Some("npz")),
        PartFormat::Parquet => ("application/vnd.apache.parquet", "application/vnd.apache.parquet", Some("parquet")),
        PartFormat::Glb => ("model/gltf-binary", "model/gltf-binary", Some("glb")),
        PartFormat::Dicom => ("application/dicom", "application/dicom", Some("dcm")),
        PartFormat::Html => ("text/html", "text/html; charset=utf-8", None),
        PartFormat::Lta => ("application/x-freesurfer-lta", "application/x-freesurfer-lta", Some("lta")),
    };
    Form { media_type, content_type, ending }
}

/// The chosen answer.
struct Chosen {
    part: ResultPart,
    format: PartFormat,
    uids: GivenUids,
    content_type: &'static str,
}

/// Answers a part of the result of the job in the path, in the requested format.
pub(super) async fn answer(mut call: AuthorizedRequest, part: ResultPart) -> Result<Response, Problem> {
    let id = call.id()?;
    let uids = given_uids(part, &mut call.query);
    let Some(format) = choose(part, &mut call)? else {
        // 404 comes first, so that the answer reveals nothing about jobs of other tenants.
        call.service().get(&call.tenant, id).await?;
        return Ok(varying(not_acceptable(part).into_response()));
    };
    let form = form(format);
    let chosen = Chosen { part, format, uids, content_type: form.content_type };
    let response = content(&call, id, chosen).await?;
    Ok(varying(named(response, id, part, form.ending)))
}

/// Answers a part of a job's result in this format, as bytes to save.
pub(super) async fn answer_file(
    call: &AuthorizedRequest,
    id: JobId,
    (part, format, uids): (ResultPart, PartFormat, GivenUids),
) -> Result<Response, Problem> {
    let chosen = Chosen { part, format, uids, content_type: "application/octet-stream" };
    let mut response = content(call, id, chosen).await?;
    response.extensions_mut().insert(Gains(gains(form(format).content_type)));
    response.headers_mut().insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    Ok(named(response, id, part, Some(form(format).ending.unwrap_or(format.name()))))
}

/// The content of a part in this format. It is streamed if it is stored in this format; otherwise it is converted in
/// memory, which is counted until the answer is sent.
async fn content(
    call: &AuthorizedRequest,
    id: JobId,
    Chosen { part, format, uids, content_type }: Chosen,
) -> Result<Response, Problem> {
    let presentation = call.service().presentation(&call.tenant, id, part, format, uids).await?;
    let etag = format!("\"{}\"", presentation.validator());
    if is_fresh(&call.headers, &etag) {
        return Ok(not_modified(&etag));
    }
    match call.service().present(&presentation).await? {
        Presented::Stored(blob) => {
            let stored = Stored { etag: &etag, content_type, n_bytes: blob.n_bytes };
            stored.answer(call, |range| call.service().open(&blob, range)).await
        }
        Presented::Converted(bytes) => {
            let memory = call.memory(bytes.len()).await?;
            let response = respond(&call.headers, &etag, content_type, Body::new(Counted::new(bytes, memory)));
            Ok(if format == PartFormat::Html { as_page(response) } else { response })
        }
    }
}

/// The answer with the policy of a page.
pub(super) fn as_page(mut response: Response) -> Response {
    response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, PAGE_POLICY);
    response.headers_mut().insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    response
}

/// The UIDs that a request supplies for inputs without UIDs, for a part that can be a DICOM object.
pub(super) fn given_uids(part: ResultPart, query: &mut QueryString) -> GivenUids {
    if !part.formats().contains(&PartFormat::Dicom) {
        return GivenUids::default();
    }
    let mut uid = |name: &str| {
        let text = query.text(name)?;
        text.parse::<Uid>().map_err(|fault| query.fault(name, "out_of_range", fault.to_string())).ok()
    };
    GivenUids { study: uid("study_uid"), source_frame: uid("source_frame_uid"), target_frame: uid("target_frame_uid") }
}

/// The format of the answer; `None` if `Accept` allows none of the available ones.
///
/// # Errors
/// `invalid-query`.
fn choose(part: ResultPart, call: &mut AuthorizedRequest) -> Result<Option<PartFormat>, Problem> {
    let formats = part.formats();
    let words: Vec<_> = formats.iter().map(|&format| (format.name(), format)).collect();
    let asked = call.query.word("format", &words);
    call.query.finish()?;
    let offered: Vec<_> = formats.iter().map(|&format| form(format).media_type).collect();
    Ok(asked.or_else(|| preferred(&call.headers, &offered).map(|index| formats[index])))
}

fn not_acceptable(part: ResultPart) -> Problem {
    let available = part.formats().iter().map(|&f| json!({"format": f.name(), "media_type": form(f).media_type}));
    Problem::new(ProblemKind::NotAcceptable).member("available", available.collect())
}

/// Declares that the answer depends on `Accept`.
fn varying(mut response: Response) -> Response {
    response.headers_mut().insert(header::VARY, HeaderValue::from_static("accept"));
    response
}

/// Adds a file name that contains nothing sent by a client.
fn named(mut response: Response, id: JobId, part: ResultPart, ending: Option<&str>) -> Response {
    if let Some(ending) = ending {
        let value = format!("attachment; filename=\"homolog-{id}-{}.{ending}\"", part.name());
        if let Ok(value) = HeaderValue::from_str(&value) {
            response.headers_mut().insert(header::CONTENT_DISPOSITION, value);
        }
    }
    response
}
