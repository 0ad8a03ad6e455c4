//! The clock of the database, held against the last time that was seen: nobody's results are removed because a clock was set
//! wrong, and no job is lost when it jumps.

use super::SqlStore;
use super::database::{Session, bind};
use super::dialect::sql;
use crate::jobs::{ClockState, JobError};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How far a clock may be ahead of the last time that was seen, in a process that has looked at it before: it looks every minute,
/// but a computer may sleep.
const AHEAD: Duration = Duration::from_secs(24 * 3600);
/// The same at the start of a process, since a service may have been off for weeks.
const AHEAD_AT_START: Duration = Duration::from_secs(30 * 24 * 3600);
/// How far it may be behind.
const BEHIND: Duration = Duration::from_secs(24 * 3600);
/// How much more or less than the time that has passed a clock may show without having been set.
const STEP: Duration = Duration::from_secs(10);

/// What a process knows of the clock.
#[derive(Debug, Default)]
pub(super) struct Clock {
    /// Whether this process has found it plausible before.
    is_known: AtomicBool,
    /// Whether it was not when it was last looked at.
    has_jumped: AtomicBool,
    /// When it was last read, and what it showed, ms.
    last: Mutex<Option<(Instant, i64)>>,
}

/// Whether a clock that shows `present` may follow on `seen`, ms.
fn is_plausible(present: i64, seen: i64, ahead: Duration) -> bool {
    let moved = i128::from(present) - i128::from(seen);
    (-(BEHIND.as_millis() as i128)..=ahead.as_millis() as i128).contains(&moved)
}

/// Whether a clock was set while `passed` went by and it moved by `moved_ms`.
fn is_set(passed: Duration, moved_ms: i64) -> bool {
    (i128::from(moved_ms) - passed.as_millis() as i128).unsigned_abs() > STEP.as_millis()
}

/// What the clock shows and what it showed when it was last found plausible, ms.
async fn clock(session: &mut Session) -> Result<(i64, Option<i64>), JobError> {
    let row = session.row(sql!("clock"), bind![]).await?;
    let row = row.ok_or(JobError::Corrupt { what: "a clock", source: None })?;
    Ok((row.get("present")?, row.get("seen")?))
}

async fn note_clock(session: &mut Session) -> Result<(), JobError> {
    session.execute(sql!("note_clock"), bind![]).await.map(|_| ())
}

impl SqlStore {
    /// Holds the clock against the last time that was seen, and notes it if it is plausible or `trusted`.
    pub(super) async fn look_at_clock(&self, trusted: bool) -> Result<ClockState, JobError> {
        let known = self.clock.is_known.load(Ordering::Relaxed);
        let ahead = if known { AHEAD } else { AHEAD_AT_START };
        let (present, seen) = clock(&mut self.database.reader().await?).await?;
        let fits = trusted || seen.is_none_or(|seen| is_plausible(present, seen, ahead));
        self.clock.has_jumped.store(!fits, Ordering::Relaxed);
        if !fits {
            return Ok(ClockState::Jumped { by_ms: present.saturating_sub(seen.unwrap_or(present)) });
        }
        self.clock.is_known.store(true, Ordering::Relaxed);
        self.database.transaction(async |session| note_clock(session).await).await?;
        Ok(ClockState::Plausible)
    }

    /// Whether the clock was set since the last call, by more than it may drift.
    pub(super) async fn was_clock_set(&self) -> Result<bool, JobError> {
        let (present, _) = clock(&mut self.database.reader().await?).await?;
        let now = Instant::now();
        let before = self.clock.last.lock().unwrap_or_else(PoisonError::into_inner).replace((now, present));
        Ok(before.is_some_and(|(then, showed)| is_set(now - then, present.saturating_sub(showed))))
    }

    /// Whether the clock had jumped when it was last looked at.
    pub(super) fn has_clock_jumped(&self) -> bool {
        self.clock.has_jumped.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::super::DatabaseLocation;
    use super::*;
    use crate::jobs::{Housekeeping as _, Retentions};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_clock_follows_within_a_day_and_within_a_month_of_rest(seen in 0..4_000_000_000_000i64, hours in -2000..2000i64) {
            let present = seen + hours * 3_600_000;
            prop_assert_eq!(is_plausible(present, seen, AHEAD), (-24..=24).contains(&hours));
            prop_assert_eq!(is_plausible(present, seen, AHEAD_AT_START), (-24..=720).contains(&hours));
            let passed = Duration::from_secs(hours.unsigned_abs());
            prop_assert!(!is_set(passed, passed.as_millis() as i64 + 9_000));
            prop_assert!(is_set(passed, passed.as_millis() as i64 - 11_000));
        }
    }

    #[tokio::test]
    async fn a_clock_that_goes_on_is_not_set() {
        let folder = tempfile::tempdir().unwrap();
        let store = SqlStore::open(&DatabaseLocation::Folder(folder.path().to_owned())).await.unwrap();
        assert!(!store.clock_was_set().await.unwrap() && !store.clock_was_set().await.unwrap());
        let (then, showed) = store.clock.last.lock().unwrap().unwrap();
        *store.clock.last.lock().unwrap() = Some((then, showed + 3 * 3_600_000));
        assert!(store.clock_was_set().await.unwrap() && !store.clock_was_set().await.unwrap());
        assert!(store.purge(&Retentions::default(), 1, false).await.unwrap().is_nothing());
    }
}
