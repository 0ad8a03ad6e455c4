//! `/v1/webhooks`: who is told of changes of jobs.

use super::page;
use crate::http::auth::Admin;
use crate::http::problem::{FieldError, Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::submission::{media_type, read_json};
use crate::http::upload::Tap;
use crate::jobs::address::check_url;
use crate::jobs::key::random_secret;
use crate::jobs::{Delivery, DeliveryState, JobState, Webhook};
use axum::Json;
use axum::extract::{Path, Request, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use jiff::Timestamp;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::json;
use utoipa::ToSchema;

/// Most webhooks of a tenant.
const MAX_WEBHOOKS: u32 = 20;

/// A webhook to be made.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewWebhookDocument {
    /// Where events go.
    pub url: String,
    /// States that are told; all if absent or empty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub states: Vec<JobState>,
}

/// What changes of a webhook; what is absent stays.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct WebhookChangeDocument {
    /// Where events go.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub url: Option<String>,
    /// States that are told; empty for all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub states: Option<Vec<JobState>>,
    /// Whether events are sent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub enabled: Option<bool>,
}

/// A webhook.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct WebhookDocument {
    /// UUIDv7.
    pub id: String,
    /// Where events go.
    pub url: String,
    /// States that are told; empty for all.
    pub states: Vec<JobState>,
    /// Whether events are sent.
    pub enabled: bool,
    /// Why not, if the service ended it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub disabled_because: Option<String>,
    /// What deliveries are signed with (Standard Webhooks); only in the answer that made it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub secret: Option<String>,
    /// When it was made.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
}

/// A part of the list of webhooks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct WebhookListDocument {
    /// The webhooks, the newest first.
    pub webhooks: Vec<WebhookDocument>,
    /// Hand this back as `page_token` for the next page; absent on the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_page_token: Option<String>,
}

/// An event on its way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct DeliveryDocument {
    /// UUIDv7; the receiver sees it as `webhook-id`.
    pub id: String,
    /// Type of the event, such as `job.succeeded`.
    pub event: String,
    /// Where it stands.
    pub state: DeliveryState,
    /// Attempts so far.
    pub attempts: u32,
    /// When it is tried next, while pending.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub next_attempt_at: Option<Timestamp>,
    /// HTTP status of the last answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub status: Option<u16>,
    /// Why there was none, or no good one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
    /// When it was made.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// When it was delivered or given up.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub ended_at: Option<Timestamp>,
}

/// A part of a log of deliveries.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct DeliveryListDocument {
    /// The deliveries, the newest first.
    pub deliveries: Vec<DeliveryDocument>,
    /// Hand this back as `page_token` for the next page; absent on the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_page_token: Option<String>,
}

impl WebhookDocument {
    fn of(webhook: Webhook, with_secret: bool) -> Self {
        WebhookDocument {
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

async fn body<T: DeserializeOwned>(state: &HttpState, request: Request, query: QueryString) -> Result<T, Problem> {
    let (request, tap) = Tap::on(request, 1 << 20);
    let read = async {
        query.finish()?;
        if media_type(&request) != "application/json" {
            return Err(Problem::new(ProblemKind::UnsupportedMediaType));
        }
        read_json(request, &tap, &state.limits).await
    };
    let read = read.await;
    tap.settle(read).await
}

fn checked_url(state: &HttpState, url: &str) -> Result<(), Problem> {
    check_url(url, state.limits.allow_private_webhooks).map(|_| ()).map_err(|detail| {
        Problem::new(ProblemKind::InvalidRequest).errors(&[FieldError::new("/url", "out_of_range", detail)])
    })
}

/// Make a webhook
///
/// Each change of a job's state to one of `states` is sent to `url` as a signed POST (Standard Webhooks), tried again
/// with growing pauses until it is answered 2xx; 410 ends the webhook. The answer holds the secret, once.
#[utoipa::path(
    post, path = "/v1/webhooks", tag = "webhooks", operation_id = "create_webhook",
    request_body = NewWebhookDocument,
    responses(
        (status = 201, description = "Made", body = WebhookDocument, headers(("Location" = String, description = "The webhook"))),
        (status = 400, description = "The body cannot be read", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "As many as a tenant may have", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "No JSON", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Faults in the fields", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn create(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let NewWebhookDocument { url, states } = body(&state, request, query).await?;
    checked_url(&state, &url)?;
    let new = Webhook {
        id: uuid::Uuid::now_v7().to_string(),
        tenant,
        url,
        states,
        secret: format!("whsec_{}", BASE64_STANDARD.encode(random_secret().as_bytes())),
        is_enabled: true,
        disabled_because: None,
        created_at: Timestamp::UNIX_EPOCH, // the store's clock says when
    };
    let Some(made) = state.service.webhooks().insert_webhook(&new, MAX_WEBHOOKS).await? else {
        let detail = format!("a tenant has at most {MAX_WEBHOOKS} webhooks");
        return Err(Problem::new(ProblemKind::TooManyWebhooks).detail(detail));
    };
    let location = [(header::LOCATION, format!("/v1/webhooks/{}", made.id))];
    Ok((StatusCode::CREATED, location, Json(WebhookDocument::of(made, true))).into_response())
}

/// List webhooks
#[utoipa::path(
    get, path = "/v1/webhooks", tag = "webhooks", operation_id = "list_webhooks",
    params(
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Most entries of a page; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the page before"),
    ),
    responses(
        (status = 200, description = "A page", body = WebhookListDocument),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn list(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    mut query: QueryString,
) -> Result<Json<WebhookListDocument>, Problem> {
    let (size, after) = page(&mut query);
    query.finish()?;
    let page = state.service.webhooks().list_webhooks(&tenant, size, after).await?;
    Ok(Json(WebhookListDocument {
        webhooks: page.webhooks.into_iter().map(|webhook| WebhookDocument::of(webhook, false)).collect(),
        next_page_token: page.next.map(|cursor| cursor.to_token()),
    }))
}

/// Look at a webhook
#[utoipa::path(
    get, path = "/v1/webhooks/{id}", tag = "webhooks", operation_id = "get_webhook",
    params(("id" = String, Path, description = "The webhook")),
    responses(
        (status = 200, description = "The webhook", body = WebhookDocument),
        (status = 404, description = "No such webhook", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn get(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<Json<WebhookDocument>, Problem> {
    query.finish()?;
    Ok(Json(WebhookDocument::of(state.service.webhooks().get_webhook(&tenant, &id).await?, false)))
}

/// Change a webhook
///
/// `enabled: true` takes one up again that the service ended.
#[utoipa::path(
    patch, path = "/v1/webhooks/{id}", tag = "webhooks", operation_id = "update_webhook",
    params(("id" = String, Path, description = "The webhook")),
    request_body = WebhookChangeDocument,
    responses(
        (status = 200, description = "Changed", body = WebhookDocument),
        (status = 400, description = "The body cannot be read", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such webhook", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "No JSON", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Faults in the fields", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn update(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    Path(id): Path<String>,
    query: QueryString,
    request: Request,
) -> Result<Json<WebhookDocument>, Problem> {
    let WebhookChangeDocument { url, states, enabled } = body(&state, request, query).await?;
    if let Some(url) = &url {
        checked_url(&state, url)?;
    }
    let store = state.service.webhooks();
    let now = store.get_webhook(&tenant, &id).await?;
    let (url, states) = (url.unwrap_or(now.url), states.unwrap_or(now.states));
    let changed = store.update_webhook(&tenant, &id, &url, &states, enabled.unwrap_or(now.is_enabled)).await?;
    Ok(Json(WebhookDocument::of(changed, false)))
}

/// Delete a webhook
///
/// With its log; what is on its way is not sent any more.
#[utoipa::path(
    delete, path = "/v1/webhooks/{id}", tag = "webhooks", operation_id = "delete_webhook",
    params(("id" = String, Path, description = "The webhook")),
    responses(
        (status = 204, description = "Gone"),
        (status = 404, description = "No such webhook", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn delete(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<StatusCode, Problem> {
    query.finish()?;
    state.service.webhooks().delete_webhook(&tenant, &id).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// List deliveries of a webhook
#[utoipa::path(
    get, path = "/v1/webhooks/{id}/deliveries", tag = "webhooks", operation_id = "list_deliveries",
    params(
        ("id" = String, Path, description = "The webhook"),
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Most entries of a page; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the page before"),
    ),
    responses(
        (status = 200, description = "A page", body = DeliveryListDocument),
        (status = 400, description = "Faults in the query", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such webhook", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn deliveries(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    Path(id): Path<String>,
    mut query: QueryString,
) -> Result<Json<DeliveryListDocument>, Problem> {
    let (size, after) = page(&mut query);
    query.finish()?;
    let page = state.service.webhooks().list_deliveries(&tenant, &id, size, after).await?;
    Ok(Json(DeliveryListDocument {
        deliveries: page.deliveries.into_iter().map(DeliveryDocument::from).collect(),
        next_page_token: page.next.map(|cursor| cursor.to_token()),
    }))
}

/// Try a webhook
///
/// Sends it an event `webhook.test`; its log says what became of it.
#[utoipa::path(
    post, path = "/v1/webhooks/{id}/test", tag = "webhooks", operation_id = "test_webhook",
    params(("id" = String, Path, description = "The webhook")),
    responses(
        (status = 202, description = "On its way", body = DeliveryDocument),
        (status = 404, description = "No such webhook", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn test(
    State(state): State<HttpState>,
    Admin(tenant): Admin,
    Path(id): Path<String>,
    query: QueryString,
) -> Result<(StatusCode, Json<DeliveryDocument>), Problem> {
    query.finish()?;
    let payload =
        json!({"type": "webhook.test", "timestamp": Timestamp::now(), "data": {"webhook_id": id}}).to_string();
    let made = state.service.webhooks().insert_delivery(&tenant, &id, "webhook.test", &payload).await?;
    Ok((StatusCode::ACCEPTED, Json(made.into())))
}
