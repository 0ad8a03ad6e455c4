//! What surrounds every request: its id, its span, its time limit, and problems where a layer answered none.

use super::preferences::{trace_id, traceparent};
use super::problem::{PROBLEM_JSON, Problem};
use super::problem_table::ProblemKind;
use super::router::HttpState;
use axum::extract::{MatchedPath, Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::time::{Duration, Instant};
use tracing::Instrument;

/// The header that names a request.
pub const REQUEST_ID: HeaderName = HeaderName::from_static("x-request-id");

tokio::task_local! {
    static CURRENT: String;
}

/// The id of the request that is being answered.
pub fn request_id() -> Option<String> {
    CURRENT.try_with(Clone::clone).ok()
}

/// The client's id for its request if it is harmless in a log, else a new one.
fn accepted_id(headers: &HeaderMap) -> String {
    let offered = headers.get(REQUEST_ID).and_then(|v| v.to_str().ok()).filter(|id| {
        (1..=128).contains(&id.len()) && id.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_.:".contains(&b))
    });
    offered.map_or_else(|| uuid::Uuid::now_v7().to_string(), str::to_owned)
}

/// Waiting for a place, draining a refused body, checking and storing two inputs: what a submission may take besides
/// its upload.
const AFTER_UPLOAD: Duration = Duration::from_secs(240);

/// The outermost layer: names the request, logs its answer, and turns errors of other layers into problems.
pub async fn surround(State(state): State<HttpState>, request: Request, next: Next) -> Response {
    let id = accepted_id(request.headers());
    let header = HeaderValue::from_str(&id).ok();
    let route = request.extensions().get::<MatchedPath>().map(|p| p.as_str().to_owned());
    let method = request.method().clone();
    let span = tracing::info_span!(
        "request",
        request_id = %id,
        trace_id = traceparent(request.headers()).as_deref().and_then(trace_id),
        %method,
        route = route.as_deref().unwrap_or("none"),
    );
    let began = Instant::now();
    let limit = match (&method, route.as_deref()) {
        // The handler bounds the upload itself, with a better answer; this is the last resort for what comes after.
        (&Method::POST, Some("/v1/jobs" | "/v1/meshes" | "/v1/batches")) => state.limits.upload_timeout + AFTER_UPLOAD,
        _ => state.limits.request_timeout,
    };
    let answer = async {
        let response = match tokio::time::timeout(limit, next.run(request)).await {
            Ok(response) => response,
            Err(_) => Problem::new(ProblemKind::Timeout).retry_after(5).into_response(),
        };
        let response = as_problem(response);
        let elapsed_ms = began.elapsed().as_millis();
        tracing::info!(status = response.status().as_u16(), elapsed_ms, "answered");
        let labels = [
            ("method", method.as_str().chars().take(16).collect::<String>()),
            ("route", route.clone().unwrap_or_else(|| "none".to_owned())),
            ("status", response.status().as_u16().to_string()),
        ];
        metrics::counter!("homolog_http_requests_total", &labels).increment(1);
        metrics::histogram!("homolog_http_request_seconds", "route" => labels[1].1.clone())
            .record(began.elapsed().as_secs_f64());
        response
    };
    let mut response = CURRENT.scope(id, answer.instrument(span)).await;
    if let Some(value) = header {
        response.headers_mut().insert(REQUEST_ID, value);
    }
    response
}

/// Errors that no handler made (a path that is no UTF-8, a wrong method) as problems too.
fn as_problem(response: Response) -> Response {
    let status = response.status();
    let is_error = status.is_client_error() || status.is_server_error();
    let is_problem = response.headers().get(header::CONTENT_TYPE).is_some_and(|t| t == PROBLEM_JSON);
    if !is_error || is_problem {
        return response;
    }
    let allow = response.headers().get(header::ALLOW).cloned();
    let mut problem = Problem::new(ProblemKind::from_status(status)).into_response();
    if let Some(allow) = allow {
        problem.headers_mut().insert(header::ALLOW, allow);
    }
    problem
}

/// What a panic of a handler is answered.
pub fn panic_problem(_: Box<dyn std::any::Any + Send + 'static>) -> Response {
    // The panic hook has logged where; what it said stays out of log and answer.
    tracing::error!(request_id = request_id(), "a handler panicked");
    Problem::new(ProblemKind::InternalError).into_response()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_harmless_request_ids_are_kept() {
        let with = |value: &'static str| {
            let mut headers = HeaderMap::new();
            headers.insert(REQUEST_ID, HeaderValue::from_static(value));
            accepted_id(&headers)
        };
        assert_eq!(with("abc-1.2:3_x"), "abc-1.2:3_x");
        assert_ne!(with("two words"), "two words");
        assert_ne!(with(""), "");
    }
}
