//! How long things are kept, and what was removed.

use std::time::Duration;

/// How long things are kept; `None` is for ever.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Retention {
    /// Results and traces after the end of their job.
    pub results: Option<Duration>,
    /// Records of jobs, and with them everything else, after the end of the job. Also uploads that no job refers to, the
    /// feed of changes and the log of deliveries.
    pub jobs: Option<Duration>,
}

/// What a purge removed, or would remove.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Purged {
    /// Jobs whose result and trace went; their record stays.
    pub results: u64,
    /// Jobs that went altogether.
    pub jobs: u64,
    /// Uploads that no job refers to.
    pub meshes: u64,
    /// Entries of the feed of changes.
    pub changes: u64,
    /// Entries of the log of deliveries.
    pub deliveries: u64,
    /// Idempotency keys whose time was over.
    pub idempotency_keys: u64,
}

impl Purged {
    /// Whether there was nothing to do.
    pub fn is_nothing(&self) -> bool {
        *self == Purged::default()
    }
}

/// Jobs that were ended because their time was over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Overdue {
    /// Waited past their deadline.
    pub expired: u32,
    /// Ran longer than they may, and their worker did not end them.
    pub stuck: u32,
}
