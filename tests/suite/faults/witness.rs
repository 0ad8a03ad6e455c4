//! Direct access to the database, bypassing the service, and a witness in it: triggers that record what was accepted,
//! independently of the service.

use super::node::Node;
use sqlx::sqlite::{SqliteConnectOptions, SqliteJournalMode};
use sqlx::{AssertSqlSafe, PgPool, Sqlite, SqlitePool, Transaction};
use std::path::Path;
use std::time::Duration;

/// The database of a site.
#[derive(Debug, Clone)]
pub(crate) enum Database {
    Sqlite(SqlitePool),
    Postgres(PgPool),
}

impl Database {
    pub(crate) async fn sqlite(file: &Path) -> Self {
        let options = SqliteConnectOptions::new()
            .filename(file)
            .journal_mode(SqliteJournalMode::Wal)
            .busy_timeout(Duration::from_secs(30));
        Database::Sqlite(SqlitePool::connect_with(options).await.unwrap())
    }

    pub(crate) async fn postgres(url: &str) -> Self {
        Database::Postgres(PgPool::connect(url).await.unwrap())
    }

    /// Runs a statement.
    pub(crate) async fn execute(&self, text: &str) {
        let text = AssertSqlSafe(text.to_owned());
        match self {
            Database::Sqlite(pool) => drop(sqlx::raw_sql(text).execute(pool).await.unwrap()),
            Database::Postgres(pool) => drop(sqlx::raw_sql(text).execute(pool).await.unwrap()),
        }
    }

    /// Runs a statement that may fail.
    pub(crate) async fn try_execute(&self, text: &str) {
        let text = AssertSqlSafe(text.to_owned());
        let _ = match self {
            Database::Sqlite(pool) => sqlx::raw_sql(text).execute(pool).await.is_ok(),
            Database::Postgres(pool) => sqlx::raw_sql(text).execute(pool).await.is_ok(),
        };
    }

    /// A transaction that has read and stays open until the returned value is dropped.
    pub(crate) async fn hold_open(&self) -> Box<dyn std::any::Any + Send> {
        match self {
            Database::Sqlite(pool) => {
                let mut held = pool.begin().await.unwrap();
                let _: i64 = sqlx::query_scalar("SELECT COUNT(*) FROM jobs").fetch_one(&mut *held).await.unwrap();
                Box::new(held)
            }
            Database::Postgres(pool) => {
                let mut held = pool.begin_with("BEGIN ISOLATION LEVEL REPEATABLE READ").await.unwrap();
                let _: i64 = sqlx::query_scalar("SELECT COUNT(*) FROM jobs").fetch_one(&mut *held).await.unwrap();
                Box::new(held)
            }
        }
    }

    /// SQLite's write lock, held until the returned value is dropped.
    pub(crate) async fn hold_lock(&self) -> Transaction<'static, Sqlite> {
        let Database::Sqlite(pool) = self else { panic!("PostgreSQL has no such lock") };
        pool.begin_with("BEGIN IMMEDIATE").await.unwrap()
    }

    /// The single number that a query returns.
    pub(crate) async fn number(&self, text: &str) -> i64 {
        let text = AssertSqlSafe(text.to_owned());
        match self {
            Database::Sqlite(pool) => sqlx::query_scalar(text).fetch_one(pool).await.unwrap(),
            Database::Postgres(pool) => sqlx::query_scalar(text).fetch_one(pool).await.unwrap(),
        }
    }

    /// The texts in the single column that a query returns.
    pub(crate) async fn texts(&self, text: &str) -> Vec<String> {
        let text = AssertSqlSafe(text.to_owned());
        match self {
            Database::Sqlite(pool) => sqlx::query_scalar(text).fetch_all(pool).await.unwrap(),
            Database::Postgres(pool) => sqlx::query_scalar(text).fetch_all(pool).await.unwrap(),
        }
    }

    /// Every table in which some column of some row holds `text`, with the number of such rows.
    pub(crate) async fn tables_with(&self, text: &str) -> Vec<(String, i64)> {
        let mut found = Vec::new();
        let tables = match self {
            Database::Sqlite(_) => "SELECT name FROM sqlite_master WHERE type = 'table'",
            Database::Postgres(_) => "SELECT tablename::text FROM pg_tables WHERE schemaname = 'public'",
        };
        for table in self.texts(tables).await {
            let condition = match self {
                Database::Sqlite(_) => {
                    let columns = self.texts(&format!("SELECT name FROM pragma_table_info('{table}')")).await;
                    let each = columns.iter().map(|c| format!("CAST(\"{c}\" AS TEXT) LIKE '%{text}%'"));
                    each.collect::<Vec<_>>().join(" OR ")
                }
                Database::Postgres(_) => format!("t::text LIKE '%{text}%'"),
            };
            let n = self.number(&format!("SELECT COUNT(*) FROM {table} AS t WHERE {condition}")).await;
            if n > 0 {
                found.push((table, n));
            }
        }
        found
    }

    /// Records every accepted result and every claim from now on.
    pub(crate) async fn watch(&self) {
        self.execute(
            "CREATE TABLE seen_results (job_id TEXT NOT NULL, epoch BIGINT NOT NULL);
             CREATE TABLE seen_claims (job_id TEXT NOT NULL, epoch BIGINT NOT NULL);",
        )
        .await;
        match self {
            Database::Sqlite(_) => {
                self.execute(
                    "CREATE TRIGGER see_result AFTER UPDATE OF state ON jobs WHEN NEW.state = 'succeeded'
                     BEGIN INSERT INTO seen_results VALUES (NEW.id, NEW.lease_epoch); END;
                     CREATE TRIGGER see_claim AFTER UPDATE OF lease_epoch ON jobs
                     BEGIN INSERT INTO seen_claims VALUES (NEW.id, NEW.lease_epoch); END;",
                )
                .await;
            }
            Database::Postgres(_) => {
                self.execute(
                    "CREATE FUNCTION see_result() RETURNS trigger LANGUAGE plpgsql AS
                     $$ BEGIN INSERT INTO seen_results VALUES (NEW.id::text, NEW.lease_epoch); RETURN NULL; END $$;
                     CREATE FUNCTION see_claim() RETURNS trigger LANGUAGE plpgsql AS
                     $$ BEGIN INSERT INTO seen_claims VALUES (NEW.id::text, NEW.lease_epoch); RETURN NULL; END $$;
                     CREATE TRIGGER see_result AFTER UPDATE OF state ON jobs
                     FOR EACH ROW WHEN (NEW.state = 'succeeded') EXECUTE FUNCTION see_result();
                     CREATE TRIGGER see_claim AFTER UPDATE OF lease_epoch ON jobs
                     FOR EACH ROW EXECUTE FUNCTION see_claim();",
                )
                .await;
            }
        }
    }

    /// Makes every renewal of a lease fail from now on, while everything else works.
    pub(crate) async fn fail_heartbeats(&self) {
        match self {
            Database::Sqlite(_) => {
                self.execute(
                    "CREATE TRIGGER fail_heartbeat BEFORE UPDATE OF lease_expires_at ON jobs
                     WHEN NEW.state = 'running' AND OLD.state = 'running' AND NEW.lease_epoch = OLD.lease_epoch
                     BEGIN SELECT RAISE(ABORT, 'injected failure'); END",
                )
                .await;
            }
            Database::Postgres(_) => {
                self.execute(
                    "CREATE FUNCTION fail_heartbeat() RETURNS trigger LANGUAGE plpgsql AS
                     $$ BEGIN RAISE EXCEPTION 'injected failure'; END $$;
                     CREATE TRIGGER fail_heartbeat BEFORE UPDATE OF lease_expires_at ON jobs FOR EACH ROW
                     WHEN (NEW.state = 'running' AND OLD.state = 'running' AND NEW.lease_epoch = OLD.lease_epoch)
                     EXECUTE FUNCTION fail_heartbeat();",
                )
                .await;
            }
        }
    }

    /// Lets leases be renewed again.
    pub(crate) async fn allow_heartbeats(&self) {
        match self {
            Database::Sqlite(_) => self.execute("DROP TRIGGER fail_heartbeat").await,
            Database::Postgres(_) => self.execute("DROP TRIGGER fail_heartbeat ON jobs").await,
        }
    }

    /// SIGSTOP to a node while it holds no database lock, because a suspended lock holder would block the other nodes.
    pub(crate) async fn freeze(&self, node: &Node) {
        for _ in 0..100 {
            node.freeze();
            if !self.is_locked().await {
                return;
            }
            node.thaw();
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
        panic!("the node always holds a lock");
    }

    async fn is_locked(&self) -> bool {
        match self {
            Database::Sqlite(pool) => {
                let mut connection = pool.acquire().await.unwrap();
                sqlx::query("PRAGMA busy_timeout = 300").execute(&mut *connection).await.unwrap();
                let locked = sqlx::query("BEGIN IMMEDIATE").execute(&mut *connection).await.is_err();
                if !locked {
                    sqlx::query("ROLLBACK").execute(&mut *connection).await.unwrap();
                }
                sqlx::query("PRAGMA busy_timeout = 30000").execute(&mut *connection).await.unwrap();
                locked
            }
            Database::Postgres(pool) => {
                let mut transaction = pool.begin().await.unwrap();
                sqlx::query("SELECT 1 FROM jobs FOR UPDATE NOWAIT").execute(&mut *transaction).await.is_err()
            }
        }
    }

    /// Number of accepted results of the job.
    pub(crate) async fn n_results(&self, id: &str) -> i64 {
        self.number(&format!("SELECT COUNT(*) FROM seen_results WHERE job_id = '{id}'")).await
    }

    /// Number of jobs with an accepted result, and of accepted results: equal if each job has one.
    pub(crate) async fn jobs_and_results(&self) -> (i64, i64) {
        let jobs = self.number("SELECT COUNT(DISTINCT job_id) FROM seen_results").await;
        (jobs, self.number("SELECT COUNT(*) FROM seen_results").await)
    }

    /// Number of claims, and of distinct pairs of job and epoch among them: equal if none was claimed twice.
    pub(crate) async fn claims(&self) -> (i64, i64) {
        let all = self.number("SELECT COUNT(*) FROM seen_claims").await;
        let distinct =
            self.number("SELECT COUNT(*) FROM (SELECT DISTINCT job_id, epoch FROM seen_claims) AS each_once").await;
        (all, distinct)
    }
}
