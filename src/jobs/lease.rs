//! A lease: the right of one worker to one job for a limited time, fenced by an epoch.
//!
//! Every claim raises the job's `lease_epoch`. Whatever a worker writes carries the epoch it was given, and a store
//! takes it only from the present one; so a worker that slept past its lease cannot overwrite its successor.

use super::job::{Job, JobId, Tenant};

/// Identity of a worker process, random, so a restarted process is never taken for its predecessor.
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
    /// The fence.
    pub epoch: u64,
    /// Who holds it.
    pub worker: WorkerId,
}

impl Lease {
    /// The name under which blobs are held for what this lease will publish.
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

/// What a heartbeat is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeaseStatus {
    /// Go on.
    Held,
    /// Go no further: the job's end was asked for.
    CancelRequested,
    /// The job is somebody else's now, or finished, or gone.
    Lost,
}

/// What became of jobs whose workers are gone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Recovered {
    /// Wait again.
    pub queued: u32,
    /// Had asked for their end.
    pub cancelled: u32,
    /// Reached the crash limit.
    pub dead: u32,
}

impl Recovered {
    /// All of them.
    pub fn total(self) -> u32 {
        self.queued + self.cancelled + self.dead
    }
}
