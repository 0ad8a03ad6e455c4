//! Batches with the numbers of their jobs in each state.

use super::argument::bind;
use super::database::{Row, Session};
use super::dialect::sql;
use super::rows;
use crate::jobs::job::Cursor;
use crate::jobs::{Batch, BatchId, BatchPage, JobError, JobState, Tenant};
use std::collections::BTreeMap;

/// A batch by its id.
pub(super) async fn get_batch(session: &mut Session, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError> {
    let row = session.row(sql!("get_batch"), bind![id, tenant]).await?.ok_or(JobError::BatchNotFound)?;
    batch(session, &row).await
}

/// The number of a batch's jobs in each state.
async fn batch_counts(session: &mut Session, id: BatchId) -> Result<BTreeMap<JobState, u32>, JobError> {
    let found = session.rows(sql!("batch_counts"), bind![id]).await?;
    found.iter().map(|row| Ok((rows::state(&row.get::<String>("state")?)?, row.count("n")?))).collect()
}

/// The batch in a row, with its counts.
async fn batch(session: &mut Session, row: &Row) -> Result<Batch, JobError> {
    let id = rows::batch_id(&row.get::<String>("id")?)?;
    Ok(Batch {
        id,
        tenant: rows::tenant(&row.get::<String>("tenant")?)?,
        n_jobs: row.count("n_jobs")?,
        tags: rows::json("a batch's tags", &row.get::<String>("labels")?)?,
        external_ref: row.get("external_ref")?,
        created_at: rows::time(row.get("created_at")?)?,
        counts: batch_counts(session, id).await?,
    })
}

/// A page of the list of batches, newest first.
pub(super) async fn list_batches(
    session: &mut Session,
    tenant: &Tenant,
    size: u32,
    after: Option<Cursor>,
) -> Result<BatchPage, JobError> {
    let arguments = bind![tenant, after.map(|c| c.created_at_ms), after.map(|c| c.id.to_string()), i64::from(size) + 1];
    let found = session.rows(sql!("list_batches"), arguments).await?;
    let mut batches = Vec::new();
    for row in found.iter().take(size as usize) {
        batches.push(batch(session, row).await?);
    }
    let more = found.len() > size as usize;
    let next = batches.last().filter(|_| more).and_then(|last| rows::cursor(last.created_at, &last.id.to_string()));
    Ok(BatchPage { batches, next })
}
