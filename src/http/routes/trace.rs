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

/// Get the energy trace
///
/// The points in order, also while the job runs. Pass `next_after_seq` as `after_seq` until `complete` is true.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/trace", tag = "jobs", operation_id = "get_trace",
    params(
        ("id" = String, Path, description = "The job"),
        ("after_seq" = Option<u64>, Query, description = "Only points after the one with this `seq`; 0 if absent"),
        ("limit" = Option<u32>, Query, minimum = 1, maximum = 10000, description = "Maximum number of points; 1000 if absent"),
    ),
    responses(
        (status = 200, description = "Points", body = TraceDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such job", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn trace(
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
