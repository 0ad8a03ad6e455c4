//! Request bodies under limits: of size, of memory, and of the rate at which they arrive.
//!
//! A client that is refused while it is still sending would see a broken connection instead of the answer. The rest of
//! its body is therefore read and discarded, up to a limit.

use super::pace::{LeastRate, Pace};
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::shares::SharePermit;
use axum::body::{Body, HttpBody};
use axum::extract::Request;
use axum::extract::multipart::{Field, MultipartError};
use bytes::{Bytes, BytesMut};
use http_body::Frame;
use parking_lot::Mutex;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, ready};
use std::time::{Duration, Instant};

/// How long a refused client may continue to send.
const DRAIN: Duration = Duration::from_secs(10);
/// The first bytes of a body that are not counted, so that small requests never wait for the memory of large ones. The
/// limit on concurrent bodies bounds their total.
const UNCOUNTED: u64 = 1 << 20;

/// The resources of a body while it is read, and until its submission is stored.
pub(super) struct Reading {
    /// A slot among the bodies that are read at the same time.
    pub(super) _slot: SharePermit,
    /// Memory, which the body takes when it turns out to be a large one: for all of it at once, so that no two bodies wait for
    /// each other.
    pub(super) memory: SharePermit,
    /// Bytes of memory for each byte of the body; 0 for a body that is stored as it arrives.
    pub(super) factor: u64,
    /// The least rate at which the body arrives.
    pub(super) least: LeastRate,
    /// How long the body waits for memory.
    pub(super) max_wait: Duration,
}

/// A request body that can still be drained after its reader has failed.
#[derive(Clone)]
pub(crate) struct LimitedBody(Arc<Mutex<Tapped>>);

struct Tapped {
    body: Body,
    seen: usize,
    limit: usize,
    /// The size of the body, if the client states it.
    declared: Option<u64>,
    reading: Option<Reading>,
    has_memory: bool,
    pace: Option<Pace>,
    /// A part for which there is no memory yet, and the time of its arrival.
    held_back: Option<(Frame<Bytes>, Instant)>,
    returned: Option<Pin<Box<dyn Future<Output = ()> + Send>>>,
    refusal: Option<Refusal>,
}

/// Why a body is not read to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Refusal {
    TooLarge,
    TooSlow,
    NoMemory,
}

impl LimitedBody {
    /// Wraps the body of a request so that at most `limit` bytes of it can be read.
    pub(crate) fn on(request: Request, limit: usize) -> (Request, LimitedBody) {
        let (parts, body) = request.into_parts();
        let tapped = Tapped {
            declared: body.size_hint().exact(),
            body,
            seen: 0,
            limit,
            reading: None,
            has_memory: false,
            pace: None,
            held_back: None,
            returned: None,
            refusal: None,
        };
        let tap = LimitedBody(Arc::new(Mutex::new(tapped)));
        (Request::from_parts(parts, Body::new(tap.clone())), tap)
    }

    /// Counts the body from now on; its resources are returned when the tap is dropped.
    pub(super) fn count(&self, reading: Reading) {
        let mut tapped = self.0.lock();
        tapped.pace = Some(Pace::new(reading.least));
        tapped.reading = Some(reading);
    }

    /// Lowers the limit.
    pub(super) fn limit_to(&self, limit: usize) {
        let mut tapped = self.0.lock();
        tapped.limit = tapped.limit.min(limit);
    }

    /// The answer to a body that was not read to its end because of a limit; `None` if the client ended it early.
    pub(super) fn refusal(&self) -> Option<Problem> {
        let tapped = self.0.lock();
        Some(match tapped.refusal? {
            Refusal::TooLarge => Problem::new(ProblemKind::BodyTooLarge).member("limit_bytes", tapped.limit.into()),
            Refusal::TooSlow => Problem::new(ProblemKind::UploadTimeout),
            Refusal::NoMemory => Problem::new(ProblemKind::Busy).retry_after(5),
        })
    }

    /// Whether the client has sent more than the limit.
    pub(super) fn is_over(&self) -> bool {
        self.0.lock().refusal == Some(Refusal::TooLarge)
    }

    /// What `reading` returns. Drains the body after an error, so that the client sees the answer.
    pub(crate) async fn settle<T, E>(&self, reading: impl Future<Output = Result<T, E>>) -> Result<T, E> {
        let read = reading.await;
        if read.is_err() {
            self.drain().await;
        }
        read
    }

    /// Reads and discards the rest of the body, up to the allowed size once more.
    async fn drain(&self) {
        {
            let mut tapped = self.0.lock();
            if tapped.refusal == Some(Refusal::TooSlow) {
                return; // such a client is not waited for a second time
            }
            tapped.limit = tapped.limit.saturating_mul(2);
            // Discarded bytes are not kept, so they take no memory.
            (tapped.reading, tapped.held_back, tapped.returned, tapped.refusal) = (None, None, None, None);
        }
        let mut tap = self.clone();
        let reading =
            async { while let Some(Ok(_)) = std::future::poll_fn(|cx| Pin::new(&mut tap).poll_frame(cx)).await {} };
        let _ = tokio::time::timeout(DRAIN, reading).await;
    }
}

impl Tapped {
    fn refuse(&mut self, refusal: Refusal) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        self.refusal = Some(refusal);
        Poll::Ready(Some(Err(axum::Error::new("the body is not read to its end"))))
    }

    /// The next part from the client.
    fn poll_body(&mut self, cx: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let Poll::Ready(frame) = Pin::new(&mut self.body).poll_frame(cx) else {
            return match self.pace.as_mut().map(|pace| pace.poll_too_slow(cx)) {
                Some(Poll::Ready(())) => self.refuse(Refusal::TooSlow),
                _ => Poll::Pending,
            };
        };
        if let Some(Ok(frame)) = &frame {
            let n = frame.data_ref().map_or(0, Bytes::len);
            self.seen = self.seen.saturating_add(n);
            if let Some(pace) = &mut self.pace {
                pace.moved(n);
            }
            if self.seen > self.limit {
                return self.refuse(Refusal::TooLarge);
            }
        }
        Poll::Ready(frame)
    }

    /// Takes the memory for the body. Returns whether there is enough.
    fn takes_memory(&mut self) -> bool {
        if let Some(reading) = &mut self.reading
            && !self.has_memory
            && self.seen as u64 > UNCOUNTED
        {
            let size = self.declared.unwrap_or(u64::MAX).min(self.limit as u64);
            self.has_memory = reading.memory.grow(size.saturating_mul(reading.factor));
            return self.has_memory;
        }
        true
    }
}

impl HttpBody for LimitedBody {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let tapped = &mut *self.0.lock();
        loop {
            let (frame, since) = match tapped.held_back.take() {
                Some(held_back) => held_back,
                None => match ready!(tapped.poll_body(cx)) {
                    Some(Ok(frame)) => (frame, Instant::now()),
                    end => return Poll::Ready(end),
                },
            };
            if tapped.takes_memory() {
                tapped.returned = None;
                return Poll::Ready(Some(Ok(frame)));
            }
            let Some((shares, wait)) = tapped.reading.as_ref().map(|r| (r.memory.shares(), r.max_wait)) else {
                return Poll::Ready(Some(Ok(frame)));
            };
            if since.elapsed() >= wait {
                return tapped.refuse(Refusal::NoMemory);
            }
            tapped.held_back = Some((frame, since));
            match &mut tapped.returned {
                Some(returned) => {
                    ready!(returned.as_mut().poll(cx));
                    tapped.returned = None;
                }
                None => {
                    // Polled once before the memory is requested again, so that a return in between is not missed.
                    let mut returned = Box::pin(shares.returned(wait));
                    if returned.as_mut().poll(cx).is_pending() {
                        tapped.returned = Some(returned);
                    }
                }
            }
        }
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

/// Extensions that identify a format. Any other extension may be part of a name: in `Doe^Jane.19700131` it is a date of
/// birth.
const ENDINGS: &[&str] = &[
    "nii", "hdr", "img", "nrrd", "nhdr", "mha", "mhd", "mgh", "mgz", "ply", "stl", "vtk", "vtp", "vtu", "obj", "off",
    "gii", "dcm", "pial", "white", "inflated", "orig", "sphere", "smoothwm", "tri", "asc", "mz3", "gz", "xml", "json",
];

/// The extension of a file name, such as `.nii.gz`. The rest of the name may identify a patient and is dropped.
pub(super) fn name_hint(file_name: &str) -> Option<String> {
    let known = |text: &str| ENDINGS.iter().copied().find(|ending| text.eq_ignore_ascii_case(ending));
    let (rest, last) = file_name.rsplit_once('.')?;
    let last = known(last)?;
    // The extension before a compression's extension names the format.
    let before = rest.rsplit_once('.').and_then(|(_, before)| known(before)).filter(|_| last == "gz");
    Some(before.map_or_else(|| format!(".{last}"), |before| format!(".{before}.{last}")))
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

    #[test]
    fn an_ending_that_names_no_format_is_dropped() {
        for name in ["Doe^Jane.19700131", "scan.Jane", "Doe.19700131.gz.Jane", ".1970", "x."] {
            assert_eq!(name_hint(name), None, "{name}");
        }
        assert_eq!(name_hint("Doe^Jane.19700131.gz").as_deref(), Some(".gz"));
    }
}
