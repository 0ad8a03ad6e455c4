//! The settings of workers.

use super::machine;
use crate::jobs::Retentions;
use std::time::Duration;

/// How workers behave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Cores that jobs may use together.
    pub cores: usize,
    /// Memory that running jobs may be predicted to take together, bytes.
    pub memory_bytes: u64,
    /// Number of jobs that run at the same time, each with an equal share of the cores; `None`: as many as the cores
    /// and the memory are predicted to suffice for.
    pub slots: Option<usize>,
    /// How long later jobs may overtake a job for which not enough cores or memory are free.
    pub patience: Duration,
    /// Duration of a lease.
    pub lease: Duration,
    /// How often leases are extended.
    pub heartbeat: Duration,
    /// How often the queue is read while idle.
    pub poll: Duration,
    /// How often trace and progress are stored.
    pub flush: Duration,
    /// Longest run of a job.
    pub max_run: Duration,
    /// How long a computation may take to stop before its job is ended without it.
    pub stop_timeout: Duration,
    /// How long results are kept.
    pub retention: Retentions,
    /// How long the cores of a computation that does not stop remain reserved before other jobs get them.
    pub abandon_after: Duration,
}

impl Default for WorkerSettings {
    fn default() -> Self {
        WorkerSettings {
            cores: machine::cores(),
            memory_bytes: u64::MAX,
            slots: None,
            patience: Duration::from_secs(10),
            lease: Duration::from_secs(15),
            heartbeat: Duration::from_secs(3),
            poll: Duration::from_millis(250),
            flush: Duration::from_millis(200),
            max_run: Duration::from_secs(3600),
            retention: Retentions::default(),
            stop_timeout: Duration::from_millis(500),
            abandon_after: Duration::from_secs(10),
        }
    }
}
