//! The HTTP API over loopback: answers to valid and to invalid requests.

use super::jobs_support::{TestService, form, problem};
use reqwest::multipart::{Form, Part};
use serde_json::{Value, json};

#[tokio::test]
async fn a_submission_becomes_a_result() {
    let service = TestService::start(&[]).await;
    let response = service.send(form("source", "target", &json!({"points": 5, "seed": 7}))).await;
    assert_eq!(response.status(), 202);
    assert!(response.headers().contains_key("retry-after"));
    let location = response.headers()["location"].to_str().unwrap().to_owned();
    let job: Value = response.json().await.unwrap();
    let id = job["id"].as_str().unwrap();
    assert_eq!(location, format!("/v1/jobs/{id}"));
    assert_eq!(job["links"]["self"], location);
    assert_eq!(job["seed"], 7);
    assert_eq!(job.get("reliable"), Some(&Value::Null), "there is no answer yet");
    assert!(job.get("surface_distance").is_none());
    assert_eq!(job["source"]["report"]["hint"], ".nii.gz");
    assert!(!job.to_string().contains("Jane"), "file names may name patients");
    assert_eq!(job["source"]["hash"], format!("blake3:{}", blake3::hash(b"source").to_hex()));

    let job = service.until_final(id).await;
    assert_eq!(job["state"], "succeeded", "{job}");
    assert_eq!(job["progress"]["fraction"], 1.0);
    assert_eq!(job["attempt"], 1);
    assert_eq!(job["energy_latest"], 200.0);
    for job in [&job, &service.json("/v1/jobs").await["jobs"][0]] {
        assert_eq!((&job["reliable"], &job["unreliable_reasons"]), (&json!(false), &json!(["ambiguous_pose"])));
        assert_eq!(job["surface_distance"], json!({"mean_mm": 0.5, "p95_mm": 1.25, "max_mm": 3.0}));
    }

    let trace = service.json(&format!("{location}/trace")).await;
    let seqs: Vec<_> = trace["points"].as_array().unwrap().iter().map(|p| p["seq"].as_u64().unwrap()).collect();
    assert_eq!(seqs, [1, 2, 3, 4, 5]);
    assert_eq!(trace["complete"], true);
    assert_eq!(trace["next_after_seq"], 5);
    let part = service.json(&format!("{location}/trace?after_seq=1&limit=2")).await;
    assert_eq!(part["points"].as_array().unwrap().len(), 2);
    assert_eq!((&part["next_after_seq"], &part["complete"]), (&json!(3), &json!(false)));

    let result = service.json(&format!("{location}/result")).await;
    assert_eq!(result["transform"]["matrix"][0][0], 1.5);
    assert_eq!(result["correspondences"]["target"], json!([1, 0]));
    let brief = service.json(&format!("{location}/result?correspondences=false")).await;
    assert!(brief.get("correspondences").is_none());
    for (link, text) in [("source_surface", "ply source"), ("target_surface", "ply target"), ("aligned", "ply aligned")]
    {
        let response = service.get(result["links"][link].as_str().unwrap()).await;
        assert_eq!(response.headers()["content-type"], "model/ply");
        assert_eq!(response.text().await.unwrap(), text);
    }
    service.end().await;
}

#[tokio::test]
async fn the_energy_of_a_finished_job_is_that_of_its_result() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 3, "energy": 42})).await;
    let job = service.until_final(&id).await;
    let result = service.json(&format!("/v1/jobs/{id}/result")).await;
    let trace = service.json(&format!("/v1/jobs/{id}/trace")).await;
    assert_eq!((&result["energy"]["final"], trace["points"].as_array().unwrap().len()), (&json!(42), 3));
    for job in [&job, &service.json("/v1/jobs").await["jobs"][0]] {
        assert_eq!(job["energy_latest"], 42.0);
    }
    service.end().await;
}

#[tokio::test]
async fn correspondences_come_as_json_and_as_csv() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({})).await;
    service.until_final(&id).await;
    let path = format!("/v1/jobs/{id}/correspondences");
    let columns = service.json(&path).await;
    assert_eq!(columns["source"], json!([0, 1]));
    let by_query = service.get(&format!("{path}?format=csv")).await;
    assert!(by_query.headers()["content-type"].to_str().unwrap().starts_with("text/csv"));
    let text = by_query.text().await.unwrap();
    assert_eq!(
        text,
        "source,target,confidence,inlier,spread_mm,outlier,triangle_0,triangle_1,triangle_2,\
         barycentric_0,barycentric_1,barycentric_2\r\n0,1,0.5,true,0,none,1,1,1,1,0,0\r\n1,0,0.25,false,0,none,0,0,0,1,0,0\r\n"
    );
    let request = service.client.get(format!("{}{path}", service.base)).header("accept", "text/csv");
    assert_eq!(request.send().await.unwrap().text().await.unwrap(), text);
    problem(service.get(&format!("{path}?format=xls")).await, 400, "invalid-query").await;
    service.end().await;
}

#[tokio::test]
async fn unchanged_answers_are_304() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 1})).await;
    service.until_final(&id).await;
    let parts = ["", "/result", "/correspondences", "/aligned", "/surfaces/source"];
    for path in parts.map(|part| format!("/v1/jobs/{id}{part}")) {
        let first = service.get(&path).await;
        let etag = first.headers()["etag"].clone();
        let request = service.client.get(format!("{}{path}", service.base)).header("if-none-match", etag);
        let second = request.send().await.unwrap();
        assert_eq!(second.status(), 304, "{path}");
        assert!(second.text().await.unwrap().is_empty());
    }
    service.end().await;
}

#[tokio::test]
async fn a_long_poll_answers_when_the_job_changes() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 3, "step_ms": 100})).await;
    let mut etag = String::new();
    loop {
        let request = service.client.get(format!("{}/v1/jobs/{id}?wait=10", service.base));
        let response = request.header("if-none-match", &etag).send().await.unwrap();
        assert_eq!(response.status(), 200, "a change ends the wait");
        etag = response.headers()["etag"].to_str().unwrap().to_owned();
        if response.json::<Value>().await.unwrap()["state"] == "succeeded" {
            break;
        }
    }
    problem(service.get(&format!("/v1/jobs/{id}?wait=31")).await, 400, "invalid-query").await;
    service.end().await;
}

#[tokio::test]
async fn lists_are_filtered_and_paged() {
    let service = TestService::start(&["--workers", "0"]).await;
    let mut ids = Vec::new();
    for i in 0..5 {
        let form = form("a", "b", &json!({})).text("external_ref", format!("study-{}", i % 2));
        let job: Value = service.send(form).await.json().await.unwrap();
        ids.push(job["id"].as_str().unwrap().to_owned());
    }
    service.post(&format!("/v1/jobs/{}/cancel", ids[0])).await;
    let mut seen = Vec::new();
    let mut token = String::new();
    loop {
        let page = service.json(&format!("/v1/jobs?order=asc&page_size=2&page_token={token}")).await;
        seen.extend(page["jobs"].as_array().unwrap().iter().map(|j| j["id"].as_str().unwrap().to_owned()));
        match page["next_page_token"].as_str() {
            Some(next) => token = next.to_owned(),
            None => break,
        }
    }
    assert_eq!(seen, ids);
    let count = async |query: &str| service.json(&format!("/v1/jobs?{query}")).await["jobs"].as_array().unwrap().len();
    assert_eq!(count("state=cancelled").await, 1);
    assert_eq!(count("state=queued,cancelled").await, 5);
    assert_eq!(count("state=queued&state=running").await, 4);
    assert_eq!(count("external_ref=study-1").await, 2);
    assert_eq!(count("method=other").await, 0);
    let newest = service.json("/v1/jobs?page_size=1").await;
    assert_eq!(newest["jobs"][0]["id"], ids[4]);
    for query in ["state=lost", "page_size=0", "page_size=501", "page_token=x", "order=up", "sate=queued"] {
        let body = problem(service.get(&format!("/v1/jobs?{query}")).await, 400, "invalid-query").await;
        assert!(body["errors"][0]["pointer"].as_str().unwrap().starts_with("/query/"), "{body}");
    }
    service.end().await;
}

#[tokio::test]
async fn a_queued_job_has_its_queue_position() {
    let service = TestService::start(&["--workers", "0"]).await;
    let first = service.submit(json!({})).await;
    let urgent: Value = service.send(form("a", "b", &json!({})).text("priority", "10")).await.json().await.unwrap();
    let urgent = urgent["id"].as_str().unwrap();
    assert_eq!(service.json(&format!("/v1/jobs/{first}")).await["queue_position"], 2);
    assert_eq!(service.json(&format!("/v1/jobs/{urgent}")).await["queue_position"], 1);
    service.end().await;
}

#[tokio::test]
async fn a_job_that_waits_or_has_just_begun_shows_its_predicted_time() {
    let service = TestService::start(&["--workers", "0", "--cores", "2"]).await;
    let accepted: Value =
        service.send(form("a", "b", &json!({"processor_ms": 90_000, "cores": 8}))).await.json().await.unwrap();
    assert_eq!(accepted["eta_ms"], 45_000, "on the cores that it gets: {accepted}");
    let id = accepted["id"].as_str().unwrap();
    assert_eq!(service.json(&format!("/v1/jobs/{id}")).await["eta_ms"], 45_000);
    assert!(service.json("/v1/jobs").await["jobs"][0].get("eta_ms").is_none(), "not in lists");
    let unknown = service.submit(json!({})).await;
    assert!(service.json(&format!("/v1/jobs/{unknown}")).await.get("eta_ms").is_none());
    service.end().await;

    let service = TestService::start(&["--workers", "1", "--cores", "1"]).await;
    let id = service.submit(json!({"processor_ms": 3_600_000, "points": 100, "step_ms": 10_000})).await;
    let job = service.until(&id, |job| job["state"] == "running").await;
    let eta_ms = job["eta_ms"].as_u64().unwrap();
    assert!((1_800_000..=3_600_000).contains(&eta_ms), "{job}");
    service.end().await;
}

#[tokio::test]
async fn cancel_reaches_queued_running_and_finished_jobs() {
    let service = TestService::start(&[]).await;
    let running = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    let queued = service.submit(json!({})).await;
    service.until_running(&running).await;
    let response = service.post(&format!("/v1/jobs/{queued}/cancel")).await;
    assert_eq!(response.status(), 202);
    assert_eq!(response.json::<Value>().await.unwrap()["state"], "cancelled");

    assert_eq!(service.post(&format!("/v1/jobs/{running}/cancel")).await.status(), 202);
    let job = service.until_final(&running).await;
    assert_eq!(job["state"], "cancelled");
    assert!(service.n_traced(&running).await < 1000, "before its end");
    assert_eq!(service.post(&format!("/v1/jobs/{running}/cancel")).await.status(), 202, "again changes nothing");
    let body = problem(service.get(&format!("/v1/jobs/{running}/result")).await, 409, "no-result").await;
    assert_eq!(body["state"], "cancelled");

    let finished = service.submit(json!({})).await;
    service.until_final(&finished).await;
    problem(service.post(&format!("/v1/jobs/{finished}/cancel")).await, 409, "job-finished").await;
    service.end().await;
}

#[tokio::test]
async fn a_computation_that_ignores_cancellation_does_not_delay_it() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 600, "step_ms": 100, "deaf": 1})).await;
    service.until_running(&id).await;
    service.post(&format!("/v1/jobs/{id}/cancel")).await;
    assert_eq!(service.until_final(&id).await["state"], "cancelled");
    assert!(service.n_traced(&id).await < 600, "before its end");
    service.end().await;
}

#[tokio::test]
async fn delete_removes_rows_and_files() {
    let service = TestService::start(&[]).await;
    let long = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    let waiting = service.submit(json!({})).await;
    service.until_running(&long).await;
    problem(service.delete(&format!("/v1/jobs/{long}")).await, 409, "job-active").await;
    problem(service.delete(&format!("/v1/jobs/{waiting}")).await, 409, "job-active").await;
    service.post(&format!("/v1/jobs/{long}/cancel")).await;
    service.until_final(&long).await;
    service.until_final(&waiting).await;
    let n_files = || files_under(&service.folder.path().join("blobs"));
    assert_eq!(n_files(), 7, "two inputs, shared by both jobs, and five parts of a result");
    assert_eq!(service.delete(&format!("/v1/jobs/{waiting}")).await.status(), 204);
    assert_eq!(n_files(), 2, "the other job still has the inputs");
    assert_eq!(service.delete(&format!("/v1/jobs/{long}")).await.status(), 204);
    assert_eq!(n_files(), 0);
    for path in ["", "/trace", "/result", "/correspondences", "/aligned"] {
        problem(service.get(&format!("/v1/jobs/{long}{path}")).await, 404, "job-not-found").await;
    }
    problem(service.delete(&format!("/v1/jobs/{long}")).await, 404, "job-not-found").await;
    service.end().await;
}

fn files_under(folder: &std::path::Path) -> usize {
    let entries = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    entries.map(|path| if path.is_dir() { files_under(&path) } else { 1 }).sum()
}

#[tokio::test]
async fn failures_and_panics_become_errors_of_the_job() {
    let service = TestService::start(&[]).await;
    let failing = service.submit(json!({"fail": 1})).await;
    let panicking = service.submit(json!({"panic": 1})).await;
    let job = service.until_final(&failing).await;
    assert_eq!((&job["state"], &job["error"]["type"]), (&json!("failed"), &json!("/problems/no-registration")));
    let job = service.until_final(&panicking).await;
    assert_eq!((&job["state"], &job["error"]["type"]), (&json!("failed"), &json!("/problems/internal-error")));
    assert!(!job["error"].to_string().contains("Jane"));
    problem(service.get(&format!("/v1/jobs/{panicking}/result")).await, 409, "no-result").await;
    let next = service.submit(json!({})).await;
    assert_eq!(service.until_final(&next).await["state"], "succeeded", "the slot lives on");
    service.end().await;
}

#[tokio::test]
async fn a_job_that_runs_too_long_fails() {
    let service = TestService::start(&["--max-run-s", "1"]).await;
    let id = service.submit(json!({"points": 1000, "step_ms": 20})).await;
    let job = service.until_final(&id).await;
    assert_eq!(job["error"]["type"], "/problems/run-time-exceeded");
    service.end().await;
}

#[tokio::test]
async fn results_are_not_ready_before_the_end() {
    let service = TestService::start(&["--workers", "0"]).await;
    let id = service.submit(json!({})).await;
    for path in ["/result", "/correspondences", "/aligned", "/surfaces/target"] {
        let body = problem(service.get(&format!("/v1/jobs/{id}{path}")).await, 409, "result-not-ready").await;
        assert_eq!(body["state"], "queued");
    }
    let trace = service.json(&format!("/v1/jobs/{id}/trace")).await;
    assert_eq!(trace, json!({"points": [], "next_after_seq": 0, "complete": false}));
    service.end().await;
}

#[tokio::test]
async fn faults_in_a_submission_name_their_field() {
    let service = TestService::start(&[]).await;
    let body = problem(service.send(form("a", "b", &json!({"x": 1, "y": 2}))).await, 422, "invalid-parameters").await;
    let pointers: Vec<_> = body["errors"].as_array().unwrap().iter().map(|e| e["pointer"].clone()).collect();
    assert_eq!(pointers, ["/parameters/x", "/parameters/y"]);

    let body = problem(service.send(form("ok", "bad", &json!({}))).await, 422, "unsuitable-surface").await;
    assert_eq!((&body["input"], &body["topology"]["n_components"]), (&json!("target"), &json!(2)));

    let file = || Part::bytes(b"x".to_vec()).file_name("a.ply");
    let both = || Form::new().part("source", file()).part("target", file());
    for (name, value, pointer) in [
        ("priority", "101", "/priority"),
        ("priority", "high", "/priority"),
        ("tags", "[1]", "/tags"),
        ("tags", "{\"a\": 1}", "/tags"),
        ("color", "red", "/color"),
    ] {
        let body = problem(service.send(both().text(name, value)).await, 422, "invalid-request").await;
        assert_eq!(body["errors"][0]["pointer"], pointer);
    }
    for text in ["", "{", "[]", "null", "nan", "{\"points\": NaN}"] {
        let body = problem(service.send(both().text("parameters", text)).await, 422, "invalid-parameters").await;
        assert_eq!(body["errors"][0]["pointer"], "/parameters", "{text}");
    }
    let body = problem(service.send(Form::new().part("source", file())).await, 422, "invalid-request").await;
    assert_eq!(body["errors"][0]["pointer"], "/target");
    let twice = both().part("source", file());
    problem(service.send(twice).await, 422, "invalid-request").await;
    let tags: Value = service.send(both().text("tags", "{\"study\": \"s1\"}")).await.json().await.unwrap();
    assert_eq!(tags["tags"]["study"], "s1");
    service.end().await;
}

#[tokio::test]
async fn every_invalid_request_is_answered_with_a_problem() {
    let service = TestService::start(&[]).await;
    for path in ["/assets/nope.js", "/nope", "/v1", "/v1/jobs/", "/v1/nope", "/v1/jobs/x/y/z"] {
        problem(service.get(path).await, 404, "route-not-found").await;
    }
    for id in ["x", "00000000-0000-0000-0000-000000000000", "%F0%9F%92%A9", "'; drop table jobs; --"] {
        problem(service.get(&format!("/v1/jobs/{id}")).await, 404, "job-not-found").await;
        problem(service.post(&format!("/v1/jobs/{id}/cancel")).await, 404, "job-not-found").await;
    }
    problem(service.get("/v1/jobs/%FF").await, 400, "bad-request").await;
    problem(service.get("/v1/methods/none").await, 404, "method-not-found").await;
    for (method, path) in [("PUT", "/v1/jobs"), ("PATCH", "/healthz"), ("DELETE", "/v1/methods"), ("BREW", "/v1/jobs")]
    {
        let method = reqwest::Method::from_bytes(method.as_bytes()).unwrap();
        let response = service.client.request(method, format!("{}{path}", service.base)).send().await.unwrap();
        assert!(response.headers().contains_key("allow"));
        problem(response, 405, "method-not-allowed").await;
    }
    let jobs = || service.client.post(format!("{}/v1/jobs", service.base));
    problem(jobs().json(&json!({})).send().await.unwrap(), 422, "invalid-request").await;
    let text = jobs().header("content-type", "text/plain").body("x");
    problem(text.send().await.unwrap(), 415, "unsupported-media-type").await;
    problem(jobs().send().await.unwrap(), 415, "unsupported-media-type").await;
    let multipart =
        |kind: &str, body: &str| jobs().header("content-type", kind.to_owned()).body(body.to_owned()).send();
    for (kind, body) in [
        ("multipart/form-data", "--x--"),
        ("multipart/form-data; boundary=x", ""),
        ("multipart/form-data; boundary=x", "no boundary here"),
        ("multipart/form-data; boundary=x", "--x\r\nContent-Disposition: form-data; name=\"source\"\r\n\r\nnever ends"),
    ] {
        problem(multipart(kind, body).await.unwrap(), 400, "malformed-multipart").await;
    }
    problem(multipart("multipart/form-data; boundary=x", "--x--\r\n").await.unwrap(), 422, "invalid-request").await;
    let body = problem(service.send(form("panic", "b", &json!({}))).await, 500, "internal-error").await;
    assert!(body.get("detail").is_none(), "the cause is hidden: {body}");
    service.end().await;
}

#[tokio::test]
async fn each_limit_has_its_own_problem() {
    let service = TestService::start(&["--workers", "0", "--max-queue", "2", "--max-file-bytes", "1000"]).await;
    let large = "x".repeat(1001);
    let body = problem(service.send(form(&large, "b", &json!({}))).await, 413, "too-large").await;
    assert_eq!((&body["input"], &body["limit_bytes"]), (&json!("source"), &json!(1000)));
    let huge = "x".repeat(5 << 20);
    let response = service.send(Form::new().text("tags", huge.clone()).text("color", huge)).await;
    problem(response, 413, "too-large").await;
    let many = (0..6).fold(Form::new(), |form, _| form.text("color", "x".repeat(1 << 20)));
    problem(service.send(many).await, 413, "body-too-large").await;
    service.submit(json!({})).await;
    service.submit(json!({})).await;
    let response = service.send(form("a", "b", &json!({}))).await;
    assert!(response.headers().contains_key("retry-after"));
    problem(response, 429, "queue-full").await;
    service.end().await;
}

#[tokio::test]
async fn the_service_describes_itself() {
    let service = TestService::start(&[]).await;
    assert_eq!(service.json("/healthz").await["status"], "alive");
    let ready = service.json("/readyz").await;
    assert_eq!(ready["dependencies"], json!({"job_store": "ok", "artifact_store": "ok", "clock": "ok"}));
    assert_eq!(service.json("/openapi.json").await["openapi"], "3.1.0");
    assert_eq!(service.json("/v1/methods").await["methods"][0]["name"], "scripted");
    assert_eq!(service.json("/v1/methods/scripted").await["version"], "1");
    assert_eq!(service.json("/problems/queue-full").await["status"], 429);
    let request = service.client.get(format!("{}/healthz", service.base)).header("x-request-id", "mine-1");
    assert_eq!(request.send().await.unwrap().headers()["x-request-id"], "mine-1");
    service.end().await;
}

#[tokio::test]
async fn readiness_names_the_failing_dependency() {
    let service = TestService::start(&["--workers", "0"]).await;
    std::fs::remove_dir(service.folder.path().join("blobs")).unwrap();
    let body = problem(service.get("/readyz").await, 503, "unavailable").await;
    assert_eq!(body["dependencies"], json!({"job_store": "ok", "artifact_store": "failing", "clock": "ok"}));
    assert_eq!(service.get("/healthz").await.status(), 200);
    service.end().await;
}
