//! Bearer tokens of an OpenID Connect provider: JSON Web Tokens, signed with a key of the provider's key set. The set
//! is read from a file or a URL, and read again when a token names a key that is not in it.

use super::token_signatures::{ACCEPTED, prepare};
use crate::jobs::{Role, Tenant};
use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD as BASE64;
use jsonwebtoken::jwk::{Jwk, JwkSet, KeyOperations, PublicKeyUse};
use jsonwebtoken::{DecodingKey, Validation, decode, decode_header};
use ring::digest::{SHA256, digest};
use serde_json::{Map, Value};
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tokio::sync::Mutex;
use url::Url;

/// How long a key set is used before it is read again.
const FRESH: Duration = Duration::from_secs(3_600);
/// Least time between two reads of the key set: anybody can send a token that names an unknown key.
const BETWEEN_READS: Duration = Duration::from_secs(5);
/// Time limit for a key set from a URL.
const READ_TIMEOUT: Duration = Duration::from_secs(5);
/// Largest key set, bytes.
const MAX_KEY_SET: usize = 1 << 20;
/// Largest token, bytes.
const MAX_TOKEN: usize = 16 << 10;

/// The rules for accepted tokens, and the claims that are read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TokenSettings {
    /// Required value of `iss`.
    pub issuer: String,
    /// `aud` must equal or contain this value.
    pub audience: String,
    /// Location of the key set.
    pub key_set: KeySetSource,
    /// Claim with the roles: names separated by dots, such as `realm_access.roles`.
    pub role_claim: String,
    /// Claim with the tenant; `None`: all tokens belong to the tenant `default`.
    pub tenant_claim: Option<String>,
    /// How far the clocks of the provider and of this machine may differ.
    pub leeway: Duration,
}

/// Location of a key set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum KeySetSource {
    /// In a file.
    File(PathBuf),
    /// At a URL.
    Url(Url),
}

impl KeySetSource {
    /// A URL if the text is one, otherwise a file.
    ///
    /// # Errors
    /// If the key set would be fetched without TLS from another machine, because an attacker on the network path could
    /// replace it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let Some(url) = Url::parse(text).ok().filter(|url| url.has_host()) else {
            return Ok(KeySetSource::File(PathBuf::from(text)));
        };
        let is_local = match url.host() {
            Some(url::Host::Ipv4(address)) => address.is_loopback(),
            Some(url::Host::Ipv6(address)) => address.is_loopback(),
            Some(url::Host::Domain(name)) => name == "localhost",
            None => false,
        };
        match url.scheme() {
            "https" => Ok(KeySetSource::Url(url)),
            "http" if is_local => Ok(KeySetSource::Url(url)),
            _ => Err("a file, or a URL that begins with https://, is needed here".to_owned()),
        }
    }
}

/// The sender of a token.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Bearer {
    pub(super) tenant: Tenant,
    pub(super) role: Role,
    /// Distinguishes the users of a provider without naming them: `oidc:` and half of the SHA-256 of issuer and
    /// subject.
    pub(super) id: String,
}

/// Why a token is not accepted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TokenFault {
    /// The token is not valid.
    Invalid,
    /// The token is valid, but names no role of this service, or no tenant.
    NoRole,
    /// The key set cannot be read.
    Unavailable,
}

/// Whether the header of a token requires no extension that a verifier must understand (`crit`; RFC 7515, section
/// 4.1.11): none is supported.
fn is_understood(token: &str) -> bool {
    let header = token.split('.').next().and_then(|part| BASE64.decode(part).ok());
    let header = header.and_then(|bytes| serde_json::from_slice::<Map<String, Value>>(&bytes).ok());
    header.is_some_and(|header| !header.contains_key("crit"))
}

/// Verifies tokens.
pub struct Tokens {
    settings: TokenSettings,
    client: reqwest::Client,
    keys: Mutex<Keys>,
}

#[derive(Default)]
struct Keys {
    set: Option<JwkSet>,
    tried: Option<Instant>,
    read: Option<Instant>,
}

impl Tokens {
    /// Verifies tokens by these settings.
    ///
    /// # Errors
    /// If the file with the key set is unreadable, or no HTTP client can be created. A URL is read with the first token.
    pub fn open(settings: TokenSettings) -> Result<Self, String> {
        prepare();
        crate::tls::prepare();
        if let KeySetSource::File(path) = &settings.key_set {
            let text = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
            parsed(&text).map_err(|error| format!("{}: {error}", path.display()))?;
        }
        let client = reqwest::Client::builder()
            .redirect(reqwest::redirect::Policy::none())
            .timeout(READ_TIMEOUT)
            .user_agent(concat!("homolog/", env!("CARGO_PKG_VERSION")))
            .build()
            .map_err(|error| error.to_string())?;
        Ok(Tokens { settings, client, keys: Mutex::default() })
    }

    /// Verifies a token. Returns its sender.
    pub(super) async fn verify(&self, token: &str) -> Result<Bearer, TokenFault> {
        if token.len() > MAX_TOKEN {
            return Err(TokenFault::Invalid);
        }
        let header = decode_header(token).map_err(|_| TokenFault::Invalid)?;
        if !ACCEPTED.contains(&header.alg) || !is_understood(token) {
            return Err(TokenFault::Invalid);
        }
        let jwk = self.key(header.kid.as_deref()).await?;
        // Both enums name their variants as the standard does.
        let of_token = format!("{:?}", header.alg);
        let is_for_this = jwk.common.key_algorithm.is_none_or(|of_key| format!("{of_key:?}") == of_token);
        let is_for_signatures = jwk.common.public_key_use.as_ref().is_none_or(|u| *u == PublicKeyUse::Signature)
            && jwk.common.key_operations.as_ref().is_none_or(|all| all.contains(&KeyOperations::Verify));
        if !is_for_this || !is_for_signatures {
            return Err(TokenFault::Invalid);
        }
        let key = DecodingKey::from_jwk(&jwk).map_err(|_| TokenFault::Invalid)?;
        let mut validation = Validation::new(header.alg);
        validation.set_issuer(&[&self.settings.issuer]);
        validation.set_audience(&[&self.settings.audience]);
        validation.set_required_spec_claims(&["exp", "iss", "aud", "sub"]);
        validation.validate_nbf = true;
        validation.leeway = self.settings.leeway.as_secs();
        let claims = decode::<Map<String, Value>>(token, &key, &validation).map_err(|_| TokenFault::Invalid)?.claims;
        self.bearer(&claims)
    }

    fn bearer(&self, claims: &Map<String, Value>) -> Result<Bearer, TokenFault> {
        let role = claim(claims, &self.settings.role_claim).and_then(highest_role).ok_or(TokenFault::NoRole)?;
        let tenant = match &self.settings.tenant_claim {
            None => Tenant::default(),
            Some(name) => {
                let named = claim(claims, name).and_then(Value::as_str).and_then(Tenant::new);
                named.ok_or(TokenFault::NoRole)?
            }
        };
        let subject = claims.get("sub").and_then(Value::as_str).ok_or(TokenFault::Invalid)?;
        let mut id = "oidc:".to_owned();
        for byte in &digest(&SHA256, format!("{}\n{subject}", self.settings.issuer).as_bytes()).as_ref()[..16] {
            let _ = write!(id, "{byte:02x}");
        }
        Ok(Bearer { tenant, role, id })
    }

    /// The key of this name; without a name, the only key of the set.
    async fn key(&self, kid: Option<&str>) -> Result<Jwk, TokenFault> {
        let mut keys = self.keys.lock().await;
        let find = |set: &JwkSet| match kid {
            Some(kid) => set.find(kid).cloned(),
            None if set.keys.len() == 1 => set.keys.first().cloned(),
            None => None,
        };
        let found = keys.set.as_ref().and_then(find);
        let is_fresh = keys.read.is_some_and(|read| read.elapsed() < FRESH);
        let may_read = keys.tried.is_none_or(|tried| tried.elapsed() >= BETWEEN_READS);
        if (found.is_some() && is_fresh) || !may_read {
            // A provider that does not answer must not lock out users whose key is known.
            return found.ok_or(if keys.set.is_some() { TokenFault::Invalid } else { TokenFault::Unavailable });
        }
        keys.tried = Some(Instant::now());
        match self.read().await {
            Ok(set) => {
                keys.read = Some(Instant::now());
                keys.set = Some(set);
            }
            Err(error) => tracing::warn!(error, "the key set of the OpenID Connect provider cannot be read"),
        }
        let Some(set) = &keys.set else { return Err(TokenFault::Unavailable) };
        find(set).ok_or(TokenFault::Invalid)
    }

    async fn read(&self) -> Result<JwkSet, String> {
        let text = match &self.settings.key_set {
            KeySetSource::File(path) => {
                let path = path.clone();
                let read = tokio::task::spawn_blocking(move || std::fs::read(path)).await;
                read.map_err(|error| error.to_string())?.map_err(|error| error.to_string())?
            }
            KeySetSource::Url(url) => {
                let failed = |error: reqwest::Error| error.without_url().to_string();
                let answer = self.client.get(url.clone()).send().await.map_err(failed)?;
                let mut answer = answer.error_for_status().map_err(failed)?;
                let mut text = Vec::new();
                while let Some(part) = answer.chunk().await.map_err(failed)? {
                    text.extend_from_slice(&part);
                    if text.len() > MAX_KEY_SET {
                        return Err(format!("more than {MAX_KEY_SET} bytes"));
                    }
                }
                text
            }
        };
        parsed(&text)
    }
}

fn parsed(text: &[u8]) -> Result<JwkSet, String> {
    serde_json::from_slice(text).map_err(|error| format!("no JSON Web Key Set: {error}"))
}

/// The value of a claim; dots select members of objects.
fn claim<'a>(claims: &'a Map<String, Value>, path: &str) -> Option<&'a Value> {
    // A name may itself contain dots, for example the names of providers that use URLs.
    if let Some(value) = claims.get(path) {
        return Some(value);
    }
    let mut names = path.split('.');
    let first = claims.get(names.next()?)?;
    names.try_fold(first, |value, name| value.get(name))
}

/// The highest role in a claim, which is a name or a list of names, such as `submitter` or `homolog-submitter`. Other
/// names are ignored.
fn highest_role(value: &Value) -> Option<Role> {
    let role = |value: &Value| {
        let name = value.as_str()?;
        Role::from_name(name.strip_prefix("homolog-").unwrap_or(name))
    };
    match value {
        Value::Array(values) => values.iter().filter_map(role).max(),
        value => role(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn roles_are_read_from_texts_lists_and_objects() {
        let claims = json!({
            "role": "reader", "roles": ["offline", "homolog-submitter", "reader"], "realm": {"access": ["admin"]},
            "https://example.org/roles": "submitter", "other": ["root", 1, {}],
        });
        let role = |path: &str| claim(claims.as_object().unwrap(), path).and_then(highest_role);
        assert_eq!(role("role"), Some(Role::Reader));
        assert_eq!(role("roles"), Some(Role::Submitter));
        assert_eq!(role("realm.access"), Some(Role::Admin));
        assert_eq!(role("https://example.org/roles"), Some(Role::Submitter));
        for nothing in ["other", "none", "realm", "realm.access.0", "role.x", ""] {
            assert_eq!(role(nothing), None, "{nothing}");
        }
    }

    #[test]
    fn key_sets_are_not_fetched_without_tls() {
        let parse = KeySetSource::parse;
        assert!(matches!(parse("https://idp.example.org/jwks"), Ok(KeySetSource::Url(_))));
        assert!(matches!(parse("http://127.0.0.1:9000/jwks"), Ok(KeySetSource::Url(_))));
        assert!(matches!(parse("/etc/homolog/jwks.json"), Ok(KeySetSource::File(_))));
        for wrong in ["http://idp.example.org/jwks", "ftp://127.0.0.1/jwks", "http://localhost.example.org/"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
