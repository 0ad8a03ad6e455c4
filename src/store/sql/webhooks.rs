//! Records of webhooks and of deliveries.

use super::database::{Row, Session, bind};
use super::dialect::sql;
use super::{SqlStore, rows};
use crate::jobs::job::Cursor;
use crate::jobs::{
    Attempted, Delivery, DeliveryPage, DeliveryState, DueDelivery, JobError, JobState, Tenant, Webhook, WebhookPage,
    WebhookStore,
};
use async_trait::async_trait;
use serde_json::json;
use std::collections::HashMap;
use std::time::Duration;

/// Changes turned into deliveries in one transaction.
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

async fn find_webhook(session: &mut Session, tenant: &Tenant, id: &str) -> Result<Webhook, JobError> {
    webhook(&session.row(sql!("get_webhook"), bind![id, tenant]).await?.ok_or(JobError::WebhookNotFound)?)
}

async fn add_delivery(
    session: &mut Session,
    webhook_id: &str,
    tenant: &str,
    event: &str,
    payload: &str,
) -> Result<String, JobError> {
    let id = uuid::Uuid::now_v7().to_string();
    session.execute(sql!("insert_delivery"), bind![&id, webhook_id, tenant, event, payload]).await?;
    Ok(id)
}

#[async_trait]
impl WebhookStore for SqlStore {
    async fn insert_webhook(&self, new: &Webhook, at_most: u32) -> Result<Option<Webhook>, JobError> {
        let states = rows::to_json("states", &new.states)?;
        let mut session = self.database.begin().await?;
        let done = async {
            let row = session.row(sql!("count_webhooks"), bind![&new.tenant]).await?;
            if row.map_or(Ok(0), |row| row.count(0))? >= at_most {
                return Ok(None);
            }
            let arguments = bind![&new.id, &new.tenant, &new.url, states, &new.secret];
            session.execute(sql!("insert_webhook"), arguments).await?;
            find_webhook(&mut session, &new.tenant, &new.id).await.map(Some)
        };
        let done = done.await;
        session.end(done).await
    }

    async fn get_webhook(&self, tenant: &Tenant, id: &str) -> Result<Webhook, JobError> {
        find_webhook(&mut self.database.reading().await?, tenant, id).await
    }

    async fn list_webhooks(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<WebhookPage, JobError> {
        let mut session = self.database.reading().await?;
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
        let mut session = self.database.begin().await?;
        let done = async {
            session.execute(sql!("update_webhook"), bind![id, tenant, url, states, is_enabled]).await?;
            find_webhook(&mut session, tenant, id).await
        };
        let done = done.await;
        session.end(done).await
    }

    async fn delete_webhook(&self, tenant: &Tenant, id: &str) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = session.execute(sql!("delete_webhook"), bind![id, tenant]).await;
        match session.end(done).await? {
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
        let mut session = self.database.reading().await?;
        find_webhook(&mut session, tenant, id).await?;
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
        let mut session = self.database.begin().await?;
        let done = async {
            find_webhook(&mut session, tenant, id).await?;
            let made = add_delivery(&mut session, id, tenant.name(), event, payload).await?;
            let row = session.row(sql!("get_delivery"), bind![made]).await?;
            delivery(&row.ok_or(JobError::WebhookNotFound)?)
        };
        let done = done.await;
        session.end(done).await
    }

    async fn tell_changes(&self) -> Result<u32, JobError> {
        self.number_changes().await?;
        let mut told = 0;
        loop {
            let mut reading = self.database.reading().await?;
            let position: Option<i64> = reading.value(sql!("webhook_position"), bind![]).await?;
            let last: Option<i64> = reading.value(sql!("last_change"), bind![]).await?;
            drop(reading);
            if last <= position {
                return Ok(told);
            }
            let mut session = self.database.begin().await?;
            let done = tell_some(&mut session).await;
            told += session.end(done).await?;
        }
    }

    async fn take_delivery(&self, busy_for: Duration) -> Result<Option<DueDelivery>, JobError> {
        if self.database.reading().await?.row(sql!("next_delivery"), bind![]).await?.is_none() {
            return Ok(None);
        }
        let mut session = self.database.begin().await?;
        let done = async {
            let Some(row) = session.row(sql!("next_delivery"), bind![]).await? else { return Ok(None) };
            let id: String = row.get("id")?;
            if session.row(sql!("lock_delivery"), bind![&id]).await?.is_none() {
                return Ok(None); // another took it at this moment
            }
            session.execute(sql!("take_delivery"), bind![&id, busy_for]).await?;
            Ok(Some(DueDelivery {
                id,
                webhook_id: row.get("webhook_id")?,
                url: row.get("url")?,
                secret: row.get("secret")?,
                payload: row.get("payload")?,
                attempt: row.count("attempts")? + 1,
                is_wanted: row.get("is_enabled")?,
            }))
        };
        let done = done.await;
        session.end(done).await
    }

    async fn end_attempt(&self, id: &str, attempted: &Attempted) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = match attempted {
            Attempted::Delivered { status } => {
                let arguments = bind![id, DeliveryState::Delivered.name(), Some(u32::from(*status)), None::<&str>];
                session.execute(sql!("end_delivery"), arguments).await
            }
            Attempted::Retry { after, status, error } => {
                let arguments = bind![id, *after, status.map(u32::from), error];
                session.execute(sql!("retry_delivery"), arguments).await
            }
            Attempted::Failed { status, error } => {
                let arguments = bind![id, DeliveryState::Failed.name(), status.map(u32::from), error];
                session.execute(sql!("end_delivery"), arguments).await
            }
        };
        session.end(done).await.map(|_| ())
    }

    async fn disable_webhook(&self, id: &str, because: &str) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = session.execute(sql!("disable_webhook"), bind![id, because]).await;
        session.end(done).await.map(|_| ())
    }
}

/// Makes deliveries of some changes, and moves the position past them; who else does so waits.
async fn tell_some(session: &mut Session) -> Result<u32, JobError> {
    let position: Option<i64> = session.value(sql!("lock_webhook_position"), bind![]).await?;
    let position = position.ok_or(JobError::Corrupt { what: "the position of webhooks", source: None })?;
    if session.value(sql!("any_webhooks"), bind![]).await? != Some(true) {
        let last: Option<i64> = session.value(sql!("last_change"), bind![]).await?;
        session.execute(sql!("set_webhook_position"), bind![last.unwrap_or(position).max(position)]).await?;
        return Ok(0);
    }
    let mut receivers: HashMap<String, Vec<(String, Vec<JobState>)>> = HashMap::new();
    let mut told = 0;
    let mut reached = position;
    for change in session.rows(sql!("changes_to_tell"), bind![position, CHANGES_AT_ONCE]).await? {
        let (seq, tenant): (i64, String) = (change.get("seq")?, change.get("tenant")?);
        reached = seq;
        if !receivers.contains_key(&tenant) {
            let mut of_tenant = Vec::new();
            for row in session.rows(sql!("webhooks_to_tell"), bind![&tenant]).await? {
                of_tenant.push((row.get("id")?, rows::json("a webhook's states", &row.get::<String>("states")?)?));
            }
            receivers.insert(tenant.clone(), of_tenant);
        }
        let state = rows::state(&change.get::<String>("state")?)?;
        let event = format!("job.{}", state.name());
        for (webhook_id, states) in receivers.get(&tenant).into_iter().flatten() {
            if !states.is_empty() && !states.contains(&state) {
                continue;
            }
            // Thin on purpose: what may say something about a patient is fetched with a key, not sent around.
            let payload = json!({
                "type": event,
                "timestamp": rows::time(change.get("at")?)?,
                "data": {
                    "job_id": change.get::<String>("job_id")?,
                    "batch_id": change.get::<Option<String>>("batch_id")?,
                    "state": state,
                    "seq": seq,
                },
            });
            add_delivery(session, webhook_id, &tenant, &event, &payload.to_string()).await?;
            told += 1;
        }
    }
    session.execute(sql!("set_webhook_position"), bind![reached]).await?;
    Ok(told)
}
