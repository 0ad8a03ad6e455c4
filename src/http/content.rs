//! Content that should not be held in memory as a whole: streamed from the store, or counted while it is sent; and byte
//! ranges of content (RFC 9110, section 14).

use super::call::AuthorizedRequest;
use super::conditional::{is_fresh, not_modified, respond};
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::shares::SharePermit;
use crate::jobs::{BlobStream, JobError};
use axum::body::{Body, HttpBody};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::response::{IntoResponse, Response};
use bytes::Bytes;
use futures_util::StreamExt;
use http_body::{Frame, SizeHint};
use std::convert::Infallible;
use std::ops::Range;
use std::pin::Pin;
use std::task::{Context, Poll};

/// Size of the pieces in which an answer in memory is sent.
const PIECE: usize = 256 << 10;

/// An answer in memory, whose memory is counted until its last piece is taken.
pub(super) struct Counted {
    rest: Bytes,
    _memory: SharePermit,
}

impl Counted {
    pub(super) fn new(bytes: Bytes, memory: SharePermit) -> Self {
        Counted { rest: bytes, _memory: memory }
    }
}

impl HttpBody for Counted {
    type Data = Bytes;
    type Error = Infallible;

    fn poll_frame(mut self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, Infallible>>> {
        if self.rest.is_empty() {
            return Poll::Ready(None);
        }
        let n = self.rest.len().min(PIECE);
        Poll::Ready(Some(Ok(Frame::data(self.rest.split_to(n)))))
    }

    fn size_hint(&self) -> SizeHint {
        SizeHint::with_exact(self.rest.len() as u64)
    }
}

/// Content in the store, which never changes under its ETag.
pub(super) struct Stored<'a> {
    pub(super) etag: &'a str,
    pub(super) content_type: &'static str,
    pub(super) n_bytes: u64,
}

/// The part of a content that a request asks for.
pub(super) enum Wanted {
    /// An answer without content: 304 or 416.
    Nothing(Box<Response>),
    /// The whole content, or a range of it; only the headers for a HEAD request.
    Content { range: Option<Range<u64>>, with_body: bool },
}

impl Stored<'_> {
    /// Answers a call with the part of the content that it asks for, streamed from what `open` returns.
    ///
    /// # Errors
    /// Those of `open`.
    pub(super) async fn answer<O>(
        &self,
        call: &AuthorizedRequest,
        open: impl FnOnce(Option<Range<u64>>) -> O,
    ) -> Result<Response, Problem>
    where
        O: Future<Output = Result<BlobStream, JobError>>,
    {
        Ok(match self.wanted(&call.method, &call.headers) {
            Wanted::Nothing(response) => *response,
            Wanted::Content { range, with_body } => {
                let stream = if with_body { Some(open(range.clone()).await?) } else { None };
                self.streamed(&call.headers, range, stream)
            }
        })
    }

    /// The part of the content that a request asks for.
    pub(super) fn wanted(&self, method: &Method, headers: &HeaderMap) -> Wanted {
        if is_fresh(headers, self.etag) {
            return Wanted::Nothing(Box::new(not_modified(self.etag)));
        }
        let with_body = method != Method::HEAD;
        let if_range = headers.get(header::IF_RANGE);
        // A range applies to GET only, and to the content that the client knows.
        let applies = with_body && if_range.is_none_or(|known| known.as_bytes() == self.etag.as_bytes());
        let asked = headers.get(header::RANGE).filter(|_| applies).and_then(|value| value.to_str().ok());
        match asked.map_or(Asked::Whole, |text| parse(text, self.n_bytes)) {
            Asked::Whole => Wanted::Content { range: None, with_body },
            Asked::Range(range) => Wanted::Content { range: Some(range), with_body },
            Asked::Beyond => {
                let mut response = Problem::new(ProblemKind::RangeNotSatisfiable).into_response();
                if let Ok(size) = HeaderValue::from_str(&format!("bytes */{}", self.n_bytes)) {
                    response.headers_mut().insert(header::CONTENT_RANGE, size);
                }
                Wanted::Nothing(Box::new(response))
            }
        }
    }

    /// The answer with a stream of the content, or of a range of it.
    fn streamed(&self, headers: &HeaderMap, range: Option<Range<u64>>, stream: Option<BlobStream>) -> Response {
        // Compression polls once more after the end, where a stream that is not fused may panic.
        let body = stream.map_or_else(Body::empty, |stream| Body::from_stream(stream.fuse()));
        let mut response = respond(headers, self.etag, self.content_type, body);
        let length = range.as_ref().map_or(self.n_bytes, |range| range.end - range.start);
        let answered = response.headers_mut();
        answered.insert(header::CONTENT_LENGTH, length.into());
        answered.insert(header::ACCEPT_RANGES, HeaderValue::from_static("bytes"));
        if let Some(range) = range {
            let place = format!("bytes {}-{}/{}", range.start, range.end.saturating_sub(1), self.n_bytes);
            if let Ok(place) = HeaderValue::from_str(&place) {
                answered.insert(header::CONTENT_RANGE, place);
            }
            *response.status_mut() = StatusCode::PARTIAL_CONTENT;
        }
        response
    }
}

/// The meaning of a `Range` header.
#[derive(Debug, PartialEq)]
enum Asked {
    /// Also for several ranges and other units, which a server may ignore.
    Whole,
    Range(Range<u64>),
    Beyond,
}

fn parse(text: &str, n_bytes: u64) -> Asked {
    let Some((first, last)) = text.trim().strip_prefix("bytes=").and_then(|range| range.split_once('-')) else {
        return Asked::Whole;
    };
    let number = |text: &str| text.trim().parse::<u64>().ok();
    let range = match (first.trim(), last.trim()) {
        ("", last) => match number(last) {
            Some(n) => n_bytes.saturating_sub(n)..n_bytes,
            None => return Asked::Whole,
        },
        (first, "") => match number(first) {
            Some(first) => first..n_bytes,
            None => return Asked::Whole,
        },
        (first, last) => match (number(first), number(last)) {
            (Some(first), Some(last)) if first <= last => first..last.saturating_add(1).min(n_bytes),
            _ => return Asked::Whole,
        },
    };
    if range.start >= range.end { Asked::Beyond } else { Asked::Range(range) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use http_body_util::BodyExt;

    #[tokio::test]
    async fn a_streamed_answer_may_be_read_beyond_its_end() {
        let pieces =
            futures_util::stream::unfold(0, |k| async move { (k < 2).then(|| (Ok(Bytes::from_static(b"ab")), k + 1)) });
        let stored = Stored { etag: "\"e\"", content_type: "application/json", n_bytes: 4 };
        let response = stored.streamed(&HeaderMap::new(), None, Some(Box::pin(pieces)));
        let mut body = response.into_body();
        for _ in 0..2 {
            assert_eq!(body.frame().await.unwrap().unwrap().into_data().unwrap(), "ab");
        }
        assert!(body.frame().await.is_none());
        assert!(body.frame().await.is_none());
    }

    #[test]
    fn ranges_are_parsed() {
        for (text, expected) in [
            ("bytes=0-0", Asked::Range(0..1)),
            ("bytes=2-5", Asked::Range(2..6)),
            ("bytes=2-", Asked::Range(2..10)),
            ("bytes=-3", Asked::Range(7..10)),
            ("bytes=-30", Asked::Range(0..10)),
            ("bytes=9-99999999999", Asked::Range(9..10)),
            ("bytes=10-", Asked::Beyond),
            ("bytes=10-12", Asked::Beyond),
            ("bytes=-0", Asked::Beyond),
            ("bytes=5-2", Asked::Whole),
            ("bytes=a-b", Asked::Whole),
            ("bytes=0-1,3-4", Asked::Whole),
            ("lines=0-1", Asked::Whole),
            ("bytes", Asked::Whole),
            ("bytes=-", Asked::Whole),
        ] {
            assert_eq!(parse(text, 10), expected, "{text}");
        }
    }
}
