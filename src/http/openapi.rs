//! The OpenAPI document: generated from the routes, committed as `api/openapi.json`.

use super::examples;
use super::handlers::api;
use crate::jobs::documents::parameter_schemas;
use utoipa::openapi::schema::{KnownFormat, ObjectBuilder, Schema, SchemaFormat, Type};
use utoipa::openapi::{Content, RefOr};

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
