//! Authentication by API key, by a token of an OpenID Connect provider or by a ticket, and authorization by the scopes of either.

use super::audit::Caller;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::router::HttpState;
use super::shares::Origin;
use super::ticketed::ticket_of;
use super::tokens::{Bearer, TokenFault};
use crate::jobs::{Role, Scope, SecretKey, Tenant, Ticket};
use axum::extract::FromRequestParts;
use axum::http::header;
use axum::http::request::Parts;

/// Whether requests are authenticated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum AuthMode {
    /// No authentication: every client is the tenant `default` and has every scope.
    None,
    /// API keys are required, `Authorization: Bearer hml_…`, or tokens where a provider is set.
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

/// Who sends a request, and what they may do.
struct Identity {
    tenant: Tenant,
    id: String,
    scopes: Vec<Scope>,
}

/// The owner of an API key or of a token of the OpenID Connect provider.
async fn identity(bearer: &str, state: &HttpState) -> Result<Identity, Problem> {
    let unauthenticated = || Problem::new(ProblemKind::Unauthenticated);
    if let Some(key) = SecretKey::parse(bearer) {
        let found = state.service.authenticate(&key).await?.ok_or_else(unauthenticated)?;
        return Ok(Identity { tenant: found.tenant, id: found.id, scopes: found.scopes });
    }
    let Some(tokens) = &state.tokens else { return Err(unauthenticated()) };
    match tokens.verify(bearer).await {
        Ok(Bearer { tenant, role, id }) => Ok(Identity { tenant, id, scopes: role.scopes().to_vec() }),
        Err(TokenFault::Invalid) => Err(unauthenticated()),
        Err(TokenFault::NoRole) => {
            let detail = "the token names no role of this service, or no tenant";
            Err(Problem::new(ProblemKind::ScopeMissing).detail(detail))
        }
        Err(TokenFault::Unavailable) => {
            let detail = "the keys of the OpenID Connect provider cannot be read";
            Err(Problem::new(ProblemKind::Unavailable).detail(detail).retry_after(5))
        }
    }
}

async fn tenant_with(parts: &Parts, state: &HttpState, scope: Scope) -> Result<Tenant, Problem> {
    let origin = Origin::of(&parts.extensions);
    let caller = parts.extensions.get::<Caller>().cloned().unwrap_or_default();
    if state.auth == AuthMode::None {
        caller.is(&Tenant::default(), None);
        state.begin_request(&Tenant::default(), origin)?;
        return Ok(Tenant::default());
    }
    let sent = parts.headers.get(header::AUTHORIZATION).and_then(|value| value.to_str().ok());
    let bearer = sent.and_then(|sent| {
        let (scheme, bearer) = sent.split_once(' ')?;
        scheme.eq_ignore_ascii_case("bearer").then(|| bearer.trim())
    });
    if sent.is_none()
        && scope == Scope::Read
        && let Some(Ticket { tenant, key_id, .. }) = ticket_of(parts, state).await?
    {
        caller.is(&tenant, key_id.as_deref());
        state.begin_request(&tenant, origin)?;
        return Ok(tenant);
    }
    // The answer does not reveal which part of a key or a token was wrong.
    let Some(bearer) = bearer else { return Err(Problem::new(ProblemKind::Unauthenticated)) };
    let found = identity(bearer, state).await?;
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
