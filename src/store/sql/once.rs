//! Idempotency keys: a request with a key is carried out once, and its outcome is recorded in the same transaction.

use super::argument::bind;
use super::database::Session;
use super::dialect::sql;
use crate::jobs::{IdempotencyKey, JobError, Made, OnceStatus};
use std::time::Duration;

/// Reserves a key, or returns the outcome of an earlier request under it.
pub(super) async fn begin_once(
    session: &mut Session,
    once: &IdempotencyKey,
    busy_for: Duration,
) -> Result<OnceStatus, JobError> {
    let arguments = bind![&once.tenant, &once.name, &once.fingerprint, &once.token, busy_for];
    // Succeeds if the key is free or has expired; waits for a concurrent transaction that is reserving it.
    if session.execute(sql!("begin_once"), arguments).await? == 1 {
        return Ok(OnceStatus::Begun);
    }
    let row = session.row(sql!("get_once"), bind![&once.tenant, &once.name]).await?;
    // Another request has released the key since the statement above; the next request finds it free.
    let Some(row) = row else { return Ok(OnceStatus::InProgress) };
    if row.get::<String>("fingerprint")? != once.fingerprint {
        return Ok(OnceStatus::OtherRequest);
    }
    match row.get::<Option<String>>("made")? {
        None => Ok(OnceStatus::InProgress),
        Some(made) => Made::from_text(&made)
            .map(OnceStatus::Made)
            .ok_or(JobError::Corrupt { what: "the record of an idempotency key", source: None }),
    }
}

/// Records the outcome of a request under a key. [`JobError::LeaseLost`] if another request has taken the key in the
/// meantime; this request must then create nothing.
pub(super) async fn finish_once(session: &mut Session, once: &IdempotencyKey, made: Made) -> Result<(), JobError> {
    let arguments = bind![&once.tenant, &once.name, &once.token, made.to_text(), once.keep_for];
    match session.execute(sql!("finish_once"), arguments).await? {
        1 => Ok(()),
        _ => Err(JobError::LeaseLost),
    }
}
