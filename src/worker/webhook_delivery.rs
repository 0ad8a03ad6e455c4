//! Delivery of webhooks: state changes become deliveries, which are attempted until the receiver accepts them.
//!
//! Every process that serves HTTP delivers webhooks; workers do not. Each webhook has its own queue and takes turns
//! with the others; the store ensures that only one process at a time serves a webhook. A receiver that does not answer
//! delays only its own deliveries: a tenant has a limited share of the concurrent turns, the turns of a failing
//! receiver become rare ([`FAILURES`]), and new changes are sent before old ones are repeated.
//!
//! If a delivery was sent but its success could not be recorded, it is sent again under the same id, by which the
//! receiver can recognize it.

use super::error_text::with_sources;
use crate::jobs::address::{NOT_PUBLIC, check_url, is_public};
use crate::jobs::{Attempted, DueDelivery, JobError, Turn, TurnLimits, WebhookStore};
use crate::spans::{Fact, Span};
use futures_util::future::join_all;
use reqwest::dns::{Addrs, Name, Resolve, Resolving};
use reqwest::redirect::Policy;
use reqwest::{Client, StatusCode};
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio_util::sync::CancellationToken;

/// Time between two checks for changes and deliveries.
const ROUND: Duration = Duration::from_millis(500);
/// Time limit of an attempt.
const ATTEMPT_TIMEOUT: Duration = Duration::from_secs(15);
/// How long a webhook is withheld from other processes during its turn; longer than an attempt takes.
const CLAIM: Duration = Duration::from_secs(60);
/// Attempts after which a delivery has failed.
const MAX_ATTEMPTS: u32 = 10;
/// Longest pause between two attempts.
const MAX_PAUSE: Duration = Duration::from_secs(12 * 3600);
/// Deliveries of a webhook in a turn, which are attempted concurrently.
const OF_TURN: u32 = 8;
/// Turns without success after which a receiver is paused; each further failed turn triples the pause.
const FAILURES: u32 = 3;
/// Longest pause of a receiver.
const MAX_BREAK: Duration = Duration::from_secs(3600);

/// Settings of the delivery of webhooks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WebhookDeliverySettings {
    /// Whether receivers may have private addresses.
    pub allow_private: bool,
    /// Pause after the first failed attempt; each further pause is three times as long.
    pub first_pause: Duration,
    /// Receivers that are called at the same time; a tenant may have a quarter of them, in all processes.
    pub receivers: u32,
}

/// Delivers events to the receivers of webhooks.
#[derive(Clone)]
pub struct WebhookDelivery {
    store: Arc<dyn WebhookStore>,
    client: Client,
    settings: WebhookDeliverySettings,
}

/// A host name resolves to an address that is not public.
#[derive(Debug, Clone, Copy, thiserror::Error)]
#[error("the receiver's host name resolves to an address that is not public")]
struct NotPublic;

impl NotPublic {
    /// Whether a private address caused this error.
    fn is_cause_of(error: &reqwest::Error) -> bool {
        let mut next = Some(error as &(dyn std::error::Error + 'static));
        while let Some(error) = next {
            if error.is::<NotPublic>() {
                return true;
            }
            next = error.source();
        }
        false
    }
}

/// Resolves host names, and refuses private addresses unless they are allowed.
#[derive(Debug, Clone, Copy)]
struct PublicOnly {
    allow_private: bool,
}

impl Resolve for PublicOnly {
    fn resolve(&self, name: Name) -> Resolving {
        let allow_private = self.allow_private;
        Box::pin(async move {
            let found: Vec<SocketAddr> = tokio::net::lookup_host((name.as_str(), 0)).await?.collect();
            // One private address among public ones is enough to refuse: the owner of the name controls which address
            // is used.
            if !allow_private && found.iter().any(|address| !is_public(address.ip())) {
                return Err(NotPublic.into());
            }
            Ok(Box::new(found.into_iter()) as Addrs)
        })
    }
}

impl WebhookDelivery {
    /// Delivery of the webhooks in this store.
    ///
    /// # Errors
    /// If the HTTP client cannot be created, for example because the system's certificates cannot be read.
    pub fn new(store: Arc<dyn WebhookStore>, settings: WebhookDeliverySettings) -> Result<Self, reqwest::Error> {
        crate::tls::prepare();
        let client = Client::builder()
            .redirect(Policy::none())
            .timeout(ATTEMPT_TIMEOUT)
            .no_proxy()
            .dns_resolver(Arc::new(PublicOnly { allow_private: settings.allow_private }))
            .user_agent(concat!("homolog/", env!("CARGO_PKG_VERSION")))
            .build()?;
        Ok(WebhookDelivery { store, client, settings })
    }

    /// Delivers until `stop` is cancelled.
    pub async fn run(self, stop: CancellationToken) {
        let mut turns = tokio::task::JoinSet::new();
        loop {
            // New changes are queued, and other receivers served, while earlier turns are still in progress.
            if let Err(error) = self.begin_turns(&mut turns).await {
                tracing::warn!(error = %with_sources(&error), "webhooks could not be delivered; tried again in the next round");
            }
            tokio::select! {
                () = stop.cancelled() => return,
                () = tokio::time::sleep(ROUND) => {}
                Some(_) = turns.join_next() => {}
            }
        }
    }

    async fn begin_turns(&self, turns: &mut tokio::task::JoinSet<()>) -> Result<(), JobError> {
        self.store.insert_due_deliveries().await?;
        while turns.try_join_next().is_some() {}
        let of_tenant = self.settings.receivers.div_ceil(4);
        let limits = TurnLimits { busy_for: CLAIM, of_tenant, deliveries: OF_TURN };
        while turns.len() < self.settings.receivers as usize {
            let Some(turn) = self.store.claim_turn(&limits).await? else { break };
            let delivery = self.clone();
            turns.spawn(async move { delivery.serve(turn).await });
        }
        Ok(())
    }

    /// Attempts the deliveries of a turn, and decides when the next one begins.
    async fn serve(&self, turn: Turn) {
        let Turn { webhook_id, failures, deliveries } = turn;
        let attempts = deliveries.into_iter().map(|due| self.deliver(due));
        let mut has_success = false;
        for attempted in join_all(attempts).await {
            match attempted {
                Ok(attempted) => has_success |= matches!(attempted, Attempted::Delivered { .. }),
                Err(error) => {
                    tracing::warn!(error = %with_sources(&error), "the outcome of a delivery could not be recorded")
                }
            }
        }
        let failures = if has_success { 0 } else { failures.saturating_add(1) };
        if let Err(error) = self.store.end_turn(&webhook_id, failures, self.pause_after(failures)).await {
            tracing::warn!(error = %with_sources(&error), "the turn of a webhook could not be ended; it ends by itself");
        }
    }

    /// The pause after this number of turns without success.
    fn pause_after(&self, failures: u32) -> Duration {
        match failures.checked_sub(FAILURES) {
            None => Duration::ZERO,
            Some(more) => self.settings.first_pause.saturating_mul(3u32.saturating_pow(more)).min(MAX_BREAK),
        }
    }

    async fn deliver(&self, due: DueDelivery) -> Result<Attempted, JobError> {
        let attempted = if due.is_wanted {
            let began = Instant::now();
            let mut span = Span::of_delivery(due.traceparent.as_deref());
            span.set("homolog.attempt", Fact::Number(due.attempt.into()));
            let attempted = self.attempt(&due, span.traceparent()).await?;
            let outcome = match &attempted {
                Attempted::Delivered { .. } => "delivered",
                Attempted::Retry { .. } => "failed",
                Attempted::Failed { .. } => "given up",
            };
            span.set("homolog.outcome", Fact::Word(outcome));
            if outcome != "delivered" {
                span.fail();
            }
            drop(span);
            metrics::counter!("homolog_webhook_attempts_total", "outcome" => outcome).increment(1);
            metrics::histogram!("homolog_webhook_attempt_seconds").record(began.elapsed().as_secs_f64());
            attempted
        } else {
            Attempted::Failed { status: None, error: "the webhook is disabled".to_owned() }
        };
        tracing::debug!(delivery = due.id, attempt = due.attempt, ?attempted, "a delivery was attempted");
        self.store.end_attempt(&due.id, &attempted).await?;
        Ok(attempted)
    }

    /// Attempts a delivery; `context` is the trace context of its span.
    async fn attempt(&self, due: &DueDelivery, context: Option<String>) -> Result<Attempted, JobError> {
        let answer = self.send(due, context).await;
        Ok(match answer {
            Ok(status) if status.is_success() => Attempted::Delivered { status: status.as_u16() },
            // 410 means that the receiver is gone permanently.
            Ok(StatusCode::GONE) => {
                self.store.disable_webhook(&due.webhook_id, "the receiver answered 410 Gone").await?;
                Attempted::Failed { status: Some(410), error: "the receiver answered 410 Gone".to_owned() }
            }
            Ok(status) => self.retry(due, Some(status.as_u16()), format!("the receiver answered {}", status.as_u16())),
            Err(error) => self.retry(due, None, error),
        })
    }

    /// A further attempt after a pause, unless this was the last one.
    fn retry(&self, due: &DueDelivery, status: Option<u16>, error: String) -> Attempted {
        if due.attempt >= MAX_ATTEMPTS {
            return Attempted::Failed { status, error };
        }
        let factor = 3u32.saturating_pow(due.attempt.saturating_sub(1));
        Attempted::Retry { after: self.settings.first_pause.saturating_mul(factor).min(MAX_PAUSE), status, error }
    }

    /// Sends a delivery, signed according to Standard Webhooks. The text of an error contains no address.
    async fn send(&self, due: &DueDelivery, context: Option<String>) -> Result<StatusCode, String> {
        // A literal address is not resolved, so it is checked here.
        let url = check_url(&due.url, self.settings.allow_private).map_err(str::to_owned)?;
        let now = jiff::Timestamp::now().as_second();
        let signer =
            standardwebhooks::Webhook::new(&due.secret).map_err(|_| "the webhook's secret is invalid".to_owned())?;
        let signature = signer
            .sign(&due.id, now, due.payload.as_bytes())
            .map_err(|_| "the delivery could not be signed".to_owned())?;
        let request = self
            .client
            .post(url)
            .header("content-type", "application/json")
            .header("webhook-id", &due.id)
            .header("webhook-timestamp", now.to_string())
            .header("webhook-signature", signature)
            .body(due.payload.clone());
        let request = match context.as_ref().or(due.traceparent.as_ref()) {
            Some(traceparent) => request.header("traceparent", traceparent),
            None => request,
        };
        match request.send().await {
            Ok(response) => Ok(response.status()),
            Err(error) if NotPublic::is_cause_of(&error) => Err(format!("{NotPublic}: {NOT_PUBLIC}")),
            Err(error) if error.is_timeout() => Err("the receiver did not answer in time".to_owned()),
            Err(error) if error.is_connect() => Err("the receiver could not be reached".to_owned()),
            Err(_) => Err("the delivery could not be sent".to_owned()),
        }
    }
}
