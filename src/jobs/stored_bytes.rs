//! The bytes that each tenant has stored, as they were last counted: a count reads all blobs of a tenant.

use super::job::Tenant;
use parking_lot::Mutex;
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// How long a count is used; what is accepted meanwhile is added to it.
const FRESH: Duration = Duration::from_secs(10);

/// The last counts.
#[derive(Debug, Default)]
pub(super) struct StoredBytes(Mutex<HashMap<Tenant, (Instant, u64)>>);

impl StoredBytes {
    /// The last count, and how old it is.
    pub(super) fn counted(&self, tenant: &Tenant) -> Option<(Duration, u64)> {
        let counts = self.0.lock();
        counts.get(tenant).map(|(at, n_bytes)| (at.elapsed(), *n_bytes)).filter(|(age, _)| *age < FRESH)
    }

    pub(super) fn note(&self, tenant: &Tenant, n_bytes: u64) {
        let mut counts = self.0.lock();
        counts.retain(|_, (at, _)| at.elapsed() < FRESH);
        counts.insert(tenant.clone(), (Instant::now(), n_bytes));
    }

    pub(super) fn add(&self, tenant: &Tenant, n_bytes: u64) {
        let mut counts = self.0.lock();
        if let Some((_, counted)) = counts.get_mut(tenant) {
            *counted = counted.saturating_add(n_bytes);
        }
    }
}
