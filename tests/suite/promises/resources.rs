//! Promises on documents, lists, uploads, batches, webhooks and the feed of changes.

use super::{SOON, Served, array, steps, text};
use crate::faults::on_both;
use crate::faults::site::Backend;
use crate::jobs_support::{form, problem};
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::routing::post;
use reqwest::Method;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

on_both!(
    documents_follow_the_conventions,
    every_list_is_paged,
    jobs_are_filtered_and_ordered,
    an_upload_is_held_once_and_kept_while_it_is_used,
    a_batch_is_created_and_cancelled_as_a_whole,
    webhooks_are_signed_repeated_and_disabled_and_changes_are_in_order,
);

/// The members that a job has at some time of its life.
const MEMBERS: &str = "id state method method_version source target seed priority tags labels external_ref attempt max_attempts \
                       progress eta_ms queue_position energy_latest created_at started_at finished_at expires_at deadline_at \
                       cancel_requested cached error links";

/// Checks names and times, at any depth. Names chosen by a client are skipped.
fn check_names(value: &Value, place: &str) {
    match value {
        Value::Object(members) => {
            for (name, value) in members {
                let is_snake = name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_');
                assert!(is_snake, "{place}/{name}");
                if name.ends_with("_at") {
                    let time = value.as_str().unwrap();
                    assert!(time.ends_with('Z') && time.parse::<jiff::Timestamp>().is_ok(), "{place}/{name}: {time}");
                }
                if name != "labels" && name != "tags" {
                    check_names(value, &format!("{place}/{name}"));
                }
            }
        }
        Value::Array(items) => items.iter().for_each(|item| check_names(item, place)),
        _ => {}
    }
}

async fn documents_follow_the_conventions(backend: Backend) {
    let served = Served::start(backend, &["--workers", "1"]);
    let long =
        form("a", "b", &steps(400, 20)).text("external_ref", "case-1").text("deadline_at", "2099-01-01T00:00:00Z");
    let long = served.client.http.post(served.url("/v1/jobs")).multipart(long).send().await.unwrap();
    let long = text(&served.expect(long, 202).await, "id").to_owned();
    let queued = served.client.submit(json!({"fail": 1})).await;
    let mut members = BTreeSet::new();
    let mut look = |job: &Value| {
        check_names(job, "job");
        members.extend(job.as_object().unwrap().keys().cloned());
    };
    look(&served.client.until_traced(&long, 3, SOON).await);
    let began = Instant::now();
    // An estimate needs some progress.
    loop {
        let job = served.client.job(&long).await;
        look(&job);
        if job["eta_ms"].is_u64() {
            let progress = job["progress"].as_object().unwrap();
            for member in ["fraction", "phase", "iteration", "message"] {
                assert!(progress.contains_key(member), "{member}: {job}");
            }
            break;
        }
        assert!(began.elapsed() < SOON, "no estimate: {job}");
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
    look(&served.client.job(&queued).await);
    served.client.post(&format!("/v1/jobs/{long}/cancel")).await.unwrap();
    look(&served.client.until_final(&queued, SOON).await);
    let done = served.client.submit(steps(1, 1)).await;
    look(&served.client.until_succeeded(&done, SOON).await);
    for member in MEMBERS.split_whitespace() {
        assert!(members.contains(member), "no {member} in {members:?}");
    }
    assert_eq!(uuid::Uuid::parse_str(&done).unwrap().get_version_num(), 7);

    // ETags
    let mesh = served.upload("a mesh").await;
    for path in [
        format!("/v1/jobs/{done}"),
        format!("/v1/jobs/{done}/result"),
        format!("/v1/meshes/{mesh}"),
        format!("/v1/meshes/{mesh}/content"),
    ] {
        let first = served.get(&path).await;
        let etag = first.headers()["etag"].to_str().unwrap().to_owned();
        let second = served.send(Method::GET, &path, &[("if-none-match", &etag)], None).await;
        assert_eq!(second.status(), 304, "{path}");
        assert_eq!(second.headers()["etag"], etag, "{path}");
        let other = served.send(Method::GET, &path, &[("if-none-match", "\"other\"")], None).await;
        assert_eq!(other.status(), 200, "{path}");
    }
    // Ids of requests, and problems
    let echoed = served.send(Method::GET, "/v1/jobs", &[("x-request-id", "mine-1")], None).await;
    assert_eq!(echoed.headers()["x-request-id"], "mine-1");
    problem(served.get("/v1/nothing").await, 404, "route-not-found").await;
    problem(served.send(Method::PUT, "/v1/jobs", &[], None).await, 405, "method-not-allowed").await;
    problem(served.get("/v1/jobs?page_size=x").await, 400, "invalid-query").await;
    let refused =
        problem(served.post("/v1/jobs", &json!({"source": {}, "target": {}})).await, 422, "invalid-request").await;
    for error in array(&refused, "errors") {
        assert!(
            text(error, "pointer").starts_with('/')
                && !text(error, "code").is_empty()
                && !text(error, "detail").is_empty()
        );
    }
    let known = served.expect(served.get("/problems/invalid-request").await, 200).await;
    assert_eq!(known["status"], 422, "the type of a problem leads to its description");
}

/// All items of a list, read one item a page.
async fn paged(served: &Served, path: &str, member: &str) -> Vec<Value> {
    let (mut all, mut token) = (Vec::new(), String::new());
    for _ in 0..20 {
        let page = served.expect(served.get(&format!("{path}?page_size=1{token}")).await, 200).await;
        check_names(&page, path);
        assert!(array(&page, member).len() <= 1, "{path}");
        all.extend(array(&page, member).iter().cloned());
        let Some(next) = page["next_page_token"].as_str() else { return all };
        token = format!("&page_token={next}");
    }
    panic!("{path} does not end");
}

async fn every_list_is_paged(backend: Backend) {
    let served = Served::start(backend, &["--workers", "0", "--allow-private-webhooks"]);
    let mut meshes = Vec::new();
    for content in ["one", "two", "three"] {
        meshes.push(served.upload(content).await);
    }
    let closed = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
    let (mut batch, mut webhook) = (String::new(), String::new());
    for n in 0..3 {
        let pairs: Vec<_> =
            (0..3).map(|k| json!({"source": {"mesh_id": meshes[k]}, "target": {"mesh_id": meshes[n]}})).collect();
        batch = text(&served.expect(served.post("/v1/batches", &json!({"pairs": pairs})).await, 202).await, "id")
            .to_owned();
        let url = json!({"url": format!("http://{closed}/{n}"), "states": ["dead"]});
        webhook = text(&served.expect(served.post("/v1/webhooks", &url).await, 201).await, "id").to_owned();
        served.expect(served.post("/v1/keys", &json!({"role": "reader", "name": format!("key {n}")})).await, 201).await;
    }
    for _ in 0..3 {
        served.expect(served.client.post(&format!("/v1/webhooks/{webhook}/test")).await.unwrap(), 202).await;
    }
    for (path, member, n) in [
        ("/v1/jobs", "jobs", 9),
        ("/v1/meshes", "meshes", 3),
        ("/v1/batches", "batches", 3),
        (&format!("/v1/batches/{batch}/jobs"), "jobs", 3),
        ("/v1/webhooks", "webhooks", 3),
        (&format!("/v1/webhooks/{webhook}/deliveries"), "deliveries", 3),
        ("/v1/keys", "keys", 3),
        ("/v1/changes", "changes", 9),
    ] {
        let all = paged(&served, path, member).await;
        let ids: BTreeSet<_> = all
            .iter()
            .map(|item| if member == "changes" { item["seq"].to_string() } else { item["id"].to_string() })
            .collect();
        assert_eq!((all.len(), ids.len()), (n, n), "{path}: each once");
        problem(served.get(&format!("{path}?page_size=0")).await, 400, "invalid-query").await;
        problem(served.get(&format!("{path}?page_token=made-up")).await, 400, "invalid-query").await;
    }
}

async fn jobs_are_filtered_and_ordered(backend: Backend) {
    let served = Served::start(backend, &["--workers", "0"]);
    let mut ids = Vec::new();
    for n in 0..4 {
        let tags = json!({"study": format!("s{}", n % 2)}).to_string();
        let form = form("a", "b", &json!({"seed": n})).text("tags", tags).text("external_ref", format!("case-{n}"));
        let answer = served.client.http.post(served.url("/v1/jobs")).multipart(form).send().await.unwrap();
        ids.push(text(&served.expect(answer, 202).await, "id").to_owned());
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    served.client.post(&format!("/v1/jobs/{}/cancel", ids[0])).await.unwrap();
    let (one, two) = (served.upload("one").await, served.upload("two").await);
    let batch =
        served.post("/v1/batches", &json!({"pairs": [{"source": {"mesh_id": one}, "target": {"mesh_id": two}}]})).await;
    let batch = text(&served.expect(batch, 202).await, "id").to_owned();
    let found = async |query: &str| -> Vec<String> {
        let list = served.expect(served.get(&format!("/v1/jobs?{query}")).await, 200).await;
        array(&list, "jobs").iter().map(|job| text(job, "id").to_owned()).collect()
    };
    assert_eq!(found("order=asc&page_size=4").await, ids);
    let mut newest = found("order=desc").await;
    newest.remove(0);
    newest.reverse();
    assert_eq!(newest, ids);
    assert_eq!(found("state=cancelled").await, ids[..1]);
    assert_eq!(found("state=queued&state=running&order=asc").await.len(), 4);
    for parameter in ["tag", "label"] {
        assert_eq!(found(&format!("{parameter}=study:s1&order=asc")).await, [ids[1].clone(), ids[3].clone()]);
    }
    assert_eq!(found("external_ref=case-2").await, ids[2..3]);
    assert_eq!((found("method=scripted").await.len(), found("method=other").await.len()), (5, 0));
    assert_eq!(found(&format!("batch={batch}")).await.len(), 1);
    let third = text(&served.client.job(&ids[2]).await, "created_at").to_owned();
    let before = found(&format!("created_before={third}&order=asc")).await;
    let from = found(&format!("created_from={third}&order=asc")).await;
    assert_eq!((before, from.len()), (ids[..2].to_vec(), 3));
    problem(served.get("/v1/jobs?sate=queued").await, 400, "invalid-query").await;
}

async fn an_upload_is_held_once_and_kept_while_it_is_used(backend: Backend) {
    let served = Served::start(backend, &["--workers", "0"]);
    let send = async || served.client.http.post(served.url("/v1/meshes")).body("a mesh").send().await.unwrap();
    let first = send().await;
    let id = format!("blake3:{}", blake3::hash(b"a mesh").to_hex());
    assert_eq!(first.headers()["location"], format!("/v1/meshes/{id}"));
    let first = served.expect(first, 201).await;
    assert_eq!((&first["id"], &first["n_bytes"], &first["n_vertices"]), (&json!(id), &json!(6), &json!(3)));
    assert!(first["report"].is_object(), "{first}");
    assert_eq!(served.expect(send().await, 200).await["id"], id.as_str(), "held");
    let part = reqwest::multipart::Part::bytes(b"a mesh".to_vec()).file_name("b.ply");
    let form = reqwest::multipart::Form::new().part("file", part);
    let again = served.client.http.post(served.url("/v1/meshes")).multipart(form).send().await.unwrap();
    assert_eq!(served.expect(again, 200).await["id"], id.as_str());
    let path = format!("/v1/meshes/{id}");
    assert_eq!(served.get(&format!("{path}/content")).await.text().await.unwrap(), "a mesh");
    for (path, length) in [(path.clone(), None), (format!("{path}/content"), Some("6"))] {
        let head = served.send(Method::HEAD, &path, &[], None).await;
        assert_eq!(head.status(), 200, "{path}");
        assert!(length.is_none_or(|length| head.headers()["content-length"] == length), "{:?}", head.headers());
        assert!(head.bytes().await.unwrap().is_empty());
    }
    let job = json!({"source": {"mesh_id": id}, "target": {"mesh_id": id}});
    let job = text(&served.expect(served.post("/v1/jobs", &job).await, 202).await, "id").to_owned();
    problem(served.client.delete(&path).await.unwrap(), 409, "mesh-in-use").await;
    served.client.post(&format!("/v1/jobs/{job}/cancel")).await.unwrap();
    assert_eq!(served.client.delete(&format!("/v1/jobs/{job}")).await.unwrap().status(), 204);
    assert_eq!(served.client.delete(&path).await.unwrap().status(), 204);
    problem(served.get(&path).await, 404, "mesh-not-found").await;
}

async fn a_batch_is_created_and_cancelled_as_a_whole(backend: Backend) {
    let served = Served::start(backend, &["--workers", "0"]);
    let template = served.upload("template").await;
    let (one, two) = (served.upload("one").await, served.upload("two").await);
    let missing = format!("blake3:{}", "0".repeat(64));
    let wrong = json!({"pairs": [{"source": {"mesh_id": one}, "target": {"mesh_id": template}}, {"source": {"mesh_id": missing}, "target": {"mesh_id": template}}]});
    let refused = served.post("/v1/batches", &wrong).await;
    assert!([404, 422].contains(&refused.status().as_u16()), "{}", refused.status());
    assert!(served.client.list().await.is_empty(), "no part of it was created");
    let against = json!({"template": {"mesh_id": template}, "subjects": [{"input": {"mesh_id": one}}, {"input": {"mesh_id": two}}]});
    let made = served.post("/v1/batches", &against).await;
    assert!(made.headers().contains_key("location"));
    let batch = served.expect(made, 202).await;
    assert_eq!((&batch["n_jobs"], &batch["counts"]), (&json!(2), &json!({"queued": 2})));
    let path = format!("/v1/batches/{}", text(&batch, "id"));
    let jobs = served.expect(served.get(&format!("{path}/jobs")).await, 200).await;
    assert!(array(&jobs, "jobs").iter().all(|job| job["target"]["hash"] == template.as_str()));
    let cancelled = served.client.post(&format!("{path}/cancel")).await.unwrap();
    assert_eq!(served.expect(cancelled, 202).await["cancelled"], 2);
    assert_eq!(served.expect(served.get(&path).await, 200).await["counts"], json!({"cancelled": 2}));
    let pairs = json!({"pairs": [{"source": {"mesh_id": one}, "target": {"mesh_id": two}}, {"source": {"mesh_id": two}, "target": {"mesh_id": one}}]});
    assert_eq!(served.expect(served.post("/v1/batches", &pairs).await, 202).await["n_jobs"], 2);
}

type Received = Arc<Mutex<(Vec<u16>, Vec<(HeaderMap, String)>)>>;

async fn webhooks_are_signed_repeated_and_disabled_and_changes_are_in_order(backend: Backend) {
    let served = Served::start(backend, &["--allow-private-webhooks", "--webhook-pause-ms", "50"]);
    let received = Received::new(Mutex::new((vec![500, 204, 410], Vec::new())));
    let receive = async |State(received): State<Received>, headers: HeaderMap, body: String| {
        let mut received = received.lock().unwrap();
        received.1.push((headers, body));
        let status = if received.0.is_empty() { 204 } else { received.0.remove(0) };
        StatusCode::from_u16(status).unwrap()
    };
    let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
    let url = format!("http://{}/hook", listener.local_addr().unwrap());
    let router = axum::Router::new().route("/hook", post(receive)).with_state(Arc::clone(&received));
    tokio::spawn(async move { axum::serve(listener, router).await });
    let until = async |n: usize| {
        let began = Instant::now();
        while received.lock().unwrap().1.len() < n {
            assert!(began.elapsed() < SOON, "{} of {n}", received.lock().unwrap().1.len());
            tokio::time::sleep(Duration::from_millis(30)).await;
        }
    };
    let created =
        served.expect(served.post("/v1/webhooks", &json!({"url": url, "states": ["succeeded"]})).await, 201).await;
    let (path, secret) = (format!("/v1/webhooks/{}", text(&created, "id")), text(&created, "secret").to_owned());
    assert!(served.expect(served.get(&path).await, 200).await.get("secret").is_none(), "shown once");
    let context = "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01";
    let job = served.client.http.post(served.url("/v1/jobs")).header("traceparent", context);
    let job = job.multipart(form("a", "b", &steps(2, 10))).send().await.unwrap();
    let job = text(&served.expect(job, 202).await, "id").to_owned();
    served.client.until_succeeded(&job, SOON).await;
    until(2).await;
    let first_two = received.lock().unwrap().1.clone();
    let verifier = standardwebhooks::Webhook::new(&secret).unwrap();
    for (headers, body) in &first_two {
        verifier.verify(body.as_bytes(), headers).unwrap();
        assert_eq!(
            (&headers["webhook-id"], &headers["traceparent"]),
            (&first_two[0].0["webhook-id"], &context.parse().unwrap())
        );
        let event: Value = serde_json::from_str(body).unwrap();
        assert_eq!((&event["type"], &event["data"]["job_id"]), (&json!("job.succeeded"), &json!(job)));
    }
    // 410
    served.expect(served.client.post(&format!("{path}/test")).await.unwrap(), 202).await;
    until(3).await;
    let began = Instant::now();
    while served.expect(served.get(&path).await, 200).await["enabled"] == true {
        assert!(began.elapsed() < SOON, "a receiver that is gone is not disabled");
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    let changed = served.send(Method::PATCH, &path, &[], Some(&json!({"enabled": true}))).await;
    assert_eq!(served.expect(changed, 200).await["enabled"], true);
    let log = served.expect(served.get(&format!("{path}/deliveries")).await, 200).await;
    assert!(
        array(&log, "deliveries").iter().any(|delivery| delivery["state"] == "delivered" && delivery["attempts"] == 2),
        "{log}"
    );
    assert_eq!(served.client.delete(&path).await.unwrap().status(), 204);
    problem(served.get(&path).await, 404, "webhook-not-found").await;
    // Changes
    let feed = served.expect(served.get("/v1/changes").await, 200).await;
    let of_job: Vec<_> = array(&feed, "changes").iter().filter(|change| change["job_id"] == job.as_str()).collect();
    assert_eq!(
        of_job.iter().map(|change| text(change, "state")).collect::<Vec<_>>(),
        ["queued", "running", "succeeded"]
    );
    let numbers: Vec<_> = array(&feed, "changes").iter().map(|change| change["seq"].as_u64().unwrap()).collect();
    assert!(numbers.is_sorted_by(|a, b| a < b), "{numbers:?}");
    let rest = served.expect(served.get(&format!("/v1/changes?since={}", numbers[0])).await, 200).await;
    assert_eq!(array(&rest, "changes").len(), numbers.len() - 1);
}
