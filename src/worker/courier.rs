//! Webhooks go out: changes become deliveries, and deliveries are tried until the receiver takes them.
//!
//! Every process that answers HTTP has a courier; the store sees to it that each delivery is tried by one at a time. A
//! delivery that was sent and whose success could not be noted is sent again, with the same id: receivers recognize it.

use super::pool::with_sources;
use crate::jobs::address::{check_url, is_public};
use crate::jobs::{Attempted, DueDelivery, JobError, WebhookStore};
use reqwest::dns::{Addrs, Name, Resolve, Resolving};
use reqwest::redirect::Policy;
use reqwest::{Client, StatusCode};
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;
use tokio_util::sync::CancellationToken;

/// Between two looks for changes and deliveries.
const LOOK: Duration = Duration::from_millis(500);
/// Longest time for one attempt.
const ATTEMPT: Duration = Duration::from_secs(15);
/// Nobody else tries a delivery for so long; more than an attempt takes.
const BUSY: Duration = Duration::from_secs(60);
/// Attempts until a delivery is given up.
const MAX_ATTEMPTS: u32 = 10;
/// Longest pause between two attempts.
const MAX_PAUSE: Duration = Duration::from_secs(12 * 3600);
/// Deliveries under way at once.
const AT_ONCE: usize = 8;

/// How deliveries are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CourierSettings {
    /// Whether receivers may have private addresses.
    pub allow_private: bool,
    /// Pause after the first attempt; each further one is three times as long.
    pub first_pause: Duration,
}

/// Delivers events.
#[derive(Clone)]
pub struct Courier {
    store: Arc<dyn WebhookStore>,
    client: Client,
    settings: CourierSettings,
}

/// Resolves names, and leaves out what nobody allowed.
#[derive(Debug, Clone, Copy)]
struct PublicOnly {
    allow_private: bool,
}

impl Resolve for PublicOnly {
    fn resolve(&self, name: Name) -> Resolving {
        let allow_private = self.allow_private;
        Box::pin(async move {
            let found: Vec<SocketAddr> = tokio::net::lookup_host((name.as_str(), 0)).await?.collect();
            // One private address among public ones is reason enough: the name's owner chooses which is taken.
            if !allow_private && found.iter().any(|address| !is_public(address.ip())) {
                return Err("the receiver's name leads to an address that is not public".into());
            }
            Ok(Box::new(found.into_iter()) as Addrs)
        })
    }
}

impl Courier {
    /// A courier over this store.
    ///
    /// # Errors
    /// If no client can be made, which is a fault of the system's certificates.
    pub fn new(store: Arc<dyn WebhookStore>, settings: CourierSettings) -> Result<Self, reqwest::Error> {
        crate::tls::prepare();
        let client = Client::builder()
            .redirect(Policy::none())
            .timeout(ATTEMPT)
            .no_proxy()
            .dns_resolver(Arc::new(PublicOnly { allow_private: settings.allow_private }))
            .user_agent(concat!("homolog/", env!("CARGO_PKG_VERSION")))
            .build()?;
        Ok(Courier { store, client, settings })
    }

    /// Delivers until `stop`.
    pub async fn run(self, stop: CancellationToken) {
        loop {
            let round = tokio::select! {
                round = self.round() => round,
                () = stop.cancelled() => return,
            };
            if let Err(error) = round {
                tracing::warn!(error = %with_sources(&error), "webhooks are put off");
            }
            tokio::select! {
                () = stop.cancelled() => return,
                () = tokio::time::sleep(LOOK) => {}
            }
        }
    }

    async fn round(&self) -> Result<(), JobError> {
        self.store.tell_changes().await?;
        let mut under_way = tokio::task::JoinSet::new();
        while let Some(due) = self.store.take_delivery(BUSY).await? {
            let courier = self.clone();
            under_way.spawn(async move { courier.deliver(due).await });
            if under_way.len() >= AT_ONCE
                && let Some(Ok(done)) = under_way.join_next().await
            {
                done?;
            }
        }
        while let Some(done) = under_way.join_next().await {
            if let Ok(done) = done {
                done?;
            }
        }
        Ok(())
    }

    async fn deliver(&self, due: DueDelivery) -> Result<(), JobError> {
        let attempted = if due.is_wanted {
            self.attempt(&due).await?
        } else {
            Attempted::Failed { status: None, error: "the webhook is disabled".to_owned() }
        };
        tracing::debug!(delivery = due.id, attempt = due.attempt, ?attempted, "a delivery was tried");
        self.store.end_attempt(&due.id, &attempted).await
    }

    async fn attempt(&self, due: &DueDelivery) -> Result<Attempted, JobError> {
        let answer = self.send(due).await;
        Ok(match answer {
            Ok(status) if status.is_success() => Attempted::Delivered { status: status.as_u16() },
            // The receiver says that it is gone for good.
            Ok(StatusCode::GONE) => {
                self.store.disable_webhook(&due.webhook_id, "the receiver answered 410 Gone").await?;
                Attempted::Failed { status: Some(410), error: "the receiver answered 410 Gone".to_owned() }
            }
            Ok(status) => self.again(due, Some(status.as_u16()), format!("the receiver answered {}", status.as_u16())),
            Err(error) => self.again(due, None, error),
        })
    }

    /// Another attempt later, unless there were enough.
    fn again(&self, due: &DueDelivery, status: Option<u16>, error: String) -> Attempted {
        if due.attempt >= MAX_ATTEMPTS {
            return Attempted::Failed { status, error };
        }
        let factor = 3u32.saturating_pow(due.attempt.saturating_sub(1));
        Attempted::Retry { after: self.settings.first_pause.saturating_mul(factor).min(MAX_PAUSE), status, error }
    }

    /// Sends it, signed after Standard Webhooks. An error is said in words that name no address.
    async fn send(&self, due: &DueDelivery) -> Result<StatusCode, String> {
        // An address that is written out is not resolved, so it is judged here.
        let url = check_url(&due.url, self.settings.allow_private).map_err(str::to_owned)?;
        let now = jiff::Timestamp::now().as_second();
        let signer = standardwebhooks::Webhook::new(&due.secret).map_err(|_| "the secret is not right".to_owned())?;
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
        match request.send().await {
            Ok(response) => Ok(response.status()),
            Err(error) if error.is_timeout() => Err("the receiver did not answer in time".to_owned()),
            Err(error) if error.is_connect() => Err("the receiver could not be reached".to_owned()),
            Err(_) => Err("the delivery could not be sent".to_owned()),
        }
    }
}
