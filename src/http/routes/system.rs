//! Liveness, readiness, the OpenAPI document, and what a type of problem means.

use crate::http::openapi;
use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::router::HttpState;
use crate::http::wire::{HealthDocument, ProblemTypeDocument, ReadinessDocument};
use axum::Json;
use axum::extract::{Path, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Whether the process lives
///
/// Touches nothing: a full disk or a slow database is no reason to restart the process.
#[utoipa::path(
    get, path = "/healthz", tag = "system", operation_id = "healthz",
    responses((status = 200, description = "It lives", body = HealthDocument))
)]
pub async fn healthz() -> Json<HealthDocument> {
    Json(HealthDocument { status: "alive".to_owned(), version: env!("CARGO_PKG_VERSION").to_owned() })
}

/// Whether the service can do its work
#[utoipa::path(
    get, path = "/readyz", tag = "system", operation_id = "readyz",
    responses(
        (status = 200, description = "Every dependency answers", body = ReadinessDocument),
        (status = 503, description = "One does not", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn readyz(State(state): State<HttpState>) -> Response {
    let mut ready = !state.stop.is_cancelled();
    let mut dependencies = BTreeMap::new();
    for (name, answer) in state.service.dependencies().await {
        ready &= answer.is_ok();
        dependencies.insert(name.to_owned(), if answer.is_ok() { "ok" } else { "failing" }.to_owned());
    }
    if ready {
        return Json(ReadinessDocument { status: "ready".to_owned(), dependencies }).into_response();
    }
    Problem::new(ProblemKind::Unavailable)
        .retry_after(2)
        .member("dependencies", serde_json::json!(dependencies))
        .into_response()
}

/// Metrics of the process and of the queue
///
/// Text format of Prometheus. Nothing in it names a job, a file or a patient.
#[utoipa::path(
    get, path = "/metrics", tag = "system", operation_id = "metrics",
    responses((status = 200, description = "Metrics", content_type = "text/plain", body = String))
)]
pub async fn metrics(State(state): State<HttpState>) -> Response {
    match state.service.load().await {
        Ok(load) => {
            metrics::gauge!("homolog_jobs", "state" => "queued").set(load.queued);
            metrics::gauge!("homolog_jobs", "state" => "running").set(load.running);
            metrics::gauge!("homolog_queue_oldest_age_seconds").set(load.oldest_queued.as_secs_f64());
            metrics::gauge!("homolog_job_store_up").set(1.0);
        }
        // What the process itself counts is worth having all the more while the store is away.
        Err(_) => metrics::gauge!("homolog_job_store_up").set(0.0),
    }
    let text = (state.metrics)();
    (StatusCode::OK, [(header::CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8")], text).into_response()
}

/// The OpenAPI document
#[utoipa::path(
    get, path = "/openapi.json", tag = "system", operation_id = "openapi",
    responses((status = 200, description = "OpenAPI 3.1", content_type = "application/json", body = Object))
)]
pub async fn openapi_json() -> Result<Response, Problem> {
    // It never changes while the program runs, and making it takes far longer than sending it.
    static DOCUMENT: OnceLock<String> = OnceLock::new();
    let text = match DOCUMENT.get() {
        Some(made) => made,
        None => {
            let made = openapi::openapi_json().map_err(|e| Problem::internal(&e))?;
            DOCUMENT.get_or_init(|| made)
        }
    };
    Ok((StatusCode::OK, [(header::CONTENT_TYPE, "application/json")], text.as_str()).into_response())
}

/// What a type of problem means
#[utoipa::path(
    get, path = "/problems/{slug}", tag = "system", operation_id = "problem_type",
    params(("slug" = String, Path, description = "The last part of a problem's `type`")),
    responses(
        (status = 200, description = "The type", body = ProblemTypeDocument),
        (status = 404, description = "No such type", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub async fn problem_type(Path(slug): Path<String>) -> Result<Json<ProblemTypeDocument>, Problem> {
    let kind = ProblemKind::from_slug(&slug).ok_or_else(|| Problem::new(ProblemKind::ProblemNotFound))?;
    let entry = kind.entry();
    Ok(Json(ProblemTypeDocument {
        r#type: format!("/problems/{}", entry.slug),
        status: entry.status.as_u16(),
        title: entry.title.to_owned(),
        advice: entry.advice.to_owned(),
    }))
}
