//! The bytes that a tenant has stored, counted at most every few seconds: a count reads all of its blobs.

use super::error::JobError;
use super::job::Tenant;
use super::service::JobService;
use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How long a count is used; what is accepted meanwhile is added to it.
const FRESH: Duration = Duration::from_secs(10);
/// How long a count is used that leaves no room.
const RECOUNTED: Duration = Duration::from_secs(1);

/// The last counts.
#[derive(Debug, Default)]
pub(super) struct StoredBytes(Mutex<HashMap<Tenant, (Instant, u64)>>);

impl StoredBytes {
    /// The last count, and how old it is.
    fn counted(&self, tenant: &Tenant) -> Option<(Duration, u64)> {
        let counts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        counts.get(tenant).map(|(at, n_bytes)| (at.elapsed(), *n_bytes)).filter(|(age, _)| *age < FRESH)
    }

    fn note(&self, tenant: &Tenant, n_bytes: u64) {
        let mut counts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        counts.retain(|_, (at, _)| at.elapsed() < FRESH);
        counts.insert(tenant.clone(), (Instant::now(), n_bytes));
    }

    fn add(&self, tenant: &Tenant, n_bytes: u64) {
        let mut counts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, counted)) = counts.get_mut(tenant) {
            *counted = counted.saturating_add(n_bytes);
        }
    }
}

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
