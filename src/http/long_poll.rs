//! Long polls: `?wait=N` delays an answer until the resource has changed, and weak ETags identify the version.
//!
//! A [`Version`] has two parts. The state is everything that a client reacts to at once, such as the end of a job; a
//! change of it is answered immediately. The progress changes all the time while a job runs. A change of progress alone
//! is answered [`PROGRESS_INTERVAL`] after the request at the earliest, so that a client that asks again after each
//! answer makes one request a second. Members outside both parts, such as the estimated remaining time, are in the body
//! but do not count as a change.

use super::call::{AuthorizedRequest, ResourceId};
use super::conditional::{not_modified, with_etag};
use super::content::Counted;
use super::fields::Fields;
use super::problem::Problem;
use super::query::QueryString;
use super::shares::SharePermit;
use super::state::HttpState;
use crate::jobs::Scope;
use crate::jobs::follow::Feed;
use async_trait::async_trait;
use axum::body::Body;
use axum::http::{HeaderMap, HeaderValue, header};
use axum::response::Response;
use serde::Serialize;
use std::sync::Arc;
use std::time::Duration;
use tokio::time::{Instant, sleep_until};

/// Longest wait of a request, s.
pub(super) const MAX_WAIT_S: u32 = 30;
/// Least time from a request to an answer that reports only progress.
const PROGRESS_INTERVAL: Duration = Duration::from_secs(1);
/// Part of a request's time limit that is reserved for the answer after the wait.
const RESERVE: Duration = Duration::from_millis(500);
/// Hexadecimal digits of each part of an ETag.
const DIGITS: usize = 24;

/// The parameter `wait`, shortened so that the answer leaves before the request's time limit.
pub(super) fn wait_of(query: &mut QueryString, state: &HttpState) -> Duration {
    let wait = Duration::from_secs(query.number("wait", 0..=MAX_WAIT_S).unwrap_or(0).into());
    wait.min(state.limits.request_timeout.saturating_sub(RESERVE))
}

/// The state and the progress of a resource, as digests.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Version {
    state: String,
    progress: String,
}

/// The difference between a version and those that a client knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Difference {
    None,
    Progress,
    State,
}

impl Version {
    /// The version of a resource with this state and progress.
    pub(super) fn of(state: &impl Serialize, progress: &impl Serialize) -> Result<Self, Problem> {
        Ok(Version { state: digest(state)?, progress: digest(progress)? })
    }

    /// A weak ETag (RFC 9110, section 8.8.1), because bodies of one version may differ in members that do not count as
    /// a change.
    fn etag(&self) -> String {
        format!("W/\"{}.{}\"", self.state, self.progress)
    }

    /// The version that an entity tag of this service names.
    fn from_etag(tag: &str) -> Option<Self> {
        let tag = tag.trim();
        let opaque = tag.strip_prefix("W/").unwrap_or(tag).strip_prefix('"')?.strip_suffix('"')?;
        let (state, progress) = opaque.split_once('.')?;
        Some(Version { state: state.to_owned(), progress: progress.to_owned() })
    }
}

fn digest(part: &impl Serialize) -> Result<String, Problem> {
    let bytes = serde_json::to_vec(part).map_err(|e| Problem::internal(&e))?;
    Ok(blake3::hash(&bytes).to_hex()[..DIGITS].to_owned())
}

/// The versions that a client has seen.
#[derive(Debug)]
struct Known {
    versions: Vec<Version>,
    /// Whether `If-None-Match` named them; an unchanged resource is then answered with 304.
    is_conditional: bool,
}

impl Known {
    /// The versions in `If-None-Match`. Without it, and for `*`, the version at the time of the request.
    fn of(headers: &HeaderMap, current: &Version) -> Self {
        let mut lines = headers.get_all(header::IF_NONE_MATCH).iter().peekable();
        let is_conditional = lines.peek().is_some();
        let tags: Vec<&str> = lines.filter_map(|line| line.to_str().ok()).flat_map(|line| line.split(',')).collect();
        if !is_conditional || tags.iter().any(|tag| tag.trim() == "*") {
            return Known { versions: vec![current.clone()], is_conditional };
        }
        Known { versions: tags.into_iter().filter_map(Version::from_etag).collect(), is_conditional }
    }

    /// The smallest difference from any of them.
    fn difference(&self, version: &Version) -> Difference {
        let each = self.versions.iter().map(|known| match (known.state == version.state, known == version) {
            (_, true) => Difference::None,
            (true, false) => Difference::Progress,
            (false, false) => Difference::State,
        });
        each.min_by_key(|difference| *difference as u8).unwrap_or(Difference::State)
    }
}

/// The present content of a resource.
#[derive(Debug)]
pub(super) struct Snapshot {
    pub(super) version: Version,
    /// JSON.
    pub(super) body: Vec<u8>,
    /// Whether the resource is final; waiting for a change would be pointless.
    pub(super) is_final: bool,
    /// Memory that the answer takes until it is sent, if that is counted.
    pub(super) memory: Option<SharePermit>,
}

/// A resource that can be waited for.
#[async_trait]
pub(super) trait Resource: Sync {
    /// The data that its feed shows.
    type Seen: Send + Sync;

    /// Reads the resource from the store.
    async fn look(&self) -> Result<Snapshot, Problem>;

    /// Follows the resource; called only if it can change.
    async fn follow(&self) -> Result<Arc<Feed<Self::Seen>>, Problem>;

    /// The version of the feed's data.
    fn version(&self, seen: &Self::Seen) -> Result<Version, Problem>;
}

/// A resource of a call that can be waited for, and the members that the client asks for.
pub(super) struct Watched<I, E> {
    pub(super) call: AuthorizedRequest,
    pub(super) id: I,
    pub(super) fields: Fields<E>,
}

/// Answers 200 with the resource in the path, or 304 where the client has this version; with `?wait=`, when it has changed, or
/// when the wait is over. `fields` reads which members are asked for.
pub(super) async fn watch<I: ResourceId, E>(
    mut call: AuthorizedRequest,
    fields: impl FnOnce(&mut QueryString) -> Fields<E>,
) -> Result<Response, Problem>
where
    Watched<I, E>: Resource,
{
    let wait = wait_of(&mut call.query, &call.state);
    let fields = fields(&mut call.query);
    call.query.finish()?;
    let _place = call.place(wait)?;
    let id = call.id()?;
    answer(wait, &Watched { call, id, fields }).await
}

async fn answer<I, E>(wait: Duration, resource: &Watched<I, E>) -> Result<Response, Problem>
where
    Watched<I, E>: Resource,
{
    let AuthorizedRequest { state, headers, rights, .. } = &resource.call;
    let asked = Instant::now();
    let first = resource.look().await?;
    let known = Known::of(headers, &first.version);
    let difference = known.difference(&first.version);
    if wait.is_zero() || first.is_final || difference == Difference::State {
        return Ok(respond(&known, first));
    }
    let until = asked + wait;
    let earliest = until.min(asked + PROGRESS_INTERVAL);
    let feed = resource.follow().await?;
    let mut seen = feed.seen();
    // The resource may have changed between the two reads.
    seen.mark_changed();
    let mut has_progressed = difference == Difference::Progress;
    loop {
        let ended = tokio::select! {
            // An error means that the reader has ended: the resource is final.
            changed = seen.changed() => changed.is_err(),
            () = sleep_until(if has_progressed { earliest } else { until }) => true,
            () = state.stop.cancelled() => true,
        };
        let now = Instant::now();
        if !ended {
            let version = resource.version(&seen.borrow_and_update())?;
            match known.difference(&version) {
                Difference::None => continue,
                Difference::Progress if now < earliest => {
                    has_progressed = true;
                    continue;
                }
                _ => {}
            }
        }
        // A key may have been revoked during the wait.
        rights.ask(Scope::Read).await?;
        // The feed says when to read, and may lag behind; the answer is what the store returns now.
        let snapshot = resource.look().await?;
        let has_changed = known.difference(&snapshot.version) != Difference::None;
        if has_changed || snapshot.is_final || now >= until || state.stop.is_cancelled() || seen.has_changed().is_err()
        {
            return Ok(respond(&known, snapshot));
        }
        has_progressed = false;
    }
}

fn respond(known: &Known, snapshot: Snapshot) -> Response {
    let etag = snapshot.version.etag();
    if known.is_conditional && known.difference(&snapshot.version) == Difference::None {
        return not_modified(&etag);
    }
    let body = match snapshot.memory {
        Some(memory) => Body::new(Counted::new(snapshot.body.into(), memory)),
        None => Body::from(snapshot.body),
    };
    let mut response = Response::new(body);
    response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
    with_etag(response, &etag)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn version(state: &str, progress: u32) -> Version {
        Version::of(&state, &progress).unwrap()
    }

    fn known(tags: &str, current: &Version) -> Known {
        let mut headers = HeaderMap::new();
        headers.insert(header::IF_NONE_MATCH, tags.parse().unwrap());
        Known::of(&headers, current)
    }

    #[test]
    fn etags_are_weak_and_compared_weakly_in_lists() {
        let current = version("running", 7);
        let etag = current.etag();
        assert!(etag.starts_with("W/\""), "{etag}");
        let strong = etag.trim_start_matches("W/").to_owned();
        for tags in [etag.clone(), strong, format!("\"other\", {etag}"), "*".to_owned()] {
            let known = known(&tags, &current);
            assert!(known.is_conditional);
            assert_eq!(known.difference(&current), Difference::None, "{tags}");
        }
    }

    #[test]
    fn the_smallest_difference_from_a_known_version_counts() {
        let (old, new) = (version("running", 7), version("running", 8));
        let ended = version("succeeded", 100);
        assert_eq!(known(&old.etag(), &new).difference(&new), Difference::Progress);
        assert_eq!(known(&old.etag(), &ended).difference(&ended), Difference::State);
        let both = format!("{}, {}", ended.etag(), old.etag());
        assert_eq!(known(&both, &new).difference(&new), Difference::Progress);
        for none in ["", "\"x\"", "x", "W/", "\""] {
            assert_eq!(known(none, &new).difference(&new), Difference::State, "{none}");
        }
    }

    #[test]
    fn without_a_condition_the_current_version_is_known() {
        let current = version("running", 7);
        let known = Known::of(&HeaderMap::new(), &current);
        assert!(!known.is_conditional);
        assert_eq!(known.difference(&current), Difference::None);
        assert_eq!(known.difference(&version("running", 8)), Difference::Progress);
    }
}
