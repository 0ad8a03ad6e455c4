//! Who asks: the holder of an API key, or anyone where no keys are asked for.

use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::router::HttpState;
use crate::jobs::{Scope, SecretKey, Tenant};
use axum::extract::FromRequestParts;
use axum::http::header;
use axum::http::request::Parts;

/// Who may ask.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum AuthMode {
    /// Anyone; all are the tenant `default` and may do everything.
    None,
    /// Holders of API keys: `Authorization: Bearer hml_…`.
    Keys,
}

/// Who asks, with a key that allows looking.
#[derive(Debug, Clone)]
pub struct Reader(pub Tenant);

/// Who asks, with a key that allows submitting.
#[derive(Debug, Clone)]
pub struct Submitter(pub Tenant);

/// Who asks, with a key that allows administration.
#[derive(Debug, Clone)]
pub struct Admin(pub Tenant);

async fn tenant_with(parts: &Parts, state: &HttpState, scope: Scope) -> Result<Tenant, Problem> {
    if state.auth == AuthMode::None {
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
    // Which part was wrong is said to nobody.
    let Some(found) = found else { return Err(Problem::new(ProblemKind::Unauthenticated)) };
    if !found.scopes.contains(&scope) {
        let detail = format!("this needs a key with the scope {}", scope.name());
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
