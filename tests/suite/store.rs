//! One suite for all job stores and blob stores: SQLite with a folder, and PostgreSQL with an S3 server.

use super::faults::site::{Backend, Site};
use super::jobs_support::doubtful;
use homolog::jobs::job::Order;
use homolog::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, ArtifactStore, BlobHolds, Failure, Housekeeping, Job, JobError,
    JobFilter, JobId, JobInput, JobQueue, JobReader, JobState, JobWriter, Lease, LeaseStatus, NewJob, NumberedPoint,
    Outcome, PageRequest, Progress, Recovered, Tenant, TraceChunk, WaitingJob, WorkerId,
};
use homolog::store::sql::{SqlStore, StoreSettings};
use homolog_primitives::observe::{Phase, TracePoint};
use serde_json::json;
use std::sync::Arc;
use std::time::Duration;

pub(crate) const LONG: Duration = Duration::from_secs(60);
pub(crate) const SHORT: Duration = Duration::from_millis(30);

pub(crate) struct Fixture {
    pub store: Arc<SqlStore>,
    pub artifacts: Arc<dyn ArtifactStore>,
    pub worker: WorkerId,
    pub tenant: Tenant,
    pub site: Site,
}

impl Fixture {
    pub(crate) async fn open(backend: Backend) -> Self {
        let site = Site::open(backend);
        std::fs::create_dir_all(site.data_dir()).unwrap();
        let store = Arc::new(SqlStore::open(&site.location()).await.unwrap());
        let artifacts = site.artifacts();
        Fixture { store, artifacts, worker: WorkerId::random(), tenant: Tenant::default(), site }
    }

    /// A store with separate connections, as another process has.
    pub(crate) async fn another(&self) -> SqlStore {
        SqlStore::open(&self.site.location()).await.unwrap()
    }

    pub(crate) async fn add(&self, priority: i32) -> Job {
        self.store.insert_job(&new_job(priority), &room(1000)).await.unwrap()
    }

    pub(crate) async fn claim(&self, duration: Duration) -> Lease {
        self.store.claim_next(&self.worker, duration, LONG).await.unwrap().unwrap().lease
    }

    pub(crate) async fn state(&self, id: JobId) -> JobState {
        self.store.get_job(&self.tenant, id).await.unwrap().state
    }

    async fn expire(&self) -> Recovered {
        tokio::time::sleep(SHORT * 2).await;
        self.store.recover_expired().await.unwrap()
    }

    pub(crate) async fn seqs(&self, id: JobId, after: u64, limit: u32) -> Vec<u64> {
        let page = self.store.get_trace(&self.tenant, id, after, limit).await.unwrap();
        page.points.iter().map(|p| p.seq).collect()
    }
}

/// Admission to a queue of at most `max_queued` jobs.
pub(crate) fn room(max_queued: u32) -> Admission {
    Admission { max_queued, holder: String::new(), keep_result: None, once: None }
}

pub(crate) fn new_job(priority: i32) -> NewJob {
    let input = |hash: char| JobInput {
        hash: hash.to_string().repeat(64),
        n_bytes: 1,
        name_hint: None,
        n_vertices: 1,
        n_faces: 1,
        report: json!({}),
    };
    NewJob {
        id: JobId::new(),
        tenant: Tenant::default(),
        method: "m".to_owned(),
        method_version: "1".to_owned(),
        parameters: json!({"seed": 1}),
        source: input('a'),
        target: input('b'),
        priority,
        tags: homolog::jobs::metadata::Tags::default(),
        external_ref: None,
        max_attempts: 3,
        deadline_at: None,
        max_run_ms: None,
        retry_of: None,
        batch_id: None,
        study_id: None,
        study_task: None,
        cache_key: None,
        use_cache: true,
        traceparent: None,
    }
}

pub(crate) fn chunk(seqs: std::ops::RangeInclusive<u64>) -> TraceChunk {
    let last = *seqs.end();
    let points =
        seqs.map(|seq| NumberedPoint { seq, point: TracePoint::new(0, Phase::Inference, seq as u32), elapsed_ms: seq });
    let progress =
        Progress { fraction: last as f64 / 100.0, phase: None, iteration: None, message: None, energy_latest: None };
    TraceChunk { points: points.collect(), progress }
}

pub(crate) fn result(hash: char) -> Outcome {
    let key = ArtifactKey::of_hash(&Tenant::default(), &hash.to_string().repeat(64)).unwrap();
    let artifacts = vec![ArtifactRef { kind: ArtifactKind::Result, key, n_bytes: 1 }];
    Outcome::Succeeded { artifacts, verdict: Some(doubtful()) }
}

pub(crate) fn is_lost<T: std::fmt::Debug>(answer: Result<T, JobError>) -> bool {
    matches!(answer, Err(JobError::LeaseLost))
}

async fn jobs_are_claimed_by_priority_then_age(f: Fixture) {
    let jobs = [f.add(0).await, f.add(5).await, f.add(0).await, f.add(-1).await, f.add(5).await];
    let mut order = Vec::new();
    while let Some(leased) = f.store.claim_next(&f.worker, LONG, LONG).await.unwrap() {
        order.push(leased.lease.job_id);
    }
    assert_eq!(order, [1, 4, 0, 2, 3].map(|i: usize| jobs[i].id));
}

async fn the_front_of_the_queue_is_in_the_order_of_claims(f: Fixture) {
    let jobs = [f.add(0).await, f.add(5).await, f.add(0).await, f.add(-1).await];
    let order = [1, 0, 2, 3].map(|i: usize| jobs[i].id);
    let ids = |front: &[WaitingJob]| front.iter().map(|job| job.id).collect::<Vec<_>>();
    assert_eq!(ids(&f.store.front_of_queue(3).await.unwrap()), order[..3]);
    let front = f.store.front_of_queue(10).await.unwrap();
    assert_eq!((ids(&front), &front[0].parameters), (order.to_vec(), &json!({"seed": 1})));
    assert_eq!((front[0].source.n_vertices, front[0].target.n_faces), (1, 1));
    assert!(front.iter().all(|job| job.waited < LONG), "{front:?}");
    tokio::time::sleep(SHORT).await;
    assert!(f.store.front_of_queue(1).await.unwrap()[0].waited >= SHORT / 2);

    let claim = async |jobs: &[JobId]| f.store.claim_one_of(jobs, &f.worker, LONG, LONG).await.unwrap();
    let leased = claim(&[order[2], order[0]]).await.unwrap();
    assert_eq!((leased.job.id, leased.lease.epoch, leased.job.state), (order[2], 1, JobState::Running));
    assert_eq!(claim(&[order[2], order[0]]).await.unwrap().job.id, order[0], "the first job that is still queued");
    assert!(claim(&[order[2], order[0]]).await.is_none());
    f.store.release_job(&leased.lease).await.unwrap();
    assert_eq!(ids(&f.store.front_of_queue(10).await.unwrap()), [order[1], order[2], order[3]]);
    assert_eq!(claim(&order[2..3]).await.unwrap().lease.epoch, 2);
}

async fn claimers_that_see_the_same_queue_get_different_jobs(f: Fixture) {
    for _ in 0..40 {
        f.add(0).await;
    }
    let mut claimers = tokio::task::JoinSet::new();
    for _ in 0..8 {
        let store = f.another().await;
        claimers.spawn(async move {
            let (worker, mut claimed) = (WorkerId::random(), Vec::new());
            loop {
                let front: Vec<_> = store.front_of_queue(64).await.unwrap().iter().map(|job| job.id).collect();
                match store.claim_one_of(&front, &worker, LONG, LONG).await.unwrap() {
                    Some(leased) => claimed.push(leased.job.id),
                    None if front.is_empty() => return claimed,
                    None => {}
                }
            }
        });
    }
    let mut claimed: Vec<_> = claimers.join_all().await.concat();
    claimed.sort();
    claimed.dedup();
    assert_eq!(claimed.len(), 40);
}

async fn no_job_is_claimed_twice(f: Fixture) {
    for _ in 0..40 {
        f.add(0).await;
    }
    let mut claimers = tokio::task::JoinSet::new();
    for _ in 0..8 {
        // Each with separate connections, as in another process.
        let store = f.another().await;
        claimers.spawn(async move {
            let worker = WorkerId::random();
            let mut claimed = Vec::new();
            while let Some(leased) = store.claim_next(&worker, LONG, LONG).await.unwrap() {
                claimed.push((leased.lease.job_id, leased.lease.epoch));
            }
            claimed
        });
    }
    let mut claimed: Vec<_> = claimers.join_all().await.concat();
    claimed.sort();
    assert_eq!(claimed.len(), 40);
    claimed.dedup();
    assert_eq!(claimed.len(), 40);
}

async fn a_stale_worker_changes_nothing(f: Fixture) {
    let job = f.add(0).await;
    let stale = f.claim(SHORT).await;
    f.store.append_trace(&stale, &chunk(1..=3)).await.unwrap();
    assert_eq!(f.expire().await, Recovered { queued: 1, ..Recovered::default() });
    assert!(is_lost(f.store.finish_job(&stale, &result('c'), None).await), "queued again");
    let fresh = f.claim(LONG).await;
    assert_eq!(fresh.epoch, stale.epoch + 1);

    assert!(is_lost(f.store.append_trace(&stale, &chunk(4..=5)).await));
    assert!(is_lost(f.store.finish_job(&stale, &result('c'), None).await));
    assert!(is_lost(f.store.release_job(&stale).await));
    assert_eq!(f.store.heartbeat(&stale, LONG).await.unwrap(), LeaseStatus::Lost);
    assert_eq!(f.store.lease_status(&stale).await.unwrap(), LeaseStatus::Lost);
    assert_eq!(f.store.heartbeat(&fresh, LONG).await.unwrap(), LeaseStatus::Held);

    f.store.finish_job(&fresh, &result('d'), None).await.unwrap();
    assert!(is_lost(f.store.finish_job(&fresh, &result('e'), None).await), "a result is accepted once");
    assert!(is_lost(f.store.finish_job(&fresh, &Outcome::Cancelled, None).await));
    let (state, artifact) = f.store.get_artifact(&f.tenant, job.id, ArtifactKind::Result).await.unwrap();
    assert_eq!(state, JobState::Succeeded);
    assert_eq!(artifact.unwrap().key.hash(), "d".repeat(64));
}

async fn a_heartbeat_renews_the_lease(f: Fixture) {
    f.add(0).await;
    let lease = f.claim(SHORT).await;
    f.store.heartbeat(&lease, LONG).await.unwrap();
    assert_eq!(f.expire().await, Recovered::default());
}

async fn a_job_that_keeps_crashing_becomes_dead_and_others_run(f: Fixture) {
    let poison = f.add(9).await;
    let other = f.add(0).await;
    for _ in 0..2 {
        assert_eq!(f.claim(SHORT).await.job_id, poison.id);
        assert_eq!(f.expire().await.queued, 1);
    }
    let last = f.claim(SHORT).await;
    assert_eq!(f.expire().await.dead, 1);
    let dead = f.store.get_job(&f.tenant, poison.id).await.unwrap();
    assert_eq!((dead.state, dead.crashes, dead.attempt), (JobState::Dead, 3, 3));
    assert_eq!(dead.error.unwrap().code, "crash-limit-reached");
    assert!(is_lost(f.store.finish_job(&last, &result('c'), None).await));
    assert_eq!(f.claim(LONG).await.job_id, other.id);
}

async fn a_job_whose_workers_crash_waits_longer_each_time(f: Fixture) {
    let pause = Duration::from_millis(300);
    let settings = StoreSettings { crash_pause: pause, ..StoreSettings::default() };
    let store = f.another().await.with(settings);
    let (poison, other) = (f.add(9).await, f.add(0).await);
    for crashes in 1..=2 {
        let claimed = store.claim_next(&f.worker, SHORT, LONG).await.unwrap().unwrap();
        assert_eq!(claimed.lease.job_id, poison.id);
        tokio::time::sleep(SHORT * 2).await;
        assert_eq!(store.recover_expired().await.unwrap().queued, 1);
        // Other jobs run in the meantime, whatever their priority.
        if crashes == 1 {
            assert_eq!(store.claim_next(&f.worker, LONG, LONG).await.unwrap().unwrap().lease.job_id, other.id);
        }
        let waiting = std::time::Instant::now();
        while store.front_of_queue(1).await.unwrap().is_empty() {
            tokio::time::sleep(Duration::from_millis(10)).await;
        }
        let expected = pause * 5u32.pow(crashes - 1);
        assert!(waiting.elapsed() > expected / 2, "{:?}", waiting.elapsed());
    }
}

async fn jobs_of_a_lost_process_are_requeued_at_once_and_others_keep_theirs(f: Fixture) {
    let (first, second) = (f.add(0).await, f.add(0).await);
    let gone = WorkerId::random();
    f.store.claim_next(&gone, LONG, LONG).await.unwrap().unwrap();
    f.claim(LONG).await;
    assert_eq!(f.store.recover_worker(&gone).await.unwrap().queued, 1);
    assert_eq!(f.state(first.id).await, JobState::Queued);
    assert_eq!(f.state(second.id).await, JobState::Running);
}

async fn a_shutdown_does_not_count_as_an_attempt(f: Fixture) {
    let job = f.add(0).await;
    for _ in 0..5 {
        let lease = f.claim(LONG).await;
        f.store.release_job(&lease).await.unwrap();
    }
    let job = f.store.get_job(&f.tenant, job.id).await.unwrap();
    assert_eq!((job.state, job.attempt, job.crashes, job.lease_epoch), (JobState::Queued, 0, 0, 5));
}

async fn readers_of_a_trace_see_every_point_once(f: Fixture) {
    let job = f.add(0).await;
    let lease = f.claim(SHORT).await;
    f.store.append_trace(&lease, &chunk(1..=4)).await.unwrap();
    f.store.append_trace(&lease, &chunk(5..=5)).await.unwrap();
    // The chunk was written but the answer was lost, so the worker sends it again.
    f.store.append_trace(&lease, &chunk(5..=5)).await.unwrap();
    f.expire().await;
    let lease = f.claim(LONG).await;
    assert!(f.seqs(job.id, 0, 100).await.is_empty(), "what the lost worker traced is dropped");
    for seqs in [1..=2, 3..=7, 8..=8] {
        f.store.append_trace(&lease, &chunk(seqs)).await.unwrap();
    }
    assert_eq!(f.seqs(job.id, 0, 100).await, [1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(f.seqs(job.id, 4, 2).await, [5, 6]);
    assert!(f.seqs(job.id, 8, 100).await.is_empty());
    let page = f.store.get_trace(&f.tenant, job.id, 0, 100).await.unwrap();
    assert!(!page.complete);
    f.store.finish_job(&lease, &result('c'), None).await.unwrap();
    assert!(f.store.get_trace(&f.tenant, job.id, 0, 8).await.unwrap().complete);
    assert!(!f.store.get_trace(&f.tenant, job.id, 0, 7).await.unwrap().complete);
}

async fn progress_never_decreases_within_an_attempt(f: Fixture) {
    let job = f.add(0).await;
    let lease = f.claim(LONG).await;
    for end in [50, 20] {
        let fraction = TraceChunk { points: Vec::new(), ..chunk(1..=end) };
        f.store.append_trace(&lease, &fraction).await.unwrap();
        assert_eq!(f.store.get_job(&f.tenant, job.id).await.unwrap().progress.unwrap().fraction, 0.5);
    }
}

async fn a_changed_priority_changes_the_order_of_the_queue(f: Fixture) {
    let [first, second] = [f.add(0).await, f.add(0).await];
    let changed = f.store.set_priority(&f.tenant, second.id, 5).await.unwrap();
    assert_eq!((changed.id, changed.priority), (second.id, 5));
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.set_priority(&other, second.id, 9).await, Err(JobError::NotFound)));
    let lease = f.claim(LONG).await;
    assert_eq!(lease.job_id, second.id);
    let running = f.store.get_job(&f.tenant, second.id).await.unwrap();
    assert_eq!(running.worker.as_deref(), Some(f.worker.name()));
    f.store.finish_job(&lease, &result('c'), None).await.unwrap();
    assert!(matches!(f.store.set_priority(&f.tenant, second.id, 1).await, Err(JobError::AlreadyFinal { .. })));
    assert_eq!(f.store.get_job(&f.tenant, second.id).await.unwrap().worker, None);
    assert_eq!(f.claim(LONG).await.job_id, first.id);
}

async fn cancellation_leads_to_exactly_one_final_state_from_every_state(f: Fixture) {
    let queued = f.add(9).await;
    assert_eq!(f.store.cancel_job(&f.tenant, queued.id).await.unwrap().state, JobState::Cancelled);
    assert!(f.store.claim_next(&f.worker, LONG, LONG).await.unwrap().is_none());

    let running = f.add(0).await;
    let lease = f.claim(LONG).await;
    let requested = f.store.cancel_job(&f.tenant, running.id).await.unwrap();
    assert_eq!((requested.state, requested.cancel_requested), (JobState::Running, true));
    assert_eq!(f.store.lease_status(&lease).await.unwrap(), LeaseStatus::CancelRequested);
    f.store.finish_job(&lease, &Outcome::Cancelled, None).await.unwrap();
    assert!(is_lost(f.store.finish_job(&lease, &result('c'), None).await));
    assert_eq!(f.state(running.id).await, JobState::Cancelled);
    assert_eq!(f.store.cancel_job(&f.tenant, running.id).await.unwrap().state, JobState::Cancelled);

    // A result that was ready when cancellation was requested is accepted.
    let finishing = f.add(0).await;
    let lease = f.claim(LONG).await;
    f.store.cancel_job(&f.tenant, finishing.id).await.unwrap();
    f.store.finish_job(&lease, &result('c'), None).await.unwrap();
    assert_eq!(f.state(finishing.id).await, JobState::Succeeded);
    assert!(matches!(f.store.cancel_job(&f.tenant, finishing.id).await, Err(JobError::AlreadyFinal { .. })));

    // The worker is lost, or releases the job, after the request.
    for lost in [true, false] {
        let job = f.add(0).await;
        let lease = f.claim(SHORT).await;
        f.store.cancel_job(&f.tenant, job.id).await.unwrap();
        if lost {
            assert_eq!(f.expire().await.cancelled, 1)
        } else {
            f.store.release_job(&lease).await.unwrap()
        }
        assert_eq!(f.state(job.id).await, JobState::Cancelled);
    }

    let failed = f.add(0).await;
    let lease = f.claim(LONG).await;
    f.store.finish_job(&lease, &Outcome::Failed(Failure::new("match-failed", "x")), None).await.unwrap();
    assert!(matches!(f.store.cancel_job(&f.tenant, failed.id).await, Err(JobError::AlreadyFinal { .. })));
    assert_eq!(f.state(failed.id).await, JobState::Failed);
}

async fn the_queue_has_a_limit(f: Fixture) {
    f.add(0).await;
    let full = f.store.insert_job(&new_job(0), &room(1)).await;
    assert!(matches!(full, Err(JobError::QueueFull { limit: 1 })));
    f.claim(LONG).await;
    f.store.insert_job(&new_job(0), &room(1)).await.unwrap();
}

async fn other_tenants_see_nothing(f: Fixture) {
    let id = f.add(0).await.id;
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.get_job(&other, id).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.cancel_job(&other, id).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.delete_job(&other, id).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.get_trace(&other, id, 0, 1).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.get_artifact(&other, id, ArtifactKind::Source).await, Err(JobError::NotFound)));
    let page = PageRequest { size: 10, after: None, order: Order::NewestFirst };
    assert!(f.store.list_jobs(&other, &JobFilter::default(), &page).await.unwrap().jobs.is_empty());
}

async fn shared_blobs_are_kept_until_they_are_no_longer_needed(f: Fixture) {
    let bytes = |text: &'static str| bytes::Bytes::from_static(text.as_bytes());
    let [source, target] = ["one", "two"].map(|text| ArtifactKey::of(&f.tenant, text.as_bytes()));
    let mut jobs = Vec::new();
    for holder in ["x", "y"] {
        f.store.hold_blobs(holder, &[source.clone(), target.clone()], LONG, None).await.unwrap();
        f.artifacts.put(&source, bytes("one")).await.unwrap();
        f.artifacts.put(&target, bytes("two")).await.unwrap();
        let mut job = new_job(0);
        (job.source.hash, job.target.hash) = (source.hash().to_owned(), target.hash().to_owned());
        let admission = Admission { holder: holder.to_owned(), ..room(10) };
        jobs.push(f.store.insert_job(&job, &admission).await.unwrap());
        f.store.cancel_job(&f.tenant, job.id).await.unwrap();
    }
    f.store.delete_job(&f.tenant, jobs[0].id).await.unwrap();
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 0);
    f.store.hold_blobs("z", std::slice::from_ref(&source), LONG, None).await.unwrap();
    f.store.delete_job(&f.tenant, jobs[1].id).await.unwrap();
    assert_eq!(
        f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(),
        1,
        "one is held by a submission"
    );
    assert_eq!(f.artifacts.get(&source).await.unwrap(), bytes("one"));
    assert!(f.artifacts.get(&target).await.is_err());
    f.store.drop_hold("z").await.unwrap();
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 1);
    // A hold expires if its holder has died.
    f.store.hold_blobs("dead", std::slice::from_ref(&source), Duration::ZERO, None).await.unwrap();
    f.artifacts.put(&source, bytes("one")).await.unwrap();
    tokio::time::sleep(SHORT).await;
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 1);
}

async fn a_blob_whose_content_differs_from_its_hash_is_refused(f: Fixture) {
    let key = ArtifactKey::of(&f.tenant, b"one");
    f.artifacts.put(&key, bytes::Bytes::from_static(b"one")).await.unwrap();
    let root = f.site.s3.as_ref().map_or_else(|| f.site.data_dir(), |s3| s3.bucket().join("blobs"));
    std::fs::write(root.join("blobs/default").join(key.path()), b"two").unwrap();
    assert!(matches!(f.artifacts.get(&key).await, Err(JobError::Corrupt { .. })));
    for escape in ["../../../../etc/passwd", "a/../b", "/etc/passwd", "A/b"] {
        assert!(ArtifactKey::from_path(&f.tenant, escape).is_none(), "{escape}");
        assert!(ArtifactKey::from_path(&f.tenant, &format!("{escape}/{}", key.hash())).is_none(), "{escape}");
    }
}

async fn a_blob_written_in_parts_is_named_when_complete(f: Fixture) {
    // Larger than a part of a multipart upload, and not a multiple of it.
    let whole: Vec<u8> = (0..20_000_003u32).map(|i| (i % 251) as u8).collect();
    let key = ArtifactKey::of(&f.tenant, &whole);
    let mut writer = f.artifacts.begin(&f.tenant).await.unwrap();
    for part in whole.chunks(1 << 20) {
        writer.write(bytes::Bytes::copy_from_slice(part)).await.unwrap();
    }
    assert!(f.artifacts.get(&key).await.is_err());
    writer.commit(&key).await.unwrap();
    assert_eq!(f.artifacts.get(&key).await.unwrap(), whole);
    let mut dropped = f.artifacts.begin(&f.tenant).await.unwrap();
    dropped.write(bytes::Bytes::from_static(b"half")).await.unwrap();
    drop(dropped);
    assert_eq!(f.site.blobs().len(), 1);
}

async fn the_store_has_durable_settings(f: Fixture) {
    let expected = match f.site.cluster {
        None => ("2", "wal"), // FULL
        Some(_) => ("on", "on"),
    };
    let (first, second) = f.store.durability().await.unwrap();
    assert_eq!((first.as_str(), second.as_str()), expected);
}

async fn stored_data_survive_the_end_of_all_connections(f: Fixture) {
    let id = f.add(0).await.id;
    f.store.close().await;
    assert_eq!(f.another().await.get_job(&f.tenant, id).await.unwrap().id, id);
}

/// Defines a test of each function on SQLite with a folder and on PostgreSQL with an S3 server.
macro_rules! on_every_store {
    ($($name:ident,)+) => {
        mod sqlite {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 4)]
            async fn $name() {
                super::$name(crate::store::Fixture::open(crate::faults::site::Backend::Sqlite).await).await;
            })+
        }
        mod postgres {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 4)]
            #[ignore = "needs PostgreSQL"]
            async fn $name() {
                super::$name(crate::store::Fixture::open(crate::faults::site::Backend::Postgres).await).await;
            })+
        }
    };
}
pub(crate) use on_every_store;

on_every_store! {
    jobs_are_claimed_by_priority_then_age,
    the_front_of_the_queue_is_in_the_order_of_claims,
    claimers_that_see_the_same_queue_get_different_jobs,
    no_job_is_claimed_twice,
    a_stale_worker_changes_nothing,
    a_heartbeat_renews_the_lease,
    a_job_that_keeps_crashing_becomes_dead_and_others_run,
    a_job_whose_workers_crash_waits_longer_each_time,
    jobs_of_a_lost_process_are_requeued_at_once_and_others_keep_theirs,
    a_shutdown_does_not_count_as_an_attempt,
    readers_of_a_trace_see_every_point_once,
    progress_never_decreases_within_an_attempt,
    a_changed_priority_changes_the_order_of_the_queue,
    cancellation_leads_to_exactly_one_final_state_from_every_state,
    the_queue_has_a_limit,
    other_tenants_see_nothing,
    shared_blobs_are_kept_until_they_are_no_longer_needed,
    a_blob_whose_content_differs_from_its_hash_is_refused,
    a_blob_written_in_parts_is_named_when_complete,
    the_store_has_durable_settings,
    stored_data_survive_the_end_of_all_connections,
}
