//! Removal of results and records past their retention.
//!
//! Each job is removed in its own transaction: a purge of thousands of jobs holds no lock for long, and the next purge
//! continues an interrupted one.

use super::argument::bind;
use super::database::{Row, Session};
use super::dialect::sql;
use super::{SqlStore, blobs, rows, studies, writing};
use crate::jobs::{Concerned, JobError, JobId, MeshStore, Purged, Retention, Retentions, StudyStore};
use std::time::Duration;

fn number(row: Option<Row>) -> Result<u64, JobError> {
    Ok(row.map_or(Ok(0), |row| row.get::<i64>(0))?.unsigned_abs())
}

/// Counts what a purge would remove.
pub(super) async fn count_purge(store: &SqlStore, retention: &Retentions) -> Result<Purged, JobError> {
    let mut session = store.database.reader().await?;
    let mut purged = Purged::default();
    for (Concerned { tenant, excepted }, keep) in retention.all() {
        let count = bind![keep.results, &tenant, &excepted];
        purged.results += number(session.row(sql!("count_results_to_purge"), count).await?)?;
        let count = bind![keep.results, &tenant, &excepted];
        purged.results += number(session.row(sql!("count_study_results_to_purge"), count).await?)?;
        let Some(keep) = keep.jobs else { continue };
        for (total, query) in [
            (&mut purged.studies, sql!("count_studies_to_purge")),
            (&mut purged.jobs, sql!("count_jobs_to_purge")),
            (&mut purged.meshes, sql!("count_meshes_to_purge")),
            (&mut purged.changes, sql!("count_old_changes")),
            (&mut purged.deliveries, sql!("count_old_deliveries")),
        ] {
            *total += number(session.row(query, bind![keep, &tenant, &excepted]).await?)?;
        }
    }
    purged.idempotency_keys = number(session.row(sql!("count_old_once"), bind![]).await?)?;
    Ok(purged)
}

/// Removes results, and then records, past their retention: at most `limit` of each kind and retention.
pub(super) async fn purge(store: &SqlStore, retention: &Retentions, limit: u32) -> Result<Purged, JobError> {
    let mut purged = Purged::default();
    for (concerned, keep) in retention.all() {
        purged.add(&purge_concerned(store, &concerned, &keep, limit).await?);
    }
    purged.idempotency_keys = purge_once(store).await?;
    if !purged.is_nothing() {
        store.note_deletion();
    }
    Ok(purged)
}

/// Removes expired idempotency keys.
async fn purge_once(store: &SqlStore) -> Result<u64, JobError> {
    store.database.transaction(async |session| session.execute(sql!("purge_once"), bind![]).await).await
}

/// Removes results and records past one retention.
async fn purge_concerned(
    store: &SqlStore,
    concerned: &Concerned,
    retention: &Retention,
    limit: u32,
) -> Result<Purged, JobError> {
    let (database, Concerned { tenant, excepted }) = (&store.database, concerned);
    let mut purged = Purged::default();
    let found = bind![limit, retention.results, tenant, excepted];
    for row in database.reader().await?.rows(sql!("results_to_purge"), found).await? {
        let id = rows::job_id(&row.get::<String>("id")?)?;
        purged.results +=
            u64::from(database.transaction(async |session| purge_result(session, id, retention.results).await).await?);
    }
    let found = bind![limit, retention.results, tenant, excepted];
    for row in database.reader().await?.rows(sql!("study_results_to_purge"), found).await? {
        let id = rows::study_id(&row.get::<String>("id")?)?;
        let done = database
            .transaction(async |session| studies::purge_study_result(session, id, retention.results).await)
            .await?;
        purged.results += u64::from(done);
    }
    let Some(keep) = retention.jobs else { return Ok(purged) };
    let found = bind![keep, limit, tenant, excepted];
    for row in database.reader().await?.rows(sql!("studies_to_purge"), found).await? {
        let tenant = rows::tenant(&row.get::<String>("tenant")?)?;
        match store.delete_study(&tenant, rows::study_id(&row.get::<String>("id")?)?).await {
            Ok(()) => purged.studies += 1,
            // The study has continued, or another process has removed it.
            Err(JobError::StudyActive { .. } | JobError::StudyNotFound) => {}
            Err(error) => return Err(error),
        }
    }
    let found = bind![keep, limit, tenant, excepted];
    for row in database.reader().await?.rows(sql!("jobs_to_purge"), found).await? {
        let id = rows::job_id(&row.get::<String>("id")?)?;
        purged.jobs += u64::from(database.transaction(async |session| purge_job(session, id).await).await?);
    }
    let found = bind![keep, limit, tenant, excepted];
    for row in database.reader().await?.rows(sql!("meshes_to_purge"), found).await? {
        let tenant = rows::tenant(&row.get::<String>("tenant")?)?;
        match store.delete_mesh(&tenant, &row.get::<String>("hash")?).await {
            Ok(()) => purged.meshes += 1,
            // A job now refers to the upload, or another process has removed it.
            Err(JobError::MeshInUse | JobError::MeshNotFound) => {}
            Err(error) => return Err(error),
        }
    }
    let records = database.transaction(async |session| purge_records(session, concerned, keep).await);
    (purged.changes, purged.deliveries) = records.await?;
    Ok(purged)
}

/// Removes a job's result and trace. `false` if the job needs no purge any more.
async fn purge_result(session: &mut Session, id: JobId, keep: Option<Duration>) -> Result<bool, JobError> {
    // Locked: a submission that shares this result has either committed before, or will not find it.
    if session.row(sql!("lock_result_to_purge"), bind![id, keep]).await?.is_none() {
        return Ok(false);
    }
    session.execute(sql!("mark_result_purged"), bind![id]).await?;
    blobs::note_candidates_of_job(session, id).await?;
    for query in [sql!("delete_artifacts"), sql!("clear_trace")] {
        session.execute(query, bind![id]).await?;
    }
    Ok(true)
}

/// Removes a job's record. `false` if the job needs no purge any more.
async fn purge_job(session: &mut Session, id: JobId) -> Result<bool, JobError> {
    if session.row(sql!("lock_job_to_purge"), bind![id]).await?.is_none() {
        return Ok(false);
    }
    writing::delete_job(session, id).await.map(|()| true)
}

/// Removes changes, deliveries and empty batches that are older than `keep`. Returns the numbers of the first two.
async fn purge_records(session: &mut Session, concerned: &Concerned, keep: Duration) -> Result<(u64, u64), JobError> {
    let Concerned { tenant, excepted } = concerned;
    let changes = session.execute(sql!("purge_changes"), bind![keep, tenant, excepted]).await?;
    let deliveries = session.execute(sql!("purge_deliveries"), bind![keep, tenant, excepted]).await?;
    session.execute(sql!("purge_empty_batches"), bind![keep, tenant, excepted]).await?;
    Ok((changes, deliveries))
}
