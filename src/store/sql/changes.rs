//! The feed of state changes.
//!
//! Triggers insert the rows, in the transactions that change a state. Committed rows are numbered afterwards, one after
//! the other under a lock, so a reader who has seen number `n` has seen every row that will ever have a smaller number.
//! Numbers assigned by the inserting transactions would not guarantee this, because those commit in any order. Each
//! tenant has its own numbers.

use super::argument::bind;
use super::database::{Database, Session};
use super::dialect::sql;
use super::rows;
use crate::jobs::change::Change;
use crate::jobs::{ChangePage, JobError, Tenant};

/// Numbers the changes that are committed and have no number yet.
pub(super) async fn number_changes(database: &Database) -> Result<(), JobError> {
    loop {
        // Checked without a lock first, because usually there is nothing to number.
        let waiting: Option<bool> = database.reader().await?.value(sql!("has_unnumbered_changes"), bind![]).await?;
        if waiting != Some(true) {
            return Ok(());
        }
        database
            .transaction(async |session| {
                let last: Option<i64> = session.value(sql!("lock_change_counter"), bind![]).await?;
                let last = last.ok_or(JobError::Corrupt { what: "the counter of changes", source: None })?;
                let n = session.execute(sql!("number_changes"), bind![last]).await?;
                session.execute(sql!("advance_change_counter"), bind![n]).await?;
                number_changes_of_tenants(session).await
            })
            .await?;
    }
}

/// Numbers the changes of each tenant that already have a global number. The numbers of a tenant have no gaps, because
/// gaps would reveal the activity of other tenants.
async fn number_changes_of_tenants(session: &mut Session) -> Result<(), JobError> {
    let first: Option<Option<i64>> = session.value(sql!("first_unnumbered_change"), bind![]).await?;
    let Some(first) = first.flatten() else { return Ok(()) };
    session.execute(sql!("number_changes_of_tenants"), bind![]).await?;
    session.execute(sql!("advance_counters_of_tenants"), bind![first]).await.map(|_| ())
}

/// The number of the last change of a tenant's jobs.
pub(super) async fn newest_change(database: &Database, tenant: &Tenant) -> Result<u64, JobError> {
    let mut session = database.reader().await?;
    let last: Option<i64> = session.value(sql!("newest_change"), bind![tenant]).await?;
    Ok(last.unwrap_or_default().unsigned_abs())
}

/// At most `limit` changes of a tenant's jobs after number `since`.
pub(super) async fn list_changes(
    database: &Database,
    tenant: &Tenant,
    since: u64,
    limit: u32,
) -> Result<ChangePage, JobError> {
    let mut session = database.reader().await?;
    let found = session.rows(sql!("list_changes"), bind![tenant, since, i64::from(limit) + 1]).await?;
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
