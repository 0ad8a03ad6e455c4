//! API keys: the tenant of a request, and what it may do: scopes, which roles bundle.

use super::error::JobError;
use super::job::Tenant;
use super::ticket::Ticket;
use async_trait::async_trait;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// A right that a key has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// Read everything of the tenant.
    Read,
    /// Submit, cancel, retry and delete jobs; upload.
    Submit,
    /// Manage webhooks and API keys.
    Admin,
}

impl Scope {
    /// All scopes.
    pub const ALL: [Scope; 3] = [Scope::Read, Scope::Submit, Scope::Admin];

    /// The name used in JSON, on the command line and in the database.
    pub fn name(self) -> &'static str {
        match self {
            Scope::Read => "read",
            Scope::Submit => "submit",
            Scope::Admin => "admin",
        }
    }

    /// The scope of this name.
    pub fn from_name(name: &str) -> Option<Scope> {
        Scope::ALL.into_iter().find(|scope| scope.name() == name)
    }
}

/// Who a key is for: each role has the scopes of those before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Reads everything of the tenant: jobs, results, uploads, changes.
    Reader,
    /// Also submits, cancels, retries and deletes jobs, and uploads.
    Submitter,
    /// Also manages webhooks and API keys of the tenant.
    Admin,
}

impl Role {
    /// All roles, the one that may do least first.
    pub const ALL: [Role; 3] = [Role::Reader, Role::Submitter, Role::Admin];

    /// The name used in JSON and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Role::Reader => "reader",
            Role::Submitter => "submitter",
            Role::Admin => "admin",
        }
    }

    /// The role of this name.
    pub fn from_name(name: &str) -> Option<Role> {
        Role::ALL.into_iter().find(|role| role.name() == name)
    }

    /// Its scopes.
    pub fn scopes(self) -> &'static [Scope] {
        match self {
            Role::Reader => &[Scope::Read],
            Role::Submitter => &[Scope::Read, Scope::Submit],
            Role::Admin => &[Scope::Read, Scope::Submit, Scope::Admin],
        }
    }

    /// The role with exactly these scopes; keys of the command line may have other combinations.
    pub fn of_scopes(scopes: &[Scope]) -> Option<Role> {
        Role::ALL.into_iter().find(|role| {
            role.scopes().iter().all(|s| scopes.contains(s)) && scopes.iter().all(|s| role.scopes().contains(s))
        })
    }

    /// The least role that has a scope.
    pub fn least_with(scope: Scope) -> Role {
        match scope {
            Scope::Read => Role::Reader,
            Scope::Submit => Role::Submitter,
            Scope::Admin => Role::Admin,
        }
    }
}

/// A key in full, as its owner receives it once.
#[derive(Clone, PartialEq, Eq)]
pub struct SecretKey {
    id: String,
    secret: String,
}

const PREFIX: &str = "hml";

/// 256 random bits, from the system's generator by way of random UUIDs and a hash.
pub fn random_secret() -> blake3::Hash {
    let mut hasher = blake3::Hasher::new();
    // Each carries 122 random bits.
    for _ in 0..4 {
        hasher.update(uuid::Uuid::new_v4().as_bytes());
    }
    hasher.finalize()
}

fn is_hex(text: &str) -> bool {
    text.bytes().all(|b| b.is_ascii_hexdigit())
}

impl SecretKey {
    /// A random key.
    pub fn random() -> Self {
        let id = uuid::Uuid::new_v4().simple().to_string()[..12].to_owned();
        SecretKey { id, secret: random_secret().to_hex().to_string() }
    }

    /// The key written in `text`.
    pub fn parse(text: &str) -> Option<Self> {
        let mut parts = text.split('_');
        let (prefix, id, secret) = (parts.next()?, parts.next()?, parts.next()?);
        let whole = prefix == PREFIX && secret.len() == 64 && parts.next().is_none();
        (whole && SecretKey::is_id(id) && is_hex(secret))
            .then(|| SecretKey { id: id.to_owned(), secret: secret.to_owned() })
    }

    /// Whether a text has the form of a public part.
    pub fn is_id(text: &str) -> bool {
        text.len() == 12 && is_hex(text)
    }

    /// Its public part.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The stored hash of the secret part. The secret is long and random, so a fast hash suffices.
    pub fn hash(&self) -> String {
        blake3::hash(self.secret.as_bytes()).to_hex().to_string()
    }

    /// Whether this key has the stored hash `hash`; takes constant time.
    pub fn has_hash(&self, stored: &str) -> bool {
        blake3::Hash::from_hex(stored).is_ok_and(|stored| stored == blake3::hash(self.secret.as_bytes()))
    }

    /// The text for its owner.
    pub fn reveal(&self) -> String {
        format!("{PREFIX}_{}_{}", self.id, self.secret)
    }
}

impl std::fmt::Debug for SecretKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "SecretKey({})", self.id)
    }
}

/// A key as stored.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ApiKey {
    /// Public part.
    pub id: String,
    /// The tenant of its requests.
    pub tenant: Tenant,
    /// Its name, for operators.
    pub name: String,
    /// Hash of its secret part.
    pub hash: String,
    /// Its scopes.
    pub scopes: Vec<Scope>,
    /// When it was created.
    pub created_at: Timestamp,
    /// When it expires.
    pub expires_at: Option<Timestamp>,
    /// When it was revoked.
    pub revoked_at: Option<Timestamp>,
    /// Whether it is neither expired nor revoked, by the database's clock.
    pub is_valid: bool,
}

/// A page of the list of a tenant's keys.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyPage {
    /// The keys, newest first.
    pub keys: Vec<ApiKey>,
    /// Where the next page begins, if there is one: creation time in ms and id.
    pub next: Option<(i64, String)>,
}

/// Records of API keys.
#[async_trait]
pub trait KeyStore: Send + Sync {
    /// Stores a key that expires after `valid_for`, or never.
    async fn insert_key(
        &self,
        key: &SecretKey,
        tenant: &Tenant,
        name: &str,
        scopes: &[Scope],
        valid_for: Option<Duration>,
    ) -> Result<(), JobError>;

    /// The key with this public part.
    async fn get_key(&self, id: &str) -> Result<Option<ApiKey>, JobError>;

    /// All keys.
    async fn list_keys(&self) -> Result<Vec<ApiKey>, JobError>;

    /// A page of a tenant's keys, newest first, after a creation time in ms and an id.
    async fn list_tenant_keys(
        &self,
        tenant: &Tenant,
        size: u32,
        after: Option<(i64, String)>,
    ) -> Result<KeyPage, JobError>;

    /// The number of a tenant's keys that are valid.
    async fn count_valid_keys(&self, tenant: &Tenant) -> Result<u32, JobError>;

    /// Stores a ticket under its hash, to be accepted for `lasts`; `false` if the tenant has `at_most` already.
    async fn insert_ticket(&self, hash: &str, ticket: &Ticket, lasts: Duration, at_most: u32)
    -> Result<bool, JobError>;

    /// The ticket with this hash, if it has not expired.
    async fn get_ticket(&self, hash: &str) -> Result<Option<Ticket>, JobError>;

    /// Revokes a key. `false` if there is no such key or it is revoked already.
    async fn revoke_key(&self, id: &str) -> Result<bool, JobError>;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_role_has_the_scopes_of_lesser_ones_and_is_known_by_its_scopes() {
        for role in Role::ALL {
            assert_eq!(Role::of_scopes(role.scopes()), Some(role));
            assert_eq!(Role::from_name(role.name()), Some(role));
            for lesser in Role::ALL.into_iter().filter(|lesser| *lesser < role) {
                assert!(lesser.scopes().iter().all(|scope| role.scopes().contains(scope)));
            }
        }
        for scope in Scope::ALL {
            let allowed: Vec<_> = Role::ALL.into_iter().filter(|role| role.scopes().contains(&scope)).collect();
            assert_eq!(allowed.first(), Some(&Role::least_with(scope)));
        }
        assert_eq!(Role::of_scopes(&[Scope::Submit]), None);
    }

    #[test]
    fn keys_are_parsed_and_redacted_in_logs() {
        let key = SecretKey::random();
        let again = SecretKey::parse(&key.reveal()).unwrap();
        assert_eq!(again, key);
        assert!(again.has_hash(&key.hash()));
        assert!(!again.has_hash(&SecretKey::random().hash()));
        assert!(!format!("{key:?}").contains(&key.secret));
        let text = key.reveal();
        for wrong in ["", "hml", "hml_x_y", &text[1..], &text[..text.len() - 1], &format!("{text}_")] {
            assert!(SecretKey::parse(wrong).is_none(), "{wrong}");
        }
    }
}
