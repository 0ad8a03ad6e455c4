//! Operations on a whole database: counting its connections, and copying and checking a SQLite database.

use super::database::{Database, READERS};
use super::driver_errors::{domain_error, lost};
use crate::jobs::JobError;
use std::path::Path;

impl Database {
    /// The numbers of connections in use, of open connections, and of connections that may be open at most.
    pub(super) fn connections(&self) -> (u32, u32, u32) {
        let counts = |size: u32, idle: usize, most: u32| {
            (size.saturating_sub(u32::try_from(idle).unwrap_or(u32::MAX)), size, most)
        };
        match self {
            Database::Sqlite { writer, readers, .. } => {
                let idle = writer.num_idle() + readers.num_idle();
                counts(writer.size() + readers.size(), idle, READERS + 1)
            }
            Database::Postgres { pool, .. } => {
                counts(pool.size(), pool.num_idle(), pool.options().get_max_connections())
            }
        }
    }

    /// Copies one state of a SQLite database into an empty file, while others write. Has no time limit.
    pub(super) async fn copy_into(&self, file: &Path) -> Result<(), JobError> {
        let Database::Sqlite { writer, .. } = self else { return Err(domain_error(lost())) };
        let mut connection = writer.acquire().await.map_err(domain_error)?;
        let copied = sqlx::query("VACUUM INTO $1").bind(file.to_string_lossy().into_owned()).execute(&mut *connection);
        copied.await.map(|_| ()).map_err(domain_error)
    }

    /// Whether a SQLite database has no damaged page, row or index.
    pub(super) async fn is_intact(&self) -> Result<bool, JobError> {
        let Database::Sqlite { readers, .. } = self else { return Err(domain_error(lost())) };
        let mut connection = readers.acquire().await.map_err(domain_error)?;
        let found = sqlx::query_scalar("PRAGMA integrity_check").fetch_all(&mut *connection).await;
        found.map(|found: Vec<String>| found == ["ok"]).map_err(domain_error)
    }
}
