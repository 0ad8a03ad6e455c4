//! The routes and the layers around them.

use super::allowed_methods::answer_options;
use super::compression::{self, Gains};
use super::context::{panic_problem, surround};
use super::handlers::api;
use super::head::check_head;
use super::host_check::check_host;
use super::openapi::openapi_json;
use super::page;
use super::problem::{Problem, begin_to_count};
use super::problem_table::ProblemKind;
use super::routes;
use super::state::HttpState;
use axum::Router;
use axum::extract::DefaultBodyLimit;
use axum::http::{Extensions, HeaderMap, HeaderValue, StatusCode, Version, header};
use axum::routing::get;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::compression::{CompressionLayer, CompressionLevel};

/// The routes of a worker process: health checks and metrics only.
pub fn probe_router(state: HttpState) -> Router {
    Router::new()
        .route("/healthz", get(routes::system::healthz))
        .route("/readyz", get(routes::system::readyz))
        .route("/metrics", get(routes::system::metrics))
        .fallback(|| async { Problem::new(ProblemKind::RouteNotFound) })
        .with_state(state)
}

/// Answers from this size on are compressed for clients that accept it, bytes.
const COMPRESSED_FROM: u64 = 4 << 10;

/// Whether an answer is worth compressing.
fn is_worth_compressing(_: StatusCode, _: Version, headers: &HeaderMap, more: &Extensions) -> bool {
    let header_text = |name| headers.get(name).and_then(|value: &HeaderValue| value.to_str().ok());
    let is_long =
        header_text(header::CONTENT_LENGTH).and_then(|n| n.parse().ok()).is_none_or(|n: u64| n >= COMPRESSED_FROM);
    let gains = || compression::gains(header_text(header::CONTENT_TYPE).unwrap_or_default());
    is_long && more.get().map_or_else(gains, |Gains(gains)| *gains)
}

/// The service as one router.
pub fn router(mut state: HttpState) -> Router {
    begin_to_count();
    state.document = openapi_json;
    let (router, _) = api().split_for_parts();
    router
        .route("/", get(page::index))
        .route("/assets/{name}", get(page::asset))
        .route("/phantoms/{name}", get(page::phantom))
        .route("/docs", get(routes::docs::leave))
        .route("/docs/", get(routes::docs::page))
        .route("/docs/{*path}", get(routes::docs::asset))
        .fallback(|| async { Problem::new(ProblemKind::RouteNotFound) })
        // Innermost first. Body sizes are limited where bodies are read; axum's own limit would not answer with a problem
        // document.
        .layer(DefaultBodyLimit::disable())
        .layer(axum::middleware::from_fn_with_state(state.clone(), check_host))
        .layer(axum::middleware::from_fn(check_head))
        .layer(CatchPanicLayer::custom(panic_problem))
        .layer(CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(is_worth_compressing))
        .layer(axum::middleware::from_fn(compression::mark))
        .layer(tower::util::option_layer(state.cors.layer()))
        .layer(axum::middleware::from_fn_with_state(state.clone(), answer_options))
        .layer(axum::middleware::from_fn_with_state(state.clone(), surround))
        .with_state(state)
}
