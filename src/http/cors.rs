//! The origins whose web pages may use the service.
//!
//! Cross-origin requests are refused unless the operator lists the origin (`--cors-origin`); browsers then let its
//! pages call this service and read the answers. Cookies are never used, so pages authenticate with keys or tickets, as
//! other clients do.

use super::request_id::REQUEST_ID;
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, Uri, header};
use std::time::Duration;
use tower_http::cors::{AllowOrigin, CorsLayer};

/// How long a browser may keep the answer to a preflight request.
const PREFLIGHT_LASTS: Duration = Duration::from_secs(3600);

/// Origins whose pages may use the service.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CorsOrigins(Vec<HeaderValue>);

impl CorsOrigins {
    /// Checks an origin as browsers write it: `https://viewer.example` or `http://localhost:3000`, without a path.
    ///
    /// # Errors
    /// The fault of the origin.
    pub fn check(text: &str) -> Result<String, String> {
        let fault = || {
            "an origin such as https://viewer.example or http://localhost:3000 is needed here, without a path"
                .to_owned()
        };
        let uri: Uri = text.parse().map_err(|_| fault())?;
        let is_web = matches!(uri.scheme_str(), Some("http" | "https"));
        let authority = uri.authority().map(|authority| authority.as_str()).unwrap_or_default();
        // Browsers compare origins byte by byte.
        let written = format!("{}://{authority}", uri.scheme_str().unwrap_or_default()).to_ascii_lowercase();
        if is_web && !authority.is_empty() && !authority.contains('@') && written == text {
            Ok(written)
        } else {
            Err(fault())
        }
    }

    /// These origins, which [`CorsOrigins::check`] has accepted.
    pub fn new(origins: &[String]) -> Self {
        CorsOrigins(origins.iter().filter_map(|origin| HeaderValue::from_str(origin).ok()).collect())
    }

    /// Whether every `Origin` of a request is listed; not for requests without one.
    pub(super) fn allow(&self, headers: &HeaderMap) -> bool {
        headers.contains_key(header::ORIGIN) && headers.get_all(header::ORIGIN).iter().all(|o| self.0.contains(o))
    }

    /// Answers preflight requests, and permits pages of the origins to read answers; `None` if no origin is listed.
    pub(super) fn layer(&self) -> Option<CorsLayer> {
        let sent = [
            header::AUTHORIZATION,
            header::CONTENT_TYPE,
            header::IF_NONE_MATCH,
            header::RANGE,
            REQUEST_ID,
            HeaderName::from_static("idempotency-key"),
            HeaderName::from_static("last-event-id"),
            HeaderName::from_static("prefer"),
            HeaderName::from_static("traceparent"),
        ];
        let read = [
            header::ACCEPT_RANGES,
            header::ALLOW,
            header::CONTENT_DISPOSITION,
            header::CONTENT_LOCATION,
            header::CONTENT_RANGE,
            header::ETAG,
            header::LOCATION,
            header::RETRY_AFTER,
            REQUEST_ID,
            HeaderName::from_static("idempotency-replayed"),
            HeaderName::from_static("preference-applied"),
        ];
        let layer = || {
            CorsLayer::new()
                .allow_origin(AllowOrigin::list(self.0.iter().cloned()))
                .allow_methods([Method::GET, Method::HEAD, Method::POST, Method::PUT, Method::PATCH, Method::DELETE])
                .allow_headers(sent)
                .expose_headers(read)
                .max_age(PREFLIGHT_LASTS)
        };
        (!self.0.is_empty()).then(layer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn origins_are_those_that_browsers_send() {
        for origin in ["https://viewer.example", "http://localhost:3000", "http://[::1]:8080"] {
            assert_eq!(CorsOrigins::check(origin), Ok(origin.to_owned()));
        }
        for other in [
            "*",
            "null",
            "",
            "viewer.example",
            "https://viewer.example/",
            "https://Viewer.example",
            "https://viewer.example/page",
            "ftp://viewer.example",
            "https://user@viewer.example",
            "https://",
        ] {
            assert!(CorsOrigins::check(other).is_err(), "{other}");
        }
    }

    #[test]
    fn only_listed_origins_are_allowed() {
        let origins = CorsOrigins::new(&["https://viewer.example".to_owned()]);
        let allows = |sent: &[&'static str]| {
            let mut headers = HeaderMap::new();
            sent.iter().for_each(|origin| {
                headers.append(header::ORIGIN, HeaderValue::from_static(origin));
            });
            origins.allow(&headers)
        };
        assert!(allows(&["https://viewer.example"]));
        for sent in [&[][..], &["https://evil.example"], &["null"], &["https://viewer.example", "https://evil.example"]]
        {
            assert!(!allows(sent), "{sent:?}");
        }
        assert!(CorsOrigins::default().layer().is_none());
    }
}
