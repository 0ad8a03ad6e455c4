//! A9, A11, A20: concurrent requests, and consistency between nodes.

use super::client::{Client, id_of, is_final, steps};
use super::queue::{LONG, Queue};
use super::site::{Backend, SOON, Site};
use super::{length, on_both, on_postgres};
use crate::jobs_support::form;
use crate::store::is_lost;
use homolog::jobs::JobState;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::time::Duration;

on_both!(
    a09_one_idempotency_key_creates_one_job,
    a11_a_job_cancelled_at_any_moment_ends_once,
    a11_simultaneous_cancel_and_finish_agree,
);
on_postgres!(a20_every_node_knows_every_job);

async fn a09_one_idempotency_key_creates_one_job(backend: Backend) {
    let site = Site::open(backend);
    let first = site.serve(&["--workers", "0"]);
    // On SQLite one process answers; on PostgreSQL the requests go to different nodes and meet only in the database.
    let second = (backend == Backend::Postgres).then(|| site.serve(&["--workers", "0"]));
    let mut clients = vec![site.client(&first)];
    clients.extend(second.iter().map(|node| site.client(node)));
    let parameters = json!({"points": 1, "seed": 4711});
    let mut requests = tokio::task::JoinSet::new();
    for n in 0..50 {
        let (client, parameters) = (clients[n % clients.len()].clone(), parameters.clone());
        requests.spawn(async move { submit_with_key(&client, "the-key", &parameters).await });
    }
    let answers = requests.join_all().await;
    assert!(answers.iter().any(|(status, _)| *status == 202), "{answers:?}");
    for (status, body) in &answers {
        // Either the same answer, or the problem that the first request is still in progress.
        assert!([202, 409].contains(status), "{status}: {body}");
    }
    let again = submit_with_key(&clients[0], "the-key", &parameters).await;
    assert_eq!(again.0, 202, "{}", again.1);
    let ids: BTreeSet<_> = answers.iter().chain([&again]).filter(|(s, _)| *s == 202).map(|(_, b)| id_of(b)).collect();
    assert_eq!(ids.len(), 1, "{ids:?}");
    assert_eq!(clients[0].list().await.len(), 1);
    let other = submit_with_key(&clients[0], "the-key", &json!({"points": 2, "seed": 4711})).await;
    assert_eq!(other.0, 422, "another body under the same key: {}", other.1);
    assert_eq!(submit_with_key(&clients[0], "another-key", &parameters).await.0, 202);
    assert_eq!(clients[0].list().await.len(), 2);
}

async fn submit_with_key(client: &Client, key: &str, parameters: &Value) -> (u16, Value) {
    let request = client.http.post(format!("{}/v1/jobs", client.base)).header("Idempotency-Key", key);
    let response = request.multipart(form("source", "target", parameters)).send().await.unwrap();
    (response.status().as_u16(), response.json().await.unwrap_or(Value::Null))
}

async fn a11_a_job_cancelled_at_any_moment_ends_once(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "4"]);
    let client = site.client(&node);
    let n_jobs = length(48, 400);
    let mut ended = Vec::new();
    for n in 0..n_jobs {
        // From before the claim to after the end of the job.
        let id = client.submit([steps(1, 1), steps(8, 10), steps(60, 10)][n as usize % 3].clone()).await;
        tokio::time::sleep(Duration::from_millis(n % 24 * 5)).await;
        let response = client.post(&format!("/v1/jobs/{id}/cancel")).await.unwrap();
        let status = response.status().as_u16();
        let answer: Value = response.json().await.unwrap();
        let job = client.until_final(&id, SOON).await;
        match status {
            202 => assert!(["cancelled", "succeeded"].contains(&job["state"].as_str().unwrap()), "{job}"),
            409 => {
                assert_eq!((&job["state"], &answer["type"]), (&json!("succeeded"), &json!("/problems/job-finished")))
            }
            other => panic!("{other}: {answer}"),
        }
        if is_final(&answer) && answer["state"].is_string() && status == 202 {
            assert_eq!(answer["state"], job["state"], "a final state that was answered has changed");
        }
        ended.push(job);
    }
    tokio::time::sleep(Duration::from_secs(1)).await;
    for job in &ended {
        let now = client.job(&id_of(job)).await;
        assert_eq!((&now["state"], &now["finished_at"]), (&job["state"], &job["finished_at"]));
        let has_result = client.get(&format!("/v1/jobs/{}/result", id_of(job))).await.unwrap().status() == 200;
        assert_eq!(has_result, now["state"] == "succeeded");
    }
    let cancelled = ended.iter().filter(|job| job["state"] == "cancelled").count();
    assert!(cancelled > 0 && cancelled < ended.len(), "{cancelled} of {}: the moments do not differ", ended.len());
}

async fn a11_simultaneous_cancel_and_finish_agree(backend: Backend) {
    let site = Site::open(backend);
    let (worker, user) = (Queue { store: site.store().await }, Queue { store: site.store().await });
    let database = site.database().await;
    database.watch().await;
    for n in 0..length(60, 1_000) {
        let id = worker.add().await.unwrap();
        let lease = worker.claim("worker", LONG).await.unwrap().unwrap();
        let wants_result = n % 2 == 0;
        let finish = async {
            if wants_result { worker.finish(&lease, "done").await } else { worker.finish_cancelled(&lease).await }
        };
        let (finished, cancelled) = tokio::join!(finish, user.cancel(id));
        finished.unwrap();
        let state = worker.state(id).await;
        assert_eq!(state, if wants_result { JobState::Succeeded } else { JobState::Cancelled });
        if let Ok(seen) = cancelled {
            assert!(seen == JobState::Running || seen == state, "{seen:?} before {state:?}");
        }
        assert!(is_lost(worker.finish(&lease, "again").await));
        assert!(is_lost(worker.finish_cancelled(&lease).await));
        assert_eq!(worker.state(id).await, state);
    }
    let (jobs, results) = database.jobs_and_results().await;
    assert_eq!(jobs, results);
}

async fn a20_every_node_knows_every_job() {
    let site = Site::open(Backend::Postgres);
    let maker = site.serve(&["--workers", "1"]);
    let other = site.serve(&["--workers", "0"]);
    let (maker, other) = (site.client(&maker), site.client(&other));
    let id = maker.submit(steps(40, 25)).await;
    let job = other.job(&id).await;
    assert_eq!(job["id"], id.as_str());
    other.until_traced(&id, 5, SOON).await;
    let events = other.get(&format!("/v1/jobs/{id}/events")).await.unwrap();
    assert_eq!(events.status(), 200);
    let events = tokio::time::timeout(SOON, events.text()).await.expect("the stream ends with the job").unwrap();
    let seqs: Vec<u64> =
        events.lines().filter_map(|line| line.strip_prefix("id:")).filter_map(|id| id.trim().parse().ok()).collect();
    assert!(seqs.windows(2).all(|pair| pair[0] <= pair[1]), "{seqs:?}");
    assert!(events.contains("event: trace") || events.contains("event:trace"), "{events}");
    assert!(events.contains("event: done") || events.contains("event:done"), "{events}");
    other.until_succeeded(&id, SOON).await;
    let result = format!("/v1/jobs/{id}/result");
    assert_eq!(other.json(&result).await, maker.json(&result).await);
    assert_eq!(other.seqs(&id).await, (1..=40).collect::<Vec<_>>());

    let long = maker.submit(steps(1_000, 25)).await;
    other.until_running(&long, SOON).await;
    assert_eq!(other.post(&format!("/v1/jobs/{long}/cancel")).await.unwrap().status(), 202);
    let job = maker.until_final(&long, Duration::from_secs(5)).await;
    assert_eq!(job["state"], "cancelled");
}
