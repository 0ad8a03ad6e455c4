//! Request bodies under size limits.
//!
//! A client that is refused while it is still sending would see a broken connection instead of the answer. So the rest of
//! its body is read and discarded, up to a limit.

use axum::body::{Body, HttpBody};
use axum::extract::Request;
use axum::extract::multipart::{Field, MultipartError};
use bytes::{Bytes, BytesMut};
use http_body::Frame;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll};
use std::time::Duration;

/// How long a refused client may go on sending.
const DRAIN: Duration = Duration::from_secs(10);

/// A request body that can still be drained after its reader has failed.
#[derive(Clone)]
pub(crate) struct Tap(Arc<Mutex<Tapped>>);

struct Tapped {
    body: Body,
    seen: usize,
    limit: usize,
    over: bool,
}

impl Tap {
    /// Wraps the body of a request so that at most `limit` bytes of it can be read.
    pub(crate) fn on(request: Request, limit: usize) -> (Request, Tap) {
        let (parts, body) = request.into_parts();
        let tap = Tap(Arc::new(Mutex::new(Tapped { body, seen: 0, limit, over: false })));
        (Request::from_parts(parts, Body::new(tap.clone())), tap)
    }

    /// Whether more than the limit was sent.
    pub(crate) fn is_over(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).over
    }

    /// Drains the body after an error, so that the client sees the answer. Passes the result through.
    pub(crate) async fn settle<T, E>(&self, read: Result<T, E>) -> Result<T, E> {
        if read.is_err() {
            self.drain().await;
        }
        read
    }

    /// Reads and discards the rest of the body, at most as much again as was allowed.
    async fn drain(&self) {
        {
            let mut tapped = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            tapped.limit = tapped.limit.saturating_mul(2);
            tapped.over = false;
        }
        let mut tap = self.clone();
        let reading =
            async { while let Some(Ok(_)) = std::future::poll_fn(|cx| Pin::new(&mut tap).poll_frame(cx)).await {} };
        let _ = tokio::time::timeout(DRAIN, reading).await;
    }
}

impl HttpBody for Tap {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let mut tapped = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let polled = Pin::new(&mut tapped.body).poll_frame(cx);
        if let Poll::Ready(Some(Ok(frame))) = &polled {
            tapped.seen = tapped.seen.saturating_add(frame.data_ref().map_or(0, Bytes::len));
            if tapped.seen > tapped.limit {
                tapped.over = true;
                return Poll::Ready(Some(Err(axum::Error::new("the body is larger than its limit"))));
            }
        }
        polled
    }
}

/// The bytes of a field; `Err(None)` if there are more than `limit`.
pub(super) async fn read_field(mut field: Field<'_>, limit: usize) -> Result<Bytes, Option<MultipartError>> {
    let mut all = BytesMut::new();
    while let Some(chunk) = field.chunk().await.map_err(Some)? {
        if all.len() + chunk.len() > limit {
            return Err(None);
        }
        all.extend_from_slice(&chunk);
    }
    Ok(all.freeze())
}

/// The extension of a file name, such as `.nii.gz`. The rest of the name may identify a patient and is dropped.
pub(super) fn name_hint(file_name: &str) -> Option<String> {
    let (rest, last) = file_name.rsplit_once('.')?;
    let is_ending = |text: &str| (1..=8).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_alphanumeric());
    if !is_ending(last) {
        return None;
    }
    let last = last.to_ascii_lowercase();
    // Before the extension of a compression, the one before it names the format.
    let before = rest.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase()).filter(|e| last == "gz" && is_ending(e));
    Some(before.map_or_else(|| format!(".{last}"), |e| format!(".{e}.{last}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_extension_of_a_name_is_kept() {
        let hint = |name| name_hint(name);
        assert_eq!(hint("Doe^Jane.1970.nii.gz").as_deref(), Some(".nii.gz"));
        assert_eq!(hint("Doe^Jane.1970.STL").as_deref(), Some(".stl"));
        assert_eq!(hint("JaneDoe"), None);
        assert_eq!(hint("a.Jane Doe"), None);
    }
}
