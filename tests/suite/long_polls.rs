//! Long polls: which changes end a wait, which do not, and how often a client that asks again at once is answered.

use super::jobs_support::{TestService, problem};
use crate::patience::{BEFORE_ITS_END, WAIT_S};
use reqwest::Response;
use reqwest::header::HeaderValue;
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// `GET path`, with `If-None-Match` if there is an ETag.
async fn get(service: &TestService, path: &str, etag: Option<&HeaderValue>) -> Response {
    let request = service.client.get(format!("{}{path}", service.base));
    let request = etag.into_iter().fold(request, |request, etag| request.header("if-none-match", etag));
    request.send().await.unwrap()
}

fn etag_of(response: &Response) -> HeaderValue {
    response.headers()["etag"].clone()
}

/// Time since `time`, by the clock that the service also uses.
fn age(time: &Value) -> Duration {
    let time: jiff::Timestamp = time.as_str().unwrap().parse().unwrap();
    Duration::try_from(jiff::Timestamp::now().duration_since(time)).unwrap_or_default()
}

#[tokio::test]
async fn a_loop_on_a_busy_job_makes_one_request_a_second_and_sees_the_end_at_once() {
    let service = TestService::start(&[]).await;
    for conditional in [false, true] {
        // Half a percent every 20 ms.
        let id = service.submit(json!({"points": 200, "step_ms": 20, "seed": u64::from(conditional)})).await;
        service.until_running(&id).await;
        let path = format!("/v1/jobs/{id}?wait={WAIT_S}");
        let (began, mut n_requests, mut percents) = (Instant::now(), 0, Vec::new());
        let mut etag = None;
        let job = loop {
            let response = get(&service, &path, etag.as_ref()).await;
            assert_eq!(response.status(), 200, "progress ends the wait");
            n_requests += 1;
            etag = conditional.then(|| etag_of(&response));
            let job: Value = response.json().await.unwrap();
            if job["state"] != "running" {
                break job;
            }
            percents.push((job["progress"]["fraction"].as_f64().unwrap_or(0.0) * 100.0) as u32);
        };
        assert!(age(&job["finished_at"]) < BEFORE_ITS_END, "seen {:?} after the end", age(&job["finished_at"]));
        let elapsed_s = began.elapsed().as_secs_f64();
        // The end is always reported at once, which adds an answer.
        assert!(f64::from(n_requests) <= elapsed_s + 2.0, "{n_requests} requests in {elapsed_s} s");
        assert!(n_requests >= 2, "progress is reported while the job runs");
        assert!(percents.windows(2).all(|pair| pair[0] < pair[1]), "each answer has news: {percents:?}");
    }
    service.end().await;
}

#[tokio::test]
async fn a_changed_estimate_does_not_end_a_wait() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 3, "step_ms": 6000})).await;
    let path = format!("/v1/jobs/{id}");
    service.until(&id, |job| job["eta_ms"].is_u64()).await;
    let first = get(&service, &path, None).await;
    let etag = etag_of(&first);
    assert!(etag.to_str().unwrap().starts_with("W/\""), "bodies with the same ETag differ: {etag:?}");
    let first: Value = first.json().await.unwrap();
    tokio::time::sleep(Duration::from_millis(200)).await;
    let second = get(&service, &path, None).await;
    assert_eq!(etag_of(&second), etag);
    assert_ne!(second.json::<Value>().await.unwrap()["eta_ms"], first["eta_ms"]);

    assert_eq!(get(&service, &path, Some(&etag)).await.status(), 304, "without a wait, at once");
    let began = Instant::now();
    assert_eq!(get(&service, &format!("{path}?wait=1"), Some(&etag)).await.status(), 304);
    assert!(began.elapsed() >= Duration::from_millis(900), "{:?}", began.elapsed());
    let began = Instant::now();
    assert_eq!(get(&service, &format!("{path}?wait=1"), None).await.status(), 200, "without a condition");
    assert!(began.elapsed() >= Duration::from_millis(900), "{:?}", began.elapsed());

    let path = format!("{path}?wait={WAIT_S}");
    let waits = async { (get(&service, &path, Some(&etag)).await, Instant::now()) };
    let cancels = async {
        tokio::time::sleep(Duration::from_millis(100)).await;
        let asked = Instant::now();
        assert_eq!(service.post(&format!("/v1/jobs/{id}/cancel")).await.status(), 202);
        asked
    };
    let ((response, answered), asked) = tokio::join!(waits, cancels);
    assert_eq!(response.status(), 200);
    let job: Value = response.json().await.unwrap();
    assert_eq!(job["cancel_requested"], true);
    assert!(answered - asked < BEFORE_ITS_END, "{:?}", answered - asked);
    service.end().await;
}

#[tokio::test]
async fn a_finished_job_is_answered_at_once() {
    let service = TestService::start(&[]).await;
    let id = service.submit(json!({"points": 1})).await;
    service.until_final(&id).await;
    let path = format!("/v1/jobs/{id}?wait={WAIT_S}");
    let began = Instant::now();
    let response = get(&service, &path, None).await;
    assert_eq!(response.status(), 200);
    let etag = etag_of(&response);
    assert_eq!(get(&service, &path, Some(&etag)).await.status(), 304);
    assert_eq!(get(&service, &path, Some(&HeaderValue::from_static("\"another\""))).await.status(), 200);
    assert!(began.elapsed() < BEFORE_ITS_END, "{:?}", began.elapsed());
    service.end().await;
}

#[tokio::test]
async fn a_wait_ends_before_the_time_limit_of_requests() {
    let service = TestService::start(&["--workers", "0", "--request-timeout-s", "2"]).await;
    let id = service.submit(json!({})).await;
    let response = get(&service, &format!("/v1/jobs/{id}?wait={WAIT_S}"), None).await;
    assert_eq!(response.status(), 200);
    service.end().await;
}

async fn upload(service: &TestService, content: &'static str) -> String {
    let response = service.client.post(format!("{}/v1/meshes", service.base)).body(content).send().await.unwrap();
    response.json::<Value>().await.unwrap()["id"].as_str().unwrap().to_owned()
}

async fn submit_batch(service: &TestService, n_jobs: usize, parameters: Value) -> String {
    let (source, target) = (upload(service, "source").await, upload(service, "target").await);
    let pair = json!({"source": {"mesh_id": source}, "target": {"mesh_id": target}});
    let batch = json!({"pairs": vec![pair; n_jobs], "parameters": parameters, "use_cache": false});
    let response = service.client.post(format!("{}/v1/batches", service.base)).json(&batch).send().await.unwrap();
    assert_eq!(response.status(), 202, "{}", response.text().await.unwrap());
    response.headers()["location"].to_str().unwrap().to_owned()
}

#[tokio::test]
async fn a_loop_on_a_batch_makes_one_request_a_second_and_sees_the_end_at_once() {
    let service = TestService::start(&["--workers", "1"]).await;
    let location = submit_batch(&service, 30, json!({"points": 1, "step_ms": 60})).await;
    let (began, mut n_requests, mut etag) = (Instant::now(), 0, None);
    loop {
        let response = get(&service, &format!("{location}?wait={WAIT_S}"), etag.as_ref()).await;
        assert_eq!(response.status(), 200);
        n_requests += 1;
        etag = Some(etag_of(&response));
        if response.json::<Value>().await.unwrap()["finished"] == true {
            break;
        }
    }
    let elapsed_s = began.elapsed().as_secs_f64();
    let jobs = service.json(&format!("{location}/jobs")).await;
    let last = jobs["jobs"].as_array().unwrap().iter().map(|job| age(&job["finished_at"])).min().unwrap();
    assert!(last < BEFORE_ITS_END, "seen {last:?} after the end");
    assert!(f64::from(n_requests) <= elapsed_s + 2.0, "{n_requests} requests in {elapsed_s} s");
    let began = Instant::now();
    assert_eq!(get(&service, &format!("{location}?wait={WAIT_S}"), etag.as_ref()).await.status(), 304, "finished");
    assert!(began.elapsed() < BEFORE_ITS_END, "{:?}", began.elapsed());
    service.end().await;
}

#[tokio::test]
async fn an_unchanged_batch_is_304_when_the_wait_is_over() {
    let service = TestService::start(&["--workers", "0"]).await;
    let location = submit_batch(&service, 2, json!({})).await;
    let etag = etag_of(&get(&service, &location, None).await);
    let began = Instant::now();
    assert_eq!(get(&service, &format!("{location}?wait=1"), Some(&etag)).await.status(), 304);
    assert!(began.elapsed() >= Duration::from_millis(900), "{:?}", began.elapsed());
    let path = format!("{location}?wait={WAIT_S}");
    let cancel = format!("{location}/cancel");
    let began = Instant::now();
    let (changed, _) = tokio::join!(get(&service, &path, Some(&etag)), service.post(&cancel));
    assert_eq!(changed.json::<Value>().await.unwrap()["finished"], true);
    assert!(began.elapsed() < BEFORE_ITS_END, "{:?}", began.elapsed());
    problem(service.get(&format!("{location}?wait=31")).await, 400, "invalid-query").await;
    service.end().await;
}

#[tokio::test]
async fn the_feed_of_changes_waits_for_the_next_one() {
    let service = TestService::start(&["--workers", "0"]).await;
    let began = Instant::now();
    let empty = service.json("/v1/changes?wait=1").await;
    assert_eq!((&empty["changes"], &empty["next_since"]), (&json!([]), &json!(0)));
    assert!(began.elapsed() >= Duration::from_millis(900), "{:?}", began.elapsed());

    let submits = async {
        tokio::time::sleep(Duration::from_millis(300)).await;
        service.submit(json!({})).await
    };
    let began = Instant::now();
    let waiting = format!("/v1/changes?since=0&wait={WAIT_S}");
    let (page, id) = tokio::join!(service.json(&waiting), submits);
    assert!(began.elapsed() < BEFORE_ITS_END, "{:?}", began.elapsed());
    assert_eq!((&page["changes"][0]["job_id"], &page["changes"][0]["state"]), (&json!(id), &json!("queued")));

    let began = Instant::now();
    let again = service.json(&format!("/v1/changes?since=0&wait={WAIT_S}")).await;
    assert_eq!(again["changes"].as_array().unwrap().len(), 1, "what is there already is answered at once");
    assert!(began.elapsed() < BEFORE_ITS_END, "{:?}", began.elapsed());
    problem(service.get("/v1/changes?wait=31").await, 400, "invalid-query").await;
    service.end().await;
}
