//! Following jobs, batches, studies and the feed of changes: one reader of the store for each resource that is followed, however
//! many clients follow it.
//!
//! A reader queries the store at intervals, and at once when this process signals a change of state, and publishes what it
//! finds. It ends when the last follower leaves or when nothing can change any more. A thousand dashboards thus cost the
//! store as much as one.

use super::batch::Batch;
use super::error::JobError;
use super::forecast::Forecast;
use super::ids::{BatchId, JobId, StudyId};
use super::job::{Job, Tenant};
use super::ports::JobStore;
use super::signals::{Moves, Signals};
use super::state::JobState;
use super::study::{Study, StudyStore};
use super::trace::NumberedPoint;
use parking_lot::Mutex;
use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Weak};
use std::time::Duration;
use tokio::sync::watch;

/// Interval between queries for a running job.
const POLL_RUNNING: Duration = Duration::from_millis(150);
/// Interval between queries for a queued job.
const POLL_QUEUED: Duration = Duration::from_millis(250);
/// Interval between queries for a batch, a study or for new changes: jobs of other processes are seen within this time.
const POLL_MANY: Duration = Duration::from_millis(250);
/// Least interval between such queries, however often jobs change.
const LEAST_MANY: Duration = Duration::from_millis(50);
/// Interval between queries while the store fails.
const POLL_FAILING: Duration = Duration::from_secs(1);
/// Maximum number of trace points of one query.
const POINTS: u32 = 5_000;

/// The last published view of a followed job.
#[derive(Debug, Clone)]
pub struct Seen {
    /// The job.
    pub job: Job,
    /// Its trace so far, in the order of `seq`.
    pub points: Vec<Arc<[NumberedPoint]>>,
    /// Whether the job is finished and `points` is its whole trace.
    pub complete: bool,
    /// Whether the job was deleted.
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

/// A resource that is followed. Its reader runs as long as the feed is referenced.
#[derive(Debug)]
pub struct Feed<T> {
    seen: watch::Receiver<Arc<T>>,
    reader: tokio::task::AbortHandle,
}

impl<T> Feed<T> {
    /// The latest that the reader found; changes when the reader finds something else, and closes when the reader ends.
    pub fn seen(&self) -> watch::Receiver<Arc<T>> {
        self.seen.clone()
    }
}

impl<T> Drop for Feed<T> {
    fn drop(&mut self) {
        self.reader.abort();
    }
}

/// Feeds by what they follow.
struct Shared<K, T>(Mutex<HashMap<K, Weak<Feed<T>>>>);

impl<K: Eq + Hash, T> Shared<K, T> {
    fn new() -> Self {
        Shared(Mutex::new(HashMap::new()))
    }

    /// The feed of `key`, or one that starts now with `first` and with the reader that `read` makes.
    fn join<R>(&self, key: K, first: T, read: impl FnOnce(watch::Sender<Arc<T>>) -> R) -> Arc<Feed<T>>
    where
        R: Future<Output = ()> + Send + 'static,
    {
        let mut feeds = self.0.lock();
        let shared = feeds.get(&key).and_then(Weak::upgrade).filter(|feed| !feed.reader.is_finished());
        if let Some(feed) = shared {
            return feed;
        }
        feeds.retain(|_, feed| feed.strong_count() > 0);
        let (sender, seen) = watch::channel(Arc::new(first));
        let reader = tokio::spawn(read(sender)).abort_handle();
        let feed = Arc::new(Feed { seen, reader });
        feeds.insert(key, Arc::downgrade(&feed));
        feed
    }
}

/// The feeds of this process.
pub(super) struct Feeds {
    store: Arc<dyn JobStore>,
    study_store: Arc<dyn StudyStore>,
    forecast: Forecast,
    signals: Arc<Signals>,
    jobs: Shared<(Tenant, JobId), Seen>,
    batches: Shared<(Tenant, BatchId), Batch>,
    studies: Shared<(Tenant, StudyId), Study>,
    changes: Shared<(Tenant, u64), bool>,
}

impl Feeds {
    pub(super) fn new(
        store: Arc<dyn JobStore>,
        study_store: Arc<dyn StudyStore>,
        forecast: Forecast,
        signals: Arc<Signals>,
    ) -> Self {
        let (jobs, batches, studies, changes) = (Shared::new(), Shared::new(), Shared::new(), Shared::new());
        Feeds { store, study_store, forecast, signals, jobs, batches, studies, changes }
    }

    pub(super) async fn follow(&self, tenant: &Tenant, id: JobId) -> Result<Arc<Feed<Seen>>, JobError> {
        // Queried also where a feed exists, so that every follower is shown to own the job.
        let job = self.forecast.of(self.store.get_job(tenant, id).await?);
        let first = Seen { job, points: Vec::new(), complete: false, removed: false };
        let key = (tenant.clone(), id);
        Ok(self.jobs.join(key.clone(), first, |sender| {
            // Subscribes before the first query, so that no change falls between the two.
            let moves = self.signals.moves_of(id);
            read_job(Arc::clone(&self.store), self.forecast.clone(), key, moves, sender)
        }))
    }

    pub(super) async fn follow_batch(&self, tenant: &Tenant, id: BatchId) -> Result<Arc<Feed<Batch>>, JobError> {
        let batch = self.store.get_batch(tenant, id).await?;
        let key = (tenant.clone(), id);
        Ok(self.batches.join(key.clone(), batch, |sender| {
            let moves = self.signals.all_moves();
            let store = Arc::clone(&self.store);
            read_until_end(async move || store.get_batch(&key.0, key.1).await, Batch::is_finished, moves, sender)
        }))
    }

    pub(super) async fn follow_study(&self, tenant: &Tenant, id: StudyId) -> Result<Arc<Feed<Study>>, JobError> {
        let study = self.study_store.get_study(tenant, id).await?;
        let key = (tenant.clone(), id);
        Ok(self.studies.join(key.clone(), study, |sender| {
            let moves = self.signals.all_moves();
            let store = Arc::clone(&self.study_store);
            let has_ended = |study: &Study| study.state.is_final();
            read_until_end(async move || store.get_study(&key.0, key.1).await, has_ended, moves, sender)
        }))
    }

    /// Turns true, and ends, when there are changes after `since`. All clients that have read the feed to its end ask with
    /// the same number, and so share one reader.
    pub(super) fn follow_changes(&self, tenant: &Tenant, since: u64) -> Arc<Feed<bool>> {
        let key = (tenant.clone(), since);
        self.changes.join(key.clone(), false, |sender| {
            let moves = self.signals.all_moves();
            read_changes(Arc::clone(&self.store), key, moves, sender)
        })
    }
}

async fn read_job(
    store: Arc<dyn JobStore>,
    forecast: Forecast,
    (tenant, id): (Tenant, JobId),
    mut moves: Moves,
    sender: watch::Sender<Arc<Seen>>,
) {
    let mut last_seq = 0;
    loop {
        let pause = match look(store.as_ref(), &tenant, id, last_seq).await {
            Ok((job, new_points, complete)) => {
                let job = forecast.of(job);
                last_seq = new_points.last().map_or(last_seq, |p| p.seq);
                let pause = if job.state == JobState::Queued { POLL_QUEUED } else { POLL_RUNNING };
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
                POLL_FAILING
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

/// Whether two queries found the same job, whenever they were made.
fn is_same(a: &Job, b: &Job) -> bool {
    Job { read_at: b.read_at, ..a.clone() } == *b
}

/// Reads a batch or a study whenever something moves, until it has ended or is gone.
async fn read_until_end<T: PartialEq>(
    read: impl AsyncFn() -> Result<T, JobError>,
    has_ended: fn(&T) -> bool,
    mut moves: Moves,
    sender: watch::Sender<Arc<T>>,
) {
    loop {
        match read().await {
            Ok(found) => {
                let ends = has_ended(&found);
                sender.send_if_modified(|seen| {
                    let changed = **seen != found;
                    *seen = Arc::new(found);
                    changed
                });
                if ends {
                    return;
                }
            }
            Err(JobError::BatchNotFound | JobError::StudyNotFound) => return,
            Err(error) => {
                tracing::debug!(%error, "a followed batch or study cannot be read now");
                tokio::time::sleep(POLL_FAILING).await;
            }
        }
        wait_for_move(&mut moves).await;
    }
}

async fn read_changes(
    store: Arc<dyn JobStore>,
    (tenant, since): (Tenant, u64),
    mut moves: Moves,
    sender: watch::Sender<Arc<bool>>,
) {
    loop {
        match store.list_changes(&tenant, since, 1).await {
            Ok(page) if page.changes.is_empty() => {}
            Ok(_) => {
                sender.send_replace(Arc::new(true));
                return;
            }
            Err(error) => {
                tracing::debug!(%error, "the feed of changes cannot be read now");
                tokio::time::sleep(POLL_FAILING).await;
            }
        }
        wait_for_move(&mut moves).await;
    }
}

/// Until any job changes its state, or the interval is over.
async fn wait_for_move(moves: &mut Moves) {
    tokio::time::sleep(LEAST_MANY).await;
    tokio::select! {
        () = moves.next() => {}
        () = tokio::time::sleep(POLL_MANY.saturating_sub(LEAST_MANY)) => {}
    }
}
