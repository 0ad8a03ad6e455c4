//! Conversion of driver errors to errors of the port.

use super::argument::Argument;
use crate::jobs::JobError;

/// Whether the server is closing this session, for example because it shuts down.
pub(super) fn is_end_of_session(error: &sqlx::Error) -> bool {
    // Class 57P: operator intervention; 25P03: idle in a transaction for too long; class 08: connection exceptions.
    let code = error.as_database_error().and_then(|e| e.code());
    code.is_some_and(|code| code.starts_with("57P") || code == "25P03" || code.starts_with("08"))
}

/// PostgreSQL stores no NUL character, and SQLite's functions stop at one. For both databases such a text is refused
/// before it is sent, as a fault of the request and not of the database.
pub(super) fn refuse_nul(arguments: &[Argument]) -> Result<(), JobError> {
    let has_nul = |argument: &Argument| matches!(argument, Argument::Text(Some(text)) if text.contains('\0'));
    if arguments.iter().any(has_nul) { Err(JobError::Unstorable) } else { Ok(()) }
}

pub(super) fn lost() -> sqlx::Error {
    sqlx::Error::PoolClosed
}

/// The [`JobError`] for an error of a driver.
pub(super) fn domain_error(error: sqlx::Error) -> JobError {
    // SQLITE_FULL, with or without an extended code in the higher bits; PostgreSQL's disk_full.
    const SQLITE_FULL: i64 = 13;
    const DISK_FULL: &str = "53100";
    let code = error.as_database_error().and_then(|e| e.code());
    let is_full = code.is_some_and(|code| {
        code == DISK_FULL || (code.len() < 5 && code.parse::<i64>().is_ok_and(|code| code & 0xff == SQLITE_FULL))
    });
    if is_full { JobError::StorageFull } else { JobError::Unavailable(Box::new(error)) }
}
