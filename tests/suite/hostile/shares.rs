//! Limits of a tenant: requests a second, stored bytes, running jobs. Above them, requests are refused with the
//! numbers, and jobs wait.

use crate::cli::homolog;
use crate::jobs_support::{TestService, form, problem};
use crate::store::{Fixture, LONG, new_job, on_every_store, room};
use homolog::jobs::{JobQueue as _, JobReader as _, JobWriter as _, NewJob, Tenant, WorkerId};
use homolog::store::sql::{SqlStore, StoreSettings};
use serde_json::json;
use std::time::Duration;

async fn key(service: &TestService, tenant: &str) -> String {
    let mut command = homolog();
    command.args(["keys", "create", "--tenant", tenant, "--data-dir"]).arg(service.folder.path());
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    assert!(done.status.success(), "{done:?}");
    String::from_utf8(done.stdout).unwrap().trim().to_owned()
}

#[tokio::test]
async fn a_tenant_that_sends_too_many_requests_is_told_when_to_send_the_next() {
    let service = TestService::start(&["--auth", "keys", "--max-request-rate", "2", "--workers", "0"]).await;
    let [hasty, calm] = [key(&service, "hasty").await, key(&service, "calm").await];
    let ask = async |key: &str| {
        service.client.get(format!("{}/v1/jobs", service.base)).bearer_auth(key).send().await.unwrap()
    };
    let mut answers = Vec::new();
    for _ in 0..60 {
        answers.push(ask(&hasty).await);
    }
    let n_accepted = answers.iter().filter(|answer| answer.status() == 200).count();
    assert!((20..=50).contains(&n_accepted), "{n_accepted} of 60");
    let refused = answers.pop().unwrap();
    let wait: u64 = refused.headers()["retry-after"].to_str().unwrap().parse().unwrap();
    let refused = problem(refused, 429, "too-many-requests").await;
    assert_eq!((&refused["limit_per_s"], wait), (&json!(2), 1), "{refused}");
    assert_eq!(ask(&calm).await.status(), 200, "the other tenant has a rate of its own");
    assert_eq!(service.get("/healthz").await.status(), 200);
    tokio::time::sleep(Duration::from_secs(wait)).await;
    assert_eq!(ask(&hasty).await.status(), 200);
    service.end().await;
}

#[tokio::test]
async fn a_tenant_that_has_stored_its_share_is_refused_with_the_numbers() {
    let service = TestService::start(&["--max-stored-bytes", "1000", "--workers", "0"]).await;
    let upload = async |letter: &str| {
        service.client.post(format!("{}/v1/meshes", service.base)).body(letter.repeat(600)).send().await.unwrap()
    };
    let first = upload("a").await;
    assert_eq!(first.status(), 201);
    let location = first.headers()["location"].to_str().unwrap().to_owned();
    assert_eq!(upload("a").await.status(), 200, "what is stored already takes nothing more");
    let refused = upload("b").await;
    assert!(refused.headers().contains_key("retry-after"));
    let refused = problem(refused, 507, "storage-share-full").await;
    assert_eq!((&refused["stored_bytes"], &refused["limit_bytes"]), (&json!(600), &json!(1000)));
    let large = service.send(form(&"c".repeat(300), &"d".repeat(300), &json!({}))).await;
    problem(large, 507, "storage-share-full").await;
    assert_eq!(service.send(form(&"c".repeat(200), &"d".repeat(190), &json!({}))).await.status(), 202);
    problem(service.send(form(&"e".repeat(20), "f", &json!({}))).await, 507, "storage-share-full").await;
    assert_eq!(service.delete(&location).await.status(), 204);
    tokio::time::sleep(Duration::from_millis(1_100)).await;
    assert_eq!(upload("b").await.status(), 201, "there is room again");
    service.end().await;
}

async fn no_tenant_runs_more_jobs_than_it_may(f: Fixture) {
    let of = |name: &str| NewJob { tenant: Tenant::new(name).unwrap(), ..new_job(0) };
    for tenant in ["greedy", "greedy", "greedy", "greedy", "greedy", "greedy", "modest"] {
        f.store.insert_job(&of(tenant), &room(100)).await.unwrap();
    }
    let open = async || {
        let settings = StoreSettings { max_running: Some(2), ..StoreSettings::default() };
        SqlStore::open(&f.site.location()).await.unwrap().with(settings)
    };
    // Many concurrent processes, each of which sees all jobs.
    let mut claimers = Vec::new();
    for _ in 0..6 {
        let store = open().await;
        claimers.push(tokio::spawn(async move {
            let mut claimed = Vec::new();
            for _ in 0..6 {
                claimed.extend(store.claim_next(&WorkerId::random(), LONG, LONG).await.unwrap());
            }
            claimed
        }));
    }
    let mut running = Vec::new();
    for claimer in claimers {
        running.extend(claimer.await.unwrap().into_iter().map(|leased| leased.job.tenant.name().to_owned()));
    }
    running.sort();
    assert_eq!(running, ["greedy", "greedy", "modest"]);
    assert_eq!(f.store.load().await.unwrap().queued, 4, "the others wait");
    let store = open().await;
    assert!(store.front_of_queue(10).await.unwrap().is_empty());
    assert!(store.claim_next(&f.worker, LONG, LONG).await.unwrap().is_none());
}

async fn stored_bytes_count_each_blob_once(f: Fixture) {
    use homolog::jobs::{ArtifactKey, MeshStore as _};
    let other = Tenant::new("other").unwrap();
    assert_eq!(f.store.stored_bytes(&f.tenant).await.unwrap(), 0);
    // Both inputs of every such job are the same blobs of one byte.
    f.add(0).await;
    f.add(0).await;
    assert_eq!(f.store.stored_bytes(&f.tenant).await.unwrap(), 2);
    f.store.insert_mesh(&ArtifactKey::of(&f.tenant, b"mesh"), 4, None, "").await.unwrap();
    f.store.insert_mesh(&ArtifactKey::of(&other, b"larger"), 6, None, "").await.unwrap();
    assert_eq!(f.store.stored_bytes(&f.tenant).await.unwrap(), 6);
    assert_eq!(f.store.stored_bytes(&other).await.unwrap(), 6);
}

on_every_store! {
    no_tenant_runs_more_jobs_than_it_may,
    stored_bytes_count_each_blob_once,
}
