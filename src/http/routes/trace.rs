//! `/v1/jobs/{id}/trace`: the energy trace, live.

use super::job_id;
use crate::http::auth::Reader;
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::wire::TraceDocument;
use axum::Json;
use axum::extract::{Path, State};

const DEFAULT_POINTS: u32 = 1000;
const MAX_POINTS: u32 = 10_000;

/// Read the energy trace
///
/// Points in order, each once. Hand `next_after_seq` back as `after_seq` until `complete`.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/trace", tag = "jobs", operation_id = "get_trace",
    params(
        ("id" = String, Path, description = "The job"),
        ("after_seq" = Option<u64>, Query, description = "Only points after this one"),
        ("limit" = Option<u32>, Query, minimum = 1, maximum = 10000, description = "Most points; 1000 if absent"),
    ),
    responses(
        (status = 200, description = "Points", body = TraceDocument),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn trace(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path(id): Path<String>,
    mut query: QueryString,
) -> Result<Json<TraceDocument>, Problem> {
    let after_seq = query.number("after_seq", 0..=u64::MAX).unwrap_or(0);
    let limit = query.number("limit", 1..=MAX_POINTS).unwrap_or(DEFAULT_POINTS);
    query.finish()?;
    let page = state.service.trace(&tenant, job_id(&id)?, after_seq, limit).await?;
    Ok(Json(page.into()))
}
