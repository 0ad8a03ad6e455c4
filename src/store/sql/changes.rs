//! The feed of state changes.
//!
//! Rows come from triggers, inside the transactions that change a state. Their numbers come afterwards, one after the
//! other under a lock, and only rows that are committed get one; so a reader that has seen number `n` has seen all that
//! will ever have a smaller one. Numbers given by the inserting transactions would not have that: they commit in any
//! order.

use super::database::bind;
use super::dialect::sql;
use super::{SqlStore, rows};
use crate::jobs::change::Change;
use crate::jobs::{ChangePage, JobError, Tenant};

impl SqlStore {
    /// Numbers what is committed and has no number yet.
    pub(super) async fn number_changes(&self) -> Result<(), JobError> {
        loop {
            let waiting: Option<bool> =
                self.database.reading().await?.value(sql!("has_unnumbered_changes"), bind![]).await?;
            if waiting != Some(true) {
                return Ok(());
            }
            let mut session = self.database.begin().await?;
            let done = async {
                let last: Option<i64> = session.value(sql!("lock_change_counter"), bind![]).await?;
                let last = last.ok_or(JobError::Corrupt { what: "the counter of changes", source: None })?;
                let n = session.execute(sql!("number_changes"), bind![last]).await?;
                session.execute(sql!("advance_change_counter"), bind![n]).await
            };
            let done = done.await;
            session.end(done).await?;
        }
    }

    pub(super) async fn read_changes(&self, tenant: &Tenant, since: u64, limit: u32) -> Result<ChangePage, JobError> {
        self.number_changes().await?;
        let mut session = self.database.reading().await?;
        let found = session.rows(sql!("changes_since"), bind![tenant, since, i64::from(limit) + 1]).await?;
        let more = found.len() > limit as usize;
        let mut changes = Vec::new();
        for row in found.iter().take(limit as usize) {
            changes.push(Change {
                seq: row.get::<i64>("seq")?.unsigned_abs(),
                job_id: rows::job_id(&row.get::<String>("job_id")?)?,
                batch_id: row.get::<Option<String>>("batch_id")?.as_deref().map(rows::batch_id).transpose()?,
                state: rows::state(&row.get::<String>("state")?)?,
                at: rows::time(row.get("at")?)?,
            });
        }
        let next_since = changes.last().map_or(since, |change| change.seq);
        Ok(ChangePage { changes, next_since, more })
    }
}
