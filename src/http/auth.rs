//! Authentication by API key, and authorization by the scopes of the key.

use super::audit::Caller;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::router::HttpState;
use super::shares::Origin;
use crate::jobs::{Role, Scope, SecretKey, Tenant};
use axum::extract::FromRequestParts;
use axum::http::header;
use axum::http::request::Parts;

/// Whether requests are authenticated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum AuthMode {
    /// No authentication: every client is the tenant `default` and has every scope.
    None,
    /// API keys are required: `Authorization: Bearer hml_…`.
    Keys,
}

/// The tenant of a request whose key has the scope `read`.
#[derive(Debug, Clone)]
pub(crate) struct Reader(pub(crate) Tenant);

/// The tenant of a request whose key has the scope `submit`.
#[derive(Debug, Clone)]
pub(crate) struct Submitter(pub(crate) Tenant);

/// The tenant of a request whose key has the scope `admin`.
#[derive(Debug, Clone)]
pub(crate) struct Admin(pub(crate) Tenant);

async fn tenant_with(parts: &Parts, state: &HttpState, scope: Scope) -> Result<Tenant, Problem> {
    let origin = Origin::of(&parts.extensions);
    let caller = parts.extensions.get::<Caller>().cloned().unwrap_or_default();
    if state.auth == AuthMode::None {
        caller.is(&Tenant::default(), None);
        state.begin_request(&Tenant::default(), origin)?;
        return Ok(Tenant::default());
    }
    let sent = parts.headers.get(header::AUTHORIZATION).and_then(|value| value.to_str().ok());
    let key = sent.and_then(|sent| {
        let (scheme, key) = sent.split_once(' ')?;
        scheme.eq_ignore_ascii_case("bearer").then(|| SecretKey::parse(key.trim())).flatten()
    });
    let found = match &key {
        Some(key) => state.service.authenticate(key).await?,
        None => None,
    };
    // The answer does not reveal which part of the key was wrong.
    let Some(found) = found else { return Err(Problem::new(ProblemKind::Unauthenticated)) };
    caller.is(&found.tenant, Some(&found.id));
    state.begin_request(&found.tenant, origin)?;
    if !found.scopes.contains(&scope) {
        let (scope, role) = (scope.name(), Role::least_with(scope).name());
        let detail = format!("requires an API key with the scope {scope}, such as one with the role {role}");
        return Err(Problem::new(ProblemKind::ScopeMissing).detail(detail));
    }
    Ok(found.tenant)
}

macro_rules! extracts {
    ($($who:ident needs $scope:ident;)*) => {
        $(impl FromRequestParts<HttpState> for $who {
            type Rejection = Problem;

            async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
                tenant_with(parts, state, Scope::$scope).await.map($who)
            }
        })*
    };
}

extracts! {
    Reader needs Read;
    Submitter needs Submit;
    Admin needs Admin;
}
