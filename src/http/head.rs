//! Limits on the head of a request, answered with a problem document.
//!
//! hyper enforces its own limits before any service sees the request: a request line that is not HTTP, more than 100
//! headers, a target of more than 65,534 bytes. Those answers have a status and no body, and the connection is closed.

use super::problem::Problem;
use super::problem_table::ProblemKind;
use axum::extract::Request;
use axum::http::HeaderMap;
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// Longest path with its query, bytes: filters, cursors and tickets together take less.
const MAX_TARGET_BYTES: usize = 16 << 10;
/// Most bytes of all names and values of headers: a token of OpenID Connect with many claims takes a quarter.
const MAX_HEADER_BYTES: usize = 64 << 10;

/// Refuses requests whose target or headers are too long, before any other check.
pub(super) async fn check_head(request: Request, next: Next) -> Response {
    let target = request.uri().path_and_query().map_or(0, |target| target.as_str().len());
    if target > MAX_TARGET_BYTES {
        return too_long(ProblemKind::TargetTooLong, MAX_TARGET_BYTES);
    }
    if header_bytes(request.headers()) > MAX_HEADER_BYTES {
        return too_long(ProblemKind::HeadersTooLarge, MAX_HEADER_BYTES);
    }
    next.run(request).await
}

fn header_bytes(headers: &HeaderMap) -> usize {
    headers.iter().map(|(name, value)| name.as_str().len() + value.len()).sum()
}

fn too_long(kind: ProblemKind, limit: usize) -> Response {
    Problem::new(kind)
        .detail(format!("at most {limit} bytes are accepted"))
        .member("limit_bytes", limit.into())
        .into_response()
}
