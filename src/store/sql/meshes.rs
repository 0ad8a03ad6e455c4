//! Records of uploads, and the outcomes of their checks.

use super::argument::bind;
use super::database::Row;
use super::dialect::sql;
use super::{SqlStore, blobs, rows};
use crate::jobs::{ArtifactKey, CheckOutcome, JobError, Mesh, MeshPage, MeshStore, Tenant};
use async_trait::async_trait;

fn mesh(tenant: &Tenant, row: &Row) -> Result<Mesh, JobError> {
    let key = ArtifactKey::from_path(tenant, &row.get::<String>("path")?);
    Ok(Mesh {
        key: key.ok_or(JobError::Corrupt { what: "a blob's address", source: None })?,
        n_bytes: row.get::<i64>("n_bytes")?.unsigned_abs(),
        name_hint: row.get("name_hint")?,
        created_at: rows::time(row.get("created_at")?)?,
    })
}

#[async_trait]
impl MeshStore for SqlStore {
    async fn insert_mesh(
        &self,
        key: &ArtifactKey,
        n_bytes: u64,
        name_hint: Option<&str>,
        holder: &str,
    ) -> Result<bool, JobError> {
        let arguments = bind![&key.tenant, key.hash(), key.path(), n_bytes, name_hint];
        self.database
            .transaction(async |session| {
                let is_new = session.execute(sql!("insert_mesh"), arguments).await? == 1;
                blobs::drop_hold(session, holder).await?;
                Ok(is_new)
            })
            .await
    }

    async fn get_mesh(&self, tenant: &Tenant, hash: &str) -> Result<Mesh, JobError> {
        let row = self.database.reader().await?.row(sql!("get_mesh"), bind![tenant, hash]).await?;
        mesh(tenant, &row.ok_or(JobError::MeshNotFound)?)
    }

    async fn list_meshes(
        &self,
        tenant: &Tenant,
        size: u32,
        after: Option<(i64, String)>,
    ) -> Result<MeshPage, JobError> {
        let (time, hash) = after.unzip();
        let mut session = self.database.reader().await?;
        let found = session.rows(sql!("list_meshes"), bind![tenant, time, hash, i64::from(size) + 1]).await?;
        let meshes: Vec<Mesh> =
            found.iter().take(size as usize).map(|row| mesh(tenant, row)).collect::<Result<_, _>>()?;
        let more = found.len() > size as usize;
        let next = meshes.last().filter(|_| more);
        let next = next.map(|mesh| (mesh.created_at.as_millisecond(), mesh.key.hash().to_owned()));
        Ok(MeshPage { meshes, next })
    }

    async fn delete_mesh(&self, tenant: &Tenant, hash: &str) -> Result<(), JobError> {
        let key = ArtifactKey::of_hash(tenant, hash).ok_or(JobError::MeshNotFound)?;
        self.database
            .transaction(async |session| {
                if session.row(sql!("lock_mesh"), bind![tenant, hash]).await?.is_none() {
                    return Err(JobError::MeshNotFound);
                }
                if session.value(sql!("mesh_is_used"), bind![tenant, key.path()]).await? == Some(true) {
                    return Err(JobError::MeshInUse);
                }
                session.execute(sql!("delete_mesh"), bind![tenant, hash]).await?;
                session.execute(sql!("note_candidate"), bind![tenant, key.path()]).await.map(|_| ())
            })
            .await?;
        self.note_deletion();
        Ok(())
    }

    async fn get_mesh_check(
        &self,
        tenant: &Tenant,
        hash: &str,
        input_key: &str,
    ) -> Result<Option<CheckOutcome>, JobError> {
        let mut session = self.database.reader().await?;
        let found: Option<String> = session.value(sql!("get_mesh_check"), bind![tenant, hash, input_key]).await?;
        found.map(|text| rows::json("a check", &text)).transpose()
    }

    async fn save_mesh_check(
        &self,
        tenant: &Tenant,
        hash: &str,
        input_key: &str,
        outcome: &CheckOutcome,
    ) -> Result<(), JobError> {
        let text = rows::to_json("a check", outcome)?;
        self.database
            .transaction(async |session| {
                // If the upload has been deleted in the meantime, its check is not stored.
                if session.row(sql!("lock_mesh"), bind![tenant, hash]).await?.is_some() {
                    session.execute(sql!("save_mesh_check"), bind![tenant, hash, input_key, text]).await?;
                }
                Ok(())
            })
            .await
    }
}
