//! Webhooks, with receivers on loopback that record their requests.

use super::jobs_support::{TestService, problem};
use crate::patience::PATIENCE;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::routing::post;
use bytes::Bytes;
use homolog::jobs::JobState;
use serde_json::{Value, json};
use std::io::BufRead as _;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

const SETTINGS: [&str; 3] = ["--allow-private-webhooks", "--webhook-pause-ms", "50"];

/// A receiver that answers with given statuses and records requests.
#[derive(Clone, Default)]
struct Receiver {
    answers: Arc<Mutex<Vec<u16>>>,
    received: Arc<Mutex<Vec<(HeaderMap, String)>>>,
}

impl Receiver {
    async fn start(answers: &[u16]) -> (Self, String) {
        let receiver = Receiver { answers: Arc::new(Mutex::new(answers.to_vec())), ..Receiver::default() };
        let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
        let url = format!("http://{}/hook", listener.local_addr().unwrap());
        let router = axum::Router::new().route("/hook", post(receive)).with_state(receiver.clone());
        tokio::spawn(async move { axum::serve(listener, router).await });
        (receiver, url)
    }

    fn received(&self) -> Vec<(HeaderMap, String)> {
        self.received.lock().unwrap().clone()
    }

    async fn until(&self, n: usize) -> Vec<(HeaderMap, String)> {
        let began = Instant::now();
        while self.received().len() < n {
            assert!(began.elapsed() < PATIENCE, "{} of {n}", self.received().len());
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
        self.received()
    }
}

async fn receive(State(receiver): State<Receiver>, headers: HeaderMap, body: Bytes) -> StatusCode {
    receiver.received.lock().unwrap().push((headers, String::from_utf8(body.to_vec()).unwrap()));
    let mut answers = receiver.answers.lock().unwrap();
    let status = if answers.is_empty() { 204 } else { answers.remove(0) };
    StatusCode::from_u16(status).unwrap()
}

async fn create(service: &TestService, body: &Value) -> reqwest::Response {
    service.client.post(format!("{}/v1/webhooks", service.base)).json(body).send().await.unwrap()
}

async fn made(service: &TestService, body: &Value) -> Value {
    let response = create(service, body).await;
    assert_eq!(response.status(), 201);
    response.json().await.unwrap()
}

/// The delivery log of a webhook once `done` holds.
async fn log(service: &TestService, id: &str, done: impl Fn(&[Value]) -> bool) -> Vec<Value> {
    let began = Instant::now();
    loop {
        let page = service.json(&format!("/v1/webhooks/{id}/deliveries")).await;
        let entries = page["deliveries"].as_array().unwrap().clone();
        if done(&entries) {
            return entries;
        }
        assert!(began.elapsed() < PATIENCE, "{entries:?}");
        tokio::time::sleep(Duration::from_millis(30)).await;
    }
}

#[tokio::test]
async fn deliveries_are_signed_and_retried_until_accepted() {
    let service = TestService::start(&SETTINGS).await;
    let (receiver, url) = Receiver::start(&[500, 302]).await;
    let webhook = made(&service, &json!({"url": url, "states": ["succeeded", "failed"]})).await;
    let (id, secret) = (webhook["id"].as_str().unwrap(), webhook["secret"].as_str().unwrap());
    assert!(service.json(&format!("/v1/webhooks/{id}")).await.get("secret").is_none(), "shown once");
    let job = service.submit(json!({})).await;
    service.until_final(&job).await;
    let received = receiver.until(3).await;
    let verifier = standardwebhooks::Webhook::new(secret).unwrap();
    for (headers, body) in &received {
        verifier.verify(body.as_bytes(), headers).unwrap();
        assert_eq!(headers["webhook-id"], received[0].0["webhook-id"], "the same at every attempt");
        assert!(verifier.verify(body.replace("succeeded", "failed").as_bytes(), headers).is_err());
    }
    let event: Value = serde_json::from_str(&received[0].1).unwrap();
    assert_eq!((&event["type"], &event["data"]["job_id"]), (&json!("job.succeeded"), &json!(job)));
    let entries = log(&service, id, |log| log.iter().any(|entry| entry["state"] == "delivered")).await;
    assert_eq!(entries.len(), 1, "only the states that were asked for");
    assert_eq!((&entries[0]["attempts"], &entries[0]["status"]), (&json!(3), &json!(204)));
    tokio::time::sleep(Duration::from_millis(700)).await;
    assert_eq!(receiver.received().len(), 3, "no more once it was taken, and the redirect was not followed");
    service.end().await;
}

#[tokio::test]
async fn a_receiver_that_answers_410_disables_its_webhook() {
    let service = TestService::start(&SETTINGS).await;
    let (receiver, url) = Receiver::start(&[410]).await;
    let webhook = made(&service, &json!({"url": url})).await;
    let id = webhook["id"].as_str().unwrap();
    let path = format!("/v1/webhooks/{id}");
    let tested = service.post(&format!("{path}/test")).await;
    assert_eq!(tested.status(), 202);
    receiver.until(1).await;
    log(&service, id, |log| log.iter().any(|entry| entry["state"] == "failed")).await;
    let ended = service.json(&path).await;
    assert_eq!(
        (&ended["enabled"], &ended["disabled_because"]),
        (&json!(false), &json!("the receiver answered 410 Gone"))
    );
    service.until_final(&service.submit(json!({})).await).await;
    tokio::time::sleep(Duration::from_millis(1200)).await;
    assert_eq!(receiver.received().len(), 1);
    let change = service.client.patch(format!("{}{path}", service.base)).json(&json!({"enabled": true}));
    let again: Value = change.send().await.unwrap().json().await.unwrap();
    assert_eq!((&again["enabled"], again.get("disabled_because")), (&json!(true), None));
    service.post(&format!("{path}/test")).await;
    receiver.until(2).await;
    assert_eq!(service.delete(&path).await.status(), 204);
    problem(service.get(&path).await, 404, "webhook-not-found").await;
    service.end().await;
}

#[tokio::test]
async fn private_addresses_are_refused_unless_allowed() {
    let service = TestService::start(&[]).await;
    for url in ["http://127.0.0.1:1/", "http://169.254.169.254/latest", "http://[::1]/", "http://localhost/", "x"] {
        let refused = problem(create(&service, &json!({"url": url})).await, 422, "invalid-request").await;
        assert_eq!(refused["errors"][0]["pointer"], "/url", "{url}");
        let said = refused["errors"][0]["detail"].as_str().unwrap();
        assert_eq!(said.contains("--allow-private-webhooks"), url != "x", "{url}: {said}");
    }
    problem(create(&service, &json!({"url": "https://example.org/", "x": 1})).await, 422, "invalid-request").await;
    problem(
        create(&service, &json!({"url": "https://example.org/", "states": ["lost"]})).await,
        422,
        "invalid-request",
    )
    .await;
    service.end().await;

    // Private addresses were allowed when the webhook was created, but are not any more: the address is checked at
    // every delivery.
    let service = TestService::start(&SETTINGS).await;
    let (receiver, url) = Receiver::start(&[]).await;
    let webhook = made(&service, &json!({"url": url})).await;
    let id = webhook["id"].as_str().unwrap().to_owned();
    let folder = service.end().await;
    let service = TestService::start_in(folder, &["--webhook-pause-ms", "50"]).await;
    service.post(&format!("/v1/webhooks/{id}/test")).await;
    let entries = log(&service, &id, |log| log.iter().any(|entry| entry["error"].is_string())).await;
    let said = entries[0]["error"].as_str().unwrap();
    assert!(said.starts_with("a public address is needed here") && said.contains("--allow-private-webhooks"), "{said}");
    assert!(receiver.received().is_empty());
    service.end().await;
}

/// A code block of docs/webhooks.md.
fn block(language: &str) -> String {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/webhooks.md")).unwrap();
    page.split_once(&format!("```{language}\n")).unwrap().1.split_once("```").unwrap().0.to_owned()
}

/// A running receiver of the documentation; it is killed when dropped.
struct Documented(Child);

impl Drop for Documented {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Runs a receiver against a service: it prints each signed event once, and refuses everything else.
async fn check_receiver(mut receiver: Command) {
    let service = TestService::start(&SETTINGS).await;
    let free = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let url = format!("http://127.0.0.1:{free}/");
    let webhook = made(&service, &json!({"url": url, "states": ["succeeded"]})).await;
    let (id, secret) = (webhook["id"].as_str().unwrap(), webhook["secret"].as_str().unwrap());
    receiver.env("WEBHOOK_SECRET", secret).env("PORT", free.to_string());
    let mut child = Documented(receiver.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap());
    let lines = std::io::BufReader::new(child.0.stdout.take().unwrap());
    let job = service.submit(json!({})).await;
    service.until_final(&job).await;
    let read = tokio::task::spawn_blocking(move || {
        let mut lines = lines.lines().map(Result::unwrap);
        (lines.next().unwrap(), lines)
    });
    let (first, lines) = read.await.unwrap();
    assert_eq!(first, format!("job.succeeded {job}"));
    log(&service, id, |log| log.iter().any(|entry| entry["state"] == "delivered")).await;

    // The same delivery is accepted again but not handled again; a forged delivery and an old one are refused.
    let signer = standardwebhooks::Webhook::new(secret).unwrap();
    let now = jiff::Timestamp::now().as_second();
    let sent = async |id: &str, at: i64, signed: &str, body: &str| {
        let signature = signer.sign(id, at, signed.as_bytes()).unwrap();
        let request = service.client.post(&url).header("webhook-id", id).header("webhook-timestamp", at.to_string());
        request.header("webhook-signature", format!("v1,AAAA {signature}")).body(body.to_owned()).send().await.unwrap()
    };
    let event = |name: &str| json!({"type": name, "timestamp": "", "data": {"job_id": "j"}}).to_string();
    let (own, other) = (event("job.succeeded"), event("job.failed"));
    assert_eq!(sent("a", now, &own, &own).await.status(), 204);
    assert_eq!(sent("a", now, &own, &own).await.status(), 204);
    assert_eq!(sent("b", now, &own, &other).await.status(), 401, "another body");
    assert_eq!(sent("c", now - 3600, &own, &own).await.status(), 401, "an old one");
    assert_eq!(service.client.post(&url).body("x").send().await.unwrap().status(), 401);
    assert_eq!(sent("d", now, &other, &other).await.status(), 204);
    let read = tokio::task::spawn_blocking(move || lines.take(2).collect::<Vec<_>>());
    assert_eq!(read.await.unwrap(), ["job.succeeded j", "job.failed j"]);
    service.end().await;
}

#[tokio::test]
async fn the_receiver_in_python_of_the_documentation_verifies_deliveries() {
    let mut receiver = Command::new("python3");
    receiver.arg("-c").arg(block("python"));
    check_receiver(receiver).await;
}

#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn the_receiver_in_typescript_of_the_documentation_compiles_and_verifies_deliveries() {
    let folder = tempfile::tempdir().unwrap();
    let packages = concat!(env!("CARGO_MANIFEST_DIR"), "/target/clients-npm/node_modules");
    std::os::unix::fs::symlink(packages, folder.path().join("node_modules")).unwrap();
    std::fs::write(folder.path().join("package.json"), r#"{"type": "module"}"#).unwrap();
    std::fs::write(folder.path().join("receiver.ts"), block("ts")).unwrap();
    let mut compile = Command::new("node");
    compile.current_dir(folder.path()).arg("node_modules/typescript/bin/tsc");
    let options = ["--strict", "--target", "es2022", "--module", "nodenext", "--types", "node", "receiver.ts"];
    let done = compile.args(options).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stdout));
    let mut receiver = Command::new("node");
    receiver.current_dir(folder.path()).arg("receiver.js");
    check_receiver(receiver).await;
}

#[test]
fn the_documentation_lists_every_event() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/webhooks.md")).unwrap();
    let listed: Vec<&str> =
        page.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` |")).map(|(name, _)| name).collect();
    let states = JobState::ALL.into_iter().map(|state| format!("job.{}", state.name()));
    for event in states.chain(["webhook.test".to_owned()]) {
        assert!(listed.contains(&event.as_str()), "{event}");
    }
}
