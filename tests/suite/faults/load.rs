//! A13, A14, A23: transactions that stay open, processes that share a database, and nodes that are killed under load.

use super::client::{Client, id_of, steps};
use super::node::Node;
use super::queue::{LONG, Queue};
use super::site::{Backend, SOON, Site};
use super::{length, on_both, seconds};
use homolog::jobs::JobError;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use std::time::{Duration, Instant};

on_both!(a13_an_open_transaction_does_not_slow_claims, a23_nodes_killed_at_random_lose_nothing);

async fn a13_an_open_transaction_does_not_slow_claims(backend: Backend) {
    let site = Site::open(backend);
    let queue = Queue { store: site.store().await };
    for _ in 0..50 {
        queue.add().await.unwrap();
    }
    // A reporting transaction that was never closed: rows replaced from now on cannot be vacuumed.
    let database = site.database().await;
    let held = database.hold_open().await;
    let until = Instant::now() + seconds(15, 180);
    let mut workers = tokio::task::JoinSet::new();
    for n in 0..4 {
        let queue = Queue { store: site.store().await };
        workers.spawn(async move {
            let (name, mut took) = (format!("worker-{n}"), Vec::new());
            while Instant::now() < until {
                queue.add().await?;
                let asked = Instant::now();
                let claimed = queue.claim(&name, LONG).await?;
                took.push(asked.elapsed());
                if let Some(lease) = claimed {
                    queue.append(&lease, 1..=3).await?;
                    queue.finish(&lease, "done").await?;
                }
            }
            Ok::<_, JobError>(took)
        });
    }
    // The rows that cannot be vacuumed grow with the claims: the last claims are compared with the first.
    let [mut first, mut last] = [Vec::new(), Vec::new()];
    for done in workers.join_all().await {
        let took: Vec<Duration> = done.unwrap();
        let third = took.len() / 3;
        first.extend_from_slice(&took[..third]);
        last.extend_from_slice(&took[took.len() - third..]);
    }
    drop(held);
    assert!(first.len() > 10, "{} claims", 3 * first.len());
    let [before, after] = [first, last].map(|mut took| {
        took.sort();
        took[took.len() / 2]
    });
    println!("median of the first claims {before:?}, of the last {after:?}");
    assert!(after < 10 * before, "claims take {after:?} after {before:?}");
}

/// On PostgreSQL processes do not wait for each other's transactions.
mod a14_processes_wait_for_each_others_writes {
    use super::*;

    #[tokio::test]
    async fn sqlite() {
        let site = Site::open(Backend::Sqlite);
        let node = site.serve(&[]);
        let client = site.client(&node);
        let _worker = site.worker(&[]);
        let first = client.submit(steps(100, 25)).await;
        client.until_traced(&first, 2, SOON).await;
        let database = site.database().await;

        // A short lock: all requests wait and none is refused.
        let lock = database.hold_lock().await;
        let mut waiting = tokio::task::JoinSet::new();
        for _ in 0..8 {
            let client = client.clone();
            waiting.spawn(async move { client.try_submit(&steps(1, 1)).await.unwrap() });
        }
        assert_eq!(client.job(&first).await["id"], first.as_str(), "readers do not wait");
        tokio::time::sleep(Duration::from_secs(3)).await;
        drop(lock);
        for (status, body) in waiting.join_all().await {
            assert_eq!(status, 202, "{body}");
            client.until_succeeded(&id_of(&body), SOON).await;
        }

        // A lock beyond the time limit: the request is refused and does not hang.
        let lock = database.hold_lock().await;
        let (status, body) = client.try_submit(&steps(1, 1)).await.unwrap();
        assert_eq!((status, body["type"].as_str()), (503, Some("/problems/unavailable")), "{body}");
        drop(lock);
        client.until_succeeded(&first, SOON * 2).await;
        let id = client.submit(steps(1, 1)).await;
        client.until_succeeded(&id, SOON).await;
    }
}

async fn a23_nodes_killed_at_random_lose_nothing(backend: Backend) {
    let site = Site::open(backend);
    // One node stays up and takes the submissions; the two others are killed and restarted.
    let arguments = ["--workers", "2", "--max-attempts", "100"];
    let front = site.serve(&[&arguments[2..], &["--workers", "1"]].concat());
    let client = site.client(&front);
    let database = site.database().await;
    database.watch().await;
    let (n_jobs, time) = (length(150, 2_000), seconds(30, 600));
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(23);
    let mut below = |bound: u64| rng.next_u64() % bound;
    let start = |victim: usize| match backend {
        // On SQLite only one process may serve HTTP.
        Backend::Sqlite => site.worker(&arguments),
        Backend::Postgres if victim == 0 => site.serve(&arguments),
        Backend::Postgres => site.worker(&arguments),
    };
    let mut victims = [start(0), start(1)];
    let submitting = tokio::spawn(submit_over(client.clone(), n_jobs, time));
    let (began, mut n_kills) = (Instant::now(), 0);
    while began.elapsed() < time {
        tokio::time::sleep(Duration::from_millis(300 + below(2_500))).await;
        let victim = below(2) as usize;
        if below(4) == 0 {
            // Some nodes are suspended past their lease before they are killed.
            database.freeze(&victims[victim]).await;
            tokio::time::sleep(Duration::from_millis(below(4_000))).await;
            victims[victim].thaw();
        }
        victims[victim].kill();
        n_kills += 1;
        victims[victim] = start(victim);
    }
    let ids = submitting.await.unwrap();
    assert_eq!(ids.len() as u64, n_jobs);
    for id in &ids {
        client.until_succeeded(id, SOON * 3).await;
    }
    let crashed = database.number("SELECT COUNT(*) FROM jobs WHERE crashes > 0").await;
    println!("{n_jobs} jobs, {n_kills} kills, {crashed} jobs begun more than once");
    assert_eq!(database.jobs_and_results().await, (n_jobs as i64, n_jobs as i64));
    let (claims, distinct) = database.claims().await;
    assert_eq!(claims, distinct);
    for id in ids.iter().step_by(10) {
        assert_eq!(client.seqs(id).await, (1..=12).collect::<Vec<_>>());
        assert_eq!(client.json(&format!("/v1/jobs/{id}/result")).await["points"], 12);
    }
    assert!(n_kills > 5, "{n_kills} kills");
    assert!(crashed > 0, "no kill met a job");
    let _: [Node; 2] = victims;
}

async fn submit_over(client: Client, n_jobs: u64, time: Duration) -> Vec<String> {
    let mut ids = Vec::new();
    let pause = time.mul_f64(0.8) / n_jobs as u32;
    for _ in 0..n_jobs {
        ids.push(client.submit(steps(12, 50)).await);
        tokio::time::sleep(pause).await;
    }
    ids
}
