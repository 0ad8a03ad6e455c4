//! Which blobs are needed: references of jobs, and holds of those who are about to refer.
//!
//! Content-addressed blobs are shared, so a removal must not meet a submission of the same bytes half-way. Who
//! writes a blob first takes a hold on it; a removal looks for references and holds and removes in one write
//! transaction. So a hold is either seen, or begins after the blob is gone and writes it anew.

use super::{SqliteStore, domain_error, query_text, rows};
use crate::jobs::{ArtifactKey, ArtifactStore, JobError, Tenant};
use sqlx::SqliteConnection;
use std::time::Duration;

/// Most blobs removed in one transaction: it keeps other writers waiting.
const REMOVALS_AT_ONCE: i64 = 32;

/// Ends a hold; its blobs become candidates for removal, which keeps those that are referred to.
pub(super) async fn end_hold(connection: &mut SqliteConnection, holder: &str) -> Result<(), JobError> {
    for text in [query_text!("note_candidates_of_holder"), query_text!("drop_hold")] {
        sqlx::query(text).bind(holder).execute(&mut *connection).await.map_err(domain_error)?;
    }
    Ok(())
}

impl SqliteStore {
    pub(super) async fn hold(&self, holder: &str, keys: &[ArtifactKey], for_at_most: Duration) -> Result<(), JobError> {
        let mut writing = self.begin().await?;
        for key in keys {
            sqlx::query(query_text!("hold_blob"))
                .bind(holder)
                .bind(key.tenant.name())
                .bind(&key.hash)
                .bind(rows::milliseconds(for_at_most))
                .execute(&mut *writing)
                .await
                .map_err(domain_error)?;
        }
        writing.commit().await.map_err(domain_error)
    }

    pub(super) async fn end_hold(&self, holder: &str) -> Result<(), JobError> {
        let mut writing = self.begin().await?;
        end_hold(&mut writing, holder).await?;
        writing.commit().await.map_err(domain_error)
    }

    pub(super) async fn remove_unreferenced(&self, artifacts: &dyn ArtifactStore) -> Result<u32, JobError> {
        let mut removed = 0;
        loop {
            // Looked at without a lock first: mostly there is nothing to do.
            let work: bool = sqlx::query_scalar(query_text!("has_work_for_removal"))
                .fetch_one(&self.readers)
                .await
                .map_err(domain_error)?;
            if !work {
                return Ok(removed);
            }
            let mut writing = self.begin().await?;
            for text in [
                query_text!("note_candidates_of_lapsed_holds"),
                query_text!("drop_lapsed_holds"),
                query_text!("forget_referenced_candidates"),
            ] {
                sqlx::query(text).execute(&mut *writing).await.map_err(domain_error)?;
            }
            let candidates: Vec<(String, String)> = sqlx::query_as(query_text!("unreferenced_candidates"))
                .bind(REMOVALS_AT_ONCE)
                .fetch_all(&mut *writing)
                .await
                .map_err(domain_error)?;
            let n_candidates = candidates.len();
            for (tenant, hash) in candidates {
                let owner = Tenant::new(&tenant).ok_or(JobError::Corrupt { what: "a tenant", source: None })?;
                artifacts.remove(&ArtifactKey { tenant: owner, hash: hash.clone() }).await?;
                sqlx::query(query_text!("forget_candidate"))
                    .bind(tenant)
                    .bind(hash)
                    .execute(&mut *writing)
                    .await
                    .map_err(domain_error)?;
                removed += 1;
            }
            writing.commit().await.map_err(domain_error)?;
            if (n_candidates as i64) < REMOVALS_AT_ONCE {
                return Ok(removed); // what remains is held; its time comes
            }
        }
    }
}
