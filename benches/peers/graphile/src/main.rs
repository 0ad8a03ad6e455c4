//! Submissions and jobs per second of graphile_worker, on the database whose address is the first argument: jobs that
//! do nothing, 8 submitters, then 8 workers. Prints three lines with one number each.
//!
//! Two ways of working are measured. `each`: every job is claimed by itself, as in the service; through `run_once`,
//! since `run` without a local queue claims a job a worker for each hint or poll and so leaves a backlog to the poll.
//! `batched`: through `run` with a local queue, which claims a hundred jobs at once.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

use graphile_worker::{
    IntoTaskHandlerResult, JobSpec, LocalQueueConfig, TaskHandler, Worker, WorkerContext, WorkerOptions,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

static DONE: AtomicU64 = AtomicU64::new(0);
const WORKERS: usize = 8;

#[derive(Deserialize, Serialize)]
struct Nothing {
    number: u64,
}

impl TaskHandler for Nothing {
    const IDENTIFIER: &'static str = "nothing";

    async fn run(self, _: WorkerContext) -> impl IntoTaskHandlerResult {
        DONE.fetch_add(1, Ordering::Relaxed);
        Ok::<(), String>(())
    }
}

fn options(url: &str) -> WorkerOptions {
    // As many connections as the service's store has.
    WorkerOptions::default()
        .database_url(url)
        .max_pg_conn(8)
        .concurrency(WORKERS)
        .schema("graphile_worker")
        .define_job::<Nothing>()
}

/// Submits jobs and returns the number per second.
async fn submit(worker: &Worker, n_jobs: u64) -> f64 {
    let began = Instant::now();
    let submitters: Vec<_> = (0..WORKERS as u64)
        .map(|submitter| {
            let utils = worker.create_utils();
            tokio::spawn(async move {
                for number in (submitter..n_jobs).step_by(WORKERS) {
                    utils.add_job(Nothing { number }, JobSpec::default()).await.unwrap();
                }
            })
        })
        .collect();
    for submitter in submitters {
        submitter.await.unwrap();
    }
    n_jobs as f64 / began.elapsed().as_secs_f64()
}

#[tokio::main]
async fn main() {
    let mut arguments = std::env::args().skip(1);
    let url = arguments.next().unwrap();
    let n_jobs: u64 = arguments.next().unwrap().parse().unwrap();

    let worker = options(&url).init().await.unwrap();
    println!("submissions {:.0}", submit(&worker, n_jobs).await);
    let began = Instant::now();
    worker.run_once().await.unwrap();
    assert_eq!(DONE.load(Ordering::Relaxed), n_jobs);
    println!("each {:.0}", n_jobs as f64 / began.elapsed().as_secs_f64());

    let worker = options(&url).local_queue(LocalQueueConfig::default().with_size(100)).init().await.unwrap();
    let worker = Arc::new(worker);
    submit(&worker, n_jobs).await;
    let began = Instant::now();
    let runner = Arc::clone(&worker);
    tokio::spawn(async move { runner.run().await.unwrap() });
    while DONE.load(Ordering::Relaxed) < 2 * n_jobs {
        tokio::time::sleep(Duration::from_millis(1)).await;
    }
    println!("batched {:.0}", n_jobs as f64 / began.elapsed().as_secs_f64());
}
