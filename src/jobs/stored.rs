//! The bytes that a tenant has stored, counted at most every few seconds: a count reads all of its blobs.

use super::error::JobError;
use super::job::Tenant;
use super::service::JobService;
use std::time::Duration;

/// How long a count is used that leaves no room.
const RECOUNTED: Duration = Duration::from_secs(1);

impl JobService {
    /// Refuses to store `n_bytes` more of a tenant that would then have more than its share.
    ///
    /// # Errors
    /// [`JobError::ShareFull`], and those of the store.
    pub(super) async fn refuse_over_share(&self, tenant: &Tenant, n_bytes: u64) -> Result<(), JobError> {
        let Some(limit) = self.limits.max_stored_bytes else { return Ok(()) };
        let over = |stored: u64| stored.saturating_add(n_bytes) > limit;
        let stored = match self.stored.counted(tenant) {
            Some((age, stored)) if !over(stored) || age < RECOUNTED => stored,
            // Something may have been deleted since.
            _ => {
                let counted = self.stores.jobs.stored_bytes(tenant).await?;
                self.stored.note(tenant, counted);
                counted
            }
        };
        if over(stored) { Err(JobError::ShareFull { stored, limit }) } else { Ok(()) }
    }

    /// Adds bytes that were accepted to the last count.
    pub(super) fn note_stored(&self, tenant: &Tenant, n_bytes: u64) {
        self.stored.add(tenant, n_bytes);
    }
}
