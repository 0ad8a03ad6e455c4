//! SQLite and PostgreSQL behind one session type: transactions, bound values, rows, and time limits.
//!
//! [`Database::transaction`] is the only way to write and [`Database::read`] the only way to run several reads on one
//! snapshot: both take the work as a closure, commit when it returns `Ok` and roll back when it returns `Err`.
//!
//! No statement waits forever: a server that disappears without closing its connections would otherwise block its
//! clients. A statement that is not answered in time, and a transaction whose future is dropped before its end, close
//! their connection instead of returning it to the pool, so that no later caller receives a connection in an unknown
//! state.

use super::argument::Argument;
use super::dialect::{Dialect, Sql};
use super::driver_errors::{domain_error, is_end_of_session, lost, refuse_nul};
use super::migrations::{POSTGRES, SQLITE, migrator};
use crate::jobs::JobError;
use crate::store::layout::DATABASE_FILE;
use crate::store::private_files;
use crate::store::space::Space;
use sqlx::migrate::MigrateError;
use sqlx::pool::PoolConnection;
use sqlx::postgres::{PgConnectOptions, PgListener, PgPool, PgPoolOptions, PgRow};
use sqlx::sqlite::{
    SqliteConnectOptions, SqliteJournalMode, SqlitePool, SqlitePoolOptions, SqliteRow, SqliteSynchronous,
};
use sqlx::{AssertSqlSafe, ColumnIndex, ConnectOptions as _, Postgres, Row as _, Sqlite};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

/// Time limit for SQLite: for the write lock that another process holds, and for a free connection.
const SQLITE_TIMEOUT: Duration = Duration::from_secs(10);
/// How long the write-ahead log waits for its readers before it is emptied.
const CHECKPOINT_TIMEOUT: Duration = Duration::from_millis(200);
/// Time limit for one statement of PostgreSQL.
const POSTGRES_TIMEOUT: Duration = Duration::from_secs(10);
/// Time limit for a connection to PostgreSQL.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);
/// Time that a server has to take leave of this process at its exit.
const CLOSE_TIMEOUT: Duration = Duration::from_secs(2);
/// Pause before announcements of queued jobs are followed again after the connection for them was lost.
const RELISTEN_PAUSE: Duration = Duration::from_secs(5);
/// Read connections to SQLite; each is a thread, and reads are short.
pub(super) const READERS: u32 = 4;
/// A process that stalls inside a transaction keeps rows locked; PostgreSQL ends such a transaction after this time.
const IDLE_IN_TRANSACTION: &str = "SET idle_in_transaction_session_timeout = '30s'";
/// The NOTIFY channel on which processes announce queued jobs. The name must not change: processes of two versions share
/// it during a rolling update.
const CHANNEL: &str = "homolog_queued";

/// Location of the database.
#[derive(Debug, Clone)]
pub enum DatabaseLocation {
    /// `homolog.sqlite` in this folder.
    Folder(PathBuf),
    /// A PostgreSQL server.
    Postgres {
        /// `postgres://user:password@host/database`.
        url: String,
        /// Most connections that this process opens.
        max_connections: u32,
        /// Whether processes announce queued jobs to each other with LISTEN/NOTIFY.
        notify: bool,
    },
}

impl DatabaseLocation {
    /// Whether the folder contains a database. A server is assumed to have one, since only a connection could tell.
    pub fn is_there(&self) -> bool {
        match self {
            DatabaseLocation::Folder(folder) => folder.join(DATABASE_FILE).is_file(),
            DatabaseLocation::Postgres { .. } => true,
        }
    }
}

/// Connections to a database.
#[derive(Debug, Clone)]
pub(super) enum Database {
    /// One connection writes, [`READERS`] read.
    Sqlite { writer: SqlitePool, readers: SqlitePool, space: Arc<Space> },
    /// Every connection reads and writes.
    Postgres { pool: PgPool, notify: bool, space: Arc<Space> },
}

impl Database {
    /// Connects and runs pending migrations.
    pub(super) async fn open(location: &DatabaseLocation) -> Result<Self, JobError> {
        match location {
            DatabaseLocation::Folder(folder) => open_sqlite(folder).await,
            DatabaseLocation::Postgres { url, max_connections, notify } => {
                let options = PgConnectOptions::from_str(url).map_err(domain_error)?.application_name("homolog");
                let pool = PgPoolOptions::new()
                    .max_connections(*max_connections)
                    .acquire_timeout(CONNECT_TIMEOUT)
                    .after_connect(|connection, _| {
                        Box::pin(async move { sqlx::query(IDLE_IN_TRANSACTION).execute(connection).await.map(|_| ()) })
                    })
                    // Every statement has a time limit and failing connections are closed: no test query is needed.
                    .test_before_acquire(false)
                    .connect_with(options.clone())
                    .await;
                let pool = match pool {
                    // The pool waits for a server that starts, and says only that it found none in time.
                    Err(sqlx::Error::PoolTimedOut) => return Err(domain_error(why_unreachable(&options).await)),
                    pool => pool.map_err(domain_error)?,
                };
                migrator(POSTGRES).run(&pool).await.map_err(migration_error)?;
                Ok(Database::Postgres { pool, notify: *notify, space: Arc::default() })
            }
        }
    }

    pub(super) fn dialect(&self) -> Dialect {
        match self {
            Database::Sqlite { .. } => Dialect::Sqlite,
            Database::Postgres { .. } => Dialect::Postgres,
        }
    }

    /// Runs `work` in a transaction that may write: commits if it returns `Ok`, rolls back if it returns `Err`.
    ///
    /// On SQLite the transaction holds the only write lock from its first moment; on PostgreSQL `work` locks the rows on
    /// which it decides. When the returned future is dropped before its end, the connection is closed, which rolls back.
    ///
    /// # Errors
    /// Those of `work`; [`JobError::Unavailable`] if there is no connection or the commit fails.
    pub(super) async fn transaction<T>(
        &self,
        work: impl AsyncFnOnce(&mut Session) -> Result<T, JobError>,
    ) -> Result<T, JobError> {
        let link = match self {
            Database::Sqlite { writer, .. } => Link::Sqlite(Some(writer.acquire().await.map_err(domain_error)?)),
            Database::Postgres { pool, .. } => Link::Postgres(Some(acquire(pool).await?)),
        };
        // A SQLite transaction that began with a read would fail at its first write if another process had written
        // since.
        let begin = if matches!(link, Link::Sqlite(_)) { "BEGIN IMMEDIATE" } else { "BEGIN" };
        self.space().noted(in_transaction(link, begin, work).await)
    }

    /// Shares the memory of refused writes with another connection pool.
    pub(super) fn share_space(&mut self, of: &Database) {
        let other = match of {
            Database::Sqlite { space, .. } | Database::Postgres { space, .. } => Arc::clone(space),
        };
        match self {
            Database::Sqlite { space, .. } | Database::Postgres { space, .. } => *space = other,
        }
    }

    /// Whether the last writes found space.
    pub(super) fn space(&self) -> &Space {
        match self {
            Database::Sqlite { space, .. } | Database::Postgres { space, .. } => space,
        }
    }

    /// Runs `work` in a read-only transaction: all of its statements see the same snapshot.
    ///
    /// # Errors
    /// As for [`Database::transaction`].
    pub(super) async fn read<T>(
        &self,
        work: impl AsyncFnOnce(&mut Session) -> Result<T, JobError>,
    ) -> Result<T, JobError> {
        let link = self.reader().await?.into_link();
        let begin =
            if matches!(link, Link::Sqlite(_)) { "BEGIN" } else { "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY" };
        in_transaction(link, begin, work).await
    }

    /// A connection for single reads, each of which sees the data committed when it runs.
    pub(super) async fn reader(&self) -> Result<Session, JobError> {
        let link = match self {
            Database::Sqlite { readers, .. } => Link::Sqlite(Some(readers.acquire().await.map_err(domain_error)?)),
            Database::Postgres { pool, .. } => Link::Postgres(Some(acquire(pool).await?)),
        };
        Ok(Session { link, is_open: false, is_broken: false })
    }

    /// Closes all connections; SQLite then writes its write-ahead log back into the database file.
    pub(super) async fn close(&self) {
        match self {
            Database::Sqlite { writer, readers, .. } => {
                readers.close().await;
                writer.close().await;
            }
            // A server that does not answer must not delay the exit of this process.
            Database::Postgres { pool, .. } => drop(tokio::time::timeout(CLOSE_TIMEOUT, pool.close()).await),
        }
    }

    /// Writes SQLite's write-ahead log, which holds earlier versions of pages, back and empties it. `false` if a reader
    /// still needs it. PostgreSQL manages its own log.
    pub(super) async fn overwrite_deleted(&self) -> Result<bool, JobError> {
        let Database::Sqlite { writer, .. } = self else { return Ok(true) };
        let link = Link::Sqlite(Some(writer.acquire().await.map_err(domain_error)?));
        let mut session = Session { link, is_open: false, is_broken: false };
        // Readers need milliseconds, but a backup takes minutes, for which no writer should wait.
        session.run(&format!("PRAGMA busy_timeout = {}", CHECKPOINT_TIMEOUT.as_millis())).await?;
        let done = session.fetch("PRAGMA wal_checkpoint(TRUNCATE)".to_owned(), Vec::new()).await;
        session.run(&format!("PRAGMA busy_timeout = {}", SQLITE_TIMEOUT.as_millis())).await?;
        let is_busy = done?.first().map_or(Ok(0), |row| row.get::<i64>(0))?;
        Ok(is_busy == 0)
    }

    /// Notifies `wake` whenever another process announces a queued job. Never returns, even where announcements are
    /// disabled.
    pub(super) async fn follow_queued(&self, wake: &tokio::sync::Notify) {
        let Database::Postgres { pool, notify: true, .. } = self else { return std::future::pending().await };
        loop {
            let listened: Result<(), sqlx::Error> = async {
                let mut listener = PgListener::connect_with(pool).await?;
                listener.listen(CHANNEL).await?;
                loop {
                    listener.recv().await?;
                    wake.notify_one();
                }
            }
            .await;
            if let Err(error) = listened {
                tracing::debug!(%error, "no notifications from the database; the queue is still polled");
            }
            tokio::time::sleep(RELISTEN_PAUSE).await;
        }
    }

    /// Announces a queued job to other processes. Not in a transaction, because PostgreSQL serializes commits that
    /// notify.
    pub(super) async fn announce_queued(&self) {
        let Database::Postgres { notify: true, .. } = self else { return };
        if let Ok(mut session) = self.reader().await {
            let _ = session.run(&format!("NOTIFY {CHANNEL}")).await;
        }
    }
}

async fn acquire(pool: &PgPool) -> Result<PoolConnection<Postgres>, JobError> {
    pool.acquire().await.map_err(domain_error)
}

async fn in_transaction<T>(
    link: Link,
    begin: &'static str,
    work: impl AsyncFnOnce(&mut Session) -> Result<T, JobError>,
) -> Result<T, JobError> {
    // Marked as open before the statement is sent: if the future is dropped while waiting, the server may have begun it.
    let mut session = Session { link, is_open: true, is_broken: false };
    session.run(begin).await?;
    let done = work(&mut session).await;
    session.end(done).await
}

async fn open_sqlite(folder: &Path) -> Result<Database, JobError> {
    // Created here before SQLite creates it; SQLite's log gets the permissions of this file.
    let file = folder.join(DATABASE_FILE);
    tokio::task::spawn_blocking(move || private_files::create(&file))
        .await
        .map_err(|join| JobError::Unavailable(Box::new(join)))?
        .map_err(|error| JobError::Unavailable(Box::new(error)))?;
    let options = SqliteConnectOptions::new()
        .filename(folder.join(DATABASE_FILE))
        .create_if_missing(true)
        .journal_mode(SqliteJournalMode::Wal)
        .synchronous(SqliteSynchronous::Full)
        .foreign_keys(true)
        // Overwrites deleted content in the pages of the file; see also `Database::overwrite_deleted`.
        .pragma("secure_delete", "ON")
        .busy_timeout(SQLITE_TIMEOUT);
    // Processes that start together migrate one after the other: SQLite has no lock that spans all migrations.
    let lock = MigrationLock::acquire(folder.to_owned()).await?;
    let writer = SqlitePoolOptions::new()
        .max_connections(1)
        .acquire_timeout(SQLITE_TIMEOUT)
        .connect_with(options.clone())
        .await
        .map_err(domain_error)?;
    migrator(SQLITE).run(&writer).await.map_err(migration_error)?;
    drop(lock);
    let readers = SqlitePoolOptions::new()
        .max_connections(READERS)
        .acquire_timeout(SQLITE_TIMEOUT)
        .connect_with(options.pragma("query_only", "ON"))
        .await
        .map_err(domain_error)?;
    Ok(Database::Sqlite { writer, readers, space: Arc::default() })
}

/// Error of a single connection to a server to which a pool finds no connection.
async fn why_unreachable(options: &PgConnectOptions) -> sqlx::Error {
    match tokio::time::timeout(CONNECT_TIMEOUT, options.connect()).await {
        Ok(Err(error)) => error,
        Ok(Ok(_)) | Err(_) => sqlx::Error::PoolTimedOut,
    }
}

/// A migration that this program does not know is one of a newer release.
fn migration_error(error: MigrateError) -> JobError {
    JobError::Unavailable(match error {
        MigrateError::VersionMissing(version) => format!(
            "the database has the schema of a newer release (migration {version}); start that release, or restore the backup made \
             before the upgrade"
        )
        .into(),
        error => Box::new(error),
    })
}

/// The right to run migrations: an exclusive lock on a file, released when dropped.
struct MigrationLock {
    _file: std::fs::File,
}

impl MigrationLock {
    async fn acquire(folder: PathBuf) -> Result<Self, JobError> {
        let locked = tokio::task::spawn_blocking(move || {
            let path = folder.join("migration.lock");
            let file = private_files::options().create(true).truncate(false).write(true).open(path)?;
            file.lock()?;
            Ok(MigrationLock { _file: file })
        });
        match locked.await {
            Ok(lock) => lock.map_err(|e: std::io::Error| JobError::Unavailable(Box::new(e))),
            Err(join) => Err(JobError::Unavailable(Box::new(join))),
        }
    }
}

#[derive(Debug)]
enum Link {
    Sqlite(Option<PoolConnection<Sqlite>>),
    Postgres(Option<PoolConnection<Postgres>>),
}

/// A connection taken from a pool, in a transaction or not.
#[derive(Debug)]
pub(super) struct Session {
    link: Link,
    /// A transaction is open.
    is_open: bool,
    /// A statement is unanswered: it is still running, or its answer did not arrive in time.
    is_broken: bool,
}

impl Drop for Session {
    fn drop(&mut self) {
        if !self.is_open && !self.is_broken {
            return;
        }
        // The connection is not returned to the pool; closing it rolls back.
        match &mut self.link {
            Link::Sqlite(held) => drop(held.take().map(PoolConnection::detach)),
            Link::Postgres(held) => drop(held.take().map(PoolConnection::detach)),
        }
    }
}

/// A row of a result set.
#[derive(Debug)]
pub(super) enum Row {
    Sqlite(SqliteRow),
    Postgres(PgRow),
}

/// A Rust type into which a column of either database can be read.
pub(super) trait Column:
    for<'r> sqlx::Decode<'r, Sqlite> + sqlx::Type<Sqlite> + for<'r> sqlx::Decode<'r, Postgres> + sqlx::Type<Postgres>
{
}
impl<T> Column for T where
    T: for<'r> sqlx::Decode<'r, Sqlite>
        + sqlx::Type<Sqlite>
        + for<'r> sqlx::Decode<'r, Postgres>
        + sqlx::Type<Postgres>
{
}

impl Row {
    /// The value of a column, by name or index.
    pub(super) fn get<T: Column>(
        &self,
        column: impl ColumnIndex<SqliteRow> + ColumnIndex<PgRow>,
    ) -> Result<T, JobError> {
        match self {
            Row::Sqlite(row) => row.try_get(column),
            Row::Postgres(row) => row.try_get(column),
        }
        .map_err(|error| JobError::corrupt("a row", error))
    }

    /// The value of a column that holds a count.
    pub(super) fn count(&self, column: impl ColumnIndex<SqliteRow> + ColumnIndex<PgRow>) -> Result<u32, JobError> {
        let value: i64 = self.get(column)?;
        u32::try_from(value).map_err(|error| JobError::corrupt("a count", error))
    }
}

macro_rules! bound {
    ($query:ident, $arguments:ident) => {
        for argument in $arguments {
            $query = match argument {
                Argument::Text(value) => $query.bind(value),
                Argument::Integer(value) => $query.bind(value),
                Argument::Real(value) => $query.bind(value),
                Argument::Flag(value) => $query.bind(value),
            };
        }
    };
}

impl Session {
    fn into_link(mut self) -> Link {
        match &mut self.link {
            Link::Sqlite(held) => Link::Sqlite(held.take()),
            Link::Postgres(held) => Link::Postgres(held.take()),
        }
    }

    /// Runs a statement and returns the number of rows that it changed.
    pub(super) async fn execute(&mut self, sql: &'static Sql, arguments: Vec<Argument>) -> Result<u64, JobError> {
        refuse_nul(&arguments)?;
        self.is_broken = true;
        let done = match &mut self.link {
            Link::Sqlite(Some(connection)) => {
                let mut query = sqlx::query(sql.text(Dialect::Sqlite));
                bound!(query, arguments);
                in_time(SQLITE_TIMEOUT, query.execute(&mut **connection)).await.map(|done| done.rows_affected())
            }
            Link::Postgres(Some(connection)) => {
                let mut query = sqlx::query(sql.text(Dialect::Postgres));
                bound!(query, arguments);
                in_time(POSTGRES_TIMEOUT, query.execute(&mut **connection)).await.map(|done| done.rows_affected())
            }
            _ => Err(lost()),
        };
        self.note_answer(done)
    }

    /// Runs a query and returns its rows.
    pub(super) async fn rows(&mut self, sql: &'static Sql, arguments: Vec<Argument>) -> Result<Vec<Row>, JobError> {
        let text = match &self.link {
            Link::Sqlite(_) => sql.text(Dialect::Sqlite),
            Link::Postgres(_) => sql.text(Dialect::Postgres),
        };
        self.fetch(text.to_owned(), arguments).await
    }

    /// Runs a query whose text is assembled at run time, from constant parts only, and returns its rows.
    pub(super) async fn fetch(&mut self, text: String, arguments: Vec<Argument>) -> Result<Vec<Row>, JobError> {
        refuse_nul(&arguments)?;
        self.is_broken = true;
        let rows = match &mut self.link {
            Link::Sqlite(Some(connection)) => {
                let mut query = sqlx::query(AssertSqlSafe(text));
                bound!(query, arguments);
                let rows = in_time(SQLITE_TIMEOUT, query.fetch_all(&mut **connection)).await;
                rows.map(|rows| rows.into_iter().map(Row::Sqlite).collect())
            }
            Link::Postgres(Some(connection)) => {
                let mut query = sqlx::query(AssertSqlSafe(text));
                bound!(query, arguments);
                let rows = in_time(POSTGRES_TIMEOUT, query.fetch_all(&mut **connection)).await;
                rows.map(|rows| rows.into_iter().map(Row::Postgres).collect())
            }
            _ => Err(lost()),
        };
        self.note_answer(rows)
    }

    /// Runs a query and returns its first row.
    pub(super) async fn row(&mut self, sql: &'static Sql, arguments: Vec<Argument>) -> Result<Option<Row>, JobError> {
        Ok(self.rows(sql, arguments).await?.into_iter().next())
    }

    /// Runs a query and returns the first column of its first row.
    pub(super) async fn value<T: Column>(
        &mut self,
        sql: &'static Sql,
        arguments: Vec<Argument>,
    ) -> Result<Option<T>, JobError> {
        self.row(sql, arguments).await?.map(|row| row.get(0)).transpose()
    }

    /// Runs a statement without parameters, unprepared.
    async fn run(&mut self, text: &str) -> Result<(), JobError> {
        self.is_broken = true;
        let text = AssertSqlSafe(text.to_owned());
        let done = match &mut self.link {
            Link::Sqlite(Some(connection)) => {
                in_time(SQLITE_TIMEOUT + Duration::from_secs(2), sqlx::raw_sql(text).execute(&mut **connection))
                    .await
                    .map(|_| ())
            }
            Link::Postgres(Some(connection)) => {
                in_time(POSTGRES_TIMEOUT, sqlx::raw_sql(text).execute(&mut **connection)).await.map(|_| ())
            }
            _ => Err(lost()),
        };
        self.note_answer(done)
    }

    /// Commits if `done` is `Ok`, else rolls back. Returns `done`, or the error of the commit.
    async fn end<T>(mut self, done: Result<T, JobError>) -> Result<T, JobError> {
        if self.is_broken {
            return done; // dropping `self` closes the connection
        }
        self.run(if done.is_ok() { "COMMIT" } else { "ROLLBACK" }).await.or_else(|error| match &done {
            Ok(_) => Err(error),
            Err(_) => Ok(()), // the error in `done` says more than the error of the rollback
        })?;
        self.is_open = false;
        done
    }

    /// Marks the connection as broken unless the server answered, even if with an error.
    fn note_answer<T>(&mut self, answer: Result<T, sqlx::Error>) -> Result<T, JobError> {
        self.is_broken = matches!(
            &answer,
            Err(sqlx::Error::Io(_) | sqlx::Error::Protocol(_) | sqlx::Error::Tls(_) | sqlx::Error::WorkerCrashed)
        ) || answer.as_ref().err().is_some_and(is_end_of_session);
        answer.map_err(domain_error)
    }
}

async fn in_time<T>(limit: Duration, answer: impl Future<Output = Result<T, sqlx::Error>>) -> Result<T, sqlx::Error> {
    match tokio::time::timeout(limit, answer).await {
        Ok(answer) => answer,
        Err(_) => {
            Err(sqlx::Error::Io(std::io::Error::new(std::io::ErrorKind::TimedOut, "the database did not answer")))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::sql::argument::bind;
    use crate::store::sql::dialect::sql;

    async fn sqlite() -> (tempfile::TempDir, Database) {
        let folder = tempfile::tempdir().unwrap();
        let database = Database::open(&DatabaseLocation::Folder(folder.path().to_owned())).await.unwrap();
        (folder, database)
    }

    async fn insert_batch(session: &mut Session, id: &str) -> Result<u64, JobError> {
        session.execute(sql!("insert_batch"), bind![id, "default", 1i64, "{}", None::<&str>]).await
    }

    async fn has_batch(database: &Database, id: &str) -> bool {
        database.reader().await.unwrap().row(sql!("get_batch"), bind![id, "default"]).await.unwrap().is_some()
    }

    #[tokio::test]
    async fn a_transaction_commits_on_ok_and_rolls_back_on_err() {
        let (_folder, database) = sqlite().await;
        database.transaction(async |session| insert_batch(session, "kept").await).await.unwrap();
        let refused: Result<(), _> = database
            .transaction(async |session| {
                insert_batch(session, "undone").await?;
                Err(JobError::BatchNotFound)
            })
            .await;
        assert!(matches!(refused, Err(JobError::BatchNotFound)), "the error of the work is returned");
        assert!(has_batch(&database, "kept").await);
        assert!(!has_batch(&database, "undone").await);
    }

    #[tokio::test]
    async fn a_transaction_that_is_dropped_closes_its_connection() {
        let (_folder, database) = sqlite().await;
        let Database::Sqlite { writer, .. } = &database else { unreachable!() };
        assert_eq!(writer.size(), 1);
        let stuck = database.transaction(async |session| {
            insert_batch(session, "undone").await?;
            std::future::pending::<Result<(), JobError>>().await
        });
        tokio::time::timeout(Duration::from_millis(100), stuck).await.unwrap_err();
        assert_eq!(writer.size(), 0, "the connection is closed and not given back");
        // The only writer is free again, and its changes were rolled back.
        database.transaction(async |session| insert_batch(session, "kept").await).await.unwrap();
        assert!(has_batch(&database, "kept").await);
        assert!(!has_batch(&database, "undone").await);
    }

    #[tokio::test]
    async fn a_database_without_space_says_so_for_a_while() {
        let (_folder, database) = sqlite().await;
        database.space().check().unwrap();
        let filled = database
            .transaction(async |session| {
                session.fetch("PRAGMA max_page_count = 1".to_owned(), Vec::new()).await?;
                for k in 0..1000 {
                    insert_batch(session, &format!("{k:01000}")).await?;
                }
                Ok(())
            })
            .await;
        assert!(matches!(filled, Err(JobError::StorageFull)), "{filled:?}");
        assert!(matches!(database.space().check(), Err(JobError::StorageFull)));
    }

    #[tokio::test]
    async fn a_read_sees_one_snapshot_and_cannot_write() {
        let (_folder, database) = sqlite().await;
        database
            .read(async |session| {
                assert!(session.row(sql!("get_batch"), bind!["late", "default"]).await?.is_none());
                database.transaction(async |writing| insert_batch(writing, "late").await).await?;
                assert!(session.row(sql!("get_batch"), bind!["late", "default"]).await?.is_none());
                Ok(())
            })
            .await
            .unwrap();
        assert!(has_batch(&database, "late").await);
        let written = database.read(async |session| insert_batch(session, "forbidden").await).await;
        assert!(matches!(written, Err(JobError::Unavailable(_))), "{written:?}");
    }
}
