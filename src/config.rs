//! The settings, each from the command line or the environment, with its default.

use crate::http::{AllowedHosts, AuthMode, ConnectionLimits, HttpLimits};
use crate::jobs::{Retention, SubmissionLimits};
use crate::store::sql::DatabaseLocation;
use crate::worker::WorkerSettings;
use crate::worker::courier::CourierSettings;
use crate::worker::machine;
use homolog_run::intake::{DEFAULT_MATCH_BYTES, IntakeLimits};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

/// What every process of the service is told.
#[derive(Debug, Clone, clap::Args)]
pub struct ServiceSettings {
    /// Where jobs and files are kept
    #[arg(long, env = "HOMOLOG_DATA_DIR", default_value = "./homolog-data", value_name = "DIR")]
    pub data_dir: PathBuf,
    /// PostgreSQL for jobs and queue, as postgres://user:password@host/database; absent: SQLite in the data directory
    #[arg(long, env = "HOMOLOG_DATABASE_URL", hide_env_values = true, value_name = "URL")]
    pub database_url: Option<String>,
    /// Most connections of this process to PostgreSQL, besides two for heartbeats
    #[arg(long, env = "HOMOLOG_DATABASE_CONNECTIONS", default_value_t = 8, value_parser = clap::value_parser!(u32).range(2..=200), value_name = "N")]
    pub database_connections: u32,
    /// Whether processes on PostgreSQL tell each other of queued jobs (LISTEN/NOTIFY); only makes them start sooner
    #[arg(long, env = "HOMOLOG_NOTIFY", default_value_t = true, action = clap::ArgAction::Set, value_name = "BOOL")]
    pub notify: bool,
    /// S3-compatible store of files, as s3://bucket/prefix, with AWS_* in the environment; absent: a folder in the data directory
    #[arg(long, env = "HOMOLOG_ARTIFACTS_URL", value_name = "URL")]
    pub artifacts_url: Option<String>,
    /// How long results and traces are kept after the end of a job, days; 0 for ever
    #[arg(long, env = "HOMOLOG_RETAIN_RESULTS_DAYS", default_value_t = 90.0, value_parser = days, value_name = "DAYS")]
    pub retain_results_days: f64,
    /// How long records of jobs are kept after their end, and all that belongs to them, days; 0 for ever
    #[arg(long, env = "HOMOLOG_RETAIN_JOBS_DAYS", default_value_t = 365.0, value_parser = days, value_name = "DAYS")]
    pub retain_jobs_days: f64,
    /// Jobs run at the same time, each with its share of the cores; 0: none; absent: small jobs on a core each, large ones
    /// on several, as many as there is room for
    #[arg(long, env = "HOMOLOG_WORKERS", value_name = "N")]
    pub workers: Option<usize>,
    /// Cores that jobs of this process may use; absent: all that the machine or the container has
    #[arg(long, env = "HOMOLOG_CORES", value_parser = clap::value_parser!(u16).range(1..=1_024), value_name = "N")]
    pub cores: Option<u16>,
    /// Memory that jobs of this process may take together, as predicted, bytes; absent: three quarters of what the machine
    /// or the container has
    #[arg(long, env = "HOMOLOG_MEMORY_BYTES", value_name = "BYTES")]
    pub memory_bytes: Option<u64>,
    /// Memory for surfaces that are kept between jobs, so that a template is prepared once, bytes; a quarter of the memory
    /// for jobs at most, and part of it; 0: none are kept
    #[arg(long, env = "HOMOLOG_PREPARED_BYTES", default_value_t = 256 << 20, value_name = "BYTES")]
    pub prepared_bytes: u64,
    /// How long smaller jobs may pass a waiting one for which not enough cores or memory are free, ms; then they wait too
    #[arg(long, env = "HOMOLOG_PATIENCE_MS", default_value_t = 10_000, value_name = "MS")]
    pub patience_ms: u64,
    /// For how long a worker is given a job before it must have shown that it lives, ms
    #[arg(long, env = "HOMOLOG_LEASE_MS", default_value_t = 15_000, value_parser = clap::value_parser!(u64).range(100..=3_600_000), value_name = "MS")]
    pub lease_ms: u64,
    /// How often it shows so, ms
    #[arg(long, env = "HOMOLOG_HEARTBEAT_MS", default_value_t = 3_000, value_parser = clap::value_parser!(u64).range(20..=600_000), value_name = "MS")]
    pub heartbeat_ms: u64,
    /// How often an idle worker asks the queue, ms
    #[arg(long, env = "HOMOLOG_POLL_MS", default_value_t = 250, value_parser = clap::value_parser!(u64).range(10..=60_000), value_name = "MS")]
    pub poll_ms: u64,
    /// Longest run of a job, s
    #[arg(long, env = "HOMOLOG_MAX_RUN_S", default_value_t = 3_600, value_parser = clap::value_parser!(u64).range(1..=604_800), value_name = "S")]
    pub max_run_s: u64,
    /// Lost workers after which a job is dead
    #[arg(long, env = "HOMOLOG_MAX_ATTEMPTS", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100), value_name = "N")]
    pub max_attempts: u32,
    /// Largest input file, bytes
    #[arg(long, env = "HOMOLOG_MAX_FILE_BYTES", default_value_t = 64 << 20, value_name = "BYTES")]
    pub max_file_bytes: usize,
    /// Largest input file after decompression, bytes
    #[arg(long, env = "HOMOLOG_MAX_INFLATED_BYTES", default_value_t = 512 << 20, value_name = "BYTES")]
    pub max_inflated_bytes: usize,
    /// Most vertices of an input surface
    #[arg(long, env = "HOMOLOG_MAX_VERTICES", default_value_t = 200_000, value_name = "N")]
    pub max_vertices: usize,
    /// Most memory that one match may take, bytes
    #[arg(long, env = "HOMOLOG_MAX_MATCH_BYTES", default_value_t = DEFAULT_MATCH_BYTES, value_name = "BYTES")]
    pub max_match_bytes: u64,
    /// How long running jobs may go on after the first signal to end, ms; then they are given back
    #[arg(long, env = "HOMOLOG_SHUTDOWN_GRACE_MS", default_value_t = 3_000, value_name = "MS")]
    pub shutdown_grace_ms: u64,
    /// Form of the log on standard error
    #[arg(long, env = "HOMOLOG_LOG_FORMAT", value_enum, default_value_t = LogFormat::Text)]
    pub log_format: LogFormat,
    /// What is logged, as for RUST_LOG
    #[arg(long, env = "HOMOLOG_LOG", default_value = "info,sqlx=warn", value_name = "FILTER")]
    pub log: String,
}

/// Form of the log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum LogFormat {
    /// For people.
    Text,
    /// For machines, an object a line.
    Json,
}

/// What a process that answers HTTP is told besides.
#[derive(Debug, Clone, clap::Args)]
pub struct HttpSettings {
    /// Address to listen on
    #[arg(long, env = "HOMOLOG_LISTEN", default_value = "127.0.0.1:8080", value_name = "ADDRESS:PORT")]
    pub listen: SocketAddr,
    /// Listen on an address that others can reach, without API keys
    #[arg(long, env = "HOMOLOG_INSECURE", value_parser = clap::builder::FalseyValueParser::new())]
    pub insecure: bool,
    /// Who may ask: anyone, or holders of API keys; absent: anyone on a loopback address, holders of keys elsewhere
    #[arg(long, env = "HOMOLOG_AUTH", value_enum)]
    pub auth: Option<AuthMode>,
    /// Let webhooks go to private addresses, such as those of this network
    #[arg(long, env = "HOMOLOG_ALLOW_PRIVATE_WEBHOOKS", value_parser = clap::builder::FalseyValueParser::new())]
    pub allow_private_webhooks: bool,
    /// Pause after the first failed delivery of an event, ms; each further one is three times as long
    #[arg(long, env = "HOMOLOG_WEBHOOK_PAUSE_MS", default_value_t = 5_000, value_parser = clap::value_parser!(u64).range(10..=3_600_000), value_name = "MS")]
    pub webhook_pause_ms: u64,
    /// Most jobs of a batch
    #[arg(long, env = "HOMOLOG_MAX_BATCH", default_value_t = 1_000, value_name = "N")]
    pub max_batch: usize,
    /// Most jobs of a tenant that may wait
    #[arg(long, env = "HOMOLOG_MAX_QUEUE", default_value_t = 1_000, value_name = "N")]
    pub max_queue: u32,
    /// Submissions read at the same time; each may hold two files in memory
    #[arg(long, env = "HOMOLOG_MAX_UPLOADS", default_value_t = 4, value_name = "N")]
    pub max_uploads: usize,
    /// Inputs checked at the same time
    #[arg(long, env = "HOMOLOG_MAX_CHECKS", default_value_t = 2, value_name = "N")]
    pub max_checks: usize,
    /// Longest time for a submission, s
    #[arg(long, env = "HOMOLOG_UPLOAD_TIMEOUT_S", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..=86_400), value_name = "S")]
    pub upload_timeout_s: u64,
    /// Longest time for any other request, s
    #[arg(long, env = "HOMOLOG_REQUEST_TIMEOUT_S", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..=3_600), value_name = "S")]
    pub request_timeout_s: u64,
    /// Longest time for the headers of a request, s; a connection may idle as long
    #[arg(long, env = "HOMOLOG_HEADER_TIMEOUT_S", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3_600), value_name = "S")]
    pub header_timeout_s: u64,
    /// Most open connections; further ones wait
    #[arg(long, env = "HOMOLOG_MAX_CONNECTIONS", default_value_t = 4_096, value_parser = clap::value_parser!(u32).range(1..), value_name = "N")]
    pub max_connections: u32,
    /// A name under which this service may be asked besides localhost, where it listens on a loopback address; repeatable
    #[arg(long = "allowed-host", env = "HOMOLOG_ALLOWED_HOSTS", value_delimiter = ',', value_name = "NAME")]
    pub allowed_hosts: Vec<String>,
}

/// A number of days that a duration can hold.
fn days(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(days) if (0.0..=36_500.0).contains(&days) => Ok(days),
        _ => Err("a number of days from 0 to 36500 is needed here".to_owned()),
    }
}

/// Memory for jobs where nobody says how much: what the process itself, uploads and the system need is left.
fn jobs_memory_bytes() -> u64 {
    machine::memory_bytes().map_or(u64::MAX, |bytes| bytes / 4 * 3)
}

/// Zero days are for ever.
fn retained(days: f64) -> Option<Duration> {
    (days > 0.0).then(|| Duration::from_secs_f64(days * 86_400.0))
}

/// What a process that only runs jobs is told besides.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct WorkerProcessSettings {
    /// End when there was no job for so long, s; absent: never
    #[arg(long, env = "HOMOLOG_EXIT_WHEN_IDLE_S", value_name = "S")]
    pub exit_when_idle_s: Option<u64>,
    /// End after so many jobs; absent: never
    #[arg(long, env = "HOMOLOG_MAX_JOBS", value_parser = clap::value_parser!(u64).range(1..), value_name = "N")]
    pub max_jobs: Option<u64>,
    /// Address to answer /healthz, /readyz and /metrics on; absent: none
    #[arg(long, env = "HOMOLOG_PROBE_LISTEN", value_name = "ADDRESS:PORT")]
    pub probe_listen: Option<SocketAddr>,
}

impl ServiceSettings {
    /// Where jobs are; `connections` at most if that is a server.
    pub fn database(&self, connections: u32) -> DatabaseLocation {
        match &self.database_url {
            None => DatabaseLocation::Folder(self.data_dir.clone()),
            Some(url) => {
                DatabaseLocation::Postgres { url: url.clone(), max_connections: connections, notify: self.notify }
            }
        }
    }

    /// How long things are kept.
    pub fn retention(&self) -> Retention {
        Retention { results: retained(self.retain_results_days), jobs: retained(self.retain_jobs_days) }
    }

    /// Bounds on what is read.
    pub fn intake_limits(&self) -> IntakeLimits {
        IntakeLimits {
            max_bytes: self.max_file_bytes,
            max_inflated_bytes: self.max_inflated_bytes,
            max_vertices: self.max_vertices,
            max_match_bytes: self.max_match_bytes,
        }
    }

    /// Memory for surfaces that are kept between jobs, bytes.
    pub fn prepared_bytes(&self) -> u64 {
        self.prepared_bytes.min(self.memory_for_jobs() / 4)
    }

    /// Memory for jobs and what is kept between them, bytes.
    fn memory_for_jobs(&self) -> u64 {
        self.memory_bytes.unwrap_or_else(jobs_memory_bytes)
    }

    /// Behavior of workers.
    pub fn worker_settings(&self) -> WorkerSettings {
        let lease = Duration::from_millis(self.lease_ms);
        WorkerSettings {
            cores: self.cores.map_or_else(machine::cores, usize::from),
            memory_bytes: self.memory_for_jobs() - self.prepared_bytes(),
            places: self.workers,
            patience: Duration::from_millis(self.patience_ms),
            lease,
            // A lease outlives two heartbeats that fail.
            heartbeat: Duration::from_millis(self.heartbeat_ms).min(lease / 3),
            poll: Duration::from_millis(self.poll_ms),
            max_run: Duration::from_secs(self.max_run_s),
            keep_results: self.retention().results,
            ..WorkerSettings::default()
        }
    }
}

impl Default for HttpSettings {
    /// What holds where nothing is said.
    fn default() -> Self {
        #[derive(clap::Parser)]
        struct Alone {
            #[command(flatten)]
            http: HttpSettings,
        }
        <Alone as clap::Parser>::parse_from(["homolog"]).http
    }
}

impl HttpSettings {
    /// Who may ask. `None`: anyone who can reach the address would be let in, and nobody said that this is wanted.
    pub fn auth_mode(&self) -> Option<AuthMode> {
        let is_local = self.listen.ip().is_loopback();
        match self.auth {
            Some(AuthMode::None) if !is_local && !self.insecure => None,
            Some(mode) => Some(mode),
            None if is_local || self.insecure => Some(AuthMode::None),
            None => Some(AuthMode::Keys),
        }
    }

    /// Bounds on requests.
    pub fn http_limits(&self, service: &ServiceSettings) -> HttpLimits {
        HttpLimits {
            max_file_bytes: service.max_file_bytes,
            max_uploads: self.max_uploads,
            max_upload_wait: Duration::from_secs(20),
            upload_timeout: Duration::from_secs(self.upload_timeout_s),
            request_timeout: Duration::from_secs(self.request_timeout_s),
            allow_private_webhooks: self.allow_private_webhooks,
        }
    }

    /// How webhooks are delivered.
    pub fn courier_settings(&self) -> CourierSettings {
        CourierSettings {
            allow_private: self.allow_private_webhooks,
            first_pause: Duration::from_millis(self.webhook_pause_ms),
        }
    }

    /// Bounds on connections.
    pub fn connection_limits(&self) -> ConnectionLimits {
        ConnectionLimits {
            header_timeout: Duration::from_secs(self.header_timeout_s),
            max_connections: self.max_connections as usize,
        }
    }

    /// Which hosts a request may name. On an address that others reach, any: they know the service by names that it
    /// does not know itself, and who may use it is asked otherwise.
    pub fn hosts(&self) -> Option<AllowedHosts> {
        let is_open = self.listen.ip().is_loopback() && self.auth_mode() == Some(AuthMode::None);
        is_open.then(|| AllowedHosts::new(self.allowed_hosts.iter().cloned()))
    }

    /// Bounds on what is accepted.
    pub fn submission_limits(&self, service: &ServiceSettings) -> SubmissionLimits {
        SubmissionLimits {
            max_queued: self.max_queue,
            max_checks: self.max_checks,
            max_check_wait: Duration::from_secs(60),
            max_attempts: service.max_attempts,
            max_batch: self.max_batch,
            once_for: Duration::from_secs(24 * 3600),
            keep_results: service.retention().results,
            max_run: Duration::from_secs(service.max_run_s),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(clap::Parser)]
    struct Alone {
        #[command(flatten)]
        service: ServiceSettings,
    }

    fn settings(told: &[&str]) -> ServiceSettings {
        let words = ["homolog"].iter().chain(told);
        <Alone as clap::Parser>::try_parse_from(words).unwrap().service
    }

    #[test]
    fn kept_surfaces_take_their_memory_from_that_of_the_jobs_and_never_much_of_it() {
        let shared = |told: &[&str]| {
            let settings = settings(told);
            (settings.prepared_bytes(), settings.worker_settings().memory_bytes)
        };
        let (gib, mib) = (1 << 30, 1 << 20);
        assert_eq!(shared(&["--memory-bytes", "8589934592"]), (256 * mib, 8 * gib - 256 * mib));
        assert_eq!(shared(&["--memory-bytes", "1000"]), (250, 750));
        assert_eq!(shared(&["--memory-bytes", "1000", "--prepared-bytes", "100"]), (100, 900));
        assert_eq!(shared(&["--memory-bytes", "1000", "--prepared-bytes", "0"]), (0, 1000));
    }
}
