//! The check of the host that a request names.
//!
//! The paths of probes are not checked: supervisors name the service by any address and learn only that it is alive.

use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::state::HttpState;
use axum::extract::{Request, State};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// Paths that any host may name.
const PROBES: [&str; 2] = ["/healthz", "/readyz"];

/// Refuses requests that name another host, before any other check.
pub(super) async fn check_host(State(state): State<HttpState>, request: Request, next: Next) -> Response {
    match &state.hosts {
        Some(hosts)
            if !PROBES.contains(&request.uri().path())
                && !hosts.allow(request.uri(), request.headers(), &state.cors) =>
        {
            Problem::new(ProblemKind::HostNotAllowed).into_response()
        }
        _ => next.run(request).await,
    }
}
