//! Where jobs are stored during a benchmark.

use crate::postgres::Cluster;
use homolog::store::sql::{DatabaseLocation, SqlStore};
use sqlx::sqlite::{SqliteConnectOptions, SqliteJournalMode};
use sqlx::{AssertSqlSafe, PgPool, SqlitePool};
use std::path::PathBuf;
use std::time::Duration;
use tempfile::TempDir;

/// A database and a folder, empty at first and gone when dropped.
pub(crate) struct Place {
    folder: TempDir,
    pub cluster: Option<Cluster>,
}

impl Place {
    pub(crate) fn sqlite() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("data")).unwrap();
        Place { folder, cluster: None }
    }

    /// `None`, with a message, if PostgreSQL is not installed.
    pub(crate) fn postgres() -> Option<Self> {
        let cluster = Cluster::start().inspect_err(|reason| println!("no rows of PostgreSQL: {reason}")).ok()?;
        Some(Place { cluster: Some(cluster), ..Place::sqlite() })
    }

    /// One of each kind that is available on this machine.
    pub(crate) fn all() -> Vec<Place> {
        std::iter::once(Place::sqlite()).chain(Place::postgres()).collect()
    }

    pub(crate) fn name(&self) -> &'static str {
        if self.cluster.is_some() { "PostgreSQL" } else { "SQLite" }
    }

    pub(crate) fn is_postgres(&self) -> bool {
        self.cluster.is_some()
    }

    pub(crate) fn data_dir(&self) -> PathBuf {
        self.folder.path().join("data")
    }

    /// The environment of a process of the service.
    pub(crate) fn environment(&self) -> Vec<(&'static str, String)> {
        let mut environment = vec![
            ("HOMOLOG_LISTEN", "127.0.0.1:0".to_owned()),
            ("HOMOLOG_DATA_DIR", self.data_dir().to_str().unwrap().to_owned()),
        ];
        environment.extend(self.cluster.iter().map(|c| ("HOMOLOG_DATABASE_URL", c.url())));
        environment
    }

    /// The store, with as many connections as the service has by default.
    pub(crate) async fn store(&self) -> SqlStore {
        let location = match &self.cluster {
            None => DatabaseLocation::Folder(self.data_dir()),
            Some(cluster) => DatabaseLocation::Postgres { url: cluster.url(), max_connections: 8, notify: true },
        };
        let store = SqlStore::open(&location).await.unwrap();
        let durability = store.durability().await.unwrap();
        let expected = if self.is_postgres() { ("on", "on") } else { ("2", "wal") };
        assert_eq!((durability.0.as_str(), durability.1.as_str()), expected, "the store must survive a loss of power");
        store
    }

    /// Direct access to the database, bypassing the store.
    pub(crate) async fn database(&self) -> Database {
        match &self.cluster {
            Some(cluster) => Database::Postgres(PgPool::connect(&cluster.url()).await.unwrap()),
            None => {
                let options = SqliteConnectOptions::new()
                    .filename(self.data_dir().join("homolog.sqlite"))
                    .journal_mode(SqliteJournalMode::Wal)
                    .busy_timeout(Duration::from_secs(60));
                Database::Sqlite(SqlitePool::connect_with(options).await.unwrap())
            }
        }
    }
}

/// Direct access to a database, bypassing the store.
pub(crate) enum Database {
    Sqlite(SqlitePool),
    Postgres(PgPool),
}

impl Database {
    pub(crate) async fn execute(&self, text: &str) {
        let text = AssertSqlSafe(text.to_owned());
        match self {
            Database::Sqlite(pool) => drop(sqlx::raw_sql(text).execute(pool).await.unwrap()),
            Database::Postgres(pool) => drop(sqlx::raw_sql(text).execute(pool).await.unwrap()),
        }
    }

    pub(crate) async fn number(&self, text: &str) -> i64 {
        let text = AssertSqlSafe(text.to_owned());
        match self {
            Database::Sqlite(pool) => sqlx::query_scalar(text).fetch_one(pool).await.unwrap(),
            Database::Postgres(pool) => sqlx::query_scalar(text).fetch_one(pool).await.unwrap(),
        }
    }
}

/// Raises the limit of open files: a thousand followers are a thousand sockets.
pub(crate) fn allow_many_files() {
    use rustix::process::{Resource, getrlimit, setrlimit};
    let mut limit = getrlimit(Resource::Nofile);
    limit.current = limit.maximum.map(|most| most.min(65_536)).or(Some(65_536));
    setrlimit(Resource::Nofile, limit).unwrap();
}
