//! Submissions and claims at the store, compared with the limit of the disk and with graphile_worker.

use crate::place::Place;
use crate::{Latencies, Scale};
use homolog::jobs::metadata::Tags;
use homolog::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, JobId, JobInput, JobQueue, JobWriter, NewJob, Outcome, Tenant,
    WorkerId,
};
use homolog::store::sql::SqlStore;
use serde_json::json;
use std::collections::BTreeMap;
use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

const LEASE: Duration = Duration::from_secs(60);
const WORKERS: usize = 8;
/// Maximum number of queued jobs of a tenant; the service's default.
const MAX_QUEUE: u32 = 1_000;

/// A job with a label, of a tenant.
pub(crate) fn new_job(tenant: &Tenant, priority: i32, label: &str) -> NewJob {
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
        tenant: tenant.clone(),
        method: "told".to_owned(),
        method_version: "1".to_owned(),
        parameters: json!({"seed": 1}),
        source: input('a'),
        target: input('b'),
        priority,
        tags: Tags::new(BTreeMap::from([("study".to_owned(), label.to_owned())])).unwrap(),
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

/// The limits under which jobs are submitted.
pub(crate) fn admission() -> Admission {
    Admission { max_queued: MAX_QUEUE, holder: String::new(), keep_result: None, once: None }
}

/// The outcome of a successful job, with a result.
pub(crate) fn outcome(tenant: &Tenant) -> Outcome {
    let key = ArtifactKey::of_hash(tenant, &"c".repeat(64)).unwrap();
    Outcome::Succeeded { artifacts: vec![ArtifactRef { kind: ArtifactKind::Result, key, n_bytes: 1 }], verdict: None }
}

/// One of many tenants, over which jobs are spread so that none exceeds its queue limit.
fn tenant_of(number: u64) -> Tenant {
    Tenant::new(&format!("t{}", number / 500)).unwrap()
}

/// Durable writes of 4 KiB per second: an upper bound on commits per second if every commit is flushed.
fn flushes_per_second(scale: Scale) -> f64 {
    let mut file = tempfile::tempfile().unwrap();
    let block = [7_u8; 4096];
    let (began, mut n) = (Instant::now(), 0_u64);
    while began.elapsed() < scale.time() / 3 {
        file.write_all(&block).unwrap();
        file.sync_data().unwrap();
        n += 1;
    }
    n as f64 / began.elapsed().as_secs_f64()
}

pub(crate) async fn submissions(scale: Scale) {
    println!("\n## Durable submissions at the store\n");
    println!(
        "`JobWriter::insert_job`, each in its own transaction; {:?} per row. For comparison, the disk does",
        scale.time()
    );
    println!("{:.0} sequential writes of 4 KiB with `fdatasync` per second.\n", flushes_per_second(scale));
    println!("| store | writers | submissions/s | p50 ms | p99 ms |\n|---|---|---|---|---|");
    for place in Place::all() {
        let store = Arc::new(place.store().await);
        let number = Arc::new(AtomicU64::new(0));
        for writers in [1, WORKERS] {
            let (rate, latencies) = insert_for(&store, writers, scale.time(), &number).await;
            let (p50, p99) = (latencies.ms(0.5), latencies.ms(0.99));
            println!("| {} | {writers} | {rate:.0} | {p50:.2} | {p99:.2} |", place.name());
        }
        store.close().await;
    }
}

async fn insert_for(
    store: &Arc<SqlStore>,
    writers: usize,
    time: Duration,
    number: &Arc<AtomicU64>,
) -> (f64, Latencies) {
    let began = Instant::now();
    let mut tasks = tokio::task::JoinSet::new();
    for _ in 0..writers {
        let (store, number) = (Arc::clone(store), Arc::clone(number));
        tasks.spawn(async move {
            let mut taken = Vec::new();
            while began.elapsed() < time {
                let tenant = tenant_of(number.fetch_add(1, Ordering::Relaxed));
                let one = Instant::now();
                store.insert_job(&new_job(&tenant, 0, "bench"), &admission()).await.unwrap();
                taken.push(one.elapsed().as_secs_f64());
            }
            taken
        });
    }
    let all = Latencies::new(tasks.join_all().await.concat());
    (all.count() as f64 / began.elapsed().as_secs_f64(), all)
}

pub(crate) async fn claims(scale: Scale) {
    println!("\n## Claims with {WORKERS} workers\n");
    println!(
        "Claim and finish with a result, until the queue is empty. The disk does {:.0} flushes per second;",
        flushes_per_second(scale)
    );
    println!("each job needs two, or fewer where commits share a flush. graphile_worker on the same cluster runs");
    println!("jobs that do nothing, deletes finished jobs, and keeps neither results nor a history of states.\n");
    println!("| queue | jobs | jobs/s | claim p50 ms | claim p99 ms | finish p50 ms | finish p99 ms |");
    println!("|---|---|---|---|---|---|---|");
    let n_jobs = scale.pick(100, 3_000);
    for place in Place::all() {
        let store = Arc::new(place.store().await);
        for number in 0..n_jobs / 100 {
            fill(&place, &store, number).await;
        }
        let began = Instant::now();
        let mut tasks = tokio::task::JoinSet::new();
        for _ in 0..WORKERS {
            let store = Arc::clone(&store);
            tasks.spawn(async move {
                let worker = WorkerId::random();
                let (mut claims, mut finishes) = (Vec::new(), Vec::new());
                loop {
                    let one = Instant::now();
                    let Some(leased) = store.claim_next(&worker, LEASE, LEASE).await.unwrap() else { break };
                    claims.push(one.elapsed().as_secs_f64());
                    let one = Instant::now();
                    store.finish_job(&leased.lease, &outcome(&leased.lease.tenant), None).await.unwrap();
                    finishes.push(one.elapsed().as_secs_f64());
                }
                (claims, finishes)
            });
        }
        let (claims, finishes): (Vec<_>, Vec<_>) = tasks.join_all().await.into_iter().unzip();
        let seconds = began.elapsed().as_secs_f64();
        let (claims, finishes) = (Latencies::new(claims.concat()), Latencies::new(finishes.concat()));
        assert_eq!(claims.count() as u64, n_jobs);
        println!(
            "| this store on {} | {n_jobs} | {:.0} | {:.2} | {:.2} | {:.2} | {:.2} |",
            place.name(),
            n_jobs as f64 / seconds,
            claims.ms(0.5),
            claims.ms(0.99),
            finishes.ms(0.5),
            finishes.ms(0.99)
        );
        store.close().await;
        if let Some(cluster) = &place.cluster {
            peer(&cluster.url(), n_jobs);
        }
    }
}

/// Queues a hundred jobs in one transaction, which is fastest.
async fn fill(place: &Place, store: &SqlStore, number: u64) {
    use homolog::jobs::{BatchId, NewBatch};
    let tenant = tenant_of(number * 100);
    let id = BatchId::new();
    let batch = NewBatch { id, tenant: tenant.clone(), tags: Tags::default(), external_ref: None };
    let jobs: Vec<_> = (0..100).map(|_| NewJob { batch_id: Some(id), ..new_job(&tenant, 0, place.name()) }).collect();
    store.insert_batch(&batch, &jobs, &admission()).await.unwrap();
}

/// The row of graphile_worker, if `make bench-service` has built it and set its path.
fn peer(url: &str, n_jobs: u64) {
    let Some(program) = std::env::var_os("HOMOLOG_BENCH_PEER") else {
        println!("| graphile_worker on PostgreSQL | not built; `make bench-service` does | | | | | |");
        return;
    };
    let output = std::process::Command::new(program).args([url, &n_jobs.to_string()]).output().unwrap();
    assert!(output.status.success(), "the peer: {}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let rate = |name: &str| text.lines().find_map(|l| l.strip_prefix(name)).unwrap().trim().to_owned();
    println!("| graphile_worker on PostgreSQL, each job claimed by itself | {n_jobs} | {} | | | | |", rate("each "));
    println!("| graphile_worker on PostgreSQL, claims of a hundred | {n_jobs} | {} | | | | |", rate("batched "));
    println!("\ngraphile_worker took {} submissions per second from 8 submitters.", rate("submissions "));
}
