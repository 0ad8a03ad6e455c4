//! Rotation of the keys of encryption at rest: the keys of blobs and the secrets in the database are encrypted with the
//! current key-encryption key.
//!
//! Each blob has its own random key, stored with the blob. A rotation therefore encrypts only 32 bytes of each blob again.

use super::artifacts::SealedArtifacts;
use super::artifacts::sealed::Resealed;
use super::sql::SqlStore;
use crate::jobs::{ArtifactKey, BlobHolds as _, JobError};
use std::time::Duration;

/// How long a rotation may take for one blob before other processes may remove the blob.
const HELD: Duration = Duration::from_secs(3_600);

/// Counts of a rotation, or of a dry run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rotated {
    /// Blobs that were already encrypted with the current key.
    pub current: u64,
    /// Blobs whose key was encrypted with the current key instead of an older one.
    pub rewrapped: u64,
    /// Blobs that were encrypted for the first time.
    pub encrypted: u64,
    /// Secrets that were encrypted with the current key.
    pub secrets: u32,
}

/// Encrypts the key of each blob, and each secret, with the current key; blobs that are not encrypted yet are
/// encrypted. The service may run at the same time. `dry_run`: only counts.
///
/// # Errors
/// Those of the stores; finished work remains.
pub async fn rotate(store: &SqlStore, artifacts: &SealedArtifacts, dry_run: bool) -> Result<Rotated, JobError> {
    let mut rotated = Rotated::default();
    let holder = format!("rotation-{}", uuid::Uuid::new_v4());
    let mut after = None;
    loop {
        let page = store.list_blobs(after.take()).await?;
        let Some(last) = page.last() else { break };
        after = Some((last.tenant.clone(), last.path.clone()));
        for blob in page {
            let Some(key) = ArtifactKey::from_path(&blob.tenant, &blob.path) else { continue };
            match artifacts.is_current(&key, blob.n_bytes).await {
                Ok(Resealed::Not) => rotated.current += 1,
                Ok(Resealed::Rewrapped) if dry_run => rotated.rewrapped += 1,
                Ok(Resealed::Encrypted) if dry_run => rotated.encrypted += 1,
                Ok(_) => {
                    // Held, because a blob that is written again after its last reference has gone would remain
                    // forever.
                    store.hold_blobs(&holder, std::slice::from_ref(&key), HELD, None).await?;
                    let done = artifacts.reseal(&key, blob.n_bytes).await;
                    store.drop_hold(&holder).await?;
                    match done {
                        Ok(Resealed::Not) => rotated.current += 1,
                        Ok(Resealed::Rewrapped) => rotated.rewrapped += 1,
                        Ok(Resealed::Encrypted) => rotated.encrypted += 1,
                        Err(error) if store.blob_is_needed(&blob).await? => return Err(error),
                        Err(_) => {}
                    }
                }
                // The blob was deleted after it was listed.
                Err(error) if store.blob_is_needed(&blob).await? => return Err(error),
                Err(_) => {}
            }
        }
    }
    if !dry_run {
        rotated.secrets = store.seal_secrets().await?;
    }
    Ok(rotated)
}
