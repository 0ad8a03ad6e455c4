//! `/v1/methods`: the methods, each with the JSON Schema of its parameters.

use crate::http::problem::Problem;
use crate::http::problem_table::ProblemKind;
use crate::http::state::HttpState;
use crate::jobs::documents::MatchParameters;
use crate::jobs::engine::MethodDescription;
use axum::Json;
use axum::extract::{Path, State};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

/// The available methods.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct MethodListDocument {
    /// The methods, the default one first.
    pub(crate) methods: Vec<MethodDocument>,
}

/// A method, for clients to choose.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct MethodDocument {
    /// Name, as in the parameters.
    pub(crate) name: String,
    /// Version.
    pub(crate) version: String,
    /// One sentence for people.
    pub(crate) description: String,
    /// Effective parameters of a request that states nothing else.
    #[schema(value_type = MatchParameters)]
    pub(crate) defaults: Value,
    /// Where the JSON Schema of its parameters is.
    pub(crate) parameters_schema: SchemaReference,
}

/// A reference to a JSON Schema.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct SchemaReference {
    /// A schema of the OpenAPI document, which has every bound: `/openapi.json#/components/schemas/PartialParameters`.
    #[serde(rename = "$ref")]
    pub(crate) reference: String,
}

impl From<MethodDescription> for MethodDocument {
    fn from(method: MethodDescription) -> Self {
        let MethodDescription { name, version, description, defaults } = method;
        // The presets are values of the same parameters.
        let parameters_schema =
            SchemaReference { reference: "/openapi.json#/components/schemas/PartialParameters".to_owned() };
        MethodDocument { name, version, description, defaults, parameters_schema }
    }
}

/// List methods
#[utoipa::path(
    get, path = "/v1/methods",
    responses((status = 200, description = "All methods, the default first", body = MethodListDocument))
)]
pub(crate) async fn list(State(state): State<HttpState>) -> Json<MethodListDocument> {
    Json(MethodListDocument { methods: state.service.methods().into_iter().map(MethodDocument::from).collect() })
}

/// Get a method
#[utoipa::path(
    get, path = "/v1/methods/{name}",
    responses((status = 200, description = "The method", body = MethodDocument))
)]
pub(crate) async fn get(
    State(state): State<HttpState>,
    Path(name): Path<String>,
) -> Result<Json<MethodDocument>, Problem> {
    let found = state.service.methods().into_iter().find(|method| method.name == name);
    found.map(|method| Json(method.into())).ok_or_else(|| Problem::new(ProblemKind::MethodNotFound))
}
