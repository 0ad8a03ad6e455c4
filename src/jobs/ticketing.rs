//! The issue and the examination of tickets.

use super::error::JobError;
use super::key::{SecretKey, random_secret};
use super::service::JobService;
use super::ticket::{MAX_TICKETS, PREFIX, TICKET_LASTS, Ticket, stored_hash};

impl JobService {
    /// Stores a ticket, and returns its text; `None` if the tenant has the maximum number.
    ///
    /// # Errors
    /// Those of the store.
    pub async fn create_ticket(&self, ticket: &Ticket) -> Result<Option<String>, JobError> {
        let text = format!("{PREFIX}{}", random_secret().to_hex());
        let hash = stored_hash(&text).unwrap_or_default();
        let made = self.stores.keys.insert_ticket(&hash, ticket, TICKET_LASTS, MAX_TICKETS).await?;
        Ok(made.then_some(text))
    }

    /// The ticket with this text; `None` if there is none, it has expired, or if the key of whoever asked for it is no longer valid.
    ///
    /// # Errors
    /// Those of the store.
    pub async fn ticket(&self, text: &str) -> Result<Option<Ticket>, JobError> {
        let Some(hash) = stored_hash(text) else { return Ok(None) };
        let Some(ticket) = self.stores.keys.get_ticket(&hash).await? else { return Ok(None) };
        let key = match &ticket.key_id {
            Some(id) if SecretKey::is_id(id) => self.stores.keys.get_key(id).await?,
            _ => return Ok(Some(ticket)),
        };
        Ok(key.is_some_and(|key| key.is_valid).then_some(ticket))
    }
}
