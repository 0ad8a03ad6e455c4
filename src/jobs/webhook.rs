//! Webhooks: who is told of changes of jobs, and what became of telling them.

use super::error::JobError;
use super::job::{Cursor, Tenant};
use super::state::JobState;
use async_trait::async_trait;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// A receiver of events.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Webhook {
    /// UUIDv7.
    pub id: String,
    /// Owner.
    pub tenant: Tenant,
    /// Where events go.
    pub url: String,
    /// States that are told; empty for all.
    pub states: Vec<JobState>,
    /// What deliveries are signed with: `whsec_` and base64.
    pub secret: String,
    /// Whether events are sent.
    pub is_enabled: bool,
    /// Why not, if the service ended it.
    pub disabled_because: Option<String>,
    /// When it was made.
    pub created_at: Timestamp,
}

/// A part of a list of webhooks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WebhookPage {
    /// The webhooks, the newest first.
    pub webhooks: Vec<Webhook>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}

/// Where a delivery stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum DeliveryState {
    /// Is tried, or tried again.
    Pending,
    /// The receiver answered 2xx.
    Delivered,
    /// It did not, and is not asked again.
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

/// An event on its way to a receiver.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Delivery {
    /// UUIDv7; the receiver sees it as `webhook-id`, the same at every attempt.
    pub id: String,
    /// Type of the event, such as `job.succeeded`.
    pub event: String,
    /// Where it stands.
    pub state: DeliveryState,
    /// Attempts so far.
    pub attempts: u32,
    /// When it is tried next, while pending.
    pub next_at: Timestamp,
    /// HTTP status of the last answer.
    pub status: Option<u16>,
    /// Why there was none.
    pub error: Option<String>,
    /// When it was made.
    pub created_at: Timestamp,
    /// When it was delivered or given up.
    pub ended_at: Option<Timestamp>,
}

/// A part of a log of deliveries.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeliveryPage {
    /// The deliveries, the newest first.
    pub deliveries: Vec<Delivery>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}

/// A delivery to be tried now.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DueDelivery {
    /// Its id.
    pub id: String,
    /// Its webhook.
    pub webhook_id: String,
    /// Where it goes.
    pub url: String,
    /// What it is signed with.
    pub secret: String,
    /// The body.
    pub payload: String,
    /// Attempts, this one included.
    pub attempt: u32,
    /// Whether its webhook wants it still.
    pub is_wanted: bool,
}

/// What became of an attempt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Attempted {
    /// The receiver answered 2xx.
    Delivered {
        /// Its answer.
        status: u16,
    },
    /// Try again after this time.
    Retry {
        /// How long to wait.
        after: Duration,
        /// Its answer, if there was one.
        status: Option<u16>,
        /// What went wrong.
        error: String,
    },
    /// Never again.
    Failed {
        /// Its answer, if there was one.
        status: Option<u16>,
        /// What went wrong.
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

    /// A part of the list of webhooks.
    async fn list_webhooks(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<WebhookPage, JobError>;

    /// Changes address, states and whether it is enabled.
    async fn update_webhook(
        &self,
        tenant: &Tenant,
        id: &str,
        url: &str,
        states: &[JobState],
        is_enabled: bool,
    ) -> Result<Webhook, JobError>;

    /// Removes a webhook with its log.
    async fn delete_webhook(&self, tenant: &Tenant, id: &str) -> Result<(), JobError>;

    /// A part of the log of deliveries.
    async fn list_deliveries(
        &self,
        tenant: &Tenant,
        id: &str,
        size: u32,
        after: Option<Cursor>,
    ) -> Result<DeliveryPage, JobError>;

    /// Makes a delivery that no job is the reason of.
    async fn insert_delivery(&self, tenant: &Tenant, id: &str, event: &str, payload: &str) -> Result<Delivery, JobError>;

    /// Makes deliveries of the changes since the last time. Returns how many.
    async fn tell_changes(&self) -> Result<u32, JobError>;

    /// The next delivery to be tried; nobody else gets it for `busy_for`.
    async fn take_delivery(&self, busy_for: Duration) -> Result<Option<DueDelivery>, JobError>;

    /// Notes what became of an attempt.
    async fn end_attempt(&self, id: &str, attempted: &Attempted) -> Result<(), JobError>;

    /// Ends a webhook.
    async fn disable_webhook(&self, id: &str, because: &str) -> Result<(), JobError>;
}
