//! A5, A18: shutdown of processes.

use super::client::steps;
use super::on_both;
use super::site::{Backend, SOON, Site};
use serde_json::json;
use std::time::Duration;

on_both!(
    a05_a_job_that_finishes_within_the_grace_period_succeeds,
    a05_a_job_that_outlasts_the_grace_period_is_requeued,
    a05_a_second_signal_requeues_at_once,
    a18_idle_followers_do_not_delay_shutdown,
);

/// How long a shutdown may take beyond its grace period: less than half of the time that the jobs below or a longer grace period
/// would take.
const ENDING: Duration = Duration::from_secs(60);

async fn a05_a_job_that_finishes_within_the_grace_period_succeeds(backend: Backend) {
    let site = Site::open(backend);
    let mut node = site.serve(&["--shutdown-grace-ms", "120000"]);
    let client = site.client(&node);
    let id = client.submit(steps(60, 25)).await;
    let waiting = client.submit(steps(1, 1)).await;
    client.until_traced(&id, 5, SOON).await;
    node.terminate();
    let (status, took) = node.ended().await;
    assert!(status.success(), "{status}");
    assert!(took < ENDING, "it waits for the job, not for the whole grace period: {took:?}");
    let later = site.serve(&["--workers", "0"]);
    let client = site.client(&later);
    let job = client.job(&id).await;
    assert_eq!((&job["state"], &job["attempt"]), (&json!("succeeded"), &json!(1)));
    assert_eq!(client.job(&waiting).await["state"], "queued", "it claims no further job");
}

async fn a05_a_job_that_outlasts_the_grace_period_is_requeued(backend: Backend) {
    ends_and_requeues(backend, "1000", 1, Duration::from_secs(1)).await;
}

async fn a05_a_second_signal_requeues_at_once(backend: Backend) {
    ends_and_requeues(backend, "150000", 2, Duration::ZERO).await;
}

async fn ends_and_requeues(backend: Backend, grace_ms: &str, n_signals: u32, at_least: Duration) {
    let site = Site::open(backend);
    let mut node = site.serve(&["--shutdown-grace-ms", grace_ms]);
    let client = site.client(&node);
    let id = client.submit(steps(6_000, 25)).await;
    client.until_traced(&id, 5, SOON).await;
    for _ in 0..n_signals {
        node.terminate();
        // Signals in quick succession are merged into one.
        tokio::time::sleep(Duration::from_millis(300)).await;
    }
    let (status, took) = node.ended().await;
    assert!(status.success(), "{status}");
    assert!(took + Duration::from_millis(500) > at_least, "{took:?}");
    assert!(took < at_least + ENDING, "{took:?}");
    let later = site.serve(&["--workers", "0"]);
    let job = site.client(&later).job(&id).await;
    assert_eq!(
        (&job["state"], &job["attempt"]),
        (&json!("queued"), &json!(0)),
        "a shutdown does not count as an attempt"
    );
}

async fn a18_idle_followers_do_not_delay_shutdown(backend: Backend) {
    let site = Site::open(backend);
    let mut node = site.serve(&["--workers", "0", "--shutdown-grace-ms", "1000"]);
    let client = site.client(&node);
    let id = client.submit(steps(1, 1)).await;
    let mut followers = tokio::task::JoinSet::new();
    for _ in 0..50 {
        let response = client.get(&format!("/v1/jobs/{id}/events")).await.unwrap();
        assert_eq!(response.status(), 200);
        assert!(response.headers()["content-type"].to_str().unwrap().starts_with("text/event-stream"));
        // The stream must end.
        followers.spawn(response.text());
    }
    tokio::time::sleep(Duration::from_secs(1)).await;
    assert_eq!(followers.len(), 50);
    assert!(followers.try_join_next().is_none(), "nothing ends a follower of a waiting job");
    node.terminate();
    let (status, took) = node.ended().await;
    assert!(status.success(), "{status}");
    assert!(took < Duration::from_secs(1) + ENDING, "{took:?}");
    for followed in followers.join_all().await {
        assert!(followed.is_ok(), "a stream is ended, not cut: {followed:?}");
    }
}
