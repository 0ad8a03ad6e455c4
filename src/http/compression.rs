//! Selects the answers that are compressed for clients that accept it, and sets their headers (RFC 9110, sections
//! 8.8.3, 12.5.5 and 14).
//!
//! A range is never compressed: it is a range of the uncompressed bytes, under their ETag. The ETag of a compressed
//! answer is weak, so that no client joins ranges to it.

use axum::extract::Request;
use axum::http::{HeaderValue, header};
use axum::middleware::Next;
use axum::response::Response;

/// Whether compression makes an answer smaller, where its media type does not tell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gains(pub(super) bool);

/// Binary formats whose numbers are not compressed already; Parquet, npz and zip compress their own.
const BINARY: [&str; 8] = [
    "application/dicom",
    "application/vnd.apache.arrow.file",
    "application/vnd.vtk.vtp",
    "application/x-npy",
    "model/gltf-binary",
    "model/ply",
    "model/stl",
    "model/vtk",
];

/// Whether compression makes an answer of this `Content-Type` smaller. Events are excluded, because compression would
/// hold each back until the next.
pub(super) fn gains(content_type: &str) -> bool {
    let media_type = content_type.split(';').next().unwrap_or_default().trim();
    let is_text = media_type.starts_with("text/") || media_type.ends_with("json") || media_type.ends_with("+xml");
    (is_text && media_type != "text/event-stream") || BINARY.contains(&media_type)
}

/// Weakens the ETag of an answer that was compressed on the way, and the ETag that confirms a client's compressed copy:
/// a strong ETag names the uncompressed bytes. Tells caches that other clients may get another answer; also in an
/// answer without content and in a range.
pub(super) async fn mark(request: Request, next: Next) -> Response {
    let known: Vec<HeaderValue> = request.headers().get_all(header::IF_NONE_MATCH).iter().cloned().collect();
    let mut response = next.run(request).await;
    let Some(etag) = response.headers().get(header::ETAG).and_then(|etag| etag.to_str().ok()) else { return response };
    let weak = format!("W/{}", etag.trim_start_matches("W/"));
    let is_compressed = response.headers().contains_key(header::CONTENT_ENCODING);
    if (is_compressed || known.iter().any(|list| names(list, &weak)))
        && let Ok(weak) = HeaderValue::from_str(&weak)
    {
        response.headers_mut().insert(header::ETAG, weak);
    }
    let varies = response.headers().get_all(header::VARY).iter().any(|list| names(list, "accept-encoding"));
    if !varies {
        response.headers_mut().append(header::VARY, HeaderValue::from_static("accept-encoding"));
    }
    response
}

/// Whether an element of a list in a header is `name`.
fn names(list: &HeaderValue, name: &str) -> bool {
    list.to_str().is_ok_and(|list| list.split(',').any(|element| element.trim().eq_ignore_ascii_case(name)))
}
