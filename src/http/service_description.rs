//! The description of the service in the OpenAPI document: title, tags, keys.

use super::problem::ProblemDocument;
use utoipa::openapi::security::{Http, HttpAuthScheme, SecurityRequirement, SecurityScheme};
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
