//! Promises on submissions.

use super::{SOON, Served, steps, text};
use crate::faults::on_both;
use crate::faults::site::Backend;
use crate::jobs_support::{form, problem};
use reqwest::{Method, Response};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

on_both!(
    a_submission_comes_in_three_forms,
    a_submission_is_made_once_tried_or_waited_for,
    equal_requests_share_a_result,
    limits_have_problems_of_their_own,
);

async fn a_submission_comes_in_three_forms(backend: Backend) {
    let served = Served::start(backend, &[]);
    let accepted = async |answer: Response| {
        let header = |name: &str| answer.headers()[name].to_str().unwrap().to_owned();
        let (location, retry_after) = (header("location"), header("retry-after"));
        let job = served.expect(answer, 202).await;
        assert_eq!(location, format!("/v1/jobs/{}", text(&job, "id")));
        assert!(retry_after.parse::<u32>().unwrap() >= 1);
        let ended = served.client.until_succeeded(text(&job, "id"), SOON).await;
        assert_eq!(ended["source"]["hash"], format!("blake3:{}", blake3::hash(b"source").to_hex()));
        served.expect(served.get(&format!("{location}/result")).await, 200).await;
    };
    let multipart = served.client.http.post(served.url("/v1/jobs"));
    accepted(multipart.multipart(form("source", "target", &json!({"seed": 1}))).send().await.unwrap()).await;
    let (source, target) = (served.upload("source").await, served.upload("target").await);
    let named = json!({"source": {"mesh_id": source}, "target": {"mesh_id": target}, "parameters": {"seed": 2}});
    accepted(served.post("/v1/jobs", &named).await).await;
    let inline =
        json!({"source": {"content_base64": "c291cmNl"}, "target": {"mesh_id": target}, "parameters": {"seed": 3}});
    accepted(served.post("/v1/jobs", &inline).await).await;
}

async fn a_submission_is_made_once_tried_or_waited_for(backend: Backend) {
    let served = Served::start(backend, &[]);
    let send = async |path: &str, header: (&'static str, &str), parameters: Value| {
        let request = served.client.http.post(served.url(path)).header(header.0, header.1);
        request.multipart(form("source", "target", &parameters)).send().await.unwrap()
    };
    // Idempotency-Key
    let key = ("idempotency-key", "one");
    let first = served.expect(send("/v1/jobs", key, json!({"seed": 1})).await, 202).await;
    let again = send("/v1/jobs", key, json!({"seed": 1})).await;
    assert_eq!(again.headers()["idempotency-replayed"], "true");
    assert_eq!(served.expect(again, 202).await["id"], first["id"]);
    problem(send("/v1/jobs", key, json!({"seed": 2})).await, 422, "idempotency-key-reused").await;
    // validate_only
    let n_jobs = served.client.list().await.len();
    let tried = served.expect(send("/v1/jobs?validate_only=true", ("x-a", "b"), json!({"seed": 5})).await, 200).await;
    assert_eq!((&tried["valid"], &tried["parameters"]["seed"]), (&json!(true), &json!(5)));
    let refused =
        problem(send("/v1/jobs?validate_only=true", ("x-a", "b"), json!({"x": 1})).await, 422, "invalid-parameters")
            .await;
    let error = &refused["errors"][0];
    assert!(
        error["pointer"] == "/parameters/x" && error["code"].is_string() && error["detail"].is_string(),
        "{refused}"
    );
    assert_eq!(served.client.list().await.len(), n_jobs, "nothing was created");
    // Prefer: wait
    let waited = send("/v1/jobs", ("prefer", "wait=20"), json!({"seed": 6, "points": 2})).await;
    assert_eq!(waited.headers()["preference-applied"], "wait=20");
    assert_eq!(served.expect(waited, 200).await["state"], "succeeded");
    let began = Instant::now();
    let long = send("/v1/jobs", ("prefer", "wait=1"), json!({"seed": 7, "points": 500, "step_ms": 20})).await;
    let long = served.expect(long, 202).await;
    assert!(began.elapsed() >= Duration::from_secs(1) && !text(&long, "id").is_empty());
}

async fn equal_requests_share_a_result(backend: Backend) {
    let served = Served::start(backend, &[]);
    let send = async |more: Option<&'static str>| {
        let mut form = form("source", "target", &json!({"seed": 1, "points": 3}));
        if let Some(use_cache) = more {
            form = form.text("use_cache", use_cache);
        }
        let answer = served.client.http.post(served.url("/v1/jobs")).multipart(form).send().await.unwrap();
        let job = served.expect(answer, 202).await;
        served.client.until_succeeded(text(&job, "id"), SOON).await
    };
    let parts = async |job: &Value| {
        let mut all = Vec::new();
        for part in ["correspondences?format=json", "correspondences?format=csv", "aligned"] {
            all.push(served.get(&format!("/v1/jobs/{}/{part}", text(job, "id"))).await.bytes().await.unwrap());
        }
        all
    };
    let (first, second, forced) = (send(None).await, send(None).await, send(Some("false")).await);
    assert_eq!([&first["cached"], &second["cached"], &forced["cached"]], [&json!(false), &json!(true), &json!(false)]);
    let bytes = parts(&first).await;
    assert_eq!(bytes, parts(&second).await);
    assert_eq!(bytes, parts(&forced).await, "computed anew, to the byte");
    assert_ne!(first["id"], second["id"]);
}

async fn limits_have_problems_of_their_own(backend: Backend) {
    let limits = ["--workers", "0", "--max-queue", "2", "--max-file-bytes", "1000", "--max-stored-bytes", "3000"];
    let served = Served::start(backend, &limits);
    let send = async |source: String, parameters: Value| {
        let request = served.client.http.post(served.url("/v1/jobs"));
        request.multipart(form(&source, "target", &parameters)).send().await.unwrap()
    };
    problem(send("x".repeat(1001), json!({})).await, 413, "too-large").await;
    problem(send("bad".to_owned(), json!({})).await, 422, "unsuitable-surface").await;
    problem(
        send("x".to_owned(), steps(1, 1).as_object().map(|_| json!({"unknown": 1})).unwrap()).await,
        422,
        "invalid-parameters",
    )
    .await;
    for seed in 0..2 {
        assert_eq!(send("x".to_owned(), json!({"seed": seed})).await.status(), 202);
    }
    let full = send("x".to_owned(), json!({"seed": 9})).await;
    assert!(full.headers()["retry-after"].to_str().unwrap().parse::<u32>().unwrap() >= 1);
    let body = problem(full, 429, "queue-full").await;
    assert!(body.as_object().unwrap().values().any(|value| value == 2), "the number is told: {body}");
    for n in 0..4 {
        let sent = served.client.http.post(served.url("/v1/meshes")).body(format!("{n}{}", "y".repeat(900)));
        let answer = sent.send().await.unwrap();
        if answer.status() != 201 {
            let problem = served.send(Method::GET, "/healthz", &[], None).await;
            assert_eq!(problem.status(), 200);
            let status = answer.status().as_u16();
            let body: Value = answer.json().await.unwrap();
            assert!([429, 507].contains(&status) && text(&body, "type").starts_with("/problems/"), "{body}");
            return;
        }
    }
    panic!("the share of stored bytes is not held");
}
