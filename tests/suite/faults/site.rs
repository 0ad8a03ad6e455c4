//! An installation of the service for a test: a separate database and blob store, the nodes on them, and direct access
//! to both for checks.

use super::client::Client;
use super::node::{Node, NotStarted, Starting, peak_memory_bytes};
use super::postgres::Cluster;
use super::s3::S3Server;
use super::witness::Database;
use homolog::jobs::{ArtifactStore, JobStore};
use homolog::store::artifacts::{FolderArtifacts, S3Artifacts};
use homolog::store::sql::{DatabaseLocation, SqlStore};
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;
use tempfile::TempDir;

/// How long a test waits for something that takes a lease (2 s by default), a poll and a round of housekeeping.
pub(crate) const SOON: Duration = Duration::from_secs(100);

/// Where a node stores jobs and blobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Backend {
    /// SQLite and a folder.
    Sqlite,
    /// PostgreSQL and S3.
    Postgres,
}

/// A process of the program; killed when dropped.
pub(crate) struct Program {
    process: Child,
    /// Its base URL.
    pub base: String,
}

impl Program {
    /// Peak memory of the process so far, bytes.
    pub(crate) fn peak_memory_bytes(&self) -> u64 {
        peak_memory_bytes(self.process.id())
    }

    /// Whether the process runs.
    pub(crate) fn is_running(&mut self) -> bool {
        self.process.try_wait().unwrap().is_none()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A database and a blob store, at first without nodes.
pub(crate) struct Site {
    pub folder: TempDir,
    pub cluster: Option<Cluster>,
    pub s3: Option<S3Server>,
}

impl Site {
    /// An empty site. Panics if the backend is not available; tests that need PostgreSQL are therefore `#[ignore]`d,
    /// and `scripts/test` runs them where it is installed.
    pub(crate) fn open(backend: Backend) -> Self {
        Site::open_on(backend, &std::env::temp_dir(), &std::env::temp_dir())
    }

    /// A site with its database and its S3 objects on these disks; on SQLite both are on the first.
    pub(crate) fn open_on(backend: Backend, database_disk: &Path, s3_disk: &Path) -> Self {
        let (cluster, s3) = match backend {
            Backend::Sqlite => (None, None),
            Backend::Postgres => {
                let cluster = Cluster::start_under(database_disk).unwrap_or_else(|reason| panic!("{reason}"));
                (Some(cluster), Some(S3Server::start_under(s3_disk)))
            }
        };
        let folder = if cluster.is_none() { tempfile::tempdir_in(database_disk) } else { tempfile::tempdir() };
        Site { folder: folder.unwrap(), cluster, s3 }
    }

    /// The data folder of the nodes.
    pub(crate) fn data_dir(&self) -> PathBuf {
        self.folder.path().join("data")
    }

    /// Default settings of the nodes; arguments of a test take precedence.
    pub(crate) fn environment(&self) -> Vec<(&'static str, String)> {
        let mut environment: Vec<_> = [
            ("HOMOLOG_LISTEN", "127.0.0.1:0"),
            ("HOMOLOG_POLL_MS", "50"),
            ("HOMOLOG_LEASE_MS", "2000"),
            ("HOMOLOG_HEARTBEAT_MS", "300"),
            ("HOMOLOG_MAX_QUEUE", "100000"),
            ("HOMOLOG_MAX_UPLOADS", "16"),
        ]
        .map(|(name, value)| (name, value.to_owned()))
        .into();
        environment.push(("HOMOLOG_DATA_DIR", self.data_dir().to_str().unwrap().to_owned()));
        if let (Some(cluster), Some(s3)) = (&self.cluster, &self.s3) {
            environment.push(("HOMOLOG_DATABASE_URL", cluster.url()));
            environment.extend(S3Server::environment(s3.port()));
        }
        environment
    }

    /// A node that serves HTTP and, by default, runs jobs.
    pub(crate) fn serve(&self, arguments: &[&str]) -> Node {
        self.node("serve", arguments, &[]).unwrap_or_else(|NotStarted(log)| panic!("{log}"))
    }

    /// The program itself, with the real engine. Panics if it does not start.
    pub(crate) fn program(&self, arguments: &[&str]) -> Program {
        let mut command = crate::cli::homolog();
        command.arg("serve").args(arguments).envs(self.environment());
        let mut process = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let base = line.split_whitespace().find(|word| word.starts_with("http://")).expect("an address").to_owned();
        Program { process, base }
    }

    /// A node that only runs jobs.
    pub(crate) fn worker(&self, arguments: &[&str]) -> Node {
        self.node("worker", arguments, &[]).unwrap_or_else(|NotStarted(log)| panic!("{log}"))
    }

    /// A node with further environment variables, which take precedence over those of the site.
    pub(crate) fn node(
        &self,
        role: &str,
        arguments: &[&str],
        more: &[(&'static str, String)],
    ) -> Result<Node, NotStarted> {
        self.begin_node(role, arguments, more).ready()
    }

    /// Starts a node without waiting until it is ready.
    pub(crate) fn begin_node(&self, role: &str, arguments: &[&str], more: &[(&'static str, String)]) -> Starting {
        static N_NODES: AtomicU32 = AtomicU32::new(0);
        let n = N_NODES.fetch_add(1, Ordering::Relaxed);
        // The log is not on the disk that a test may have filled.
        let log = std::env::temp_dir().join(format!("homolog-node-{}-{}.log", std::process::id(), n));
        let arguments: Vec<_> = arguments.iter().map(|a| (*a).to_owned()).collect();
        let environment = self.environment();
        let environment: Vec<_> = environment.into_iter().chain(more.iter().cloned()).collect();
        Starting::new(role, &arguments, &environment, &log)
    }

    /// A client of a node.
    pub(crate) fn client(&self, node: &Node) -> Client {
        Client::of(&node.base)
    }

    /// Location of the database.
    pub(crate) fn location(&self) -> DatabaseLocation {
        match &self.cluster {
            None => DatabaseLocation::Folder(self.data_dir()),
            Some(cluster) => DatabaseLocation::Postgres { url: cluster.url(), max_connections: 8, notify: true },
        }
    }

    /// The blob store of the nodes.
    pub(crate) fn artifacts(&self) -> Arc<dyn ArtifactStore> {
        match &self.s3 {
            None => Arc::new(FolderArtifacts::open(&self.data_dir()).unwrap()),
            Some(s3) => {
                let variables = S3Server::environment(s3.port());
                let url = variables.iter().find(|(name, _)| *name == "HOMOLOG_ARTIFACTS_URL").unwrap().1.clone();
                let variables = variables.into_iter().map(|(name, value)| (name.to_owned(), value));
                Arc::new(S3Artifacts::open_with(&url, variables).unwrap())
            }
        }
    }

    /// The job store through separate connections, as in another process.
    pub(crate) async fn store(&self) -> Arc<dyn JobStore> {
        std::fs::create_dir_all(self.data_dir()).unwrap();
        Arc::new(SqlStore::open(&self.location()).await.unwrap())
    }

    /// Direct access to the database, bypassing the service. The tables must exist already.
    pub(crate) async fn database(&self) -> Database {
        match &self.cluster {
            None => Database::sqlite(&self.data_dir().join("homolog.sqlite")).await,
            Some(cluster) => Database::postgres(&cluster.url()).await,
        }
    }

    /// The names of all stored blobs, sorted, without the mark of the store.
    pub(crate) fn blobs(&self) -> Vec<String> {
        let root = match &self.s3 {
            None => self.data_dir().join("blobs"),
            Some(s3) => s3.bucket(),
        };
        let mut found = Vec::new();
        names_under(&root, &mut found);
        found.sort();
        found
    }
}

fn names_under(folder: &Path, into: &mut Vec<String>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.path().is_dir() {
            names_under(&entry.path(), into);
        } else if !std::fs::read(entry.path()).is_ok_and(|bytes| bytes.starts_with(b"blob store of homolog ")) {
            into.push(entry.file_name().to_string_lossy().into_owned());
        }
    }
}
