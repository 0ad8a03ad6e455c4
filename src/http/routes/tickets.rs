//! `/v1/tickets`: permissions for browsers to read one resource for a minute.

use crate::http::call::AuthorizedRequest;
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::ticketed::is_path_for_tickets;
use crate::jobs::{MAX_TICKETS, TICKET_LASTS, Ticket};
use axum::Json;
use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// What a ticket is to permit.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewTicketDocument {
    /// `/v1/events`, or the path of a job or an upload, or of its events or a download below it.
    #[schema(max_length = 200, example = "/v1/jobs/019d8a1b-2c3d-7e4f-8a5b-000000000001/events")]
    pub(crate) path: String,
}

/// A ticket.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct TicketDocument {
    /// To be sent as `?ticket=`.
    pub(crate) ticket: String,
    /// The path that can be read with it, and those below it.
    pub(crate) path: String,
    /// How long it is accepted, s. Streams that have begun go on.
    pub(crate) expires_in_s: u32,
}

/// Create a ticket
///
/// For `EventSource` and links of a browser, which send no `Authorization` header: the events of all jobs (`/v1/events`) or of a job and the downloads of a job
/// or an upload below `path` can then be read with `?ticket=` instead. A ticket is valid for 60 s and for reading only, and
/// ends with the API key that asked for it.
#[utoipa::path(
    post, path = "/v1/tickets",
    request_body = NewTicketDocument,
    responses((status = 201, description = "Created", body = TicketDocument))
)]
pub(crate) async fn create(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let NewTicketDocument { path } = call.small_json(request).await?;
    if !is_path_for_tickets(&path) {
        let detail = "must be /v1/events, or the path of a job or an upload, or of its events or a download below it, without a query";
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[FieldError::new(
            "/path",
            "out_of_range",
            detail,
        )]));
    }
    let key_id = call.rights.key_id().map(str::to_owned);
    let ticket = Ticket { tenant: call.tenant, key_id, path };
    let Some(text) = call.state.service.create_ticket(&ticket).await? else {
        let detail = format!("at most {MAX_TICKETS} tickets of a tenant at the same time");
        return Err(Problem::new(ProblemKind::TooManyRequests)
            .detail(detail)
            .retry_after(TICKET_LASTS.as_secs() as u32));
    };
    let answer = TicketDocument { ticket: text, path: ticket.path, expires_in_s: TICKET_LASTS.as_secs() as u32 };
    Ok((StatusCode::CREATED, [(header::CACHE_CONTROL, "no-store")], Json(answer)).into_response())
}
