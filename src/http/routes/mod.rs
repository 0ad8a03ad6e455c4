//! The handlers, one file for each resource.

pub(crate) mod batches;
pub(crate) mod changes;
pub(crate) mod docs;
pub(crate) mod events;
pub(crate) mod files;
pub(crate) mod jobs;
pub(crate) mod keys;
pub(crate) mod meshes;
pub(crate) mod methods;
pub(crate) mod result;
pub(crate) mod studies;
pub(crate) mod study_scores;
pub(crate) mod study_subjects;
pub(crate) mod surfaces;
pub(crate) mod system;
pub(crate) mod tenant_events;
pub(crate) mod tickets;
pub(crate) mod trace;
pub(crate) mod webhooks;

use super::call::AuthorizedRequest;
use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use super::submission::{ALLOWED_PRIORITIES, PRIORITIES};
use super::upload::LimitedBody;
use axum::Json;
use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;

/// Most faults listed in an answer.
const NAMED_FAULTS: usize = 16;

/// What `take` makes of a request with a body and without a query. After a refusal the rest of the body is read, as far as it
/// is allowed.
async fn taken<T>(
    mut call: AuthorizedRequest,
    request: Request,
    take: impl AsyncFnOnce(&AuthorizedRequest, Request, &LimitedBody) -> Result<T, Problem>,
) -> Result<T, Problem> {
    let (request, tap) = LimitedBody::on(request, call.state.limits.max_body_bytes());
    let read = async {
        call.query.finish()?;
        take(&call, request, &tap).await
    };
    tap.settle(read).await
}

/// 202 with what was accepted, and its place.
fn accepted(place: &str, document: impl Serialize) -> Response {
    let headers = [(header::LOCATION, place), (header::RETRY_AFTER, "1")];
    (StatusCode::ACCEPTED, headers, Json(document)).into_response()
}

/// Refuses a priority that is not allowed.
fn check_priority(priority: i32) -> Result<(), Problem> {
    if PRIORITIES.contains(&priority) {
        return Ok(());
    }
    let fault = FieldError::new("/priority", "out_of_range", ALLOWED_PRIORITIES);
    Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]))
}
