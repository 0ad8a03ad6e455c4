//! Submission, cancel and delete.

use super::reading::find_job;
use super::rows;
use super::{SqliteStore, blobs, domain_error, query_text};
use crate::jobs::{
    ArtifactKey, ArtifactKind, ArtifactRef, CancelEffect, Failure, Job, JobError, JobId, JobState, NewJob, Tenant,
    cancel_effect,
};
use sqlx::SqliteConnection;

/// Ends a job that is not finished. `false` if it was.
pub(super) async fn end_job(
    connection: &mut SqliteConnection,
    id: &str,
    state: JobState,
    failure: Option<&Failure>,
) -> Result<bool, JobError> {
    let error = failure.map(|f| rows::to_json("a failure", f)).transpose()?;
    let done = sqlx::query(query_text!("end_job"))
        .bind(id)
        .bind(state.name())
        .bind(error)
        .execute(connection)
        .await
        .map_err(domain_error)?;
    Ok(done.rows_affected() == 1)
}

/// Makes a job refer to a blob.
pub(super) async fn refer(
    connection: &mut SqliteConnection,
    id: JobId,
    artifact: &ArtifactRef,
) -> Result<(), JobError> {
    sqlx::query(query_text!("insert_artifact"))
        .bind(id.to_string())
        .bind(artifact.kind.name())
        .bind(artifact.key.tenant.name())
        .bind(&artifact.key.hash)
        .bind(i64::try_from(artifact.n_bytes).unwrap_or(i64::MAX))
        .execute(connection)
        .await
        .map(|_| ())
        .map_err(domain_error)
}

impl SqliteStore {
    pub(super) async fn insert_job(&self, job: &NewJob, max_queued: u32, holder: &str) -> Result<Job, JobError> {
        let mut writing = self.begin().await?;
        let waiting: u32 =
            sqlx::query_scalar(query_text!("queue_length")).fetch_one(&mut *writing).await.map_err(domain_error)?;
        if waiting >= max_queued {
            return Err(JobError::QueueFull { limit: max_queued });
        }
        sqlx::query(query_text!("insert_job"))
            .bind(job.id.to_string())
            .bind(job.tenant.name())
            .bind(&job.method)
            .bind(&job.method_version)
            .bind(job.parameters.to_string())
            .bind(rows::to_json("a source", &job.source)?)
            .bind(rows::to_json("a target", &job.target)?)
            .bind(job.priority)
            .bind(rows::to_json("labels", &job.labels)?)
            .bind(&job.external_ref)
            .bind(job.max_attempts)
            .execute(&mut *writing)
            .await
            .map_err(domain_error)?;
        for (kind, input) in [(ArtifactKind::Source, &job.source), (ArtifactKind::Target, &job.target)] {
            let key = ArtifactKey { tenant: job.tenant.clone(), hash: input.hash.clone() };
            refer(&mut writing, job.id, &ArtifactRef { kind, key, n_bytes: input.n_bytes }).await?;
        }
        blobs::end_hold(&mut writing, holder).await?;
        let stored = find_job(&mut writing, &job.tenant, job.id).await?;
        writing.commit().await.map_err(domain_error)?;
        Ok(stored)
    }

    pub(super) async fn cancel_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        let mut writing = self.begin().await?;
        let job = find_job(&mut writing, tenant, id).await?;
        match cancel_effect(job.state) {
            CancelEffect::AlreadyCancelled => return Ok(job),
            CancelEffect::AlreadyFinal => return Err(JobError::AlreadyFinal { state: job.state }),
            CancelEffect::TellWorker | CancelEffect::CancelNow => {}
        }
        sqlx::query(query_text!("request_cancel"))
            .bind(id.to_string())
            .execute(&mut *writing)
            .await
            .map_err(domain_error)?;
        if cancel_effect(job.state) == CancelEffect::CancelNow {
            end_job(&mut writing, &id.to_string(), JobState::Cancelled, None).await?;
        }
        let job = find_job(&mut writing, tenant, id).await?;
        writing.commit().await.map_err(domain_error)?;
        Ok(job)
    }

    pub(super) async fn delete_job(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        let mut writing = self.begin().await?;
        let job = find_job(&mut writing, tenant, id).await?;
        if !job.state.is_final() {
            return Err(JobError::StillActive { state: job.state });
        }
        for text in [query_text!("note_candidates_of_job"), query_text!("delete_job")] {
            sqlx::query(text).bind(id.to_string()).execute(&mut *writing).await.map_err(domain_error)?;
        }
        writing.commit().await.map_err(domain_error)
    }
}
