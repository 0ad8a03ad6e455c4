//! `/v1/methods`: the methods, each with the JSON Schema of its parameters.

use crate::http::problem::{Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::router::HttpState;
use crate::http::wire::{MethodDocument, MethodListDocument};
use axum::Json;
use axum::extract::{Path, State};

/// List methods
#[utoipa::path(
    get, path = "/v1/methods", tag = "methods", operation_id = "list_methods",
    responses((status = 200, description = "All methods, the default first", body = MethodListDocument))
)]
pub(crate) async fn list(State(state): State<HttpState>) -> Json<MethodListDocument> {
    Json(MethodListDocument { methods: state.service.methods().into_iter().map(MethodDocument::from).collect() })
}

/// Get a method
#[utoipa::path(
    get, path = "/v1/methods/{name}", tag = "methods", operation_id = "get_method",
    params(("name" = String, Path, description = "The method")),
    responses(
        (status = 200, description = "The method", body = MethodDocument),
        (status = 404, description = "No such method", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn get(
    State(state): State<HttpState>,
    Path(name): Path<String>,
) -> Result<Json<MethodDocument>, Problem> {
    let found = state.service.methods().into_iter().find(|method| method.name == name);
    found.map(|method| Json(method.into())).ok_or_else(|| Problem::new(ProblemKind::MethodNotFound))
}
