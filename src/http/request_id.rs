//! The id of a request: its header, its form, and the one of the request that is being answered.

use axum::http::{HeaderMap, HeaderName};

/// The header that carries the id of a request.
pub(super) const REQUEST_ID: HeaderName = HeaderName::from_static("x-request-id");

tokio::task_local! {
    /// The id of the request that a task answers.
    pub(super) static CURRENT: String;
}

/// The id of the request that is being answered.
pub(super) fn request_id() -> Option<String> {
    CURRENT.try_with(Clone::clone).ok()
}

/// The client's id for its request if it is harmless in a log, else a new one.
pub(super) fn accepted_id(headers: &HeaderMap) -> String {
    let offered = headers.get(REQUEST_ID).and_then(|v| v.to_str().ok()).filter(|id| {
        (1..=128).contains(&id.len()) && id.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_.:".contains(&b))
    });
    offered.map_or_else(|| uuid::Uuid::now_v7().to_string(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

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
