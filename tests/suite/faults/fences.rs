//! A2, A3, A8, A16: leases and their fencing.

use super::client::steps;
use super::queue::{LONG, Queue, SHORT};
use super::site::{Backend, SOON, Site};
use super::{length, on_both};
use crate::store::is_lost;
use homolog::jobs::{JobState, LeaseStatus};
use serde_json::json;
use std::collections::HashSet;
use std::time::Duration;

on_both!(
    a02_a_worker_that_slept_past_its_lease_changes_nothing,
    a02_without_the_fence_a_result_would_be_accepted_twice,
    a03_a_worker_restarted_under_its_name_inherits_no_lease,
    a08_no_job_is_claimed_twice_in_one_epoch,
    a16_one_stuck_among_many_running_jobs_is_rescued,
    a16_many_running_jobs_keep_their_leases,
);

async fn a02_a_worker_that_slept_past_its_lease_changes_nothing(backend: Backend) {
    let site = Site::open(backend);
    let front = site.serve(&["--workers", "0"]);
    let client = site.client(&front);
    let database = site.database().await;
    database.watch().await;
    let stale = site.worker(&[]);
    // The result contains the identity of its process, so that results of two workers are different blobs.
    let id = client.submit(json!({"points": 80, "step_ms": 25, "sign": 1})).await;
    client.until_traced(&id, 20, SOON).await;
    database.freeze(&stale).await;
    let _fresh = site.worker(&[]);
    client.until(&id, SOON, |job| job["attempt"] == 2).await;
    let accepted = client.until_succeeded(&id, SOON).await;
    let result = client.json(&format!("/v1/jobs/{id}/result")).await;
    let blobs = site.blobs();

    stale.thaw();
    stale.until_logged("lease lost", SOON).await;
    // Time for any late write of the worker.
    tokio::time::sleep(Duration::from_secs(1)).await;
    assert_eq!(client.job(&id).await, accepted);
    assert_eq!(client.json(&format!("/v1/jobs/{id}/result")).await, result);
    assert_eq!(client.seqs(&id).await, (1..=80).collect::<Vec<_>>());
    assert_eq!(site.blobs(), blobs);
    assert_eq!(database.n_results(&id).await, 1);
    assert_eq!(database.claims().await, (2, 2));
}

async fn a02_without_the_fence_a_result_would_be_accepted_twice(backend: Backend) {
    let site = Site::open(backend);
    let queue = Queue { store: site.store().await };
    let database = site.database().await;
    database.watch().await;
    let id = queue.add().await.unwrap();
    let stale = queue.claim("sleeper", SHORT).await.unwrap().unwrap();
    queue.append(&stale, 1..=3).await.unwrap();
    assert_eq!(queue.expire().await.queued, 1);
    let fresh = queue.claim("successor", LONG).await.unwrap().unwrap();
    assert!(fresh.epoch > stale.epoch);
    queue.append(&fresh, 1..=2).await.unwrap();

    assert!(is_lost(queue.append(&stale, 4..=5).await));
    assert!(is_lost(queue.hold(&stale, "stale").await));
    assert!(is_lost(queue.finish(&stale, "stale").await));
    assert_eq!(queue.heartbeat(&stale).await.unwrap(), LeaseStatus::Lost);
    queue.finish(&fresh, "fresh").await.unwrap();
    assert!(is_lost(queue.finish(&stale, "stale").await));
    assert!(is_lost(queue.append(&stale, 4..=5).await));
    assert_eq!(queue.seqs(id).await, [1, 2]);
    assert_eq!(queue.result_hash(id).await, blake3::hash(b"fresh").to_hex().to_string());
    assert_eq!(database.n_results(&id.to_string()).await, 1);

    // Control experiment: without the fence a second result is accepted, and the witness detects it.
    database.execute(&format!("UPDATE jobs SET state = 'succeeded' WHERE id = '{id}'")).await;
    assert_eq!(database.n_results(&id.to_string()).await, 2);
}

async fn a03_a_worker_restarted_under_its_name_inherits_no_lease(backend: Backend) {
    let site = Site::open(backend);
    let queue = Queue { store: site.store().await };
    let id = queue.add().await.unwrap();
    let before = queue.claim("worker-0", SHORT).await.unwrap().unwrap();
    queue.append(&before, 1..=3).await.unwrap();
    assert_eq!(queue.expire().await.queued, 1);
    let after = queue.claim("worker-0", LONG).await.unwrap().unwrap();

    assert_eq!(queue.heartbeat(&before).await.unwrap(), LeaseStatus::Lost);
    assert_eq!(queue.store.lease_status(&before).await.unwrap(), LeaseStatus::Lost);
    assert!(is_lost(queue.append(&before, 4..=4).await));
    assert!(is_lost(queue.finish(&before, "before").await));
    assert!(is_lost(queue.finish_cancelled(&before).await));
    assert!(is_lost(queue.store.release_job(&before).await));
    assert_eq!(queue.state(id).await, JobState::Running);
    queue.append(&after, 1..=1).await.unwrap();
    queue.finish(&after, "after").await.unwrap();
    assert_eq!(queue.result_hash(id).await, blake3::hash(b"after").to_hex().to_string());
    assert_eq!(queue.seqs(id).await, [1]);
}

async fn a08_no_job_is_claimed_twice_in_one_epoch(backend: Backend) {
    let site = Site::open(backend);
    let queue = Queue { store: site.store().await };
    let database = site.database().await;
    database.watch().await;
    let n_jobs = length(400, 5_000) as usize;
    let mut adding = tokio::task::JoinSet::new();
    for _ in 0..8 {
        let queue = queue.clone();
        adding.spawn(async move {
            for _ in 0..n_jobs / 8 {
                queue.add().await.unwrap();
            }
        });
    }
    adding.join_all().await;
    let mut claiming = tokio::task::JoinSet::new();
    for n in 0..8 {
        // Each with separate connections, as in another process.
        let queue = Queue { store: site.store().await };
        claiming.spawn(async move {
            let (name, mut claimed) = (format!("worker-{n}"), Vec::new());
            while let Some(lease) = queue.claim(&name, LONG).await.unwrap() {
                // Released from time to time, so that there are later epochs too.
                if lease.epoch == 1 && claimed.len() % 7 == 0 {
                    queue.store.release_job(&lease).await.unwrap();
                } else {
                    queue.finish(&lease, "done").await.unwrap();
                }
                claimed.push((lease.job_id, lease.epoch));
            }
            claimed
        });
    }
    let claimed = claiming.join_all().await.concat();
    let distinct: HashSet<_> = claimed.iter().collect();
    assert_eq!(distinct.len(), claimed.len());
    assert_eq!(claimed.iter().filter(|(_, epoch)| *epoch == 1).count(), n_jobs);
    assert_eq!(database.claims().await, (claimed.len() as i64, claimed.len() as i64));
    assert_eq!(database.jobs_and_results().await, (n_jobs as i64, n_jobs as i64));
}

/// Only the lease shows that a worker is stuck: there is no run time limit, and its process is still alive.
async fn a16_one_stuck_among_many_running_jobs_is_rescued(backend: Backend) {
    let site = Site::open(backend);
    let queue = Queue { store: site.store().await };
    for _ in 0..500 {
        queue.add().await.unwrap();
    }
    let mut stuck = None;
    for n in 0..500 {
        let lease = queue.claim("worker", if n == 250 { SHORT } else { LONG }).await.unwrap().unwrap();
        if n == 250 {
            stuck = Some(lease);
        }
    }
    let stuck = stuck.unwrap();
    let keeper = site.serve(&["--workers", "0"]);
    let client = site.client(&keeper);
    let id = stuck.job_id.to_string();
    client.until(&id, SOON, |job| job["state"] == "queued").await;
    // A job whose worker was lost waits a moment before it runs again.
    let began = std::time::Instant::now();
    let lease = loop {
        match queue.claim("rescuer", LONG).await.unwrap() {
            Some(lease) => break lease,
            None => tokio::time::sleep(Duration::from_millis(100)).await,
        }
        assert!(began.elapsed() < SOON);
    };
    assert_eq!((lease.job_id, lease.epoch), (stuck.job_id, stuck.epoch + 1));
    let states = client.list().await;
    assert_eq!(states.iter().filter(|(_, state)| state == "running").count(), 500);
}

/// A single heartbeat thread renews all leases of a worker that runs many jobs at once.
async fn a16_many_running_jobs_keep_their_leases(backend: Backend) {
    let site = Site::open(backend);
    let slots = length(40, 100);
    let node = site.serve(&["--workers", &slots.to_string(), "--lease-ms", "4000", "--heartbeat-ms", "1000"]);
    let client = site.client(&node);
    let mut ids = Vec::new();
    for _ in 0..slots {
        ids.push(client.submit(steps(40, 200)).await);
    }
    for id in &ids {
        let job = client.until_succeeded(id, SOON * 3).await;
        assert_eq!(job["attempt"], 1, "a lease was lost: {job}");
    }
}
