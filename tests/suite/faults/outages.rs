//! A6, A7, A21: outages of databases and blob stores, missing notifications, wrong clocks.

use super::client::{Client, id_of, steps};
use super::node::Node;
use super::postgres::Cluster;
use super::proxy::{Network, Proxy};
use super::s3::S3Server;
use super::site::{Backend, SOON, Site};
use super::witness::Database;
use super::{on_both, on_postgres, seconds};
use serde_json::Value;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tokio::task::JoinHandle;

on_both!(a07_without_notifications_a_job_runs_within_the_poll_interval);
on_postgres!(
    a06_the_database_is_stopped,
    a06_the_database_crashes,
    a06_the_database_hangs,
    a06_connections_to_the_database_are_half_open,
    a06_connections_to_the_database_are_cut,
    a06_the_blob_store_refuses,
    a06_connections_to_the_blob_store_are_half_open,
);
on_postgres!(needs "needs PostgreSQL and faketime": a21_a_workers_wrong_clock_does_not_affect_leases);

/// Maximum duration of a submission during an outage: the time of one request to the blob store, with a margin.
const NO_HANG: Duration = Duration::from_secs(120);
/// Maximum duration of a readiness check: half of that, as supervisors poll often and have short timeouts.
const READY: Duration = Duration::from_secs(60);

/// A node behind a network that can fail, and a client that submits continuously.
struct Outage {
    site: Site,
    database: Proxy,
    blobs: Proxy,
    node: Node,
    client: Client,
    witness: Database,
    long: String,
    submissions: Arc<Submissions>,
    submitting: JoinHandle<Vec<Answer>>,
}

/// Shared state of the client that submits.
#[derive(Default)]
struct Submissions {
    refused: AtomicBool,
    end: AtomicBool,
}

/// The answer to a submission, and the time it took.
struct Answer {
    status: u16,
    body: Value,
    took: Duration,
}

impl Outage {
    async fn prepare() -> Self {
        let site = Site::open(Backend::Postgres);
        let database = Proxy::to(site.cluster.as_ref().unwrap().port());
        let blobs = Proxy::to(site.s3.as_ref().unwrap().port());
        let mut environment = S3Server::environment(blobs.port());
        environment.push(("HOMOLOG_DATABASE_URL", Cluster::url_at(database.port())));
        let node = site.node("serve", &["--workers", "2", "--max-attempts", "20"], &environment).unwrap();
        let client = site.client(&node);
        let witness = site.database().await;
        witness.watch().await;
        let long = client.submit(steps(200, 25)).await;
        client.until_traced(&long, 5, SOON).await;
        let submissions = Arc::<Submissions>::default();
        let submitting = tokio::spawn(keep_submitting(client.clone(), Arc::clone(&submissions)));
        tokio::time::sleep(Duration::from_secs(1)).await;
        Outage { site, database, blobs, node, client, witness, long, submissions, submitting }
    }

    /// Waits during the outage and asserts that the service reports it, refuses submissions, and stays alive.
    async fn endure(&self, length: Duration, what: &str) {
        let began = Instant::now();
        let mut said = false;
        while began.elapsed() < length || !said || !self.submissions.refused.load(Ordering::Acquire) {
            let asked = Instant::now();
            let ready = self.client.get("/readyz").await.unwrap();
            assert!(asked.elapsed() < READY, "/readyz takes {:?}", asked.elapsed());
            if ready.status() == 503 {
                said |= ready.text().await.unwrap().contains(what);
            }
            assert_eq!(self.client.get("/healthz").await.unwrap().status(), 200, "liveness touches nothing");
            assert!(began.elapsed() < length + NO_HANG, "{what} is named: {said}, and no submission is refused");
            tokio::time::sleep(Duration::from_millis(200)).await;
        }
    }

    /// Asserts that after the outage submissions are accepted again and no acknowledged job is lost.
    async fn recovered(mut self) {
        let over = Instant::now();
        loop {
            match self.client.try_submit(&steps(1, 1)).await {
                Ok((202, _)) => break,
                _ => assert!(over.elapsed() < NO_HANG, "no submission is taken after the outage"),
            }
            tokio::time::sleep(Duration::from_millis(200)).await;
        }
        tokio::time::sleep(Duration::from_secs(1)).await;
        self.submissions.end.store(true, Ordering::Release);
        let answers = self.submitting.await.unwrap();
        for Answer { status, body, took } in &answers {
            assert!([202, 503].contains(status), "{status}: {body}");
            assert!(*took < NO_HANG, "a submission takes {took:?}");
        }
        assert!(answers.iter().any(|a| a.status == 202));
        self.client.until_succeeded(&self.long, SOON * 2).await;
        for answer in answers.iter().filter(|a| a.status == 202) {
            self.client.until_succeeded(&id_of(&answer.body), SOON * 2).await;
        }
        let (jobs, results) = self.witness.jobs_and_results().await;
        assert_eq!(jobs, results, "each result is accepted once");
        assert!(self.node.is_running());
    }
}

async fn keep_submitting(client: Client, submissions: Arc<Submissions>) -> Vec<Answer> {
    let mut answers = Vec::new();
    while !submissions.end.load(Ordering::Acquire) {
        let asked = Instant::now();
        let (status, body) = client.try_submit(&steps(2, 5)).await.unwrap_or((0, Value::Null));
        submissions.refused.fetch_or(status == 503, Ordering::AcqRel);
        answers.push(Answer { status, body, took: asked.elapsed() });
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
    answers
}

async fn a06_the_database_is_stopped() {
    let mut outage = Outage::prepare().await;
    outage.site.cluster.as_mut().unwrap().stop_fast();
    outage.endure(seconds(5, 60), "job_store").await;
    outage.site.cluster.as_mut().unwrap().start_again();
    outage.recovered().await;
}

async fn a06_the_database_crashes() {
    let mut outage = Outage::prepare().await;
    outage.site.cluster.as_mut().unwrap().kill();
    outage.endure(seconds(1, 10), "job_store").await;
    outage.site.cluster.as_mut().unwrap().start_again();
    outage.recovered().await;
}

async fn a06_the_database_hangs() {
    let outage = Outage::prepare().await;
    outage.site.cluster.as_ref().unwrap().freeze();
    outage.endure(seconds(3, 60), "job_store").await;
    outage.site.cluster.as_ref().unwrap().thaw();
    outage.recovered().await;
}

async fn a06_connections_to_the_database_are_half_open() {
    let outage = Outage::prepare().await;
    outage.database.set(Network::Silent);
    outage.endure(seconds(5, 60), "job_store").await;
    outage.database.set(Network::Up);
    outage.recovered().await;
}

async fn a06_connections_to_the_database_are_cut() {
    let outage = Outage::prepare().await;
    for _ in 0..seconds(5, 60).as_secs() {
        outage.database.cut();
        tokio::time::sleep(Duration::from_secs(1)).await;
    }
    // Whether a request is in progress when connections are cut is random; with the network down, every request fails.
    outage.database.set(Network::Refusing);
    outage.database.cut();
    outage.endure(Duration::from_secs(1), "job_store").await;
    outage.database.set(Network::Up);
    outage.recovered().await;
}

async fn a06_the_blob_store_refuses() {
    let outage = Outage::prepare().await;
    outage.blobs.set(Network::Refusing);
    outage.blobs.cut();
    outage.endure(seconds(5, 60), "artifact_store").await;
    outage.blobs.set(Network::Up);
    outage.recovered().await;
}

async fn a06_connections_to_the_blob_store_are_half_open() {
    let outage = Outage::prepare().await;
    outage.blobs.set(Network::Silent);
    outage.endure(seconds(5, 60), "artifact_store").await;
    outage.blobs.set(Network::Up);
    outage.recovered().await;
}

async fn a07_without_notifications_a_job_runs_within_the_poll_interval(backend: Backend) {
    let site = Site::open(backend);
    // Processes on SQLite do not notify each other.
    let silent: &[&str] = if backend == Backend::Postgres { &["--notify", "false"] } else { &[] };
    let front = site.serve(&[&["--workers", "0"], silent].concat());
    let client = site.client(&front);
    let _worker = site.worker(&[&["--poll-ms", "700"], silent].concat());
    for _ in 0..3 {
        let id = client.submit(steps(1, 1)).await;
        client.until_succeeded(&id, SOON).await;
    }
}

/// Environment in which only the wall clock is wrong. The monotonic clock measures intervals and is never set back.
pub(super) fn wrong_clock(offset: &str) -> Option<Vec<(&'static str, String)>> {
    let mut libraries =
        std::fs::read_dir("/usr/lib").ok()?.flatten().map(|d| d.path().join("faketime/libfaketime.so.1"));
    let library = libraries.find(|path| path.exists())?;
    Some(vec![
        ("LD_PRELOAD", library.to_str()?.to_owned()),
        ("FAKETIME", offset.to_owned()),
        ("FAKETIME_DONT_FAKE_MONOTONIC", "1".to_owned()),
        ("DONT_FAKE_MONOTONIC", "1".to_owned()),
    ])
}

/// PostgreSQL only, because on SQLite the database and the workers share the machine's clock.
async fn a21_a_workers_wrong_clock_does_not_affect_leases() {
    let site = Site::open(Backend::Postgres);
    let front = site.serve(&["--workers", "0"]);
    let client = site.client(&front);
    let database = site.database().await;
    database.watch().await;
    for offset in ["+1h", "-1h"] {
        let clock = wrong_clock(offset).expect("libfaketime; apt-get install faketime");
        // A worker with a wrong clock keeps its lease for several times its duration, beside one with a correct clock.
        let mut wrong = site.node("worker", &[], &clock).unwrap();
        let id = client.submit(steps(120, 50)).await;
        client.until_traced(&id, 5, SOON).await;
        let right = site.worker(&[]);
        let job = client.until_succeeded(&id, SOON).await;
        assert_eq!(job["attempt"], 1, "{job}");
        assert_eq!(client.seqs(&id).await, (1..=120).collect::<Vec<_>>());
        drop(right);
        // When it dies, another worker with a wrong clock takes over its job, neither an hour late nor before the lease
        // expires.
        let id = client.submit(steps(100, 25)).await;
        client.until_traced(&id, 5, SOON).await;
        wrong.kill();
        let _rescuer = site.node("worker", &[], &clock).unwrap();
        client.until(&id, SOON, |job| job["attempt"] == 2).await;
        let job = client.until_succeeded(&id, SOON).await;
        let moment: jiff::Timestamp = job["finished_at"].as_str().unwrap().parse().unwrap();
        let off = jiff::Timestamp::now().duration_since(moment);
        assert!(off.abs() < jiff::SignedDuration::from_secs(300), "times are the database's: off by {off:?}");
    }
    let (jobs, results) = database.jobs_and_results().await;
    assert_eq!(jobs, results);
}
