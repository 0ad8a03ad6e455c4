//! The resources of a service for many users, over loopback.

use super::jobs_support::{TestService, form, problem};
use crate::patience::PATIENCE;
use futures_util::StreamExt;
use reqwest::Response;
use serde_json::{Value, json};
use std::time::{Duration, Instant};

async fn post_json(service: &TestService, path: &str, body: &Value) -> Response {
    service.client.post(format!("{}{path}", service.base)).json(body).send().await.unwrap()
}

async fn body(response: Response) -> Value {
    response.json().await.unwrap()
}

/// Uploads a file and returns its id.
async fn upload(service: &TestService, content: &str) -> String {
    let response = service
        .client
        .post(format!("{}/v1/meshes?file_name=Doe.ply", service.base))
        .body(content.to_owned())
        .send()
        .await
        .unwrap();
    assert!(response.status().is_success(), "{}", response.text().await.unwrap());
    body(response).await["id"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn an_upload_is_stored_once_under_its_hash() {
    let service = TestService::start(&["--max-file-bytes", "1000"]).await;
    let send = |content: String| service.client.post(format!("{}/v1/meshes", service.base)).body(content).send();
    let first = send("mesh".to_owned()).await.unwrap();
    assert_eq!(first.status(), 201);
    let location = first.headers()["location"].to_str().unwrap().to_owned();
    let mesh = body(first).await;
    let id = format!("blake3:{}", blake3::hash(b"mesh").to_hex());
    assert_eq!((&mesh["id"], &mesh["n_bytes"], &mesh["suitable"]), (&json!(id), &json!(4), &json!(true)));
    assert_eq!(location, format!("/v1/meshes/{id}"));
    assert_eq!(send("mesh".to_owned()).await.unwrap().status(), 200, "held already");

    let form = reqwest::multipart::Form::new()
        .part("file", reqwest::multipart::Part::bytes(b"mesh".to_vec()).file_name("Doe^Jane.ply"));
    let again = service.client.post(format!("{}/v1/meshes", service.base)).multipart(form).send().await.unwrap();
    assert_eq!(again.status(), 200);
    let answer = service.get(&location).await;
    let etag = answer.headers()["etag"].clone();
    assert_eq!(body(answer).await["n_vertices"], 3);
    let fresh = service.client.get(format!("{}{location}", service.base)).header("if-none-match", etag);
    assert_eq!(fresh.send().await.unwrap().status(), 304);
    assert_eq!(service.get(&format!("{location}/content")).await.text().await.unwrap(), "mesh");
    let head = service.client.head(format!("{}{location}", service.base)).send().await.unwrap();
    assert_eq!((head.status().as_u16(), head.text().await.unwrap().len()), (200, 0));

    let bad = body(send("bad".to_owned()).await.unwrap()).await;
    assert_eq!((&bad["suitable"], &bad["problem"]["type"]), (&json!(false), &json!("/problems/unsuitable-surface")));
    problem(send("x".repeat(1001)).await.unwrap(), 413, "too-large").await;
    problem(send(String::new()).await.unwrap(), 422, "empty-structure").await;
    for wrong in ["blake3:00", "x", &format!("blake3:{}", "0".repeat(64))] {
        problem(service.get(&format!("/v1/meshes/{wrong}")).await, 404, "mesh-not-found").await;
    }
    assert_eq!(service.json("/v1/meshes?page_size=1").await["meshes"].as_array().unwrap().len(), 1);
    assert!(service.json("/v1/meshes?page_size=1").await["next_page_token"].is_string());
    assert_eq!(service.delete(&location).await.status(), 204);
    problem(service.get(&location).await, 404, "mesh-not-found").await;
    service.end().await;
}

#[tokio::test]
async fn jobs_refer_to_uploads_or_contain_small_files() {
    let service = TestService::start(&[]).await;
    let (source, target) = (upload(&service, "source").await, upload(&service, "target").await);
    let by_name = json!({"source": {"mesh_id": source}, "target": {"mesh_id": target}, "parameters": {"seed": 3}});
    let response = post_json(&service, "/v1/jobs", &by_name).await;
    assert_eq!(response.status(), 202);
    let job = body(response).await;
    assert_eq!((&job["source"]["hash"], &job["seed"]), (&json!(source), &json!(3)));
    assert_eq!(service.until_final(job["id"].as_str().unwrap()).await["state"], "succeeded");
    problem(service.delete(&format!("/v1/meshes/{source}")).await, 409, "mesh-in-use").await;
    assert_eq!(service.delete(&format!("/v1/jobs/{}", job["id"].as_str().unwrap())).await.status(), 204);
    assert_eq!(service.delete(&format!("/v1/meshes/{source}")).await.status(), 204);

    let inline = json!({"source": {"content_base64": "c291cmNl", "file_name": "Doe.nii.gz"},
        "target": {"mesh_id": target}, "tags": {"a": "b"}, "priority": 4, "use_cache": false});
    let job = body(post_json(&service, "/v1/jobs", &inline).await).await;
    assert_eq!((&job["source"]["report"]["hint"], &job["priority"]), (&json!(".nii.gz"), &json!(4)));
    assert_eq!(service.until_final(job["id"].as_str().unwrap()).await["state"], "succeeded");

    problem(post_json(&service, "/v1/jobs", &by_name).await, 404, "mesh-not-found").await;
    for (wrong, pointer) in [
        (json!({"source": {}, "target": {"mesh_id": target}}), "/source"),
        (json!({"source": {"mesh_id": "x"}, "target": {"mesh_id": target}}), "/source/mesh_id"),
        (json!({"source": {"content_base64": "%"}, "target": {"mesh_id": target}}), "/source/content_base64"),
        (json!({"source": {"mesh_id": target}, "target": {"mesh_id": target}, "priority": 101}), "/priority"),
        (json!({"source": {"mesh_id": target}, "target": {"mesh_id": target}, "max_run_s": 0}), "/max_run_s"),
    ] {
        let refused = problem(post_json(&service, "/v1/jobs", &wrong).await, 422, "invalid-request").await;
        assert_eq!(refused["errors"][0]["pointer"], pointer, "{refused}");
    }
    for wrong in [json!({"source": {"mesh_id": target}}), json!({"color": 1}), json!([]), json!("x")] {
        problem(post_json(&service, "/v1/jobs", &wrong).await, 422, "invalid-request").await;
    }
    let raw = service.client.post(format!("{}/v1/jobs", service.base)).header("content-type", "application/json");
    problem(raw.body("{").send().await.unwrap(), 400, "malformed-json").await;
    service.end().await;
}

#[tokio::test]
async fn a_submission_can_be_validated_without_creating_a_job() {
    let service = TestService::start(&[]).await;
    let send = async |parameters: Value, target: &str| {
        let url = format!("{}/v1/jobs?validate_only=true", service.base);
        service.client.post(url).multipart(form("source", target, &parameters)).send().await.unwrap()
    };
    let tried = send(json!({"seed": 5}), "target").await;
    assert_eq!(tried.status(), 200);
    let tried = body(tried).await;
    assert_eq!((&tried["valid"], &tried["parameters"]["seed"]), (&json!(true), &json!(5)));
    assert_eq!(tried["source"]["n_vertices"], 3);
    problem(send(json!({"x": 1}), "target").await, 422, "invalid-parameters").await;
    problem(send(json!({}), "bad").await, 422, "unsuitable-surface").await;
    assert!(service.json("/v1/jobs").await["jobs"].as_array().unwrap().is_empty());
    service.end().await;
}

#[tokio::test]
async fn a_submission_can_wait_for_the_finished_job() {
    let service = TestService::start(&[]).await;
    let send = |parameters: Value, prefer: &'static str| {
        let request = service.client.post(format!("{}/v1/jobs", service.base)).header("prefer", prefer);
        request.multipart(form("source", "target", &parameters)).send()
    };
    let quick = send(json!({"points": 3, "step_ms": 50}), "wait=10").await.unwrap();
    assert_eq!((quick.status().as_u16(), &quick.headers()["preference-applied"]), (200, &"wait=10".parse().unwrap()));
    assert_eq!(body(quick).await["state"], "succeeded");
    let began = Instant::now();
    let slow = send(json!({"points": 1000, "step_ms": 20}), "respond-async, wait=1").await.unwrap();
    assert_eq!(slow.status(), 202);
    assert!(slow.headers().contains_key("location"));
    assert!(began.elapsed() >= Duration::from_secs(1), "{:?}", began.elapsed());
    service.end().await;
}

#[tokio::test]
async fn an_idempotency_key_creates_one_job() {
    let service = TestService::start(&["--workers", "0"]).await;
    let send = |key: &'static str, seed: u64| {
        let request = service.client.post(format!("{}/v1/jobs", service.base)).header("idempotency-key", key);
        request.multipart(form("source", "target", &json!({"seed": seed}))).send()
    };
    let first = send("one", 1).await.unwrap();
    assert!(!first.headers().contains_key("idempotency-replayed"));
    let first = body(first).await;
    // The job has changed in the meantime, but the first answer is repeated.
    service.post(&format!("/v1/jobs/{}/cancel", first["id"].as_str().unwrap())).await;
    let again = send("one", 1).await.unwrap();
    assert_eq!((again.status().as_u16(), &again.headers()["idempotency-replayed"]), (202, &"true".parse().unwrap()));
    assert_eq!(body(again).await, first);
    problem(send("one", 2).await.unwrap(), 422, "idempotency-key-reused").await;
    assert_ne!(body(send("two", 1).await.unwrap()).await["id"], first["id"]);
    problem(send("two words", 1).await.unwrap(), 400, "bad-request").await;

    // A request that created nothing may be corrected and sent again with the same key.
    let wrong = service.client.post(format!("{}/v1/jobs", service.base)).header("idempotency-key", "three");
    problem(wrong.multipart(form("bad", "b", &json!({}))).send().await.unwrap(), 422, "unsuitable-surface").await;
    assert_eq!(send("three", 1).await.unwrap().status(), 202);

    let (a, b) = (upload(&service, "a").await, upload(&service, "b").await);
    let batch = |seed: u64| {
        let body =
            json!({"pairs": [{"source": {"mesh_id": a}, "target": {"mesh_id": b}}], "parameters": {"seed": seed}});
        let request = service.client.post(format!("{}/v1/batches", service.base)).header("idempotency-key", "batch");
        request.json(&body).send()
    };
    let made = body(batch(1).await.unwrap()).await;
    assert_eq!(body(batch(1).await.unwrap()).await["id"], made["id"]);
    problem(batch(2).await.unwrap(), 422, "idempotency-key-reused").await;
    service.end().await;
}

#[tokio::test]
async fn equal_requests_are_answered_from_the_first_result() {
    let service = TestService::start(&[]).await;
    let first = service.submit(json!({"seed": 1, "points": 3})).await;
    service.until_final(&first).await;
    let again = service.send(form("source", "target", &json!({"seed": 1, "points": 3}))).await;
    let again = body(again).await;
    assert_eq!((&again["state"], &again["cached"]), (&json!("succeeded"), &json!(true)));
    assert_ne!(again["id"], first);
    let id = again["id"].as_str().unwrap();
    let [a, b] = [&first, id].map(|id| format!("/v1/jobs/{id}"));
    let texts = async |path: &str| service.get(path).await.text().await.unwrap();
    assert_eq!(texts(&format!("{a}/correspondences")).await, texts(&format!("{b}/correspondences")).await);
    assert_eq!(texts(&format!("{a}/trace")).await, texts(&format!("{b}/trace")).await);
    // The first job may be deleted.
    assert_eq!(service.delete(&a).await.status(), 204);
    assert_eq!(service.get(&format!("{b}/result")).await.status(), 200);
    let forced = form("source", "target", &json!({"seed": 1, "points": 3})).text("use_cache", "false");
    assert_eq!(body(service.send(forced).await).await["cached"], false);
    let other = service.submit(json!({"seed": 2, "points": 3})).await;
    assert_eq!(service.until_final(&other).await["cached"], false);
    service.end().await;
}

#[tokio::test]
async fn finished_jobs_can_be_retried() {
    let service = TestService::start(&[]).await;
    let failed = service.submit(json!({"fail": 1})).await;
    service.until_final(&failed).await;
    let again = service.post(&format!("/v1/jobs/{failed}/retry")).await;
    assert_eq!(again.status(), 202);
    let again = body(again).await;
    assert_eq!((&again["retry_of"], &again["cached"]), (&json!(failed), &json!(false)));
    let id = again["id"].as_str().unwrap();
    assert_eq!(service.until_final(id).await["state"], "failed");
    let running = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    service.until_running(&running).await;
    problem(service.post(&format!("/v1/jobs/{running}/retry")).await, 409, "job-active").await;
    problem(service.post(&format!("/v1/jobs/{}/retry", uuid::Uuid::now_v7())).await, 404, "job-not-found").await;
    service.end().await;
}

#[tokio::test]
async fn many_jobs_are_cancelled_at_once() {
    let service = TestService::start(&[]).await;
    let running = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    service.until_running(&running).await;
    for i in 0..4 {
        let tags = json!({"study": format!("s{}", i % 2)}).to_string();
        service.send(form("a", "b", &json!({"seed": i})).text("tags", tags)).await;
    }
    problem(service.post("/v1/jobs/cancel").await, 400, "invalid-query").await;
    problem(service.post("/v1/jobs/cancel?state=failed").await, 400, "invalid-query").await;
    let done = service.post("/v1/jobs/cancel?tag=study:s1").await;
    assert_eq!(done.status(), 202);
    assert_eq!(body(done).await, json!({"cancelled": 2, "told": 0}));
    assert_eq!(body(service.post("/v1/jobs/cancel?all=true").await).await, json!({"cancelled": 2, "told": 1}));
    assert_eq!(service.until_final(&running).await["state"], "cancelled");
    assert_eq!(service.json("/v1/jobs?state=cancelled").await["jobs"].as_array().unwrap().len(), 5);
    service.end().await;
}

#[tokio::test]
async fn a_batch_is_followed_and_cancelled_as_a_whole() {
    let service = TestService::start(&["--workers", "0", "--max-batch", "3"]).await;
    let template = upload(&service, "template").await;
    let mut subjects = Vec::new();
    for i in 0..3 {
        let mesh_id = upload(&service, &format!("subject {i}")).await;
        subjects.push(
            json!({"input": {"mesh_id": mesh_id}, "external_ref": format!("s{i}"), "tags": {"n": i.to_string()}}),
        );
    }
    let submission =
        json!({"template": {"mesh_id": template}, "subjects": subjects, "tags": {"study": "x"}, "priority": 7});
    let response = post_json(&service, "/v1/batches", &submission).await;
    assert_eq!(response.status(), 202);
    let location = response.headers()["location"].to_str().unwrap().to_owned();
    let batch = body(response).await;
    assert_eq!((&batch["n_jobs"], &batch["counts"]), (&json!(3), &json!({"queued": 3})));
    let jobs = service.json(&format!("{location}/jobs")).await;
    let jobs = jobs["jobs"].as_array().unwrap();
    assert_eq!(jobs.iter().map(|j| j["external_ref"].as_str().unwrap()).collect::<Vec<_>>(), ["s0", "s1", "s2"]);
    assert_eq!(jobs[1]["tags"], json!({"study": "x", "n": "1"}));
    assert_eq!((&jobs[1]["target"]["hash"], &jobs[1]["priority"]), (&json!(template), &json!(7)));
    let by_filter = service.json(&format!("/v1/jobs?batch={}", batch["id"].as_str().unwrap())).await;
    assert_eq!(by_filter["jobs"].as_array().unwrap().len(), 3);
    assert_eq!(body(service.post(&format!("{location}/cancel")).await).await, json!({"cancelled": 3, "told": 0}));
    let after = service.json(&location).await;
    assert_eq!((&after["counts"], &after["finished"]), (&json!({"cancelled": 3}), &json!(true)));
    assert_eq!(service.json("/v1/batches").await["batches"].as_array().unwrap().len(), 1);

    let bad = upload(&service, "bad").await;
    let missing = format!("blake3:{}", "0".repeat(64));
    let wrong = json!({"pairs": [{"source": {"mesh_id": template}, "target": {"mesh_id": template}}, {"source": {"mesh_id": bad}, "target": {"mesh_id": missing}}]});
    let refused = problem(post_json(&service, "/v1/batches", &wrong).await, 422, "unsuitable-batch").await;
    let pointers: Vec<_> = refused["errors"].as_array().unwrap().iter().map(|e| e["pointer"].clone()).collect();
    assert_eq!(pointers, ["/pairs/1/source", "/pairs/1/target"]);
    let four = json!({"pairs": (0..4).map(|_| json!({"source": {"mesh_id": template}, "target": {"mesh_id": template}})).collect::<Vec<_>>()});
    problem(post_json(&service, "/v1/batches", &four).await, 413, "too-large").await;
    for wrong in [json!({}), json!({"template": template}), json!({"pairs": []})] {
        problem(post_json(&service, "/v1/batches", &wrong).await, 422, "invalid-request").await;
    }
    problem(service.get("/v1/batches/x").await, 404, "batch-not-found").await;
    assert_eq!(service.json("/v1/jobs").await["jobs"].as_array().unwrap().len(), 3, "no partially created batch");
    service.end().await;
}

/// Events of a stream until it ends: name, id, data.
async fn events(response: Response) -> Vec<(String, Option<u64>, Value)> {
    let mut text = String::new();
    let mut stream = response.bytes_stream();
    while let Some(Ok(part)) = stream.next().await {
        text.push_str(std::str::from_utf8(&part).unwrap());
    }
    let field = |block: &str, name: &str| {
        block.lines().find_map(|l| l.strip_prefix(name)).map(|value| value.trim_start_matches(':').trim().to_owned())
    };
    text.split("\n\n")
        .filter_map(|block| {
            let name = field(block, "event")?;
            let id = field(block, "id").map(|id| id.trim_end_matches("-done").parse().unwrap());
            Some((name, id, serde_json::from_str(&field(block, "data").unwrap()).unwrap()))
        })
        .collect()
}

#[tokio::test]
async fn events_cover_a_job_from_start_to_end() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 12, "step_ms": 60})).await;
    let url = format!("{}/v1/jobs/{id}/events", service.base);
    let response = service.client.get(&url).send().await.unwrap();
    assert_eq!(response.headers()["content-type"], "text/event-stream");
    assert_eq!(response.headers()["x-accel-buffering"], "no");
    let all = tokio::time::timeout(PATIENCE, events(response)).await.unwrap();
    let seqs: Vec<_> = all.iter().filter(|(name, ..)| name == "trace").map(|(_, id, _)| id.unwrap()).collect();
    assert_eq!(seqs, (1..=12).collect::<Vec<_>>());
    let states: Vec<_> = all.iter().filter(|e| e.0 == "state").map(|e| e.2["state"].as_str().unwrap()).collect();
    assert_eq!(states.last(), Some(&"succeeded"));
    assert!(all.iter().filter(|e| e.0 == "progress").count() > 1, "live, not only at the end");
    assert_eq!((all.last().unwrap().0.as_str(), &all.last().unwrap().2["state"]), ("done", &json!("succeeded")));

    let later = service.client.get(&url).header("last-event-id", "9").send().await.unwrap();
    let rest = tokio::time::timeout(PATIENCE, events(later)).await.unwrap();
    let seqs: Vec<_> = rest.iter().filter(|event| event.0 == "trace").map(|event| event.1.unwrap()).collect();
    assert_eq!(seqs, [10, 11, 12], "no gap and no repetition");
    let wrong = service.client.get(&url).header("last-event-id", "x").send().await.unwrap();
    problem(wrong, 400, "bad-request").await;
    problem(service.get(&format!("/v1/jobs/{}/events", uuid::Uuid::now_v7())).await, 404, "job-not-found").await;

    let long = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    service.until_running(&long).await;
    let open = service.client.get(format!("{}/v1/jobs/{long}/events", service.base)).send().await.unwrap();
    service.shutdown.stop.cancel();
    tokio::time::timeout(PATIENCE, events(open)).await.expect("the stream ends with the service");
    service.end().await;
}

#[tokio::test]
async fn the_feed_of_changes_resumes_after_a_given_change() {
    let service = TestService::start(&[]).await;
    let first = service.submit(json!({})).await;
    service.until_final(&first).await;
    let feed = service.json("/v1/changes").await;
    let states: Vec<_> = feed["changes"].as_array().unwrap().iter().map(|c| c["state"].as_str().unwrap()).collect();
    assert_eq!((states, &feed["more"]), (vec!["queued", "running", "succeeded"], &json!(false)));
    let since = feed["next_since"].as_u64().unwrap();
    assert!(service.json(&format!("/v1/changes?since={since}")).await["changes"].as_array().unwrap().is_empty());
    let second = service.submit(json!({"seed": 1})).await;
    service.until_final(&second).await;
    let page = service.json(&format!("/v1/changes?since={since}&limit=2")).await;
    assert_eq!((page["changes"].as_array().unwrap().len(), &page["more"]), (2, &json!(true)));
    assert!(page["changes"].as_array().unwrap().iter().all(|change| change["job_id"] == second));
    problem(service.get("/v1/changes?since=-1").await, 400, "invalid-query").await;
    service.end().await;
}

#[tokio::test]
async fn deadlines_and_run_time_limits_of_a_submission_are_enforced() {
    let service = TestService::start(&[]).await;
    let running = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    service.until_running(&running).await;
    let soon = jiff::Timestamp::now() + Duration::from_millis(300);
    let late = form("a", "b", &json!({})).text("deadline_at", soon.to_string());
    let late = body(service.send(late).await).await["id"].as_str().unwrap().to_owned();
    let job = service.until_final(&late).await;
    assert_eq!((&job["state"], &job["error"]["type"]), (&json!("expired"), &json!("/problems/deadline-passed")));
    service.post(&format!("/v1/jobs/{running}/cancel")).await;
    let short = form("a", "b", &json!({"points": 1000, "step_ms": 20})).text("max_run_s", "1");
    let short = body(service.send(short).await).await["id"].as_str().unwrap().to_owned();
    assert_eq!(service.until_final(&short).await["error"]["type"], "/problems/run-time-exceeded");
    service.end().await;
}

#[tokio::test]
async fn metrics_contain_no_identifiers() {
    let service = TestService::start(&[]).await;
    let tags = json!({"patient": "Jane Doe"}).to_string();
    let sent = form("a", "b", &json!({})).text("tags", tags).text("external_ref", "Jane Doe");
    let id = body(service.send(sent).await).await["id"].as_str().unwrap().to_owned();
    service.until_final(&id).await;
    let text = service.get("/metrics").await.text().await.unwrap();
    for line in ["homolog_jobs{state=\"queued\"} 0", "homolog_job_store_up 1", "homolog_http_requests_total{"] {
        assert!(text.contains(line), "{line} is not in\n{text}");
    }
    assert!(text.contains("route=\"/v1/jobs/{id}\"") && !text.contains(&id) && !text.contains("Jane"), "{text}");
    service.end().await;
}
