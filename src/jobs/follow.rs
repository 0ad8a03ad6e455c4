//! Following a job: one reader of the store for each job that is followed, however many follow it.
//!
//! The reader asks the store at intervals, and when this process is told that the job moved on, and shares what it saw; it
//! ends when nobody follows any more or the job is finished. So a thousand dashboards cost the store as much as one.

use super::error::JobError;
use super::job::{Job, JobId, Tenant};
use super::ports::JobStore;
use super::signals::{Moves, Signals};
use super::state::JobState;
use super::trace::NumberedPoint;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::Duration;
use tokio::sync::watch;

/// Between two looks at a running job.
const LOOK_RUNNING: Duration = Duration::from_millis(150);
/// Between two looks at a waiting job.
const LOOK_QUEUED: Duration = Duration::from_millis(250);
/// Between two looks while the store does not answer.
const LOOK_FAILING: Duration = Duration::from_secs(1);
/// Points read at once.
const POINTS: u32 = 5_000;

/// What is known of a job at a moment.
#[derive(Debug, Clone)]
pub struct Seen {
    /// The job.
    pub job: Job,
    /// Its trace so far, in the order of `seq`.
    pub points: Vec<Arc<[NumberedPoint]>>,
    /// Whether the job is finished and `points` is all of its trace.
    pub complete: bool,
    /// Whether the job was removed.
    pub removed: bool,
}

impl Seen {
    /// The points after `seq`.
    pub fn points_after(&self, seq: u64) -> impl Iterator<Item = &NumberedPoint> {
        self.points
            .iter()
            .skip_while(move |chunk| chunk.last().is_none_or(|last| last.seq <= seq))
            .flat_map(|chunk| chunk.iter())
            .filter(move |point| point.seq > seq)
    }
}

/// A job that is followed.
#[derive(Debug)]
pub struct Feed {
    seen: watch::Receiver<Arc<Seen>>,
    reader: tokio::task::AbortHandle,
}

impl Feed {
    /// What is seen, now and whenever it changes.
    pub fn seen(&self) -> watch::Receiver<Arc<Seen>> {
        self.seen.clone()
    }
}

impl Drop for Feed {
    fn drop(&mut self) {
        self.reader.abort();
    }
}

/// The jobs that are followed in this process.
pub(super) struct Feeds {
    store: Arc<dyn JobStore>,
    signals: Arc<Signals>,
    feeds: Mutex<HashMap<(Tenant, JobId), Weak<Feed>>>,
}

impl Feeds {
    pub(super) fn new(store: Arc<dyn JobStore>, signals: Arc<Signals>) -> Self {
        Feeds { store, signals, feeds: Mutex::default() }
    }

    pub(super) async fn follow(&self, tenant: &Tenant, id: JobId) -> Result<Arc<Feed>, JobError> {
        // Asked in any case: who follows sees the job as it is now, and whether it is theirs.
        let job = self.store.get_job(tenant, id).await?;
        let mut feeds = self.feeds.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (tenant.clone(), id);
        let followed = feeds.get(&key).and_then(Weak::upgrade).filter(|feed| !feed.reader.is_finished());
        if let Some(feed) = followed {
            return Ok(feed);
        }
        feeds.retain(|_, feed| feed.strong_count() > 0);
        let first = Seen { job, points: Vec::new(), complete: false, removed: false };
        let (sender, seen) = watch::channel(Arc::new(first));
        // Listens before it first looks, so that no move falls between the two.
        let moves = self.signals.moves_of(id);
        let reader = tokio::spawn(read(Arc::clone(&self.store), key.clone(), moves, sender)).abort_handle();
        let feed = Arc::new(Feed { seen, reader });
        feeds.insert(key, Arc::downgrade(&feed));
        Ok(feed)
    }
}

async fn read(
    store: Arc<dyn JobStore>,
    (tenant, id): (Tenant, JobId),
    mut moves: Moves,
    sender: watch::Sender<Arc<Seen>>,
) {
    let mut last_seq = 0;
    loop {
        let pause = match look(store.as_ref(), &tenant, id, last_seq).await {
            Ok((job, new_points, complete)) => {
                last_seq = new_points.last().map_or(last_seq, |p| p.seq);
                let pause = if job.state == JobState::Queued { LOOK_QUEUED } else { LOOK_RUNNING };
                sender.send_if_modified(|seen| {
                    if new_points.is_empty() && seen.complete == complete && is_same(&seen.job, &job) {
                        return false;
                    }
                    let mut points = seen.points.clone();
                    if !new_points.is_empty() {
                        points.push(new_points.into());
                    }
                    *seen = Arc::new(Seen { job, points, complete, removed: false });
                    true
                });
                if complete {
                    return;
                }
                pause
            }
            Err(JobError::NotFound) => {
                sender.send_modify(|seen| *seen = Arc::new(Seen { removed: true, ..seen.as_ref().clone() }));
                return;
            }
            Err(error) => {
                tracing::debug!(job_id = %id, %error, "a followed job cannot be read now");
                LOOK_FAILING
            }
        };
        tokio::select! {
            () = moves.next() => {}
            () = tokio::time::sleep(pause) => {}
        }
    }
}

/// The job, the points after `last_seq`, and whether that is all. The trace is read after the job, so that a finished
/// job's last points are never missed.
async fn look(
    store: &dyn JobStore,
    tenant: &Tenant,
    id: JobId,
    last_seq: u64,
) -> Result<(Job, Vec<NumberedPoint>, bool), JobError> {
    let job = store.get_job(tenant, id).await?;
    let page = store.get_trace(tenant, id, last_seq, POINTS).await?;
    let complete = job.state.is_final() && page.complete;
    Ok((job, page.points, complete))
}

/// Whether two looks saw the same, whenever they were.
fn is_same(a: &Job, b: &Job) -> bool {
    Job { read_at: b.read_at, ..a.clone() } == *b
}
