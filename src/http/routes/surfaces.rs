//! `/v1/jobs/{id}/surfaces/{which}` and `/aligned`: surfaces as files.

use super::job_id;
use crate::http::auth::Reader;
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::representation::{Asking, answer};
use crate::http::router::HttpState;
use crate::http::shares::Origin;
use crate::jobs::ResultPart;
use axum::extract::{Path, State};
use axum::http::{HeaderMap, Method};
use axum::response::Response;

/// Get a matched surface
///
/// The surface whose vertices the correspondences refer to. Binary PLY and legacy VTK are exact and keep quads. GIFTI and
/// STL have single precision and triangles only, so quads are split. STL has no shared vertices, so the vertex indices of
/// the correspondences do not apply to it.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/surfaces/{which}", tag = "results", operation_id = "get_surface",
    params(
        ("id" = String, Path, description = "The job"),
        ("which" = String, Path, description = "`source` or `target`"),
        ("format" = Option<String>, Query, description = "`ply`, `vtk`, `gifti` or `stl`; takes precedence over `Accept`; PLY if neither is given"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The surface, mm", content(
            (Vec<u8> = "model/ply"), (Vec<u8> = "model/vtk"), (String = "application/gifti+xml"), (Vec<u8> = "model/stl"),
        ), headers(
            ("ETag" = String, description = "Of this representation"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "Suggested file name"),
        )),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job or surface", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "`Accept` allows none of the formats; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn surface(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path((id, which)): Path<(String, String)>,
    method: Method,
    origin: Origin,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    let part = match which.as_str() {
        "source" => ResultPart::SourceSurface,
        "target" => ResultPart::TargetSurface,
        _ => return Err(Problem::new(ProblemKind::RouteNotFound).detail("the surface must be source or target")),
    };
    answer(&state, &tenant, job_id(&id)?, part, Asking { method: &method, headers: &headers, origin }, query).await
}

/// Get the aligned source surface
///
/// The source surface moved onto the target, in the formats of the matched surfaces.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/aligned", tag = "results", operation_id = "get_aligned",
    params(
        ("id" = String, Path, description = "The job"),
        ("format" = Option<String>, Query, description = "`ply`, `vtk`, `gifti` or `stl`; takes precedence over `Accept`; PLY if neither is given"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The surface, mm", content(
            (Vec<u8> = "model/ply"), (Vec<u8> = "model/vtk"), (String = "application/gifti+xml"), (Vec<u8> = "model/stl"),
        ), headers(
            ("ETag" = String, description = "Of this representation"), ("Vary" = String, description = "`accept`"),
            ("Content-Disposition" = String, description = "Suggested file name"),
        )),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 406, description = "`Accept` allows none of the formats; `available` lists them", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn aligned(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    method: Method,
    origin: Origin,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    answer(
        &state,
        &tenant,
        job_id(&id)?,
        ResultPart::Aligned,
        Asking { method: &method, headers: &headers, origin },
        query,
    )
    .await
}
