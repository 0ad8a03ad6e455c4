//! Makes the rows of the requests that the audit log records: every operation that may change something, and those that
//! read a result or an upload ([`Operation::is_recorded`]). A row is stored before the answer is sent; a request whose client
//! disconnects earlier is recorded too.

use super::operations::Operation;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::shares::Origin;
use super::state::HttpState;
use crate::jobs::audit::Recorder;
use crate::jobs::{AuditEvent, SecretKey, Tenant};
use axum::extract::Request;
use axum::http::{HeaderMap, header};
use axum::response::{IntoResponse, Response};
use std::sync::{Arc, OnceLock};

/// The sender of a request, once it is authenticated.
#[derive(Debug, Clone, Default)]
pub(super) struct Caller(Arc<OnceLock<(Tenant, Option<String>)>>);

impl Caller {
    /// Notes the tenant and the id of the key.
    pub(super) fn is(&self, tenant: &Tenant, key_id: Option<&str>) {
        let _ = self.0.set((tenant.clone(), key_id.map(str::to_owned)));
    }

    pub(super) fn tenant(&self) -> Option<&str> {
        self.0.get().map(|(tenant, _)| tenant.name())
    }

    pub(super) fn key_id(&self) -> Option<&str> {
        self.0.get().and_then(|(_, key_id)| key_id.as_deref())
    }
}

/// A request that will be recorded, however it ends.
pub(super) struct Recording {
    recorder: Arc<Recorder>,
    is_required: bool,
    caller: Caller,
    event: Option<AuditEvent>,
}

impl Recording {
    /// The recording of a request; `None` if the request is not recorded.
    pub(super) fn of(state: &HttpState, caller: &Caller, request: &Request, route: &str) -> Option<Self> {
        let operation = Operation::of(request.method(), route).filter(|operation| operation.is_recorded())?;
        let event = AuditEvent {
            tenant: None,
            key_id: None,
            action: operation.name.to_owned(),
            resource: resource(route, request.uri().path()),
            address: Origin::of(request.extensions()).address().map(|address| address.to_string()),
            status: None,
        };
        Some(Recording {
            recorder: Arc::clone(state.service.recorder()),
            is_required: state.limits.audit_required,
            caller: caller.clone(),
            event: Some(event),
        })
    }

    fn complete(&self, mut event: AuditEvent) -> AuditEvent {
        event.tenant = self.caller.tenant().and_then(Tenant::new);
        event.key_id = self.caller.key_id().map(str::to_owned);
        event
    }

    /// Stores the row, and returns the answer, or a problem if the row is required and cannot be stored.
    pub(super) async fn end(mut self, response: Response) -> Response {
        let Some(event) = self.event.take() else { return response };
        let mut event = self.complete(event);
        event.status = Some(response.status().as_u16());
        if response.status().is_success()
            && let Some(made) = made(response.headers())
        {
            event.resource = Some(made);
        }
        if self.recorder.record(event).await || !self.is_required {
            return response;
        }
        Problem::new(ProblemKind::Unavailable).detail("the audit log cannot be written").retry_after(5).into_response()
    }
}

impl Drop for Recording {
    fn drop(&mut self) {
        // The client has disconnected: hyper then drops the future of the answer.
        if let (Some(event), Ok(runtime)) = (self.event.take(), tokio::runtime::Handle::try_current()) {
            let _inside = runtime.enter();
            drop(self.recorder.record(self.complete(event)));
        }
    }
}

/// Kind and id of the resource in a path, such as `jobs/019d8a1b-…`. Only text in the form of an id is recorded: a
/// client may write anything into a path.
fn resource(route: &str, path: &str) -> Option<String> {
    let (_, id) = route.split('/').zip(path.split('/')).find(|(part, _)| *part == "{id}")?;
    let id = id.replace("%3A", ":").replace("%3a", ":");
    let is_hash = |text: &str| text.len() == 64 && text.bytes().all(|b| b.is_ascii_hexdigit());
    let is_id = (id.len() == 36 && uuid::Uuid::try_parse(&id).is_ok())
        || id.strip_prefix("blake3:").is_some_and(is_hash)
        || SecretKey::is_id(&id);
    is_id.then(|| format!("{}/{id}", route.split('/').nth(2).unwrap_or_default()))
}

/// The resource that a request has created, from the location in its answer.
fn made(headers: &HeaderMap) -> Option<String> {
    let location = headers.get(header::LOCATION).or_else(|| headers.get(header::CONTENT_LOCATION))?;
    location.to_str().ok()?.strip_prefix("/v1/").map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_ids_are_taken_from_paths() {
        let id = "019d8a1b-2c3d-7e4f-8a5b-000000000001";
        let hash = format!("blake3:{}", "0a".repeat(32));
        let of = |route: &str, last: &str| resource(route, &route.replace("{id}", last));
        assert_eq!(of("/v1/jobs/{id}/result", id), Some(format!("jobs/{id}")));
        assert_eq!(of("/v1/meshes/{id}", &hash), Some(format!("meshes/{hash}")));
        assert_eq!(of("/v1/meshes/{id}", &hash.replace(':', "%3A")), Some(format!("meshes/{hash}")));
        assert_eq!(of("/v1/keys/{id}", "3f9a1c07be52"), Some("keys/3f9a1c07be52".to_owned()));
        for other in ["Doe%5EJane", "19700131", "blake3:Jane", "", &id.replace('-', ""), &format!("{{{id}}}")] {
            assert_eq!(of("/v1/jobs/{id}/result", other), None, "{other}");
        }
        assert_eq!(of("/v1/jobs", ""), None);
    }
}
