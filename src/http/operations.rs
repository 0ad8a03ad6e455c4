//! The table of all operations, a row each: method, path, name, who may send it, and the parts that it has in common with
//! others. The rights, the audit log, the tickets, the time limits of bodies, and what the OpenAPI document says of parameters
//! and problems follow from the rows.
//!
//! To add an operation, write its handler under `routes`, with its summary, its own parameters and its successful answers in
//! `#[utoipa::path]`, add it to the list in `handlers`, and add a row in the section of its tag and resource:
//!
//! ```text
//! method path                      name        scope   parts
//! POST   "/v1/jobs/{id}/cancel"    cancel_job, Submit, [Accepted, Says(409, "The job is finished")];
//! ```
//!
//! `name` is the `operationId` and the action in the audit log. The scope is `Read`, `Submit`, `Admin` or `Open` (no key). A
//! handler that takes a [`super::call::AuthorizedRequest`] is called only if the sender has the scope. Then run `make api`.

use super::parts::Part::{self, *};
use super::parts::Resource;
use crate::jobs::Scope;
use axum::http::Method;
use std::collections::HashMap;
use std::sync::LazyLock;

/// An operation of the API.
#[derive(Debug)]
pub struct Operation {
    /// Its method; a `GET` also answers `HEAD`.
    pub method: Method,
    /// Its path, with names in braces for the parts that vary.
    pub path: &'static str,
    /// Its `operationId` in the OpenAPI document, and its action in the audit log.
    pub name: &'static str,
    /// The scope that the sender needs; `None` if no key is needed.
    pub scope: Option<Scope>,
    pub(super) tag: &'static str,
    pub(super) resource: Resource,
    pub(super) parts: &'static [Part],
}

macro_rules! scope {
    (Open) => {
        None
    };
    ($scope:ident) => {
        Some(Scope::$scope)
    };
}

macro_rules! operations {
    ($($tag:literal $resource:ident {
        $($method:ident $path:literal $name:ident, $scope:ident, [$($part:expr),*];)*
    })*) => {
        /// All operations.
        pub static OPERATIONS: &[Operation] = &[$($(Operation {
            method: Method::$method,
            path: $path,
            name: stringify!($name),
            scope: scope!($scope),
            tag: $tag,
            resource: Resource::$resource,
            parts: &[$($part),*],
        },)*)*];
    };
}

operations! {
"jobs" Job {
    POST   "/v1/jobs"              submit_job,   Submit, [Files, Form, Idempotent, Accepted, Queue, Slow, Busy, Full,
        Says(400, "The body or the query is malformed"), Says(403, "The API key lacks the scope `submit`"),
        Says(404, "A mesh does not exist"), Says(413, "Larger than a limit of the service"), Says(422, INVALID_SUBMISSION)];
    GET    "/v1/jobs"              list_jobs,    Read,   [Pages("jobs")];
    POST   "/v1/jobs/cancel"       cancel_jobs,  Submit, [Query];
    GET    "/v1/jobs/{id}"         get_job,      Read,   [Watch];
    PATCH  "/v1/jobs/{id}"         update_job,   Submit, [Json, Says(409, "The job is finished")];
    DELETE "/v1/jobs/{id}"         delete_job,   Submit, [Says(409, "The job is not finished")];
    POST   "/v1/jobs/{id}/cancel"  cancel_job,   Submit, [Accepted, Says(409, "The job is finished")];
    POST   "/v1/jobs/{id}/retry"   retry_job,    Submit, [Accepted, Queue, Says(409, "The job is not finished"),
        Says(410, "Its inputs were deleted at the end of their retention time")];
    GET    "/v1/jobs/{id}/events"  follow_job,   Read,   [Follow, Says(400, "Invalid Last-Event-ID")];
    GET    "/v1/jobs/{id}/trace"   get_trace,    Read,   [Query];
    GET    "/v1/changes"           list_changes, Read,   [Query, Polls];
    GET    "/v1/events"            follow_jobs,  Read,   [Follow, Says(400, "Invalid Last-Event-ID or query")];
}
"results" Job {
    GET "/v1/jobs/{id}/result"           get_result,          Read, [Download, Query, Etag, OfResult];
    GET "/v1/jobs/{id}/correspondences"  get_correspondences, Read, [Download, Formats, OfResult, Says(404, NO_INVERSE)];
    GET "/v1/jobs/{id}/transform"        get_transform,       Read, [Download, Uids, Formats, OfResult];
    GET "/v1/jobs/{id}/report"           get_report,          Read, [Download, Formats, OfResult,
        Says(406, "`Accept` allows no HTML")];
    GET "/v1/jobs/{id}/surfaces/{which}" get_surface,         Read, [Download, Surface, Formats, OfResult,
        Says(404, "No such job or surface")];
    GET "/v1/jobs/{id}/volumes/{which}"  get_volume,          Read, [Download, Etag,
        Says(404, "No such job, or its input is a surface"), Says(410, "The inputs were deleted at the end of their retention time")];
    GET "/v1/jobs/{id}/aligned"          get_aligned,         Read, [Download, Surface, Formats, OfResult];
    GET "/v1/jobs/{id}/warped"           get_warped,          Read, [Download, Surface, Uids, Formats, OfResult,
        Says(404, NO_INVERSE)];
    GET "/v1/jobs/{id}/files/{name}"     download_file,       Read, [Download, Query, Uids, Etag, OfResult,
        Says(404, "No such job, no file of this name, or no inverse correspondences"),
        Says(406, "This result cannot be written in this format"), Says(416, "The range is not within the file")];
}
"batches" Batch {
    POST "/v1/batches"             submit_batch,    Submit, [Files, Form, Idempotent, Accepted, Busy, Says(413, TOO_LARGE_BATCH),
        Says(422, "Invalid fields, parameters or meshes, or an Idempotency-Key that was used for another request"),
        Says(429, "The queue has no room for all jobs")];
    GET  "/v1/batches"             list_batches,    Read,   [Pages("entries")];
    GET  "/v1/batches/{id}"        get_batch,       Read,   [Watch];
    GET  "/v1/batches/{id}/jobs"   list_batch_jobs, Read,   [Pages("jobs")];
    POST "/v1/batches/{id}/cancel" cancel_batch,    Submit, [];
}
"studies" Study {
    POST   "/v1/studies"               submit_study,       Submit, [Files, Form, Idempotent, Accepted, Queue, Slow, Full,
        Says(413, TOO_LARGE_STUDY), Says(422, INVALID_SUBMISSION)];
    GET    "/v1/studies"               list_studies,       Read,   [Pages("entries")];
    GET    "/v1/studies/{id}"          get_study,          Read,   [Watch];
    PATCH  "/v1/studies/{id}"          update_study,       Submit, [Json, Says(409, "The study is finished")];
    DELETE "/v1/studies/{id}"          delete_study,       Submit, [
        Says(409, "The study, or a match of it, is not finished")];
    POST   "/v1/studies/{id}/cancel"   cancel_study,       Submit, [Accepted, Says(409, "The study is finished")];
    GET    "/v1/studies/{id}/result"   get_study_result,   Read,   [Download, Etag, OfResult];
    GET    "/v1/studies/{id}/report"   get_study_report,   Read,   [Download, Etag, OfResult];
    GET    "/v1/studies/{id}/archive"  get_study_archive,  Read,   [Download, Etag, OfResult];
    POST   "/v1/studies/{id}/score"    score_study_subject, Submit, [Files, Form, Idempotent, Accepted, Queue, Slow, Busy, Full,
        Says(409, "The study is not finished, or a request with the same Idempotency-Key is in progress"), Says(410, STUDY_GONE),
        Says(413, "Larger than a limit of the service"), Says(415, "Neither multipart nor JSON, or an unknown file format"), Says(422, INVALID_SUBMISSION)];
    GET    "/v1/studies/{id}/scores/{job}" get_study_score, Read, [Download, Etag, OfResult,
        Says(404, "No such job of this study")];
    GET    "/v1/studies/{id}/subjects" list_study_subjects, Read, [Pages("entries"), Says(410, STUDY_GONE)];
    POST   "/v1/studies/{id}/subjects" add_study_subjects, Submit, [Files, Form, Accepted, Queue, Slow,
        Says(410, STUDY_GONE), Says(413, TOO_LARGE_STUDY), Says(422, "Invalid fields or inputs")];
    PUT    "/v1/studies/{id}/subjects/{subject}/decision" decide_study_subject, Submit, [Json, Accepted,
        Says(404, NO_SUBJECT), Says(410, STUDY_GONE)];
    DELETE "/v1/studies/{id}/subjects/{subject}/decision" undecide_study_subject, Submit, [Accepted,
        Says(404, NO_SUBJECT), Says(410, STUDY_GONE)];
}
"meshes" Mesh {
    POST   "/v1/meshes"              upload_mesh,      Submit, [Files, Slow, Busy, Full,
        Says(400, "The body or the query is malformed"), Says(413, "Larger than a limit of the service"),
        Says(415, "Unsupported media type"), Says(422, "An empty body, or a form without a file")];
    GET    "/v1/meshes"              list_meshes,      Read,   [Pages("entries")];
    GET    "/v1/meshes/{id}"         get_mesh,         Read,   [Etag];
    DELETE "/v1/meshes/{id}"         delete_mesh,      Submit, [Says(409, "Jobs refer to it")];
    GET    "/v1/meshes/{id}/content" get_mesh_content, Read,   [Download, Etag, Says(416, "The range is not within the content")];
    GET    "/v1/meshes/{id}/surface" get_mesh_surface, Read,   [Download, Etag,
        Says(413, "The surface is larger than may be matched"),
        Says(415, "There is no surface: the format of the file is not known"),
        Says(422, "There is no surface: the file cannot be read, or no structure is labeled")];
}
"webhooks" Webhook {
    POST   "/v1/webhooks"                 create_webhook,  Admin, [Json,
        Says(409, "The tenant has the maximum number of webhooks")];
    GET    "/v1/webhooks"                 list_webhooks,   Admin, [Pages("entries")];
    GET    "/v1/webhooks/{id}"            get_webhook,     Admin, [];
    PATCH  "/v1/webhooks/{id}"            update_webhook,  Admin, [Json];
    DELETE "/v1/webhooks/{id}"            delete_webhook,  Admin, [];
    GET    "/v1/webhooks/{id}/deliveries" list_deliveries, Admin, [Pages("entries")];
    POST   "/v1/webhooks/{id}/test"       test_webhook,    Admin, [];
}
"keys" Key {
    POST   "/v1/keys"      create_key,    Admin, [Json, Says(409, "The tenant has the maximum number of valid keys")];
    GET    "/v1/keys"      list_keys,     Admin, [Pages("entries")];
    GET    "/v1/keys/{id}" get_key,       Admin, [];
    DELETE "/v1/keys/{id}" revoke_key,    Admin, [];
    POST   "/v1/tickets"   create_ticket, Read,  [Json, Says(422, "No path of a job or an upload")];
}
"methods" Method {
    GET "/v1/methods"        list_methods, Open, [];
    GET "/v1/methods/{name}" get_method,   Open, [];
}
"system" ProblemType {
    GET "/healthz"         healthz,      Open, [];
    GET "/readyz"          readyz,       Open, [
        Says(503, "A dependency does not respond, or the service is shutting down")];
    GET "/metrics"         metrics,      Open, [];
    GET "/openapi.json"    openapi,      Open, [];
    GET "/problems/{slug}" problem_type, Open, [];
}
}

const INVALID_SUBMISSION: &str =
    "Invalid fields, parameters or inputs, or an Idempotency-Key that was used for another request";
const NO_INVERSE: &str = "No such job, or no inverse correspondences";
const NO_SUBJECT: &str = "No such study, or it has no such subject";
const STUDY_GONE: &str = "The study was deleted at the end of its retention time";
const TOO_LARGE_BATCH: &str = "More jobs than a batch can have, or pairs that are too large and otherwise suitable";
const TOO_LARGE_STUDY: &str = "More subjects than a study can have, or a body beyond the limits";

impl Operation {
    /// The operation that answers requests with this method on this route.
    pub(super) fn of(method: &Method, route: &str) -> Option<&'static Operation> {
        static BY_ROUTE: LazyLock<HashMap<(&str, &str), &Operation>> =
            LazyLock::new(|| OPERATIONS.iter().map(|row| ((row.method.as_str(), row.path), row)).collect());
        let method = if method == Method::HEAD { "GET" } else { method.as_str() };
        BY_ROUTE.get(&(method, route)).copied()
    }

    pub(super) fn has(&self, part: Part) -> bool {
        self.parts.contains(&part)
    }

    /// Whether the audit log records it: it may change something, or returns results about a patient or uploads.
    pub(super) fn is_recorded(&self) -> bool {
        self.method != Method::GET || self.has(Download)
    }

    /// Whether it can be sent with a ticket in the query.
    pub(super) fn takes_tickets(&self) -> bool {
        self.has(Download) || self.has(Follow)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_are_found_by_route_and_reading_asks_for_no_more_than_it_needs() {
        assert_eq!(Operation::of(&Method::HEAD, "/v1/jobs/{id}").unwrap().name, "get_job");
        assert!(Operation::of(&Method::PUT, "/v1/jobs/{id}").is_none());
        for row in OPERATIONS {
            assert_eq!(row.scope.is_none(), !row.path.starts_with("/v1/") || row.tag == "methods", "{}", row.name);
            let changes = row.method != Method::GET && row.name != "create_ticket";
            assert!(!changes || matches!(row.scope, Some(Scope::Submit | Scope::Admin)), "{}", row.name);
            assert!(!row.takes_tickets() || row.scope == Some(Scope::Read), "{}: tickets are for reading", row.name);
        }
    }
}
