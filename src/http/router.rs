//! The routes and the layers around them.

use super::auth::AuthMode;
use super::context::{panic_problem, surround};
use super::hosts::{AllowedHosts, check_host};
use super::openapi::document;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::routes;
use crate::jobs::JobService;
use axum::Router;
use axum::extract::DefaultBodyLimit;
use axum::routing::get;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio_util::sync::CancellationToken;
use tower::ServiceBuilder;
use tower_http::catch_panic::CatchPanicLayer;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

/// Bounds on requests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HttpLimits {
    /// Largest file of a submission.
    pub max_file_bytes: usize,
    /// Submissions read at the same time; each may hold two files in memory.
    pub max_uploads: usize,
    /// Longest wait for one of those slots.
    pub max_upload_wait: Duration,
    /// Longest time for a submission, its body included.
    pub upload_timeout: Duration,
    /// Longest time for any other request.
    pub request_timeout: Duration,
    /// Whether webhooks may go to private addresses.
    pub allow_private_webhooks: bool,
}

impl HttpLimits {
    /// Largest body: two files, the text fields and the multipart framing.
    pub fn max_body_bytes(&self) -> usize {
        self.max_file_bytes.saturating_mul(2).saturating_add(4 << 20)
    }
}

/// State shared by all handlers.
#[derive(Clone)]
pub struct HttpState {
    /// The use cases.
    pub service: Arc<JobService>,
    /// Bounds.
    pub limits: HttpLimits,
    /// Slots for submissions being read.
    pub uploads: Arc<Semaphore>,
    /// Whether API keys are required.
    pub auth: AuthMode,
    /// The metrics of the process, in the text format of Prometheus.
    pub metrics: Arc<dyn Fn() -> String + Send + Sync>,
    /// Which hosts a request may name; `None`: any.
    pub hosts: Option<Arc<AllowedHosts>>,
    /// Cancelled when the process shuts down; long polls then answer at once.
    pub stop: CancellationToken,
}

impl HttpState {
    /// The state over these use cases.
    pub fn new(service: Arc<JobService>, limits: HttpLimits, auth: AuthMode, stop: CancellationToken) -> Self {
        let uploads = Arc::new(Semaphore::new(limits.max_uploads.max(1)));
        HttpState { service, limits, uploads, auth, metrics: Arc::new(String::new), hosts: None, stop }
    }

    /// Restricts the hosts that requests may name; `None` allows any.
    #[must_use]
    pub fn for_hosts(mut self, hosts: Option<AllowedHosts>) -> Self {
        self.hosts = hosts.map(Arc::new);
        self
    }
}

impl HttpState {
    /// An upload slot, held until it is dropped.
    ///
    /// # Errors
    /// `busy` if no slot becomes free in time.
    pub(super) async fn upload_permit(&self) -> Result<OwnedSemaphorePermit, Problem> {
        let permit = Arc::clone(&self.uploads).acquire_owned();
        match tokio::time::timeout(self.limits.max_upload_wait, permit).await {
            Ok(Ok(permit)) => Ok(permit),
            _ => Err(Problem::new(ProblemKind::Busy).retry_after(5)),
        }
    }

    /// Sets the text that `/metrics` answers.
    #[must_use]
    pub fn with_metrics(mut self, metrics: impl Fn() -> String + Send + Sync + 'static) -> Self {
        self.metrics = Arc::new(metrics);
        self
    }
}

/// The routes of a worker process: health checks and metrics only.
pub fn probe_router(state: HttpState) -> Router {
    Router::new()
        .route("/healthz", get(routes::system::healthz))
        .route("/readyz", get(routes::system::readyz))
        .route("/metrics", get(routes::system::metrics))
        .fallback(|| async { Problem::new(ProblemKind::RouteNotFound) })
        .with_state(state)
}

/// Every route with its description.
pub(super) fn api() -> OpenApiRouter<HttpState> {
    OpenApiRouter::with_openapi(document())
        .routes(routes!(routes::jobs::submit, routes::jobs::list))
        .routes(routes!(routes::jobs::get, routes::jobs::delete))
        .routes(routes!(routes::jobs::cancel_many))
        .routes(routes!(routes::jobs::cancel))
        .routes(routes!(routes::jobs::retry))
        .routes(routes!(routes::events::events))
        .routes(routes!(routes::trace::trace))
        .routes(routes!(routes::result::result))
        .routes(routes!(routes::result::correspondences))
        .routes(routes!(routes::result::transform))
        .routes(routes!(routes::surfaces::surface))
        .routes(routes!(routes::surfaces::aligned))
        .routes(routes!(routes::surfaces::warped))
        .routes(routes!(routes::changes::list))
        .routes(routes!(routes::batches::submit, routes::batches::list))
        .routes(routes!(routes::batches::get))
        .routes(routes!(routes::batches::jobs))
        .routes(routes!(routes::batches::cancel))
        .routes(routes!(routes::meshes::upload, routes::meshes::list))
        .routes(routes!(routes::meshes::get, routes::meshes::delete))
        .routes(routes!(routes::meshes::content))
        .routes(routes!(routes::webhooks::create, routes::webhooks::list))
        .routes(routes!(routes::webhooks::get, routes::webhooks::update, routes::webhooks::delete))
        .routes(routes!(routes::webhooks::deliveries))
        .routes(routes!(routes::webhooks::test))
        .routes(routes!(routes::methods::list))
        .routes(routes!(routes::methods::get))
        .routes(routes!(routes::system::healthz))
        .routes(routes!(routes::system::readyz))
        .routes(routes!(routes::system::metrics))
        .routes(routes!(routes::system::openapi_json))
        .routes(routes!(routes::system::problem_type))
}

/// The service as one router.
pub fn router(state: HttpState) -> Router {
    let (router, _) = api().split_for_parts();
    router
        .route("/docs", get(routes::docs::leave))
        .route("/docs/", get(routes::docs::page))
        .route("/docs/{*path}", get(routes::docs::asset))
        .fallback(|| async { Problem::new(ProblemKind::RouteNotFound) })
        .layer(
            // Outermost first.
            ServiceBuilder::new()
                .layer(axum::middleware::from_fn_with_state(state.clone(), surround))
                .layer(CatchPanicLayer::custom(panic_problem))
                .layer(axum::middleware::from_fn_with_state(state.clone(), check_host))
                // Body sizes are limited where bodies are read; axum's own limit would not answer with a problem document.
                .layer(DefaultBodyLimit::disable()),
        )
        .with_state(state)
}
