//! Heartbeats of all running jobs of this process, on an operating-system thread of their own.
//!
//! The thread has its own small runtime and its own connections to the store. However busy the cores, the other
//! runtime or the other connections are, leases are prolonged and requests to cancel are seen.

use super::control::{Control, StopCause};
use crate::jobs::{JobError, JobStore, Lease, LeaseStatus};
use futures_util::future::join_all;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How often leases are looked at; bounds how late a request to cancel is seen.
const LOOK: Duration = Duration::from_millis(100);

/// The heart of a process; stops beating when dropped.
#[derive(Debug)]
pub struct Heart {
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
    prolonged: Instant,
    tried: Instant,
}

/// Keeps a lease alive until it is dropped.
#[derive(Debug)]
pub struct Watch {
    shared: Arc<Shared>,
    lease: Lease,
}

impl Heart {
    /// Begins to beat: every `interval` each watched lease is prolonged to `duration` from then.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(store: Arc<dyn JobStore>, interval: Duration, duration: Duration) -> std::io::Result<Self> {
        let shared = Arc::new(Shared {
            watched: Mutex::default(),
            healthy: AtomicBool::new(true),
            ended: AtomicBool::new(false),
        });
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        let beating = Arc::clone(&shared);
        std::thread::Builder::new().name("heartbeat".to_owned()).spawn(move || {
            runtime.block_on(async {
                while !beating.ended.load(Ordering::Acquire) {
                    beat(&beating, store.as_ref(), interval, duration).await;
                    tokio::time::sleep(LOOK).await;
                }
            });
        })?;
        Ok(Heart { shared })
    }

    /// Keeps `lease` alive and tells `control` what the store says of it.
    pub fn watch(&self, lease: &Lease, control: Arc<Control>) -> Watch {
        let now = Instant::now();
        let watched = Watched { control, prolonged: now, tried: now };
        self.shared.lock().insert(lease.clone(), watched);
        Watch { shared: Arc::clone(&self.shared), lease: lease.clone() }
    }

    /// Whether the last look at the store succeeded; while it does not, no new job should be begun.
    pub fn is_healthy(&self) -> bool {
        self.shared.healthy.load(Ordering::Acquire)
    }
}

impl Drop for Heart {
    fn drop(&mut self) {
        self.shared.ended.store(true, Ordering::Release);
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        self.shared.lock().remove(&self.lease);
    }
}

impl Shared {
    fn lock(&self) -> std::sync::MutexGuard<'_, HashMap<Lease, Watched>> {
        self.watched.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

async fn beat(shared: &Shared, store: &dyn JobStore, interval: Duration, duration: Duration) {
    let watched: Vec<(Lease, Watched)> = shared.lock().iter().map(|(l, w)| (l.clone(), w.clone())).collect();
    // Side by side: a store that swallows one question must not hold up the others until their leases ran out.
    join_all(watched.iter().map(|(lease, watched)| look(shared, store, lease, watched, interval, duration))).await;
    if shared.lock().is_empty() && !shared.healthy.load(Ordering::Acquire) {
        shared.healthy.store(store.ping().await.is_ok(), Ordering::Release);
    }
}

/// Prolongs a lease if that is due, else only looks at it, and tells its computation what the store says.
async fn look(
    shared: &Shared,
    store: &dyn JobStore,
    lease: &Lease,
    Watched { control, prolonged, tried }: &Watched,
    interval: Duration,
    duration: Duration,
) {
    let asked = Instant::now();
    let due = asked - *tried >= interval;
    let answer = if due { store.heartbeat(lease, duration).await } else { store.lease_status(lease).await };
    shared.healthy.store(answer.is_ok(), Ordering::Release);
    let mut held = shared.lock();
    let Some(entry) = held.get_mut(lease) else { return };
    if due {
        entry.tried = asked;
    }
    match answer {
        Ok(LeaseStatus::Lost) | Err(JobError::LeaseLost) => control.stop(StopCause::LeaseLost),
        Ok(status) => {
            if due {
                entry.prolonged = asked;
            }
            if status == LeaseStatus::CancelRequested {
                control.stop(StopCause::CancelRequested);
            }
        }
        Err(error) => {
            tracing::warn!(job_id = %lease.job_id, %error, "heartbeat failed");
            // Tried again at the next look, not only after a whole interval.
            if let Some(earlier) = asked.checked_sub(interval) {
                entry.tried = earlier;
            }
            // By now another worker may have the job; the fence would refuse what this one writes.
            if prolonged.elapsed() > duration {
                control.stop(StopCause::LeaseLost);
            }
        }
    }
}
