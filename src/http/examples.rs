//! Examples of bodies in the OpenAPI document, and the errors that any operation can answer.
//!
//! JSON examples are files under `api/examples`, taken from a real run; a test validates each against its schema.

use super::operation_description as description;
use super::operations::{OPERATIONS, Operation};
use super::problem_table::ProblemKind;
use super::ticketed::TICKET;
use axum::http::StatusCode;
use serde_json::{Value, json};
use utoipa::openapi::path::{Operation as Described, ParameterBuilder, ParameterIn};
use utoipa::openapi::request_body::RequestBody;
use utoipa::openapi::schema::{Object, Type};
use utoipa::openapi::{Content, OpenApi, RefOr, Required};

macro_rules! file {
    ($name:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/api/examples/", $name))
    };
}

/// Operation id, media type and example of a request body.
const REQUESTS: &[(&str, &str, &str)] = &[
    ("submit_job", "multipart/form-data", file!("submission.json")),
    ("submit_job", "application/json", file!("submission_by_reference.json")),
    ("submit_batch", "application/json", file!("batch_submission.json")),
    ("submit_batch", "multipart/form-data", file!("batch_form.json")),
    ("submit_study", "application/json", file!("study_submission.json")),
    ("submit_study", "multipart/form-data", file!("study_form.json")),
    ("update_study", "application/json", file!("study_change.json")),
    ("add_study_subjects", "application/json", file!("study_subjects.json")),
    ("add_study_subjects", "multipart/form-data", file!("study_subjects_form.json")),
    ("decide_study_subject", "application/json", file!("study_decision.json")),
    ("score_study_subject", "application/json", file!("study_score_submission.json")),
    ("score_study_subject", "multipart/form-data", file!("study_score_form.json")),
    ("create_webhook", "application/json", file!("webhook_submission.json")),
    ("update_job", "application/json", file!("job_change.json")),
    ("update_webhook", "application/json", file!("webhook_change.json")),
    ("create_key", "application/json", file!("key_submission.json")),
    ("create_ticket", "application/json", file!("ticket_submission.json")),
    ("upload_mesh", "multipart/form-data", r#"{"file": "(binary content of a file)"}"#),
    ("upload_mesh", "application/octet-stream", r#""(binary content of a file)""#),
];
/// Operation id and example of its JSON answer.
const ANSWERS: &[(&str, &str)] = &[
    ("submit_job", file!("job_queued.json")),
    ("list_jobs", file!("job_list.json")),
    ("get_job", file!("job_running.json")),
    ("update_job", file!("job_queued.json")),
    ("cancel_job", file!("job_cancelled.json")),
    ("cancel_jobs", file!("bulk_cancel.json")),
    ("retry_job", file!("job_retry.json")),
    ("list_changes", file!("changes.json")),
    ("submit_batch", file!("batch.json")),
    ("get_batch", file!("batch.json")),
    ("list_batches", file!("batch_list.json")),
    ("list_batch_jobs", file!("job_list.json")),
    ("cancel_batch", file!("bulk_cancel.json")),
    ("submit_study", file!("study_queued.json")),
    ("list_studies", file!("study_list.json")),
    ("get_study", file!("study.json")),
    ("list_study_subjects", file!("study_subject_list.json")),
    ("cancel_study", file!("study_queued.json")),
    ("update_study", file!("study_queued.json")),
    ("add_study_subjects", file!("study_queued.json")),
    ("decide_study_subject", file!("study_queued.json")),
    ("undecide_study_subject", file!("study_queued.json")),
    ("get_study_result", file!("study_result.json")),
    ("score_study_subject", file!("study_score_job.json")),
    ("get_study_score", file!("study_score.json")),
    ("upload_mesh", file!("mesh.json")),
    ("get_mesh", file!("mesh.json")),
    ("list_meshes", file!("mesh_list.json")),
    ("create_webhook", file!("webhook_created.json")),
    ("get_webhook", file!("webhook.json")),
    ("update_webhook", file!("webhook.json")),
    ("list_webhooks", file!("webhook_list.json")),
    ("list_deliveries", file!("delivery_list.json")),
    ("test_webhook", file!("delivery.json")),
    ("create_key", file!("key_created.json")),
    ("create_ticket", file!("ticket.json")),
    ("get_key", file!("key.json")),
    ("list_keys", file!("key_list.json")),
    ("get_trace", file!("trace.json")),
    ("get_result", file!("result.json")),
    ("get_correspondences", file!("correspondences.json")),
    ("get_transform", file!("transform.json")),
    ("list_methods", file!("method_list.json")),
    ("get_method", file!("method.json")),
    ("healthz", file!("healthz.json")),
    ("readyz", file!("readyz.json")),
];
/// Examples of text bodies, by media type.
const TEXTS: &[(&str, &str)] = &[
    (
        "text/event-stream",
        "event: trace\nid: 7\ndata: {\"seq\":7,\"round\":0,\"phase\":\"inference\",\"iteration\":7,\"elapsed_ms\":410}\n\n",
    ),
    ("text/html", "<!doctype html>\n<html lang=\"en\">...</html>\n"),
];
/// Example of the events of all jobs.
const CHANGES: &str = "event: change\nid: 12\ndata: {\"seq\":12,\"job_id\":\"019d8a1b-2c3d-7e4f-8a5b-000000000001\",\
     \"state\":\"running\",\"at\":\"2026-11-22T08:00:00Z\"}\n\n";
/// Errors that any operation can answer.
const ALWAYS: [(StatusCode, &str); 6] = [
    (StatusCode::BAD_REQUEST, "The path or the query is malformed"),
    (StatusCode::UNAUTHORIZED, "No valid API key"),
    (
        StatusCode::FORBIDDEN,
        "The Host or Origin header names a host that is not allowed, or the API key lacks the scope",
    ),
    (StatusCode::TOO_MANY_REQUESTS, "The tenant sends too many requests"),
    (StatusCode::INTERNAL_SERVER_ERROR, "Internal error"),
    (StatusCode::SERVICE_UNAVAILABLE, "A dependency does not respond, or not in time"),
];
const PROBLEM: &str = super::problem::PROBLEM_JSON;

/// Adds examples and common errors to every operation.
pub(super) fn complete(document: &mut OpenApi) {
    for row in OPERATIONS {
        if let Some(described) = row.described(document) {
            complete_operation(row, described);
        }
    }
}

fn complete_operation(row: &Operation, operation: &mut Described) {
    let name = row.name;
    let named = |table: &[(&str, &str)]| {
        let found = table.iter().find(|(operation, _)| *operation == name);
        found.and_then(|(_, text)| serde_json::from_str::<Value>(text).ok())
    };
    if let Some(RefOr::T(RequestBody { content, .. })) = &mut operation.request_body {
        for (media_type, content) in content {
            let found = REQUESTS.iter().find(|(operation, kind, _)| *operation == name && kind == media_type);
            set(content, found.and_then(|(_, _, text)| serde_json::from_str(text).ok()));
        }
    }
    if row.takes_tickets() {
        let ticket = ParameterBuilder::new()
            .name(TICKET)
            .parameter_in(ParameterIn::Query)
            .required(Required::False)
            .schema(Some(Object::with_type(Type::String)))
            .description(Some("A ticket of `/v1/tickets`, instead of an API key"));
        description::add(operation, ticket.build());
    }
    for (status, description) in ALWAYS {
        if [StatusCode::UNAUTHORIZED, StatusCode::TOO_MANY_REQUESTS].contains(&status) && row.scope.is_none() {
            continue;
        }
        description::problem(operation, status.as_u16(), description);
    }
    for (status, response) in &mut operation.responses.responses {
        let RefOr::T(response) = response else { continue };
        let status = status.parse().unwrap_or(StatusCode::OK);
        for (media_type, content) in &mut response.content {
            let example = match media_type.as_str() {
                PROBLEM => Some(problem(typical(row, status))),
                "application/json" if name == "problem_type" => Some(problem_type()),
                "text/plain" if name == "metrics" => Some(json!("homolog_jobs{state=\"queued\"} 3\n")),
                "text/event-stream" if name == "follow_jobs" => Some(json!(CHANGES)),
                "application/json" => named(ANSWERS),
                text => TEXTS.iter().find(|(kind, _)| *kind == text).map(|(_, text)| json!(text)),
            };
            set(content, example);
        }
    }
}

fn set(content: &mut RefOr<Content>, example: Option<Value>) {
    if let (RefOr::T(content), Some(example)) = (content, example)
        && content.example.is_none()
    {
        content.example = Some(example);
    }
}

/// The most common problem with this status in this operation.
fn typical(row: &Operation, status: StatusCode) -> ProblemKind {
    match (row.name, status) {
        (_, StatusCode::NOT_FOUND) => row.resource.not_found(),
        (_, StatusCode::UNAUTHORIZED) => ProblemKind::Unauthenticated,
        (_, StatusCode::GONE) => ProblemKind::Expired,
        (_, StatusCode::REQUEST_TIMEOUT) => ProblemKind::UploadTimeout,
        ("delete_mesh", StatusCode::CONFLICT) => ProblemKind::MeshInUse,
        ("create_webhook", StatusCode::CONFLICT) => ProblemKind::TooManyWebhooks,
        ("create_key", StatusCode::CONFLICT) => ProblemKind::TooManyKeys,
        ("submit_job" | "submit_batch" | "submit_study", StatusCode::CONFLICT) => ProblemKind::IdempotencyKeyInProgress,
        ("cancel_study" | "update_study", StatusCode::CONFLICT) => ProblemKind::StudyFinished,
        ("delete_study", StatusCode::CONFLICT) => ProblemKind::StudyActive,
        (name, StatusCode::CONFLICT) if name.contains("study") => ProblemKind::StudyNotReady,
        (name, StatusCode::UNPROCESSABLE_ENTITY) if name.contains("study") => ProblemKind::InvalidRequest,
        ("retry_job", StatusCode::CONFLICT) => ProblemKind::JobActive,
        ("submit_batch", StatusCode::UNPROCESSABLE_ENTITY) => ProblemKind::UnsuitableBatch,
        (
            "create_webhook" | "update_webhook" | "create_key" | "create_ticket" | "upload_mesh",
            StatusCode::UNPROCESSABLE_ENTITY,
        ) => ProblemKind::InvalidRequest,
        ("submit_job", StatusCode::BAD_REQUEST) => ProblemKind::MalformedMultipart,
        (_, StatusCode::BAD_REQUEST) => ProblemKind::InvalidQuery,
        (_, StatusCode::FORBIDDEN) => ProblemKind::HostNotAllowed,
        ("cancel_job" | "update_job", StatusCode::CONFLICT) => ProblemKind::JobFinished,
        ("get_mesh_surface", StatusCode::UNPROCESSABLE_ENTITY) => ProblemKind::EmptyStructure,
        ("update_job", StatusCode::UNPROCESSABLE_ENTITY) => ProblemKind::InvalidRequest,
        ("delete_job", StatusCode::CONFLICT) => ProblemKind::JobActive,
        (_, StatusCode::CONFLICT) => ProblemKind::ResultNotReady,
        (_, StatusCode::PAYLOAD_TOO_LARGE) => ProblemKind::TooLarge,
        (_, StatusCode::UNSUPPORTED_MEDIA_TYPE) => ProblemKind::UnknownFormat,
        (_, StatusCode::UNPROCESSABLE_ENTITY) => ProblemKind::InvalidParameters,
        ("get_job" | "get_batch" | "list_changes" | "follow_job" | "follow_jobs", StatusCode::TOO_MANY_REQUESTS) => {
            ProblemKind::TooManyStreams
        }
        (
            "submit_job" | "submit_batch" | "submit_study" | "add_study_subjects" | "retry_job",
            StatusCode::TOO_MANY_REQUESTS,
        ) => ProblemKind::QueueFull,
        (_, StatusCode::TOO_MANY_REQUESTS) => ProblemKind::TooManyRequests,
        ("submit_job", StatusCode::SERVICE_UNAVAILABLE) => ProblemKind::Busy,
        (_, StatusCode::INSUFFICIENT_STORAGE) => ProblemKind::StorageFull,
        (_, status) => ProblemKind::from_status(status),
    }
}

fn problem(kind: ProblemKind) -> Value {
    let entry = kind.entry();
    let mut body = json!({
        "type": format!("/problems/{}", entry.slug), "title": entry.title, "status": entry.status.as_u16(),
        "request_id": "01a1fd75-113e-74d9-9ded-f0dd4fe414eb",
    });
    let error = |pointer: &str, code: &str, detail: &str| json!([{"pointer": pointer, "code": code, "detail": detail}]);
    match kind {
        ProblemKind::InvalidParameters => {
            let detail = "must be a number from 0 to 100";
            body["errors"] = error("/parameters/energy/alpha", "out_of_range", detail);
        }
        ProblemKind::InvalidQuery => {
            body["errors"] = error("/query/wait", "out_of_range", "must be a number from 0 to 30");
        }
        ProblemKind::ResultNotReady | ProblemKind::JobActive => body["state"] = json!("running"),
        ProblemKind::JobFinished => body["state"] = json!("succeeded"),
        ProblemKind::TooLarge => body["input"] = json!("source"),
        _ => {}
    }
    body
}

fn problem_type() -> Value {
    let entry = ProblemKind::QueueFull.entry();
    json!({
        "type": format!("/problems/{}", entry.slug), "status": entry.status.as_u16(), "title": entry.title,
        "advice": entry.advice,
    })
}
