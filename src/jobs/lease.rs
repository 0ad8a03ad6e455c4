//! A lease: the right of one worker to one job for a limited time, fenced by an epoch.
//!
//! Every claim increments the job's `lease_epoch`. Everything that a worker writes carries the epoch of its claim, and the
//! store accepts only the current epoch; so a worker that was suspended past its lease cannot overwrite its successor.

use super::ids::JobId;
use super::job::{Job, Tenant};

/// Identity of a worker process: random, so that a restarted process is never mistaken for its predecessor.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct WorkerId(String);

impl WorkerId {
    /// A new identity.
    pub fn random() -> Self {
        WorkerId(uuid::Uuid::new_v4().to_string())
    }

    /// The identity with this name.
    pub fn from_name(name: &str) -> Self {
        WorkerId(name.to_owned())
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.0
    }
}

/// The right to work on a job.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Lease {
    /// The job.
    pub job_id: JobId,
    /// Its owner.
    pub tenant: Tenant,
    /// Number of the claim; the fence.
    pub epoch: u64,
    /// The worker that holds it.
    pub worker: WorkerId,
}

impl Lease {
    /// The name under which the blobs of its result are held.
    pub fn holder(&self) -> String {
        format!("{}:{}", self.job_id, self.epoch)
    }
}

/// A claimed job with its lease.
#[derive(Debug, Clone, PartialEq)]
pub struct LeasedJob {
    /// The lease.
    pub lease: Lease,
    /// The job as it was when it was claimed.
    pub job: Job,
}

/// The status of a lease, as a heartbeat returns it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeaseStatus {
    /// The worker holds it.
    Held,
    /// The worker holds it, and cancellation of the job was requested.
    CancelRequested,
    /// Another worker holds the job, or the job has finished or was deleted.
    Lost,
}

/// Counts of jobs that were taken back from lost workers, by their new state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Recovered {
    /// Returned to the queue.
    pub queued: u32,
    /// Cancelled, because that had been requested.
    pub cancelled: u32,
    /// Dead, because they reached the limit of lost workers.
    pub dead: u32,
}

impl Recovered {
    /// All of them.
    pub fn total(self) -> u32 {
        self.queued + self.cancelled + self.dead
    }
}
