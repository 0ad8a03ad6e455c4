//! Entry points of coverage-guided fuzzing (`make fuzz PART=json` and so on), which accept any bytes: JSON, multipart
//! forms, headers, queries with their cursors, and bearer tokens, as the handlers read them. None may panic, take long,
//! or answer with more than a short refusal.
//!
//! A test reads the inputs that are kept in `fuzz/kept`.

use super::accept::preferred;
use super::conditional::{etag_of, is_fresh};
use super::content::{Stored, Wanted};
use super::cors::CorsOrigins;
use super::hosts::AllowedHosts;
use super::pace::LeastRate;
use super::preferences::{idempotency_key, trace_id, traceparent, wanted_wait};
use super::problem::Problem;
use super::query::QueryString;
use super::request_id::accepted_id;
use super::routes::{batches, events, jobs, keys, meshes, webhooks};
use super::state::HttpLimits;
use super::strict_json::parse;
use super::submission::{self, SubmissionDocument};
use super::tokens::{KeySetSource, TokenSettings, Tokens};
use super::upload::LimitedBody;
use crate::jobs::job::Cursor;
use crate::jobs::{Retentions, SecretKey, SubmissionLimits};
use axum::body::Body;
use axum::extract::FromRequestParts as _;
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, Request, Uri};
use axum::response::IntoResponse as _;
use futures_util::stream;
use serde::de::IgnoredAny;
use std::future::Future;
use std::sync::OnceLock;
use std::time::Duration;
use tokio::runtime::Runtime;

/// Longest refusal, bytes.
const MOST: usize = 16 << 10;

/// Runs a future that needs no runtime.
fn at_once<T>(work: impl Future<Output = T>) -> T {
    static RUNTIME: OnceLock<Option<Runtime>> = OnceLock::new();
    let runtime = RUNTIME.get_or_init(|| tokio::runtime::Builder::new_current_thread().enable_time().build().ok());
    runtime
        .as_ref()
        .map(|runtime| runtime.block_on(work))
        .unwrap_or_else(|| unreachable!("a runtime without a network"))
}

/// A refusal is the client's fault, and short.
fn check(problem: Problem) {
    let response = problem.into_response();
    assert!(response.status().is_client_error(), "{}", response.status());
    let body = at_once(axum::body::to_bytes(response.into_body(), usize::MAX)).unwrap_or_default();
    assert!(body.len() < MOST, "{} bytes", body.len());
    assert!(serde_json::from_slice::<IgnoredAny>(&body).is_ok());
}

fn limits() -> HttpLimits {
    let while_it_lasts = Duration::from_secs(60);
    HttpLimits {
        max_file_bytes: 32 << 10,
        max_json_bytes: 64 << 10,
        max_parameters_bytes: 4 << 10,
        max_batch: 10,
        max_uploads: 1,
        max_body_memory_bytes: 1 << 20,
        max_answer_memory_bytes: 1 << 20,
        least_rate: LeastRate { bytes_per_s: 1, patience: while_it_lasts },
        max_streams: 1,
        access_interval: while_it_lasts,
        max_upload_wait: while_it_lasts,
        upload_timeout: while_it_lasts,
        request_timeout: while_it_lasts,
        allow_private_webhooks: false,
        audit_required: false,
        max_request_rate: 0,
    }
}

/// A JSON body, read as each of the accepted documents.
pub fn json(bytes: &[u8]) {
    let most = limits().max_parameters_bytes;
    let is_json = serde_json::from_slice::<IgnoredAny>(bytes).is_ok();
    let refusals = [
        parse::<SubmissionDocument>(bytes, most, 10).err(),
        parse::<batches::BatchSubmissionDocument>(bytes, most, 10).err(),
        parse::<keys::NewKeyDocument>(bytes, most, 10).err(),
        parse::<webhooks::NewWebhookDocument>(bytes, most, 10).err(),
        parse::<webhooks::WebhookChangeDocument>(bytes, most, 10).err(),
    ];
    for refusal in refusals {
        match refusal {
            Some(problem) => check(problem),
            None => assert!(is_json, "what is accepted is JSON"),
        }
    }
}

/// A submission: a line with its media type, then its body, which arrives in parts of the length of that line.
pub fn form(bytes: &[u8]) {
    let end = bytes.iter().position(|b| *b == b'\n').unwrap_or(bytes.len());
    let (line, body) = (&bytes[..end], bytes.get(end + 1..).unwrap_or_default());
    let Ok(media_type) = HeaderValue::from_bytes(line) else { return };
    let parts: Vec<_> = body.chunks(end.max(1)).map(|part| Ok::<_, std::io::Error>(part.to_vec())).collect();
    let Ok(request) =
        Request::builder().header("content-type", media_type).body(Body::from_stream(stream::iter(parts)))
    else {
        return;
    };
    let limits = limits();
    let accepted = SubmissionLimits {
        max_queued: 1,
        max_checks: 1,
        max_check_wait: Duration::ZERO,
        max_attempts: 1,
        max_batch: 10,
        once_for: Duration::ZERO,
        retention: Retentions::default(),
        max_run: Duration::from_secs(60),
        max_stored_bytes: None,
        cores: 1,
    };
    let read = at_once(async {
        let (request, tap) = LimitedBody::on(request, limits.max_body_bytes());
        tap.settle(submission::read(request, &tap, &limits, &accepted)).await
    });
    if let Err(problem) = read {
        check(problem);
    }
}

/// The headers that handlers parse, one a line: a letter that chooses the name, then the value.
pub fn headers(bytes: &[u8]) {
    const NAMES: [&str; 12] = [
        "accept",
        "if-none-match",
        "if-range",
        "range",
        "prefer",
        "idempotency-key",
        "traceparent",
        "x-request-id",
        "last-event-id",
        "host",
        "origin",
        "content-type",
    ];
    let mut headers = HeaderMap::new();
    for line in bytes.split(|b| *b == b'\n').take(32) {
        let Some((choice, value)) = line.split_first() else { continue };
        if let Ok(value) = HeaderValue::from_bytes(value) {
            headers.append(HeaderName::from_static(NAMES[usize::from(*choice) % NAMES.len()]), value);
        }
    }
    let offered = ["application/json", "text/csv", "model/ply"];
    assert!(preferred(&headers, &offered).is_none_or(|index| index < offered.len()));
    let etag = etag_of(b"content");
    let fresh = is_fresh(&headers, &etag);
    for n_bytes in [0, 1, 1000, u64::MAX] {
        let stored = Stored { etag: &etag, content_type: "application/octet-stream", n_bytes };
        if let Wanted::Content { range: Some(range), .. } = stored.wanted(&Method::GET, &headers) {
            assert!(!fresh && range.start < range.end && range.end <= n_bytes, "{range:?} of {n_bytes}");
        }
    }
    assert!(wanted_wait(&headers, 30).is_none_or(|wait| wait <= Duration::from_secs(30)));
    if let Err(problem) = idempotency_key(&headers) {
        check(problem);
    }
    assert!(traceparent(&headers).is_none_or(|context| trace_id(&context).is_some_and(|id| id.len() == 32)));
    let id = accepted_id(&headers);
    assert!((1..=128).contains(&id.len()) && id.bytes().all(|b| b.is_ascii_graphic()));
    if let Some(text) = headers.get("last-event-id").and_then(|value| value.to_str().ok()) {
        let _ = events::parse_id(text);
    }
    let _ = AllowedHosts::new(["imaging.example".to_owned()]).allow(
        &Uri::from_static("/v1/jobs"),
        &headers,
        &CorsOrigins::default(),
    );
}

/// A query string, as of a list of jobs: filters, and a cursor.
pub fn query(bytes: &[u8]) {
    let Ok(uri) = Uri::try_from([b"/v1/jobs?", bytes].concat()) else { return };
    let mut parts = Request::new(()).into_parts().0;
    parts.uri = uri;
    let mut query = match at_once(QueryString::from_request_parts(&mut parts, &())) {
        Ok(query) => query,
        Err(problem) => return check(problem),
    };
    let _ = jobs::filter(&mut query);
    let _ = query.number("page_size", 1..=500);
    if let Some(token) = query.text("page_token") {
        // An accepted cursor must be one that this service could have issued.
        assert!(Cursor::from_token(&token).is_none_or(|cursor| cursor.to_token() == token), "{token}");
        assert!(meshes::cursor(&token).is_none_or(|(time, hash)| meshes::token_of(time, &hash) == token), "{token}");
        assert!(keys::cursor(&token).is_none_or(|(time, id)| keys::token_of(time, &id) == token), "{token}");
    }
    if let Err(problem) = query.finish() {
        check(problem);
    }
}

/// The text after `Bearer`: never accepted, because nobody has the private part of the key.
pub fn token(bytes: &[u8]) {
    static TOKENS: OnceLock<Option<Tokens>> = OnceLock::new();
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Some(key) = SecretKey::parse(text) {
        assert!(SecretKey::is_id(key.id()));
    }
    let tokens = TOKENS.get_or_init(|| {
        let path = std::env::temp_dir().join(format!("homolog-fuzzed-{}.json", std::process::id()));
        std::fs::write(&path, include_str!("../../fuzz/kept/keys.json")).ok()?;
        Tokens::open(TokenSettings {
            issuer: "https://idp.example.org".to_owned(),
            audience: "homolog".to_owned(),
            key_set: KeySetSource::File(path),
            role_claim: "roles".to_owned(),
            tenant_claim: None,
            leeway: Duration::ZERO,
        })
        .ok()
    });
    if let Some(tokens) = tokens {
        assert!(at_once(tokens.verify(text)).is_err(), "a forged token is accepted");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn kept_inputs_are_read_without_a_panic() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/kept");
        type Target = (&'static str, fn(&[u8]));
        let targets: [Target; 5] =
            [("json", json), ("form", form), ("headers", headers), ("query", query), ("token", token)];
        for (name, read) in targets {
            let mut n = 0;
            for entry in std::fs::read_dir(folder.join(name)).unwrap() {
                let path = entry.unwrap().path();
                println!("{}", path.display());
                let bytes = std::fs::read(&path).unwrap();
                read(&bytes);
                // Every prefix is an input too, as if the connection had ended there.
                let step = (bytes.len() / 64).max(1);
                (0..bytes.len()).step_by(step).for_each(|end| read(&bytes[..end]));
                n += 1;
            }
            assert!(n >= 3, "{name}");
        }
    }

    #[test]
    fn a_cursor_has_one_form() {
        let cursor = Cursor { created_at_ms: 1_795_238_118_123, id: crate::jobs::JobId::new() };
        let token = cursor.to_token();
        assert_eq!(Cursor::from_token(&token), Some(cursor));
        for other in [format!("-{token}"), format!("+{token}"), format!("0{token}"), token.to_uppercase()] {
            assert_eq!(Cursor::from_token(&other), None, "{other}");
        }
    }
}
