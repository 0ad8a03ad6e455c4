//! Idempotency keys: a request is begun once, and what it made is remembered in the transaction that makes it.

use super::SqlStore;
use super::database::{Session, bind};
use super::dialect::sql;
use crate::jobs::{JobError, Made, Once, OnceStatus};
use std::time::Duration;

/// Notes what was made. `LeaseLost` if somebody else took the key meanwhile: then nothing must be made.
pub(super) async fn remember(session: &mut Session, once: &Once, made: Made) -> Result<(), JobError> {
    let arguments = bind![&once.tenant, &once.name, &once.token, made.to_text(), once.keep_for];
    match session.execute(sql!("made_once"), arguments).await? {
        1 => Ok(()),
        _ => Err(JobError::LeaseLost),
    }
}

impl SqlStore {
    pub(super) async fn take_once(&self, once: &Once, busy_for: Duration) -> Result<OnceStatus, JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            let arguments = bind![&once.tenant, &once.name, &once.fingerprint, &once.token, busy_for];
            // Takes the key if it is free or its time is over; waits for whoever takes it at this moment.
            if session.execute(sql!("take_once"), arguments).await? == 1 {
                return Ok(OnceStatus::Begun);
            }
            let row = session.row(sql!("get_once"), bind![&once.tenant, &once.name]).await?;
            // Given up at this very moment: to whoever asks again it is free.
            let Some(row) = row else { return Ok(OnceStatus::InProgress) };
            if row.get::<String>("fingerprint")? != once.fingerprint {
                return Ok(OnceStatus::OtherRequest);
            }
            match row.get::<Option<String>>("made")? {
                None => Ok(OnceStatus::InProgress),
                Some(made) => Made::from_text(&made)
                    .map(OnceStatus::Made)
                    .ok_or(JobError::Corrupt { what: "what a key stands for", source: None }),
            }
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn drop_once(&self, once: &Once) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = session.execute(sql!("give_up_once"), bind![&once.tenant, &once.name, &once.token]).await;
        session.end(done).await.map(|_| ())
    }
}
