//! Clients that hold many connections open.

use crate::jobs_support::{TestService, problem};
use serde_json::json;
use std::time::Duration;

#[tokio::test]
async fn event_streams_and_long_polls_of_a_client_are_limited() {
    let service = TestService::start(&["--workers", "0", "--max-streams", "3"]).await;
    let id = service.submit(json!({})).await;
    let events = format!("{}/v1/jobs/{id}/events", service.base);
    let mut streams = Vec::new();
    for _ in 0..3 {
        let stream = service.client.get(&events).send().await.unwrap();
        assert_eq!(stream.status(), 200);
        streams.push(stream);
    }
    problem(service.client.get(&events).send().await.unwrap(), 429, "too-many-streams").await;
    for path in [format!("/v1/jobs/{id}?wait=5"), "/v1/changes?since=100&wait=5".to_owned()] {
        problem(service.get(&path).await, 429, "too-many-streams").await;
    }
    assert_eq!(service.get(&format!("/v1/jobs/{id}")).await.status(), 200, "what holds no connection is answered");
    drop(streams.pop());
    // The service notices a closed connection at its next write.
    let began = std::time::Instant::now();
    while service.client.get(&events).send().await.unwrap().status() != 200 {
        assert!(began.elapsed() < Duration::from_secs(25), "the place of a closed stream is not free again");
        tokio::time::sleep(Duration::from_millis(200)).await;
    }
    service.end().await;
}

#[tokio::test]
async fn probes_are_answered_while_clients_hold_all_connections() {
    let arguments = ["--workers", "0", "--max-connections", "4", "--probe-listen", "127.0.0.1:0"];
    let service = TestService::start(&arguments).await;
    let id = service.submit(json!({})).await;
    let mut streams = Vec::new();
    for _ in 0..4 {
        // Each client has a connection of its own; the first keeps that of the submission.
        let client = if streams.is_empty() { service.client.clone() } else { reqwest::Client::new() };
        streams.push(client.get(format!("{}/v1/jobs/{id}/events", service.base)).send().await.unwrap());
    }
    let refused = reqwest::Client::new().get(format!("{}/healthz", service.base)).timeout(Duration::from_millis(500));
    assert!(refused.send().await.is_err(), "all connections are taken");
    for path in ["/healthz", "/readyz", "/metrics"] {
        let probe = reqwest::Client::new().get(format!("{}{path}", service.probes)).timeout(Duration::from_secs(5));
        assert_eq!(probe.send().await.unwrap().status(), 200, "{path}");
    }
    let other = reqwest::get(format!("{}/v1/jobs", service.probes)).await.unwrap();
    assert_eq!(other.status(), 404, "nothing else is served there");
    drop(streams);
    service.end().await;
}
