//! `/v1/changes`: the feed of state changes.

use crate::http::auth::Reader;
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::wire::ChangesDocument;
use axum::Json;
use axum::extract::State;

const DEFAULT_CHANGES: u32 = 500;
const MAX_CHANGES: u32 = 5_000;

/// Read state changes
///
/// All changes of the tenant's jobs after number `since`, in order: a platform that was away catches up by handing
/// `next_since` back until `more` is false. No change appears later with a smaller number.
#[utoipa::path(
    get, path = "/v1/changes", tag = "jobs", operation_id = "list_changes",
    params(
        ("since" = Option<u64>, Query, description = "Only changes after this number; 0 if absent"),
        ("limit" = Option<u32>, Query, minimum = 1, maximum = 5000, description = "Most changes; 500 if absent"),
    ),
    responses(
        (status = 200, description = "Changes", body = ChangesDocument),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn list(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    mut query: QueryString,
) -> Result<Json<ChangesDocument>, Problem> {
    let since = query.number("since", 0..=i64::MAX.unsigned_abs()).unwrap_or(0);
    let limit = query.number("limit", 1..=MAX_CHANGES).unwrap_or(DEFAULT_CHANGES);
    query.finish()?;
    Ok(Json(ChangesDocument::from(&state.service.changes(&tenant, since, limit).await?)))
}
