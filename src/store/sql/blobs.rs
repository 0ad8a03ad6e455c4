//! Which blobs are in use: references of jobs and uploads, and holds of processes that are about to refer to them.
//!
//! Equal uploads share a blob, so the removal of a blob must not interleave with a submission of the same bytes. Each
//! blob has a row, which both sides lock: a writer places a hold on a blob before it writes it; a removal checks for
//! references and holds, marks the row, removes the blob outside of any transaction, and then deletes the row. A writer
//! that finds the mark waits until the row is deleted and then writes the blob again.

use super::SqlStore;
use super::argument::bind;
use super::database::Session;
use super::dialect::sql;
use super::fence::lock_lease;
use crate::jobs::{ArtifactKey, ArtifactStore, BlobHolds, JobError, JobId, Lease, Tenant};
use async_trait::async_trait;
use std::time::{Duration, Instant};

/// Most blobs examined in one transaction.
const REMOVALS_AT_ONCE: u32 = 64;
/// A removal that takes longer than this was interrupted, and another process takes it over.
const REMOVAL_LAPSES: Duration = Duration::from_secs(20);
/// How long a hold waits for a removal of the same blob.
const HOLD_TIMEOUT: Duration = Duration::from_secs(25);

/// Releases a hold; its blobs become candidates for removal, which keeps those that are in use.
pub(super) async fn drop_hold(session: &mut Session, holder: &str) -> Result<(), JobError> {
    for query in [sql!("lock_blobs_of_holder"), sql!("note_candidates_of_holder"), sql!("drop_hold")] {
        session.execute(query, bind![holder]).await?;
    }
    Ok(())
}

/// Makes the blobs of a job candidates for removal.
pub(super) async fn note_candidates_of_job(session: &mut Session, id: JobId) -> Result<(), JobError> {
    for query in [sql!("lock_blobs_of_job"), sql!("note_candidates_of_job")] {
        session.execute(query, bind![id]).await?;
    }
    Ok(())
}

/// Places a hold on blobs. [`JobError::BeingRemoved`] if one of them is being removed.
async fn hold_blobs(
    session: &mut Session,
    holder: &str,
    keys: &[&ArtifactKey],
    for_at_most: Duration,
    fence: Option<&Lease>,
) -> Result<(), JobError> {
    if let Some(lease) = fence {
        lock_lease(session, lease).await?;
    }
    for key in keys {
        let row = session.row(sql!("claim_blob"), bind![&key.tenant, key.path()]).await?;
        if row.map_or(Ok(None), |row| row.get::<Option<i64>>(0))?.is_some() {
            return Err(JobError::BeingRemoved);
        }
        session.execute(sql!("hold_blob"), bind![holder, &key.tenant, key.path(), for_at_most]).await?;
    }
    Ok(())
}

/// Examines some candidates: those in use stop being candidates, the others are marked for removal. Returns the number
/// of candidates and the marked ones, each with the time of its mark.
async fn mark_unreferenced(session: &mut Session) -> Result<(usize, Vec<(ArtifactKey, i64)>), JobError> {
    for holder in session.rows(sql!("lapsed_holders"), bind![]).await? {
        drop_hold(session, &holder.get::<String>(0)?).await?;
    }
    let candidates = session.rows(sql!("lock_candidates"), bind![REMOVALS_AT_ONCE, REMOVAL_LAPSES]).await?;
    let mut unreferenced = Vec::new();
    for row in &candidates {
        let (tenant, path): (String, String) = (row.get("tenant")?, row.get("path")?);
        // Checked after the row was locked: every transaction that has added a reference has committed by then. A held
        // blob becomes a candidate again when the hold is released.
        if session.value(sql!("blob_is_needed"), bind![&tenant, &path]).await? == Some(true) {
            session.execute(sql!("keep_blob"), bind![&tenant, &path]).await?;
            continue;
        }
        let since: Option<i64> = session.value(sql!("begin_removal"), bind![&tenant, &path]).await?;
        let key = Tenant::new(&tenant).and_then(|tenant| ArtifactKey::from_path(&tenant, &path));
        let key = key.ok_or(JobError::Corrupt { what: "a blob's address", source: None })?;
        unreferenced.push((key, since.unwrap_or_default()));
    }
    Ok((candidates.len(), unreferenced))
}

#[async_trait]
impl BlobHolds for SqlStore {
    async fn hold_blobs(
        &self,
        holder: &str,
        keys: &[ArtifactKey],
        for_at_most: Duration,
        fence: Option<&Lease>,
    ) -> Result<(), JobError> {
        // All holders lock in the same order, so that two of them never deadlock.
        let mut keys: Vec<&ArtifactKey> = keys.iter().collect();
        keys.sort_by_key(|key| key.path());
        keys.dedup();
        let began = Instant::now();
        loop {
            let held = self
                .database
                .transaction(async |session| hold_blobs(session, holder, &keys, for_at_most, fence).await)
                .await;
            match held {
                Err(JobError::BeingRemoved) if began.elapsed() < HOLD_TIMEOUT => {
                    tokio::time::sleep(Duration::from_millis(50)).await;
                }
                held => return held,
            }
        }
    }

    async fn drop_hold(&self, holder: &str) -> Result<(), JobError> {
        self.database.transaction(async |session| drop_hold(session, holder).await).await
    }

    async fn remove_unreferenced_blobs(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError> {
        let mut removed = 0;
        loop {
            // Checked without a lock first, because usually there is nothing to do.
            let work: Option<bool> = self.database.reader().await?.value(sql!("has_candidates"), bind![]).await?;
            if work != Some(true) {
                return Ok(removed);
            }
            let (n_seen, unreferenced) = self.database.transaction(mark_unreferenced).await?;
            for (key, since) in &unreferenced {
                artifacts.remove(key).await?;
                let arguments = bind![&key.tenant, key.path(), *since];
                self.database
                    .transaction(async |session| session.execute(sql!("end_removal"), arguments).await)
                    .await?;
                removed += 1;
            }
            if n_seen < REMOVALS_AT_ONCE as usize {
                return Ok(removed); // the rest is held or being removed by other processes, and is checked again later
            }
        }
    }
}
