//! The answer to `OPTIONS` on every route: its methods.

use super::cors::CorsOrigins;
use super::state::HttpState;
use axum::extract::{Request, State};
use axum::http::{Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// Answers `OPTIONS` with the methods of the route. If an origin is listed, the layer of [`CorsOrigins`] handles
/// preflight requests of browsers.
pub(super) async fn answer_options(State(state): State<HttpState>, mut request: Request, next: Next) -> Response {
    let is_preflight = state.cors != CorsOrigins::default()
        && request.headers().contains_key(header::ORIGIN)
        && request.headers().contains_key(header::ACCESS_CONTROL_REQUEST_METHOD);
    if request.method() != Method::OPTIONS || is_preflight {
        return next.run(request).await;
    }
    // No route has this method, so the router adds the methods that the route has.
    *request.method_mut() = Method::TRACE;
    let response = next.run(request).await;
    if response.status() != StatusCode::METHOD_NOT_ALLOWED {
        return response;
    }
    let mut answer = StatusCode::NO_CONTENT.into_response();
    answer.headers_mut().extend(response.headers().iter().map(|(name, value)| (name.clone(), value.clone())));
    answer.headers_mut().remove(header::CONTENT_TYPE);
    answer.headers_mut().remove(header::CONTENT_LENGTH);
    answer
}
