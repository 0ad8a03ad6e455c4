//! The suite of stores, continued: records other than jobs, on SQLite with a folder and on PostgreSQL with an S3 server.

use super::jobs_support::doubtful;
use super::store::{Fixture, LONG, SHORT, chunk, is_lost, new_job, on_every_store, result, room};
use homolog::jobs::job::Order;
use homolog::jobs::metadata::{ExternalRef, Tags};
use homolog::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, Attempted, BatchId, BlobHolds, DeliveryState, Housekeeping,
    IdempotencyKey, JobError, JobFilter, JobQueue, JobReader, JobState, JobWriter, KeyStore, Made, MeshStore, NewBatch,
    NewJob, OnceStatus, Outcome, Overdue, PageRequest, Purged, Retention, Retentions, Scope, SecretKey, Tenant,
    TurnLimits, Webhook, WebhookStore, WorkerId,
};
use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

async fn an_equal_job_is_answered_from_the_first_result(f: Fixture) {
    let with_key = || NewJob { cache_key: Some("k".to_owned()), ..new_job(0) };
    let first = f.store.insert_job(&with_key(), &room(10)).await.unwrap();
    assert!(!f.store.insert_job(&with_key(), &room(10)).await.unwrap().cached, "there is no result yet");
    let lease = f.claim(LONG).await;
    assert_eq!(lease.job_id, first.id);
    f.store.append_trace(&lease, &chunk(1..=3)).await.unwrap();
    f.store.finish_job(&lease, &result('c'), None).await.unwrap();

    let second = f.store.insert_job(&with_key(), &room(10)).await.unwrap();
    assert_eq!((second.state, second.cached, second.attempt), (JobState::Succeeded, true, 0));
    assert_eq!(second.verdict, Some(doubtful()), "the verdict belongs to the result");
    let finished = f.store.get_job(&f.tenant, first.id).await.unwrap();
    assert_eq!((first.verdict, finished.verdict), (None, Some(doubtful())));
    assert!(second.finished_at.is_some());
    assert_eq!(f.seqs(second.id, 0, 10).await, [1, 2, 3]);
    f.store.delete_job(&f.tenant, first.id).await.unwrap();
    let (_, artifact) = f.store.get_artifact(&f.tenant, second.id, ArtifactKind::Result).await.unwrap();
    assert_eq!(artifact.unwrap().key.hash(), "c".repeat(64), "it no longer depends on the first job");

    for other in [
        NewJob { use_cache: false, ..with_key() },
        NewJob { cache_key: Some("other".to_owned()), ..new_job(0) },
        NewJob { cache_key: None, ..new_job(0) },
        NewJob { tenant: Tenant::new("other").unwrap(), ..with_key() },
    ] {
        assert_eq!(f.store.insert_job(&other, &room(10)).await.unwrap().state, JobState::Queued);
    }
}

async fn deadlines_and_run_time_limits_are_enforced(f: Fixture) {
    let now = jiff::Timestamp::now();
    let late = NewJob { deadline_at: Some(now), ..new_job(9) };
    let late = f.store.insert_job(&late, &room(10)).await.unwrap().id;
    let in_time = NewJob { deadline_at: Some(now + LONG), max_run_ms: Some(1), ..new_job(0) };
    let in_time = f.store.insert_job(&in_time, &room(10)).await.unwrap().id;
    tokio::time::sleep(SHORT).await;
    let lease = f.claim(LONG).await;
    assert_eq!(lease.job_id, in_time, "a job past its deadline is not started");
    tokio::time::sleep(SHORT).await;
    assert_eq!(f.store.end_overdue(LONG).await.unwrap(), Overdue { expired: 1, stuck: 0 });
    let job = f.store.get_job(&f.tenant, late).await.unwrap();
    assert_eq!((job.state, job.error.unwrap().code.as_str()), (JobState::Expired, "deadline-passed"));
    assert_eq!(f.store.end_overdue(Duration::ZERO).await.unwrap(), Overdue { expired: 0, stuck: 1 });
    let job = f.store.get_job(&f.tenant, in_time).await.unwrap();
    assert_eq!((job.state, job.error.unwrap().code.as_str()), (JobState::Failed, "run-time-exceeded"));
    assert!(is_lost(f.store.finish_job(&lease, &result('c'), None).await));
}

async fn changes_come_in_order_and_none_is_missed(f: Fixture) {
    let mut writers = tokio::task::JoinSet::new();
    for _ in 0..4 {
        let store = f.another().await;
        writers.spawn(async move {
            let worker = WorkerId::random();
            for _ in 0..15 {
                store.insert_job(&new_job(0), &room(1000)).await.unwrap();
                let leased = store.claim_next(&worker, LONG, LONG).await.unwrap();
                if let Some(leased) = leased {
                    store.finish_job(&leased.lease, &Outcome::Cancelled, None).await.unwrap();
                }
            }
        });
    }
    // Read while the writers run.
    let (mut seen, mut since) = (Vec::new(), 0);
    loop {
        let done = writers.is_empty();
        let page = f.store.list_changes(&f.tenant, since, 7).await.unwrap();
        since = page.next_since;
        seen.extend(page.changes);
        while writers.try_join_next().is_some() {}
        if done && !page.more {
            break;
        }
    }
    assert!(seen.windows(2).all(|w| w[0].seq < w[1].seq));
    let of = |state| seen.iter().filter(|c| c.state == state).count();
    assert_eq!(of(JobState::Queued), 60, "each job once");
    assert_eq!(of(JobState::Running), of(JobState::Cancelled));
    for change in &seen {
        let states: Vec<_> = seen.iter().filter(|c| c.job_id == change.job_id).map(|c| c.state).collect();
        assert!([JobState::Queued, JobState::Running, JobState::Cancelled].starts_with(&states), "{states:?}");
    }
    let other = Tenant::new("other").unwrap();
    assert!(f.store.list_changes(&other, 0, 10).await.unwrap().changes.is_empty());
}

async fn an_idempotency_key_is_used_once(f: Fixture) {
    let once = |fingerprint: &str| IdempotencyKey {
        tenant: Tenant::default(),
        name: "key".to_owned(),
        fingerprint: fingerprint.to_owned(),
        token: uuid::Uuid::new_v4().to_string(),
        keep_for: LONG,
    };
    let first = once("a");
    assert_eq!(f.store.begin_once(&first, LONG).await.unwrap(), OnceStatus::Begun);
    assert_eq!(f.store.begin_once(&once("a"), LONG).await.unwrap(), OnceStatus::InProgress);
    assert_eq!(f.store.begin_once(&once("b"), LONG).await.unwrap(), OnceStatus::OtherRequest);
    f.store.give_up_once(&once("a")).await.unwrap(); // another request's token: no effect
    assert_eq!(f.store.begin_once(&once("a"), LONG).await.unwrap(), OnceStatus::InProgress);
    let admission = |once: &IdempotencyKey| Admission { once: Some(once.clone()), ..room(10) };
    let made = f.store.insert_job(&new_job(0), &admission(&first)).await.unwrap();
    let again = f.store.begin_once(&once("a"), LONG).await.unwrap();
    assert_eq!(again, OnceStatus::Made(Made::Job(made.id)));
    f.store.give_up_once(&first).await.unwrap(); // too late: no effect
    assert_eq!(f.store.begin_once(&once("a"), LONG).await.unwrap(), again);

    // A request that has lost the key creates nothing.
    let slow = IdempotencyKey { name: "slow".to_owned(), ..once("a") };
    assert_eq!(f.store.begin_once(&slow, Duration::ZERO).await.unwrap(), OnceStatus::Begun);
    tokio::time::sleep(SHORT).await;
    let quick = IdempotencyKey { name: "slow".to_owned(), ..once("a") };
    assert_eq!(f.store.begin_once(&quick, LONG).await.unwrap(), OnceStatus::Begun);
    assert!(f.store.insert_job(&new_job(0), &admission(&slow)).await.is_err());
    f.store.insert_job(&new_job(0), &admission(&quick)).await.unwrap();
    let page = PageRequest { size: 10, after: None, order: Order::NewestFirst };
    assert_eq!(f.store.list_jobs(&f.tenant, &JobFilter::default(), &page).await.unwrap().jobs.len(), 2);
}

async fn lists_are_filtered_in_every_way(f: Fixture) {
    let mut ids = Vec::new();
    for i in 0..6u32 {
        let tags = [("study", format!("s{}", i % 2)), ("site", "zurich".to_owned())];
        let job = NewJob {
            tags: Tags::new(tags.into_iter().map(|(k, v)| (k.to_owned(), v)).collect()).unwrap(),
            external_ref: ExternalRef::new(if i < 3 { "ref".to_owned() } else { String::new() }).unwrap(),
            method: format!("m{}", i % 3),
            ..new_job(0)
        };
        ids.push(f.store.insert_job(&job, &room(10)).await.unwrap().id);
    }
    f.store.cancel_job(&f.tenant, ids[4]).await.unwrap();
    let find = async |filter: JobFilter| {
        let page = PageRequest { size: 10, after: None, order: Order::OldestFirst };
        let found = f.store.list_jobs(&f.tenant, &filter, &page).await.unwrap().jobs;
        found.iter().map(|job| ids.iter().position(|id| *id == job.id).unwrap()).collect::<Vec<_>>()
    };
    let tags = |pairs: &[(&str, &str)]| pairs.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
    let all = JobFilter::default();
    assert_eq!(find(all.clone()).await, [0, 1, 2, 3, 4, 5]);
    assert_eq!(find(JobFilter { tags: tags(&[("study", "s0")]), ..all.clone() }).await, [0, 2, 4]);
    let both = tags(&[("study", "s0"), ("site", "zurich")]);
    let states = vec![JobState::Queued, JobState::Running];
    assert_eq!(find(JobFilter { tags: both, states, ..all.clone() }).await, [0, 2]);
    assert!(find(JobFilter { tags: tags(&[("study", "zurich")]), ..all.clone() }).await.is_empty());
    assert_eq!(find(JobFilter { external_ref: Some("ref".to_owned()), ..all.clone() }).await, [0, 1, 2]);
    assert_eq!(find(JobFilter { method: Some("m1".to_owned()), ..all.clone() }).await, [1, 4]);
    let states = vec![JobState::Cancelled, JobState::Queued];
    assert_eq!(find(JobFilter { states, ..all.clone() }).await, [0, 1, 2, 3, 4, 5]);
    let later = jiff::Timestamp::now() + LONG;
    assert!(find(JobFilter { created_from: Some(later), ..all.clone() }).await.is_empty());
    assert_eq!(find(JobFilter { created_before: Some(later), ..all }).await.len(), 6);
}

async fn a_batch_is_created_as_a_whole_or_not_at_all(f: Fixture) {
    let id = BatchId::new();
    let batch = NewBatch { id, tenant: f.tenant.clone(), tags: Tags::default(), external_ref: None };
    let jobs: Vec<_> = (0..3).map(|_| NewJob { batch_id: Some(id), ..new_job(0) }).collect();
    assert!(matches!(f.store.insert_batch(&batch, &jobs, &room(2)).await, Err(JobError::QueueFull { .. })));
    let mut wrong = jobs.clone();
    wrong[2].id = wrong[0].id;
    assert!(f.store.insert_batch(&batch, &wrong, &room(10)).await.is_err());
    assert!(matches!(f.store.get_batch(&f.tenant, id).await, Err(JobError::BatchNotFound)));
    assert_eq!(f.store.queue_length(&f.tenant, 10).await.unwrap(), 0);

    let made = f.store.insert_batch(&batch, &jobs, &room(10)).await.unwrap();
    assert_eq!(made.counts, BTreeMap::from([(JobState::Queued, 3)]));
    let lease = f.claim(LONG).await;
    f.store.finish_job(&lease, &result('c'), None).await.unwrap();
    f.claim(LONG).await;
    let counts = [(JobState::Queued, 1), (JobState::Running, 1), (JobState::Succeeded, 1)];
    assert_eq!(f.store.get_batch(&f.tenant, id).await.unwrap().counts, BTreeMap::from(counts));
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.get_batch(&other, id).await, Err(JobError::BatchNotFound)));
    let listed = f.store.list_batches(&f.tenant, 10, None).await.unwrap();
    assert_eq!((listed.batches.len(), listed.next), (1, None));
}

async fn retention_removes_results_then_records(f: Fixture) {
    let bytes = bytes::Bytes::from_static(b"result");
    let job = f.add(0).await;
    let lease = f.claim(LONG).await;
    let key = ArtifactKey::of_result(&lease, &bytes);
    f.store.hold_blobs(&lease.holder(), std::slice::from_ref(&key), LONG, Some(&lease)).await.unwrap();
    f.artifacts.put(&key, bytes).await.unwrap();
    f.store.append_trace(&lease, &chunk(1..=3)).await.unwrap();
    let artifact = ArtifactRef { kind: ArtifactKind::Result, key: key.clone(), n_bytes: 6 };
    f.store
        .finish_job(&lease, &Outcome::Succeeded { artifacts: vec![artifact], verdict: None }, Some(SHORT))
        .await
        .unwrap();
    let young = f.add(0).await;
    tokio::time::sleep(SHORT * 2).await;

    let keep = Retention { results: Some(SHORT), jobs: Some(LONG) };
    let expected = Purged { results: 1, ..Purged::default() };
    assert_eq!(f.store.purge(&keep.into(), 10, true).await.unwrap(), expected, "a dry run counts");
    assert_eq!(f.store.purge(&keep.into(), 10, true).await.unwrap(), expected, "and removes nothing");
    assert_eq!(f.store.purge(&keep.into(), 10, false).await.unwrap(), expected);
    f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap();
    assert!(f.artifacts.get(&key).await.is_err());
    assert!(f.seqs(job.id, 0, 10).await.is_empty());
    assert!(matches!(f.store.get_artifact(&f.tenant, job.id, ArtifactKind::Result).await, Err(JobError::Gone)));
    assert_eq!(f.state(job.id).await, JobState::Succeeded, "the record is kept");

    let forget = Retention { results: Some(SHORT), jobs: Some(SHORT) };
    let purged = f.store.purge(&forget.into(), 10, false).await.unwrap();
    assert_eq!((purged.results, purged.jobs), (0, 1));
    assert!(matches!(f.store.get_job(&f.tenant, job.id).await, Err(JobError::NotFound)));
    assert_eq!(f.state(young.id).await, JobState::Queued, "unfinished jobs are kept");
}

async fn each_tenant_has_its_own_retention(f: Fixture) {
    let brief = Tenant::new("brief").unwrap();
    let kept = f.add(0).await;
    let purged = f.store.insert_job(&NewJob { tenant: brief.clone(), ..new_job(0) }, &room(10)).await.unwrap();
    for (tenant, id) in [(&f.tenant, kept.id), (&brief, purged.id)] {
        f.store.cancel_job(tenant, id).await.unwrap();
    }
    tokio::time::sleep(SHORT * 2).await;
    let others = Retention { results: None, jobs: Some(LONG) };
    let own = ["brief=0.0000001".parse().unwrap()];
    let retentions = Retentions::new(others, &[], &own);
    assert_eq!(f.store.purge(&retentions, 10, true).await.unwrap().jobs, 1, "a dry run counts");
    assert_eq!(f.store.purge(&retentions, 10, false).await.unwrap().jobs, 1);
    assert!(matches!(f.store.get_job(&brief, purged.id).await, Err(JobError::NotFound)));
    assert!(f.store.get_job(&f.tenant, kept.id).await.is_ok());
    // The opposite case: a tenant keeps forever what others do not.
    let forever = [format!("{}=0", f.tenant.name()).parse().unwrap()];
    let all = Retention { results: None, jobs: Some(SHORT) };
    assert_eq!(f.store.purge(&Retentions::new(all, &[], &forever), 10, false).await.unwrap().jobs, 0);
    assert_eq!(f.store.purge(&all.into(), 10, false).await.unwrap().jobs, 1);
}

async fn meshes_are_kept_while_jobs_refer_to_them(f: Fixture) {
    let key = ArtifactKey::of(&f.tenant, b"mesh");
    f.store.hold_blobs("up", std::slice::from_ref(&key), LONG, None).await.unwrap();
    f.artifacts.put(&key, bytes::Bytes::from_static(b"mesh")).await.unwrap();
    assert!(f.store.insert_mesh(&key, 4, Some(".ply"), "up").await.unwrap());
    assert!(!f.store.insert_mesh(&key, 4, None, "").await.unwrap(), "held already");
    assert_eq!(f.store.get_mesh(&f.tenant, key.hash()).await.unwrap().name_hint.as_deref(), Some(".ply"));
    let other = Tenant::new("other").unwrap();
    assert!(matches!(f.store.get_mesh(&other, key.hash()).await, Err(JobError::MeshNotFound)));
    assert!(matches!(f.store.delete_mesh(&other, key.hash()).await, Err(JobError::MeshNotFound)));

    let mut job = new_job(0);
    job.source.hash = key.hash().to_owned();
    let job = f.store.insert_job(&job, &room(10)).await.unwrap();
    assert!(matches!(f.store.delete_mesh(&f.tenant, key.hash()).await, Err(JobError::MeshInUse)));
    f.store.cancel_job(&f.tenant, job.id).await.unwrap();
    f.store.delete_job(&f.tenant, job.id).await.unwrap();
    f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap();
    assert!(f.artifacts.get(&key).await.is_ok(), "the upload itself refers to it");
    f.store.delete_mesh(&f.tenant, key.hash()).await.unwrap();
    assert_eq!(f.store.remove_unreferenced_blobs(f.artifacts.as_ref()).await.unwrap(), 1);

    // An upload that has not been used for the retention time is removed too.
    f.store.insert_mesh(&key, 4, None, "").await.unwrap();
    tokio::time::sleep(SHORT * 2).await;
    let keep = Retention { results: None, jobs: Some(SHORT) };
    assert_eq!(f.store.purge(&keep.into(), 10, true).await.unwrap().meshes, 1);
    assert_eq!(f.store.purge(&keep.into(), 10, false).await.unwrap().meshes, 1);
    assert!(matches!(f.store.get_mesh(&f.tenant, key.hash()).await, Err(JobError::MeshNotFound)));
}

async fn keys_are_invalid_once_revoked_or_expired(f: Fixture) {
    let (lasting, brief) = (SecretKey::random(), SecretKey::random());
    f.store.insert_key(&lasting, &f.tenant, "one", &[Scope::Read], None).await.unwrap();
    f.store.insert_key(&brief, &f.tenant, "two", &[Scope::Submit], Some(SHORT * 10)).await.unwrap();
    let is_valid = async |key: &SecretKey| f.store.get_key(key.id()).await.unwrap().unwrap().is_valid;
    assert!(is_valid(&lasting).await && is_valid(&brief).await);
    tokio::time::sleep(SHORT * 12).await;
    assert!(!is_valid(&brief).await);
    assert!(f.store.revoke_key(lasting.id()).await.unwrap());
    assert!(!f.store.revoke_key(lasting.id()).await.unwrap());
    assert!(!is_valid(&lasting).await);
    assert_eq!(f.store.list_keys().await.unwrap().len(), 2);
    assert!(f.store.get_key("none").await.unwrap().is_none());
    // By tenant, newest first, and page by page.
    let other = Tenant::new("other").unwrap();
    f.store.insert_key(&SecretKey::random(), &other, "three", &[Scope::Read], None).await.unwrap();
    assert_eq!(f.store.count_valid_keys(&f.tenant).await.unwrap(), 0);
    assert_eq!(f.store.count_valid_keys(&other).await.unwrap(), 1);
    let first = f.store.list_tenant_keys(&f.tenant, 1, None).await.unwrap();
    let second = f.store.list_tenant_keys(&f.tenant, 1, first.next).await.unwrap();
    let ids: BTreeSet<String> = [first.keys, second.keys].concat().into_iter().map(|key| key.id).collect();
    assert_eq!(ids, BTreeSet::from([lasting.id().to_owned(), brief.id().to_owned()]));
    assert!(second.next.is_none());
}

async fn a_webhook_gets_one_delivery_for_each_change(f: Fixture) {
    let hook = |states: Vec<JobState>| Webhook {
        id: uuid::Uuid::now_v7().to_string(),
        tenant: Tenant::default(),
        url: "https://example.org/".to_owned(),
        states,
        secret: "whsec_AAAA".to_owned(),
        is_enabled: true,
        disabled_because: None,
        created_at: jiff::Timestamp::now(),
    };
    f.add(0).await;
    f.store.insert_due_deliveries().await.unwrap();
    let all = f.store.insert_webhook(&hook(Vec::new()), 2).await.unwrap().unwrap();
    let ends = f.store.insert_webhook(&hook(vec![JobState::Cancelled]), 2).await.unwrap().unwrap();
    assert!(f.store.insert_webhook(&hook(Vec::new()), 2).await.unwrap().is_none(), "at most two");
    let job = f.add(0).await;
    f.store.cancel_job(&f.tenant, job.id).await.unwrap();
    // Two processes concurrently.
    let other = f.another().await;
    let (a, b) = tokio::join!(f.store.insert_due_deliveries(), other.insert_due_deliveries());
    assert_eq!(a.unwrap() + b.unwrap(), 3, "queued and cancelled to one, cancelled to the other");
    let log = f.store.list_deliveries(&f.tenant, &all.id, 10, None).await.unwrap().deliveries;
    assert_eq!(log.iter().map(|d| d.event.as_str()).collect::<Vec<_>>(), ["job.cancelled", "job.queued"]);

    let limits = TurnLimits { busy_for: LONG, of_tenant: 2, deliveries: 8 };
    let claim = async || f.store.claim_turn(&limits).await.unwrap();
    let mut taken = Vec::new();
    while let Some(turn) = claim().await {
        taken.extend(turn.deliveries);
    }
    assert_eq!(taken.len(), 3, "each is claimed once while an attempt is in progress");
    let again = taken.iter().find(|d| d.webhook_id == ends.id).unwrap();
    assert!(again.payload.contains(&job.id.to_string()));
    let retry = Attempted::Retry { after: Duration::ZERO, status: Some(500), error: "HTTP 500".to_owned() };
    f.store.end_attempt(&again.id, &retry).await.unwrap();
    tokio::time::sleep(SHORT).await;
    assert!(claim().await.is_none(), "its turn is not over");
    f.store.end_turn(&ends.id, 1, LONG).await.unwrap();
    assert!(claim().await.is_none(), "it pauses");
    f.store.end_turn(&ends.id, 1, Duration::ZERO).await.unwrap();
    let turn = claim().await.unwrap();
    assert_eq!((turn.failures, turn.deliveries[0].attempt), (1, 2));
    f.store.end_attempt(&again.id, &Attempted::Delivered { status: 204 }).await.unwrap();
    let log = f.store.list_deliveries(&f.tenant, &ends.id, 10, None).await.unwrap().deliveries;
    assert_eq!((log[0].state, log[0].attempts, log[0].status), (DeliveryState::Delivered, 2, Some(204)));
    f.store.disable_webhook(&ends.id, "it answered 410").await.unwrap();
    assert!(!f.store.get_webhook(&f.tenant, &ends.id).await.unwrap().is_enabled);
    f.store.delete_webhook(&f.tenant, &ends.id).await.unwrap();
    assert!(matches!(f.store.get_webhook(&f.tenant, &ends.id).await, Err(JobError::WebhookNotFound)));
}

on_every_store! {
    an_equal_job_is_answered_from_the_first_result,
    deadlines_and_run_time_limits_are_enforced,
    changes_come_in_order_and_none_is_missed,
    an_idempotency_key_is_used_once,
    lists_are_filtered_in_every_way,
    a_batch_is_created_as_a_whole_or_not_at_all,
    retention_removes_results_then_records,
    each_tenant_has_its_own_retention,
    meshes_are_kept_while_jobs_refer_to_them,
    keys_are_invalid_once_revoked_or_expired,
    a_webhook_gets_one_delivery_for_each_change,
}
