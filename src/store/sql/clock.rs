//! Compares the clock of the database with the last time that was seen, so that a clock that was set wrong removes no
//! results, and a jump of the clock loses no job.

use super::SqlStore;
use super::argument::bind;
use super::database::Session;
use super::dialect::sql;
use crate::jobs::{ClockState, JobError};
use parking_lot::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How far the clock may be ahead of the last time that was seen, in a process that has seen it before: the process
/// looks every minute, but a computer may sleep.
const AHEAD: Duration = Duration::from_secs(24 * 3600);
/// As [`AHEAD`], at the start of a process: the service may have been off for weeks.
const AHEAD_AT_START: Duration = Duration::from_secs(30 * 24 * 3600);
/// How far the clock may be behind.
const BEHIND: Duration = Duration::from_secs(24 * 3600);
/// How much the movement of a clock may differ from the time that has passed, unless the clock was set.
const STEP: Duration = Duration::from_secs(10);

/// The state of the clock as a process knows it.
#[derive(Debug, Default)]
pub(super) struct Clock {
    /// Whether this process has ever found the clock plausible.
    is_known: AtomicBool,
    /// Whether the clock was implausible at the last look.
    has_jumped: AtomicBool,
    /// When the clock was last read, and its time, ms.
    last: Mutex<Option<(Instant, i64)>>,
}

/// Whether a clock that shows `present` may follow a time `seen`, ms.
fn is_plausible(present: i64, seen: i64, ahead: Duration) -> bool {
    let moved = i128::from(present) - i128::from(seen);
    (-(BEHIND.as_millis() as i128)..=ahead.as_millis() as i128).contains(&moved)
}

/// Whether the clock was set, given that it moved by `moved_ms` while `passed` went by.
fn is_set(passed: Duration, moved_ms: i64) -> bool {
    (i128::from(moved_ms) - passed.as_millis() as i128).unsigned_abs() > STEP.as_millis()
}

/// The present time of the clock, and its time when it was last found plausible, ms.
async fn clock(session: &mut Session) -> Result<(i64, Option<i64>), JobError> {
    let row = session.row(sql!("clock"), bind![]).await?;
    let row = row.ok_or(JobError::Corrupt { what: "a clock", source: None })?;
    Ok((row.get("present")?, row.get("seen")?))
}

async fn note_clock(session: &mut Session) -> Result<(), JobError> {
    session.execute(sql!("note_clock"), bind![]).await.map(|_| ())
}

impl SqlStore {
    /// Compares the clock with the last time that was seen, and notes the present time if it is plausible or `trusted`.
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
        let before = self.clock.last.lock().replace((now, present));
        Ok(before.is_some_and(|(then, showed)| is_set(now - then, present.saturating_sub(showed))))
    }

    /// Whether the clock had jumped at the last look.
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
        let (then, showed) = store.clock.last.lock().unwrap();
        *store.clock.last.lock() = Some((then, showed + 3 * 3_600_000));
        assert!(store.clock_was_set().await.unwrap() && !store.clock_was_set().await.unwrap());
        assert!(store.purge(&Retentions::default(), 1, false).await.unwrap().is_nothing());
    }
}
