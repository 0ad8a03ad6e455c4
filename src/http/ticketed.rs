//! Resources that can be read with a ticket in the query: the events of a job or of all jobs, and downloads. Other
//! operations take no ticket.

use super::operations::OPERATIONS;
use super::problem::Problem;
use super::state::HttpState;
use crate::jobs::{JobId, Ticket};
use axum::extract::MatchedPath;
use axum::http::request::Parts;
use axum::http::{Extensions, Method};
use url::form_urlencoded;

/// Name of the query parameter.
pub(super) const TICKET: &str = "ticket";
/// The events of all jobs.
const EVENTS: &str = "/v1/events";

/// The routes that take tickets.
fn routes() -> impl Iterator<Item = &'static str> {
    OPERATIONS.iter().filter(|operation| operation.takes_tickets()).map(|operation| operation.path)
}

/// Whether the route of a request takes tickets.
pub(super) fn is_ticketed(extensions: &Extensions) -> bool {
    extensions.get::<MatchedPath>().is_some_and(|path| routes().any(|route| route == path.as_str()))
}

/// Whether a ticket can be for this path: the events of all jobs, a job, a study, an upload, or a path below one of
/// these that takes tickets.
pub(super) fn is_path_for_tickets(path: &str) -> bool {
    if path == EVENTS {
        return true;
    }
    let parts: Vec<&str> = path.split('/').collect();
    let ["", "v1", kind, id, rest @ ..] = parts.as_slice() else { return false };
    let is_id = match *kind {
        "jobs" | "studies" => JobId::parse(id).is_some(),
        "meshes" => id.strip_prefix("blake3:").is_some_and(|hash| {
            hash.len() == 64 && hash.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b))
        }),
        _ => false,
    };
    let below = |route: &str| {
        let template: Vec<&str> = route.split('/').skip(4).collect();
        let fits = |(name, part): (&&str, &&str)| {
            name == part
                || (name.starts_with('{')
                    && !part.is_empty()
                    && part.bytes().all(|b| b.is_ascii_lowercase() || b"-.".contains(&b))
                    && !part.contains(".."))
        };
        route.split('/').nth(2) == Some(kind) && template.len() == rest.len() && template.iter().zip(rest).all(fits)
    };
    is_id && (rest.is_empty() || routes().any(below))
}

/// The ticket of a request, if it has one that permits it.
///
/// # Errors
/// Those of the store.
pub(super) async fn ticket_of(parts: &Parts, state: &HttpState) -> Result<Option<Ticket>, Problem> {
    let is_read = parts.method == Method::GET || parts.method == Method::HEAD;
    let query = parts.uri.query().unwrap_or_default().as_bytes();
    let mut sent = form_urlencoded::parse(query).filter(|(name, _)| name == TICKET).map(|(_, value)| value);
    let (Some(text), None) = (sent.next(), sent.next()) else { return Ok(None) };
    if !is_read || !is_ticketed(&parts.extensions) {
        return Ok(None);
    }
    let path = parts.uri.path().replace("%3A", ":").replace("%3a", ":");
    Ok(state.service.ticket(&text).await?.filter(|ticket| ticket.permits(&path)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tickets_are_for_events_and_downloads_only() {
        let (job, mesh) =
            ("/v1/jobs/019d8a1b-2c3d-7e4f-8a5b-000000000001", format!("/v1/meshes/blake3:{}", "0a".repeat(32)));
        assert_eq!(routes().count(), 17);
        for below in
            ["", "/events", "/result", "/correspondences", "/report", "/surfaces/source", "/files/warped-inverse.ply"]
        {
            assert!(is_path_for_tickets(&format!("{job}{below}")), "{below}");
        }
        assert!(
            is_path_for_tickets("/v1/events")
                && is_path_for_tickets(&mesh)
                && is_path_for_tickets(&format!("{mesh}/content"))
        );
        let of_others = [
            "/v1/jobs",
            "/v1/events/",
            "/v1/jobs/",
            "/v1/keys/3f9a1c07be52",
            "/v1/jobs/x/events",
            "/v1",
            "",
            "/",
            "/metrics",
        ];
        for other in of_others {
            assert!(!is_path_for_tickets(other), "{other}");
        }
        for below in [
            "/",
            "/cancel",
            "/events/",
            "/events?x=1",
            "/../1",
            "/result/x",
            "/surfaces/../result",
            "/files/..",
            "/files/a/b",
        ] {
            assert!(!is_path_for_tickets(&format!("{job}{below}")), "{below}");
        }
    }
}
