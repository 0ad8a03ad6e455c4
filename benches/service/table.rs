//! Latencies of lists, reads, claims and submissions as the table grows.

use crate::place::{Database, Place};
use crate::queue::{admission, new_job, outcome};
use crate::{Latencies, Scale};
use homolog::jobs::job::Order;
use homolog::jobs::{JobFilter, JobQueue, JobReader, JobState, JobWriter, PageRequest, Tenant, WorkerId};
use homolog::store::sql::SqlStore;
use std::time::{Duration, Instant};

const LEASE: Duration = Duration::from_secs(60);
const COLUMNS: &str = "method, method_version, parameters, source, target, labels, max_attempts, attempt, lease_epoch, \
                       started_at, finished_at, cached, cancel_requested, crashes";

pub(crate) async fn latencies(scale: Scale) {
    let (sizes, repeats): (&[u64], usize) =
        scale.pick((&[1_000, 2_000], 5), (&[1_000, 10_000, 100_000, 1_000_000], 100));
    println!("\n## Latency by the number of jobs in the table, ms\n");
    println!(
        "p50 / p99 of {repeats} sequential calls of the store; pages of 50. Three quarters of the jobs are finished jobs of"
    );
    println!(
        "the tenant with the label `study=all`; a quarter are queued jobs of another tenant with a lower priority than"
    );
    println!(
        "the jobs that are claimed. Ten jobs failed, and ten have the label `study=few`. The rows are copies of one job,"
    );
    println!("made by SQL; the planner's statistics are up to date.\n");
    println!(
        "| store | jobs | first page | second | 10 failed | 10 labeled | most labeled | labeled and failed | job | position in queue | submit | claim | finish |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    for place in Place::all() {
        let store = place.store().await;
        let database = place.database().await;
        let tenant = Tenant::default();
        // The row of which the others are copies.
        store.insert_job(&new_job(&tenant, 0, "all"), &admission()).await.unwrap();
        let leased = store.claim_next(&WorkerId::random(), LEASE, LEASE).await.unwrap().unwrap();
        store.finish_job(&leased.lease, &outcome(&tenant), None).await.unwrap();
        let mut filled = 1;
        for &size in sizes {
            fill(&database, filled, size).await;
            filled = size;
            row(&place, &store, size, repeats).await;
        }
        store.close().await;
    }
}

/// Adds jobs up to number `to`; the failed and specially labeled ones are among the first hundred, that is, the oldest.
async fn fill(database: &Database, from: u64, to: u64) {
    let (id, series, analyze) = match database {
        Database::Postgres(_) => (
            "lpad(to_hex(n), 8, '0') || '-0000-7000-8000-' || lpad(to_hex(n), 12, '0')",
            format!("generate_series({}, {to}) AS numbers (n)", from + 1),
            "VACUUM ANALYZE",
        ),
        Database::Sqlite(_) => (
            "printf('%08x-0000-7000-8000-%012x', n, n)",
            format!(
                "(WITH RECURSIVE numbers (n) AS (VALUES ({}) UNION ALL SELECT n + 1 FROM numbers WHERE n < {to}) \
                 SELECT n FROM numbers) AS numbers",
                from + 1
            ),
            "ANALYZE",
        ),
    };
    let text = format!(
        "CREATE TABLE IF NOT EXISTS model AS SELECT * FROM jobs;
         INSERT INTO jobs (id, tenant, state, priority, created_at, scheduled_at, {COLUMNS})
         SELECT {id}, CASE WHEN n % 4 = 0 THEN 'other' ELSE 'default' END,
                CASE WHEN n % 4 = 0 THEN 'queued' WHEN n IN (21, 22, 23, 25, 26, 27, 29, 30, 31, 33) THEN 'failed'
                     ELSE 'succeeded' END,
                CASE WHEN n % 4 = 0 THEN -1 ELSE 0 END,
                model.created_at - 100000000 + n, model.created_at - 100000000 + n, {COLUMNS}
         FROM model, {series};
         INSERT INTO job_labels (job_id, tenant, name, value, created_at)
         SELECT {id}, CASE WHEN n % 4 = 0 THEN 'other' ELSE 'default' END, 'study',
                CASE WHEN n IN (41, 42, 43, 45, 46, 47, 49, 50, 51, 53) THEN 'few' ELSE 'all' END,
                model.created_at - 100000000 + n
         FROM model, {series};"
    );
    database.execute(&text).await;
    // A separate statement, because it cannot run in a transaction.
    database.execute(analyze).await;
}

async fn row(place: &Place, store: &SqlStore, size: u64, repeats: usize) {
    let tenant = Tenant::default();
    let labeled = |value: &str| JobFilter {
        tags: vec![("study".to_owned(), value.to_owned())].into_iter().collect(),
        ..JobFilter::default()
    };
    let failed = JobFilter { states: vec![JobState::Failed], ..JobFilter::default() };
    let failed_and_labeled = JobFilter { states: vec![JobState::Failed], ..labeled("all") };
    let page = PageRequest { size: 50, after: None, order: Order::NewestFirst };
    let next = store.list_jobs(&tenant, &JobFilter::default(), &page).await.unwrap().next;
    let second = PageRequest { after: next, ..page.clone() };
    let mut cells = Vec::new();
    for (filter, page, expected) in [
        (JobFilter::default(), &page, 50),
        (JobFilter::default(), &second, 50),
        (failed, &page, 10),
        (labeled("few"), &page, 10),
        (labeled("all"), &page, 50),
        (failed_and_labeled, &page, 10),
    ] {
        let mut taken = Vec::new();
        let began = Instant::now();
        // A few calls are enough where each is slow.
        while taken.len() < repeats && (taken.len() < 5 || began.elapsed() < Duration::from_secs(5)) {
            let one = Instant::now();
            let jobs = store.list_jobs(&tenant, &filter, page).await.unwrap().jobs;
            taken.push(one.elapsed().as_secs_f64());
            assert_eq!(jobs.len(), expected);
        }
        cells.push(taken);
    }
    let [mut get, mut place_in_queue, mut submit, mut claim, mut finish] = [const { Vec::new() }; 5];
    let worker = WorkerId::random();
    for _ in 0..repeats {
        let one = Instant::now();
        let id = store.insert_job(&new_job(&tenant, 0, "new"), &admission()).await.unwrap().id;
        submit.push(one.elapsed().as_secs_f64());
        let one = Instant::now();
        store.get_job(&tenant, id).await.unwrap();
        place_in_queue.push(one.elapsed().as_secs_f64());
        let one = Instant::now();
        let leased = store.claim_next(&worker, LEASE, LEASE).await.unwrap().unwrap();
        claim.push(one.elapsed().as_secs_f64());
        assert_eq!(leased.lease.job_id, id);
        let one = Instant::now();
        store.finish_job(&leased.lease, &outcome(&tenant), None).await.unwrap();
        finish.push(one.elapsed().as_secs_f64());
        let one = Instant::now();
        store.get_job(&tenant, id).await.unwrap();
        get.push(one.elapsed().as_secs_f64());
    }
    cells.extend([get, place_in_queue, submit, claim, finish]);
    let cells: Vec<_> = cells
        .into_iter()
        .map(Latencies::new)
        .map(|taken| format!("{:.1} / {:.1}", taken.ms(0.5), taken.ms(0.99)))
        .collect();
    println!("| {} | {size} | {} |", place.name(), cells.join(" | "));
}
