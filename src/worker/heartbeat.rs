//! Heartbeats of all running jobs of this process, on a separate operating-system thread.
//!
//! The thread has its own small runtime and its own connections to the store. It extends leases and sees requests to
//! cancel even when the cores, the main runtime or the other connections are busy.

use super::control::{Control, StopCause};
use crate::jobs::{JobError, JobStore, Lease, LeaseStatus};
use futures_util::future::join_all;
use parking_lot::Mutex;
use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How often the status of each lease is read: the longest delay until a request to cancel is seen.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);

/// The heartbeats of a process; they stop when this is dropped.
#[derive(Debug)]
pub(crate) struct Heartbeats {
    shared: Arc<Shared>,
}

#[derive(Debug)]
struct Shared {
    watched: Mutex<HashMap<Lease, Watched>>,
    healthy: AtomicBool,
    ended: AtomicBool,
}

#[derive(Debug, Clone)]
struct Watched {
    control: Arc<Control>,
    /// When the lease was last extended.
    extended: Instant,
    /// When an extension was last attempted.
    attempted: Instant,
}

/// Keeps a lease alive until it is dropped.
#[derive(Debug)]
pub(crate) struct Watch {
    shared: Arc<Shared>,
    lease: Lease,
}

impl Heartbeats {
    /// Starts the thread, which extends each watched lease every `interval` to `duration` from then.
    ///
    /// # Errors
    /// If no thread can be started.
    pub(crate) fn start(store: Arc<dyn JobStore>, interval: Duration, duration: Duration) -> std::io::Result<Self> {
        let shared = Arc::new(Shared {
            watched: Mutex::default(),
            healthy: AtomicBool::new(true),
            ended: AtomicBool::new(false),
        });
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        let checked = Arc::clone(&shared);
        std::thread::Builder::new().name("heartbeat".to_owned()).spawn(move || {
            runtime.block_on(async {
                while !checked.ended.load(Ordering::Acquire) {
                    check_all(&checked, store.as_ref(), interval, duration).await;
                    tokio::time::sleep(CHECK_INTERVAL).await;
                }
            });
        })?;
        Ok(Heartbeats { shared })
    }

    /// Keeps `lease` alive. Stops the computation of `control` when the lease is lost or cancellation of the job is
    /// requested.
    pub(crate) fn watch(&self, lease: &Lease, control: Arc<Control>) -> Watch {
        let now = Instant::now();
        let watched = Watched { control, extended: now, attempted: now };
        self.shared.watched.lock().insert(lease.clone(), watched);
        Watch { shared: Arc::clone(&self.shared), lease: lease.clone() }
    }

    /// Whether the store answered last time. While it does not answer, no further job should start.
    pub(crate) fn is_healthy(&self) -> bool {
        self.shared.healthy.load(Ordering::Acquire)
    }
}

impl Drop for Heartbeats {
    fn drop(&mut self) {
        self.shared.ended.store(true, Ordering::Release);
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        self.shared.watched.lock().remove(&self.lease);
    }
}

async fn check_all(shared: &Shared, store: &dyn JobStore, interval: Duration, duration: Duration) {
    let watched: Vec<(Lease, Watched)> = shared.watched.lock().iter().map(|(l, w)| (l.clone(), w.clone())).collect();
    // Concurrently: one unanswered statement must not delay the others until their leases expire.
    join_all(watched.iter().map(|(lease, watched)| check(shared, store, lease, watched, interval, duration))).await;
    if shared.watched.lock().is_empty() && !shared.healthy.load(Ordering::Acquire) {
        shared.healthy.store(store.ping().await.is_ok(), Ordering::Release);
    }
}

/// Extends a lease if the extension is due, otherwise only reads its status; tells the computation what the store
/// answered.
async fn check(
    shared: &Shared,
    store: &dyn JobStore,
    lease: &Lease,
    Watched { control, extended, attempted }: &Watched,
    interval: Duration,
    duration: Duration,
) {
    let asked = Instant::now();
    let due = asked - *attempted >= interval;
    let answer = if due { store.heartbeat(lease, duration).await } else { store.lease_status(lease).await };
    shared.healthy.store(answer.is_ok(), Ordering::Release);
    let mut held = shared.watched.lock();
    let Some(entry) = held.get_mut(lease) else { return };
    if due {
        entry.attempted = asked;
    }
    match answer {
        Ok(LeaseStatus::Lost) | Err(JobError::LeaseLost) => control.stop(StopCause::LeaseLost),
        Ok(status) => {
            if due {
                entry.extended = asked;
            }
            if status == LeaseStatus::CancelRequested {
                control.stop(StopCause::CancelRequested);
            }
        }
        Err(error) => {
            tracing::warn!(job_id = %lease.job_id, %error, "heartbeat failed");
            // The next check attempts it again, without waiting a whole interval.
            if let Some(earlier) = asked.checked_sub(interval) {
                entry.attempted = earlier;
            }
            // Another worker may hold the job by now; the fence would refuse every write of this worker.
            if extended.elapsed() > duration {
                control.stop(StopCause::LeaseLost);
            }
        }
    }
}
