//! `/v1/webhooks`: notifications of state changes.

use crate::http::call::{AuthorizedRequest, PageOf, WebhookId};
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::state::HttpState;
use crate::jobs::address::check_url;
use crate::jobs::job::Cursor;
use crate::jobs::key::random_secret;
use crate::jobs::{Delivery, DeliveryState, JobState, Webhook};
use axum::Json;
use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use serde_json::json;
use utoipa::ToSchema;

/// Most webhooks of a tenant.
const MAX_WEBHOOKS: u32 = 20;

/// A new webhook.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewWebhookDocument {
    /// URL that events are sent to.
    pub(crate) url: String,
    /// Job states that are reported; all if absent or empty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) states: Vec<JobState>,
}

/// Changes to a webhook; absent members stay as they are.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WebhookChangeDocument {
    /// URL that events are sent to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) url: Option<String>,
    /// Job states that are reported; empty for all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) states: Option<Vec<JobState>>,
    /// Whether events are sent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) enabled: Option<bool>,
}

/// A webhook.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct WebhookDocument {
    /// UUIDv7.
    pub(crate) id: String,
    /// URL that events are sent to.
    pub(crate) url: String,
    /// Job states that are reported; empty for all.
    pub(crate) states: Vec<JobState>,
    /// Whether events are sent.
    pub(crate) enabled: bool,
    /// Why the service disabled it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) disabled_because: Option<String>,
    /// Secret that signs deliveries (Standard Webhooks); only in the answer that created the webhook.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) secret: Option<String>,
    /// When it was created.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// Paths of related resources.
    pub(crate) links: WebhookLinks,
}

/// Paths of the resources of a webhook.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct WebhookLinks {
    /// The webhook.
    #[serde(rename = "self")]
    pub(crate) webhook: String,
    /// Its log of deliveries.
    pub(crate) deliveries: String,
    /// Sends a test event.
    pub(crate) test: String,
}

/// A page of the list of webhooks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct WebhookListDocument {
    /// The webhooks, newest first.
    pub(crate) webhooks: Vec<WebhookDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// The delivery of an event to a webhook.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct DeliveryDocument {
    /// UUIDv7; the receiver sees it as `webhook-id`.
    pub(crate) id: String,
    /// Type of the event, such as `job.succeeded`.
    pub(crate) event: String,
    /// State of the delivery.
    pub(crate) state: DeliveryState,
    /// Attempts so far.
    pub(crate) attempts: u32,
    /// Time of the next attempt, while the delivery is pending.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) next_attempt_at: Option<Timestamp>,
    /// HTTP status of the receiver's last answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) status: Option<u16>,
    /// Why the last attempt failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<String>,
    /// When it was created.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// When it was delivered, or when the service gave up.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) ended_at: Option<Timestamp>,
}

/// A page of the delivery log.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct DeliveryListDocument {
    /// The deliveries, newest first.
    pub(crate) deliveries: Vec<DeliveryDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

impl WebhookDocument {
    fn of(webhook: Webhook, with_secret: bool) -> Self {
        let path = format!("/v1/webhooks/{}", webhook.id);
        WebhookDocument {
            links: WebhookLinks {
                deliveries: format!("{path}/deliveries"),
                test: format!("{path}/test"),
                webhook: path,
            },
            id: webhook.id,
            url: webhook.url,
            states: webhook.states,
            enabled: webhook.is_enabled,
            disabled_because: webhook.disabled_because,
            secret: with_secret.then_some(webhook.secret),
            created_at: webhook.created_at,
        }
    }
}

impl From<Delivery> for DeliveryDocument {
    fn from(delivery: Delivery) -> Self {
        DeliveryDocument {
            next_attempt_at: (delivery.state == DeliveryState::Pending).then_some(delivery.next_at),
            id: delivery.id,
            event: delivery.event,
            state: delivery.state,
            attempts: delivery.attempts,
            status: delivery.status,
            error: delivery.error,
            created_at: delivery.created_at,
            ended_at: delivery.ended_at,
        }
    }
}

fn checked_url(state: &HttpState, url: &str) -> Result<(), Problem> {
    check_url(url, state.limits.allow_private_webhooks).map(|_| ()).map_err(|detail| {
        Problem::new(ProblemKind::InvalidRequest).errors(&[FieldError::new("/url", "out_of_range", detail)])
    })
}

/// Create a webhook
///
/// Each change of a job's state to one of `states` is sent to `url` as a signed POST (Standard Webhooks), and retried with
/// growing delays until the receiver answers 2xx; an answer of 410 disables the webhook. Only the answer to this request
/// contains the secret.
#[utoipa::path(
    post, path = "/v1/webhooks",
    request_body = NewWebhookDocument,
    responses((status = 201, description = "Created", body = WebhookDocument, headers(("Location" = String, description = "The webhook"))))
)]
pub(crate) async fn create(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let NewWebhookDocument { url, states } = call.small_json(request).await?;
    checked_url(&call.state, &url)?;
    let new = Webhook {
        id: uuid::Uuid::now_v7().to_string(),
        tenant: call.tenant,
        url,
        states,
        secret: format!("whsec_{}", BASE64_STANDARD.encode(random_secret().as_bytes())),
        is_enabled: true,
        disabled_because: None,
        created_at: Timestamp::UNIX_EPOCH, // set by the clock of the store
    };
    let Some(made) = call.state.service.webhooks().insert_webhook(&new, MAX_WEBHOOKS).await? else {
        let detail = format!("a tenant can have at most {MAX_WEBHOOKS} webhooks");
        return Err(Problem::new(ProblemKind::TooManyWebhooks).detail(detail));
    };
    let location = [(header::LOCATION, format!("/v1/webhooks/{}", made.id))];
    Ok((StatusCode::CREATED, location, Json(WebhookDocument::of(made, true))).into_response())
}

/// List webhooks
///
/// `fields` selects members of each entry, as in the list of jobs.
#[utoipa::path(
    get, path = "/v1/webhooks",
    responses((status = 200, description = "A page", body = WebhookListDocument))
)]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let PageOf { size, after, fields } = call.last_page::<_, WebhookDocument>(Cursor::from_token)?;
    let page = call.service().webhooks().list_webhooks(&call.tenant, size, after).await?;
    let webhooks = page.webhooks.into_iter().map(|webhook| WebhookDocument::of(webhook, false)).collect();
    let next_page_token = page.next.map(|cursor| cursor.to_token());
    fields.answer(&WebhookListDocument { webhooks, next_page_token }, "webhooks")
}

/// Get a webhook
#[utoipa::path(
    get, path = "/v1/webhooks/{id}",
    responses((status = 200, description = "The webhook", body = WebhookDocument))
)]
pub(crate) async fn get(mut call: AuthorizedRequest) -> Result<Json<WebhookDocument>, Problem> {
    let WebhookId(id) = call.last_id()?;
    Ok(Json(WebhookDocument::of(call.service().webhooks().get_webhook(&call.tenant, &id).await?, false)))
}

/// Update a webhook
///
/// `enabled: true` enables a webhook that the service has disabled.
#[utoipa::path(
    patch, path = "/v1/webhooks/{id}",
    request_body = WebhookChangeDocument,
    responses((status = 200, description = "Updated", body = WebhookDocument))
)]
pub(crate) async fn update(mut call: AuthorizedRequest, request: Request) -> Result<Json<WebhookDocument>, Problem> {
    let WebhookChangeDocument { url, states, enabled } = call.small_json(request).await?;
    if let Some(url) = &url {
        checked_url(&call.state, url)?;
    }
    let store = call.service().webhooks();
    let WebhookId(id) = call.id()?;
    let now = store.get_webhook(&call.tenant, &id).await?;
    let (url, states) = (url.unwrap_or(now.url), states.unwrap_or(now.states));
    let changed = store.update_webhook(&call.tenant, &id, &url, &states, enabled.unwrap_or(now.is_enabled)).await?;
    Ok(Json(WebhookDocument::of(changed, false)))
}

/// Delete a webhook
///
/// Deletes its delivery log too. Pending deliveries are not sent.
#[utoipa::path(delete, path = "/v1/webhooks/{id}", responses((status = 204, description = "Deleted")))]
pub(crate) async fn delete(mut call: AuthorizedRequest) -> Result<StatusCode, Problem> {
    let WebhookId(id) = call.last_id()?;
    call.service().webhooks().delete_webhook(&call.tenant, &id).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// List the deliveries of a webhook
///
/// `fields` selects members of each entry, as in the list of jobs.
#[utoipa::path(
    get, path = "/v1/webhooks/{id}/deliveries",
    responses((status = 200, description = "A page", body = DeliveryListDocument))
)]
pub(crate) async fn deliveries(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let PageOf { size, after, fields } = call.last_page::<_, DeliveryDocument>(Cursor::from_token)?;
    let WebhookId(id) = call.id()?;
    let page = call.service().webhooks().list_deliveries(&call.tenant, &id, size, after).await?;
    let deliveries = page.deliveries.into_iter().map(DeliveryDocument::from).collect();
    let next_page_token = page.next.map(|cursor| cursor.to_token());
    fields.answer(&DeliveryListDocument { deliveries, next_page_token }, "deliveries")
}

/// Test a webhook
///
/// Sends an event `webhook.test`; the delivery log shows the outcome.
#[utoipa::path(
    post, path = "/v1/webhooks/{id}/test",
    responses((status = 202, description = "The delivery is queued", body = DeliveryDocument))
)]
pub(crate) async fn test(mut call: AuthorizedRequest) -> Result<(StatusCode, Json<DeliveryDocument>), Problem> {
    let WebhookId(id) = call.last_id()?;
    let payload =
        json!({"type": "webhook.test", "timestamp": Timestamp::now(), "data": {"webhook_id": id}}).to_string();
    let made = call.service().webhooks().insert_delivery(&call.tenant, &id, "webhook.test", &payload).await?;
    Ok((StatusCode::ACCEPTED, Json(made.into())))
}
