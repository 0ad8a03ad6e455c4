//! `/v1/jobs/{id}/events`: the events of a job as they happen.

use crate::http::auth::Rights;
use crate::http::call::AuthorizedRequest;
use crate::http::fields::Fields;
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::shares::SharePermit;
use crate::http::wire::JobDocument;
use crate::jobs::follow::{Feed, Seen};
use crate::jobs::{Job, JobId};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode, header};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use futures_util::Stream;
use std::collections::VecDeque;
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::watch;
use tokio_util::sync::CancellationToken;

/// Interval between comments on an idle stream: proxies close silent connections.
const HEARTBEAT: Duration = Duration::from_secs(15);
const LAST_EVENT_ID: HeaderName = HeaderName::from_static("last-event-id");

/// Follow a job
///
/// Server-sent events: `state` (the job, whenever its state changes), `progress`, `trace` (a point) and `done` (the finished
/// job), after which the stream ends. `fields` selects members of these jobs; without it they are without their `parameters`. The `id` of an event is the `seq` of the last trace point up to it, with `-done` after
/// it for `done`. A client that reconnects with `Last-Event-ID` gets the trace from there on, without gaps or repeats; after
/// `done` it gets 204, at which an `EventSource` stops. The stream also ends when the service shuts down; reconnect then. It ends
/// as well when the key that opened it is revoked, or the token has expired.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/events",
    params(
        ("fields" = Option<String>, Query, description = "Members of the jobs in `state` and `done`, separated by commas, or `*`; all but `parameters` if absent"),
        ("Last-Event-ID" = Option<String>, Header, description = "`id` of the last event received"),
    ),
    responses(
        (status = 200, description = "Events", content_type = "text/event-stream", body = serde_json::Value),
        (status = 204, description = "`Last-Event-ID` is that of `done`: nothing follows"),
    )
)]
pub(crate) async fn events(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let fields = Fields::of(&mut call.query);
    call.query.finish()?;
    let (after_seq, is_done) = last_event_id(&call.headers, parse_id)?.unwrap_or((0, false));
    let id: JobId = call.id()?;
    if is_done && call.service().get(&call.tenant, id).await?.state.is_final() {
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    let place = call.state.begin_stream(&call.tenant, call.origin)?;
    let feed = call.service().follow(&call.tenant, id).await?;
    let mut seen = feed.seen();
    seen.mark_changed(); // the current state is sent too
    let follower = Follower {
        seen,
        stop: call.state.stop,
        rights: call.rights,
        fields,
        last_seq: after_seq,
        last: None,
        waiting: VecDeque::new(),
        ended: false,
        _feed: feed,
        _place: place,
    };
    Ok(as_stream(follower.into_stream()))
}

/// The value of `Last-Event-ID`, read by `parse`, if the client sends it.
///
/// # Errors
/// `bad-request` if it is not the id of an event of the stream.
pub(super) fn last_event_id<T>(
    headers: &HeaderMap,
    parse: impl FnOnce(&str) -> Option<T>,
) -> Result<Option<T>, Problem> {
    let Some(value) = headers.get(LAST_EVENT_ID) else { return Ok(None) };
    let id = value.to_str().ok().and_then(parse).ok_or_else(|| {
        let detail = "must be the id of an event of this stream";
        let fault = FieldError::new("/headers/last-event-id", "out_of_range", detail);
        Problem::new(ProblemKind::BadRequest).detail(detail).errors(&[fault])
    })?;
    Ok(Some(id))
}

/// The answer with a stream of events, which no proxy should buffer or store.
pub(super) fn as_stream(events: impl Stream<Item = Result<Event, Infallible>> + Send + 'static) -> Response {
    let keep_alive = KeepAlive::new().interval(HEARTBEAT).text("alive");
    let mut response = Sse::new(events).keep_alive(keep_alive).into_response();
    // Some proxies buffer responses; this header turns that off.
    response.headers_mut().insert("x-accel-buffering", HeaderValue::from_static("no"));
    response.headers_mut().insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
    response
}

/// A client of the stream: the sent events, and the ones to send next.
struct Follower {
    seen: watch::Receiver<Arc<Seen>>,
    stop: CancellationToken,
    rights: Rights,
    fields: Fields<JobDocument>,
    last_seq: u64,
    last: Option<Arc<Seen>>,
    waiting: VecDeque<Event>,
    ended: bool,
    /// Keeps the reader of the store running.
    _feed: Arc<Feed<Seen>>,
    _place: [Option<SharePermit>; 2],
}

/// Suffix of the `seq` in the id of the last event.
const DONE: &str = "-done";

/// The `seq` in the id of an event, and whether it is the id of the last event.
pub(in crate::http) fn parse_id(text: &str) -> Option<(u64, bool)> {
    let text = text.trim();
    let (seq, is_done) = text.strip_suffix(DONE).map_or((text, false), |seq| (seq, true));
    Some((seq.parse().ok()?, is_done))
}

impl Follower {
    fn into_stream(self) -> impl Stream<Item = Result<Event, Infallible>> {
        futures_util::stream::unfold(self, |mut follower| async move {
            let event = follower.next().await?;
            Some((Ok(event), follower))
        })
    }

    async fn next(&mut self) -> Option<Event> {
        loop {
            if let Some(event) = self.waiting.pop_front() {
                return Some(event);
            }
            if self.ended {
                return None;
            }
            let is_new = tokio::select! {
                changed = self.seen.changed() => {
                    // The reader has ended: the job is finished or was deleted, and everything was sent.
                    if changed.is_err() {
                        return None;
                    }
                    true
                }
                () = self.rights.due() => false,
                () = self.stop.cancelled() => return None,
            };
            if !self.rights.last().await {
                return None;
            }
            if !is_new {
                continue;
            }
            let seen = Arc::clone(&self.seen.borrow_and_update());
            self.note(seen);
        }
    }

    /// Queues the events for what is new.
    fn note(&mut self, seen: Arc<Seen>) {
        if seen.removed {
            self.ended = true;
            return;
        }
        let before = self.last.take();
        let before = before.as_ref().map(|last| &last.job);
        let state_changed = before.is_none_or(|job| (job.state, job.attempt) != (seen.job.state, seen.job.attempt));
        if state_changed {
            self.push_job("state", "", &seen.job);
        }
        for point in seen.points_after(self.last_seq) {
            if let Ok(event) = Event::default().event("trace").id(point.seq.to_string()).json_data(point) {
                self.waiting.push_back(event);
            }
        }
        self.last_seq =
            seen.points.last().and_then(|chunk| chunk.last()).map_or(self.last_seq, |p| p.seq.max(self.last_seq));
        if let Some(progress) = &JobDocument::from(&seen.job).progress
            && before.is_none_or(|job| job.progress != seen.job.progress)
        {
            self.push("progress", "", progress);
        }
        if seen.complete {
            self.push_job("done", DONE, &seen.job);
            self.ended = true;
        }
        self.last = Some(seen);
    }

    fn push_job(&mut self, name: &str, ending: &str, job: &Job) {
        let document = self.fields.value(&JobDocument::of(job, self.fields.asks_for("parameters")));
        if let Ok(document) = document {
            self.push(name, ending, &document);
        }
    }

    fn push(&mut self, name: &str, ending: &str, data: &impl serde::Serialize) {
        let id = format!("{}{ending}", self.last_seq);
        if let Ok(event) = Event::default().event(name).id(id).json_data(data) {
            self.waiting.push_back(event);
        }
    }
}
