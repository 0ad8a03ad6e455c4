//! Bodies read under limits.
//!
//! Whoever is refused while still sending would see a broken connection instead of the answer; so what follows a
//! refusal is read and thrown away, within bounds.

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

/// A request's body that can still be read after its reader gave up.
#[derive(Clone)]
pub struct Tap(Arc<Mutex<Tapped>>);

struct Tapped {
    body: Body,
    seen: usize,
    limit: usize,
    over: bool,
}

impl Tap {
    /// Splits a request: the rest of it, and its body, of which `limit` bytes are given out.
    pub fn on(request: Request, limit: usize) -> (Request, Tap) {
        let (parts, body) = request.into_parts();
        let tap = Tap(Arc::new(Mutex::new(Tapped { body, seen: 0, limit, over: false })));
        (Request::from_parts(parts, Body::new(tap.clone())), tap)
    }

    /// Whether more than the limit was sent.
    pub fn is_over(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).over
    }

    /// Lets a refused client send to its end, so that it sees the answer; what was not refused passes.
    pub async fn settle<T, E>(&self, read: Result<T, E>) -> Result<T, E> {
        if read.is_err() {
            self.drain().await;
        }
        read
    }

    /// Reads and throws away what is still sent, at most as much again as was allowed.
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
                return Poll::Ready(Some(Err(axum::Error::new("the body is over its limit"))));
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

/// The endings of a file's name, such as `.nii.gz`; the rest of the name may name a patient and is dropped.
pub(super) fn name_hint(file_name: &str) -> Option<String> {
    let (rest, last) = file_name.rsplit_once('.')?;
    let is_ending = |text: &str| (1..=8).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_alphanumeric());
    if !is_ending(last) {
        return None;
    }
    let last = last.to_ascii_lowercase();
    // Only before a compression's ending does the one before it say more.
    let before = rest.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase()).filter(|e| last == "gz" && is_ending(e));
    Some(before.map_or_else(|| format!(".{last}"), |e| format!(".{e}.{last}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_endings_of_names_are_kept() {
        let hint = |name| name_hint(name);
        assert_eq!(hint("Doe^Jane.1970.nii.gz").as_deref(), Some(".nii.gz"));
        assert_eq!(hint("Doe^Jane.1970.STL").as_deref(), Some(".stl"));
        assert_eq!(hint("JaneDoe"), None);
        assert_eq!(hint("a.Jane Doe"), None);
    }
}
