//! The settings, each from the command line, the environment or a configuration file ([`mod@file`]), with its default.
//! The texts of `--help` are defined here.

pub mod file;

use crate::http::{
    AllowedHosts, AuthMode, ConnectionLimits, CorsOrigins, HttpLimits, KeySetSource, LeastRate, TokenSettings,
};
use crate::jobs::{MAX_DAYS, Retention, Retentions, SubmissionLimits, TenantDays, TenantWeight, TenantWeights, kept};
use crate::store::sql::DatabaseLocation;
use crate::tls::TlsFiles;
use crate::worker::WorkerSettings;
use crate::worker::isolation::{Isolation, IsolationSettings};
use crate::worker::machine;
use crate::worker::price::PriceLimit;
use crate::worker::webhook_delivery::WebhookDeliverySettings;
use homolog_run::intake::{DEFAULT_FACES, DEFAULT_INFLATION, DEFAULT_MATCH_BYTES, DEFAULT_VOXELS, IntakeLimits};
use std::net::{SocketAddr, ToSocketAddrs as _};
use std::path::PathBuf;
use std::time::Duration;

/// Largest number of jobs of a batch that can be allowed; more entries of a list are not read.
const MAX_LIST: usize = crate::http::MAX_LIST;

/// Settings of every process of the service.
#[derive(Debug, Clone, clap::Args)]
pub struct ServiceSettings {
    /// Configuration file in TOML: settings under their names with underscores, such as max_queue = 500; the
    /// environment and the command line override it
    #[arg(long, env = "HOMOLOG_CONFIG", value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Folder of the database and the files
    #[arg(long, env = "HOMOLOG_DATA_DIR", default_value = "./homolog-data", value_name = "DIR")]
    pub data_dir: PathBuf,
    /// PostgreSQL server for jobs and queue, as postgres://user:password@host/database; default: SQLite in the data directory
    #[arg(long, env = "HOMOLOG_DATABASE_URL", hide_env_values = true, value_name = "URL")]
    pub database_url: Option<String>,
    /// Maximum number of connections of this process to PostgreSQL, in addition to two for heartbeats
    #[arg(long, env = "HOMOLOG_DATABASE_CONNECTIONS", default_value_t = 8, value_parser = clap::value_parser!(u32).range(2..=200), value_name = "N")]
    pub database_connections: u32,
    /// Whether processes on PostgreSQL announce queued jobs to each other (LISTEN/NOTIFY), so that jobs start sooner
    #[arg(long, env = "HOMOLOG_NOTIFY", default_value_t = true, action = clap::ArgAction::Set, value_name = "BOOL")]
    pub notify: bool,
    /// S3-compatible store for files, as s3://bucket/prefix, with AWS_* in the environment; default: a folder in the data
    /// directory
    #[arg(long, env = "HOMOLOG_ARTIFACTS_URL", value_parser = s3_url, value_name = "URL")]
    pub artifacts_url: Option<String>,
    /// How long results and traces are kept after a job has ended, days; 0: forever
    #[arg(long, env = "HOMOLOG_RETAIN_RESULTS_DAYS", default_value_t = 90.0, value_parser = days, value_name = "DAYS")]
    pub retain_results_days: f64,
    /// How long the records of jobs, and everything that belongs to them, are kept after they have ended, days; 0:
    /// forever
    #[arg(long, env = "HOMOLOG_RETAIN_JOBS_DAYS", default_value_t = 365.0, value_parser = days, value_name = "DAYS")]
    pub retain_jobs_days: f64,
    /// How long results and traces of one tenant are kept, as TENANT=DAYS; 0: forever; repeatable
    #[arg(
        long = "tenant-retain-results-days",
        env = "HOMOLOG_TENANT_RETAIN_RESULTS_DAYS",
        value_delimiter = ',',
        value_name = "TENANT=DAYS"
    )]
    pub tenant_retain_results_days: Vec<TenantDays>,
    /// How long the records of jobs of one tenant are kept, as TENANT=DAYS; 0: forever; repeatable
    #[arg(
        long = "tenant-retain-jobs-days",
        env = "HOMOLOG_TENANT_RETAIN_JOBS_DAYS",
        value_delimiter = ',',
        value_name = "TENANT=DAYS"
    )]
    pub tenant_retain_jobs_days: Vec<TenantDays>,
    /// Number of jobs run at the same time, each with an equal share of the cores; 0: none; default: as many as fit,
    /// small jobs on one core each and large jobs on several
    #[arg(long, env = "HOMOLOG_WORKERS", value_name = "N")]
    pub workers: Option<usize>,
    /// Cores that jobs of this process may use; default: all cores of the machine or the container
    #[arg(long, env = "HOMOLOG_CORES", value_parser = clap::value_parser!(u16).range(1..=1_024), value_name = "N")]
    pub cores: Option<u16>,
    /// Memory that the running jobs of this process may be predicted to take together, bytes; default: three quarters of the
    /// memory of the machine or the container
    #[arg(long, env = "HOMOLOG_MEMORY_BYTES", value_name = "BYTES")]
    pub memory_bytes: Option<u64>,
    /// Memory for prepared surfaces that are kept for later jobs, so that a template is prepared only once, bytes; part
    /// of the memory for jobs, and at most a quarter of it; 0: none are kept
    #[arg(long, env = "HOMOLOG_PREPARED_BYTES", default_value_t = 256 << 20, value_name = "BYTES")]
    pub prepared_bytes: u64,
    /// Where computations run: in separate processes, which can harm nothing else, or in threads of this process
    #[arg(long, env = "HOMOLOG_ISOLATION", value_enum, default_value_t = Isolation::Process)]
    pub isolation: Isolation,
    /// File with the key that seals the secrets of webhooks in the database, 64 hexadecimal digits, the same for all
    /// processes; default: secret.key in the data directory, which is created; with a database server: secrets are not sealed
    #[arg(long, env = "HOMOLOG_SECRET_KEY_FILE", value_name = "FILE")]
    pub secret_key_file: Option<PathBuf>,
    /// File with the keys that encrypt uploads, results and the secrets of webhooks at rest, one in each line, 64 hexadecimal digits:
    /// the first one encrypts, all of them decrypt; default: uploads and results are not encrypted
    #[arg(long, env = "HOMOLOG_ENCRYPTION_KEY_FILE", value_name = "FILE")]
    pub encryption_key_file: Option<PathBuf>,
    /// Shell command that prints these keys instead, for example from a key management service; run at each start
    #[arg(long, env = "HOMOLOG_ENCRYPTION_KEY_COMMAND", hide_env_values = true, value_name = "COMMAND")]
    pub encryption_key_command: Option<String>,
    /// How long a job waits before it runs again after its worker was lost, ms; five times as long after each further loss, at
    /// most a minute
    #[arg(long, env = "HOMOLOG_CRASH_PAUSE_MS", default_value_t = 1_000, value_parser = clap::value_parser!(u64).range(0..=60_000), value_name = "MS")]
    pub crash_pause_ms: u64,
    /// Share of a tenant in the turns of all tenants with waiting jobs, as TENANT=WEIGHT; default: 1; repeatable
    #[arg(long = "tenant-weight", env = "HOMOLOG_TENANT_WEIGHTS", value_delimiter = ',', value_name = "TENANT=WEIGHT")]
    pub tenant_weights: Vec<TenantWeight>,
    /// Maximum number of running jobs of a tenant, in all processes together, the same setting in each; further jobs
    /// wait in the queue; default: any number
    #[arg(long, env = "HOMOLOG_MAX_RUNNING", value_parser = clap::value_parser!(u32).range(1..), value_name = "N")]
    pub max_running: Option<u32>,
    /// How long smaller jobs may overtake a queued job for which not enough cores or memory are free, ms; then they
    /// wait too
    #[arg(long, env = "HOMOLOG_PATIENCE_MS", default_value_t = 10_000, value_name = "MS")]
    pub patience_ms: u64,
    /// How long a worker may send no heartbeat before its jobs are taken from it, ms
    #[arg(long, env = "HOMOLOG_LEASE_MS", default_value_t = 15_000, value_parser = clap::value_parser!(u64).range(100..=3_600_000), value_name = "MS")]
    pub lease_ms: u64,
    /// Time between two heartbeats of a running job, ms
    #[arg(long, env = "HOMOLOG_HEARTBEAT_MS", default_value_t = 3_000, value_parser = clap::value_parser!(u64).range(20..=600_000), value_name = "MS")]
    pub heartbeat_ms: u64,
    /// How often an idle worker reads the queue, ms
    #[arg(long, env = "HOMOLOG_POLL_MS", default_value_t = 250, value_parser = clap::value_parser!(u64).range(10..=60_000), value_name = "MS")]
    pub poll_ms: u64,
    /// Maximum run time of a job, s
    #[arg(long, env = "HOMOLOG_MAX_RUN_S", default_value_t = 3_600, value_parser = clap::value_parser!(u64).range(1..=604_800), value_name = "S")]
    pub max_run_s: u64,
    /// Number of lost workers after which a job is dead
    #[arg(long, env = "HOMOLOG_MAX_ATTEMPTS", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100), value_name = "N")]
    pub max_attempts: u32,
    /// Maximum size of an input file, bytes
    #[arg(long, env = "HOMOLOG_MAX_FILE_BYTES", default_value_t = 64 << 20, value_name = "BYTES")]
    pub max_file_bytes: usize,
    /// Maximum size of an input file after decompression, bytes
    #[arg(long, env = "HOMOLOG_MAX_INFLATED_BYTES", default_value_t = 512 << 20, value_name = "BYTES")]
    pub max_inflated_bytes: usize,
    /// Maximum size of an input file after decompression, as a multiple of its size, above a mebibyte
    #[arg(long, env = "HOMOLOG_MAX_INFLATION", default_value_t = DEFAULT_INFLATION, value_name = "N")]
    pub max_inflation: usize,
    /// Maximum number of vertices of an input surface
    #[arg(long, env = "HOMOLOG_MAX_VERTICES", default_value_t = 200_000, value_name = "N")]
    pub max_vertices: usize,
    /// Maximum number of faces of an input mesh
    #[arg(long, env = "HOMOLOG_MAX_FACES", default_value_t = DEFAULT_FACES, value_name = "N")]
    pub max_faces: usize,
    /// Maximum number of voxels of the box around the chosen labels of a volume
    #[arg(long, env = "HOMOLOG_MAX_VOXELS", default_value_t = DEFAULT_VOXELS, value_name = "N")]
    pub max_voxels: u64,
    /// Maximum processor time that a job may be predicted to take on all cores together, s; default: four times what --max-run-s
    /// allows on the cores that the job gets
    #[arg(long, env = "HOMOLOG_MAX_PROCESSOR_S", value_parser = clap::value_parser!(u64).range(1..), value_name = "S")]
    pub max_processor_s: Option<u64>,
    /// Maximum memory that one match may be predicted to take, bytes
    #[arg(long, env = "HOMOLOG_MAX_MATCH_BYTES", default_value_t = DEFAULT_MATCH_BYTES, value_name = "BYTES")]
    pub max_match_bytes: u64,
    /// How long running jobs may continue after the first SIGTERM or SIGINT, ms; then they return to the queue
    #[arg(long, env = "HOMOLOG_SHUTDOWN_GRACE_MS", default_value_t = 3_000, value_name = "MS")]
    pub shutdown_grace_ms: u64,
    /// Format of the log on standard error
    #[arg(long, env = "HOMOLOG_LOG_FORMAT", value_enum, default_value_t = LogFormat::Text)]
    pub log_format: LogFormat,
    /// Base address of an OpenTelemetry collector that receives spans of requests and jobs (OTLP over HTTP, protobuf),
    /// such as http://collector:4318; default: none are sent
    #[arg(long, env = "HOMOLOG_OTLP_ENDPOINT", hide_env_values = true, value_parser = otlp_endpoint, value_name = "URL")]
    pub otlp_endpoint: Option<String>,
    /// Filter of the log, in the syntax of RUST_LOG
    #[arg(long, env = "HOMOLOG_LOG", default_value = "info,sqlx=warn", value_name = "FILTER")]
    pub log: String,
}

/// Format of the log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum LogFormat {
    /// Lines of text.
    Text,
    /// One JSON object per line.
    Json,
}

/// Further settings of a process that serves HTTP.
#[derive(Debug, Clone, clap::Args)]
pub struct HttpSettings {
    /// Address to listen on
    #[arg(long, env = "HOMOLOG_LISTEN", default_value = "127.0.0.1:8080", value_parser = address, value_name = "ADDRESS:PORT")]
    pub listen: SocketAddr,
    /// Serve with TLS: file with the service's certificate and intermediate certificates, in PEM; read again when it
    /// changes, and at SIGHUP; default: without TLS, for a proxy in front
    #[arg(long, env = "HOMOLOG_TLS_CERT", value_name = "FILE")]
    pub tls_cert: Option<PathBuf>,
    /// File with the private key of the certificate, in PEM
    #[arg(long, env = "HOMOLOG_TLS_KEY", value_name = "FILE")]
    pub tls_key: Option<PathBuf>,
    /// Require certificates of clients that an authority in this file has signed, in PEM; default: clients need no certificate
    #[arg(long, env = "HOMOLOG_TLS_CLIENT_CA", value_name = "FILE")]
    pub tls_client_ca: Option<PathBuf>,
    /// Allow an address that other machines can reach without authentication
    #[arg(long, env = "HOMOLOG_INSECURE", value_parser = clap::builder::FalseyValueParser::new())]
    pub insecure: bool,
    /// Authentication: none, or API keys; default: none on a loopback address, API keys elsewhere
    #[arg(long, env = "HOMOLOG_AUTH", value_enum)]
    pub auth: Option<AuthMode>,
    /// Issuer of tokens of an OpenID Connect provider, which are accepted beside API keys: the claim iss
    #[arg(long, env = "HOMOLOG_OIDC_ISSUER", value_name = "URL")]
    pub oidc_issuer: Option<String>,
    /// Audience of these tokens: the claim aud must equal or contain it
    #[arg(long, env = "HOMOLOG_OIDC_AUDIENCE", value_name = "NAME")]
    pub oidc_audience: Option<String>,
    /// Key set of the provider (JWKS): its URL, or a file; read again when a token names a key that is not in it
    #[arg(long, env = "HOMOLOG_OIDC_JWKS", value_name = "URL|FILE")]
    pub oidc_jwks: Option<String>,
    /// Claim with the roles of the user: reader, submitter, admin, also with the prefix homolog-; dots select members
    /// of objects
    #[arg(long, env = "HOMOLOG_OIDC_ROLE_CLAIM", default_value = "roles", value_name = "CLAIM")]
    pub oidc_role_claim: String,
    /// Claim with the tenant of the user; default: all users belong to the tenant default
    #[arg(long, env = "HOMOLOG_OIDC_TENANT_CLAIM", value_name = "CLAIM")]
    pub oidc_tenant_claim: Option<String>,
    /// How far the clocks of the provider and of this machine may differ, s
    #[arg(long, env = "HOMOLOG_OIDC_LEEWAY_S", default_value_t = 30, value_parser = clap::value_parser!(u64).range(0..=600), value_name = "S")]
    pub oidc_leeway_s: u64,
    /// Allow webhooks to private addresses, such as those of the local network
    #[arg(long, env = "HOMOLOG_ALLOW_PRIVATE_WEBHOOKS", value_parser = clap::builder::FalseyValueParser::new())]
    pub allow_private_webhooks: bool,
    /// Refuse requests whose row of the audit log cannot be stored, with 503; otherwise they are answered, and the row
    /// is written to the log of the process
    #[arg(long, env = "HOMOLOG_AUDIT_REQUIRED", value_parser = clap::builder::FalseyValueParser::new())]
    pub audit_required: bool,
    /// Pause after the first failed attempt to deliver a webhook, ms; each further pause is three times as long
    #[arg(long, env = "HOMOLOG_WEBHOOK_PAUSE_MS", default_value_t = 5_000, value_parser = clap::value_parser!(u64).range(10..=3_600_000), value_name = "MS")]
    pub webhook_pause_ms: u64,
    /// Number of receivers of webhooks that are called at the same time; a tenant may have a quarter of them
    #[arg(long, env = "HOMOLOG_MAX_RECEIVERS", default_value_t = 32, value_parser = clap::value_parser!(u32).range(1..=1_000), value_name = "N")]
    pub max_receivers: u32,
    /// Maximum number of jobs in a batch
    #[arg(long, env = "HOMOLOG_MAX_BATCH", default_value_t = 1_000, value_parser = clap::value_parser!(u32).range(1..=MAX_LIST as i64), value_name = "N")]
    pub max_batch: u32,
    /// Maximum number of queued jobs per tenant
    #[arg(long, env = "HOMOLOG_MAX_QUEUE", default_value_t = 1_000, value_name = "N")]
    pub max_queue: u32,
    /// Maximum number of bytes of the uploads and results of a tenant; default: any number
    #[arg(long, env = "HOMOLOG_MAX_STORED_BYTES", value_parser = clap::value_parser!(u64).range(1..), value_name = "BYTES")]
    pub max_stored_bytes: Option<u64>,
    /// Maximum number of requests a second of a tenant to this process, on average; ten times as many at once after a pause; 0:
    /// any number
    #[arg(long, env = "HOMOLOG_MAX_REQUEST_RATE", default_value_t = 0, value_parser = clap::value_parser!(u32).range(0..=100_000), value_name = "N/S")]
    pub max_request_rate: u32,
    /// Number of submissions and uploads received at the same time; a tenant may have half of them
    #[arg(long, env = "HOMOLOG_MAX_UPLOADS", default_value_t = 64, value_name = "N")]
    pub max_uploads: usize,
    /// Memory of all submissions that are being received and checked, bytes; a tenant may have half of it, or one submission
    #[arg(long, env = "HOMOLOG_MAX_BODY_MEMORY_BYTES", default_value_t = 512 << 20, value_name = "BYTES")]
    pub max_body_memory_bytes: u64,
    /// Memory of all results that are sent in another format than the stored one, bytes; a tenant may have half of it
    #[arg(long, env = "HOMOLOG_MAX_ANSWER_MEMORY_BYTES", default_value_t = 256 << 20, value_parser = clap::value_parser!(u64).range(1 << 20..), value_name = "BYTES")]
    pub max_answer_memory_bytes: u64,
    /// Maximum size of a JSON body, bytes
    #[arg(long, env = "HOMOLOG_MAX_JSON_BYTES", default_value_t = 32 << 20, value_name = "BYTES")]
    pub max_json_bytes: usize,
    /// Maximum size of the parameters of a submission, bytes
    #[arg(long, env = "HOMOLOG_MAX_PARAMETERS_BYTES", default_value_t = 64 << 10, value_name = "BYTES")]
    pub max_parameters_bytes: usize,
    /// Least rate at which a client sends a body and reads an answer, bytes a second; a slower one is disconnected
    #[arg(long, env = "HOMOLOG_LEAST_RATE", default_value_t = 8_192, value_parser = clap::value_parser!(u64).range(1..), value_name = "BYTES/S")]
    pub least_rate: u64,
    /// How long a client may pause while it sends a body or reads an answer, and fall behind the least rate, s
    #[arg(long, env = "HOMOLOG_STALL_TIMEOUT_S", default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=3_600), value_name = "S")]
    pub stall_timeout_s: u64,
    /// Maximum number of event streams and long polls of a tenant at the same time, and of an address
    #[arg(long, env = "HOMOLOG_MAX_STREAMS", default_value_t = 512, value_parser = clap::value_parser!(u32).range(1..), value_name = "N")]
    pub max_streams: u32,
    /// Longest time after which an open event stream ends when its key was revoked or its token has expired, ms
    #[arg(long, env = "HOMOLOG_ACCESS_INTERVAL_MS", default_value_t = 30_000, value_parser = clap::value_parser!(u64).range(100..=30_000), value_name = "MS")]
    pub access_interval_ms: u64,
    /// Number of inputs checked at the same time
    #[arg(long, env = "HOMOLOG_MAX_CHECKS", default_value_t = 2, value_name = "N")]
    pub max_checks: usize,
    /// Time limit for a submission, s
    #[arg(long, env = "HOMOLOG_UPLOAD_TIMEOUT_S", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..=86_400), value_name = "S")]
    pub upload_timeout_s: u64,
    /// Time limit for any other request, s
    #[arg(long, env = "HOMOLOG_REQUEST_TIMEOUT_S", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..=3_600), value_name = "S")]
    pub request_timeout_s: u64,
    /// Time limit for the headers of a request, and for an idle connection, s
    #[arg(long, env = "HOMOLOG_HEADER_TIMEOUT_S", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3_600), value_name = "S")]
    pub header_timeout_s: u64,
    /// Maximum number of open connections; further ones wait
    #[arg(long, env = "HOMOLOG_MAX_CONNECTIONS", default_value_t = 4_096, value_parser = clap::value_parser!(u32).range(1..), value_name = "N")]
    pub max_connections: u32,
    /// Further address on which to serve /healthz, /readyz and /metrics, apart from the connections of clients; default: none
    #[arg(long, env = "HOMOLOG_PROBE_LISTEN", value_parser = address, value_name = "ADDRESS:PORT")]
    pub probe_listen: Option<SocketAddr>,
    /// Host name that requests may use, besides localhost and the address of --listen; any name if API keys are required and
    /// none is given; repeatable
    #[arg(long = "allowed-host", env = "HOMOLOG_ALLOWED_HOSTS", value_delimiter = ',', value_name = "NAME")]
    pub allowed_hosts: Vec<String>,
    /// Origin whose pages may use the service from a browser, such as `https://viewer.example`; none if absent; repeatable
    #[arg(long = "cors-origin", env = "HOMOLOG_CORS_ORIGINS", value_delimiter = ',', value_parser = CorsOrigins::check, value_name = "ORIGIN")]
    pub cors_origins: Vec<String>,
}

/// Parses an address with its port; a name is looked up.
fn address(text: &str) -> Result<SocketAddr, String> {
    if let Ok(address) = text.parse() {
        return Ok(address);
    }
    let needed = "an address with a port is needed here, such as 127.0.0.1:8080, localhost:8080 or [::1]:8080";
    let (host, port) = text.rsplit_once(':').ok_or(needed)?;
    if host.is_empty() || host.contains(':') || port.parse::<u16>().is_err() {
        return Err(needed.to_owned());
    }
    let found = text.to_socket_addrs().map_err(|error| format!("no address is found for {host}: {error}"))?;
    let found: Vec<SocketAddr> = found.collect();
    // For a name with addresses of both versions, such as localhost, the version that every client reaches.
    let usual = found.iter().find(|address| address.is_ipv4()).or(found.first());
    usual.copied().ok_or_else(|| format!("no address is found for {host}"))
}

/// Parses the address of a bucket.
fn s3_url(text: &str) -> Result<String, String> {
    let bucket = text.strip_prefix("s3://").and_then(|rest| rest.split('/').next()).unwrap_or_default();
    let is_bucket = bucket.bytes().all(|b| b.is_ascii_alphanumeric() || b"-._".contains(&b));
    if bucket.is_empty() || !is_bucket {
        return Err("s3://bucket or s3://bucket/prefix is needed here".to_owned());
    }
    Ok(text.to_owned())
}

/// Checks the address of a collector.
fn otlp_endpoint(text: &str) -> Result<String, String> {
    crate::spans::traces_url(text).map(|_| text.to_owned())
}

/// Parses a number of days that fits into a duration.
fn days(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(days) if (0.0..=MAX_DAYS).contains(&days) => Ok(days),
        _ => Err("a number of days from 0 to 36500 is needed here".to_owned()),
    }
}

/// Default of the memory for jobs: the process itself, uploads and the operating system use the rest.
fn jobs_memory_bytes() -> u64 {
    machine::memory_bytes().map_or(u64::MAX, |bytes| bytes / 4 * 3)
}

/// When a process that only runs jobs exits.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct WorkerEnd {
    /// Exit after this time without a job, s; default: never
    #[arg(long, env = "HOMOLOG_EXIT_WHEN_IDLE_S", value_name = "S")]
    pub exit_when_idle_s: Option<u64>,
    /// Exit after this number of jobs; default: never
    #[arg(long, env = "HOMOLOG_MAX_JOBS", value_parser = clap::value_parser!(u64).range(1..), value_name = "N")]
    pub max_jobs: Option<u64>,
}

/// Further settings of a process that only runs jobs.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct WorkerProcessSettings {
    /// When it exits.
    #[command(flatten)]
    pub end: WorkerEnd,
    /// Address on which to serve /healthz, /readyz and /metrics; default: none
    #[arg(long, env = "HOMOLOG_PROBE_LISTEN", value_parser = address, value_name = "ADDRESS:PORT")]
    pub probe_listen: Option<SocketAddr>,
}

impl ServiceSettings {
    /// The location of the database; a server gets at most `connections` connections.
    pub fn database(&self, connections: u32) -> DatabaseLocation {
        match &self.database_url {
            None => DatabaseLocation::Folder(self.data_dir.clone()),
            Some(url) => {
                DatabaseLocation::Postgres { url: url.clone(), max_connections: connections, notify: self.notify }
            }
        }
    }

    /// How long jobs and results are kept.
    pub fn retention(&self) -> Retentions {
        let others = Retention { results: kept(self.retain_results_days), jobs: kept(self.retain_jobs_days) };
        Retentions::new(others, &self.tenant_retain_results_days, &self.tenant_retain_jobs_days)
    }

    /// Limits on inputs.
    pub fn intake_limits(&self) -> IntakeLimits {
        IntakeLimits {
            max_bytes: self.max_file_bytes,
            max_inflated_bytes: self.max_inflated_bytes,
            max_inflation: self.max_inflation,
            max_vertices: self.max_vertices,
            max_faces: self.max_faces,
            max_voxels: self.max_voxels,
            max_match_bytes: self.max_match_bytes,
        }
    }

    /// Limit on the predicted processor time of a job.
    pub fn price_limit(&self) -> PriceLimit {
        match self.max_processor_s {
            Some(seconds) => PriceLimit::fixed(Duration::from_secs(seconds)),
            None => PriceLimit::of_run(Duration::from_secs(self.max_run_s), self.cores_of_job()),
        }
    }

    /// Most cores that a job gets here; where no job runs here, in another process, of which the same is assumed.
    fn cores_of_job(&self) -> usize {
        let cores = self.cores_for_jobs();
        self.workers.filter(|&slots| slots > 0).map_or(cores, |slots| (cores / slots).max(1))
    }

    /// Memory for prepared surfaces that are kept for later jobs, bytes.
    pub fn prepared_bytes(&self) -> u64 {
        self.prepared_bytes.min(self.memory_for_jobs() / 4)
    }

    /// How computations are isolated; `None`: not isolated.
    ///
    /// # Errors
    /// If the system does not report the path of this program.
    pub fn isolation_settings(&self) -> std::io::Result<Option<IsolationSettings>> {
        if self.isolation == Isolation::None {
            return Ok(None);
        }
        let own = IsolationSettings::of_this_program(self.intake_limits(), self.memory_for_jobs())?;
        let at_once = self.workers.unwrap_or_else(|| self.worker_settings().cores);
        Ok(Some(IsolationSettings { price: self.price_limit(), prepared_bytes: self.prepared_bytes(), at_once, ..own }))
    }

    /// Cores for jobs, at least one.
    fn cores_for_jobs(&self) -> usize {
        self.cores.map_or_else(machine::cores, usize::from)
    }

    /// Memory for jobs and prepared surfaces, bytes.
    fn memory_for_jobs(&self) -> u64 {
        self.memory_bytes.unwrap_or_else(jobs_memory_bytes)
    }

    /// The values of settings whose defaults depend on the machine or the container, by their names in the file.
    pub fn on_this_machine(&self) -> [(&'static str, u64); 2] {
        [("cores", self.cores_for_jobs() as u64), ("memory_bytes", self.memory_for_jobs())]
    }

    /// How long a job waits after the first loss of its worker.
    pub fn crash_pause(&self) -> Duration {
        Duration::from_millis(self.crash_pause_ms)
    }

    /// The weights of tenants.
    pub fn tenant_weights(&self) -> TenantWeights {
        TenantWeights::new(self.tenant_weights.iter().cloned())
    }

    /// Settings of workers.
    pub fn worker_settings(&self) -> WorkerSettings {
        let lease = Duration::from_millis(self.lease_ms);
        WorkerSettings {
            cores: self.cores_for_jobs(),
            memory_bytes: self.memory_for_jobs() - self.prepared_bytes(),
            slots: self.workers,
            patience: Duration::from_millis(self.patience_ms),
            lease,
            // A lease survives two failed heartbeats.
            heartbeat: Duration::from_millis(self.heartbeat_ms).min(lease / 3),
            poll: Duration::from_millis(self.poll_ms),
            max_run: Duration::from_secs(self.max_run_s),
            retention: self.retention(),
            ..WorkerSettings::default()
        }
    }
}

impl Default for HttpSettings {
    /// The defaults of the command line.
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
    /// The effective authentication. `None`: other machines could use the service without authentication, and
    /// `--insecure`, which allows this, is not set.
    pub fn auth_mode(&self) -> Option<AuthMode> {
        let is_local = self.listen.ip().is_loopback();
        match self.auth {
            Some(AuthMode::None) if !is_local && !self.insecure => None,
            Some(mode) => Some(mode),
            None if self.oidc_issuer.is_some() => Some(AuthMode::Keys),
            None if is_local || self.insecure => Some(AuthMode::None),
            None => Some(AuthMode::Keys),
        }
    }

    /// The files with the certificates of the listener; `None`: no TLS.
    ///
    /// # Errors
    /// The missing setting.
    pub fn tls_files(&self) -> Result<Option<TlsFiles>, String> {
        let client_authorities = self.tls_client_ca.clone();
        match (&self.tls_cert, &self.tls_key) {
            (Some(certificates), Some(key)) => {
                Ok(Some(TlsFiles { certificates: certificates.clone(), key: key.clone(), client_authorities }))
            }
            (None, None) if client_authorities.is_none() => Ok(None),
            _ => Err("--tls-cert and --tls-key are needed together, and both for --tls-client-ca".to_owned()),
        }
    }

    /// The tokens that are accepted besides API keys; `None`: no tokens.
    ///
    /// # Errors
    /// The missing or wrong setting.
    pub fn tokens(&self) -> Result<Option<TokenSettings>, String> {
        let (issuer, audience, jwks) = match (&self.oidc_issuer, &self.oidc_audience, &self.oidc_jwks) {
            (None, None, None) => return Ok(None),
            (Some(issuer), Some(audience), Some(jwks)) => (issuer, audience, jwks),
            _ => return Err("--oidc-issuer, --oidc-audience and --oidc-jwks are needed together".to_owned()),
        };
        if self.auth == Some(AuthMode::None) {
            return Err(
                "--auth none would accept requests without a token; remove it, or the settings of OpenID Connect"
                    .to_owned(),
            );
        }
        Ok(Some(TokenSettings {
            issuer: issuer.clone(),
            audience: audience.clone(),
            key_set: KeySetSource::parse(jwks).map_err(|reason| format!("--oidc-jwks: {reason}"))?,
            role_claim: self.oidc_role_claim.clone(),
            tenant_claim: self.oidc_tenant_claim.clone(),
            leeway: Duration::from_secs(self.oidc_leeway_s),
        }))
    }

    /// Limits on requests.
    pub fn http_limits(&self, service: &ServiceSettings) -> HttpLimits {
        HttpLimits {
            max_file_bytes: service.max_file_bytes,
            max_json_bytes: self.max_json_bytes,
            max_parameters_bytes: self.max_parameters_bytes,
            max_batch: self.max_batch as usize,
            max_uploads: self.max_uploads,
            max_body_memory_bytes: self.max_body_memory_bytes,
            max_answer_memory_bytes: self.max_answer_memory_bytes,
            least_rate: self.least_rate(),
            max_streams: self.max_streams,
            access_interval: Duration::from_millis(self.access_interval_ms),
            max_upload_wait: Duration::from_secs(20),
            upload_timeout: Duration::from_secs(self.upload_timeout_s),
            request_timeout: Duration::from_secs(self.request_timeout_s),
            allow_private_webhooks: self.allow_private_webhooks,
            audit_required: self.audit_required,
            max_request_rate: self.max_request_rate,
        }
    }

    /// Settings of the delivery of webhooks.
    pub fn webhook_delivery_settings(&self) -> WebhookDeliverySettings {
        WebhookDeliverySettings {
            allow_private: self.allow_private_webhooks,
            first_pause: Duration::from_millis(self.webhook_pause_ms),
            receivers: self.max_receivers,
        }
    }

    /// Limits on connections.
    pub fn connection_limits(&self) -> ConnectionLimits {
        ConnectionLimits {
            header_timeout: Duration::from_secs(self.header_timeout_s),
            max_connections: self.max_connections as usize,
            least_rate: self.least_rate(),
        }
    }

    /// Limits on connections of supervisors.
    pub fn probe_limits(&self) -> ConnectionLimits {
        ConnectionLimits { max_connections: 64, ..self.connection_limits() }
    }

    fn least_rate(&self) -> LeastRate {
        LeastRate { bytes_per_s: self.least_rate, patience: Duration::from_secs(self.stall_timeout_s) }
    }

    /// Whether other machines can use the service without authentication.
    pub fn is_open_to_others(&self) -> bool {
        !self.listen.ip().is_loopback() && self.auth_mode() == Some(AuthMode::None)
    }

    /// The host names that requests may use; `None`: any. They are restricted where requests are not authenticated,
    /// whatever the address, and where names are given. With keys and without names any name is allowed, because other
    /// machines reach the service by names that it does not know.
    pub fn hosts(&self) -> Option<AllowedHosts> {
        let is_restricted = self.auth_mode() == Some(AuthMode::None) || !self.allowed_hosts.is_empty();
        let own = Some(self.listen.ip()).filter(|address| !address.is_unspecified()).map(|address| address.to_string());
        is_restricted.then(|| AllowedHosts::new(self.allowed_hosts.iter().cloned().chain(own)))
    }

    /// Limits on submissions.
    pub fn submission_limits(&self, service: &ServiceSettings) -> SubmissionLimits {
        SubmissionLimits {
            max_queued: self.max_queue,
            max_checks: self.max_checks,
            max_check_wait: Duration::from_secs(60),
            max_attempts: service.max_attempts,
            max_batch: self.max_batch as usize,
            once_for: Duration::from_secs(24 * 3600),
            retention: service.retention(),
            max_run: Duration::from_secs(service.max_run_s),
            max_stored_bytes: self.max_stored_bytes,
            cores: service.cores_of_job(),
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
    fn an_address_may_be_a_name_with_a_port() {
        for (text, expected) in [
            ("127.0.0.1:8080", "127.0.0.1:8080"),
            ("localhost:8080", "127.0.0.1:8080"),
            ("[::1]:80", "[::1]:80"),
            ("0.0.0.0:0", "0.0.0.0:0"),
        ] {
            assert_eq!(address(text).unwrap().to_string(), expected, "{text}");
        }
        for text in ["", "8080", ":8080", "localhost", "localhost:", "localhost:http", "localhost:70000", "::1:80"] {
            assert!(address(text).unwrap_err().contains("such as 127.0.0.1:8080"), "{text}");
        }
        assert!(
            address("no-such-host.invalid:80").unwrap_err().contains("no address is found for no-such-host.invalid")
        );
    }

    #[test]
    fn only_addresses_of_buckets_are_accepted_for_files() {
        let parse = |url: &str| <Alone as clap::Parser>::try_parse_from(["homolog", "--artifacts-url", url]);
        for url in ["s3://bucket", "s3://bucket/prefix/more", "s3://my.bucket-1/"] {
            assert!(parse(url).is_ok(), "{url}");
        }
        for url in ["ftp://x", "http://169.254.169.254/", "bucket", "s3://", "s3:///prefix", "s3://a b", "s3://a@b/"] {
            assert!(parse(url).is_err(), "{url}");
        }
    }

    #[test]
    fn prepared_surfaces_take_at_most_a_quarter_of_the_memory_for_jobs() {
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
