//! Which blobs are needed: references of jobs and uploads, and holds of those who are about to refer.
//!
//! Blobs of uploads are shared, so a removal must not meet a submission of the same bytes half-way. Each blob has a
//! row, and both sides lock it: who writes a blob first takes a hold on it; a removal looks for references and holds,
//! marks the row, removes the blob without a transaction open, and then the row. A hold that meets the mark waits until
//! the row is gone, and the blob is written anew.

use super::SqlStore;
use super::database::{Session, bind};
use super::dialect::sql;
use super::leasing::fence as check_fence;
use crate::jobs::{ArtifactKey, ArtifactStore, JobError, JobId, Lease, Tenant};
use std::time::{Duration, Instant};

/// Most blobs looked at in one transaction.
const REMOVALS_AT_ONCE: u32 = 64;
/// A removal that takes longer was interrupted; another takes it over.
const REMOVAL_LAPSES: Duration = Duration::from_secs(20);
/// How long a hold waits for a removal of the same blob.
const HOLD_PATIENCE: Duration = Duration::from_secs(25);

/// Ends a hold; its blobs become candidates for removal, which keeps those that are referred to.
pub(super) async fn end_hold(session: &mut Session, holder: &str) -> Result<(), JobError> {
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

impl SqlStore {
    pub(super) async fn hold(
        &self,
        holder: &str,
        keys: &[ArtifactKey],
        for_at_most: Duration,
        fence: Option<&Lease>,
    ) -> Result<(), JobError> {
        // In one order for all, so that two holders never wait for each other.
        let mut keys: Vec<&ArtifactKey> = keys.iter().collect();
        keys.sort_by_key(|key| key.path());
        keys.dedup();
        let began = Instant::now();
        loop {
            match self.hold_now(holder, &keys, for_at_most, fence).await {
                Err(JobError::BeingRemoved) if began.elapsed() < HOLD_PATIENCE => {
                    tokio::time::sleep(Duration::from_millis(50)).await;
                }
                done => return done,
            }
        }
    }

    async fn hold_now(
        &self,
        holder: &str,
        keys: &[&ArtifactKey],
        for_at_most: Duration,
        fence: Option<&Lease>,
    ) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            if let Some(lease) = fence {
                check_fence(&mut session, lease).await?;
            }
            for key in keys {
                let row = session.row(sql!("claim_blob"), bind![&key.tenant, key.path()]).await?;
                if row.map_or(Ok(None), |row| row.get::<Option<i64>>(0))?.is_some() {
                    return Err(JobError::BeingRemoved);
                }
                session.execute(sql!("hold_blob"), bind![holder, &key.tenant, key.path(), for_at_most]).await?;
            }
            Ok(())
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn end_hold(&self, holder: &str) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = end_hold(&mut session, holder).await;
        session.end(done).await
    }

    pub(super) async fn remove_unreferenced(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError> {
        let mut removed = 0;
        loop {
            // Looked at without a lock first: mostly there is nothing to do.
            let work: Option<bool> = self.database.reading().await?.value(sql!("has_candidates"), bind![]).await?;
            if work != Some(true) {
                return Ok(removed);
            }
            let (n_seen, unneeded) = self.mark_unneeded().await?;
            for (key, since) in &unneeded {
                artifacts.remove(key).await?;
                let mut session = self.database.begin().await?;
                let done = session.execute(sql!("end_removal"), bind![&key.tenant, key.path(), *since]).await;
                session.end(done).await?;
                removed += 1;
            }
            if n_seen < REMOVALS_AT_ONCE as usize {
                return Ok(removed); // what remains is held or being removed; its time comes
            }
        }
    }

    /// Decides about some candidates: those needed are none any more, those unneeded are marked and returned.
    async fn mark_unneeded(&self) -> Result<(usize, Vec<(ArtifactKey, i64)>), JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            for holder in session.rows(sql!("lapsed_holders"), bind![]).await? {
                end_hold(&mut session, &holder.get::<String>(0)?).await?;
            }
            let candidates =
                session.rows(sql!("lock_candidates"), bind![REMOVALS_AT_ONCE, REMOVAL_LAPSES]).await?;
            let mut unneeded = Vec::new();
            for row in &candidates {
                let (tenant, path): (String, String) = (row.get("tenant")?, row.get("path")?);
                // Asked after the row was locked: who began to refer before has committed. A blob that is held is a
                // candidate again when the hold ends.
                if session.value(sql!("blob_is_needed"), bind![&tenant, &path]).await? == Some(true) {
                    session.execute(sql!("keep_blob"), bind![&tenant, &path]).await?;
                    continue;
                }
                let since: Option<i64> = session.value(sql!("begin_removal"), bind![&tenant, &path]).await?;
                let owner = Tenant::new(&tenant).and_then(|tenant| ArtifactKey::from_path(&tenant, &path));
                let key = owner.ok_or(JobError::Corrupt { what: "a blob's address", source: None })?;
                unneeded.push((key, since.unwrap_or_default()));
            }
            Ok((candidates.len(), unneeded))
        };
        let done = done.await;
        session.end(done).await
    }
}
