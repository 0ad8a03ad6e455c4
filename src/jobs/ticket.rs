//! Tickets: short-lived permissions to read one resource, for what cannot send an API key, such as `EventSource` and links in a
//! browser. The store has their hashes only.

use super::job::Tenant;
use std::time::Duration;

/// How long a ticket is accepted. A stream that has begun goes on.
pub const TICKET_LASTS: Duration = Duration::from_secs(60);
/// Most tickets of a tenant that are accepted at the same time.
pub const MAX_TICKETS: u32 = 1_000;
/// Prefix of the text of a ticket.
pub(super) const PREFIX: &str = "hmt_";

/// The permission of a ticket.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ticket {
    /// The tenant of whoever asked for it.
    pub tenant: Tenant,
    /// Their key, or their token; `None` where nobody is authenticated.
    pub key_id: Option<String>,
    /// The path that may be read, and those below it.
    pub path: String,
}

impl Ticket {
    /// Whether a path may be read with it.
    pub fn permits(&self, path: &str) -> bool {
        path.strip_prefix(self.path.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    }
}

/// The hash under which a ticket is stored; `None` if a text is no ticket.
pub(super) fn stored_hash(text: &str) -> Option<String> {
    let secret = text.strip_prefix(PREFIX).filter(|secret| secret.len() == 64)?;
    Some(blake3::hash(secret.as_bytes()).to_hex().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ticket_permits_its_path_and_what_is_below() {
        let ticket = Ticket { tenant: Tenant::default(), key_id: None, path: "/v1/jobs/1".to_owned() };
        assert!(ticket.permits("/v1/jobs/1") && ticket.permits("/v1/jobs/1/events"));
        for other in ["/v1/jobs/12", "/v1/jobs/12/events", "/v1/jobs", "/v1/jobs/2/events", "", "/x/v1/jobs/1"] {
            assert!(!ticket.permits(other), "{other}");
        }
        assert_eq!(stored_hash("hmt_short"), None);
        assert_eq!(stored_hash(&"a".repeat(68)), None);
    }
}
