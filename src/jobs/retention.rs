//! How long jobs and results are kept, and what was removed.

use std::time::Duration;

/// How long jobs and results are kept; `None` is for ever.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Retention {
    /// Results and traces after the end of their job: as long as was promised when it ended, or for this long, whichever is
    /// shorter, so that an operator can make room.
    pub results: Option<Duration>,
    /// Records of jobs, and with them everything else, after the end of the job. Also uploads that no job refers to, the
    /// feed of changes and the log of deliveries.
    pub jobs: Option<Duration>,
}

/// What a purge removed, or would remove.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Purged {
    /// Jobs whose result and trace were removed; their records stay.
    pub results: u64,
    /// Jobs that were removed entirely.
    pub jobs: u64,
    /// Uploads that no job refers to.
    pub meshes: u64,
    /// Entries of the feed of changes.
    pub changes: u64,
    /// Entries of the log of deliveries.
    pub deliveries: u64,
    /// Expired idempotency keys.
    pub idempotency_keys: u64,
}

impl Purged {
    /// Whether nothing was removed.
    pub fn is_nothing(&self) -> bool {
        *self == Purged::default()
    }
}

/// Jobs that were ended because they exceeded a time limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Overdue {
    /// Queued past their deadline.
    pub expired: u32,
    /// Exceeded their run time, and their worker did not end them.
    pub stuck: u32,
}
