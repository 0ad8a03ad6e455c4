//! A19: no route reveals anything about another tenant's resources.

use super::client::{Client, id_of, steps};
use super::on_both;
use super::site::{Backend, SOON, Site};
use serde_json::{Value, json};
use std::process::Command;
use std::time::{Duration, Instant};
use tokio::time::timeout;

on_both!(a19_resources_of_another_tenant_are_not_found);

/// How often each answer is timed.
const N_TIMED: usize = 41;
/// Allowed difference between medians of equal requests on a busy machine, in addition to half of the medians.
const NOISE: Duration = Duration::from_millis(4);

/// A new key of this tenant, with all scopes.
fn key(site: &Site, tenant: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homolog"));
    command.args(["keys", "create", "--tenant", tenant, "--scope", "submit", "--scope", "read", "--scope", "admin"]);
    let done = command.envs(site.environment()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap().split_whitespace().last().unwrap().to_owned()
}

fn client_with(base: &str, key: &str) -> Client {
    let mut headers = reqwest::header::HeaderMap::new();
    headers.insert("authorization", format!("Bearer {key}").parse().unwrap());
    let http = reqwest::Client::builder().default_headers(headers).no_proxy().build().unwrap();
    Client { base: base.to_owned(), http }
}

async fn a19_resources_of_another_tenant_are_not_found(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--auth", "keys"]);
    let openapi = site.client(&node).json("/openapi.json").await;
    let owner = client_with(&node.base, &key(&site, "owner"));
    let other = client_with(&node.base, &key(&site, "other"));
    let job = owner.submit(steps(3, 1)).await;
    owner.until_succeeded(&job, SOON).await;
    let mesh = owner.http.post(format!("{}/v1/meshes", node.base)).body("ply mesh of the owner");
    let mesh: Value = mesh.send().await.unwrap().json().await.unwrap();
    let mesh = id_of(&mesh);
    let post = async |path: &str, body: Value| {
        let sent = owner.http.post(format!("{}{path}", node.base)).json(&body).send().await.unwrap();
        assert!(sent.status().is_success(), "{path}: {}", sent.status());
        id_of(&sent.json().await.unwrap())
    };
    let batch =
        post("/v1/batches", json!({"pairs": [{"source": {"mesh_id": mesh}, "target": {"mesh_id": mesh}}]})).await;
    let webhook = post("/v1/webhooks", json!({"url": "https://example.org/", "states": ["dead"]})).await;
    let key_id = post("/v1/keys", json!({"role": "reader"})).await;
    // The other tenant has a job too, so that its lists are not empty.
    let own = other.submit(steps(1, 1)).await;
    other.until_succeeded(&own, SOON).await;

    let mut n_asked = 0;
    for (path, operations) in openapi["paths"].as_object().unwrap() {
        if !path.starts_with("/v1/") {
            continue;
        }
        let (held, absent) = if path.starts_with("/v1/meshes") {
            (mesh.clone(), format!("blake3:{}", "0".repeat(64)))
        } else if path.starts_with("/v1/batches") {
            (batch.clone(), uuid::Uuid::now_v7().to_string())
        } else if path.starts_with("/v1/keys") {
            (key_id.clone(), "0".repeat(12))
        } else if path.starts_with("/v1/webhooks") {
            (webhook.clone(), uuid::Uuid::now_v7().to_string())
        } else {
            (job.clone(), uuid::Uuid::now_v7().to_string())
        };
        let described = operations.as_object().unwrap().keys().map(String::as_str);
        let described: Vec<&str> =
            described.filter(|m| ["get", "post", "patch", "put", "delete"].contains(m)).collect();
        let head = described.contains(&"get").then_some("head");
        for method in described.into_iter().chain(head) {
            let ask = async |id: &str| {
                let named = path.replace("{id}", id).replace("{hash}", id).replace("{name}", "transform.json");
                let named = if path == "/v1/events" { format!("{named}?since=0") } else { named };
                let url = format!("{}{named}", node.base);
                let mut request = other.http.request(method.to_uppercase().parse().unwrap(), url);
                if method == "patch" {
                    let has_priority = path.starts_with("/v1/jobs") || path.starts_with("/v1/studies");
                    let change = if has_priority { json!({"priority": 1}) } else { json!({"states": ["dead"]}) };
                    request = request.json(&change);
                }
                if method == "put" {
                    request = request.json(&json!({"decision": "kept"}));
                }
                let mut response = request.send().await.unwrap();
                let status = response.status().as_u16();
                let text = if path == "/v1/events" && method == "get" {
                    // A stream without an end: reads what arrives within a second after the first change.
                    let mut said = Vec::new();
                    while let Ok(Ok(Some(piece))) = timeout(Duration::from_secs(1), response.chunk()).await {
                        said.extend(piece);
                    }
                    String::from_utf8(said).unwrap()
                } else {
                    response.text().await.unwrap_or_default()
                };
                let mut body: Value = serde_json::from_str(&text).unwrap_or(Value::String(text));
                if let Some(members) = body.as_object_mut() {
                    members.remove("request_id");
                }
                (status, body)
            };
            let (status, body) = ask(&held).await;
            if path.contains('{') {
                assert!(status >= 400, "{method} {path}: {status}");
                let nothing = ask(&absent).await;
                assert_eq!((status, &body), (nothing.0, &nothing.1), "{method} {path} tells what is there");
                if method != "post" {
                    assert_eq!(status, 404, "{method} {path}");
                }
                if method == "get" {
                    // Alternating, so that other work of the machine affects both equally.
                    let mut times = [Vec::new(), Vec::new()];
                    for _ in 0..N_TIMED {
                        for (times, id) in times.iter_mut().zip([&held, &absent]) {
                            let began = Instant::now();
                            ask(id).await;
                            times.push(began.elapsed());
                        }
                    }
                    let [of_held, of_absent] = times.map(|mut times| {
                        times.sort();
                        times[N_TIMED / 2]
                    });
                    let (less, more) = (of_held.min(of_absent), of_held.max(of_absent));
                    assert!(more < less * 3 / 2 + NOISE, "{path}: {of_held:?} if it is there, else {of_absent:?}");
                }
            }
            let text = body.to_string();
            let reveals = [&job, &mesh, &batch, &webhook, &key_id].into_iter().any(|id| text.contains(id.as_str()));
            assert!(!reveals, "{method} {path} reveals a resource of another tenant: {text}");
            n_asked += 1;
        }
    }
    assert!(n_asked > 15, "{n_asked} routes");
    // Content addresses reveal nothing either: uploading the same bytes creates a new mesh of the other tenant.
    let again = other.http.post(format!("{}/v1/meshes", node.base)).body("ply mesh of the owner").send().await.unwrap();
    assert_eq!(again.status(), 201, "the answer does not reveal that another tenant has these bytes");
    assert_eq!(owner.job(&job).await["state"], "succeeded");
}
