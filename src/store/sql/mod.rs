//! The job store in SQLite or PostgreSQL.
//!
//! Both databases share one implementation: each query is written once, in a file of `queries/`; [`dialect`] fills in
//! the parts that differ, and [`database`] hides which database a connection belongs to. The code relies on no
//! guarantee that only one of them gives: PostgreSQL runs write transactions concurrently, so rows are locked before a
//! decision depends on them.
//!
//! An operation has the name of the port's method. If it is a single query, the query's file has the same name (a test
//! below checks this).
//!
//! Each port of [`crate::jobs`] is implemented in one file: [`reading`] ([`crate::jobs::JobReader`]), [`writing`]
//! ([`crate::jobs::JobWriter`]), [`leasing`] ([`crate::jobs::JobQueue`]), [`blobs`] ([`crate::jobs::BlobHolds`]),
//! [`housekeeping`] ([`crate::jobs::Housekeeping`]), [`meshes`], [`studies`], [`keys`], [`audit`], [`webhooks`]. Other
//! files: [`batches`], [`changes`] (the feed), [`clock`] (whether it is plausible), [`once`] (idempotency keys),
//! [`retention`], [`inspection`] (copies and checks of a whole database), [`encryption`] (which key encrypts blobs),
//! [`fence`] (of a lease), [`argument`] (bound values), [`rows`] (from rows to records), [`driver_errors`].

mod argument;
mod audit;
mod batches;
mod blobs;
mod changes;
mod clock;
mod database;
mod dialect;
mod driver_errors;
mod encryption;
mod fence;
mod housekeeping;
mod inspection;
mod keys;
mod leasing;
mod meshes;
mod migrations;
mod once;
mod reading;
mod retention;
mod rows;
mod studies;
mod webhooks;
mod writing;

pub use database::DatabaseLocation;

use crate::jobs::{JobError, JobStore, Tenant, TenantWeights};
use crate::store::seal::Seal;
use argument::bind;
use async_trait::async_trait;
use database::{Database, Row};
use dialect::sql;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// The store of jobs, uploads, API keys and webhooks in a database.
#[derive(Debug, Clone)]
pub struct SqlStore {
    database: Database,
    settings: Arc<StoreSettings>,
    /// Whether something was deleted since the files of the database were last cleaned.
    has_deleted: Arc<AtomicBool>,
    /// The state of the clock of the database.
    clock: Arc<clock::Clock>,
}

/// Blobs listed in one page.
const BLOBS_AT_ONCE: u32 = 5_000;

/// A blob to which a job or an upload refers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct StoredBlob {
    /// The owner of the blob.
    pub(crate) tenant: Tenant,
    /// The path of the blob under the tenant.
    pub(crate) path: String,
    /// The size of the blob, bytes.
    pub(crate) n_bytes: u64,
}

/// Settings of a store; tests use the defaults.
#[derive(Debug, Default)]
pub struct StoreSettings {
    /// The weights of tenants.
    pub weights: TenantWeights,
    /// Maximum number of running jobs of a tenant; `None`: no limit.
    pub max_running: Option<u32>,
    /// How long a job waits after the first crash of its worker; each further crash multiplies the wait by five.
    pub crash_pause: Duration,
    /// Seals the secrets of webhooks; `None`: secrets are stored unsealed.
    pub seal: Option<Seal>,
}

impl SqlStore {
    /// Connects to the database, creates it if it is a file that does not exist, and runs pending migrations.
    ///
    /// # Errors
    /// [`JobError::Unavailable`]; also if a newer version of this program has migrated the database.
    pub async fn open(location: &DatabaseLocation) -> Result<Self, JobError> {
        Ok(SqlStore {
            database: Database::open(location).await?,
            settings: Arc::default(),
            has_deleted: Arc::default(),
            clock: Arc::default(),
        })
    }

    /// Replaces the settings of the store.
    #[must_use]
    pub fn with(mut self, settings: StoreSettings) -> Self {
        self.settings = Arc::new(settings);
        self
    }

    /// Adopts the settings of another store of this process, and shares its knowledge of the database; the connections
    /// stay separate.
    #[must_use]
    pub(crate) fn beside(mut self, other: &SqlStore) -> Self {
        self.database.share_space(&other.database);
        self.clock = Arc::clone(&other.clock);
        self.settings = Arc::clone(&other.settings);
        self
    }

    fn note_deletion(&self) {
        self.has_deleted.store(true, Ordering::SeqCst);
    }

    /// Copies one state of a SQLite database into an empty file, while others write.
    ///
    /// # Errors
    /// [`JobError::Unavailable`]; also for PostgreSQL, which has its own tools for this.
    pub(crate) async fn copy_into(&self, file: &Path) -> Result<(), JobError> {
        self.database.copy_into(file).await
    }

    /// Whether a SQLite database is undamaged.
    ///
    /// # Errors
    /// As for [`SqlStore::copy_into`].
    pub(crate) async fn is_intact(&self) -> Result<bool, JobError> {
        self.database.is_intact().await
    }

    /// A page of the blobs to which jobs and uploads refer, ordered by tenant and path, after `after`.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn list_blobs(&self, after: Option<(Tenant, String)>) -> Result<Vec<StoredBlob>, JobError> {
        let (tenant, path) = after.map_or_else(Default::default, |(tenant, path)| (tenant.name().to_owned(), path));
        let rows = self.database.reader().await?.rows(sql!("list_blobs"), bind![tenant, path, BLOBS_AT_ONCE]).await?;
        let blob = |row: &Row| {
            let n_bytes = row.get::<i64>("n_bytes")?.unsigned_abs();
            Ok(StoredBlob { tenant: rows::tenant(&row.get::<String>("tenant")?)?, path: row.get("path")?, n_bytes })
        };
        rows.iter().map(blob).collect()
    }

    /// Sets the gauges of the connections to the database.
    pub fn gauge_connections(&self) {
        let (busy, open, most) = self.database.connections();
        for (r#use, n) in [("busy", busy), ("idle", open - busy), ("most", most)] {
            metrics::gauge!("homolog_database_connections", "use" => r#use).set(n);
        }
    }

    /// Closes all connections.
    pub async fn close(&self) {
        self.database.close().await;
    }

    /// The settings on which durability depends: `synchronous` and `journal_mode` of SQLite's writing connection, `fsync`
    /// and `synchronous_commit` of PostgreSQL.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub async fn durability(&self) -> Result<(String, String), JobError> {
        let texts = match self.database.dialect() {
            dialect::Dialect::Sqlite => ["PRAGMA synchronous", "PRAGMA journal_mode"],
            dialect::Dialect::Postgres => ["SHOW fsync", "SHOW synchronous_commit"],
        };
        self.database
            .transaction(async |session| {
                let mut values = [String::new(), String::new()];
                for (value, text) in values.iter_mut().zip(texts) {
                    let rows = session.fetch(text.to_owned(), Vec::new()).await?;
                    let row = rows.first().ok_or(JobError::Corrupt { what: "a setting", source: None })?;
                    *value = row.get::<String>(0).or_else(|_| row.get::<i64>(0).map(|n| n.to_string()))?;
                }
                let [first, second] = values;
                Ok((first, second))
            })
            .await
    }
}

#[async_trait]
impl JobStore for SqlStore {
    async fn ping(&self) -> Result<(), JobError> {
        self.database.reader().await?.execute(sql!("ping"), bind![]).await?;
        self.database.space().check()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};
    use std::fs;
    use std::path::PathBuf;

    fn folder() -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src/store/sql")
    }

    /// The files of a folder with this extension: name without the extension, and text.
    fn files(folder: PathBuf, extension: &str) -> BTreeMap<String, String> {
        let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let paths = paths.filter(|path| path.extension().is_some_and(|e| e == extension));
        paths
            .map(|path| (path.file_stem().unwrap().to_str().unwrap().to_owned(), fs::read_to_string(&path).unwrap()))
            .collect()
    }

    /// The functions of this module's sources, tests excluded: name and text up to the next function.
    fn functions() -> Vec<(String, String)> {
        let mut functions = Vec::new();
        for source in files(folder(), "rs").values() {
            let code = source.split("\n#[cfg(test)]").next().unwrap();
            for part in code.split("fn ").skip(1) {
                let name: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                functions.push((name, part.to_owned()));
            }
        }
        functions
    }

    /// The queries that a text names: `sql!("…")`, and the one that is assembled at run time.
    fn queries(code: &str) -> Vec<&str> {
        let named = code.split("sql!(\"").skip(1).map(|rest| rest.split('"').next().unwrap());
        let included = code.split("include_str!(\"queries/").skip(1).map(|rest| rest.split('.').next().unwrap());
        named.chain(included).collect()
    }

    #[test]
    fn every_query_is_used_and_begins_with_its_name() {
        let functions = functions();
        let used: BTreeSet<&str> = functions.iter().flat_map(|(_, code)| queries(code)).collect();
        let files = files(folder().join("queries"), "sql");
        assert_eq!(used, files.keys().map(String::as_str).collect());
        for (name, text) in &files {
            assert_eq!(text.lines().next().unwrap(), format!("-- {name}"));
        }
    }

    #[test]
    fn a_function_that_runs_one_query_has_the_name_of_the_query() {
        let mut n_equal = 0;
        for (name, code) in functions() {
            let [query] = queries(&code)[..] else { continue };
            // A function that passes its session on runs further queries. `list_state` runs a part of `list_jobs`.
            let hands_on = ["(session,", "(session)", "(&mut session,", "self.get_", "number_changes("];
            if hands_on.iter().any(|call| code.contains(call)) || name == "list_state" {
                continue;
            }
            assert_eq!(name, query, "one operation has two names");
            n_equal += 1;
        }
        assert!(n_equal >= 25, "only {n_equal} functions were recognized");
    }

    #[test]
    fn a_query_with_the_name_of_a_function_is_run_by_that_function() {
        let files = files(folder().join("queries"), "sql");
        let functions = functions();
        for query in files.keys() {
            let of_this_name: Vec<_> = functions.iter().filter(|(name, _)| name == query).collect();
            let runs_it = of_this_name.iter().any(|(_, code)| queries(code).contains(&query.as_str()));
            // The text of `list_jobs` is assembled in `list_state`.
            assert!(of_this_name.is_empty() || runs_it || query == "list_jobs", "{query}");
        }
    }
}
