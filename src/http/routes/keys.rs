//! `/v1/keys`: API keys of a tenant, managed by its admins.

use crate::http::call::{AuthorizedRequest, KeyId, PageOf, ResourceId as _};
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::jobs::{ApiKey, Role, Scope, SecretKey};
use axum::Json;
use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::time::Duration;
use utoipa::ToSchema;

/// Most valid keys of a tenant.
const MAX_KEYS: u32 = 200;
/// Most characters of a name.
const MAX_NAME: usize = 100;
/// Most days until a key expires.
const MAX_DAYS: u32 = 36_500;

/// A new API key.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewKeyDocument {
    /// What the key allows.
    pub(crate) role: Role,
    /// Note to tell the key by.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schema(max_length = 100)]
    pub(crate) name: String,
    /// Days until the key expires; never if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(minimum = 1, maximum = 36500)]
    pub(crate) expires_days: Option<u32>,
}

/// Whether a key is accepted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum KeyState {
    /// It is.
    Valid,
    /// It was revoked.
    Revoked,
    /// Its time is over.
    Expired,
}

/// An API key.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct KeyDocument {
    /// Its public part: 12 hexadecimal digits.
    pub(crate) id: String,
    /// The role with these scopes; absent if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) role: Option<Role>,
    /// What it allows.
    pub(crate) scopes: Vec<Scope>,
    /// Note to tell the key by.
    pub(crate) name: String,
    /// Whether it is accepted.
    pub(crate) state: KeyState,
    /// The key itself; only in the answer that created it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) key: Option<String>,
    /// When it was created.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// When it expires; never if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) expires_at: Option<Timestamp>,
    /// When it was revoked.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) revoked_at: Option<Timestamp>,
}

/// A page of the list of API keys.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct KeyListDocument {
    /// The keys, newest first.
    pub(crate) keys: Vec<KeyDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

impl KeyDocument {
    fn of(key: ApiKey, secret: Option<&SecretKey>) -> Self {
        KeyDocument {
            role: Role::of_scopes(&key.scopes),
            state: match (key.is_valid, key.revoked_at) {
                (true, _) => KeyState::Valid,
                (false, Some(_)) => KeyState::Revoked,
                (false, None) => KeyState::Expired,
            },
            id: key.id,
            scopes: key.scopes,
            name: key.name,
            key: secret.map(SecretKey::reveal),
            created_at: key.created_at,
            expires_at: key.expires_at,
            revoked_at: key.revoked_at,
        }
    }
}

/// Create an API key
///
/// The key belongs to the tenant of the request. Only the answer to this request contains it; the service stores a hash.
#[utoipa::path(
    post, path = "/v1/keys",
    request_body = NewKeyDocument,
    responses((status = 201, description = "Created", body = KeyDocument, headers(("Location" = String, description = "The key, without its secret"))))
)]
pub(crate) async fn create(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let NewKeyDocument { role, name, expires_days } = call.small_json(request).await?;
    let mut faults = Vec::new();
    if name.chars().count() > MAX_NAME || name.chars().any(char::is_control) {
        let detail = format!("must have at most {MAX_NAME} characters, none of them a control character");
        faults.push(FieldError::new("/name", "out_of_range", detail));
    }
    if expires_days.is_some_and(|days| !(1..=MAX_DAYS).contains(&days)) {
        faults.push(FieldError::new("/expires_days", "out_of_range", format!("must be a number from 1 to {MAX_DAYS}")));
    }
    if !faults.is_empty() {
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&faults));
    }
    let valid_for = expires_days.map(|days| Duration::from_secs(u64::from(days) * 86_400));
    let Some((key, stored)) = call.service().create_key(&call.tenant, &name, role, valid_for, MAX_KEYS).await? else {
        let detail = format!("a tenant can have at most {MAX_KEYS} valid keys");
        return Err(Problem::new(ProblemKind::TooManyKeys).detail(detail));
    };
    // The only answer that contains a secret: no cache may keep it.
    let headers =
        [(header::LOCATION, format!("/v1/keys/{}", key.id())), (header::CACHE_CONTROL, "no-store".to_owned())];
    Ok((StatusCode::CREATED, headers, Json(KeyDocument::of(stored, Some(&key)))).into_response())
}

/// The position in the list that a `page_token` names.
pub(in crate::http) fn cursor(token: &str) -> Option<(i64, String)> {
    let (time, id) = token.split_once('.')?;
    let (time, id) = (i64::from_str_radix(time, 16).ok()?, KeyId::parse(id)?.0);
    // A position has exactly one token.
    (token_of(time, &id) == token).then_some((time, id))
}

/// The `page_token` of a position in the list.
pub(in crate::http) fn token_of(time: i64, id: &str) -> String {
    format!("{time:x}.{id}")
}

/// List API keys
///
/// Those of the tenant of the request, also expired and revoked ones, without their secrets. `fields` selects members of each
/// entry, as in the list of jobs.
#[utoipa::path(get, path = "/v1/keys", responses((status = 200, description = "A page", body = KeyListDocument)))]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let PageOf { size, after, fields } = call.last_page::<_, KeyDocument>(cursor)?;
    let page = call.service().keys(&call.tenant, size, after).await?;
    let keys = page.keys.into_iter().map(|key| KeyDocument::of(key, None)).collect();
    let next_page_token = page.next.map(|(time, id)| token_of(time, &id));
    fields.answer(&KeyListDocument { keys, next_page_token }, "keys")
}

/// Get an API key
#[utoipa::path(
    get, path = "/v1/keys/{id}",
    responses((status = 200, description = "The key, without its secret", body = KeyDocument))
)]
pub(crate) async fn get(mut call: AuthorizedRequest) -> Result<Json<KeyDocument>, Problem> {
    let KeyId(id) = call.last_id()?;
    Ok(Json(KeyDocument::of(call.service().key(&call.tenant, &id).await?, None)))
}

/// Revoke an API key
///
/// Every process refuses it from its next request on. Its record stays, so that the audit log can be read.
#[utoipa::path(delete, path = "/v1/keys/{id}", responses((status = 204, description = "Revoked, now or before")))]
pub(crate) async fn revoke(mut call: AuthorizedRequest) -> Result<StatusCode, Problem> {
    let KeyId(id) = call.last_id()?;
    call.service().revoke_key(&call.tenant, &id).await?;
    Ok(StatusCode::NO_CONTENT)
}
