//! Uploads: files that jobs can name by the hash of their content.

use super::engine::{InputRefusal, InputSummary};
use super::error::JobError;
use super::job::Tenant;
use super::ports::{ArtifactKey, is_hash};
use async_trait::async_trait;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};

/// The id of a content with this hash, as clients see it.
pub fn content_id(hash: &str) -> String {
    format!("blake3:{hash}")
}

/// The hash in an id; `None` if it is no id.
pub fn hash_of_id(id: &str) -> Option<&str> {
    id.strip_prefix("blake3:").filter(|hash| is_hash(hash))
}

/// An upload.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Where its bytes are; the hash is its identity within the tenant.
    pub key: ArtifactKey,
    /// Their number.
    pub n_bytes: u64,
    /// The endings of its name.
    pub name_hint: Option<String>,
    /// When it was first uploaded.
    pub created_at: Timestamp,
}

/// What checking an input found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum CheckOutcome {
    /// It can be matched.
    Fit(InputSummary),
    /// It cannot.
    Unfit(InputRefusal),
}

/// A part of a list of uploads.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPage {
    /// The uploads, the newest first.
    pub meshes: Vec<Mesh>,
    /// Where the next page begins: time in ms and hash of the last.
    pub next: Option<(i64, String)>,
}

/// Records of uploads.
#[async_trait]
pub trait MeshStore: Send + Sync {
    /// Records an upload whose blob is held by `holder`; the hold ends. Returns whether it is new.
    async fn insert_mesh(
        &self,
        key: &ArtifactKey,
        n_bytes: u64,
        name_hint: Option<&str>,
        holder: &str,
    ) -> Result<bool, JobError>;

    /// An upload.
    async fn get_mesh(&self, tenant: &Tenant, hash: &str) -> Result<Mesh, JobError>;

    /// A part of the list of uploads.
    async fn list_meshes(&self, tenant: &Tenant, size: u32, after: Option<(i64, String)>)
    -> Result<MeshPage, JobError>;

    /// Forgets an upload. `MeshInUse` while jobs refer to it.
    async fn delete_mesh(&self, tenant: &Tenant, hash: &str) -> Result<(), JobError>;

    /// What checking it for `input_key` found earlier.
    async fn mesh_check(&self, tenant: &Tenant, hash: &str, input_key: &str) -> Result<Option<CheckOutcome>, JobError>;

    /// Remembers what checking it found.
    async fn save_mesh_check(
        &self,
        tenant: &Tenant,
        hash: &str,
        input_key: &str,
        outcome: &CheckOutcome,
    ) -> Result<(), JobError>;
}
