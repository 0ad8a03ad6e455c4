//! A client of a node that tolerates nodes being down for a while.

use crate::jobs_support::form;
use reqwest::Response;
use serde_json::{Value, json};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// An HTTP client of one node.
#[derive(Debug, Clone)]
pub(crate) struct Client {
    pub base: String,
    pub http: reqwest::Client,
}

impl Client {
    /// A client of the node at `base`.
    pub(crate) fn of(base: &str) -> Self {
        // The library has no default provider; each process sets one once.
        let _ = rustls::crypto::ring::default_provider().install_default();
        let http = reqwest::Client::builder().timeout(Duration::from_secs(60)).no_proxy().build().unwrap();
        Client { base: base.to_owned(), http }
    }

    pub(crate) async fn get(&self, path: &str) -> reqwest::Result<Response> {
        self.http.get(format!("{}{path}", self.base)).send().await
    }

    pub(crate) async fn post(&self, path: &str) -> reqwest::Result<Response> {
        self.http.post(format!("{}{path}", self.base)).send().await
    }

    pub(crate) async fn delete(&self, path: &str) -> reqwest::Result<Response> {
        self.http.delete(format!("{}{path}", self.base)).send().await
    }

    /// Submits a job; returns the status and the JSON body, if there is one.
    pub(crate) async fn try_submit(&self, parameters: &Value) -> reqwest::Result<(u16, Value)> {
        self.try_submit_files("source", "target", parameters).await
    }

    pub(crate) async fn try_submit_files(
        &self,
        source: &str,
        target: &str,
        parameters: &Value,
    ) -> reqwest::Result<(u16, Value)> {
        let parameters = unlike_others(parameters);
        let request = self.http.post(format!("{}/v1/jobs", self.base)).multipart(form(source, target, &parameters));
        let response = request.send().await?;
        let status = response.status().as_u16();
        Ok((status, response.json().await.unwrap_or(Value::Null)))
    }

    /// Submits and returns the id.
    pub(crate) async fn submit(&self, parameters: Value) -> String {
        let (status, body) = self.try_submit(&parameters).await.unwrap();
        assert_eq!(status, 202, "{body}");
        id_of(&body)
    }

    /// The JSON at a path; the status must be 200.
    pub(crate) async fn json(&self, path: &str) -> Value {
        let response = self.get(path).await.unwrap();
        assert_eq!(response.status(), 200, "{path}");
        response.json().await.unwrap()
    }

    pub(crate) async fn job(&self, id: &str) -> Value {
        self.json(&format!("/v1/jobs/{id}")).await
    }

    /// The job once `done` holds. Failed requests and statuses other than 200 are retried.
    pub(crate) async fn until(&self, id: &str, patience: Duration, done: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        let mut last = Value::Null;
        loop {
            if let Ok(response) = self.get(&format!("/v1/jobs/{id}")).await
                && response.status() == 200
                && let Ok(job) = response.json::<Value>().await
            {
                if done(&job) {
                    return job;
                }
                last = job;
            }
            assert!(began.elapsed() < patience, "after {:?} still {last}", began.elapsed());
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    }

    pub(crate) async fn until_running(&self, id: &str, patience: Duration) -> Value {
        self.until(id, patience, |job| job["state"] == "running").await
    }

    /// The job once it has `n` trace points.
    pub(crate) async fn until_traced(&self, id: &str, n: u64, patience: Duration) -> Value {
        self.until(id, patience, |job| job["progress"]["iteration"].as_u64() >= Some(n)).await
    }

    pub(crate) async fn until_final(&self, id: &str, patience: Duration) -> Value {
        self.until(id, patience, is_final).await
    }

    /// The job once it has finished; it must have succeeded.
    pub(crate) async fn until_succeeded(&self, id: &str, patience: Duration) -> Value {
        let job = self.until_final(id, patience).await;
        assert_eq!(job["state"], "succeeded", "{job}");
        job
    }

    /// Sequence numbers of all trace points, in the order of the pages.
    pub(crate) async fn seqs(&self, id: &str) -> Vec<u64> {
        let mut seqs: Vec<u64> = Vec::new();
        loop {
            let after = seqs.last().copied().unwrap_or(0);
            let page = self.json(&format!("/v1/jobs/{id}/trace?after_seq={after}&limit=500")).await;
            let points = page["points"].as_array().unwrap();
            if points.is_empty() {
                return seqs;
            }
            seqs.extend(points.iter().map(|point| point["seq"].as_u64().unwrap()));
        }
    }

    /// The ids and states of all jobs.
    pub(crate) async fn list(&self) -> Vec<(String, String)> {
        let (mut found, mut token) = (Vec::new(), String::new());
        loop {
            let page = self.json(&format!("/v1/jobs?page_size=500&page_token={token}")).await;
            found.extend(
                page["jobs"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .map(|job| (id_of(job), job["state"].as_str().unwrap().to_owned())),
            );
            match page["next_page_token"].as_str() {
                Some(next) if !next.is_empty() => token = next.to_owned(),
                _ => return found,
            }
        }
    }
}

/// The parameters with a unique seed, because an equal job would be answered with the result of an earlier one.
fn unlike_others(parameters: &Value) -> Value {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    let mut parameters = parameters.clone();
    if parameters.get("seed").is_none() {
        parameters["seed"] = json!(NEXT.fetch_add(1, Ordering::Relaxed));
    }
    parameters
}

/// Whether a job has ended.
pub(super) fn is_final(job: &Value) -> bool {
    job["state"] != "queued" && job["state"] != "running"
}

/// The id of a job.
pub(crate) fn id_of(job: &Value) -> String {
    job["id"].as_str().unwrap_or_else(|| panic!("no id in {job}")).to_owned()
}

/// Parameters of a job that emits `points` trace points at intervals of `step_ms`.
pub(crate) fn steps(points: u64, step_ms: u64) -> Value {
    json!({"points": points, "step_ms": step_ms})
}
