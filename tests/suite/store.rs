//! One suite for every job store and every blob store: SQLite with a folder, PostgreSQL with an S3 server.

use super::faults::site::{Backend, Site};
use homolog::jobs::job::Order;
use homolog::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, ArtifactStore, Attempted, BatchId, DeliveryState, Failure, Job,
    JobError, JobFilter, JobId, JobInput, JobState, JobStore, KeyStore, Lease, LeaseStatus, Made, MeshStore, NewBatch,
    NewJob, NumberedPoint, Once, OnceStatus, Outcome, Overdue, PageRequest, Progress, Purged, Recovered, Retention,
    Scope, SecretKey, Tenant, TraceChunk, Webhook, WebhookStore, WorkerId,
};
use homolog::observe::{Phase, TracePoint};
use homolog::store::sql::SqlStore;
use serde_json::json;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

const LONG: Duration = Duration::from_secs(60);
const SHORT: Duration = Duration::from_millis(30);

struct Fixture {
    store: Arc<SqlStore>,
    artifacts: Arc<dyn ArtifactStore>,
    worker: WorkerId,
    tenant: Tenant,
    site: Site,
}

impl Fixture {
    /// `None` if this machine cannot have the backend, which is said.
    async fn open(backend: Backend) -> Option<Self> {
        let site = Site::open(backend)?;
        std::fs::create_dir_all(site.data_dir()).unwrap();
        let store = Arc::new(SqlStore::open(&site.location()).await.unwrap());
        let artifacts = site.artifacts();
        Some(Fixture { store, artifacts, worker: WorkerId::random(), tenant: Tenant::default(), site })
    }

    /// Connections of another process.
    async fn another(&self) -> SqlStore {
        SqlStore::open(&self.site.location()).await.unwrap()
    }

    async fn add(&self, priority: i32) -> Job {
        self.store.insert(&new_job(priority), &room(1000)).await.unwrap()
    }

    async fn claim(&self, duration: Duration) -> Lease {
        self.store.claim(&self.worker, duration, LONG).await.unwrap().unwrap().lease
    }

    async fn state(&self, id: JobId) -> JobState {
        self.store.get(&self.tenant, id).await.unwrap().state
    }

    async fn expire(&self) -> Recovered {
        tokio::time::sleep(SHORT * 2).await;
        self.store.recover_expired().await.unwrap()
    }

    async fn seqs(&self, id: JobId, after: u64, limit: u32) -> Vec<u64> {
        let page = self.store.trace(&self.tenant, id, after, limit).await.unwrap();
        page.points.iter().map(|p| p.seq).collect()
    }
}

/// A queue for so many.
fn room(max_queued: u32) -> Admission {
    Admission { max_queued, holder: String::new(), keep_result: None, once: None }
}

fn new_job(priority: i32) -> NewJob {
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
        labels: BTreeMap::new(),
        external_ref: None,
        max_attempts: 3,
        deadline_at: None,
        max_run_ms: None,
        retry_of: None,
        batch_id: None,
        cache_key: None,
        use_cache: true,
        traceparent: None,
    }
}

fn chunk(seqs: std::ops::RangeInclusive<u64>) -> TraceChunk {
    let last = *seqs.end();
    let points =
        seqs.map(|seq| NumberedPoint { seq, point: TracePoint::new(0, Phase::Inference, seq as u32), elapsed_ms: seq });
    let progress =
        Progress { fraction: last as f64 / 100.0, phase: None, iteration: None, message: None, energy_latest: None };
    TraceChunk { points: points.collect(), progress }
}

fn result(hash: char) -> Outcome {
    let key = ArtifactKey::of_hash(&Tenant::default(), &hash.to_string().repeat(64)).unwrap();
    Outcome::Succeeded(vec![ArtifactRef { kind: ArtifactKind::Result, key, n_bytes: 1 }])
}

fn is_lost<T: std::fmt::Debug>(answer: Result<T, JobError>) -> bool {
    matches!(answer, Err(JobError::LeaseLost))
}

async fn claims_go_by_priority_then_age(f: Fixture) {
    let jobs = [f.add(0).await, f.add(5).await, f.add(0).await, f.add(-1).await, f.add(5).await];
    let mut order = Vec::new();
    while let Some(leased) = f.store.claim(&f.worker, LONG, LONG).await.unwrap() {
        order.push(leased.lease.job_id);
    }
    assert_eq!(order, [1, 4, 0, 2, 3].map(|i: usize| jobs[i].id));
}

async fn no_job_is_claimed_twice(f: Fixture) {
    for _ in 0..40 {
        f.add(0).await;
    }
    let mut claimers = tokio::task::JoinSet::new();
    for _ in 0..8 {
        // Each with connections of its own, as if in another process.
        let store = f.another().await;
        claimers.spawn(async move {
            let worker = WorkerId::random();
            let mut claimed = Vec::new();
            while let Some(leased) = store.claim(&worker, LONG, LONG).await.unwrap() {
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
    assert!(is_lost(f.store.finish(&stale, &result('c'), None).await), "queued again");
    let fresh = f.claim(LONG).await;
    assert_eq!(fresh.epoch, stale.epoch + 1);

    assert!(is_lost(f.store.append_trace(&stale, &chunk(4..=5)).await));
    assert!(is_lost(f.store.finish(&stale, &result('c'), None).await));
    assert!(is_lost(f.store.release(&stale).await));
    assert_eq!(f.store.heartbeat(&stale, LONG).await.unwrap(), LeaseStatus::Lost);
    assert_eq!(f.store.lease_status(&stale).await.unwrap(), LeaseStatus::Lost);
    assert_eq!(f.store.heartbeat(&fresh, LONG).await.unwrap(), LeaseStatus::Held);

    f.store.finish(&fresh, &result('d'), None).await.unwrap();
    assert!(is_lost(f.store.finish(&fresh, &result('e'), None).await), "a result is accepted once");
    assert!(is_lost(f.store.finish(&fresh, &Outcome::Cancelled, None).await));
    let (state, artifact) = f.store.artifact(&f.tenant, job.id, ArtifactKind::Result).await.unwrap();
    assert_eq!(state, JobState::Succeeded);
    assert_eq!(artifact.unwrap().key.hash(), "d".repeat(64));
}

async fn a_heartbeat_keeps_a_lease(f: Fixture) {
    f.add(0).await;
    let lease = f.claim(SHORT).await;
    f.store.heartbeat(&lease, LONG).await.unwrap();
    assert_eq!(f.expire().await, Recovered::default());
}

async fn crashes_end_in_dead_and_others_go_on(f: Fixture) {
    let poison = f.add(9).await;
    let other = f.add(0).await;
    for _ in 0..2 {
        assert_eq!(f.claim(SHORT).await.job_id, poison.id);
        assert_eq!(f.expire().await.queued, 1);
    }
    let last = f.claim(SHORT).await;
    assert_eq!(f.expire().await.dead, 1);
    let dead = f.store.get(&f.tenant, poison.id).await.unwrap();
    assert_eq!((dead.state, dead.crashes, dead.attempt), (JobState::Dead, 3, 3));
    assert_eq!(dead.error.unwrap().code, "crash-limit-reached");
    assert!(is_lost(f.store.finish(&last, &result('c'), None).await));
    assert_eq!(f.claim(LONG).await.job_id, other.id);
}

async fn a_lost_process_gives_up_its_jobs_at_once_and_others_keep_theirs(f: Fixture) {
    let (first, second) = (f.add(0).await, f.add(0).await);
    let gone = WorkerId::random();
    f.store.claim(&gone, LONG, LONG).await.unwrap().unwrap();
    f.claim(LONG).await;
    assert_eq!(f.store.recover_worker(&gone).await.unwrap().queued, 1);
    assert_eq!(f.state(first.id).await, JobState::Queued);
    assert_eq!(f.state(second.id).await, JobState::Running);
}

async fn a_shutdown_is_no_attempt(f: Fixture) {
    let job = f.add(0).await;
    for _ in 0..5 {
        let lease = f.claim(LONG).await;
        f.store.release(&lease).await.unwrap();
    }
    let job = f.store.get(&f.tenant, job.id).await.unwrap();
    assert_eq!((job.state, job.attempt, job.crashes, job.lease_epoch), (JobState::Queued, 0, 0, 5));
}

async fn readers_of_a_trace_see_every_point_once(f: Fixture) {
    let job = f.add(0).await;
    let lease = f.claim(SHORT).await;
    f.store.append_trace(&lease, &chunk(1..=4)).await.unwrap();
    f.store.append_trace(&lease, &chunk(5..=5)).await.unwrap();
    // Written, but the answer was lost: the worker sends it again.
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
    let page = f.store.trace(&f.tenant, job.id, 0, 100).await.unwrap();
    assert!(!page.complete);
    f.store.finish(&lease, &result('c'), None).await.unwrap();
    assert!(f.store.trace(&f.tenant, job.id, 0, 8).await.unwrap().complete);
    assert!(!f.store.trace(&f.tenant, job.id, 0, 7).await.unwrap().complete);
}

async fn progress_never_goes_back_within_an_attempt(f: Fixture) {
    let job = f.add(0).await;
    let lease = f.claim(LONG).await;
    for end in [50, 20] {
        let fraction = TraceChunk { points: Vec::new(), ..chunk(1..=end) };
        f.store.append_trace(&lease, &fraction).await.unwrap();
        assert_eq!(f.store.get(&f.tenant, job.id).await.unwrap().progress.unwrap().fraction, 0.5);
    }
}

async fn cancel_leads_to_exactly_one_end_from_every_state(f: Fixture) {
    let queued = f.add(9).await;
    assert_eq!(f.store.cancel(&f.tenant, queued.id).await.unwrap().state, JobState::Cancelled);
    assert!(f.store.claim(&f.worker, LONG, LONG).await.unwrap().is_none());

    let running = f.add(0).await;
    let lease = f.claim(LONG).await;
    let told = f.store.cancel(&f.tenant, running.id).await.unwrap();
    assert_eq!((told.state, told.cancel_requested), (JobState::Running, true));
    assert_eq!(f.store.lease_status(&lease).await.unwrap(), LeaseStatus::CancelRequested);
    f.store.finish(&lease, &Outcome::Cancelled, None).await.unwrap();
    assert!(is_lost(f.store.finish(&lease, &result('c'), None).await));
    assert_eq!(f.state(running.id).await, JobState::Cancelled);
    assert_eq!(f.store.cancel(&f.tenant, running.id).await.unwrap().state, JobState::Cancelled);

    // A result that was ready when the request came counts.
    let finishing = f.add(0).await;
    let lease = f.claim(LONG).await;
    f.store.cancel(&f.tenant, finishing.id).await.unwrap();
    f.store.finish(&lease, &result('c'), None).await.unwrap();
    assert_eq!(f.state(finishing.id).await, JobState::Succeeded);
    assert!(matches!(f.store.cancel(&f.tenant, finishing.id).await, Err(JobError::AlreadyFinal { .. })));

    // The worker is lost, or gives back, after the request.
    for lost in [true, false] {
        let job = f.add(0).await;
        let lease = f.claim(SHORT).await;
        f.store.cancel(&f.tenant, job.id).await.unwrap();
        if lost {
            assert_eq!(f.expire().await.cancelled, 1)
        } else {
            f.store.release(&lease).await.unwrap()
        }
        assert_eq!(f.state(job.id).await, JobState::Cancelled);
    }

    let failed = f.add(0).await;
    let lease = f.claim(LONG).await;
    f.store.finish(&lease, &Outcome::Failed(Failure::new("match-failed", "x")), None).await.unwrap();
    assert!(matches!(f.store.cancel(&f.tenant, failed.id).await, Err(JobError::AlreadyFinal { .. })));
    assert_eq!(f.state(failed.id).await, JobState::Failed);
}

async fn the_queue_has_a_limit(f: Fixture) {
    f.add(0).await;
    let full = f.store.insert(&new_job(0), &room(1)).await;
    assert!(matches!(full, Err(JobError::QueueFull { limit: 1 })));
    f.claim(LONG).await;
    f.store.insert(&new_job(0), &room(1)).await.unwrap();
}

async fn other_tenants_see_nothing(f: Fixture) {
    let id = f.add(0).await.id;
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.get(&other, id).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.cancel(&other, id).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.delete(&other, id).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.trace(&other, id, 0, 1).await, Err(JobError::NotFound)));
    assert!(matches!(f.store.artifact(&other, id, ArtifactKind::Source).await, Err(JobError::NotFound)));
    let page = PageRequest { size: 10, after: None, order: Order::NewestFirst };
    assert!(f.store.list(&other, &JobFilter::default(), &page).await.unwrap().jobs.is_empty());
}

async fn shared_blobs_stay_until_nobody_needs_them(f: Fixture) {
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
        jobs.push(f.store.insert(&job, &admission).await.unwrap());
        f.store.cancel(&f.tenant, job.id).await.unwrap();
    }
    f.store.delete(&f.tenant, jobs[0].id).await.unwrap();
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 0);
    f.store.hold_blobs("z", std::slice::from_ref(&source), LONG, None).await.unwrap();
    f.store.delete(&f.tenant, jobs[1].id).await.unwrap();
    assert_eq!(
        f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(),
        1,
        "one is held by a submission"
    );
    assert_eq!(f.artifacts.get(&source).await.unwrap(), bytes("one"));
    assert!(f.artifacts.get(&target).await.is_err());
    f.store.drop_hold("z").await.unwrap();
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 1);
    // A hold whose holder died lapses.
    f.store.hold_blobs("dead", std::slice::from_ref(&source), Duration::ZERO, None).await.unwrap();
    f.artifacts.put(&source, bytes("one")).await.unwrap();
    tokio::time::sleep(SHORT).await;
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 1);
}

async fn a_blob_that_is_not_what_its_name_says_is_refused(f: Fixture) {
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

async fn a_blob_in_parts_gets_its_name_at_the_end(f: Fixture) {
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

async fn the_store_is_set_to_be_durable(f: Fixture) {
    let expected = match f.site.cluster {
        None => ("2", "wal"), // FULL
        Some(_) => ("on", "on"),
    };
    let (first, second) = f.store.durability().await.unwrap();
    assert_eq!((first.as_str(), second.as_str()), expected);
}

async fn what_is_stored_stays_after_all_connections_ended(f: Fixture) {
    let id = f.add(0).await.id;
    f.store.close().await;
    assert_eq!(f.another().await.get(&f.tenant, id).await.unwrap().id, id);
}

async fn an_equal_job_is_answered_from_the_first_result(f: Fixture) {
    let with_key = || NewJob { cache_key: Some("k".to_owned()), ..new_job(0) };
    let first = f.store.insert(&with_key(), &room(10)).await.unwrap();
    assert!(!f.store.insert(&with_key(), &room(10)).await.unwrap().cached, "there is no result yet");
    let lease = f.claim(LONG).await;
    assert_eq!(lease.job_id, first.id);
    f.store.append_trace(&lease, &chunk(1..=3)).await.unwrap();
    f.store.finish(&lease, &result('c'), None).await.unwrap();

    let second = f.store.insert(&with_key(), &room(10)).await.unwrap();
    assert_eq!((second.state, second.cached, second.attempt), (JobState::Succeeded, true, 0));
    assert!(second.finished_at.is_some());
    assert_eq!(f.seqs(second.id, 0, 10).await, [1, 2, 3]);
    f.store.delete(&f.tenant, first.id).await.unwrap();
    let (_, artifact) = f.store.artifact(&f.tenant, second.id, ArtifactKind::Result).await.unwrap();
    assert_eq!(artifact.unwrap().key.hash(), "c".repeat(64), "it does not need the first any more");

    for other in [
        NewJob { use_cache: false, ..with_key() },
        NewJob { cache_key: Some("other".to_owned()), ..new_job(0) },
        NewJob { cache_key: None, ..new_job(0) },
        NewJob { tenant: Tenant::new("other").unwrap(), ..with_key() },
    ] {
        assert_eq!(f.store.insert(&other, &room(10)).await.unwrap().state, JobState::Queued);
    }
}

async fn a_deadline_and_a_run_time_are_kept(f: Fixture) {
    let now = jiff::Timestamp::now();
    let late = NewJob { deadline_at: Some(now), ..new_job(9) };
    let late = f.store.insert(&late, &room(10)).await.unwrap().id;
    let in_time = NewJob { deadline_at: Some(now + LONG), max_run_ms: Some(1), ..new_job(0) };
    let in_time = f.store.insert(&in_time, &room(10)).await.unwrap().id;
    tokio::time::sleep(SHORT).await;
    let lease = f.claim(LONG).await;
    assert_eq!(lease.job_id, in_time, "what is too late is not begun");
    tokio::time::sleep(SHORT).await;
    assert_eq!(f.store.end_overdue(LONG).await.unwrap(), Overdue { expired: 1, stuck: 0 });
    let job = f.store.get(&f.tenant, late).await.unwrap();
    assert_eq!((job.state, job.error.unwrap().code.as_str()), (JobState::Expired, "deadline-passed"));
    assert_eq!(f.store.end_overdue(Duration::ZERO).await.unwrap(), Overdue { expired: 0, stuck: 1 });
    let job = f.store.get(&f.tenant, in_time).await.unwrap();
    assert_eq!((job.state, job.error.unwrap().code.as_str()), (JobState::Failed, "run-time-exceeded"));
    assert!(is_lost(f.store.finish(&lease, &result('c'), None).await));
}

async fn changes_come_in_order_and_none_is_missed(f: Fixture) {
    let mut writers = tokio::task::JoinSet::new();
    for _ in 0..4 {
        let store = f.another().await;
        writers.spawn(async move {
            let worker = WorkerId::random();
            for _ in 0..15 {
                store.insert(&new_job(0), &room(1000)).await.unwrap();
                let leased = store.claim(&worker, LONG, LONG).await.unwrap();
                if let Some(leased) = leased {
                    store.finish(&leased.lease, &Outcome::Cancelled, None).await.unwrap();
                }
            }
        });
    }
    // Read while they write.
    let (mut seen, mut since) = (Vec::new(), 0);
    loop {
        let done = writers.is_empty();
        let page = f.store.changes(&f.tenant, since, 7).await.unwrap();
        since = page.next_since;
        seen.extend(page.changes);
        while writers.try_join_next().is_some() {}
        if done && !page.more {
            break;
        }
    }
    assert!(seen.windows(2).all(|w| w[0].seq < w[1].seq));
    let of = |state| seen.iter().filter(|c| c.state == state).count();
    assert_eq!(of(JobState::Queued), 60, "each job once");
    assert_eq!(of(JobState::Running), of(JobState::Cancelled));
    for change in &seen {
        let states: Vec<_> = seen.iter().filter(|c| c.job_id == change.job_id).map(|c| c.state).collect();
        assert!([JobState::Queued, JobState::Running, JobState::Cancelled].starts_with(&states), "{states:?}");
    }
    let other = Tenant::new("other").unwrap();
    assert!(f.store.changes(&other, 0, 10).await.unwrap().changes.is_empty());
}

async fn an_idempotency_key_makes_one_thing(f: Fixture) {
    let once = |fingerprint: &str| Once {
        tenant: Tenant::default(),
        name: "key".to_owned(),
        fingerprint: fingerprint.to_owned(),
        token: uuid::Uuid::new_v4().to_string(),
        keep_for: LONG,
    };
    let first = once("a");
    assert_eq!(f.store.begin_once(&first, LONG).await.unwrap(), OnceStatus::Begun);
    assert_eq!(f.store.begin_once(&once("a"), LONG).await.unwrap(), OnceStatus::InProgress);
    assert_eq!(f.store.begin_once(&once("b"), LONG).await.unwrap(), OnceStatus::OtherRequest);
    f.store.give_up_once(&once("a")).await.unwrap(); // another's token: nothing happens
    assert_eq!(f.store.begin_once(&once("a"), LONG).await.unwrap(), OnceStatus::InProgress);
    let admission = |once: &Once| Admission { once: Some(once.clone()), ..room(10) };
    let made = f.store.insert(&new_job(0), &admission(&first)).await.unwrap();
    let again = f.store.begin_once(&once("a"), LONG).await.unwrap();
    assert_eq!(again, OnceStatus::Made(Made::Job(made.id)));
    f.store.give_up_once(&first).await.unwrap(); // too late
    assert_eq!(f.store.begin_once(&once("a"), LONG).await.unwrap(), again);

    // Whoever lost the key makes nothing.
    let slow = Once { name: "slow".to_owned(), ..once("a") };
    assert_eq!(f.store.begin_once(&slow, Duration::ZERO).await.unwrap(), OnceStatus::Begun);
    tokio::time::sleep(SHORT).await;
    let quick = Once { name: "slow".to_owned(), ..once("a") };
    assert_eq!(f.store.begin_once(&quick, LONG).await.unwrap(), OnceStatus::Begun);
    assert!(f.store.insert(&new_job(0), &admission(&slow)).await.is_err());
    f.store.insert(&new_job(0), &admission(&quick)).await.unwrap();
    let page = PageRequest { size: 10, after: None, order: Order::NewestFirst };
    assert_eq!(f.store.list(&f.tenant, &JobFilter::default(), &page).await.unwrap().jobs.len(), 2);
}

async fn lists_are_filtered_in_every_way(f: Fixture) {
    let mut ids = Vec::new();
    for i in 0..6u32 {
        let labels = [("study", format!("s{}", i % 2)), ("site", "zurich".to_owned())];
        let job = NewJob {
            labels: labels.into_iter().map(|(k, v)| (k.to_owned(), v)).collect(),
            external_ref: (i < 3).then(|| "ref".to_owned()),
            method: format!("m{}", i % 3),
            ..new_job(0)
        };
        ids.push(f.store.insert(&job, &room(10)).await.unwrap().id);
    }
    f.store.cancel(&f.tenant, ids[4]).await.unwrap();
    let find = async |filter: JobFilter| {
        let page = PageRequest { size: 10, after: None, order: Order::OldestFirst };
        let found = f.store.list(&f.tenant, &filter, &page).await.unwrap().jobs;
        found.iter().map(|job| ids.iter().position(|id| *id == job.id).unwrap()).collect::<Vec<_>>()
    };
    let labels = |pairs: &[(&str, &str)]| pairs.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
    let all = JobFilter::default();
    assert_eq!(find(all.clone()).await, [0, 1, 2, 3, 4, 5]);
    assert_eq!(find(JobFilter { labels: labels(&[("study", "s0")]), ..all.clone() }).await, [0, 2, 4]);
    let both = labels(&[("study", "s0"), ("site", "zurich")]);
    let states = vec![JobState::Queued, JobState::Running];
    assert_eq!(find(JobFilter { labels: both, states, ..all.clone() }).await, [0, 2]);
    assert!(find(JobFilter { labels: labels(&[("study", "zurich")]), ..all.clone() }).await.is_empty());
    assert_eq!(find(JobFilter { external_ref: Some("ref".to_owned()), ..all.clone() }).await, [0, 1, 2]);
    assert_eq!(find(JobFilter { method: Some("m1".to_owned()), ..all.clone() }).await, [1, 4]);
    let states = vec![JobState::Cancelled, JobState::Queued];
    assert_eq!(find(JobFilter { states, ..all.clone() }).await, [0, 1, 2, 3, 4, 5]);
    let later = jiff::Timestamp::now() + LONG;
    assert!(find(JobFilter { created_from: Some(later), ..all.clone() }).await.is_empty());
    assert_eq!(find(JobFilter { created_before: Some(later), ..all }).await.len(), 6);
}

async fn a_batch_is_made_whole_or_not_at_all(f: Fixture) {
    let id = BatchId::random();
    let batch = NewBatch { id, tenant: f.tenant.clone(), labels: BTreeMap::new(), external_ref: None };
    let jobs: Vec<_> = (0..3).map(|_| NewJob { batch_id: Some(id), ..new_job(0) }).collect();
    assert!(matches!(f.store.insert_batch(&batch, &jobs, &room(2)).await, Err(JobError::QueueFull { .. })));
    let mut wrong = jobs.clone();
    wrong[2].id = wrong[0].id;
    assert!(f.store.insert_batch(&batch, &wrong, &room(10)).await.is_err());
    assert!(matches!(f.store.get_batch(&f.tenant, id).await, Err(JobError::BatchNotFound)));
    assert_eq!(f.store.queue_length(None).await.unwrap(), 0);

    let made = f.store.insert_batch(&batch, &jobs, &room(10)).await.unwrap();
    assert_eq!(made.counts, BTreeMap::from([(JobState::Queued, 3)]));
    let lease = f.claim(LONG).await;
    f.store.finish(&lease, &result('c'), None).await.unwrap();
    f.claim(LONG).await;
    let counts = [(JobState::Queued, 1), (JobState::Running, 1), (JobState::Succeeded, 1)];
    assert_eq!(f.store.get_batch(&f.tenant, id).await.unwrap().counts, BTreeMap::from(counts));
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.get_batch(&other, id).await, Err(JobError::BatchNotFound)));
    let listed = f.store.list_batches(&f.tenant, 10, None).await.unwrap();
    assert_eq!((listed.batches.len(), listed.next), (1, None));
}

async fn retention_removes_results_then_records(f: Fixture) {
    let bytes = bytes::Bytes::from_static(b"result");
    let job = f.add(0).await;
    let lease = f.claim(LONG).await;
    let key = ArtifactKey::of_result(&lease, &bytes);
    f.store.hold_blobs(&lease.holder(), std::slice::from_ref(&key), LONG, Some(&lease)).await.unwrap();
    f.artifacts.put(&key, bytes).await.unwrap();
    f.store.append_trace(&lease, &chunk(1..=3)).await.unwrap();
    let artifact = ArtifactRef { kind: ArtifactKind::Result, key: key.clone(), n_bytes: 6 };
    f.store.finish(&lease, &Outcome::Succeeded(vec![artifact]), Some(SHORT)).await.unwrap();
    let young = f.add(0).await;
    tokio::time::sleep(SHORT * 2).await;

    let keep = Retention { results: Some(SHORT), jobs: Some(LONG) };
    let expected = Purged { results: 1, ..Purged::default() };
    assert_eq!(f.store.purge(&keep, 10, true).await.unwrap(), expected, "a dry run counts");
    assert_eq!(f.store.purge(&keep, 10, true).await.unwrap(), expected, "and removes nothing");
    assert_eq!(f.store.purge(&keep, 10, false).await.unwrap(), expected);
    f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap();
    assert!(f.artifacts.get(&key).await.is_err());
    assert!(f.seqs(job.id, 0, 10).await.is_empty());
    assert!(matches!(f.store.artifact(&f.tenant, job.id, ArtifactKind::Result).await, Err(JobError::Gone)));
    assert_eq!(f.state(job.id).await, JobState::Succeeded, "the record stays");

    let forget = Retention { results: Some(SHORT), jobs: Some(SHORT) };
    let purged = f.store.purge(&forget, 10, false).await.unwrap();
    assert_eq!((purged.results, purged.jobs), (0, 1));
    assert!(matches!(f.store.get(&f.tenant, job.id).await, Err(JobError::NotFound)));
    assert_eq!(f.state(young.id).await, JobState::Queued, "what is not finished stays");
}

async fn meshes_are_kept_while_jobs_refer_to_them(f: Fixture) {
    let key = ArtifactKey::of(&f.tenant, b"mesh");
    f.store.hold_blobs("up", std::slice::from_ref(&key), LONG, None).await.unwrap();
    f.artifacts.put(&key, bytes::Bytes::from_static(b"mesh")).await.unwrap();
    assert!(f.store.insert_mesh(&key, 4, Some(".ply"), "up").await.unwrap());
    assert!(!f.store.insert_mesh(&key, 4, None, "").await.unwrap(), "held already");
    assert_eq!(f.store.get_mesh(&f.tenant, key.hash()).await.unwrap().name_hint.as_deref(), Some(".ply"));
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.get_mesh(&other, key.hash()).await, Err(JobError::MeshNotFound)));
    assert!(matches!(f.store.delete_mesh(&other, key.hash()).await, Err(JobError::MeshNotFound)));

    let mut job = new_job(0);
    job.source.hash = key.hash().to_owned();
    let job = f.store.insert(&job, &room(10)).await.unwrap();
    assert!(matches!(f.store.delete_mesh(&f.tenant, key.hash()).await, Err(JobError::MeshInUse)));
    f.store.cancel(&f.tenant, job.id).await.unwrap();
    f.store.delete(&f.tenant, job.id).await.unwrap();
    f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap();
    assert!(f.artifacts.get(&key).await.is_ok(), "the upload itself refers to it");
    f.store.delete_mesh(&f.tenant, key.hash()).await.unwrap();
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 1);
}

async fn keys_end_when_revoked_or_expired(f: Fixture) {
    let (lasting, brief) = (SecretKey::random(), SecretKey::random());
    f.store.insert_key(&lasting, &f.tenant, "one", &[Scope::Read], None).await.unwrap();
    f.store.insert_key(&brief, &f.tenant, "two", &[Scope::Submit], Some(SHORT)).await.unwrap();
    let is_valid = async |key: &SecretKey| f.store.get_key(key.id()).await.unwrap().unwrap().is_valid;
    assert!(is_valid(&lasting).await && is_valid(&brief).await);
    tokio::time::sleep(SHORT * 2).await;
    assert!(!is_valid(&brief).await);
    assert!(f.store.revoke_key(lasting.id()).await.unwrap());
    assert!(!f.store.revoke_key(lasting.id()).await.unwrap());
    assert!(!is_valid(&lasting).await);
    assert_eq!(f.store.list_keys().await.unwrap().len(), 2);
    assert!(f.store.get_key("none").await.unwrap().is_none());
}

async fn webhooks_are_told_once_of_each_change(f: Fixture) {
    let hook = |states: Vec<JobState>| Webhook {
        id: uuid::Uuid::now_v7().to_string(),
        tenant: Tenant::default(),
        url: "https://example.org/".to_owned(),
        states,
        secret: "whsec_AAAA".to_owned(),
        is_enabled: true,
        disabled_because: None,
        created_at: jiff::Timestamp::now(),
    };
    f.add(0).await;
    f.store.tell_changes().await.unwrap();
    let all = f.store.insert_webhook(&hook(Vec::new()), 2).await.unwrap().unwrap();
    let ends = f.store.insert_webhook(&hook(vec![JobState::Cancelled]), 2).await.unwrap().unwrap();
    assert!(f.store.insert_webhook(&hook(Vec::new()), 2).await.unwrap().is_none(), "at most two");
    let job = f.add(0).await;
    f.store.cancel(&f.tenant, job.id).await.unwrap();
    // Two processes at the same time.
    let other = f.another().await;
    let (a, b) = tokio::join!(f.store.tell_changes(), other.tell_changes());
    assert_eq!(a.unwrap() + b.unwrap(), 3, "queued and cancelled to one, cancelled to the other");
    let log = f.store.list_deliveries(&f.tenant, &all.id, 10, None).await.unwrap().deliveries;
    assert_eq!(log.iter().map(|d| d.event.as_str()).collect::<Vec<_>>(), ["job.cancelled", "job.queued"]);

    let mut taken = Vec::new();
    while let Some(due) = f.store.take_delivery(LONG).await.unwrap() {
        taken.push(due);
    }
    assert_eq!(taken.len(), 3, "each once while somebody is busy with it");
    let again = taken.iter().find(|d| d.webhook_id == ends.id).unwrap();
    assert!(again.payload.contains(&job.id.to_string()));
    let retry = Attempted::Retry { after: Duration::ZERO, status: Some(500), error: "HTTP 500".to_owned() };
    f.store.end_attempt(&again.id, &retry).await.unwrap();
    tokio::time::sleep(SHORT).await;
    assert_eq!(f.store.take_delivery(LONG).await.unwrap().unwrap().attempt, 2);
    f.store.end_attempt(&again.id, &Attempted::Delivered { status: 204 }).await.unwrap();
    let log = f.store.list_deliveries(&f.tenant, &ends.id, 10, None).await.unwrap().deliveries;
    assert_eq!((log[0].state, log[0].attempts, log[0].status), (DeliveryState::Delivered, 2, Some(204)));
    f.store.disable_webhook(&ends.id, "it answered 410").await.unwrap();
    assert!(!f.store.get_webhook(&f.tenant, &ends.id).await.unwrap().is_enabled);
    f.store.delete_webhook(&f.tenant, &ends.id).await.unwrap();
    assert!(matches!(f.store.get_webhook(&f.tenant, &ends.id).await, Err(JobError::WebhookNotFound)));
}

/// Makes a test of each on SQLite with a folder and on PostgreSQL with an S3 server.
macro_rules! on_every_store {
    ($($name:ident,)+) => {
        mod sqlite {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 4)]
            async fn $name() {
                let Some(fixture) = super::Fixture::open(super::Backend::Sqlite).await else { return };
                super::$name(fixture).await;
            })+
        }
        mod postgres {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 4)]
            async fn $name() {
                let Some(fixture) = super::Fixture::open(super::Backend::Postgres).await else { return };
                super::$name(fixture).await;
            })+
        }
    };
}

on_every_store! {
    claims_go_by_priority_then_age,
    no_job_is_claimed_twice,
    a_stale_worker_changes_nothing,
    a_heartbeat_keeps_a_lease,
    crashes_end_in_dead_and_others_go_on,
    a_lost_process_gives_up_its_jobs_at_once_and_others_keep_theirs,
    a_shutdown_is_no_attempt,
    readers_of_a_trace_see_every_point_once,
    progress_never_goes_back_within_an_attempt,
    cancel_leads_to_exactly_one_end_from_every_state,
    the_queue_has_a_limit,
    other_tenants_see_nothing,
    shared_blobs_stay_until_nobody_needs_them,
    a_blob_that_is_not_what_its_name_says_is_refused,
    a_blob_in_parts_gets_its_name_at_the_end,
    the_store_is_set_to_be_durable,
    what_is_stored_stays_after_all_connections_ended,
    an_equal_job_is_answered_from_the_first_result,
    a_deadline_and_a_run_time_are_kept,
    changes_come_in_order_and_none_is_missed,
    an_idempotency_key_makes_one_thing,
    lists_are_filtered_in_every_way,
    a_batch_is_made_whole_or_not_at_all,
    retention_removes_results_then_records,
    meshes_are_kept_while_jobs_refer_to_them,
    keys_end_when_revoked_or_expired,
    webhooks_are_told_once_of_each_change,
}
