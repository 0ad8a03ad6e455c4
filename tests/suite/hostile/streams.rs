//! Clients that hold many connections open.

use crate::jobs_support::{TestService, form, problem};
use crate::keys::keys;
use crate::patience::PATIENCE;
use serde_json::{Value, json};
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
        assert!(began.elapsed() < PATIENCE, "the place of a closed stream is not free again");
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
        // Each client has its own connection; the first one keeps the connection of the submission.
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

/// The rest of a stream until it ends; `None` if it does not end within three seconds.
async fn rest_of(mut stream: reqwest::Response) -> Option<String> {
    let mut text = String::new();
    let read = async {
        while let Ok(Some(part)) = stream.chunk().await {
            text.push_str(&String::from_utf8_lossy(&part));
        }
    };
    tokio::time::timeout(Duration::from_secs(3), read).await.ok().map(|()| text)
}

#[tokio::test]
async fn who_has_lost_the_right_to_listen_hears_no_more() {
    let arguments = ["--auth", "keys", "--workers", "0", "--access-interval-ms", "300"];
    let service = TestService::start(&arguments).await;
    let make = |role: &str| keys(service.folder.path(), &["create", "--tenant", "clinic", "--role", role]);
    let (owner, reader) = (make("admin"), make("reader"));
    let get = async |path: String, key: &str| {
        service.client.get(format!("{}{path}", service.base)).bearer_auth(key).send().await.unwrap()
    };
    let submit = service.client.post(format!("{}/v1/jobs", service.base)).bearer_auth(&owner);
    let job: Value = submit.multipart(form("a", "b", &json!({}))).send().await.unwrap().json().await.unwrap();
    let job = format!("/v1/jobs/{}", job["id"].as_str().unwrap());
    let ticket = service.client.post(format!("{}/v1/tickets", service.base)).bearer_auth(&reader);
    let ticket: Value = ticket.json(&json!({"path": "/v1/events"})).send().await.unwrap().json().await.unwrap();
    let of_ticket = format!("/v1/events?ticket={}", ticket["ticket"].as_str().unwrap());

    let mut lost = Vec::new();
    for (path, key) in
        [(format!("{job}/events"), Some(&reader)), ("/v1/events".to_owned(), Some(&reader)), (of_ticket, None)]
    {
        let request = service.client.get(format!("{}{path}", service.base));
        let sent = match key {
            Some(key) => request.bearer_auth(key).send().await.unwrap(),
            None => request.send().await.unwrap(),
        };
        assert_eq!(sent.status(), 200, "{path}");
        lost.push(sent);
    }
    for stream in &mut lost {
        assert!(stream.chunk().await.unwrap().is_some(), "it begins");
    }
    let mut kept = get("/v1/events".to_owned(), &owner).await;
    assert!(kept.chunk().await.unwrap().is_some());
    let newest: Value = get("/v1/changes?limit=5000".to_owned(), &reader).await.json().await.unwrap();
    let since = format!("/v1/changes?since={}&wait=20", newest["next_since"]);
    let polls = async { tokio::join!(get(format!("{job}?wait=20"), &reader), get(since, &reader)) };
    let revoked = async {
        tokio::time::sleep(Duration::from_millis(500)).await;
        keys(service.folder.path(), &["revoke", reader.split('_').nth(1).unwrap()]);
        let cancelled = service.client.post(format!("{}{job}/cancel", service.base)).bearer_auth(&owner);
        assert!(cancelled.send().await.unwrap().status().is_success());
    };
    let ((of_job, of_changes), ()) = tokio::join!(polls, revoked);
    problem(of_job, 401, "unauthenticated").await;
    problem(of_changes, 401, "unauthenticated").await;
    for stream in lost {
        let rest = rest_of(stream).await.expect("the stream goes on");
        assert!(!rest.contains("cancelled") && !rest.contains("change"), "{rest}");
    }
    let heard = tokio::time::timeout(Duration::from_secs(3), kept.chunk()).await;
    assert!(heard.unwrap().unwrap().is_some_and(|part| String::from_utf8_lossy(&part).contains("cancelled")));
    assert_eq!(rest_of(kept).await, None, "with a valid key it goes on");
    service.end().await;
}
