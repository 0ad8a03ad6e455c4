//! Which queued job starts next, when, and on how many threads.

use super::jobs_support::{TestService, WorkerProcess};
use serde_json::{Value, json};
use std::sync::atomic::Ordering;
use std::time::Duration;

/// A job that demands `cores` cores and runs for 1.5 s unless it is cancelled.
fn on_cores(cores: u64) -> Value {
    json!({"cores": cores, "points": 75, "step_ms": 20, "sign": 1})
}

/// A patience that no job in these tests reaches.
const PATIENT: [&str; 2] = ["--patience-ms", "600000"];

async fn state(service: &TestService, id: &str) -> Value {
    service.json(&format!("/v1/jobs/{id}")).await["state"].clone()
}

async fn n_threads(service: &TestService, id: &str) -> Value {
    assert_eq!(service.until_final(id).await["state"], "succeeded");
    service.json(&format!("/v1/jobs/{id}/result")).await["n_threads"].clone()
}

/// When a job started, as a text that sorts by time.
async fn started_at(service: &TestService, id: &str) -> String {
    let job = service.until_final(id).await;
    assert_eq!(job["state"], "succeeded");
    job["started_at"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn small_jobs_run_side_by_side_while_a_large_one_is_queued() {
    let service = TestService::start(&[&["--cores", "3"], &PATIENT[..]].concat()).await;
    let first = service.submit(on_cores(1)).await;
    service.until_running(&first).await;
    let large = service.submit(on_cores(3)).await;
    let second = service.submit(on_cores(1)).await;
    service.until_running(&second).await;
    assert_eq!((state(&service, &first).await, state(&service, &large).await), (json!("running"), json!("queued")));
    assert_eq!(n_threads(&service, &first).await, 3, "nothing else was queued or running when it started");
    assert_eq!(n_threads(&service, &second).await, 1);
    assert_eq!(n_threads(&service, &large).await, 3);
    service.end().await;
}

#[tokio::test]
async fn a_large_job_that_has_waited_for_the_patience_starts_before_later_small_ones() {
    let service = TestService::start(&["--cores", "2", "--patience-ms", "0"]).await;
    let first = service.submit(on_cores(1)).await;
    service.until_running(&first).await;
    let large = service.submit(on_cores(2)).await;
    let second = service.submit(on_cores(1)).await;
    tokio::time::sleep(Duration::from_millis(500)).await;
    assert_eq!(state(&service, &second).await, "queued", "a core is free but reserved for the large job");
    assert!(started_at(&service, &large).await < started_at(&service, &second).await);
    service.end().await;
}

#[tokio::test]
async fn a_job_that_cannot_start_here_is_left_to_other_processes() {
    let service = TestService::start(&["--cores", "2", "--patience-ms", "0"]).await;
    let small = service.submit(json!({"cores": 1, "points": 500, "step_ms": 20})).await;
    service.until_running(&small).await;
    let large = service.submit(json!({"cores": 2, "points": 2})).await;
    tokio::time::sleep(Duration::from_millis(300)).await;
    assert_eq!(state(&service, &large).await, "queued");

    let WorkerProcess { shutdown, engine, running } = service.worker(&["--cores", "2"]).await;
    assert_eq!(service.until_final(&large).await["state"], "succeeded");
    assert_eq!((state(&service, &small).await, engine.computed.load(Ordering::SeqCst)), (json!("running"), 1));
    shutdown.stop.cancel();
    running.await.unwrap();
    service.end().await;
}

#[tokio::test]
async fn with_fixed_slots_each_job_gets_an_equal_share_of_the_cores() {
    let service = TestService::start(&["--cores", "4", "--workers", "2"]).await;
    let first = service.submit(on_cores(4)).await;
    service.until_running(&first).await;
    let [second, third] = [service.submit(on_cores(1)).await, service.submit(on_cores(4)).await];
    service.until_running(&second).await;
    assert_eq!((state(&service, &first).await, state(&service, &third).await), (json!("running"), json!("queued")));
    assert_eq!((n_threads(&service, &second).await, n_threads(&service, &third).await), (json!(2), json!(2)));
    service.end().await;
}

#[tokio::test]
async fn a_request_that_waits_for_a_short_job_is_answered_as_soon_as_it_ends() {
    let service = TestService::start(&[]).await;
    let mut waited = Vec::new();
    for seed in 0..20 {
        let form = super::jobs_support::form("source", "target", &json!({"points": 1, "seed": seed}));
        let request = service.client.post(format!("{}/v1/jobs", service.base)).header("prefer", "wait=20");
        let response = request.multipart(form).send().await.unwrap();
        let answered = jiff::Timestamp::now();
        assert_eq!(response.status(), 200, "it has ended");
        let job: Value = response.json().await.unwrap();
        let ended: jiff::Timestamp = job["finished_at"].as_str().unwrap().parse().unwrap();
        waited.push(Duration::try_from(answered.duration_since(ended)).unwrap_or_default());
    }
    // The store is polled only every 250 ms while a request waits: without a notice none is answered earlier.
    assert!(waited.iter().min().unwrap() < &Duration::from_millis(250), "{waited:?}");
    service.end().await;
}

#[tokio::test]
async fn the_parameters_of_a_queued_job_are_read_once_however_often_the_queue_is_polled() {
    let service = TestService::start(&[&["--cores", "2"], &PATIENT[..]].concat()).await;
    let small = service.submit(json!({"cores": 1, "points": 75, "step_ms": 20})).await;
    service.until_running(&small).await;
    let large = service.submit(json!({"cores": 2, "points": 1})).await;
    // A core is free and the queue is polled every 20 ms, about 70 times while the large job has to wait.
    assert_eq!(service.until_final(&large).await["state"], "succeeded");
    assert_eq!(
        service.engine.restored.load(Ordering::SeqCst),
        4,
        "for each job once by the queue, once for its `eta_ms`"
    );
    service.end().await;
}
