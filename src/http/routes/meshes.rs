//! `/v1/meshes`: uploads, identified by the hash of their content.

use crate::http::call::{AuthorizedRequest, MeshHash, PageOf};
use crate::http::compression::Gains;
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::content::{Counted, Stored};
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::state::HttpState;
use crate::http::submission::media_type;
use crate::http::upload::{LimitedBody, name_hint};
use crate::http::wire::{MeshDocument, MeshListDocument};
use crate::jobs::mesh::{content_id, hash_of_id};
use crate::jobs::uploads::Upload;
use crate::jobs::{BlobStream, Mesh};
use axum::Json;
use axum::body::Body;
use axum::extract::multipart::MultipartError;
use axum::extract::{FromRequest, Multipart, Request};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use bytes::Bytes;
use futures_util::TryStreamExt as _;
use http_body_util::BodyExt;

/// Upload a mesh or a label volume
///
/// Send the file as the raw body (with `?file_name=` if the bytes alone do not tell the format), or as the field `file` of a
/// multipart form. The id is the hash of the content: uploading the same bytes again answers 200 with the existing upload.
/// The answer says whether the file can be matched with default parameters. The file is kept even if it cannot, because other
/// parameters may allow repairs.
#[utoipa::path(
    post, path = "/v1/meshes",
    params(
        ("file_name" = Option<String>, Query, description = "Name of the file; only its extension is kept"),
        ("inspect" = Option<bool>, Query, description = "`false` stores the file without inspecting it; it is inspected when a job uses it"),
    ),
    request_body(content(
        (FileBytes = "application/octet-stream"),
        (MeshForm = "multipart/form-data"))),
    responses(
        (status = 200, description = "The same file was uploaded before", body = MeshDocument, headers(("Location" = String, description = "The upload"))),
        (status = 201, description = "Uploaded", body = MeshDocument, headers(("Location" = String, description = "The upload"))),
    )
)]
pub(crate) async fn upload(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let (request, tap) = LimitedBody::on(request, call.state.limits.max_file_bytes.saturating_add(1 << 20));
    let inspect = call.query.word("inspect", &[("true", true), ("false", false)]).unwrap_or(true);
    let file_name = call.query.text("file_name");
    let stored = async {
        call.query.finish()?;
        store(&call, file_name, request, &tap).await
    };
    let (mesh, is_new) = tap.settle(stored).await?;
    drop(tap);
    let check = if inspect { Some(call.service().mesh_report(&mesh).await?) } else { None };
    let document = MeshDocument::of(&mesh, check);
    let status = if is_new { StatusCode::CREATED } else { StatusCode::OK };
    Ok((status, [(header::LOCATION, document.links.mesh.clone())], Json(document)).into_response())
}

/// The bytes of a file.
#[derive(Debug, Clone, utoipa::ToSchema)]
#[schema(value_type = String, format = Binary)]
#[allow(dead_code, reason = "describes a body that is read as a stream")]
pub(crate) struct FileBytes(String);

/// A multipart upload.
#[derive(Debug, Clone, utoipa::ToSchema)]
#[allow(dead_code, reason = "describes a multipart form")]
pub(crate) struct MeshForm {
    /// A surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label volume (NIfTI, MGZ, NRRD, MetaImage,
    /// DICOM SEG).
    #[schema(format = Binary)]
    file: String,
}

async fn store(
    call: &AuthorizedRequest,
    file_name: Option<String>,
    request: Request,
    tap: &LimitedBody,
) -> Result<(Mesh, bool), Problem> {
    call.begin_storing(tap).await?;
    let reading = async {
        match media_type(&request).as_str() {
            "multipart/form-data" => store_form(call, request, tap).await,
            "application/json" => Err(Problem::new(ProblemKind::UnsupportedMediaType)),
            _ => store_raw(call, file_name, request, tap).await,
        }
    };
    call.in_time(reading).await
}

fn too_large(state: &HttpState) -> Problem {
    let limit = state.limits.max_file_bytes;
    Problem::new(ProblemKind::TooLarge)
        .detail(format!("the file has more than {limit} bytes"))
        .member("limit_bytes", limit.into())
}

/// The answer to a body that was not read to its end because of a limit.
fn refusal(state: &HttpState, tap: &LimitedBody) -> Option<Problem> {
    if tap.is_over() { Some(too_large(state)) } else { tap.refusal() }
}

/// Appends a part, up to the size limit of a file.
async fn add(state: &HttpState, upload: &mut Upload, part: Bytes) -> Result<(), Problem> {
    if upload.n_bytes() + part.len() as u64 > state.limits.max_file_bytes as u64 {
        return Err(too_large(state));
    }
    Ok(upload.write(part).await?)
}

/// Completes the upload, unless it is empty.
async fn end(state: &HttpState, upload: Upload, hint: Option<String>) -> Result<(Mesh, bool), Problem> {
    if upload.n_bytes() == 0 {
        return Err(Problem::new(ProblemKind::EmptyStructure).detail("the file is empty"));
    }
    Ok(state.service.end_upload(upload, hint.as_deref()).await?)
}

async fn store_raw(
    call: &AuthorizedRequest,
    file_name: Option<String>,
    request: Request,
    tap: &LimitedBody,
) -> Result<(Mesh, bool), Problem> {
    let AuthorizedRequest { state, tenant, .. } = call;
    let mut upload = state.service.begin_upload(tenant).await?;
    let mut body = request.into_body();
    while let Some(frame) = body.frame().await {
        let frame = frame.map_err(|_| {
            let ended_early = || Problem::new(ProblemKind::BadRequest).detail("the body ended early");
            refusal(state, tap).unwrap_or_else(ended_early)
        })?;
        if let Ok(part) = frame.into_data() {
            add(state, &mut upload, part).await?;
        }
    }
    end(state, upload, file_name.as_deref().and_then(name_hint)).await
}

async fn store_form(call: &AuthorizedRequest, request: Request, tap: &LimitedBody) -> Result<(Mesh, bool), Problem> {
    let AuthorizedRequest { state, tenant, .. } = call;
    let refuse = |error: &MultipartError| {
        let malformed = || Problem::new(ProblemKind::MalformedMultipart).detail(error.body_text());
        refusal(state, tap).unwrap_or_else(malformed)
    };
    let mut form = Multipart::from_request(request, &())
        .await
        .map_err(|e| Problem::new(ProblemKind::MalformedMultipart).detail(e.body_text()))?;
    while let Some(mut field) = form.next_field().await.map_err(|e| refuse(&e))? {
        if field.name() != Some("file") {
            continue;
        }
        let hint = field.file_name().and_then(name_hint);
        let mut upload = state.service.begin_upload(tenant).await?;
        while let Some(part) = field.chunk().await.map_err(|e| refuse(&e))? {
            add(state, &mut upload, part).await?;
        }
        return end(state, upload, hint).await;
    }
    let detail = "send the file in the field `file`";
    let fault = FieldError::new("/file", "missing", detail);
    Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]))
}

/// The position in the list that a `page_token` names.
pub(in crate::http) fn cursor(token: &str) -> Option<(i64, String)> {
    let (time, hash) = token.split_once('.')?;
    let (time, hash) = (i64::from_str_radix(time, 16).ok()?, hash_of_id(&content_id(hash))?.to_owned());
    // A position has exactly one token.
    (token_of(time, &hash) == token).then_some((time, hash))
}

/// The `page_token` of a position in the list.
pub(in crate::http) fn token_of(time: i64, hash: &str) -> String {
    format!("{time:x}.{hash}")
}

/// List uploads
///
/// `fields` selects members of each entry, as in the list of jobs.
#[utoipa::path(get, path = "/v1/meshes", responses((status = 200, description = "A page", body = MeshListDocument)))]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let PageOf { size, after, fields } = call.last_page::<_, MeshDocument>(cursor)?;
    let page = call.service().meshes(&call.tenant, size, after).await?;
    let meshes = page.meshes.iter().map(|mesh| MeshDocument::of(mesh, None)).collect();
    let next_page_token = page.next.map(|(time, hash)| token_of(time, &hash));
    fields.answer(&MeshListDocument { meshes, next_page_token }, "meshes")
}

/// Get an upload
#[utoipa::path(
    get, path = "/v1/meshes/{id}",
    responses((status = 200, description = "The upload with its inspection report", body = MeshDocument))
)]
pub(crate) async fn get(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let MeshHash(hash) = call.last_id()?;
    let mesh = call.service().mesh(&call.tenant, &hash).await?;
    // Neither the bytes nor their inspection with default parameters change within a version.
    let etag = format!("\"{}-{}\"", &mesh.key.hash()[..32], env!("CARGO_PKG_VERSION"));
    if is_fresh(&call.headers, &etag) {
        return Ok(not_modified(&etag));
    }
    let check = call.service().mesh_report(&mesh).await?;
    let body = serde_json::to_vec(&MeshDocument::of(&mesh, Some(check))).map_err(|e| Problem::internal(&e))?;
    Ok(respond(&call.headers, &etag, "application/json", body))
}

/// Number of bytes at the beginning of a file that show whether it is compressed.
const BEGINNING: u64 = 4;

/// Whether a file with these first bytes is compressed: gzip, zip or zstd.
async fn is_compressed(beginning: BlobStream) -> Result<bool, Problem> {
    let bytes = beginning.try_collect::<Vec<_>>().await?.concat();
    Ok([&[0x1f, 0x8b][..], b"PK", &[0x28, 0xb5, 0x2f, 0xfd]].iter().any(|magic| bytes.starts_with(magic)))
}

/// Download an upload
#[utoipa::path(
    get, path = "/v1/meshes/{id}/content",
    params(
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
        ("Range" = Option<String>, Header, description = "One range of bytes, such as `bytes=1000-1999`"),
    ),
    responses(
        (status = 206, description = "The range of the bytes", content_type = "application/octet-stream", body = Vec<u8>, headers(("Content-Range" = String, description = "The range, and the size of the whole"))),
        (status = 200, description = "The bytes as they were uploaded", content_type = "application/octet-stream", body = Vec<u8>),
    )
)]
pub(crate) async fn content(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let MeshHash(hash) = call.last_id()?;
    let mesh = call.service().mesh(&call.tenant, &hash).await?;
    let etag = format!("\"{}\"", &mesh.key.hash()[..32]);
    let stored = Stored { etag: &etag, content_type: "application/octet-stream", n_bytes: mesh.n_bytes };
    let mut response = stored.answer(&call, |range| call.service().open_mesh(&mesh, range)).await?;
    // Checked only for clients that accept compression.
    if response.status() == StatusCode::OK && call.headers.contains_key(header::ACCEPT_ENCODING) {
        let beginning = call.service().open_mesh(&mesh, Some(0..mesh.n_bytes.min(BEGINNING))).await?;
        response.extensions_mut().insert(Gains(!is_compressed(beginning).await?));
    }
    Ok(response)
}

/// Get the surface of an upload
///
/// A preview before a job is submitted: the surface that would be matched with default parameters, made from
/// the labels of a volume or repaired as far as is harmless. Of a mesh that cannot be matched, the surface as it is in the
/// file, on which `problem.place_mm` of the upload names the place of the first fault.
#[utoipa::path(
    get, path = "/v1/meshes/{id}/surface",
    responses((status = 200, description = "The surface as binary PLY, mm", content_type = "model/ply", body = Vec<u8>))
)]
pub(crate) async fn surface(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let MeshHash(hash) = call.last_id()?;
    let mesh = call.service().mesh(&call.tenant, &hash).await?;
    let etag = format!("\"{}-{}-surface\"", &mesh.key.hash()[..32], env!("CARGO_PKG_VERSION"));
    if is_fresh(&call.headers, &etag) {
        return Ok(not_modified(&etag));
    }
    let bytes = call.service().mesh_surface(&mesh).await?;
    let memory = call.memory(bytes.len()).await?;
    Ok(respond(&call.headers, &etag, "model/ply", Body::new(Counted::new(bytes.into(), memory))))
}

/// Delete an upload
///
/// Only if no job refers to it: delete those jobs first, or wait until their retention time is over.
#[utoipa::path(delete, path = "/v1/meshes/{id}", responses((status = 204, description = "Deleted")))]
pub(crate) async fn delete(mut call: AuthorizedRequest) -> Result<StatusCode, Problem> {
    let MeshHash(hash) = call.last_id()?;
    call.service().delete_mesh(&call.tenant, &hash).await?;
    Ok(StatusCode::NO_CONTENT)
}
