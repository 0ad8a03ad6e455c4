//! The wiring: which store, which engine, which workers, and how a process begins and ends.

use crate::config::{HttpSettings, ServiceSettings};
use crate::http::{HttpState, router, serve};
use crate::jobs::{ArtifactStore, Engine, JobError, JobService, JobStore, WorkerId};
use crate::store::artifacts::FolderArtifacts;
use crate::store::presence::{Ownership, Presence};
use crate::store::sqlite::SqliteStore;
use crate::worker::heartbeat::Heart;
use crate::worker::housekeeper::Housekeeper;
use crate::worker::match_engine::MatchEngine;
use crate::worker::{Pool, PoolParts};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::sync::Notify;
use tokio_util::sync::CancellationToken;

/// How long a new `serve` waits for its predecessor to leave the data directory.
const TAKEOVER: Duration = Duration::from_secs(10);
/// How long open connections may hold up the end of a process after its jobs are settled.
const LAST_ANSWERS: Duration = Duration::from_secs(5);

/// Why a process does not begin.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
    /// Others could reach the service, and nobody would be asked who they are.
    #[error("{0} can be reached from outside and there is no authentication: listen on 127.0.0.1, or say --insecure")]
    Insecure(SocketAddr),
    /// The address cannot be had.
    #[error("cannot listen on {address}: {error}")]
    Listen {
        /// Which.
        address: SocketAddr,
        /// Why.
        error: std::io::Error,
    },
    /// The data directory cannot be used.
    #[error("cannot use the data directory {}: {error}", path.display())]
    DataDir {
        /// Which.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// Another process serves it.
    #[error("another `homolog serve` uses the data directory {}; `homolog worker` may share it", .0.display())]
    Taken(PathBuf),
    /// A store cannot be opened.
    #[error("{what} cannot be opened: {error}")]
    Store {
        /// Which.
        what: &'static str,
        /// Why, with causes.
        error: String,
    },
    /// The system gives no thread.
    #[error("no thread: {0}")]
    Thread(std::io::Error),
}

/// The two signals to end: the first asks, the second insists.
#[derive(Debug, Clone, Default)]
pub struct Shutdown {
    /// Accept and claim nothing more.
    pub stop: CancellationToken,
    /// Give running jobs back now.
    pub give_back: CancellationToken,
}

impl Shutdown {
    /// Follows SIGTERM and SIGINT: the first sets `stop` and, after `grace`, `give_back`; the second both at once.
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
        tracing::error!("signals cannot be followed; end the process by killing it");
        return std::future::pending().await;
    };
    tokio::select! {
        _ = terminate.recv() => {}
        _ = interrupt.recv() => {}
    }
}

/// What a process of the service consists of, whether it answers HTTP or not.
pub struct App {
    parts: PoolParts,
    housekeeper: Housekeeper,
    stores: [SqliteStore; 2],
    _ownership: Option<Ownership>,
}

impl App {
    /// Opens the data directory and takes back jobs of processes that are gone.
    ///
    /// # Errors
    /// [`AppError`].
    pub async fn open(
        settings: &ServiceSettings,
        engine: Arc<dyn Engine>,
        shutdown: &Shutdown,
        serves: bool,
    ) -> Result<Self, AppError> {
        let data_dir = settings.data_dir.clone();
        let unusable = |error| AppError::DataDir { path: data_dir.clone(), error };
        std::fs::create_dir_all(&data_dir).map_err(unusable)?;
        let ownership = if serves {
            Some(Ownership::take(&data_dir, TAKEOVER).map_err(unusable)?.ok_or(AppError::Taken(data_dir.clone()))?)
        } else {
            None
        };
        let database = |e: JobError| AppError::Store { what: "the database", error: with_causes(&e) };
        let store = SqliteStore::open(&data_dir).await.map_err(database)?;
        // Heartbeats have connections of their own, so that they never wait behind other work of this process.
        let heart_store = SqliteStore::open(&data_dir).await.map_err(database)?;
        let artifacts = FolderArtifacts::open(&data_dir)
            .map_err(|e| AppError::Store { what: "the folder of blobs", error: with_causes(&e) })?;
        let worker = WorkerId::random();
        let presence = Presence::announce(&data_dir, &worker).map_err(unusable)?;
        let worker_settings = settings.worker_settings();
        let heart = Heart::start(Arc::new(heart_store.clone()), worker_settings.heartbeat, worker_settings.lease)
            .map_err(AppError::Thread)?;
        let job_store: Arc<dyn JobStore> = Arc::new(store.clone());
        let artifacts: Arc<dyn ArtifactStore> = Arc::new(artifacts);
        let housekeeper = Housekeeper {
            store: Arc::clone(&job_store),
            artifacts: Arc::clone(&artifacts),
            presence: Arc::new(presence),
        };
        housekeeper.recover().await.map_err(database)?;
        let parts = PoolParts {
            store: job_store,
            artifacts,
            engine,
            heart: Arc::new(heart),
            worker,
            settings: worker_settings,
            queued: Arc::new(Notify::new()),
            stop: shutdown.stop.clone(),
            give_back: shutdown.give_back.clone(),
        };
        Ok(App { parts, housekeeper, stores: [store, heart_store], _ownership: ownership })
    }

    /// Runs jobs, and answers HTTP on `listener` if there is one, until `shutdown`.
    pub async fn run(self, http: Option<(TcpListener, HttpSettings, ServiceSettings)>, shutdown: &Shutdown) {
        let housekeeping = tokio::spawn(self.housekeeper.clone().run(shutdown.stop.clone()));
        let pool = Pool::start(&self.parts);
        let server = http.map(|(listener, http, service)| {
            let use_cases = JobService::new(
                Arc::clone(&self.parts.store),
                Arc::clone(&self.parts.artifacts),
                Arc::clone(&self.parts.engine),
                http.submission_limits(&service),
                Arc::clone(&self.parts.queued),
            );
            let state = HttpState::new(Arc::new(use_cases), http.http_limits(&service), shutdown.stop.clone())
                .for_hosts(http.hosts());
            tokio::spawn(serve(listener, router(state), http.connection_limits(), shutdown.stop.clone()))
        });
        shutdown.stop.cancelled().await;
        pool.ended().await;
        let _ = housekeeping.await;
        if let Some(mut server) = server
            && tokio::time::timeout(LAST_ANSWERS, &mut server).await.is_err()
        {
            tracing::warn!("connections are still open; they are cut");
            server.abort();
            let _ = server.await;
        }
        for store in &self.stores {
            store.close().await;
        }
        tracing::info!("ended");
    }
}

/// The engine of this program.
pub fn engine(settings: &ServiceSettings) -> Arc<dyn Engine> {
    Arc::new(MatchEngine { limits: settings.intake_limits() })
}

/// A listener on the address of the settings, refused where it would be open to all.
///
/// # Errors
/// [`AppError::Insecure`], [`AppError::Listen`].
pub async fn listen(http: &HttpSettings) -> Result<TcpListener, AppError> {
    let address = http.listen;
    if !address.ip().is_loopback() && !http.insecure {
        return Err(AppError::Insecure(address));
    }
    TcpListener::bind(address).await.map_err(|error| AppError::Listen { address, error })
}

fn with_causes(error: &dyn std::error::Error) -> String {
    crate::worker::pool::with_sources(error)
}
