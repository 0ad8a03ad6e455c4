//! The port to blobs as they are stored, encrypted or not.

use crate::jobs::{ArtifactKey, ArtifactStore, JobError};
use async_trait::async_trait;
use bytes::Bytes;

/// A store whose stored bytes can be read unchanged.
#[async_trait]
pub trait StoredBlobs: ArtifactStore {
    /// The bytes stored under `key`, even if they do not match the hash in the address.
    async fn stored(&self, key: &ArtifactKey) -> Result<Bytes, JobError>;
}
