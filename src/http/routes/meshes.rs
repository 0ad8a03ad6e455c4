//! `/v1/meshes`: uploads, identified by the hash of their content.

use super::{DEFAULT_PAGE, MAX_PAGE};
use crate::http::auth::{Reader, Submitter};
use crate::http::compression::Gains;
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::content::{Counted, Wanted, streamed, wanted};
use crate::http::fields::Fields;
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::{AS_IT_ARRIVES, HttpState};
use crate::http::shares::Origin;
use crate::http::submission::media_type;
use crate::http::upload::{Tap, name_hint};
use crate::http::wire::{MeshDocument, MeshListDocument};
use crate::jobs::mesh::{content_id, hash_of_id};
use crate::jobs::uploads::Upload;
use crate::jobs::{BlobStream, Mesh, Tenant};
use axum::Json;
use axum::body::Body;
use axum::extract::multipart::MultipartError;
use axum::extract::{FromRequest, Multipart, Path, Request, State};
use axum::http::{HeaderMap, Method, StatusCode, header};
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
    post, path = "/v1/meshes", tag = "meshes", operation_id = "upload_mesh",
    params(
        ("file_name" = Option<String>, Query, description = "Name of the file; only its extension is kept"),
        ("inspect" = Option<bool>, Query, description = "`false` stores the file without inspecting it; it is inspected when a job uses it"),
    ),
    request_body(content(
        (FileBytes = "application/octet-stream"),
        (MeshForm = "multipart/form-data"),
    )),
    responses(
        (status = 200, description = "The same file was uploaded before", body = MeshDocument, headers(("Location" = String, description = "The upload"))),
        (status = 201, description = "Uploaded", body = MeshDocument, headers(("Location" = String, description = "The upload"))),
        (status = 400, description = "The body or the query is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 408, description = "The body took too long to arrive", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "Larger than a limit of the service", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Unsupported media type", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "An empty body, or a form without a file", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 503, description = "Too many uploads at once, or a dependency does not respond", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 507, description = "Out of storage space", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn upload(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    mut query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let (request, tap) = Tap::on(request, state.limits.max_file_bytes.saturating_add(1 << 20));
    let inspect = query.word("inspect", &[("true", true), ("false", false)]).unwrap_or(true);
    let file_name = query.text("file_name");
    let stored = match query.finish() {
        Ok(()) => store(&state, &tenant, file_name, request, &tap).await,
        Err(problem) => Err(problem),
    };
    let (mesh, is_new) = tap.settle(stored).await?;
    drop(tap);
    let check = if inspect { Some(state.service.mesh_report(&mesh).await?) } else { None };
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
    state: &HttpState,
    tenant: &Tenant,
    file_name: Option<String>,
    request: Request,
    tap: &Tap,
) -> Result<(Mesh, bool), Problem> {
    state.begin_reading(tap, tenant, Origin::of(request.extensions()), AS_IT_ARRIVES).await?;
    let reading = async {
        match media_type(&request).as_str() {
            "multipart/form-data" => store_form(state, tenant, request, tap).await,
            "application/json" => Err(Problem::new(ProblemKind::UnsupportedMediaType)),
            _ => store_raw(state, tenant, file_name, request, tap).await,
        }
    };
    let reading = tokio::time::timeout(state.limits.upload_timeout, reading);
    reading.await.map_err(|_| Problem::new(ProblemKind::UploadTimeout))?
}

fn too_large(state: &HttpState) -> Problem {
    let limit = state.limits.max_file_bytes;
    Problem::new(ProblemKind::TooLarge)
        .detail(format!("the file has more than {limit} bytes"))
        .member("limit_bytes", limit.into())
}

/// The answer to a body that was not read to its end because of a limit.
fn refusal(state: &HttpState, tap: &Tap) -> Option<Problem> {
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
    state: &HttpState,
    tenant: &Tenant,
    file_name: Option<String>,
    request: Request,
    tap: &Tap,
) -> Result<(Mesh, bool), Problem> {
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

async fn store_form(state: &HttpState, tenant: &Tenant, request: Request, tap: &Tap) -> Result<(Mesh, bool), Problem> {
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
    let fault = crate::http::problem::FieldError::new("/file", "missing", detail);
    Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]))
}

/// The hash in the id of a path; 404 for a text that cannot be an id.
fn hash(id: &str) -> Result<&str, Problem> {
    hash_of_id(id).ok_or_else(|| Problem::new(ProblemKind::MeshNotFound))
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
#[utoipa::path(
    get, path = "/v1/meshes", tag = "meshes", operation_id = "list_meshes",
    params(
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Maximum number of entries; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page"),
    ),
    responses(
        (status = 200, description = "A page", body = MeshListDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn list(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let size = query.number("page_size", 1..=MAX_PAGE).unwrap_or(DEFAULT_PAGE);
    let token = query.text("page_token").filter(|token| !token.is_empty());
    let after = token.as_deref().and_then(cursor);
    if token.is_some() && after.is_none() {
        query.fault("page_token", "out_of_range", "must be a next_page_token of an earlier answer");
    }
    let fields = Fields::<MeshDocument>::of(&mut query);
    query.finish()?;
    let page = state.service.meshes(&tenant, size, after).await?;
    let meshes = page.meshes.iter().map(|mesh| MeshDocument::of(mesh, None)).collect();
    let next_page_token = page.next.map(|(time, hash)| token_of(time, &hash));
    fields.answer(&MeshListDocument { meshes, next_page_token }, "meshes")
}

/// Get an upload
#[utoipa::path(
    get, path = "/v1/meshes/{id}", tag = "meshes", operation_id = "get_mesh",
    params(
        ("id" = String, Path, description = "`blake3:` and 64 hexadecimal digits"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The upload with its inspection report", body = MeshDocument, headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such mesh", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn get(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let mesh = state.service.mesh(&tenant, hash(&id)?).await?;
    // Neither the bytes nor their inspection with default parameters change within a version.
    let etag = format!("\"{}-{}\"", &mesh.key.hash()[..32], env!("CARGO_PKG_VERSION"));
    if is_fresh(&headers, &etag) {
        return Ok(not_modified(&etag));
    }
    let check = state.service.mesh_report(&mesh).await?;
    let body = serde_json::to_vec(&MeshDocument::of(&mesh, Some(check))).map_err(|e| Problem::internal(&e))?;
    Ok(respond(&headers, &etag, "application/json", body))
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
    get, path = "/v1/meshes/{id}/content", tag = "meshes", operation_id = "get_mesh_content",
    params(
        ("id" = String, Path, description = "`blake3:` and 64 hexadecimal digits"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
        ("Range" = Option<String>, Header, description = "One range of bytes, such as `bytes=1000-1999`"),
    ),
    responses(
        (status = 206, description = "The range of the bytes", content_type = "application/octet-stream", body = Vec<u8>, headers(("Content-Range" = String, description = "The range, and the size of the whole"))),
        (status = 416, description = "The range is not within the content", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 200, description = "The bytes as they were uploaded", content_type = "application/octet-stream", body = Vec<u8>, headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such mesh", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn content(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    method: Method,
    Path(id): Path<String>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let mesh = state.service.mesh(&tenant, hash(&id)?).await?;
    let etag = format!("\"{}\"", &mesh.key.hash()[..32]);
    let (range, with_body) = match wanted(&method, &headers, &etag, mesh.n_bytes) {
        Wanted::Nothing(response) => return Ok(*response),
        Wanted::Content { range, with_body } => (range, with_body),
    };
    let stream = if with_body { Some(state.service.open_mesh(&mesh, range.clone()).await?) } else { None };
    let mut response = streamed(&headers, &etag, "application/octet-stream", mesh.n_bytes, range.as_ref(), stream);
    // Checked only for clients that accept compression.
    if range.is_none() && headers.contains_key(header::ACCEPT_ENCODING) {
        let beginning = state.service.open_mesh(&mesh, Some(0..mesh.n_bytes.min(BEGINNING))).await?;
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
    get, path = "/v1/meshes/{id}/surface", tag = "meshes", operation_id = "get_mesh_surface",
    params(
        ("id" = String, Path, description = "`blake3:` and 64 hexadecimal digits"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The surface as binary PLY, mm", content_type = "model/ply", body = Vec<u8>, headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such mesh", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "The surface is larger than may be matched", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "There is no surface: the format of the file is not known", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "There is no surface: the file cannot be read, or no structure is labeled", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn surface(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    origin: Origin,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let mesh = state.service.mesh(&tenant, hash(&id)?).await?;
    let etag = format!("\"{}-{}-surface\"", &mesh.key.hash()[..32], env!("CARGO_PKG_VERSION"));
    if is_fresh(&headers, &etag) {
        return Ok(not_modified(&etag));
    }
    let bytes = state.service.mesh_surface(&mesh).await?;
    let memory = state.answer_memory(&tenant, origin, bytes.len()).await?;
    Ok(respond(&headers, &etag, "model/ply", Body::new(Counted::new(bytes.into(), memory))))
}

/// Delete an upload
///
/// Only if no job refers to it: delete those jobs first, or wait until their retention time is over.
#[utoipa::path(
    delete, path = "/v1/meshes/{id}", tag = "meshes", operation_id = "delete_mesh",
    params(("id" = String, Path, description = "`blake3:` and 64 hexadecimal digits")),
    responses(
        (status = 204, description = "Deleted"),
        (status = 404, description = "No such mesh", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Jobs refer to it", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn delete(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<StatusCode, Problem> {
    query.finish()?;
    state.service.delete_mesh(&tenant, hash(&id)?).await?;
    Ok(StatusCode::NO_CONTENT)
}
