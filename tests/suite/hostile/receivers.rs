//! Receivers of webhooks that do not answer, and their effect on other receivers.

use crate::faults::on_both;
use crate::faults::site::{Backend, Site};
use crate::jobs_support::{TestService, form};
use crate::patience::PATIENCE;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::routing::post;
use serde_json::{Value, json};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// The time limit of an attempt to deliver.
const ATTEMPT: Duration = Duration::from_secs(15);

/// A receiver that accepts everything and records the times.
#[derive(Clone, Default)]
struct Receiver(Arc<Mutex<Vec<(Instant, HeaderMap, String)>>>);

impl Receiver {
    async fn start() -> (Self, String) {
        let receiver = Receiver::default();
        let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
        let url = format!("http://{}/hook", listener.local_addr().unwrap());
        let receive = async |State(receiver): State<Receiver>, headers: HeaderMap, body: String| {
            receiver.0.lock().unwrap().push((Instant::now(), headers, body));
        };
        let router = axum::Router::new().route("/hook", post(receive)).with_state(receiver.clone());
        tokio::spawn(async move { axum::serve(listener, router).await });
        (receiver, url)
    }

    async fn until(&self, n: usize, patience: Duration) -> Duration {
        let began = Instant::now();
        while self.0.lock().unwrap().len() < n {
            assert!(began.elapsed() < patience, "{} of {n} after {patience:?}", self.0.lock().unwrap().len());
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
        began.elapsed()
    }
}

/// An address that accepts connections and never answers.
async fn hanging() -> String {
    let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
    let url = format!("http://{}/hook", listener.local_addr().unwrap());
    tokio::spawn(async move {
        let mut held = Vec::new();
        while let Ok((stream, _)) = listener.accept().await {
            held.push(stream);
        }
    });
    url
}

async fn key(site: &Site, tenant: &str) -> String {
    let mut command = crate::cli::homolog();
    command.args(["keys", "create", "--tenant", tenant, "--scope", "read,submit,admin"]).envs(site.environment());
    let output = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().trim().to_owned()
}

on_both!(a_dead_receiver_delays_only_its_own_deliveries);

async fn a_dead_receiver_delays_only_its_own_deliveries(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--auth", "keys", "--workers", "0", "--allow-private-webhooks"]);
    let client = site.client(&node);
    let (dead, alive) = (key(&site, "dead").await, key(&site, "alive").await);
    let create = async |key: &str, url: String| {
        let request =
            client.http.post(format!("{}/v1/webhooks", node.base)).bearer_auth(key).json(&json!({"url": url}));
        assert_eq!(request.send().await.unwrap().status(), 201);
    };
    let submit = async |key: &str, seed: u64| {
        let request = client.http.post(format!("{}/v1/jobs", node.base)).bearer_auth(key);
        let answer = request.multipart(form("a", "b", &json!({"seed": seed}))).send().await.unwrap();
        assert_eq!(answer.status(), 202);
    };
    for _ in 0..19 {
        create(&dead, hanging().await).await;
    }
    let (receiver, url) = Receiver::start().await;
    create(&alive, url).await;
    for seed in 0..5 {
        submit(&dead, seed).await;
    }
    // Receivers that hang occupy all of the tenant's share.
    tokio::time::sleep(Duration::from_secs(3)).await;
    for seed in 0..3 {
        submit(&alive, seed).await;
    }
    let waited = receiver.until(3, PATIENCE).await;
    assert!(waited < ATTEMPT, "they waited for an attempt of the others: {waited:?}");
}

#[tokio::test]
async fn a_receiver_that_fails_is_left_alone_and_its_deliveries_keep_their_attempts() {
    let service =
        TestService::start(&["--workers", "0", "--allow-private-webhooks", "--webhook-pause-ms", "100"]).await;
    // Nobody listens on this port any more.
    let closed = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
    let create = service.client.post(format!("{}/v1/webhooks", service.base));
    let created = create.json(&json!({"url": format!("http://{closed}/hook")})).send().await.unwrap();
    let id = created.json::<Value>().await.unwrap()["id"].as_str().unwrap().to_owned();
    for seed in 0..30 {
        service.submit(json!({"seed": seed})).await;
    }
    tokio::time::sleep(Duration::from_secs(4)).await;
    let log = service.json(&format!("/v1/webhooks/{id}/deliveries?page_size=100")).await;
    let attempts: u64 = log["deliveries"].as_array().unwrap().iter().map(|d| d["attempts"].as_u64().unwrap()).sum();
    // A turn of 8, then single attempts with pauses of 0.1, 0.3, 0.9 and 2.7 s; without the circuit breaker there would
    // be over 60.
    assert!((3..=20).contains(&attempts), "{attempts}");
    service.end().await;
}

#[tokio::test]
async fn the_trace_context_of_a_submission_is_sent_on() {
    let service = TestService::start(&["--workers", "0", "--allow-private-webhooks"]).await;
    let (receiver, url) = Receiver::start().await;
    let create = service.client.post(format!("{}/v1/webhooks", service.base)).json(&json!({"url": url}));
    assert_eq!(create.send().await.unwrap().status(), 201);
    let context = "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01";
    let submit = service.client.post(format!("{}/v1/jobs", service.base)).header("traceparent", context);
    submit.multipart(form("a", "b", &json!({}))).send().await.unwrap();
    receiver.until(1, PATIENCE).await;
    assert_eq!(receiver.0.lock().unwrap()[0].1["traceparent"], context);
    service.end().await;
}
