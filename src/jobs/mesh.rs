//! Uploads: files to which jobs refer by the hash of their content.

use super::artifact::{ArtifactKey, is_hash};
use super::error::JobError;
use super::input_check::{InputRefusal, InputSummary};
use super::job::Tenant;
use async_trait::async_trait;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};

/// The id of a content with this hash, as clients see it.
pub fn content_id(hash: &str) -> String {
    format!("blake3:{hash}")
}

/// The hash in an id; `None` if `id` is not an id.
pub fn hash_of_id(id: &str) -> Option<&str> {
    id.strip_prefix("blake3:").filter(|hash| is_hash(hash))
}

/// An upload.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// The address of its content; the hash identifies the upload within the tenant.
    pub key: ArtifactKey,
    /// Size of the content, bytes.
    pub n_bytes: u64,
    /// The extensions of its file name, such as `.nii.gz`.
    pub name_hint: Option<String>,
    /// When it was first uploaded.
    pub created_at: Timestamp,
}

/// The outcome of checking an input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum CheckOutcome {
    /// It can be matched.
    Fit(InputSummary),
    /// It cannot.
    Unfit(InputRefusal),
}

/// A page of the list of uploads.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPage {
    /// The uploads, newest first.
    pub meshes: Vec<Mesh>,
    /// Where the next page begins, if there is one: creation time, ms, and hash of the last upload.
    pub next: Option<(i64, String)>,
}

/// Records of uploads.
#[async_trait]
pub trait MeshStore: Send + Sync {
    /// Records an upload whose blob `holder` holds, and releases the hold. Returns whether the upload is new.
    async fn insert_mesh(
        &self,
        key: &ArtifactKey,
        n_bytes: u64,
        name_hint: Option<&str>,
        holder: &str,
    ) -> Result<bool, JobError>;

    /// An upload.
    async fn get_mesh(&self, tenant: &Tenant, hash: &str) -> Result<Mesh, JobError>;

    /// A page of the list of uploads, newest first.
    async fn list_meshes(&self, tenant: &Tenant, size: u32, after: Option<(i64, String)>)
    -> Result<MeshPage, JobError>;

    /// Deletes an upload. [`JobError::MeshInUse`] while jobs refer to it.
    async fn delete_mesh(&self, tenant: &Tenant, hash: &str) -> Result<(), JobError>;

    /// The stored outcome of its check under `input_key`.
    async fn get_mesh_check(
        &self,
        tenant: &Tenant,
        hash: &str,
        input_key: &str,
    ) -> Result<Option<CheckOutcome>, JobError>;

    /// Stores the outcome of its check under `input_key`.
    async fn save_mesh_check(
        &self,
        tenant: &Tenant,
        hash: &str,
        input_key: &str,
        outcome: &CheckOutcome,
    ) -> Result<(), JobError>;
}
