//! Liveness, readiness, metrics, the OpenAPI document and the problem types.

use crate::http::problem::Problem;
use crate::http::problem_table::ProblemKind;
use crate::http::state::HttpState;
use crate::http::wire::{HealthDocument, ProblemTypeDocument, ReadinessDocument};
use crate::jobs::JobError;
use axum::Json;
use axum::extract::{Path, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Check liveness
///
/// Queries no dependency: a full disk or a slow database is no reason to restart the process.
#[utoipa::path(
    get, path = "/healthz",
    responses((status = 200, description = "The process is alive", body = HealthDocument))
)]
pub(crate) async fn healthz() -> Json<HealthDocument> {
    Json(HealthDocument { status: "alive".to_owned(), version: env!("CARGO_PKG_VERSION").to_owned() })
}

/// Check readiness
#[utoipa::path(
    get, path = "/readyz",
    responses((status = 200, description = "All dependencies respond", body = ReadinessDocument))
)]
pub(crate) async fn readyz(State(state): State<HttpState>) -> Response {
    let mut ready = !state.stop.is_cancelled();
    let mut dependencies = BTreeMap::new();
    for (name, answer) in state.service.dependencies().await {
        ready &= answer.is_ok();
        let word = match answer {
            Ok(()) => "ok",
            Err(JobError::StorageFull) => "full",
            Err(_) => "failing",
        };
        dependencies.insert(name.to_owned(), word.to_owned());
    }
    // A jumped clock does not make the service unready: results are kept longer, and no deadline counts.
    let clock = if state.service.has_clock_jumped() { "jumped" } else { "ok" };
    dependencies.insert("clock".to_owned(), clock.to_owned());
    if ready {
        return Json(ReadinessDocument { status: "ready".to_owned(), dependencies }).into_response();
    }
    Problem::new(ProblemKind::Unavailable)
        .retry_after(2)
        .member("dependencies", serde_json::json!(dependencies))
        .into_response()
}

/// Get metrics
///
/// Metrics of the process and the queue in the text format of Prometheus. They name no job, file or patient.
#[utoipa::path(
    get, path = "/metrics",
    responses((status = 200, description = "Metrics", content_type = "text/plain", body = String))
)]
pub(crate) async fn metrics(State(state): State<HttpState>) -> Response {
    match state.service.load().await {
        Ok(load) => {
            metrics::gauge!("homolog_jobs", "state" => "queued").set(load.queued);
            metrics::gauge!("homolog_jobs", "state" => "running").set(load.running);
            metrics::gauge!("homolog_queue_oldest_age_seconds").set(load.oldest_queued.as_secs_f64());
            metrics::gauge!("homolog_workers", "state" => "busy").set(load.busy_workers);
            metrics::gauge!("homolog_workers", "state" => "idle").set(load.idle_workers);
            metrics::gauge!("homolog_job_store_up").set(1.0);
        }
        // The metrics of the process itself are needed most while the store does not respond.
        Err(_) => metrics::gauge!("homolog_job_store_up").set(0.0),
    }
    let text = (state.metrics)();
    (StatusCode::OK, [(header::CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8")], text).into_response()
}

/// Get the OpenAPI document
#[utoipa::path(
    get, path = "/openapi.json",
    responses((status = 200, description = "OpenAPI 3.1", content_type = "application/json", body = Object))
)]
pub(crate) async fn openapi_json(State(state): State<HttpState>) -> Result<Response, Problem> {
    // The document never changes while the program runs, and generating it takes far longer than sending it.
    static DOCUMENT: OnceLock<String> = OnceLock::new();
    let text = match DOCUMENT.get() {
        Some(made) => made,
        None => {
            let made = (state.document)().map_err(|e| Problem::internal(&e))?;
            DOCUMENT.get_or_init(|| made)
        }
    };
    Ok((StatusCode::OK, [(header::CONTENT_TYPE, "application/json")], text.as_str()).into_response())
}

/// Get a problem type
#[utoipa::path(
    get, path = "/problems/{slug}",
    responses((status = 200, description = "The problem type", body = ProblemTypeDocument))
)]
pub(crate) async fn problem_type(Path(slug): Path<String>) -> Result<Json<ProblemTypeDocument>, Problem> {
    let kind = ProblemKind::from_slug(&slug).ok_or_else(|| Problem::new(ProblemKind::ProblemNotFound))?;
    let entry = kind.entry();
    Ok(Json(ProblemTypeDocument {
        r#type: format!("/problems/{}", entry.slug),
        status: entry.status.as_u16(),
        title: entry.title.to_owned(),
        advice: entry.advice.to_owned(),
    }))
}
