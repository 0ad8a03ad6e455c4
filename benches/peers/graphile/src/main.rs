//! Submissions and jobs per second of graphile_worker, on the database whose address is the first argument: jobs that
//! do nothing, 8 submitters, then 8 workers. Prints two lines, a number each.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

use graphile_worker::{IntoTaskHandlerResult, JobSpec, TaskHandler, WorkerContext, WorkerOptions};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

static DONE: AtomicU64 = AtomicU64::new(0);
const WORKERS: u64 = 8;

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

#[tokio::main]
async fn main() {
    let mut arguments = std::env::args().skip(1);
    let url = arguments.next().unwrap();
    let n_jobs: u64 = arguments.next().unwrap().parse().unwrap();
    let worker = WorkerOptions::default()
        .database_url(&url)
        // As many connections as the store of the service has.
        .max_pg_conn(8)
        .concurrency(WORKERS as usize)
        .schema("graphile_worker")
        .define_job::<Nothing>()
        .init()
        .await
        .unwrap();
    let worker = Arc::new(worker);

    let began = Instant::now();
    let submitters: Vec<_> = (0..WORKERS)
        .map(|submitter| {
            let utils = worker.create_utils();
            tokio::spawn(async move {
                for number in (submitter..n_jobs).step_by(WORKERS as usize) {
                    utils.add_job(Nothing { number }, JobSpec::default()).await.unwrap();
                }
            })
        })
        .collect();
    for submitter in submitters {
        submitter.await.unwrap();
    }
    println!("submissions {:.1}", n_jobs as f64 / began.elapsed().as_secs_f64());

    let runner = Arc::clone(&worker);
    tokio::spawn(async move { runner.run().await.unwrap() });
    let began = Instant::now();
    while DONE.load(Ordering::Relaxed) < n_jobs {
        tokio::time::sleep(Duration::from_millis(1)).await;
    }
    println!("jobs {:.1}", n_jobs as f64 / began.elapsed().as_secs_f64());
}
