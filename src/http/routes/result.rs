//! `/v1/jobs/{id}/result` and `/correspondences`.

use super::{job_id, tenant};
use crate::http::conditional::{is_fresh, not_modified, respond};
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::wire::{JobResultDocument, ResultLinks};
use crate::jobs::documents::Correspondences;
use crate::jobs::{ArtifactKind, JobError};
use axum::extract::{Path, State};
use axum::http::{HeaderMap, header};
use axum::response::Response;

/// Read the result
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result", tag = "results", operation_id = "get_result",
    params(
        ("id" = String, Path, description = "The job"),
        ("correspondences" = Option<bool>, Query, description = "`false` leaves the correspondences out"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The result", body = JobResultDocument, headers(("ETag" = String))),
        (status = 304, description = "Unchanged"),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn result(
    State(state): State<HttpState>,
    Path(id): Path<String>,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let with_correspondences = query.word("correspondences", &[("true", true), ("false", false)]).unwrap_or(true);
    query.finish()?;
    let id = job_id(&id)?;
    let document = state.service.result_part(&tenant(), id, ArtifactKind::Result).await?;
    // Results never change, so the address of the blob is the validator.
    let form = if with_correspondences { "full" } else { "brief" };
    let etag = format!("\"{}-{form}\"", &document.key.hash()[..32]);
    if is_fresh(&headers, &etag) {
        return Ok(not_modified(&etag));
    }
    // Stored JSON objects are joined as they are: numbers come out to the digit as they were written.
    let stored = state.service.read(&document).await?;
    let mut body = stored.strip_suffix(b"}").ok_or_else(unreadable)?.to_vec();
    if with_correspondences {
        let part = state.service.result_part(&tenant(), id, ArtifactKind::Correspondences).await?;
        body.extend_from_slice(b",\"correspondences\":");
        body.extend_from_slice(&state.service.read(&part).await?);
    }
    body.extend_from_slice(b",\"links\":");
    body.extend(serde_json::to_vec(&ResultLinks::of(id)).map_err(|e| Problem::internal(&e))?);
    body.push(b'}');
    Ok(respond(&headers, &etag, "application/json", body))
}

/// Read the dense correspondence
///
/// JSON in columns, or CSV with `?format=csv` or `Accept: text/csv`.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/correspondences", tag = "results", operation_id = "get_correspondences",
    params(
        ("id" = String, Path, description = "The job"),
        ("format" = Option<String>, Query, description = "`json` or `csv`; goes before `Accept`"),
        ("If-None-Match" = Option<String>, Header, description = "The ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The correspondence", content((Correspondences = "application/json"), (String = "text/csv")), headers(("ETag" = String))),
        (status = 304, description = "Unchanged"),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "Not finished, or ended without a result", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn correspondences(
    State(state): State<HttpState>,
    Path(id): Path<String>,
    headers: HeaderMap,
    mut query: QueryString,
) -> Result<Response, Problem> {
    // The first type listed is the one preferred by every client that lists more than one.
    let accept = headers.get(header::ACCEPT).and_then(|v| v.to_str().ok()).unwrap_or_default();
    let accepts_csv = accept.split([',', ';']).next().is_some_and(|first| first.trim() == "text/csv");
    let as_csv = query.word("format", &[("json", false), ("csv", true)]).unwrap_or(accepts_csv);
    query.finish()?;
    let part = state.service.result_part(&tenant(), job_id(&id)?, ArtifactKind::Correspondences).await?;
    let etag = format!("\"{}-{}\"", &part.key.hash()[..32], if as_csv { "csv" } else { "json" });
    if is_fresh(&headers, &etag) {
        return Ok(not_modified(&etag));
    }
    let stored = state.service.read(&part).await?;
    let mut response = if as_csv {
        let columns: Correspondences = serde_json::from_slice(&stored).map_err(|e| Problem::internal(&e))?;
        respond(&headers, &etag, "text/csv; charset=utf-8; header=present", columns.to_csv())
    } else {
        respond(&headers, &etag, "application/json", stored)
    };
    response.headers_mut().insert(header::VARY, header::HeaderValue::from_static("accept"));
    Ok(response)
}

fn unreadable() -> Problem {
    Problem::internal(&JobError::Corrupt { what: "a stored result", source: None })
}
