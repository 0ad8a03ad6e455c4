//! A24 and A25: a clock that is set, and processes that do not share their blobs.

use super::client::steps;
use super::node::NotStarted;
use super::outages::wrong_clock;
use super::site::{Backend, SOON, Site};
use super::{on_both, on_postgres};
use crate::store::{Fixture, LONG};
use homolog::jobs::{
    ArtifactKey, Attempted, BlobHolds, ClockState, Housekeeping, IdempotencyKey, JobQueue, JobState, JobWriter,
    KeyStore, OnceStatus, Retention, Retentions, Ticket, TurnLimits, Webhook, WebhookStore,
};
use serde_json::json;
use std::time::{Duration, Instant};

on_both!(
    a24_a_clock_that_is_set_back_keeps_the_order_of_the_queue,
    a24_a_lost_lease_of_a_clock_that_was_set_back_is_taken_back,
    a24_no_wait_is_longer_after_the_clock_was_set_back_than_it_was_meant_to_be,
    a24_nothing_is_removed_after_a_jump_until_somebody_says_that_the_clock_is_right,
);
on_postgres!(a25_a_process_with_other_blobs_does_not_start, a25_an_input_that_is_gone_fails_its_job_by_name);

/// Setting the clock back is simulated by moving all stored times three hours ahead.
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

/// Every stored wait: table, column, and its longest duration, ms. Each of them exists when the clock is set back; for
/// webhooks and run times the duration is stored in the row.
const WAITS: [(&str, &str, i64); 8] = [
    ("webhook_deliveries", "next_at", 7_000),
    ("webhooks", "next_at", 9_000),
    ("blobs", "removing_since", 0),
    ("blob_holds", "expires_at", 3_600_000),
    ("idempotency_keys", "expires_at", 10_000),
    ("tickets", "expires_at", 60_000),
    ("jobs", "lease_expires_at", 3_600_000),
    ("jobs", "run_deadline_at", 60_000),
];

async fn a24_no_wait_is_longer_after_the_clock_was_set_back_than_it_was_meant_to_be(backend: Backend) {
    let f = Fixture::open(backend).await;
    let database = f.site.database().await;
    // A running job, a hold, a request in progress, a ticket, a blob whose removal has begun, and a delivery that is
    // retried.
    f.add(0).await;
    f.claim(LONG).await;
    let key = ArtifactKey::of(&f.tenant, b"held");
    f.store.hold_blobs("holder", std::slice::from_ref(&key), LONG, None).await.unwrap();
    let once = IdempotencyKey {
        tenant: f.tenant.clone(),
        name: "key".to_owned(),
        fingerprint: "f".to_owned(),
        token: "t".to_owned(),
        keep_for: LONG,
    };
    assert_eq!(f.store.begin_once(&once, Duration::from_secs(5)).await.unwrap(), OnceStatus::Begun);
    let ticket = Ticket { tenant: f.tenant.clone(), key_id: None, path: "/v1/events".to_owned() };
    assert!(f.store.insert_ticket("hash", &ticket, Duration::from_secs(30), 9).await.unwrap());
    database.execute("UPDATE blobs SET removing_since = (SELECT MAX(created_at) FROM jobs)").await;
    let webhook = Webhook {
        id: "0195d1a0-0000-7000-8000-000000000001".to_owned(),
        tenant: f.tenant.clone(),
        url: "https://example.org/hook".to_owned(),
        states: Vec::new(),
        secret: "whsec_AAAA".to_owned(),
        is_enabled: true,
        disabled_because: None,
        created_at: jiff::Timestamp::UNIX_EPOCH,
    };
    f.store.insert_webhook(&webhook, 9).await.unwrap().unwrap();
    f.store.insert_delivery(&f.tenant, &webhook.id, "test", "{}").await.unwrap();
    let limits = TurnLimits { busy_for: LONG, of_tenant: 1, deliveries: 8 };
    let turn = f.store.claim_turn(&limits).await.unwrap().unwrap();
    let again = Attempted::Retry { after: Duration::from_secs(7), status: None, error: "e".to_owned() };
    f.store.end_attempt(&turn.deliveries[0].id, &again).await.unwrap();
    f.store.end_turn(&webhook.id, 4, Duration::from_secs(9)).await.unwrap();
    assert_eq!(f.store.bound_waits().await.unwrap(), 0, "no wait is too long while the clock goes on");

    // Setting the clock back is simulated by moving all stored times three hours ahead.
    for (table, column, _) in WAITS {
        database.execute(&format!("UPDATE {table} SET {column} = {column} + 10800000")).await;
    }
    database.execute("UPDATE jobs SET started_at = started_at + 10800000").await;
    assert!(f.store.claim_turn(&limits).await.unwrap().is_none());
    assert_eq!(f.store.bound_waits().await.unwrap(), WAITS.len() as u64);
    assert_eq!(f.store.bound_waits().await.unwrap(), 0);
    for (table, column, longest) in WAITS {
        // A job was created at the present time or before it.
        let wait = format!("SELECT MAX({column}) - (SELECT MAX(created_at) FROM jobs) FROM {table}");
        let wait = database.number(&wait).await;
        let slack = i64::try_from(SOON.as_millis()).unwrap();
        assert!(wait <= longest + slack, "{table}.{column} waits {wait} ms, not {longest}");
        assert!(wait >= longest, "{table}.{column} waits {wait} ms, less than it was meant to");
    }
    // A turn that ended with its process does not wait any longer either.
    database.execute("UPDATE webhook_deliveries SET next_at = 0").await;
    database.execute("UPDATE webhooks SET next_at = 0").await;
    f.store.claim_turn(&limits).await.unwrap().unwrap();
    database.execute("UPDATE webhooks SET next_at = next_at + 10800000, busy_until = busy_until + 10800000").await;
    f.store.bound_waits().await.unwrap();
    let busy = database.number("SELECT busy_until - (SELECT MAX(created_at) FROM jobs) FROM webhooks").await;
    assert!(busy < 10_800_000 / 2, "{busy} ms");
}

async fn a24_nothing_is_removed_after_a_jump_until_somebody_says_that_the_clock_is_right(backend: Backend) {
    let f = Fixture::open(backend).await;
    assert_eq!(f.store.check_clock(false).await.unwrap(), ClockState::Plausible);
    // A clock 900 days ahead is simulated by moving all stored times 900 days back.
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

/// The service itself, whose clock jumps 900 days ahead while it runs and when it starts again.
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
    // Jobs continue, and nothing is removed, not even by a process that starts now.
    let later = client.submit(steps(1, 1)).await;
    client.until_succeeded(&later, SOON).await;
    node.kill();
    let node = site.node("serve", kept, &clock).unwrap_or_else(|NotStarted(log)| panic!("{log}"));
    let client = site.client(&node);
    tokio::time::sleep(Duration::from_secs(3)).await;
    assert_eq!(clock_of(&client).await, "jumped");
    assert!(client.get(&format!("/v1/jobs/{id}/result")).await.unwrap().status().is_success());
    // Three hours back: jobs that were queued earlier also run.
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
    // Removes the blob of the source, as if the store of the worker had lost it.
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
