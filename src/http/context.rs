//! The outermost layer around every request: request id, log span, metrics, time limit, and a problem document for
//! errors that no handler has answered.

use super::audit::{Caller, Recording};
use super::auth_mode::AuthMode;
use super::operations::Operation;
use super::parts::Part;
use super::preferences::{TRACEPARENT, trace_id, traceparent};
use super::problem::{PROBLEM_JSON, Problem};
use super::problem_table::ProblemKind;
use super::request_id::{CURRENT, REQUEST_ID, accepted_id, request_id};
use super::state::HttpState;
use crate::spans::{Fact, Span};
use axum::extract::{MatchedPath, Request, State};
use axum::http::{HeaderName, HeaderValue, Method, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::time::{Duration, Instant};
use tracing::Instrument;

/// The header that tells the sender of a key that the key was not checked, because none is required.
pub(crate) const AUTHENTICATION: HeaderName = HeaderName::from_static("homolog-authentication");

/// Time that a submission may take in addition to its upload: waiting for an upload slot, draining a refused body,
/// checking and storing two inputs.
const AFTER_UPLOAD: Duration = Duration::from_secs(240);

/// The route of a request that no route matches, in logs and metrics.
const UNMATCHED: &str = "none";

/// Requests of supervisors, which get no spans because they are not part of the clients' work.
const PROBES: [&str; 3] = ["/healthz", "/readyz", "/metrics"];

/// The method as it appears in logs and metrics: a standard one, or `other`. A client can make up any number of methods,
/// and each label value is a time series for as long as the process lives.
fn method_label(method: &Method) -> &'static str {
    const KNOWN: [&str; 7] = ["GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"];
    KNOWN.into_iter().find(|known| *known == method.as_str()).unwrap_or("other")
}

/// The outermost layer: gives the request an id, logs and counts its answer, and turns errors of other layers into problems.
pub(crate) async fn surround(State(state): State<HttpState>, mut request: Request, next: Next) -> Response {
    let id = accepted_id(request.headers());
    let sends_key = request.headers().contains_key(header::AUTHORIZATION);
    let request_id = HeaderValue::from_str(&id).ok();
    let route = request.extensions().get::<MatchedPath>().map(|p| p.as_str().to_owned());
    let method = method_label(request.method());
    let route = route.unwrap_or_else(|| UNMATCHED.to_owned());
    let span = tracing::info_span!(
        "request",
        request_id = %id,
        trace_id = traceparent(request.headers()).as_deref().and_then(trace_id),
        method,
        route,
    );
    let mut sent = Span::default();
    if !PROBES.contains(&route.as_str()) {
        sent = Span::of_request(method, &route, traceparent(request.headers()).as_deref());
    }
    // Everything that is stored or passed on for this request belongs to its span.
    if let Some(context) = sent.traceparent().and_then(|context| HeaderValue::from_str(&context).ok()) {
        request.headers_mut().insert(TRACEPARENT, context);
    }
    let caller = Caller::default();
    request.extensions_mut().insert(caller.clone());
    let recording = Recording::of(&state, &caller, &request, &route);
    let began = Instant::now();
    // The handler limits an upload itself, with a better answer; this limit covers the steps after the upload.
    let takes_files = Operation::of(request.method(), &route).is_some_and(|operation| operation.has(Part::Files));
    let limit = match takes_files {
        true => state.limits.upload_timeout + AFTER_UPLOAD,
        false => state.limits.request_timeout,
    };
    let answer = async {
        let response = match tokio::time::timeout(limit, next.run(request)).await {
            Ok(response) => response,
            Err(_) => Problem::new(ProblemKind::Timeout).retry_after(5).into_response(),
        };
        let mut response = as_problem(response);
        if let Some(recording) = recording {
            response = recording.end(response).await;
        }
        let elapsed_ms = u64::try_from(began.elapsed().as_millis()).unwrap_or(u64::MAX);
        let (tenant, key_id) = (caller.tenant(), caller.key_id());
        tracing::info!(status = response.status().as_u16(), elapsed_ms, tenant, key_id, "answered");
        // Every label comes from a closed set, because requests are counted before they are authenticated: the methods
        // below, the routes of the router, the statuses that the service answers.
        let status = response.status().as_u16().to_string();
        metrics::counter!("homolog_http_requests_total", "method" => method, "route" => route.clone(), "status" => status)
            .increment(1);
        metrics::histogram!("homolog_http_request_seconds", "route" => route).record(began.elapsed().as_secs_f64());
        response
    };
    let mut response = CURRENT.scope(id, answer.instrument(span)).await;
    sent.set("http.response.status_code", Fact::Number(response.status().as_u16().into()));
    if response.status().is_server_error() {
        sent.fail();
    }
    if let Some(value) = request_id {
        response.headers_mut().insert(REQUEST_ID, value);
    }
    if state.auth == AuthMode::None && sends_key {
        response.headers_mut().insert(AUTHENTICATION, HeaderValue::from_static("none"));
    }
    response
}

/// Turns errors that no handler has answered (a path that is not UTF-8, a method that is not allowed) into problems.
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

/// The answer to a request whose handler panicked.
pub(crate) fn panic_problem(_: Box<dyn std::any::Any + Send + 'static>) -> Response {
    // The panic hook has logged the location; the message stays out of log and answer.
    tracing::error!(request_id = request_id(), "a handler panicked");
    Problem::new(ProblemKind::InternalError).into_response()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn made_up_methods_share_one_label() {
        assert_eq!(method_label(&Method::GET), "GET");
        for made_up in ["BREW", "get", "GET1", "PROPFIND", "CONNECT"] {
            assert_eq!(method_label(&Method::from_bytes(made_up.as_bytes()).unwrap()), "other", "{made_up}");
        }
    }
}
