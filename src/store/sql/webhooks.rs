//! Records of webhooks and of their deliveries.

use super::argument::{Argument, bind};
use super::database::{Row, Session};
use super::dialect::sql;
use super::{SqlStore, changes, rows};
use crate::jobs::job::Cursor;
use crate::jobs::{
    Attempted, Delivery, DeliveryPage, DeliveryState, DueDelivery, JobError, JobState, Tenant, Turn, TurnLimits,
    Webhook, WebhookPage, WebhookStore,
};
use crate::store::seal::{Seal, opened};
use async_trait::async_trait;
use serde_json::json;
use std::collections::HashMap;
use std::time::Duration;

/// Changes for which deliveries are inserted in one transaction.
const CHANGES_AT_ONCE: u32 = 500;

fn webhook(row: &Row) -> Result<Webhook, JobError> {
    Ok(Webhook {
        id: row.get("id")?,
        tenant: rows::tenant(&row.get::<String>("tenant")?)?,
        url: row.get("url")?,
        states: rows::json("a webhook's states", &row.get::<String>("states")?)?,
        secret: row.get("secret")?,
        is_enabled: row.get("is_enabled")?,
        disabled_because: row.get("disabled_because")?,
        created_at: rows::time(row.get("created_at")?)?,
    })
}

fn delivery(row: &Row) -> Result<Delivery, JobError> {
    let state = DeliveryState::from_name(&row.get::<String>("state")?);
    let status: Option<i64> = row.get("status")?;
    Ok(Delivery {
        id: row.get("id")?,
        event: row.get("event")?,
        state: state.ok_or(JobError::Corrupt { what: "a delivery's state", source: None })?,
        attempts: row.count("attempts")?,
        next_at: rows::time(row.get("next_at")?)?,
        status: status.and_then(|status| u16::try_from(status).ok()),
        error: row.get("error")?,
        created_at: rows::time(row.get("created_at")?)?,
        ended_at: rows::maybe_time(row, "ended_at")?,
    })
}

async fn get_webhook(session: &mut Session, tenant: &Tenant, id: &str) -> Result<Webhook, JobError> {
    webhook(&session.row(sql!("get_webhook"), bind![id, tenant]).await?.ok_or(JobError::WebhookNotFound)?)
}

/// Inserts a delivery and returns its id.
async fn insert_delivery(
    session: &mut Session,
    webhook_id: &str,
    tenant: &str,
    event: &str,
    payload: &str,
    traceparent: Option<&str>,
) -> Result<String, JobError> {
    let id = uuid::Uuid::now_v7().to_string();
    session.execute(sql!("insert_delivery"), bind![&id, webhook_id, tenant, event, payload, traceparent]).await?;
    Ok(id)
}

/// The webhook whose turn it is.
async fn next_webhook(session: &mut Session, limits: &TurnLimits) -> Result<Option<String>, JobError> {
    session.value(sql!("next_webhook"), bind![limits.of_tenant]).await
}

/// Begins the turn of the next webhook; `None` if no turn is due or another process has begun it in the meantime.
async fn claim_turn(session: &mut Session, limits: &TurnLimits, seal: Option<&Seal>) -> Result<Option<Turn>, JobError> {
    let Some(webhook_id) = next_webhook(session, limits).await? else { return Ok(None) };
    let Some(webhook) = session.row(sql!("lock_webhook"), bind![&webhook_id]).await? else { return Ok(None) };
    session.execute(sql!("begin_turn"), bind![&webhook_id, limits.busy_for]).await?;
    let failures = webhook.count("failures")?;
    // If the secret cannot be opened, the deliveries fail, and their log says why.
    let secret = opened(seal, &webhook_id, &webhook.get::<String>("secret")?).unwrap_or_default();
    // A receiver that has failed is tried with one delivery, so that the other deliveries do not use up their attempts.
    let at_most = if failures == 0 { limits.deliveries } else { 1 };
    let mut deliveries = Vec::new();
    for row in session.rows(sql!("due_deliveries"), bind![&webhook_id, at_most]).await? {
        let id: String = row.get("id")?;
        session.execute(sql!("claim_delivery"), bind![&id, limits.busy_for]).await?;
        deliveries.push(DueDelivery {
            id,
            webhook_id: webhook_id.clone(),
            url: webhook.get("url")?,
            secret: secret.clone(),
            payload: row.get("payload")?,
            attempt: row.count("attempts")? + 1,
            is_wanted: webhook.get("is_enabled")?,
            traceparent: row.get("traceparent")?,
        });
    }
    Ok(Some(Turn { webhook_id, failures, deliveries }))
}

impl SqlStore {
    /// The form in which the secret of a webhook is stored.
    fn sealed(&self, webhook_id: &str, secret: &str) -> Result<String, JobError> {
        let Some(seal) = &self.settings.seal else { return Ok(secret.to_owned()) };
        seal.seal(webhook_id, secret).ok_or(JobError::Corrupt { what: "a secret that cannot be sealed", source: None })
    }

    /// Seals the secrets that are stored unsealed or sealed with another key than the current one. Returns their
    /// number.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn seal_secrets(&self) -> Result<u32, JobError> {
        let Some(seal) = &self.settings.seal else { return Ok(0) };
        let mut n_sealed = 0;
        for row in self.database.reader().await?.rows(sql!("webhook_secrets"), bind![]).await? {
            let (id, secret): (String, String) = (row.get("id")?, row.get("secret")?);
            if seal.is_current(&secret) {
                continue;
            }
            // A secret that no key opens stays as it is: a key may be missing by mistake.
            let Some(clear) = opened(Some(seal), &id, &secret) else { continue };
            let arguments = bind![&id, self.sealed(&id, &clear)?, &secret];
            self.database.transaction(async |session| session.execute(sql!("seal_secret"), arguments).await).await?;
            n_sealed += 1;
        }
        if n_sealed > 0 {
            self.note_deletion();
        }
        Ok(n_sealed)
    }
}

#[async_trait]
impl WebhookStore for SqlStore {
    async fn insert_webhook(&self, new: &Webhook, at_most: u32) -> Result<Option<Webhook>, JobError> {
        let states = rows::to_json("states", &new.states)?;
        self.database
            .transaction(async |session| {
                let row = session.row(sql!("count_webhooks"), bind![&new.tenant]).await?;
                if row.map_or(Ok(0), |row| row.count(0))? >= at_most {
                    return Ok(None);
                }
                let arguments = bind![&new.id, &new.tenant, &new.url, states, self.sealed(&new.id, &new.secret)?];
                session.execute(sql!("insert_webhook"), arguments).await?;
                let made = get_webhook(session, &new.tenant, &new.id).await?;
                Ok(Some(Webhook { secret: new.secret.clone(), ..made }))
            })
            .await
    }

    async fn get_webhook(&self, tenant: &Tenant, id: &str) -> Result<Webhook, JobError> {
        get_webhook(&mut self.database.reader().await?, tenant, id).await
    }

    async fn list_webhooks(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<WebhookPage, JobError> {
        let mut session = self.database.reader().await?;
        let (time, id) = (after.map(|c| c.created_at_ms), after.map(|c| c.id));
        let found = session.rows(sql!("list_webhooks"), bind![tenant, time, id, i64::from(size) + 1]).await?;
        let webhooks: Vec<Webhook> = found.iter().take(size as usize).map(webhook).collect::<Result<_, _>>()?;
        let more = found.len() > size as usize;
        let next = webhooks.last().filter(|_| more).and_then(|last| rows::cursor(last.created_at, &last.id));
        Ok(WebhookPage { webhooks, next })
    }

    async fn update_webhook(
        &self,
        tenant: &Tenant,
        id: &str,
        url: &str,
        states: &[JobState],
        is_enabled: bool,
    ) -> Result<Webhook, JobError> {
        let states = rows::to_json("states", &states)?;
        self.database
            .transaction(async |session| {
                session.execute(sql!("update_webhook"), bind![id, tenant, url, states, is_enabled]).await?;
                get_webhook(session, tenant, id).await
            })
            .await
    }

    async fn delete_webhook(&self, tenant: &Tenant, id: &str) -> Result<(), JobError> {
        let arguments = bind![id, tenant];
        let deleted =
            self.database.transaction(async |session| session.execute(sql!("delete_webhook"), arguments).await);
        match deleted.await? {
            0 => Err(JobError::WebhookNotFound),
            _ => Ok(()),
        }
    }

    async fn list_deliveries(
        &self,
        tenant: &Tenant,
        id: &str,
        size: u32,
        after: Option<Cursor>,
    ) -> Result<DeliveryPage, JobError> {
        let mut session = self.database.reader().await?;
        get_webhook(&mut session, tenant, id).await?;
        let (time, after) = (after.map(|c| c.created_at_ms), after.map(|c| c.id));
        let found = session.rows(sql!("list_deliveries"), bind![id, time, after, i64::from(size) + 1]).await?;
        let deliveries: Vec<Delivery> = found.iter().take(size as usize).map(delivery).collect::<Result<_, _>>()?;
        let more = found.len() > size as usize;
        let next = deliveries.last().filter(|_| more).and_then(|last| rows::cursor(last.created_at, &last.id));
        Ok(DeliveryPage { deliveries, next })
    }

    async fn insert_delivery(
        &self,
        tenant: &Tenant,
        id: &str,
        event: &str,
        payload: &str,
    ) -> Result<Delivery, JobError> {
        self.database
            .transaction(async |session| {
                get_webhook(session, tenant, id).await?;
                let made = insert_delivery(session, id, tenant.name(), event, payload, None).await?;
                let row = session.row(sql!("get_delivery"), bind![made]).await?;
                delivery(&row.ok_or(JobError::WebhookNotFound)?)
            })
            .await
    }

    async fn insert_due_deliveries(&self) -> Result<u32, JobError> {
        changes::number_changes(&self.database).await?;
        let mut inserted = 0;
        loop {
            let mut session = self.database.reader().await?;
            let position: Option<i64> = session.value(sql!("webhook_position"), bind![]).await?;
            let last: Option<i64> = session.value(sql!("last_change"), bind![]).await?;
            drop(session);
            if last <= position {
                return Ok(inserted);
            }
            inserted += self.database.transaction(insert_some_deliveries).await?;
        }
    }

    async fn claim_turn(&self, limits: &TurnLimits) -> Result<Option<Turn>, JobError> {
        // Checked without a lock first: usually nothing is due.
        if next_webhook(&mut self.database.reader().await?, limits).await?.is_none() {
            return Ok(None);
        }
        let seal = self.settings.seal.as_ref();
        self.database.transaction(async |session| claim_turn(session, limits, seal).await).await
    }

    async fn end_turn(&self, webhook_id: &str, failures: u32, pause: Duration) -> Result<(), JobError> {
        let arguments = bind![webhook_id, failures, pause];
        let ended = self.database.transaction(async |session| session.execute(sql!("end_turn"), arguments).await);
        ended.await.map(|_| ())
    }

    async fn end_attempt(&self, id: &str, attempted: &Attempted) -> Result<(), JobError> {
        let ended = |state: DeliveryState, status: Option<u16>, error: Option<&str>| {
            (sql!("end_delivery"), bind![id, state.name(), status.map(u32::from), error])
        };
        let (query, arguments): (_, Vec<Argument>) = match attempted {
            Attempted::Delivered { status } => ended(DeliveryState::Delivered, Some(*status), None),
            Attempted::Failed { status, error } => ended(DeliveryState::Failed, *status, Some(error)),
            Attempted::Retry { after, status, error } => {
                (sql!("retry_delivery"), bind![id, *after, status.map(u32::from), error])
            }
        };
        self.database.transaction(async |session| session.execute(query, arguments).await).await.map(|_| ())
    }

    async fn disable_webhook(&self, id: &str, because: &str) -> Result<(), JobError> {
        let arguments = bind![id, because];
        let disabled =
            self.database.transaction(async |session| session.execute(sql!("disable_webhook"), arguments).await);
        disabled.await.map(|_| ())
    }
}

/// Inserts the deliveries of at most [`CHANGES_AT_ONCE`] changes and advances the position past them, under a lock that
/// excludes other processes. Returns the number of deliveries.
async fn insert_some_deliveries(session: &mut Session) -> Result<u32, JobError> {
    let position: Option<i64> = session.value(sql!("lock_webhook_position"), bind![]).await?;
    let position = position.ok_or(JobError::Corrupt { what: "the position of webhooks", source: None })?;
    if session.value(sql!("has_webhooks"), bind![]).await? != Some(true) {
        let last: Option<i64> = session.value(sql!("last_change"), bind![]).await?;
        session.execute(sql!("set_webhook_position"), bind![last.unwrap_or(position).max(position)]).await?;
        return Ok(0);
    }
    let mut receivers: HashMap<String, Vec<(String, Vec<JobState>)>> = HashMap::new();
    let mut inserted = 0;
    let mut reached = position;
    for change in session.rows(sql!("undelivered_changes"), bind![position, CHANGES_AT_ONCE]).await? {
        let (seq, tenant): (i64, String) = (change.get("seq")?, change.get("tenant")?);
        reached = seq;
        if !receivers.contains_key(&tenant) {
            let mut of_tenant = Vec::new();
            for row in session.rows(sql!("enabled_webhooks"), bind![&tenant]).await? {
                of_tenant.push((row.get("id")?, rows::json("a webhook's states", &row.get::<String>("states")?)?));
            }
            receivers.insert(tenant.clone(), of_tenant);
        }
        let state = rows::state(&change.get::<String>("state")?)?;
        let (number, traceparent): (i64, Option<String>) = (change.get("number")?, change.get("traceparent")?);
        let event = format!("job.{}", state.name());
        for (webhook_id, states) in receivers.get(&tenant).into_iter().flatten() {
            if !states.is_empty() && !states.contains(&state) {
                continue;
            }
            // Minimal on purpose: data that may concern a patient are fetched with an API key and are never sent out.
            let payload = json!({
                "type": event,
                "timestamp": rows::time(change.get("at")?)?,
                "data": {
                    "job_id": change.get::<String>("job_id")?,
                    "batch_id": change.get::<Option<String>>("batch_id")?,
                    "state": state,
                    "seq": number,
                },
            });
            insert_delivery(session, webhook_id, &tenant, &event, &payload.to_string(), traceparent.as_deref()).await?;
            inserted += 1;
        }
    }
    session.execute(sql!("set_webhook_position"), bind![reached]).await?;
    Ok(inserted)
}
