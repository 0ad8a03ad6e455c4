//! Records of API keys.

use super::argument::bind;
use super::database::Row;
use super::dialect::sql;
use super::leasing::lock_turns;
use super::{SqlStore, rows};
use crate::jobs::{ApiKey, JobError, KeyPage, KeyStore, Scope, SecretKey, Tenant, Ticket};
use async_trait::async_trait;
use std::time::Duration;

fn api_key(row: &Row) -> Result<ApiKey, JobError> {
    Ok(ApiKey {
        id: row.get("id")?,
        tenant: rows::tenant(&row.get::<String>("tenant")?)?,
        name: row.get("name")?,
        hash: row.get("hash")?,
        scopes: rows::json("a key's scopes", &row.get::<String>("scopes")?)?,
        created_at: rows::time(row.get("created_at")?)?,
        expires_at: rows::maybe_time(row, "expires_at")?,
        revoked_at: rows::maybe_time(row, "revoked_at")?,
        is_valid: row.get("is_valid")?,
    })
}

#[async_trait]
impl KeyStore for SqlStore {
    async fn insert_key(
        &self,
        key: &SecretKey,
        tenant: &Tenant,
        name: &str,
        scopes: &[Scope],
        valid_for: Option<Duration>,
    ) -> Result<(), JobError> {
        let scopes = rows::to_json("scopes", &scopes)?;
        let arguments = bind![key.id(), tenant, name, key.hash(), scopes, valid_for];
        let inserted = self.database.transaction(async |session| session.execute(sql!("insert_key"), arguments).await);
        inserted.await.map(|_| ())
    }

    async fn get_key(&self, id: &str) -> Result<Option<ApiKey>, JobError> {
        self.database.reader().await?.row(sql!("get_key"), bind![id]).await?.as_ref().map(api_key).transpose()
    }

    async fn list_keys(&self) -> Result<Vec<ApiKey>, JobError> {
        self.database.reader().await?.rows(sql!("list_keys"), bind![]).await?.iter().map(api_key).collect()
    }

    async fn list_tenant_keys(
        &self,
        tenant: &Tenant,
        size: u32,
        after: Option<(i64, String)>,
    ) -> Result<KeyPage, JobError> {
        let (time, id) = after.unzip();
        let arguments = bind![tenant, time, id, i64::from(size) + 1];
        let rows = self.database.reader().await?.rows(sql!("list_tenant_keys"), arguments).await?;
        let mut keys: Vec<ApiKey> = rows.iter().map(api_key).collect::<Result<_, _>>()?;
        let more = keys.len() > size as usize;
        keys.truncate(size as usize);
        let next = keys.last().filter(|_| more).map(|key| (key.created_at.as_millisecond(), key.id.clone()));
        Ok(KeyPage { keys, next })
    }

    async fn count_valid_keys(&self, tenant: &Tenant) -> Result<u32, JobError> {
        let row = self.database.reader().await?.row(sql!("count_valid_keys"), bind![tenant]).await?;
        row.map_or(Ok(0), |row| row.count(0))
    }

    async fn insert_ticket(
        &self,
        hash: &str,
        ticket: &Ticket,
        lasts: Duration,
        at_most: u32,
    ) -> Result<bool, JobError> {
        let Ticket { tenant, key_id, path } = ticket;
        let arguments = bind![hash, tenant, key_id, path, lasts, at_most];
        self.database
            .transaction(async |session| {
                // Concurrent requests would otherwise each count only the tickets that existed before them.
                lock_turns(session, tenant.name()).await?;
                session.execute(sql!("remove_old_tickets"), bind![]).await?;
                Ok(session.execute(sql!("insert_ticket"), arguments).await? == 1)
            })
            .await
    }

    async fn get_ticket(&self, hash: &str) -> Result<Option<Ticket>, JobError> {
        let row = self.database.reader().await?.row(sql!("get_ticket"), bind![hash]).await?;
        let ticket = |row: &Row| {
            let tenant = rows::tenant(&row.get::<String>("tenant")?)?;
            Ok(Ticket { tenant, key_id: row.get("key_id")?, path: row.get("path")? })
        };
        row.as_ref().map(ticket).transpose()
    }

    async fn revoke_key(&self, id: &str) -> Result<bool, JobError> {
        let revoked = self.database.transaction(async |session| session.execute(sql!("revoke_key"), bind![id]).await);
        Ok(revoked.await? == 1)
    }
}
