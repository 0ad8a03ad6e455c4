//! Removal of what outlived its retention.
//!
//! Each job goes in a transaction of its own: a purge of thousands keeps nobody waiting, and what it was interrupted in
//! goes on the next time.

use super::database::{Row, bind};
use super::dialect::sql;
use super::{SqlStore, blobs, rows, writing};
use crate::jobs::{JobError, MeshStore, Purged, Retention};

fn n(row: Option<Row>) -> Result<u64, JobError> {
    Ok(row.map_or(Ok(0), |row| row.get::<i64>(0))?.unsigned_abs())
}

impl SqlStore {
    pub(super) async fn count_purge(&self, retention: &Retention) -> Result<Purged, JobError> {
        let mut session = self.database.snapshot().await?;
        let done = async {
            let mut purged = Purged {
                results: n(session.row(sql!("count_results_to_purge"), bind![]).await?)?,
                ..Purged::default()
            };
            if let Some(keep) = retention.jobs {
                purged.jobs = n(session.row(sql!("count_jobs_to_purge"), bind![keep]).await?)?;
                purged.meshes = n(session.row(sql!("count_meshes_to_purge"), bind![keep]).await?)?;
                purged.changes = n(session.row(sql!("count_old_changes"), bind![keep]).await?)?;
                purged.deliveries = n(session.row(sql!("count_old_deliveries"), bind![keep]).await?)?;
            }
            purged.idempotency_keys = n(session.row(sql!("count_old_once"), bind![]).await?)?;
            Ok(purged)
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn do_purge(&self, retention: &Retention, limit: u32) -> Result<Purged, JobError> {
        let mut purged = Purged::default();
        for row in self.database.reading().await?.rows(sql!("results_to_purge"), bind![limit]).await? {
            let id = rows::job_id(&row.get::<String>("id")?)?;
            let mut session = self.database.begin().await?;
            let done = async {
                // Locked: a submission that takes this result as its own came before, or does not find it.
                if session.row(sql!("lock_result_to_purge"), bind![id]).await?.is_none() {
                    return Ok(false);
                }
                session.execute(sql!("mark_result_purged"), bind![id]).await?;
                blobs::note_candidates_of_job(&mut session, id).await?;
                for query in [sql!("delete_artifacts"), sql!("clear_trace")] {
                    session.execute(query, bind![id]).await?;
                }
                Ok(true)
            };
            let done = done.await;
            purged.results += u64::from(session.end(done).await?);
        }
        if let Some(keep) = retention.jobs {
            for row in self.database.reading().await?.rows(sql!("jobs_to_purge"), bind![keep, limit]).await? {
                let id = rows::job_id(&row.get::<String>("id")?)?;
                let mut session = self.database.begin().await?;
                let done = async {
                    if session.row(sql!("lock_job_to_purge"), bind![id]).await?.is_none() {
                        return Ok(false);
                    }
                    writing::remove_job(&mut session, id).await.map(|()| true)
                };
                let done = done.await;
                purged.jobs += u64::from(session.end(done).await?);
            }
            for row in self.database.reading().await?.rows(sql!("meshes_to_purge"), bind![keep, limit]).await? {
                let tenant = rows::tenant(&row.get::<String>("tenant")?)?;
                match self.delete_mesh(&tenant, &row.get::<String>("hash")?).await {
                    Ok(()) => purged.meshes += 1,
                    // A job refers to it since, or somebody else removed it.
                    Err(JobError::MeshInUse | JobError::MeshNotFound) => {}
                    Err(error) => return Err(error),
                }
            }
            let mut session = self.database.begin().await?;
            let done = async {
                let changes = session.execute(sql!("purge_changes"), bind![keep]).await?;
                let deliveries = session.execute(sql!("purge_deliveries"), bind![keep]).await?;
                session.execute(sql!("purge_empty_batches"), bind![keep]).await?;
                Ok((changes, deliveries))
            };
            let done = done.await;
            (purged.changes, purged.deliveries) = session.end(done).await?;
        }
        let mut session = self.database.begin().await?;
        let done = session.execute(sql!("purge_once"), bind![]).await;
        purged.idempotency_keys = session.end(done).await?;
        Ok(purged)
    }
}
