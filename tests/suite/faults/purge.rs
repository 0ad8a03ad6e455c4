//! A22: purged jobs are removed everywhere, permanently.

use super::client::{Client, id_of, steps};
use super::on_both;
use super::site::{Backend, SOON, Site};
use super::witness::Database;
use serde_json::json;
use std::time::{Duration, Instant};

on_both!(a22_purged_jobs_are_removed_everywhere);

async fn a22_purged_jobs_are_removed_everywhere(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&[]);
    let client = site.client(&node);
    let parameters = json!({"points": 5, "sign": 1, "seed": 22});
    let (status, job) = client.try_submit_files("its source", "its target", &parameters).await.unwrap();
    assert_eq!(status, 202, "{job}");
    let id = id_of(&job);
    client.until_succeeded(&id, SOON).await;
    let database = site.database().await;
    assert!(!database.tables_with(&id).await.is_empty());
    assert!(site.blobs().len() >= 3, "{:?}", site.blobs());
    let first = client.json(&format!("/v1/jobs/{id}/result")).await;
    // Another job, which must not be affected.
    let other = client.submit(steps(3, 1)).await;
    client.until_succeeded(&other, SOON).await;
    let neighbor = client.json(&format!("/v1/jobs/{other}/result")).await;

    assert_eq!(client.delete(&format!("/v1/jobs/{id}")).await.unwrap().status(), 204);
    let hash = |text: &str| blake3::hash(text.as_bytes()).to_hex().to_string();
    let began = Instant::now();
    // Blobs are removed soon after, by housekeeping at the latest.
    while site.blobs().iter().any(|name| *name == hash("its source") || *name == hash("its target")) {
        assert!(began.elapsed() < SOON, "{:?}", site.blobs());
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
    is_gone(&client, &database, &id).await;

    drop(node);
    let node = site.serve(&[]);
    let client = site.client(&node);
    is_gone(&client, &database, &id).await;
    assert_eq!(client.json(&format!("/v1/jobs/{other}/result")).await, neighbor);
    // The result is not cached either: an equal request is computed again.
    let (status, job) = client.try_submit_files("its source", "its target", &parameters).await.unwrap();
    assert_eq!(status, 202, "{job}");
    let again = client.until_succeeded(&id_of(&job), SOON).await;
    assert_ne!(again["cached"], true);
    let second = client.json(&format!("/v1/jobs/{}/result", id_of(&again))).await;
    assert_ne!(second["process"], first["process"], "the result names the process that computed it");
}

async fn is_gone(client: &Client, database: &Database, id: &str) {
    for part in ["", "/trace", "/result", "/correspondences"] {
        let status = client.get(&format!("/v1/jobs/{id}{part}")).await.unwrap().status();
        assert_eq!(status, 404, "{part}");
    }
    assert!(client.list().await.iter().all(|(listed, _)| listed != id));
    // The audit log records its submission and deletion, by its id alone.
    let mut tables = database.tables_with(id).await;
    tables.retain(|(table, _)| table != "audit");
    assert_eq!(tables, [], "rows are left");
}
