//! A24 and A25: a clock that is set, and processes that do not share their blobs.

use super::client::steps;
use super::node::NotStarted;
use super::outages::wrong_clock;
use super::site::{Backend, SOON, Site};
use super::{on_both, on_postgres};
use crate::store::{Fixture, LONG};
use homolog::jobs::{ClockState, Housekeeping, JobQueue, JobState, Retention, Retentions};
use serde_json::json;
use std::time::{Duration, Instant};

on_both!(
    a24_a_clock_that_is_set_back_keeps_the_order_of_the_queue,
    a24_a_lost_lease_of_a_clock_that_was_set_back_is_taken_back,
    a24_nothing_is_removed_after_a_jump_until_somebody_says_that_the_clock_is_right,
);
on_postgres!(a25_a_process_with_other_blobs_does_not_start, a25_an_input_that_is_gone_fails_its_job_by_name);

/// The clock three hours back is all that was stored three hours ahead.
async fn a24_a_clock_that_is_set_back_keeps_the_order_of_the_queue(backend: Backend) {
    let f = Fixture::open(backend).await;
    let database = f.site.database().await;
    let mut expected = Vec::new();
    for _ in 0..3 {
        expected.push(f.add(0).await.id);
    }
    database
        .execute("UPDATE jobs SET created_at = created_at + 10800000, scheduled_at = scheduled_at + 10800000")
        .await;
    for _ in 0..3 {
        expected.push(f.add(0).await.id);
    }
    let urgent = f.add(1).await.id;
    expected.insert(0, urgent);
    for (place, id) in expected.iter().enumerate() {
        let job = homolog::jobs::JobReader::get_job(f.store.as_ref(), &f.tenant, *id).await.unwrap();
        assert_eq!(job.queue_position, Some(place as u64 + 1));
    }
    let front: Vec<_> = f.store.front_of_queue(10).await.unwrap().iter().map(|job| job.id).collect();
    assert_eq!(front, expected);
    for id in expected {
        assert_eq!(f.claim(LONG).await.job_id, id, "by when they came, whatever the clock said");
    }
}

async fn a24_a_lost_lease_of_a_clock_that_was_set_back_is_taken_back(backend: Backend) {
    let f = Fixture::open(backend).await;
    let id = f.add(0).await.id;
    f.claim(LONG).await;
    assert_eq!(f.store.recover_expired().await.unwrap().total(), 0);
    let database = f.site.database().await;
    database.execute("UPDATE jobs SET lease_expires_at = lease_expires_at + 172800000").await;
    assert_eq!(f.store.recover_expired().await.unwrap().queued, 1, "a lease of two days is none");
    assert_eq!(f.state(id).await, JobState::Queued);
}

async fn a24_nothing_is_removed_after_a_jump_until_somebody_says_that_the_clock_is_right(backend: Backend) {
    let f = Fixture::open(backend).await;
    assert_eq!(f.store.check_clock(false).await.unwrap(), ClockState::Plausible);
    // The clock 900 days ahead is all that was stored 900 days back.
    let database = f.site.database().await;
    database.execute("UPDATE facts SET number = number - 77760000000 WHERE name = 'clock'").await;
    for store in [f.store.as_ref(), &f.another().await] {
        let found = store.check_clock(false).await.unwrap();
        assert!(matches!(found, ClockState::Jumped { by_ms: 77_750_000_000..78_000_000_000 }), "{found:?}");
        assert!(store.clock_has_jumped());
    }
    assert_eq!(f.store.check_clock(true).await.unwrap(), ClockState::Plausible);
    assert_eq!(f.another().await.check_clock(false).await.unwrap(), ClockState::Plausible);
    let retention = Retentions::new(Retention { results: Some(Duration::from_secs(86_400)), jobs: None }, &[], &[]);
    assert!(f.store.purge(&retention, 10, false).await.unwrap().is_nothing());
}

/// The service itself, whose clock jumps ahead by 900 days while it runs and when it starts again.
#[tokio::test]
#[ignore = "needs faketime"]
async fn a24_a_service_whose_clock_jumps_ahead_keeps_its_results() {
    let site = Site::open(Backend::Sqlite);
    let file = site.folder.path().join("clock");
    let set = |offset: &str| std::fs::write(&file, format!("{offset}\n")).unwrap();
    set("+0d");
    let mut clock = wrong_clock("+0d").expect("libfaketime; apt-get install faketime");
    clock.retain(|(name, _)| *name != "FAKETIME");
    clock.push(("FAKETIME_TIMESTAMP_FILE", file.to_str().unwrap().to_owned()));
    clock.push(("FAKETIME_NO_CACHE", "1".to_owned()));
    let kept: &[&str] = &["--retain-results-days", "30", "--retain-jobs-days", "60"];
    let mut node = site.node("serve", kept, &clock).unwrap_or_else(|NotStarted(log)| panic!("{log}"));
    let client = site.client(&node);
    let id = client.submit(steps(1, 1)).await;
    client.until_succeeded(&id, SOON).await;
    let clock_of = async |client: &super::client::Client| client.json("/readyz").await["dependencies"]["clock"].clone();
    assert_eq!(clock_of(&client).await, "ok");
    set("+900d");
    let began = Instant::now();
    while clock_of(&client).await != "jumped" {
        assert!(began.elapsed() < SOON, "{}", node.log());
        tokio::time::sleep(Duration::from_millis(200)).await;
    }
    assert!(node.log().contains("the clock has jumped"), "{}", node.log());
    let metrics = client.get("/metrics").await.unwrap().text().await.unwrap();
    assert!(metrics.contains("homolog_clock_jumped 1"), "{metrics}");
    // Jobs go on, and nothing was removed; nor by a process that starts now.
    let later = client.submit(steps(1, 1)).await;
    client.until_succeeded(&later, SOON).await;
    node.kill();
    let node = site.node("serve", kept, &clock).unwrap_or_else(|NotStarted(log)| panic!("{log}"));
    let client = site.client(&node);
    tokio::time::sleep(Duration::from_secs(3)).await;
    assert_eq!(clock_of(&client).await, "jumped");
    assert!(client.get(&format!("/v1/jobs/{id}/result")).await.unwrap().status().is_success());
    // Three hours back: what was queued before runs, too.
    drop(node);
    set("+0d");
    let node = site.node("serve", &["--workers", "0"], &clock).unwrap_or_else(|NotStarted(log)| panic!("{log}"));
    let client = site.client(&node);
    let waiting = client.submit(steps(1, 1)).await;
    drop(node);
    set("-3h");
    let node = site.node("serve", kept, &clock).unwrap_or_else(|NotStarted(log)| panic!("{log}"));
    site.client(&node).until_succeeded(&waiting, SOON).await;
}

async fn a25_a_process_with_other_blobs_does_not_start() {
    let site = Site::open(Backend::Postgres);
    let _front = site.serve(&["--workers", "0"]);
    let _same = site.worker(&[]);
    let environment = site.environment();
    let (_, url) = environment.iter().find(|(name, _)| *name == "HOMOLOG_ARTIFACTS_URL").unwrap();
    let other = [("HOMOLOG_ARTIFACTS_URL", format!("{}/elsewhere", url.trim_end_matches('/')))];
    for role in ["worker", "serve"] {
        let Err(NotStarted(log)) = site.node(role, &[], &other) else { panic!("a {role} with other blobs started") };
        assert!(log.contains("its mark is missing") && log.contains("--artifacts-url"), "{log}");
    }
}

async fn a25_an_input_that_is_gone_fails_its_job_by_name() {
    let site = Site::open(Backend::Postgres);
    let front = site.serve(&["--workers", "0"]);
    let client = site.client(&front);
    let id = client.submit(steps(1, 1)).await;
    // What another process finds whose store lost the blob.
    let hash = site.database().await.texts("SELECT source FROM jobs").await.remove(0);
    let hash = serde_json::from_str::<serde_json::Value>(&hash).unwrap()["hash"].as_str().unwrap().to_owned();
    let key = homolog::jobs::ArtifactKey::of_hash(&homolog::jobs::Tenant::default(), &hash).unwrap();
    site.artifacts().remove(&key).await.unwrap();
    let _worker = site.worker(&[]);
    let job = client.until_final(&id, SOON).await;
    assert_eq!((&job["state"], &job["error"]["type"]), (&json!("failed"), &json!("/problems/input-missing")), "{job}");
    let detail = job["error"]["detail"].as_str().unwrap();
    assert!(detail.contains("source") && detail.contains(&hash), "{detail}");
}
