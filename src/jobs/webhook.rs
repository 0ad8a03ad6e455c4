//! Webhooks: receivers of state changes, and the deliveries to them.

use super::error::JobError;
use super::job::{Cursor, Tenant};
use super::state::JobState;
use async_trait::async_trait;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// A subscription to events.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Webhook {
    /// UUIDv7.
    pub id: String,
    /// Owner.
    pub tenant: Tenant,
    /// The URL to which events are sent.
    pub url: String,
    /// Changes to these states are sent; empty for all.
    pub states: Vec<JobState>,
    /// The key with which deliveries are signed: `whsec_` and base64; in lists, its stored form, which may be sealed.
    pub secret: String,
    /// Whether events are sent.
    pub is_enabled: bool,
    /// Why not, if the service disabled it.
    pub disabled_because: Option<String>,
    /// When it was created.
    pub created_at: Timestamp,
}

/// A page of the list of webhooks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WebhookPage {
    /// The webhooks, newest first.
    pub webhooks: Vec<Webhook>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}

/// The state of a delivery.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum DeliveryState {
    /// Waiting for its first or next attempt, or in progress.
    Pending,
    /// The receiver answered 2xx.
    Delivered,
    /// All attempts failed; there will be no further one.
    Failed,
}

impl DeliveryState {
    /// The name in JSON and in the database.
    pub fn name(self) -> &'static str {
        match self {
            DeliveryState::Pending => "pending",
            DeliveryState::Delivered => "delivered",
            DeliveryState::Failed => "failed",
        }
    }

    /// The state of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Pending, Self::Delivered, Self::Failed].into_iter().find(|state| state.name() == name)
    }
}

/// The delivery of an event to a webhook.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Delivery {
    /// UUIDv7, sent as `webhook-id`; the same at every attempt.
    pub id: String,
    /// Type of the event, such as `job.succeeded`.
    pub event: String,
    /// Its state.
    pub state: DeliveryState,
    /// Attempts so far.
    pub attempts: u32,
    /// When it is attempted next, while pending.
    pub next_at: Timestamp,
    /// HTTP status of the last response.
    pub status: Option<u16>,
    /// Why there was no response.
    pub error: Option<String>,
    /// When it was created.
    pub created_at: Timestamp,
    /// When it was delivered or given up.
    pub ended_at: Option<Timestamp>,
}

/// A page of the log of deliveries.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeliveryPage {
    /// The deliveries, newest first.
    pub deliveries: Vec<Delivery>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}

/// A delivery that is due.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DueDelivery {
    /// Its id.
    pub id: String,
    /// Its webhook.
    pub webhook_id: String,
    /// The URL to which it is sent.
    pub url: String,
    /// The key with which it is signed.
    pub secret: String,
    /// The body.
    pub payload: String,
    /// Number of this attempt, from 1.
    pub attempt: u32,
    /// Whether its webhook is still enabled.
    pub is_wanted: bool,
    /// W3C trace context of the submission of its job.
    pub traceparent: Option<String>,
}

/// The turn of a webhook: deliveries that one process attempts. Each webhook has a queue of its own, so that no receiver waits
/// for another one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Turn {
    /// The webhook.
    pub webhook_id: String,
    /// Turns in which its receiver has accepted nothing, since it last accepted something.
    pub failures: u32,
    /// The due deliveries: one if the receiver failed last time, else several.
    pub deliveries: Vec<DueDelivery>,
}

/// Bounds on turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TurnLimits {
    /// How long no other process serves the webhook, unless the turn ends before.
    pub busy_for: Duration,
    /// Webhooks of a tenant that are served at the same time, in all processes.
    pub of_tenant: u32,
    /// Deliveries of a turn.
    pub deliveries: u32,
}

/// The outcome of an attempt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Attempted {
    /// The receiver answered 2xx.
    Delivered {
        /// HTTP status of the response.
        status: u16,
    },
    /// The attempt failed and is repeated.
    Retry {
        /// Time until the next attempt.
        after: Duration,
        /// HTTP status of the response, if there was one.
        status: Option<u16>,
        /// Description of the error.
        error: String,
    },
    /// The attempt failed and there is no further one.
    Failed {
        /// HTTP status of the response, if there was one.
        status: Option<u16>,
        /// Description of the error.
        error: String,
    },
}

/// Records of webhooks and deliveries.
#[async_trait]
pub trait WebhookStore: Send + Sync {
    /// Stores a webhook; `None` if the tenant has `at_most` already.
    async fn insert_webhook(&self, webhook: &Webhook, at_most: u32) -> Result<Option<Webhook>, JobError>;

    /// A webhook.
    async fn get_webhook(&self, tenant: &Tenant, id: &str) -> Result<Webhook, JobError>;

    /// A page of the list of webhooks, newest first.
    async fn list_webhooks(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<WebhookPage, JobError>;

    /// Changes the URL, the states, and whether the webhook is enabled.
    async fn update_webhook(
        &self,
        tenant: &Tenant,
        id: &str,
        url: &str,
        states: &[JobState],
        is_enabled: bool,
    ) -> Result<Webhook, JobError>;

    /// Deletes a webhook with its log of deliveries.
    async fn delete_webhook(&self, tenant: &Tenant, id: &str) -> Result<(), JobError>;

    /// A page of the log of deliveries, newest first.
    async fn list_deliveries(
        &self,
        tenant: &Tenant,
        id: &str,
        size: u32,
        after: Option<Cursor>,
    ) -> Result<DeliveryPage, JobError>;

    /// Inserts a delivery that no state change caused, such as a test event.
    async fn insert_delivery(
        &self,
        tenant: &Tenant,
        id: &str,
        event: &str,
        payload: &str,
    ) -> Result<Delivery, JobError>;

    /// Inserts the deliveries of the state changes since the last call. Returns their number.
    async fn insert_due_deliveries(&self) -> Result<u32, JobError>;

    /// The turn of the webhook that was served longest ago, of those with deliveries that are due.
    async fn claim_turn(&self, limits: &TurnLimits) -> Result<Option<Turn>, JobError>;

    /// Ends the turn of a webhook whose receiver has failed `failures` times; its next turn begins after `pause`.
    async fn end_turn(&self, webhook_id: &str, failures: u32, pause: Duration) -> Result<(), JobError>;

    /// Records the outcome of an attempt.
    async fn end_attempt(&self, id: &str, attempted: &Attempted) -> Result<(), JobError>;

    /// Disables a webhook and records why.
    async fn disable_webhook(&self, id: &str, because: &str) -> Result<(), JobError>;
}
