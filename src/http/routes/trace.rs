//! `/v1/jobs/{id}/trace`: the energy trace, live.

use crate::http::call::AuthorizedRequest;
use crate::http::problem::Problem;
use crate::http::wire::TraceDocument;
use axum::Json;

const DEFAULT_POINTS: u32 = 1000;
const MAX_POINTS: u32 = 10_000;

/// Get the energy trace
///
/// The points in order, also while the job runs. Pass `next_after_seq` as `after_seq` until `complete` is true.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/trace",
    params(
        ("after_seq" = Option<u64>, Query, description = "Only points after the one with this `seq`; 0 if absent"),
        ("limit" = Option<u32>, Query, minimum = 1, maximum = 10000, description = "Maximum number of points; 1000 if absent"),
    ),
    responses((status = 200, description = "Points", body = TraceDocument))
)]
pub(crate) async fn trace(mut call: AuthorizedRequest) -> Result<Json<TraceDocument>, Problem> {
    let after_seq = call.query.number("after_seq", 0..=u64::MAX).unwrap_or(0);
    let limit = call.query.number("limit", 1..=MAX_POINTS).unwrap_or(DEFAULT_POINTS);
    call.query.finish()?;
    let page = call.service().trace(&call.tenant, call.id()?, after_seq, limit).await?;
    Ok(Json(page.into()))
}
