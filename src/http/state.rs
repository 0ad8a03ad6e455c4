//! The state that all handlers share: the use cases, the limits and settings, and the stocks of slots, memory and streams.

use super::auth_mode::AuthMode;
use super::cors::CorsOrigins;
use super::hosts::AllowedHosts;
use super::pace::LeastRate;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::rate::RequestRate;
use super::shares::{Origin, SharePermit, Shares, owner};
use super::tokens::Tokens;
use super::upload::{LimitedBody, Reading};
use crate::jobs::{JobService, Tenant};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio_util::sync::CancellationToken;

/// Memory for each byte of a body that is decoded: while the body is read, both the body and the decoded form are in
/// memory.
pub(super) const IN_MEMORY: u64 = 2;
/// Memory for each byte of a body that is stored as it arrives.
pub(super) const AS_IT_ARRIVES: u64 = 0;

/// Bounds on requests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HttpLimits {
    /// Largest file of a submission.
    pub max_file_bytes: usize,
    /// Largest body of JSON.
    pub max_json_bytes: usize,
    /// Largest parameters of a match.
    pub max_parameters_bytes: usize,
    /// Most jobs of a batch; further entries of a longer list are not kept.
    pub max_batch: usize,
    /// Bodies read at the same time; one tenant has at most half of them.
    pub max_uploads: usize,
    /// Memory of all bodies that are being read and checked; one tenant has at most half of it, or one body.
    pub max_body_memory_bytes: u64,
    /// Memory of all answers being sent, except those streamed from the store; shared in the same way.
    pub max_answer_memory_bytes: u64,
    /// The least rate at which a body arrives.
    pub least_rate: LeastRate,
    /// Most event streams and long polls of a tenant at the same time, and of an address.
    pub max_streams: u32,
    /// Longest time between two checks whether the key of an open stream is still valid.
    pub access_interval: Duration,
    /// Longest wait for a slot, and for memory.
    pub max_upload_wait: Duration,
    /// Longest time for a submission, its body included.
    pub upload_timeout: Duration,
    /// Longest time for any other request.
    pub request_timeout: Duration,
    /// Whether webhooks may go to private addresses.
    pub allow_private_webhooks: bool,
    /// Whether a request that cannot be recorded in the audit log is refused.
    pub audit_required: bool,
    /// Requests a second of a tenant, on average; 0: any number.
    pub max_request_rate: u32,
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
    /// Whether API keys are required.
    pub auth: AuthMode,
    /// The metrics of the process, in the text format of Prometheus.
    pub metrics: Arc<dyn Fn() -> String + Send + Sync>,
    /// Which hosts a request may name; `None`: any.
    pub hosts: Option<Arc<AllowedHosts>>,
    /// Origins whose pages may use the service.
    pub cors: CorsOrigins,
    /// Verifies tokens, if an OpenID Connect provider is set.
    pub tokens: Option<Arc<Tokens>>,
    /// Cancelled when the process shuts down; long polls then answer at once.
    pub stop: CancellationToken,
    /// Writes the OpenAPI document; empty without the routes of the service.
    pub(super) document: fn() -> Result<String, serde_json::Error>,
    stocks: Arc<Stocks>,
}

/// The resources that requests share.
struct Stocks {
    bodies: Arc<Shares>,
    body_memory: Arc<Shares>,
    answer_memory: Arc<Shares>,
    streams: Arc<Shares>,
    requests: RequestRate,
}

impl Stocks {
    fn new(limits: &HttpLimits) -> Self {
        let half = |total: u64| total.div_ceil(2);
        let bodies = (limits.max_uploads as u64).max(1);
        // The largest allowed body fits, whatever the setting.
        let largest = (limits.max_body_bytes() as u64).saturating_mul(IN_MEMORY);
        let memory = limits.max_body_memory_bytes.max(largest);
        let streams = u64::from(limits.max_streams);
        Stocks {
            bodies: Shares::new(bodies, half(bodies)),
            body_memory: Shares::new(memory, half(memory).max(largest)),
            answer_memory: Shares::new(limits.max_answer_memory_bytes, half(limits.max_answer_memory_bytes)),
            streams: Shares::new(u64::MAX, streams),
            requests: RequestRate::new(limits.max_request_rate),
        }
    }
}

impl HttpState {
    /// The state over these use cases.
    pub fn new(service: Arc<JobService>, limits: HttpLimits, auth: AuthMode, stop: CancellationToken) -> Self {
        let stocks = Arc::new(Stocks::new(&limits));
        HttpState {
            service,
            limits,
            auth,
            metrics: Arc::new(String::new),
            hosts: None,
            cors: CorsOrigins::default(),
            tokens: None,
            stop,
            document: || Ok(String::new()),
            stocks,
        }
    }

    /// Also accepts tokens.
    #[must_use]
    pub fn with_tokens(mut self, tokens: Option<Tokens>) -> Self {
        self.tokens = tokens.map(Arc::new);
        self
    }

    /// Restricts the hosts that requests may name; `None` allows any.
    #[must_use]
    pub fn for_hosts(mut self, hosts: Option<AllowedHosts>) -> Self {
        self.hosts = hosts.map(Arc::new);
        self
    }

    /// Allows pages of these origins to use the service.
    #[must_use]
    pub fn for_origins(mut self, cors: CorsOrigins) -> Self {
        self.cors = cors;
        self
    }
}

impl HttpState {
    /// Counts a request of a tenant.
    ///
    /// # Errors
    /// `too-many-requests`.
    pub(super) fn begin_request(&self, tenant: &Tenant, origin: Origin) -> Result<(), Problem> {
        let rate = &self.stocks.requests;
        let Err(wait) = rate.take(&owner(self.auth, tenant, origin), Instant::now()) else { return Ok(()) };
        let (per_s, burst) = (rate.per_s(), rate.burst());
        let seconds = u32::try_from(wait.as_secs()).unwrap_or(u32::MAX).saturating_add(1);
        Err(Problem::new(ProblemKind::TooManyRequests)
            .detail(format!("at most {per_s} requests a second on average, and {burst} at once"))
            .member("limit_per_s", per_s.into())
            .retry_after(seconds))
    }

    /// Begins to read a body, which takes memory of `factor` times its size. Its slot and its memory are returned when
    /// the tap is dropped.
    ///
    /// # Errors
    /// `busy` if no slot becomes free in time.
    pub(super) async fn begin_reading(
        &self,
        tap: &LimitedBody,
        tenant: &Tenant,
        origin: Origin,
        factor: u64,
    ) -> Result<(), Problem> {
        let owner = owner(self.auth, tenant, origin);
        let max_wait = self.limits.max_upload_wait;
        let slot = self.stocks.bodies.take(&owner, 1, max_wait).await;
        let (Some(slot), Some(memory)) = (slot, self.stocks.body_memory.try_take(&owner, 0)) else {
            return Err(Problem::new(ProblemKind::Busy).retry_after(5));
        };
        tap.count(Reading { _slot: slot, memory, factor, least: self.limits.least_rate, max_wait });
        Ok(())
    }

    /// A place for an event stream or a long poll, within the limits of the tenant and of the address.
    ///
    /// # Errors
    /// `too-many-streams`.
    pub(super) fn begin_stream(
        &self,
        tenant: &Tenant,
        Origin(address): Origin,
    ) -> Result<[Option<SharePermit>; 2], Problem> {
        let too_many = || {
            let detail = format!("at most {} at the same time", self.limits.max_streams);
            Problem::new(ProblemKind::TooManyStreams).detail(detail).retry_after(5)
        };
        let of_tenant = self.stocks.streams.try_take(tenant.name(), 1).ok_or_else(too_many)?;
        let of_address = match address {
            // An address contains a dot or a colon, which no tenant's name does.
            Some(address) => Some(self.stocks.streams.try_take(&address.to_string(), 1).ok_or_else(too_many)?),
            None => None,
        };
        Ok([Some(of_tenant), of_address])
    }

    /// Memory for an answer of `n` bytes, held until the answer is sent.
    ///
    /// # Errors
    /// `busy` if this tenant does not get the memory in time.
    pub(super) async fn answer_memory(
        &self,
        tenant: &Tenant,
        origin: Origin,
        n: usize,
    ) -> Result<SharePermit, Problem> {
        let owner = owner(self.auth, tenant, origin);
        // An answer that is larger than a share takes the whole share.
        let n = (n as u64).min(self.limits.max_answer_memory_bytes.div_ceil(2));
        let taken = self.stocks.answer_memory.take(&owner, n, self.limits.max_upload_wait).await;
        taken.ok_or_else(|| Problem::new(ProblemKind::Busy).retry_after(5))
    }

    /// Sets the text that `/metrics` returns.
    #[must_use]
    pub fn with_metrics(mut self, metrics: impl Fn() -> String + Send + Sync + 'static) -> Self {
        self.metrics = Arc::new(metrics);
        self
    }
}
