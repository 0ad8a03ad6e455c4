//! `ETag` and `If-None-Match`.

use axum::body::Body;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};

/// The strong ETag of a body.
pub(super) fn etag_of(body: &[u8]) -> String {
    format!("\"{}\"", &blake3::hash(body).to_hex()[..32])
}

/// Whether `If-None-Match` names `etag`.
pub(super) fn is_fresh(headers: &HeaderMap, etag: &str) -> bool {
    headers.get_all(header::IF_NONE_MATCH).iter().filter_map(|v| v.to_str().ok()).any(|list| {
        // Weak comparison (RFC 9110, section 13.1.2): a proxy may have weakened the ETag.
        list.split(',').map(str::trim).any(|tag| tag == "*" || tag.trim_start_matches("W/") == etag)
    })
}

/// 304 with the ETag.
pub(super) fn not_modified(etag: &str) -> Response {
    with_etag(StatusCode::NOT_MODIFIED.into_response(), etag)
}

/// 200 with the body, or 304 if the client has it.
pub(super) fn respond(headers: &HeaderMap, etag: &str, content_type: &'static str, body: impl Into<Body>) -> Response {
    if is_fresh(headers, etag) {
        return not_modified(etag);
    }
    let mut response = Response::new(body.into());
    response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(content_type));
    with_etag(response, etag)
}

/// The response with an ETag.
pub(super) fn with_etag(mut response: Response, etag: &str) -> Response {
    if let Ok(value) = HeaderValue::from_str(etag) {
        response.headers_mut().insert(header::ETAG, value);
    }
    // Shared caches must not store answers about patients; private ones revalidate each time.
    response.headers_mut().insert(header::CACHE_CONTROL, HeaderValue::from_static("private, no-cache"));
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn etags_are_compared_weakly_in_lists() {
        let mut headers = HeaderMap::new();
        headers.insert(header::IF_NONE_MATCH, HeaderValue::from_static("\"a\", W/\"b\""));
        assert!(is_fresh(&headers, "\"a\""));
        assert!(is_fresh(&headers, "\"b\""));
        assert!(!is_fresh(&headers, "\"c\""));
    }
}
