//! `/v1/events`: the changes of all jobs of a tenant as they happen, in one stream.

use super::events::{as_stream, last_event_id};
use crate::http::auth::Rights;
use crate::http::call::AuthorizedRequest;
use crate::http::problem::Problem;
use crate::http::shares::SharePermit;
use crate::http::wire::ChangeDocument;
use crate::jobs::{JobService, Tenant};
use axum::response::Response;
use axum::response::sse::Event;
use futures_util::Stream;
use serde_json::json;
use std::collections::VecDeque;
use std::convert::Infallible;
use std::sync::Arc;
use tokio_util::sync::CancellationToken;

/// Changes read from the store at once.
const PAGE: u32 = 500;

/// Follow all jobs
///
/// Server-sent events: first `open`, with the number of the last change so far as `next_since`, then `change` for every change of
/// a job's state, as in `/v1/changes`. The `id` of an event is the number of the change. A client that reconnects with
/// `Last-Event-ID`, as an `EventSource` does by itself, gets every change since, without gaps or repeats; `since` does the same
/// for the first connection. The stream ends when the service shuts down; reconnect then. It ends as well when the key that opened it
/// is revoked, or the token has expired.
#[utoipa::path(
    get, path = "/v1/events",
    params(
        ("since" = Option<u64>, Query, description = "Begin after the change with this number; with the next change if absent"),
        ("Last-Event-ID" = Option<String>, Header, description = "`id` of the last event received; takes precedence over `since`"),
    ),
    responses((status = 200, description = "Events", content_type = "text/event-stream", body = serde_json::Value))
)]
pub(crate) async fn events(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let asked = call.query.number("since", 0..=i64::MAX.unsigned_abs());
    call.query.finish()?;
    let number = |text: &str| text.trim().parse::<u64>().ok().filter(|number| i64::try_from(*number).is_ok());
    let resumed = last_event_id(&call.headers, number)?;
    let place = call.state.begin_stream(&call.tenant, call.origin)?;
    let since = match resumed.or(asked) {
        Some(since) => since,
        None => call.service().newest_change(&call.tenant).await?,
    };
    let opening = Event::default().event("open").id(since.to_string()).json_data(json!({"next_since": since}));
    let follower = Follower {
        service: call.state.service,
        tenant: call.tenant,
        since,
        rights: call.rights,
        stop: call.state.stop,
        waiting: opening.into_iter().collect(),
        _place: place,
    };
    Ok(as_stream(follower.into_stream()))
}

/// A client of the stream.
struct Follower {
    service: Arc<JobService>,
    tenant: Tenant,
    /// Number of the last sent change.
    since: u64,
    rights: Rights,
    stop: CancellationToken,
    waiting: VecDeque<Event>,
    _place: [Option<SharePermit>; 2],
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
            if !self.rights.last().await {
                return None;
            }
            // An answer that has begun cannot become an error: the client reconnects and then gets the error.
            let page = self.service.changes(&self.tenant, self.since, PAGE).await.ok()?;
            if page.changes.is_empty() {
                let feed = self.service.follow_changes(&self.tenant, self.since);
                let mut seen = feed.seen();
                tokio::select! {
                    // An error means that the reader has ended; the store is then read.
                    _ = seen.wait_for(|has_changes| **has_changes) => {}
                    () = self.rights.due() => {}
                    () = self.stop.cancelled() => return None,
                }
                continue;
            }
            for change in &page.changes {
                let event = Event::default().event("change").id(change.seq.to_string());
                self.waiting.extend(event.json_data(ChangeDocument::from(change)));
            }
            self.since = page.next_since;
        }
    }
}
