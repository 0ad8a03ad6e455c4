//! Promises on jobs while they run and when they end.

use super::{SOON, Served, array, steps, text};
use crate::faults::on_both;
use crate::faults::site::Backend;
use crate::jobs_support::problem;
use futures_util::StreamExt as _;
use reqwest::{Method, Response};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

on_both!(
    a_job_is_followed_by_polls_trace_and_events,
    cancel_is_prompt_and_a_retry_is_a_new_job,
    an_idle_stream_is_kept_alive_and_ends_with_the_service,
    results_are_not_ready_then_there_then_expired,
);

/// Name, id and data of each event, until the stream ends.
async fn events(response: Response) -> Vec<(String, String, Value)> {
    let text = tokio::time::timeout(SOON, response.text()).await.expect("the stream ends").unwrap();
    let event = |block: &str| {
        let field = |name: &str| block.lines().find_map(|line| Some(line.strip_prefix(name)?.trim().to_owned()));
        Some((field("event:")?, field("id:")?, serde_json::from_str(&field("data:")?).unwrap()))
    };
    text.split("\n\n").filter_map(event).collect()
}

async fn a_job_is_followed_by_polls_trace_and_events(backend: Backend) {
    let served = Served::start(backend, &[]);
    let id = served.client.submit(steps(40, 50)).await;
    let path = format!("/v1/jobs/{id}");
    let stream = tokio::spawn(served.client.http.get(served.url(&format!("{path}/events"))).send());
    served.client.until_running(&id, SOON).await;
    // A long poll answers when the job changes, before its time is over.
    let first = served.get(&path).await;
    let etag = first.headers()["etag"].to_str().unwrap().to_owned();
    let polled = served.send(Method::GET, &format!("{path}?wait=20"), &[("if-none-match", &etag)], None).await;
    assert_eq!(polled.status(), 200, "not 304 at the end of the wait");
    // The trace grows while the job runs, in order; progress does not decrease.
    let (mut after, mut seqs, mut fraction, mut n_live) = (0, Vec::new(), 0.0, 0);
    loop {
        let trace = served.expect(served.get(&format!("{path}/trace?after_seq={after}")).await, 200).await;
        let points = array(&trace, "points");
        seqs.extend(points.iter().map(|point| point["seq"].as_u64().unwrap()));
        after = trace["next_after_seq"].as_u64().unwrap();
        let job = served.client.job(&id).await;
        let now = job["progress"]["fraction"].as_f64().unwrap_or(0.0);
        assert!(now >= fraction, "{now} after {fraction}");
        fraction = now;
        n_live += u32::from(job["state"] == "running" && !points.is_empty());
        if trace["complete"] == true {
            break;
        }
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    assert_eq!(seqs, (1..=40).collect::<Vec<u64>>());
    assert!(n_live > 1, "live, not only at the end");
    // Events
    let all = events(stream.await.unwrap().unwrap()).await;
    let of = |name: &str| all.iter().filter(|event| event.0 == name).collect::<Vec<_>>();
    let traced: Vec<_> = of("trace").iter().map(|event| event.1.parse::<u64>().unwrap()).collect();
    assert_eq!(traced, (1..=40).collect::<Vec<_>>(), "the id of a point is its seq");
    assert!(!of("state").is_empty() && of("progress").len() > 1);
    assert_eq!((all.last().unwrap().0.as_str(), of("done").len()), ("done", 1));
    let later = served.send(Method::GET, &format!("{path}/events"), &[("last-event-id", "37")], None).await;
    let rest = events(later).await;
    let rest: Vec<_> = rest.iter().filter(|event| event.0 == "trace").map(|event| event.1.as_str()).collect();
    assert_eq!(rest, ["38", "39", "40"], "no gap and no repeat");
}

async fn cancel_is_prompt_and_a_retry_is_a_new_job(backend: Backend) {
    let served = Served::start(backend, &[]);
    let id = served.client.submit(steps(1000, 20)).await;
    served.client.until_running(&id, SOON).await;
    problem(served.client.delete(&format!("/v1/jobs/{id}")).await.unwrap(), 409, "job-active").await;
    served.expect(served.client.post(&format!("/v1/jobs/{id}/cancel")).await.unwrap(), 202).await;
    let job = served.client.until_final(&id, SOON).await;
    assert_eq!((&job["state"], &job["cancel_requested"]), (&json!("cancelled"), &json!(true)));
    assert!(served.client.seqs(&id).await.len() < 1000, "before its end");
    let retried = served.client.post(&format!("/v1/jobs/{id}/retry")).await.unwrap();
    assert!(retried.headers().contains_key("location"));
    let retried = served.expect(retried, 202).await;
    assert_eq!(retried["retry_of"], id.as_str());
    assert_ne!(retried["id"], id.as_str());
    served.client.post(&format!("/v1/jobs/{}/cancel", text(&retried, "id"))).await.unwrap();
    served.client.until_final(text(&retried, "id"), SOON).await;
    for id in [id.as_str(), text(&retried, "id")] {
        assert_eq!(served.client.delete(&format!("/v1/jobs/{id}")).await.unwrap().status(), 204);
        for part in ["", "/trace", "/events", "/result", "/correspondences"] {
            problem(served.get(&format!("/v1/jobs/{id}{part}")).await, 404, "job-not-found").await;
        }
    }
    assert_eq!(served.site.blobs(), Vec::<String>::new(), "no blob is left");
}

async fn an_idle_stream_is_kept_alive_and_ends_with_the_service(backend: Backend) {
    let mut served = Served::start(backend, &["--workers", "0"]);
    let id = served.client.submit(json!({})).await;
    let stream = served.get(&format!("/v1/jobs/{id}/events")).await;
    let mut parts = stream.bytes_stream();
    let began = Instant::now();
    loop {
        let part = tokio::time::timeout(SOON, parts.next()).await.expect("a comment").unwrap().unwrap();
        if part.starts_with(b":") {
            break;
        }
        assert!(began.elapsed() < SOON);
    }
    served.node.terminate();
    let ended = async { while let Some(Ok(_)) = parts.next().await {} };
    tokio::time::timeout(SOON, ended).await.expect("the stream ends with the service");
    assert!(served.node.ended().await.0.success());
}

async fn results_are_not_ready_then_there_then_expired(backend: Backend) {
    let served = Served::start(backend, &["--retain-results-days", "0.00005"]);
    let id = served.client.submit(steps(60, 30)).await;
    served.client.until_running(&id, SOON).await;
    let path = format!("/v1/jobs/{id}/result");
    assert_eq!(problem(served.get(&path).await, 409, "result-not-ready").await["state"], "running");
    let job = served.client.until_succeeded(&id, SOON).await;
    assert!(job["expires_at"].is_string(), "{job}");
    served.expect(served.get(&path).await, 200).await;
    // The service also purges by itself, but not every second.
    tokio::time::sleep(Duration::from_secs(5)).await;
    let mut purge = crate::cli::homolog();
    purge.args(["purge", "--retain-results-days", "0.00005"]).envs(served.site.environment());
    let purged = tokio::task::spawn_blocking(move || purge.output()).await.unwrap().unwrap();
    assert!(purged.status.success(), "{}", String::from_utf8_lossy(&purged.stderr));
    problem(served.get(&path).await, 410, "expired").await;
    assert_eq!(served.client.job(&id).await["state"], "succeeded", "the job is kept");
    let failed = served.client.submit(json!({"fail": 1})).await;
    served.client.until_final(&failed, SOON).await;
    problem(served.get(&format!("/v1/jobs/{failed}/result")).await, 409, "no-result").await;
}
