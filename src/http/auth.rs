//! Authentication by API key, by a token of an OpenID Connect provider or by a ticket, and authorization by their
//! scopes.
//!
//! A long answer, such as an event stream or a long poll, checks the rights again ([`Rights`]): a key may be revoked in
//! the meantime, and a token may expire.

use super::audit::Caller;
use super::auth_mode::AuthMode;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::shares::Origin;
use super::state::HttpState;
use super::ticketed::ticket_of;
use super::tokens::{Bearer, TokenFault};
use crate::jobs::{Role, Scope, SecretKey, Tenant, Ticket};
use axum::http::header;
use axum::http::request::Parts;
use std::time::Duration;
use tokio::time::{Instant, sleep_until};

/// Longest duration of a stream that was opened with a ticket of a token's owner. The token is not kept, so its
/// validity cannot be checked again.
const LONGEST_BY_TOKEN: Duration = Duration::from_secs(3_600);

/// The sender of a request, and its rights.
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

/// The tenant of a request whose sender has this scope.
///
/// # Errors
/// `unauthenticated`, `scope-missing`, `too-many-requests`, or a store that does not answer.
pub(super) async fn tenant_with(parts: &Parts, state: &HttpState, scope: Scope) -> Result<Tenant, Problem> {
    let origin = Origin::of(&parts.extensions);
    let caller = parts.extensions.get::<Caller>().cloned().unwrap_or_default();
    if state.auth == AuthMode::None {
        caller.is(&Tenant::default(), None);
        state.begin_request(&Tenant::default(), origin)?;
        return Ok(Tenant::default());
    }
    if !parts.headers.contains_key(header::AUTHORIZATION)
        && scope == Scope::Read
        && let Some(Ticket { tenant, key_id, .. }) = ticket_of(parts, state).await?
    {
        caller.is(&tenant, key_id.as_deref());
        state.begin_request(&tenant, origin)?;
        return Ok(tenant);
    }
    // The answer does not reveal which part of a key or a token is wrong.
    let Some(bearer) = bearer(parts) else { return Err(Problem::new(ProblemKind::Unauthenticated)) };
    let found = identity(bearer, state).await?;
    caller.is(&found.tenant, Some(&found.id));
    state.begin_request(&found.tenant, origin)?;
    found.require(scope)?;
    Ok(found.tenant)
}

/// The key or the token of a request.
fn bearer(parts: &Parts) -> Option<&str> {
    let (scheme, bearer) = parts.headers.get(header::AUTHORIZATION)?.to_str().ok()?.split_once(' ')?;
    scheme.eq_ignore_ascii_case("bearer").then(|| bearer.trim())
}

impl Identity {
    fn require(&self, scope: Scope) -> Result<(), Problem> {
        if self.scopes.contains(&scope) {
            return Ok(());
        }
        let (scope, role) = (scope.name(), Role::least_with(scope).name());
        let detail = format!("requires an API key with the scope {scope}, such as one with the role {role}");
        Err(Problem::new(ProblemKind::ScopeMissing).detail(detail))
    }
}

/// The credentials of a request, for further checks while its answer continues.
#[derive(Clone)]
pub(crate) struct Rights {
    state: HttpState,
    bearer: Option<String>,
    caller: Caller,
    began: Instant,
    /// When the rights must be checked again at the latest.
    due: Instant,
}

impl Rights {
    /// The credentials of a request.
    pub(super) fn of(parts: &Parts, state: &HttpState) -> Self {
        Rights {
            state: state.clone(),
            bearer: bearer(parts).map(str::to_owned),
            caller: parts.extensions.get::<Caller>().cloned().unwrap_or_default(),
            began: Instant::now(),
            due: Instant::now() + state.limits.access_interval,
        }
    }

    /// The id of the key, if it has one.
    pub(super) fn key_id(&self) -> Option<&str> {
        self.caller.key_id()
    }

    /// Checks that the caller still has `scope` in the tenant of the request. One query.
    ///
    /// # Errors
    /// As for a new request; `unavailable` if the rights cannot be determined now.
    pub(super) async fn ask(&self, scope: Scope) -> Result<(), Problem> {
        if self.state.auth == AuthMode::None {
            return Ok(());
        }
        let unauthenticated = || Problem::new(ProblemKind::Unauthenticated);
        if let Some(bearer) = &self.bearer {
            let found = identity(bearer, &self.state).await?;
            let is_of_tenant = self.caller.tenant() == Some(found.tenant.name());
            return if is_of_tenant { found.require(scope) } else { Err(unauthenticated()) };
        }
        // A ticket is valid for a minute, in which a stream may begin. A running stream depends on the rights of the
        // owner who requested the ticket.
        let is_valid = match self.caller.key_id() {
            None => true,
            Some(id) if SecretKey::is_id(id) => self.state.service.is_key_valid(id).await?,
            Some(_) => self.began.elapsed() < LONGEST_BY_TOKEN,
        };
        if is_valid { Ok(()) } else { Err(unauthenticated()) }
    }

    /// Whether a stream of readable data may continue. A store or a provider that does not answer revokes nothing: the
    /// stream reads nothing new from it meanwhile, and the next page checks again.
    pub(super) async fn last(&mut self) -> bool {
        self.due = Instant::now() + self.state.limits.access_interval;
        match self.ask(Scope::Read).await {
            Ok(()) => true,
            Err(problem) => problem.kind() == ProblemKind::Unavailable,
        }
    }

    /// Returns when a silent stream has to check its rights again.
    pub(super) async fn due(&self) {
        sleep_until(self.due).await;
    }
}
