//! A1, A4, A10, A17: workers that die, abort, lose their heartbeat, or do not stop.

use super::client::steps;
use super::on_both;
use super::site::{Backend, SOON, Site};
use serde_json::json;
use std::time::{Duration, Instant};

on_both!(
    a01_the_job_of_a_killed_worker_runs_again,
    a04_a_job_that_kills_its_workers_becomes_dead_and_others_run,
    a10_a_worker_whose_heartbeats_fail_claims_nothing_and_drops_its_job,
    a17_a_computation_that_ignores_cancellation_frees_its_slot,
);

async fn a01_the_job_of_a_killed_worker_runs_again(backend: Backend) {
    let site = Site::open(backend);
    let front = site.serve(&["--workers", "0"]);
    let client = site.client(&front);
    let database = site.database().await;
    database.watch().await;
    let mut doomed = site.worker(&[]);
    let id = client.submit(steps(60, 25)).await;
    client.until_traced(&id, 20, SOON).await;
    let _heir = site.worker(&["--workers", "1"]);
    doomed.kill();
    client.until(&id, SOON, |job| job["attempt"] == 2 && job["state"] != "queued").await;
    client.until_succeeded(&id, SOON).await;
    assert_eq!(client.seqs(&id).await, (1..=60).collect::<Vec<_>>(), "no point twice, none missing");
    assert_eq!(client.json(&format!("/v1/jobs/{id}/result")).await["points"], 60);
    assert_eq!(database.n_results(&id).await, 1);
}

async fn a04_a_job_that_kills_its_workers_becomes_dead_and_others_run(backend: Backend) {
    let site = Site::open(backend);
    let front = site.serve(&["--workers", "0", "--max-attempts", "3"]);
    let client = site.client(&front);
    let poison = client.submit(json!({"abort": 1, "points": 2, "step_ms": 20})).await;
    let mut others = Vec::new();
    for _ in 0..6 {
        others.push(client.submit(steps(3, 20)).await);
    }
    // As a supervisor does, workers that exit are restarted.
    let start = || site.worker(&["--lease-ms", "1000"]);
    let mut workers = [start(), start()];
    let (began, mut n_crashes) = (Instant::now(), 0);
    loop {
        for worker in &mut workers {
            if !worker.is_running() {
                n_crashes += 1;
                *worker = start();
            }
        }
        if client.job(&poison).await["state"] == "dead" {
            break;
        }
        assert!(began.elapsed() < SOON * 2, "{}", client.job(&poison).await);
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    for id in &others {
        client.until_succeeded(id, SOON).await;
    }
    let dead = client.job(&poison).await;
    assert_eq!((&dead["attempt"], &dead["error"]["type"]), (&json!(3), &json!("/problems/crash-limit-reached")));
    assert_eq!(n_crashes, 3);
    assert!(workers.iter_mut().all(super::node::Node::is_running));
}

async fn a10_a_worker_whose_heartbeats_fail_claims_nothing_and_drops_its_job(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "2", "--lease-ms", "3000"]);
    let client = site.client(&node);
    let database = site.database().await;
    database.watch().await;
    let running = client.submit(steps(400, 25)).await;
    client.until_traced(&running, 5, SOON).await;
    let failing = Instant::now();
    database.fail_heartbeats().await;
    node.until_logged("heartbeat failed", SOON).await;
    let waiting = client.submit(steps(3, 25)).await;
    loop {
        let job = client.job(&waiting).await;
        if node.log().contains("lease lost") {
            break;
        }
        assert_eq!(job["state"], "queued", "a worker that cannot renew leases claimed a job");
        assert!(failing.elapsed() < SOON, "the worker continues without a lease");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
    assert!(
        failing.elapsed() > Duration::from_secs(1),
        "the worker dropped the job before its lease had expired: {:?}",
        failing.elapsed()
    );
    database.allow_heartbeats().await;
    for id in [&running, &waiting] {
        client.until_succeeded(id, SOON * 2).await;
        assert_eq!(database.n_results(id).await, 1);
    }
    assert_eq!(client.seqs(&running).await, (1..=400).collect::<Vec<_>>());
}

async fn a17_a_computation_that_ignores_cancellation_frees_its_slot(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "1"]);
    let client = site.client(&node);
    let deaf = client.submit(json!({"deaf": 1, "points": 1200, "step_ms": 50})).await;
    client.until_traced(&deaf, 2, SOON).await;
    let next = client.submit(steps(2, 10)).await;
    assert_eq!(client.post(&format!("/v1/jobs/{deaf}/cancel")).await.unwrap().status(), 202);
    let job = client.until_final(&deaf, SOON).await;
    assert_eq!(job["state"], "cancelled");
    client.until_succeeded(&next, SOON).await;
    assert!(node.log().contains("its thread is abandoned"), "{}", node.log());
    let points = client.seqs(&deaf).await.len();
    assert!(points < 1200, "it was not waited for");
    tokio::time::sleep(Duration::from_millis(500)).await;
    assert_eq!(client.seqs(&deaf).await.len(), points, "trace points after the cancellation are not stored");
}
