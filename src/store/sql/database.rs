//! The two databases behind one session: what is bound, what comes back, and who waits for how long.
//!
//! No statement waits for ever: a server that is gone without closing its connections would hold up whoever asks. A
//! statement that is not answered in time, or a transaction that is dropped in the middle, closes its connection
//! instead of giving it back, so that nobody inherits what is half-done.

use super::dialect::{Dialect, Sql};
use crate::jobs::JobError;
use sqlx::migrate::{Migration, MigrationType, Migrator};
use sqlx::pool::PoolConnection;
use sqlx::postgres::{PgConnectOptions, PgListener, PgPool, PgPoolOptions, PgRow};
use sqlx::sqlite::{
    SqliteConnectOptions, SqliteJournalMode, SqlitePool, SqlitePoolOptions, SqliteRow, SqliteSynchronous,
};
use sqlx::{AssertSqlSafe, ColumnIndex, Postgres, Row as _, SqlSafeStr as _, Sqlite};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Duration;

/// Migrations in their order: version, description, text. Listed here because the macro that reads the folder would build
/// both database drivers a second time, for the compiler.
const SQLITE_MIGRATIONS: &[(i64, &str, &str)] = &[
    (1, "jobs", include_str!("migrations/sqlite/0001_jobs.sql")),
    (2, "service", include_str!("migrations/sqlite/0002_service.sql")),
];
/// The same for PostgreSQL.
const POSTGRES_MIGRATIONS: &[(i64, &str, &str)] =
    &[(1, "service", include_str!("migrations/postgres/0001_service.sql"))];

/// Longest wait for SQLite: for another process's write, or a free connection.
const SQLITE_PATIENCE: Duration = Duration::from_secs(10);
/// Longest wait for an answer of PostgreSQL.
const POSTGRES_PATIENCE: Duration = Duration::from_secs(10);
/// Longest wait for a connection to PostgreSQL.
const CONNECT_PATIENCE: Duration = Duration::from_secs(5);
/// SQLite readers; each is a thread, and reads here are short.
const READERS: u32 = 4;
/// A process that sleeps in a transaction keeps rows locked; PostgreSQL ends such a transaction after this time.
const IDLE_IN_TRANSACTION: &str = "SET idle_in_transaction_session_timeout = '30s'";
/// The channel of hints.
const CHANNEL: &str = "homolog_queued";

fn migrator(migrations: &[(i64, &'static str, &'static str)]) -> Migrator {
    let migration = |&(version, description, text): &(i64, &'static str, &'static str)| {
        Migration::new(version, description.into(), MigrationType::Simple, text.into_sql_str(), false)
    };
    Migrator::with_migrations(migrations.iter().map(migration).collect())
}

/// Where jobs are.
#[derive(Debug, Clone)]
pub enum DatabaseLocation {
    /// `homolog.sqlite` in this folder.
    Folder(PathBuf),
    /// A PostgreSQL server.
    Postgres {
        /// `postgres://user:password@host/database`.
        url: String,
        /// Most connections of this process.
        max_connections: u32,
        /// Whether hints are given and listened to.
        notify: bool,
    },
}

/// The file of a SQLite database in its folder.
const SQLITE_FILE: &str = "homolog.sqlite";

impl DatabaseLocation {
    /// Whether the folder holds a database. A server is taken to have one: only connecting to it can tell.
    pub fn is_there(&self) -> bool {
        match self {
            DatabaseLocation::Folder(folder) => folder.join(SQLITE_FILE).is_file(),
            DatabaseLocation::Postgres { .. } => true,
        }
    }
}

/// Connections to a database.
#[derive(Debug, Clone)]
pub(super) enum Database {
    /// One connection writes, some read.
    Sqlite { writer: SqlitePool, readers: SqlitePool },
    /// Any connection does anything.
    Postgres { pool: PgPool, notify: bool },
}

impl Database {
    /// Connects, and brings the tables up to date.
    pub(super) async fn open(location: &DatabaseLocation) -> Result<Self, JobError> {
        match location {
            DatabaseLocation::Folder(folder) => open_sqlite(folder).await,
            DatabaseLocation::Postgres { url, max_connections, notify } => {
                let options = PgConnectOptions::from_str(url).map_err(domain_error)?.application_name("homolog");
                let pool = PgPoolOptions::new()
                    .max_connections(*max_connections)
                    .acquire_timeout(CONNECT_PATIENCE)
                    .after_connect(|connection, _| {
                        Box::pin(async move { sqlx::query(IDLE_IN_TRANSACTION).execute(connection).await.map(|_| ()) })
                    })
                    // Every statement has its time limit and failing connections are closed: no need to ask each time.
                    .test_before_acquire(false)
                    .connect_with(options)
                    .await
                    .map_err(domain_error)?;
                migrator(POSTGRES_MIGRATIONS).run(&pool).await.map_err(|e| JobError::Unavailable(Box::new(e)))?;
                Ok(Database::Postgres { pool, notify: *notify })
            }
        }
    }

    pub(super) fn dialect(&self) -> Dialect {
        match self {
            Database::Sqlite { .. } => Dialect::Sqlite,
            Database::Postgres { .. } => Dialect::Postgres,
        }
    }

    /// A connection for single statements that read.
    pub(super) async fn reading(&self) -> Result<Session, JobError> {
        let link = match self {
            Database::Sqlite { readers, .. } => Link::Sqlite(Some(readers.acquire().await.map_err(domain_error)?)),
            Database::Postgres { pool, .. } => Link::Postgres(Some(acquire(pool).await?)),
        };
        Ok(Session { link, is_open: false, is_broken: false })
    }

    /// A transaction that writes. In SQLite it is the only one meanwhile.
    pub(super) async fn begin(&self) -> Result<Session, JobError> {
        let link = match self {
            Database::Sqlite { writer, .. } => Link::Sqlite(Some(writer.acquire().await.map_err(domain_error)?)),
            Database::Postgres { pool, .. } => Link::Postgres(Some(acquire(pool).await?)),
        };
        // One that began as a reader and became a writer would be refused at once when another process writes.
        let begin = if matches!(link, Link::Sqlite(_)) { "BEGIN IMMEDIATE" } else { "BEGIN" };
        open_transaction(link, begin).await
    }

    /// A transaction that reads at one moment.
    pub(super) async fn snapshot(&self) -> Result<Session, JobError> {
        let link = self.reading().await?.into_link();
        let begin =
            if matches!(link, Link::Sqlite(_)) { "BEGIN" } else { "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY" };
        open_transaction(link, begin).await
    }

    /// Ends all connections; SQLite's write-ahead log is written back.
    pub(super) async fn close(&self) {
        match self {
            Database::Sqlite { writer, readers } => {
                readers.close().await;
                writer.close().await;
            }
            // A server that is gone must not hold up the end of this process.
            Database::Postgres { pool, .. } => drop(tokio::time::timeout(Duration::from_secs(2), pool.close()).await),
        }
    }

    /// Passes hints on for ever; never returns, also where there are none.
    pub(super) async fn follow_hints(&self, wake: &tokio::sync::Notify) {
        let Database::Postgres { pool, notify: true } = self else { return std::future::pending().await };
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
                tracing::debug!(%error, "no hints of the database; polling goes on");
            }
            tokio::time::sleep(Duration::from_secs(5)).await;
        }
    }

    /// Sends a hint. Outside of transactions: commits that notify wait for one another.
    pub(super) async fn give_hint(&self) {
        let Database::Postgres { notify: true, .. } = self else { return };
        if let Ok(mut session) = self.reading().await {
            let _ = session.run(&format!("NOTIFY {CHANNEL}")).await;
        }
    }
}

async fn acquire(pool: &PgPool) -> Result<PoolConnection<Postgres>, JobError> {
    pool.acquire().await.map_err(domain_error)
}

async fn open_transaction(link: Link, begin: &'static str) -> Result<Session, JobError> {
    let mut session = Session { link, is_open: true, is_broken: false };
    session.run(begin).await?;
    Ok(session)
}

async fn open_sqlite(folder: &Path) -> Result<Database, JobError> {
    let options = SqliteConnectOptions::new()
        .filename(folder.join(SQLITE_FILE))
        .create_if_missing(true)
        .journal_mode(SqliteJournalMode::Wal)
        .synchronous(SqliteSynchronous::Full)
        .foreign_keys(true)
        .busy_timeout(SQLITE_PATIENCE);
    // Processes that start together take turns: SQLite itself has no lock that spans all migrations.
    let turn = MigrationTurn::wait(folder.to_owned()).await?;
    let writer = SqlitePoolOptions::new()
        .max_connections(1)
        .acquire_timeout(SQLITE_PATIENCE)
        .connect_with(options.clone())
        .await
        .map_err(domain_error)?;
    migrator(SQLITE_MIGRATIONS).run(&writer).await.map_err(|e| JobError::Unavailable(Box::new(e)))?;
    drop(turn);
    let readers = SqlitePoolOptions::new()
        .max_connections(READERS)
        .acquire_timeout(SQLITE_PATIENCE)
        .connect_with(options.pragma("query_only", "ON"))
        .await
        .map_err(domain_error)?;
    Ok(Database::Sqlite { writer, readers })
}

/// The right to run migrations, an exclusive lock on a file.
struct MigrationTurn {
    _lock: std::fs::File,
}

impl MigrationTurn {
    async fn wait(folder: PathBuf) -> Result<Self, JobError> {
        let locked = tokio::task::spawn_blocking(move || {
            let path = folder.join("migration.lock");
            let lock = std::fs::File::options().create(true).truncate(false).write(true).open(path)?;
            lock.lock()?;
            Ok(MigrationTurn { _lock: lock })
        });
        match locked.await {
            Ok(turn) => turn.map_err(|e: std::io::Error| JobError::Unavailable(Box::new(e))),
            Err(join) => Err(JobError::Unavailable(Box::new(join))),
        }
    }
}

#[derive(Debug)]
enum Link {
    Sqlite(Option<PoolConnection<Sqlite>>),
    Postgres(Option<PoolConnection<Postgres>>),
}

/// A connection in use, in a transaction or not.
#[derive(Debug)]
pub(super) struct Session {
    link: Link,
    /// A transaction is open.
    is_open: bool,
    /// An answer is outstanding, or did not come in time.
    is_broken: bool,
}

impl Drop for Session {
    fn drop(&mut self) {
        if !self.is_open && !self.is_broken {
            return;
        }
        // Closing the connection rolls back.
        match &mut self.link {
            Link::Sqlite(held) => drop(held.take().map(PoolConnection::detach)),
            Link::Postgres(held) => drop(held.take().map(PoolConnection::detach)),
        }
    }
}

/// A value to be bound.
#[derive(Debug, Clone)]
pub(super) enum Argument {
    Text(Option<String>),
    Integer(Option<i64>),
    Real(Option<f64>),
    Flag(bool),
}

macro_rules! arguments_from {
    ($($type:ty => |$value:ident| $argument:expr;)*) => {
        $(impl From<$type> for Argument {
            fn from($value: $type) -> Self {
                $argument
            }
        })*
    };
}

arguments_from! {
    &str => |v| Argument::Text(Some(v.to_owned()));
    &String => |v| Argument::Text(Some(v.clone()));
    String => |v| Argument::Text(Some(v));
    Option<String> => |v| Argument::Text(v);
    &Option<String> => |v| Argument::Text(v.clone());
    Option<&str> => |v| Argument::Text(v.map(str::to_owned));
    i64 => |v| Argument::Integer(Some(v));
    i32 => |v| Argument::Integer(Some(v.into()));
    u32 => |v| Argument::Integer(Some(v.into()));
    u64 => |v| Argument::Integer(Some(i64::try_from(v).unwrap_or(i64::MAX)));
    Option<i64> => |v| Argument::Integer(v);
    Option<u64> => |v| Argument::Integer(v.map(|v| i64::try_from(v).unwrap_or(i64::MAX)));
    Option<u32> => |v| Argument::Integer(v.map(i64::from));
    f64 => |v| Argument::Real(Some(v));
    Option<f64> => |v| Argument::Real(v);
    bool => |v| Argument::Flag(v);
    std::time::Duration => |v| Argument::Integer(Some(milliseconds(v)));
    Option<std::time::Duration> => |v| Argument::Integer(v.map(milliseconds));
    crate::jobs::JobId => |v| Argument::Text(Some(v.to_string()));
    Option<crate::jobs::JobId> => |v| Argument::Text(v.map(|id| id.to_string()));
    crate::jobs::BatchId => |v| Argument::Text(Some(v.to_string()));
    Option<crate::jobs::BatchId> => |v| Argument::Text(v.map(|id| id.to_string()));
    crate::jobs::JobState => |v| Argument::Text(Some(v.name().to_owned()));
    &crate::jobs::Tenant => |v| Argument::Text(Some(v.name().to_owned()));
    Option<jiff::Timestamp> => |v| Argument::Integer(v.map(jiff::Timestamp::as_millisecond));
}

/// A duration in the database's unit.
fn milliseconds(duration: Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX / 4)
}

/// Values for a statement, in order.
macro_rules! bind {
    ($($value:expr),* $(,)?) => {
        vec![$($crate::store::sql::database::Argument::from($value)),*]
    };
}
pub(super) use bind;

/// A row of an answer.
#[derive(Debug)]
pub(super) enum Row {
    Sqlite(SqliteRow),
    Postgres(PgRow),
}

/// What a column may be read as, in both databases.
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
    /// A column by name or place.
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

    /// A column that counts something.
    pub(super) fn count(&self, column: impl ColumnIndex<SqliteRow> + ColumnIndex<PgRow>) -> Result<u32, JobError> {
        let value: i64 = self.get(column)?;
        u32::try_from(value).map_err(|error| JobError::corrupt("a number", error))
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

    /// Does a statement; returns how many rows it changed.
    pub(super) async fn execute(&mut self, sql: &'static Sql, arguments: Vec<Argument>) -> Result<u64, JobError> {
        self.is_broken = true;
        let done = match &mut self.link {
            Link::Sqlite(Some(connection)) => {
                let mut query = sqlx::query(sql.text(Dialect::Sqlite));
                bound!(query, arguments);
                in_time(SQLITE_PATIENCE, query.execute(&mut **connection)).await.map(|done| done.rows_affected())
            }
            Link::Postgres(Some(connection)) => {
                let mut query = sqlx::query(sql.text(Dialect::Postgres));
                bound!(query, arguments);
                in_time(POSTGRES_PATIENCE, query.execute(&mut **connection)).await.map(|done| done.rows_affected())
            }
            _ => Err(lost()),
        };
        self.judge(done)
    }

    /// Reads rows.
    pub(super) async fn rows(&mut self, sql: &'static Sql, arguments: Vec<Argument>) -> Result<Vec<Row>, JobError> {
        let text = match &self.link {
            Link::Sqlite(_) => sql.text(Dialect::Sqlite),
            Link::Postgres(_) => sql.text(Dialect::Postgres),
        };
        self.fetch(text.to_owned(), arguments).await
    }

    /// Reads rows of a text made at run time, from constant parts only.
    pub(super) async fn fetch(&mut self, text: String, arguments: Vec<Argument>) -> Result<Vec<Row>, JobError> {
        self.is_broken = true;
        let rows = match &mut self.link {
            Link::Sqlite(Some(connection)) => {
                let mut query = sqlx::query(AssertSqlSafe(text));
                bound!(query, arguments);
                let rows = in_time(SQLITE_PATIENCE, query.fetch_all(&mut **connection)).await;
                rows.map(|rows| rows.into_iter().map(Row::Sqlite).collect())
            }
            Link::Postgres(Some(connection)) => {
                let mut query = sqlx::query(AssertSqlSafe(text));
                bound!(query, arguments);
                let rows = in_time(POSTGRES_PATIENCE, query.fetch_all(&mut **connection)).await;
                rows.map(|rows| rows.into_iter().map(Row::Postgres).collect())
            }
            _ => Err(lost()),
        };
        self.judge(rows)
    }

    /// Reads a row, if there is one.
    pub(super) async fn row(&mut self, sql: &'static Sql, arguments: Vec<Argument>) -> Result<Option<Row>, JobError> {
        Ok(self.rows(sql, arguments).await?.into_iter().next())
    }

    /// Reads the first column of a row, if there is one.
    pub(super) async fn value<T: Column>(
        &mut self,
        sql: &'static Sql,
        arguments: Vec<Argument>,
    ) -> Result<Option<T>, JobError> {
        self.row(sql, arguments).await?.map(|row| row.get(0)).transpose()
    }

    /// Does a statement without parameters, unprepared.
    async fn run(&mut self, text: &str) -> Result<(), JobError> {
        self.is_broken = true;
        let text = AssertSqlSafe(text.to_owned());
        let done = match &mut self.link {
            Link::Sqlite(Some(connection)) => {
                in_time(SQLITE_PATIENCE + Duration::from_secs(2), sqlx::raw_sql(text).execute(&mut **connection))
                    .await
                    .map(|_| ())
            }
            Link::Postgres(Some(connection)) => {
                in_time(POSTGRES_PATIENCE, sqlx::raw_sql(text).execute(&mut **connection)).await.map(|_| ())
            }
            _ => Err(lost()),
        };
        self.judge(done)
    }

    /// Ends the transaction: commits if all went well, else undoes it. Returns what was done.
    pub(super) async fn end<T>(mut self, done: Result<T, JobError>) -> Result<T, JobError> {
        if self.is_broken {
            return done; // dropped, and so closed
        }
        self.run(if done.is_ok() { "COMMIT" } else { "ROLLBACK" }).await.or_else(|error| match &done {
            Ok(_) => Err(error),
            Err(_) => Ok(()), // the first error says more
        })?;
        self.is_open = false;
        done
    }

    /// Keeps the connection if the server answered, with whatever.
    fn judge<T>(&mut self, answer: Result<T, sqlx::Error>) -> Result<T, JobError> {
        self.is_broken = matches!(
            &answer,
            Err(sqlx::Error::Io(_) | sqlx::Error::Protocol(_) | sqlx::Error::Tls(_) | sqlx::Error::WorkerCrashed)
        ) || answer.as_ref().err().is_some_and(is_end_of_session);
        answer.map_err(domain_error)
    }
}

/// Whether the server said that it ends this session, as when it shuts down.
fn is_end_of_session(error: &sqlx::Error) -> bool {
    // Class 57P: operator intervention; 25P03: idle in a transaction for too long; class 08: connection exceptions.
    let code = error.as_database_error().and_then(|e| e.code());
    code.is_some_and(|code| code.starts_with("57P") || code == "25P03" || code.starts_with("08"))
}

async fn in_time<T>(
    patience: Duration,
    answer: impl Future<Output = Result<T, sqlx::Error>>,
) -> Result<T, sqlx::Error> {
    match tokio::time::timeout(patience, answer).await {
        Ok(answer) => answer,
        Err(_) => {
            Err(sqlx::Error::Io(std::io::Error::new(std::io::ErrorKind::TimedOut, "the database did not answer")))
        }
    }
}

fn lost() -> sqlx::Error {
    sqlx::Error::PoolClosed
}

/// What a failure of a driver means to jobs.
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_migration_file_is_listed_with_the_version_and_description_of_its_name() {
        for (folder, listed) in [("sqlite", SQLITE_MIGRATIONS), ("postgres", POSTGRES_MIGRATIONS)] {
            let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/store/sql/migrations").join(folder);
            let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
            let found: BTreeSet<String> = std::fs::read_dir(folder).unwrap().map(name).collect();
            let expected: BTreeSet<String> =
                listed.iter().map(|(version, description, _)| format!("{version:04}_{description}.sql")).collect();
            assert_eq!(found, expected);
        }
    }
}
