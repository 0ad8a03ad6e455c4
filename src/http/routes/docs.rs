//! `/docs`: the OpenAPI document as an interactive page that loads nothing from the internet.

use crate::http::conditional::{etag_of, respond};
use crate::http::problem::Problem;
use crate::http::problem_table::ProblemKind;
use axum::extract::Path;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::sync::{Arc, LazyLock};
use utoipa_swagger_ui::Config;

/// Nothing is loaded from or sent to another origin, not even by an injected script.
const POLICY: HeaderValue = HeaderValue::from_static(
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; \
     connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
);

static CONFIG: LazyLock<Arc<Config<'static>>> = LazyLock::new(|| {
    let config = Config::from("/openapi.json");
    // The badge of a public validator would reveal the address of this service to it.
    Arc::new(config.use_base_layout().validator_url("none").deep_linking(true).display_request_duration(true))
});

/// Redirects to the page, whose files are named relative to `/docs/`.
pub(crate) async fn leave() -> Response {
    (StatusCode::PERMANENT_REDIRECT, [(header::LOCATION, "/docs/")]).into_response()
}

/// The page.
pub(crate) async fn page(headers: HeaderMap) -> Result<Response, Problem> {
    file("index.html", &headers)
}

/// A file of the page.
pub(crate) async fn asset(Path(path): Path<String>, headers: HeaderMap) -> Result<Response, Problem> {
    file(&path, &headers)
}

fn file(path: &str, headers: &HeaderMap) -> Result<Response, Problem> {
    let found = utoipa_swagger_ui::serve(path, Arc::clone(&CONFIG));
    // The library's error only says that a template is not text, which would be a fault of the build.
    let found = found.map_err(|_| Problem::new(ProblemKind::InternalError))?;
    let file = found.ok_or_else(|| Problem::new(ProblemKind::RouteNotFound))?;
    let content_type = match path.rsplit_once('.').map(|(_, ending)| ending) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("png") => "image/png",
        _ => "application/octet-stream",
    };
    let bytes = file.bytes.into_owned();
    let mut response = respond(headers, &etag_of(&bytes), content_type, bytes);
    response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, POLICY);
    response.headers_mut().insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    Ok(response)
}
