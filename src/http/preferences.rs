//! The request headers `Prefer`, `Idempotency-Key` and `traceparent`.

use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use axum::http::{HeaderMap, HeaderName, HeaderValue};
use axum::response::Response;
use std::time::Duration;

const PREFER: HeaderName = HeaderName::from_static("prefer");
const IDEMPOTENCY_KEY: HeaderName = HeaderName::from_static("idempotency-key");
pub(super) const TRACEPARENT: HeaderName = HeaderName::from_static("traceparent");
const MAX_KEY: usize = 128;

/// How long the client prefers to wait (RFC 7240), at most `most_s` seconds. An unreadable preference is ignored.
pub(super) fn wanted_wait(headers: &HeaderMap, most_s: u32) -> Option<Duration> {
    let preferences = headers.get_all(PREFER).iter().filter_map(|value| value.to_str().ok());
    preferences.flat_map(|value| value.split(',')).find_map(|preference| {
        let (name, value) = preference.split_once('=')?;
        let seconds: u32 = name.trim().eq_ignore_ascii_case("wait").then(|| value.trim().parse().ok())??;
        Some(Duration::from_secs(seconds.min(most_s).into()))
    })
}

/// The client's idempotency key.
///
/// # Errors
/// `bad-request` for a key that is empty, too long or not of visible ASCII characters, and for more than one key.
pub(super) fn idempotency_key(headers: &HeaderMap) -> Result<Option<String>, Problem> {
    let mut values = headers.get_all(IDEMPOTENCY_KEY).iter();
    let Some(value) = values.next() else { return Ok(None) };
    let key = value.to_str().unwrap_or("").trim().trim_matches('"');
    let is_right = (1..=MAX_KEY).contains(&key.len()) && key.bytes().all(|b| b.is_ascii_graphic());
    if !is_right || values.next().is_some() {
        let detail = "must be one key of 1 to 128 visible ASCII characters";
        let error = FieldError::new("/headers/idempotency-key", "out_of_range", detail);
        return Err(Problem::new(ProblemKind::BadRequest).detail(detail).errors(&[error]));
    }
    Ok(Some(key.to_owned()))
}

/// The answer, marked with `Idempotency-Replayed` if an earlier request with the same key created the resource.
pub(super) fn marked(mut response: Response, replayed: bool) -> Response {
    if replayed {
        response.headers_mut().insert("idempotency-replayed", HeaderValue::from_static("true"));
    }
    response
}

/// The W3C trace context, if it is valid.
pub(super) fn traceparent(headers: &HeaderMap) -> Option<String> {
    let value = headers.get(TRACEPARENT)?.to_str().ok()?;
    trace_id(value).map(|_| value.to_owned())
}

/// The trace id of a valid `traceparent`.
pub(super) fn trace_id(value: &str) -> Option<&str> {
    let mut parts = value.split('-');
    let (version, trace, parent, flags) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    let hex = |text: &str, length| text.len() == length && text.bytes().all(|b| b.is_ascii_hexdigit());
    let whole = hex(version, 2) && hex(trace, 32) && hex(parent, 16) && hex(flags, 2) && parts.next().is_none();
    whole.then_some(trace)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(name: HeaderName, value: &'static str) -> HeaderMap {
        HeaderMap::from_iter([(name, HeaderValue::from_static(value))])
    }

    #[test]
    fn preferences_are_read() {
        let wait = |value| wanted_wait(&with(PREFER, value), 30).map(|wait| wait.as_secs());
        assert_eq!(wait("wait=5"), Some(5));
        assert_eq!(wait("respond-async, Wait = 100"), Some(30));
        assert_eq!(wait("wait=-1"), None);
        assert_eq!(wait("respond-async"), None);
        assert_eq!(wanted_wait(&HeaderMap::new(), 30), None);
    }

    #[test]
    fn keys_are_checked() {
        let key = |value| idempotency_key(&with(IDEMPOTENCY_KEY, value));
        assert_eq!(key("\"8e03978e\"").unwrap().as_deref(), Some("8e03978e"));
        assert!(key("").is_err());
        assert!(key("two words").is_err());
        assert_eq!(idempotency_key(&HeaderMap::new()).unwrap(), None);
    }

    #[test]
    fn only_whole_trace_contexts_are_kept() {
        let whole = "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01";
        assert_eq!(traceparent(&with(TRACEPARENT, whole)).as_deref(), Some(whole));
        assert_eq!(trace_id(whole), Some("0af7651916cd43dd8448eb211c80319c"));
        assert_eq!(traceparent(&with(TRACEPARENT, "00-0af7-b7ad-01")), None);
    }
}
