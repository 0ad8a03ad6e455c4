//! The wiring: which store, which engine, which workers, and how a process starts and exits.

use crate::config::{HttpSettings, ServiceSettings};
use crate::http::{AuthMode, CorsOrigins, HttpState, Served, Tokens, probe_router, router, serve};
use crate::jobs::audit::Recorder;
use crate::jobs::{
    ArtifactKey, ArtifactStore, Engine, JobError, JobService, JobStore, KeyStore as _, Processes, Signals, Stores,
    StudyProgression, Tenant, WorkerId,
};
use crate::store::artifacts::{FolderArtifacts, S3Artifacts, SealedArtifacts, StoredBlobs};
use crate::store::keyring::Keyring;
use crate::store::layout::SECRET_KEY_FILE;
use crate::store::private_files;
use crate::store::processes::{ProcessRecord, ServeLock};
use crate::store::reserve;
use crate::store::seal::Seal;
use crate::store::sql::{SqlStore, StoreSettings};
use crate::telemetry;
use crate::tls::ServerTls;
use crate::worker::heartbeat::Heartbeats;
use crate::worker::housekeeper::Housekeeper;
use crate::worker::isolation::IsolatedEngine;
use crate::worker::match_engine::MatchEngine;
use crate::worker::quota::Quota;
use crate::worker::webhook_delivery::WebhookDelivery;
use crate::worker::{Pool, PoolParts};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;

/// How long a new `serve` waits for its predecessor to release the data directory.
const TAKEOVER_TIMEOUT: Duration = Duration::from_secs(10);
/// Database connections for the probes of supervisors.
const PROBE_CONNECTIONS: u32 = 1;
/// Database connections for heartbeats.
const HEARTBEAT_CONNECTIONS: u32 = 2;
/// How long open connections may delay the exit of a process after its jobs have ended.
const DRAIN_TIMEOUT: Duration = Duration::from_secs(5);

/// Why a process does not start.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
    /// The service would require no authentication although other machines can reach it.
    #[error(
        "{0} can be reached from other machines without authentication: use --auth keys, listen on 127.0.0.1, or pass --insecure"
    )]
    Insecure(SocketAddr),
    /// The address cannot be bound.
    #[error("cannot listen on {address}: {error}{}", choose_another(error))]
    Listen {
        /// The address.
        address: SocketAddr,
        /// The cause.
        error: std::io::Error,
    },
    /// The data directory cannot be used.
    #[error("cannot use the data directory {}: {error}", path.display())]
    DataDir {
        /// The data directory.
        path: PathBuf,
        /// The cause.
        error: std::io::Error,
    },
    /// Another process serves the data directory.
    #[error("another `homolog serve` uses the data directory {}; `homolog worker` may share it", .0.display())]
    Taken(PathBuf),
    /// A store cannot be used.
    #[error("{what} cannot be used: {error}")]
    Store {
        /// The store.
        what: &'static str,
        /// The error with its causes.
        error: String,
    },
    /// The blob store differs from the one of the other processes on the database.
    #[error(
        "the blob store is not the one that this database belongs to: its mark is missing. Processes that share a database share one \
         blob store: give all of them the same --artifacts-url, or the same --data-dir on storage that they share"
    )]
    OtherBlobs,
    /// The file with the key of secrets cannot be used.
    #[error("cannot use the key of secrets in {}: {error}", path.display())]
    SecretKey {
        /// The file.
        path: PathBuf,
        /// The cause.
        error: std::io::Error,
    },
    /// The keys for encryption at rest cannot be used, or are missing.
    #[error("encryption at rest: {0}")]
    Encryption(String),
    /// The certificates of the listener cannot be used.
    #[error("TLS: {0}")]
    Tls(String),
    /// The settings of OpenID Connect are incomplete or wrong.
    #[error("tokens of OpenID Connect cannot be verified: {0}")]
    Tokens(String),
    /// No process for computations can be started.
    #[error(
        "no process for computations can be started: {0}; with --isolation none they run in threads of the service"
    )]
    Isolation(std::io::Error),
    /// The operating system starts no thread.
    #[error("cannot start a thread: {0}")]
    Thread(std::io::Error),
}

/// Advice for an address that another program uses.
fn choose_another(error: &std::io::Error) -> &'static str {
    match error.kind() {
        std::io::ErrorKind::AddrInUse => {
            "; another program listens there: stop it, or choose another port with --listen"
        }
        _ => "",
    }
}

/// The two stages of a shutdown.
#[derive(Debug, Clone, Default)]
pub struct Shutdown {
    /// Cancelled first: nothing more is accepted or claimed.
    pub stop: CancellationToken,
    /// Cancelled second: running jobs return to the queue at once.
    pub give_back: CancellationToken,
}

impl Shutdown {
    /// Handles SIGTERM and SIGINT: the first signal cancels `stop` and, after `grace`, `give_back`; a second signal
    /// cancels `give_back` at once.
    pub fn follow_signals(&self, grace: Duration) {
        let shutdown = self.clone();
        tokio::spawn(async move {
            wait_for_signal().await;
            tracing::info!("asked to end");
            shutdown.stop.cancel();
            tokio::select! {
                () = tokio::time::sleep(grace) => {}
                () = wait_for_signal() => {}
            }
            shutdown.give_back.cancel();
        });
    }
}

async fn wait_for_signal() {
    use tokio::signal::unix::{SignalKind, signal};
    let (Ok(mut terminate), Ok(mut interrupt)) = (signal(SignalKind::terminate()), signal(SignalKind::interrupt()))
    else {
        tracing::error!("signals cannot be handled; only SIGKILL ends this process");
        return std::future::pending().await;
    };
    tokio::select! {
        _ = terminate.recv() => {}
        _ = interrupt.recv() => {}
    }
}

/// The parts of a process of the service, whether it serves HTTP or not.
pub struct App {
    parts: PoolParts,
    housekeeper: Housekeeper,
    stores: [SqlStore; 2],
    _serve_lock: Option<ServeLock>,
}

impl App {
    /// Opens the stores and requeues the jobs of processes that have ended.
    ///
    /// # Errors
    /// [`AppError`].
    pub async fn open(
        settings: &ServiceSettings,
        engine: Arc<dyn Engine>,
        shutdown: &Shutdown,
        serves: bool,
    ) -> Result<Self, AppError> {
        telemetry::metrics_text(); // starts to collect metrics
        let data_dir = settings.data_dir.clone();
        let unusable = |error| AppError::DataDir { path: data_dir.clone(), error };
        let is_shared = settings.database_url.is_some();
        if !is_shared || settings.artifacts_url.is_none() {
            create_data_dir(settings)?;
        }
        // Only one process serves a SQLite database; many share a PostgreSQL server.
        let serve_lock = if serves && !is_shared {
            Some(match ServeLock::acquire(&data_dir, Duration::ZERO).map_err(unusable)? {
                Some(lock) => lock,
                None => {
                    // Logged at once: the process does not answer while it waits.
                    tracing::warn!(
                        "another `homolog serve` uses the data directory; waiting {} s for it to end",
                        TAKEOVER_TIMEOUT.as_secs()
                    );
                    ServeLock::acquire(&data_dir, TAKEOVER_TIMEOUT)
                        .map_err(unusable)?
                        .ok_or(AppError::Taken(data_dir.clone()))?
                }
            })
        } else {
            None
        };
        let database = |e: JobError| store_error("the database", &e);
        let keyring = open_keyring(settings)?;
        let store = open_database(settings).await?;
        require_keys(&store, keyring.as_deref(), false).await?;
        if serves && is_shared && settings.secret_key_file.is_none() && keyring.is_none() {
            tracing::warn!(
                "secrets of webhooks are stored as they are, because no key is given with --secret-key-file"
            );
        }
        let n_sealed = store.seal_secrets().await.map_err(database)?;
        if n_sealed > 0 {
            tracing::info!(n_sealed, "secrets of webhooks were sealed with the current key");
        }
        // Heartbeats have their own connections, so that they never wait for other work of this process.
        let heartbeat_store = SqlStore::open(&settings.database(HEARTBEAT_CONNECTIONS)).await.map_err(database)?;
        let stored = open_stored(settings)?;
        if is_shared {
            require_shared_blobs(&store, stored.as_ref()).await?;
        }
        let artifacts: Arc<dyn ArtifactStore> = match keyring {
            Some(keyring) => Arc::new(SealedArtifacts::new(stored, keyring)),
            None => stored,
        };
        let worker = WorkerId::random();
        let processes: Option<Arc<dyn Processes>> = match is_shared {
            true => None,
            false => Some(Arc::new(ProcessRecord::create(&data_dir, &worker).map_err(unusable)?)),
        };
        let worker_settings = settings.worker_settings();
        tracing::info!(
            version = env!("CARGO_PKG_VERSION"),
            commit = env!("HOMOLOG_COMMIT"),
            cores = worker_settings.cores,
            memory_bytes = worker_settings.memory_bytes,
            database = if is_shared { "postgresql" } else { "sqlite" },
            "started"
        );
        let heartbeats =
            Heartbeats::start(Arc::new(heartbeat_store.clone()), worker_settings.heartbeat, worker_settings.lease);
        let heartbeats = Arc::new(heartbeats.map_err(AppError::Thread)?);
        let job_store: Arc<dyn JobStore> = Arc::new(store.clone());
        let signals = Arc::<Signals>::default();
        let studies = StudyProgression {
            jobs: Arc::clone(&job_store),
            studies: Arc::new(store.clone()),
            artifacts: Arc::clone(&artifacts),
            signals: Arc::clone(&signals),
            retention: settings.retention(),
        };
        let housekeeper = Housekeeper {
            store: Arc::clone(&job_store),
            audit: Arc::new(store.clone()),
            artifacts: Arc::clone(&artifacts),
            processes,
            retention: settings.retention(),
            studies: studies.clone(),
        };
        housekeeper.recover().await.map_err(database)?;
        let parts = PoolParts {
            store: job_store,
            artifacts,
            studies,
            engine,
            heartbeats,
            worker,
            settings: worker_settings,
            signals,
            quota: Arc::default(),
            stop: shutdown.stop.clone(),
            give_back: shutdown.give_back.clone(),
        };
        Ok(App { parts, housekeeper, stores: [store, heartbeat_store], _serve_lock: serve_lock })
    }

    /// Makes the process exit by itself, after a time without a job or after a number of jobs.
    pub fn limit_to(&mut self, quota: Quota) {
        self.parts.quota = Arc::new(quota);
    }

    /// Runs jobs, and serves HTTP if there is a listener, until `shutdown`.
    pub async fn run(self, http: Option<(TcpListener, HttpSettings, ServiceSettings)>, shutdown: &Shutdown) {
        self.run_probed(http, None, shutdown).await;
    }

    /// As [`App::run`], and also answers probes of supervisors on `probes`, separately from the connections of clients.
    pub async fn run_probed(
        self,
        http: Option<(TcpListener, HttpSettings, ServiceSettings)>,
        probes: Option<TcpListener>,
        shutdown: &Shutdown,
    ) {
        let Some((listener, http, service)) = http else {
            return self.run_with(Vec::new(), None, None, shutdown).await;
        };
        let auth = http.auth_mode().unwrap_or(AuthMode::Keys);
        if http.is_open_to_others() {
            tracing::warn!(
                address = %http.listen,
                "no authentication is required, and other machines can reach the service: whoever connects may read and \
                 delete everything"
            );
        }
        if auth == AuthMode::None {
            match self.stores[0].list_keys().await {
                Ok(keys) if keys.iter().any(|key| key.is_valid) => tracing::warn!(
                    "API keys exist, and are not asked for: every client is let in, with or without one; --auth keys requires them"
                ),
                Ok(_) => {}
                Err(error) => tracing::warn!(%error, "whether API keys exist is not known"),
            }
        } else if http.oidc_issuer.is_none()
            && matches!(self.stores[0].list_keys().await, Ok(keys) if !keys.iter().any(|key| key.is_valid))
        {
            tracing::warn!(
                "no valid API key exists, so every request is answered with 401; 'homolog keys create' creates one"
            );
        }
        let state = self.http_state(&self.stores[0], &http, &service, auth, shutdown);
        let webhooks = WebhookDelivery::new(Arc::new(self.stores[0].clone()), http.webhook_delivery_settings());
        let webhooks = webhooks.inspect_err(|error| tracing::error!(%error, "webhooks are not delivered")).ok();
        let recorder = Arc::clone(state.service.recorder());
        // Checked before the address was bound; without the certificates nothing is served.
        let tls = match open_tls(&http) {
            Ok(tls) => tls,
            Err(error) => {
                tracing::error!(%error, "the service ends");
                shutdown.stop.cancel();
                return self.run_with(Vec::new(), None, None, shutdown).await;
            }
        };
        let limits = http.connection_limits();
        let servers = vec![Served { listener, router: router(state), limits, tls }];
        let probes = probes.map(|listener| self.start_probes(listener, &http, &service, auth, shutdown));
        self.run_with(servers, webhooks, Some(recorder), shutdown).await;
        end_probes(probes).await;
    }

    /// Runs jobs, and answers the probes of supervisors on `listener`, until `shutdown`.
    pub async fn run_with_probes(self, listener: TcpListener, service: &ServiceSettings, shutdown: &Shutdown) {
        let http = HttpSettings::default();
        let probes = Some(self.start_probes(listener, &http, service, AuthMode::Keys, shutdown));
        self.run_with(Vec::new(), None, None, shutdown).await;
        end_probes(probes).await;
    }

    /// Answers the probes of supervisors on a separate thread with its own connections to the database, so that busy
    /// threads delay no probe.
    fn start_probes(
        &self,
        listener: TcpListener,
        http: &HttpSettings,
        service: &ServiceSettings,
        auth: AuthMode,
        shutdown: &Shutdown,
    ) -> Option<std::thread::JoinHandle<()>> {
        let state = self.http_state(&self.stores[0], http, service, auth, shutdown);
        let of_store = {
            let (parts, main) = (self.parts.clone(), self.stores[0].clone());
            let (http, service, shutdown) = (http.clone(), service.clone(), shutdown.clone());
            move |store: SqlStore| state_over(&parts, [&store.beside(&main), &main], &http, &service, auth, &shutdown)
        };
        let (database, limits, stop) =
            (service.database(PROBE_CONNECTIONS), http.probe_limits(), shutdown.stop.clone());
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let listener = listener.into_std();
        let (Ok(runtime), Ok(listener)) = (runtime, listener) else {
            tracing::error!("probes are not answered: no thread for them");
            return None;
        };
        let serving = move || {
            runtime.block_on(async move {
                let Ok(listener) = TcpListener::from_std(listener) else { return };
                let own = SqlStore::open(&database).await;
                let own = own.inspect_err(|error| tracing::warn!(%error, "probes have no connections of their own"));
                let (state, own) = match own {
                    Ok(own) => (of_store(own.clone()), Some(own)),
                    Err(_) => (state, None),
                };
                let served = Served { listener, router: probe_router(state), limits, tls: None };
                let serving = serve(served, stop.clone());
                tokio::pin!(serving);
                tokio::select! {
                    _ = &mut serving => {}
                    () = stop.cancelled() => drop(tokio::time::timeout(DRAIN_TIMEOUT, &mut serving).await),
                }
                if let Some(own) = own {
                    own.close().await;
                }
            });
        };
        let thread = std::thread::Builder::new().name("probes".to_owned()).spawn(serving);
        thread.inspect_err(|error| tracing::error!(%error, "probes are not answered")).ok()
    }

    fn http_state(
        &self,
        store: &SqlStore,
        http: &HttpSettings,
        service: &ServiceSettings,
        auth: AuthMode,
        shutdown: &Shutdown,
    ) -> HttpState {
        state_over(&self.parts, [store, store], http, service, auth, shutdown)
    }

    async fn run_with(
        self,
        servers: Vec<Served>,
        webhooks: Option<WebhookDelivery>,
        recorder: Option<Arc<Recorder>>,
        shutdown: &Shutdown,
    ) {
        let housekeeping = tokio::spawn(self.housekeeper.clone().run(shutdown.stop.clone()));
        let mut aside = tokio::task::JoinSet::new();
        let (store, signals) = (Arc::clone(&self.parts.store), Arc::clone(&self.parts.signals));
        aside.spawn(async move { store.follow_queued(&signals.queued).await });
        if let Some(webhooks) = webhooks {
            aside.spawn(webhooks.run(shutdown.stop.clone()));
        }
        let pool = Pool::start(&self.parts);
        for tls in servers.iter().filter_map(|served| served.tls.clone()) {
            aside.spawn(tls.follow());
        }
        let servers: Vec<_> =
            servers.into_iter().map(|served| tokio::spawn(serve(served, shutdown.stop.clone()))).collect();
        shutdown.stop.cancelled().await;
        pool.ended().await;
        aside.shutdown().await;
        let _ = housekeeping.await;
        let drained_by = tokio::time::Instant::now() + DRAIN_TIMEOUT;
        for mut server in servers {
            if tokio::time::timeout_at(drained_by, &mut server).await.is_err() {
                tracing::warn!("connections are still open and are closed");
                server.abort();
                let _ = server.await;
            }
        }
        if let Some(recorder) = recorder {
            // Audit rows of requests whose clients have disconnected.
            let _ = tokio::time::timeout_at(drained_by, recorder.settled()).await;
        }
        for store in &self.stores {
            store.close().await;
        }
        tracing::info!("ended");
    }
}

/// The state of the request handlers over a store; metrics report the connections of `main`.
fn state_over(
    parts: &PoolParts,
    [store, main]: [&SqlStore; 2],
    http: &HttpSettings,
    service: &ServiceSettings,
    auth: AuthMode,
    shutdown: &Shutdown,
) -> HttpState {
    let own = Arc::new(store.clone());
    let stores = Stores {
        jobs: own.clone(),
        meshes: own.clone(),
        keys: own.clone(),
        webhooks: own.clone(),
        studies: own.clone(),
        audit: own,
        artifacts: Arc::clone(&parts.artifacts),
    };
    let main = main.clone();
    let metrics = move || {
        main.gauge_connections();
        telemetry::metrics_text()
    };
    let (engine, signals) = (Arc::clone(&parts.engine), Arc::clone(&parts.signals));
    let use_cases = JobService::new(stores, engine, http.submission_limits(service), signals);
    HttpState::new(Arc::new(use_cases), http.http_limits(service), auth, shutdown.stop.clone())
        .with_metrics(metrics)
        // Checked before the address was bound; if the file has disappeared since, tokens are refused.
        .with_tokens(open_tokens(http).ok().flatten())
        .for_hosts(http.hosts())
        .for_origins(CorsOrigins::new(&http.cors_origins))
}

/// Waits until the thread of the probes has ended.
async fn end_probes(thread: Option<Option<std::thread::JoinHandle<()>>>) {
    if let Some(thread) = thread.flatten() {
        let _ = tokio::task::spawn_blocking(move || thread.join()).await;
    }
}

/// Creates the data directory, which only this user can enter.
///
/// # Errors
/// [`AppError::DataDir`].
pub fn create_data_dir(settings: &ServiceSettings) -> Result<(), AppError> {
    let path = &settings.data_dir;
    private_files::create_dir_all(path).map_err(|error| AppError::DataDir { path: path.clone(), error })
}

/// Opens the database of the settings and runs pending migrations.
///
/// # Errors
/// [`AppError::Store`].
pub async fn open_database(settings: &ServiceSettings) -> Result<SqlStore, AppError> {
    // Commands that free space need some space, and so does a service that reports a full disk.
    if settings.database_url.is_none() && settings.data_dir.is_dir() && reserve::give_up_if_full(&settings.data_dir) {
        tracing::warn!("the disk of the data directory is full; the space that is kept for this is used");
    }
    let opened = SqlStore::open(&settings.database(settings.database_connections)).await;
    let opened = opened.map_err(|e| store_error("the database", &e))?;
    let keyring = open_keyring(settings)?;
    let seal = match (&settings.secret_key_file, &settings.database_url) {
        (Some(path), _) => Some((path.clone(), Seal::read(path))),
        // With a keyring the file is not created, only read, because it may have sealed stored secrets.
        (None, _) if keyring.is_some() => {
            let path = settings.data_dir.join(SECRET_KEY_FILE);
            path.exists().then(|| (path.clone(), Seal::read(&path)))
        }
        (None, None) => {
            let path = settings.data_dir.join(SECRET_KEY_FILE);
            Some((path.clone(), Seal::read_or_create(&path)))
        }
        // Processes on several machines need the same key, which only the operator can distribute.
        (None, Some(_)) => None,
    };
    let seal = seal.map(|(path, seal)| seal.map_err(|error| AppError::SecretKey { path, error })).transpose()?;
    let seal = match keyring {
        Some(keyring) => Some(Seal::with_keyring(keyring, seal)),
        None => seal,
    };
    let settings = StoreSettings {
        weights: settings.tenant_weights(),
        max_running: settings.max_running,
        crash_pause: settings.crash_pause(),
        seal,
    };
    Ok(opened.with(settings))
}

/// The keys for encryption at rest; `None` if the settings name none.
///
/// # Errors
/// [`AppError::Encryption`].
pub fn open_keyring(settings: &ServiceSettings) -> Result<Option<Arc<Keyring>>, AppError> {
    let read = match (&settings.encryption_key_file, &settings.encryption_key_command) {
        (None, None) => return Ok(None),
        (Some(path), None) => Keyring::read(path),
        (None, Some(command)) => Keyring::from_command(command),
        (Some(_), Some(_)) => Err("either --encryption-key-file or --encryption-key-command, not both".to_owned()),
    };
    read.map(|keyring| Some(Arc::new(keyring))).map_err(AppError::Encryption)
}

/// Refuses to run without the key that encrypts the blobs of this service. Records a new key, except in a dry run.
///
/// # Errors
/// [`AppError::Encryption`], [`AppError::Store`].
pub(crate) async fn require_keys(store: &SqlStore, keyring: Option<&Keyring>, dry_run: bool) -> Result<(), AppError> {
    let database = |e: JobError| store_error("the database", &e);
    let noted = store.encryption_key().await.map_err(database)?;
    let current = keyring.and_then(Keyring::current).map(|id| id.to_string());
    match (noted, keyring, current) {
        (Some(noted), None, _) => Err(AppError::Encryption(format!(
            "the blobs of this service are encrypted with the key {noted}; give it with --encryption-key-file or \
             --encryption-key-command"
        ))),
        (Some(noted), Some(keyring), _) if !keyring.knows(&noted) => Err(AppError::Encryption(format!(
            "the key {noted}, which encrypts the blobs of this service, is not among the given ones"
        ))),
        (noted, _, Some(current)) if !dry_run && noted.as_ref() != Some(&current) => {
            store.set_encryption_key(&current).await.map_err(database)?;
            tracing::info!(key_id = current, "blobs and secrets are encrypted with this key from now on");
            Ok(())
        }
        _ => Ok(()),
    }
}

/// Refuses to run with a blob store other than that of the processes that share the database, because their inputs
/// would not be found. The first process puts a blob with a random mark into its store and the mark into the database;
/// the others must find this blob.
///
/// # Errors
/// [`AppError::OtherBlobs`], [`AppError::Store`].
pub(crate) async fn require_shared_blobs(store: &SqlStore, blobs: &dyn StoredBlobs) -> Result<(), AppError> {
    let database = |e: JobError| store_error("the database", &e);
    let marked = |mark: &str| bytes::Bytes::from(format!("blob store of homolog {mark}\n"));
    let key_of = |mark: &str| ArtifactKey::of(&Tenant::default(), &marked(mark));
    let noted = store.blob_store_mark().await.map_err(database)?;
    let mark = match noted {
        Some(mark) => mark,
        None => {
            let own = uuid::Uuid::new_v4().to_string();
            // Stored before the mark is recorded, so that every reader of the mark finds the blob.
            blobs.put(&key_of(&own), marked(&own)).await.map_err(|e| store_error("the blob store", &e))?;
            match store.set_blob_store_mark(&own).await.map_err(database)? {
                true => own,
                false => store.blob_store_mark().await.map_err(database)?.ok_or(AppError::OtherBlobs)?,
            }
        }
    };
    match blobs.stored(&key_of(&mark)).await {
        Ok(found) if found == marked(&mark) => Ok(()),
        Ok(_) | Err(JobError::Corrupt { .. }) => Err(AppError::OtherBlobs),
        Err(error) => Err(store_error("the blob store", &error)),
    }
}

/// Opens the blob store of the settings.
///
/// # Errors
/// [`AppError::Store`], [`AppError::Encryption`].
pub fn open_artifacts(settings: &ServiceSettings) -> Result<Arc<dyn ArtifactStore>, AppError> {
    let stored = open_stored(settings)?;
    Ok(match open_keyring(settings)? {
        Some(keyring) => Arc::new(SealedArtifacts::new(stored, keyring)),
        None => stored,
    })
}

/// The blob store of the settings, without encryption.
///
/// # Errors
/// [`AppError::Store`].
pub(crate) fn open_stored(settings: &ServiceSettings) -> Result<Arc<dyn StoredBlobs>, AppError> {
    Ok(match &settings.artifacts_url {
        None => {
            Arc::new(FolderArtifacts::open(&settings.data_dir).map_err(|e| store_error("the folder of blobs", &e))?)
        }
        Some(url) => Arc::new(S3Artifacts::open(url).map_err(|e| store_error("the S3-compatible store", &e))?),
    })
}

/// The engine of this program: in child processes or in threads, by the settings.
///
/// # Errors
/// [`AppError::Isolation`].
pub fn engine(settings: &ServiceSettings) -> Result<Arc<dyn Engine>, AppError> {
    let Some(isolation) = settings.isolation_settings().map_err(AppError::Isolation)? else {
        return Ok(Arc::new(MatchEngine::priced(
            settings.intake_limits(),
            settings.price_limit(),
            settings.prepared_bytes(),
        )));
    };
    let engine = IsolatedEngine::start(isolation).map_err(AppError::Isolation)?;
    match engine.unconfined() {
        None => tracing::debug!("computations run in processes of their own"),
        // The confinement that the kernel does not support.
        Some(lacking) => tracing::warn!(lacking, "computations are not fully confined"),
    }
    Ok(Arc::new(engine))
}

/// A listener on the address of the settings, unless other machines could use it without authentication.
///
/// # Errors
/// [`AppError::Insecure`], [`AppError::Listen`].
pub async fn listen(http: &HttpSettings) -> Result<TcpListener, AppError> {
    let address = http.listen;
    if http.auth_mode().is_none() {
        return Err(AppError::Insecure(address));
    }
    open_tokens(http)?;
    open_tls(http)?;
    bind(address).await
}

/// The certificates of the listener, by the settings; `None`: no TLS.
fn open_tls(http: &HttpSettings) -> Result<Option<Arc<ServerTls>>, AppError> {
    let files = http.tls_files().map_err(AppError::Tls)?;
    files.map(ServerTls::open).transpose().map_err(AppError::Tls)
}

/// The verifier of tokens, by the settings; `None`: no tokens are accepted.
fn open_tokens(http: &HttpSettings) -> Result<Option<Tokens>, AppError> {
    let settings = http.tokens().map_err(AppError::Tokens)?;
    settings.map(Tokens::open).transpose().map_err(AppError::Tokens)
}

/// A listener on this address.
///
/// # Errors
/// [`AppError::Listen`].
pub async fn bind(address: SocketAddr) -> Result<TcpListener, AppError> {
    TcpListener::bind(address).await.map_err(|error| AppError::Listen { address, error })
}

/// The error of a process that cannot use a store.
pub(crate) fn store_error(what: &'static str, error: &JobError) -> AppError {
    AppError::Store { what, error: crate::worker::error_text::with_sources(error) }
}
