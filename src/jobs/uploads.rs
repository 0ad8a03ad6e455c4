//! Uploads: stored as they arrive, and checked afterwards, once for each set of parameters that affects the check.

use super::artifact::{ArtifactKey, BLOB_HOLD};
use super::engine::{Computation, InputBytes, InputView, Resolved};
use super::error::JobError;
use super::job::{Job, Tenant};
use super::mesh::{CheckOutcome, Mesh, MeshPage};
use super::ports::{ArtifactWriter, BlobStream};
use super::service::JobService;
use super::submission::{SubmitError, SubmittedFile};
use bytes::Bytes;
use serde_json::Value;
use std::ops::Range;
use std::sync::Arc;

/// An upload in progress.
pub struct Upload {
    tenant: Tenant,
    writer: Box<dyn ArtifactWriter>,
    hasher: blake3::Hasher,
    n_bytes: u64,
}

impl Upload {
    /// Number of bytes received.
    pub fn n_bytes(&self) -> u64 {
        self.n_bytes
    }

    /// Appends a part.
    ///
    /// # Errors
    /// Those of the store.
    pub async fn write(&mut self, part: Bytes) -> Result<(), JobError> {
        self.n_bytes += part.len() as u64;
        self.hasher.update(&part);
        self.writer.write(part).await
    }
}

/// The name of the input whose parameters are those of the target.
const TARGET: &str = "target";

impl JobService {
    /// Begins an upload; nothing is stored unless [`JobService::end_upload`] is called.
    ///
    /// # Errors
    /// [`JobError::ShareFull`], and those of the store.
    pub async fn begin_upload(&self, tenant: &Tenant) -> Result<Upload, JobError> {
        self.refuse_over_share(tenant, 1).await?;
        let writer = self.stores.artifacts.begin(tenant).await?;
        Ok(Upload { tenant: tenant.clone(), writer, hasher: blake3::Hasher::new(), n_bytes: 0 })
    }

    /// Stores an upload under the hash of its content and records it. Returns it, and whether it is new.
    ///
    /// # Errors
    /// [`JobError::ShareFull`], and those of the stores.
    pub async fn end_upload(&self, upload: Upload, name_hint: Option<&str>) -> Result<(Mesh, bool), JobError> {
        let Upload { tenant, writer, hasher, n_bytes } = upload;
        let hash = hasher.finalize().to_hex().to_string();
        // The same bytes again take nothing more.
        if matches!(self.stores.meshes.get_mesh(&tenant, &hash).await, Err(JobError::MeshNotFound)) {
            self.refuse_over_share(&tenant, n_bytes).await?;
        }
        let key = ArtifactKey::of_hash(&tenant, &hash)
            .ok_or(JobError::Corrupt { what: "the hash of an upload", source: None })?;
        let holder = format!("upload:{}", uuid::Uuid::new_v4());
        self.stores.jobs.hold_blobs(&holder, std::slice::from_ref(&key), BLOB_HOLD, None).await?;
        let recorded = async {
            writer.commit(&key).await?;
            self.stores.meshes.insert_mesh(&key, n_bytes, name_hint, &holder).await
        };
        match recorded.await {
            Ok(is_new) => {
                self.note_stored(&tenant, if is_new { n_bytes } else { 0 });
                Ok((self.stores.meshes.get_mesh(&tenant, &hash).await?, is_new))
            }
            Err(error) => {
                let _ = self.stores.jobs.drop_hold(&holder).await;
                Err(error)
            }
        }
    }

    /// An upload.
    ///
    /// # Errors
    /// [`JobError::MeshNotFound`].
    pub async fn mesh(&self, tenant: &Tenant, hash: &str) -> Result<Mesh, JobError> {
        self.stores.meshes.get_mesh(tenant, hash).await
    }

    /// A page of the list of uploads, newest first.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn meshes(&self, tenant: &Tenant, size: u32, after: Option<(i64, String)>) -> Result<MeshPage, JobError> {
        self.stores.meshes.list_meshes(tenant, size, after).await
    }

    /// The content of an upload, or a range of it, in pieces.
    ///
    /// # Errors
    /// [`JobError`].
    pub async fn open_mesh(&self, mesh: &Mesh, range: Option<Range<u64>>) -> Result<BlobStream, JobError> {
        self.stores.artifacts.open(&mesh.key, mesh.n_bytes, range).await
    }

    /// The content of an upload.
    ///
    /// # Errors
    /// [`JobError`].
    async fn mesh_content(&self, mesh: &Mesh) -> Result<Bytes, JobError> {
        self.stores.artifacts.get(&mesh.key).await
    }

    /// Deletes an upload.
    ///
    /// # Errors
    /// [`JobError::MeshInUse`] while jobs refer to it.
    pub async fn delete_mesh(&self, tenant: &Tenant, hash: &str) -> Result<(), JobError> {
        self.stores.meshes.delete_mesh(tenant, hash).await?;
        if let Err(error) = self.remove_unreferenced_blobs().await {
            tracing::warn!(%error, "the blob of a deleted mesh could not be removed yet");
        }
        Ok(())
    }

    /// The outcome of checking an upload with the default parameters.
    ///
    /// # Errors
    /// [`SubmitError::Busy`], and those of the stores.
    pub async fn mesh_report(&self, mesh: &Mesh) -> Result<CheckOutcome, SubmitError> {
        let resolved = self.engine.resolve(&Value::Object(serde_json::Map::new())).map_err(SubmitError::Parameters)?;
        self.check_mesh(mesh, "mesh", &resolved).await
    }

    /// The outcome of checking an upload: the stored one, or that of a new check.
    pub(super) async fn check_mesh(
        &self,
        mesh: &Mesh,
        input: &'static str,
        resolved: &Resolved,
    ) -> Result<CheckOutcome, SubmitError> {
        let (tenant, hash) = (&mesh.key.tenant, mesh.key.hash());
        let input_key = &resolved.input_keys[usize::from(input == TARGET)];
        if let Some(found) = self.stores.meshes.get_mesh_check(tenant, hash, input_key).await? {
            return Ok(found);
        }
        let file = SubmittedFile { bytes: self.mesh_content(mesh).await?, name_hint: mesh.name_hint.clone() };
        let found = self.inspect(input, file, resolved).await?;
        self.stores.meshes.save_mesh_check(tenant, hash, input_key, &found).await?;
        Ok(found)
    }

    /// The surface of an upload as binary PLY, mm: the one that a job with default parameters would match, or, of a mesh that
    /// would be refused, the one in the file.
    ///
    /// # Errors
    /// [`SubmitError::Input`] if there is no surface; [`SubmitError::Busy`], and those of the stores.
    pub async fn mesh_surface(&self, mesh: &Mesh) -> Result<Vec<u8>, SubmitError> {
        let resolved = self.engine.resolve(&Value::Object(serde_json::Map::new())).map_err(SubmitError::Parameters)?;
        let bytes = self.mesh_content(mesh).await?;
        self.view("mesh", (bytes, mesh.name_hint.clone()), resolved.computation, InputView::Surface).await
    }

    /// The label volume of an input of a job, as NIfTI compressed with gzip.
    ///
    /// # Errors
    /// [`JobError::Gone`] if the inputs were removed; [`SubmitError::Input`] if it has none; [`SubmitError::Busy`], and those of the
    /// stores.
    pub async fn job_volume(&self, job: &Job, side: &'static str) -> Result<Vec<u8>, SubmitError> {
        if job.purged_at.is_some() {
            return Err(JobError::Gone.into());
        }
        let input = if side == TARGET { &job.target } else { &job.source };
        let corrupt = JobError::Corrupt { what: "the hash of an input", source: None };
        let key = ArtifactKey::of_hash(&job.tenant, &input.hash).ok_or(corrupt)?;
        let computation = self.engine.restore(&job.parameters);
        // What this version does not accept any more cannot be shown either.
        let computation = computation.map_err(|_| SubmitError::CheckFailed { input: side })?;
        let bytes = self.stores.artifacts.get(&key).await?;
        self.view(side, (bytes, input.name_hint.clone()), computation, InputView::Volume).await
    }

    /// A view of a file, made on a blocking thread.
    async fn view(
        &self,
        input: &'static str,
        (bytes, name_hint): (Bytes, Option<String>),
        computation: Arc<dyn Computation>,
        view: InputView,
    ) -> Result<Vec<u8>, SubmitError> {
        let permit = tokio::time::timeout(self.limits.max_check_wait, Arc::clone(&self.checks).acquire_owned());
        let Ok(Ok(permit)) = permit.await else { return Err(SubmitError::Busy) };
        let made = tokio::task::spawn_blocking(move || {
            let _permit = permit; // released when the view is made, even if its request has ended
            let is_target = input == TARGET;
            computation.show_input(&InputBytes { bytes: &bytes, name_hint: name_hint.as_deref(), is_target }, view)
        });
        match made.await {
            Ok(Ok(shown)) => Ok(shown),
            Ok(Err(refusal)) => Err(SubmitError::Input { input, refusal }),
            Err(_) => Err(SubmitError::CheckFailed { input }),
        }
    }

    /// Checks a file on a blocking thread.
    pub(super) async fn inspect(
        &self,
        input: &'static str,
        file: SubmittedFile,
        resolved: &Resolved,
    ) -> Result<CheckOutcome, SubmitError> {
        let permit = tokio::time::timeout(self.limits.max_check_wait, Arc::clone(&self.checks).acquire_owned());
        let Ok(Ok(permit)) = permit.await else { return Err(SubmitError::Busy) };
        let computation = Arc::clone(&resolved.computation);
        let checked = tokio::task::spawn_blocking(move || {
            let _permit = permit; // released when the check ends, even if its request has ended
            let bytes =
                InputBytes { bytes: &file.bytes, name_hint: file.name_hint.as_deref(), is_target: input == TARGET };
            computation.check_input(&bytes)
        });
        match checked.await {
            Ok(Ok(summary)) => Ok(CheckOutcome::Fit(summary)),
            Ok(Err(refusal)) => Ok(CheckOutcome::Unfit(refusal)),
            Err(_) => Err(SubmitError::CheckFailed { input }),
        }
    }
}
