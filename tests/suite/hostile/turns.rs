//! One tenant with many jobs, and the effect on another tenant.

use crate::jobs_support::{TestService, form};
use crate::patience::PATIENCE;
use serde_json::{Value, json};

/// A client of a tenant.
struct Tenant<'a> {
    service: &'a TestService,
    key: String,
}

impl<'a> Tenant<'a> {
    async fn new(service: &'a TestService, name: &str) -> Self {
        let mut command = crate::cli::homolog();
        command.args(["keys", "create", "--tenant", name, "--data-dir"]).arg(service.folder.path());
        // Not on this thread: the service that runs on it may hold the database for which the command waits.
        let output = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
        Tenant { service, key: String::from_utf8(output.stdout).unwrap().trim().to_owned() }
    }

    async fn submit(&self, seed: u64, priority: i32) -> Value {
        let form = form("a", "b", &json!({"seed": seed, "points": 2, "step_ms": 40}));
        let request = self.service.client.post(format!("{}/v1/jobs", self.service.base)).bearer_auth(&self.key);
        request.multipart(form.text("priority", priority.to_string())).send().await.unwrap().json().await.unwrap()
    }

    async fn get(&self, path: &str) -> Value {
        let request = self.service.client.get(format!("{}{path}", self.service.base)).bearer_auth(&self.key);
        request.send().await.unwrap().json().await.unwrap()
    }

    async fn n_in(&self, state: &str) -> usize {
        self.get(&format!("/v1/jobs?state={state}&page_size=500")).await["jobs"].as_array().unwrap().len()
    }
}

#[tokio::test]
async fn tenants_take_turns_whatever_their_priorities() {
    let service = TestService::start(&["--auth", "keys", "--workers", "1"]).await;
    let (many, few) = (Tenant::new(&service, "many").await, Tenant::new(&service, "few").await);
    for seed in 0..40 {
        many.submit(seed, 100).await;
    }
    let job = few.submit(0, -100).await;
    let path = format!("/v1/jobs/{}", job["id"].as_str().unwrap());
    let n_before = many.n_in("succeeded").await;
    let began = std::time::Instant::now();
    while few.get(&path).await["state"] != "succeeded" {
        assert!(began.elapsed() < PATIENCE, "it waits behind the other tenant");
        tokio::time::sleep(std::time::Duration::from_millis(10)).await;
    }
    let n_between = many.n_in("succeeded").await - n_before;
    assert!(n_between <= 4, "{n_between} jobs of the other tenant went first");
    service.end().await;
}

#[tokio::test]
async fn a_tenant_of_greater_weight_gets_more_turns() {
    let service = TestService::start(&["--auth", "keys", "--workers", "1", "--tenant-weight", "heavy=3,light=1"]).await;
    let (heavy, light) = (Tenant::new(&service, "heavy").await, Tenant::new(&service, "light").await);
    for seed in 0..30 {
        heavy.submit(seed, 0).await;
        light.submit(seed, 0).await;
    }
    let before = (heavy.n_in("succeeded").await, light.n_in("succeeded").await);
    let began = std::time::Instant::now();
    while light.n_in("succeeded").await < before.1 + 4 {
        assert!(began.elapsed() < PATIENCE);
        tokio::time::sleep(std::time::Duration::from_millis(10)).await;
    }
    let n_heavy = heavy.n_in("succeeded").await - before.0;
    assert!((9..=16).contains(&n_heavy), "{n_heavy} for 4");
    service.end().await;
}

#[tokio::test]
async fn numbers_tell_nothing_about_other_tenants() {
    let service = TestService::start(&["--auth", "keys", "--workers", "0"]).await;
    let (own, other) = (Tenant::new(&service, "own").await, Tenant::new(&service, "other").await);
    let mut positions = Vec::new();
    for seed in 0..5 {
        for more in 0..3 {
            other.submit(100 + 3 * seed + more, 100).await;
        }
        let job = own.submit(seed, 0).await;
        let job = own.get(&format!("/v1/jobs/{}", job["id"].as_str().unwrap())).await;
        positions.push(job["queue_position"].as_u64().unwrap());
    }
    assert_eq!(positions, [1, 2, 3, 4, 5]);
    let changes = own.get("/v1/changes").await;
    let numbers: Vec<u64> = changes["changes"].as_array().unwrap().iter().map(|c| c["seq"].as_u64().unwrap()).collect();
    assert_eq!(numbers, [1, 2, 3, 4, 5]);
    assert_eq!(own.get("/v1/changes?since=3").await["changes"].as_array().unwrap().len(), 2);
    service.end().await;
}
