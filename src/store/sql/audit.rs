//! The audit log: one chain to which all processes append row by row.

use super::SqlStore;
use super::argument::bind;
use super::database::{Row, Session};
use super::dialect::sql;
use crate::jobs::{AuditEvent, AuditHead, AuditRow, AuditStore, JobError};
use async_trait::async_trait;
use jiff::Timestamp;

/// Rows pruned in one transaction.
const PRUNED_AT_ONCE: u32 = 5_000;

/// A time in ms in the form of the log, always with milliseconds.
fn written(at_ms: i64) -> String {
    Timestamp::from_millisecond(at_ms).map_or_else(|_| at_ms.to_string(), |at| format!("{at:.3}"))
}

fn head(row: &Row) -> Result<AuditHead, JobError> {
    Ok(AuditHead { position: row.get::<i64>("position")?.unsigned_abs(), hash: row.get("hash")? })
}

/// Returns whatever is stored, so that verification can judge it.
fn audit_row(row: &Row) -> Result<AuditRow, JobError> {
    Ok(AuditRow {
        position: row.get::<i64>("position")?.unsigned_abs(),
        at: written(row.get("at")?),
        tenant: row.get("tenant")?,
        key_id: row.get("key_id")?,
        action: row.get("action")?,
        resource: row.get("resource")?,
        address: row.get("address")?,
        status: row.get("status")?,
        hash: row.get("hash")?,
    })
}

async fn insert_audit(session: &mut Session, row: &AuditRow, at_ms: i64) -> Result<(), JobError> {
    let AuditRow { position, tenant, key_id, action, resource, address, status, hash, .. } = row;
    let arguments = bind![*position, at_ms, tenant, key_id, action, resource, address, *status, hash];
    session.execute(sql!("insert_audit"), arguments).await.map(|_| ())
}

/// Locks the end of the log until the commit, so that the next process continues from the last row of this one. Returns
/// the last row and the time.
async fn lock_audit_head(session: &mut Session) -> Result<(AuditHead, i64), JobError> {
    let locked = session.row(sql!("lock_audit_head"), bind![]).await?;
    let locked = locked.ok_or(JobError::Corrupt { what: "the end of the audit log", source: None })?;
    Ok((head(&locked)?, locked.get::<i64>("at")?))
}

/// Appends rows after the last one, whose position is locked.
async fn append(
    session: &mut Session,
    (mut last, at_ms): (AuditHead, i64),
    events: &[AuditEvent],
) -> Result<(), JobError> {
    for event in events {
        let mut row = AuditRow {
            position: last.position + 1,
            at: written(at_ms),
            tenant: event.tenant.as_ref().map(|tenant| tenant.name().to_owned()),
            key_id: event.key_id.clone(),
            action: event.action.clone(),
            resource: event.resource.clone(),
            address: event.address.clone(),
            status: event.status.map(i64::from),
            hash: String::new(),
        };
        row.hash = row.hash_after(&last.hash);
        insert_audit(session, &row, at_ms).await?;
        last = AuditHead { position: row.position, hash: row.hash };
    }
    session.execute(sql!("move_audit_head"), bind![last.position, last.hash]).await.map(|_| ())
}

impl SqlStore {
    /// The last row that was pruned.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn audit_anchor(&self) -> Result<AuditHead, JobError> {
        let row = self.database.reader().await?.row(sql!("audit_anchor"), bind![]).await?;
        head(&row.ok_or(JobError::Corrupt { what: "the beginning of the audit log", source: None })?)
    }

    /// Removes the rows before a time, but never the last row, and records the last removed row. Returns that row and
    /// the number of removed rows.
    ///
    /// # Errors
    /// [`JobError::Unavailable`]; the next call removes the rest.
    pub(crate) async fn prune_audit(&self, before: Timestamp) -> Result<(AuditHead, u64), JobError> {
        self.database
            .transaction(async |session| {
                let (last, at_ms) = lock_audit_head(session).await?;
                let arguments = bind![before.as_millisecond(), last.position];
                let Some(row) = session.row(sql!("last_audit_before"), arguments).await? else { return Ok(()) };
                let anchor = head(&row)?;
                append(session, (last, at_ms), &[AuditEvent::pruned(&anchor)]).await?;
                session.execute(sql!("move_audit_anchor"), bind![anchor.position, &anchor.hash]).await.map(|_| ())
            })
            .await?;
        let mut n_removed = 0;
        loop {
            let removed = self
                .database
                .transaction(async |session| session.execute(sql!("remove_pruned_audit"), bind![PRUNED_AT_ONCE]).await)
                .await?;
            n_removed += removed;
            if removed == 0 {
                break;
            }
        }
        if n_removed > 0 {
            self.note_deletion();
        }
        Ok((self.audit_anchor().await?, n_removed))
    }
}

#[async_trait]
impl AuditStore for SqlStore {
    async fn append_audit(&self, events: &[AuditEvent]) -> Result<(), JobError> {
        self.database
            .transaction(async |session| {
                let locked = lock_audit_head(session).await?;
                append(session, locked, events).await
            })
            .await
    }

    async fn list_audit(&self, after: u64, limit: u32) -> Result<Vec<AuditRow>, JobError> {
        let rows = self.database.reader().await?.rows(sql!("list_audit"), bind![after, limit]).await?;
        rows.iter().map(audit_row).collect()
    }

    async fn audit_head(&self) -> Result<AuditHead, JobError> {
        let row = self.database.reader().await?.row(sql!("audit_head"), bind![]).await?;
        head(&row.ok_or(JobError::Corrupt { what: "the end of the audit log", source: None })?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_always_have_milliseconds() {
        assert_eq!(written(1_795_238_118_123), "2026-11-21T05:15:18.123Z");
        assert_eq!(written(1_795_238_118_000), "2026-11-21T05:15:18.000Z");
        assert_eq!(written(i64::MAX), i64::MAX.to_string());
    }
}
