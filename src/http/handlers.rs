//! The handlers of all operations, each at the method and the path that its description states.

use super::operations::OPERATIONS;
use super::routes::{
    batches, changes, events, files, jobs, keys, meshes, methods, result, studies, study_scores, study_subjects,
    surfaces, system, tenant_events, tickets, trace, webhooks,
};
use super::service_description::document;
use super::state::HttpState;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

macro_rules! handlers {
    ($($($handler:ident)::+,)*) => {
        /// The handlers with their descriptions.
        fn handlers() -> OpenApiRouter<HttpState> {
            OpenApiRouter::with_openapi(document())$(.routes(routes!($($handler)::+)))*
        }
    };
}

handlers! {
    jobs::submit, jobs::list, jobs::cancel_many, jobs::get, jobs::update, jobs::delete, jobs::cancel,
    jobs::retry, events::events, trace::trace, changes::list, tenant_events::events,
    result::result, result::correspondences, result::transform, result::report, surfaces::surface,
    surfaces::volume, surfaces::aligned, surfaces::warped, files::download,
    batches::submit, batches::list, batches::get, batches::jobs, batches::cancel,
    studies::submit, studies::list, studies::get, studies::update, studies::delete, studies::cancel,
    studies::result, studies::report, studies::archive, study_scores::submit, study_scores::get,
    study_subjects::list, study_subjects::add, study_subjects::decide, study_subjects::undecide,
    meshes::upload, meshes::list, meshes::get, meshes::delete, meshes::content, meshes::surface,
    webhooks::create, webhooks::list, webhooks::get, webhooks::update, webhooks::delete, webhooks::deliveries,
    webhooks::test,
    keys::create, keys::list, keys::get, keys::revoke, tickets::create,
    methods::list, methods::get,
    system::healthz, system::readyz, system::metrics, system::openapi_json, system::problem_type,
}

/// Every route with its description.
pub(super) fn api() -> OpenApiRouter<HttpState> {
    let mut router = handlers();
    OPERATIONS.iter().for_each(|row| row.describe(router.get_openapi_mut()));
    router
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn rows_and_handlers_agree_on_methods_and_paths() {
        let document = handlers().into_openapi();
        let of_handlers: BTreeSet<(String, String)> = document
            .paths
            .paths
            .iter()
            .flat_map(|(path, item)| {
                let item = serde_json::to_value(item).unwrap();
                let methods: Vec<String> = item.as_object().unwrap().keys().map(|m| m.to_uppercase()).collect();
                methods.into_iter().map(|method| (method, path.clone()))
            })
            .collect();
        let of_rows: BTreeSet<(String, String)> =
            OPERATIONS.iter().map(|row| (row.method.to_string(), row.path.to_owned())).collect();
        assert_eq!(of_rows, of_handlers);
        assert_eq!(of_rows.len(), OPERATIONS.len(), "no two rows have one method and path");
        let names: BTreeSet<&str> = OPERATIONS.iter().map(|row| row.name).collect();
        assert_eq!(names.len(), OPERATIONS.len(), "no two rows have one name");
    }
}
