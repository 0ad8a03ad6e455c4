//! The OpenAPI document: generated from the routes, committed as `api/openapi.json`.

use super::examples;
use super::operations::api;
use super::problem::ProblemDocument;
use crate::jobs::documents::parameter_schemas;
use utoipa::openapi::schema::{KnownFormat, ObjectBuilder, Schema, SchemaFormat, Type};
use utoipa::openapi::security::{Http, HttpAuthScheme, SecurityRequirement, SecurityScheme};
use utoipa::openapi::{Content, RefOr};
use utoipa::{Modify, OpenApi};

#[derive(OpenApi)]
#[openapi(
    info(
        title = "homolog",
        description = "Dense correspondence and rigid registration of anatomical surfaces. \
                       Submit two surfaces, follow the job and its energy trace, get the result.",
        license(name = "MIT OR Apache-2.0", identifier = "MIT OR Apache-2.0"),
    ),
    tags(
        (name = "jobs", description = "Submit, follow, cancel and delete jobs"),
        (name = "batches", description = "Many jobs in one request"),
        (name = "studies", description = "What a group of subjects shows"),
        (name = "meshes", description = "Uploads that jobs refer to by id"),
        (name = "webhooks", description = "Notifications of state changes"),
        (name = "keys", description = "API keys of a tenant"),
        (name = "results", description = "Results of succeeded jobs"),
        (name = "methods", description = "Methods and their parameters"),
        (name = "system", description = "Health, metrics and the description of the API"),
    ),
    components(schemas(ProblemDocument)),
    modifiers(&Keys),
)]
struct Description;

/// API keys, which are required unless the service listens on a loopback address or is started with `--insecure`.
struct Keys;

impl Modify for Keys {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let components = document.components.get_or_insert_default();
        components.add_security_scheme("bearerAuth", SecurityScheme::Http(Http::new(HttpAuthScheme::Bearer)));
        let keys = SecurityRequirement::new("bearerAuth", Vec::<String>::new());
        document.security = Some(vec![keys, SecurityRequirement::default()]);
    }
}

/// The document without its routes.
pub(super) fn document() -> utoipa::openapi::OpenApi {
    Description::openapi()
}

/// Gives the parameters every bound that the service enforces, and gives files a schema that client generators read as
/// a stream of bytes.
fn complete_schemas(document: &mut utoipa::openapi::OpenApi) {
    let schemas = &mut document.components.get_or_insert_default().schemas;
    schemas.extend(parameter_schemas());
    // Without an example the page at /docs would make one up from extreme values.
    if let Some(RefOr::T(Schema::Object(parameters))) = schemas.get_mut("PartialParameters") {
        parameters.example = Some(serde_json::json!({}));
    }
    let file = || {
        let format = SchemaFormat::KnownFormat(KnownFormat::Binary);
        ObjectBuilder::new().schema_type(Type::String).format(Some(format)).build()
    };
    for operation in document.paths.paths.values_mut().filter_map(|item| item.get.as_mut()) {
        for response in operation.responses.responses.values_mut() {
            let RefOr::T(response) = response else { continue };
            for (media_type, content) in &mut response.content {
                let is_text = media_type.starts_with("text/") || media_type.ends_with("json");
                if let (false, RefOr::T(Content { schema, .. })) = (is_text, content) {
                    *schema = Some(file().into());
                }
            }
        }
    }
}

/// The document, pretty-printed, with a final newline.
///
/// # Errors
/// If it cannot be written as JSON.
pub fn openapi_json() -> Result<String, serde_json::Error> {
    let (_, mut document) = api().split_for_parts();
    complete_schemas(&mut document);
    examples::complete(&mut document);
    let mut text = serde_json::to_string_pretty(&document)?;
    text.push('\n');
    Ok(text)
}
