//! Running jobs when their process shuts down, and processes that share a data directory.

use super::jobs_support::{TestService, WorkerProcess};
use serde_json::json;
use std::sync::atomic::Ordering;
use std::time::Duration;

#[tokio::test]
async fn a_shutdown_requeues_running_jobs_and_they_finish_after_a_restart() {
    let service = TestService::start(&[]).await;
    let running = service.submit(json!({"points": 40, "step_ms": 20})).await;
    let waiting = service.submit(json!({"points": 2})).await;
    service.until_running(&running).await;
    let folder = service.end().await;

    let service = TestService::start_in(folder, &[]).await;
    for id in [&running, &waiting] {
        let job = service.until_final(id).await;
        assert_eq!(
            (&job["state"], &job["attempt"]),
            (&json!("succeeded"), &json!(1)),
            "a shutdown does not count as an attempt"
        );
    }
    let trace = service.json(&format!("/v1/jobs/{running}/trace")).await;
    let seqs: Vec<_> = trace["points"].as_array().unwrap().iter().map(|p| p["seq"].as_u64().unwrap()).collect();
    assert_eq!(seqs, (1..=40).collect::<Vec<_>>());
    service.end().await;
}

#[tokio::test]
async fn jobs_that_finish_within_the_grace_period_are_not_requeued() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 20, "step_ms": 20})).await;
    service.until_running(&id).await;
    service.shutdown.stop.cancel();
    tokio::time::sleep(Duration::from_millis(1500)).await;
    let computed = service.engine.computed.load(Ordering::SeqCst);
    let service = TestService::start_in(service.end().await, &["--workers", "0"]).await;
    assert_eq!(service.json(&format!("/v1/jobs/{id}")).await["state"], "succeeded");
    assert_eq!(computed, 1);
    service.end().await;
}

#[tokio::test]
async fn a_worker_process_runs_jobs_that_another_process_accepts() {
    let service = TestService::start(&["--workers", "0"]).await;
    let WorkerProcess { shutdown, engine, running } = service.worker(&["--poll-ms", "20"]).await;

    let id = service.submit(json!({"points": 3})).await;
    assert_eq!(service.until_final(&id).await["state"], "succeeded");
    let long = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    service.until_running(&long).await;
    service.post(&format!("/v1/jobs/{long}/cancel")).await;
    assert_eq!(service.until_final(&long).await["state"], "cancelled");
    assert!(service.n_traced(&long).await < 1000, "cancel crosses processes");
    assert_eq!(engine.computed.load(Ordering::SeqCst), 2);
    assert_eq!(service.engine.computed.load(Ordering::SeqCst), 0);

    shutdown.stop.cancel();
    shutdown.give_back.cancel();
    running.await.unwrap();
    service.end().await;
}

#[tokio::test]
async fn heartbeats_renew_short_leases_during_a_computation() {
    let service = TestService::start(&["--lease-ms", "300", "--heartbeat-ms", "50"]).await;
    let id = service.submit(json!({"points": 100, "step_ms": 15})).await;
    let job = service.until_final(&id).await;
    assert_eq!((&job["state"], &job["attempt"]), (&json!("succeeded"), &json!(1)));
    service.end().await;
}
