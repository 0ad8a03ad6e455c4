//! `/v1/changes`: the feed of state changes.

use crate::http::call::AuthorizedRequest;
use crate::http::fields::Fields;
use crate::http::long_poll::wait_of;
use crate::http::problem::Problem;
use crate::http::query::QueryString;
use crate::http::wire::{ChangeDocument, ChangesDocument};
use crate::jobs::Scope;
use axum::response::Response;
use std::fmt::Display;
use std::ops::RangeInclusive;
use std::str::FromStr;
use std::time::Duration;
use tokio::time::Instant;

const DEFAULT_CHANGES: u32 = 500;
const MAX_CHANGES: u32 = 5_000;
/// After the first change ends a wait, changes that follow at once are gathered into the same answer, because a batch
/// can end many jobs in quick succession.
const GATHER: Duration = Duration::from_millis(100);

/// A number with two names: its own name, and the name that other lists use.
fn either<T>(query: &mut QueryString, [own, of_lists]: [&str; 2], range: RangeInclusive<T>) -> Option<T>
where
    T: FromStr + PartialOrd + Display + Clone,
{
    let (first, second) = (query.number(own, range.clone()), query.number(of_lists, range));
    if first.is_some() && second.is_some() {
        query.fault(of_lists, "repeated", format!("is the same as {own}; give one of them"));
    }
    first.or(second)
}

/// List state changes
///
/// All changes of the tenant's jobs after number `since`, in order. A platform that was offline catches up by passing
/// `next_since` as `since` until `more` is false. No change appears later with a smaller number. With `wait` an answer
/// without changes is delayed until there is one, or until the wait is over. `fields` selects members of each change, as in
/// the list of jobs.
#[utoipa::path(
    get, path = "/v1/changes",
    params(
        ("since" = Option<u64>, Query, description = "Only changes after this number; 0 if absent"),
        ("wait" = Option<u32>, Query, minimum = 0, maximum = 30, description = "Longest time to wait for a change, s; 0 if absent"),
        ("limit" = Option<u32>, Query, minimum = 1, maximum = 5000, description = "Maximum number of changes; 500 if absent"),
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 5000, description = "The same as `limit`, as in the other lists"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page; the same as `since`"),
    ),
    responses((status = 200, description = "Changes", body = ChangesDocument))
)]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let since = either(&mut call.query, ["since", "page_token"], 0..=i64::MAX.unsigned_abs()).unwrap_or(0);
    let limit = either(&mut call.query, ["limit", "page_size"], 1..=MAX_CHANGES).unwrap_or(DEFAULT_CHANGES);
    let wait = wait_of(&mut call.query, &call.state);
    let fields = Fields::<ChangeDocument>::of(&mut call.query);
    call.query.finish()?;
    let _place = call.place(wait)?;
    let until = Instant::now() + wait;
    let mut page = call.service().changes(&call.tenant, since, limit).await?;
    if page.changes.is_empty() && !wait.is_zero() {
        let feed = call.service().follow_changes(&call.tenant, since);
        let mut seen = feed.seen();
        let appear = async {
            // An error means that the reader has ended; the store is then read.
            let _ = seen.wait_for(|has_changes| **has_changes).await;
            tokio::time::sleep_until(until.min(Instant::now() + GATHER)).await;
        };
        tokio::select! {
            () = appear => {}
            () = tokio::time::sleep_until(until) => {}
            () = call.state.stop.cancelled() => {}
        }
        // A key may have been revoked during the wait.
        call.rights.ask(Scope::Read).await?;
        page = call.service().changes(&call.tenant, since, limit).await?;
    }
    fields.answer(&ChangesDocument::from(&page), "changes")
}
