//! `/v1/jobs/{id}/surfaces/{which}` and `/aligned`: surfaces as files.

use super::{job_id, tenant};
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::jobs::{ArtifactKind, JobId};
use axum::extract::{Path, State};
use axum::http::HeaderMap;
use axum::response::Response;

/// Read a surface whose vertices the correspondences count
#[utoipa::path(
    get, path = "/v1/jobs/{id}/surfaces/{which}", tag = "results", operation_id = "get_surface",
    params(
        ("id" = String, Path, description = "The job"),
        ("which" = String, Path, description = "`source` or `target`"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "Binary PLY, mm", content_type = "model/ply", body = Vec<u8>, headers(("ETag" = String))),
        (status = 304, description = "Unchanged"),
        (status = 404, description = "No such job or surface", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn surface(
    State(state): State<HttpState>,
    Path((id, which)): Path<(String, String)>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let kind = match which.as_str() {
        "source" => ArtifactKind::SourceSurface,
        "target" => ArtifactKind::TargetSurface,
        _ => return Err(Problem::new(ProblemKind::RouteNotFound).detail("surfaces are source and target")),
    };
    file(&state, job_id(&id)?, kind, &headers).await
}

/// Read the source surface moved onto the target
#[utoipa::path(
    get, path = "/v1/jobs/{id}/aligned", tag = "results", operation_id = "get_aligned",
    params(
        ("id" = String, Path, description = "The job"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "Binary PLY, mm", content_type = "model/ply", body = Vec<u8>, headers(("ETag" = String))),
        (status = 304, description = "Unchanged"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn aligned(
    State(state): State<HttpState>,
    Path(id): Path<String>,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    file(&state, job_id(&id)?, ArtifactKind::Aligned, &headers).await
}

async fn file(state: &HttpState, id: JobId, kind: ArtifactKind, headers: &HeaderMap) -> Result<Response, Problem> {
    let part = state.service.result_part(&tenant(), id, kind).await?;
    let etag = format!("\"{}\"", &part.key.hash()[..32]);
    if is_fresh(headers, &etag) {
        return Ok(not_modified(&etag));
    }
    Ok(respond(headers, &etag, "model/ply", state.service.read(&part).await?))
}
