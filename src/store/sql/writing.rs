//! Writes on behalf of clients: submissions, their idempotency keys, cancellation and deletion.

use super::argument::bind;
use super::database::Session;
use super::dialect::sql;
use super::reading::{get_job, queue_length};
use super::{SqlStore, batches, blobs, once, rows};
use crate::jobs::metadata::ExternalRef;
use crate::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, Batch, CancelEffect, Failure, IdempotencyKey, Job, JobError,
    JobId, JobState, JobWriter, Made, NewBatch, NewJob, OnceStatus, Tenant, cancel_effect,
};
use async_trait::async_trait;
use std::time::Duration;

/// Moves a job to a final state. Returns `false`, and changes nothing, if the job is already in one.
pub(super) async fn end_job(
    session: &mut Session,
    id: JobId,
    state: JobState,
    failure: Option<&Failure>,
    keep: Option<Duration>,
) -> Result<bool, JobError> {
    let error = failure.map(|f| rows::to_json("a failure", f)).transpose()?;
    Ok(session.execute(sql!("end_job"), bind![id, state, error, keep]).await? == 1)
}

/// Adds a reference from a job to a blob.
pub(super) async fn insert_artifact(session: &mut Session, id: JobId, artifact: &ArtifactRef) -> Result<(), JobError> {
    let ArtifactRef { kind, key, n_bytes } = artifact;
    let arguments = bind![id, kind.name(), &key.tenant, key.path(), key.hash(), *n_bytes];
    session.execute(sql!("insert_artifact"), arguments).await.map(|_| ())
}

/// Inserts a job as queued, or as succeeded if it may share the result of an equal job and such a job exists.
pub(super) async fn insert_job(
    session: &mut Session,
    job: &NewJob,
    keep_result: Option<Duration>,
) -> Result<(), JobError> {
    let arguments = bind![
        job.id,
        &job.tenant,
        &job.method,
        &job.method_version,
        job.parameters.to_string(),
        rows::to_json("a source", &job.source)?,
        rows::to_json("a target", &job.target)?,
        job.priority,
        rows::to_json("tags", &job.tags)?,
        job.external_ref.as_ref().map(ExternalRef::as_str),
        job.max_attempts,
        job.deadline_at,
        job.max_run_ms,
        job.retry_of,
        job.batch_id,
        &job.cache_key,
        &job.traceparent,
        job.study_id,
        &job.study_task,
    ];
    session.execute(sql!("insert_job"), arguments).await?;
    for (name, value) in job.tags.iter() {
        session.execute(sql!("insert_label"), bind![job.id, name, value]).await?;
    }
    for (kind, input) in [(ArtifactKind::Source, &job.source), (ArtifactKind::Target, &job.target)] {
        let key = ArtifactKey::of_hash(&job.tenant, &input.hash);
        let key = key.ok_or(JobError::Corrupt { what: "an input's hash", source: None })?;
        insert_artifact(session, job.id, &ArtifactRef { kind, key, n_bytes: input.n_bytes }).await?;
    }
    if let (true, Some(cache_key)) = (job.use_cache, &job.cache_key) {
        answer_from_cache(session, job, cache_key, keep_result).await?;
    }
    Ok(())
}

/// Gives a new job the result of an equal job, if there is one.
async fn answer_from_cache(
    session: &mut Session,
    job: &NewJob,
    cache_key: &str,
    keep: Option<Duration>,
) -> Result<(), JobError> {
    let found: Option<String> = session.value(sql!("find_cached"), bind![&job.tenant, cache_key]).await?;
    let Some(first) = found else { return Ok(()) };
    // Locked: a purge of that job has either finished, or waits until the new job refers to the same blobs.
    if session.row(sql!("lock_cached"), bind![&first]).await?.is_none() {
        return Ok(());
    }
    for query in [sql!("copy_artifacts"), sql!("copy_trace"), sql!("copy_progress")] {
        session.execute(query, bind![job.id, &first]).await?;
    }
    session.execute(sql!("answer_from_cache"), bind![job.id, keep, &first]).await.map(|_| ())
}

#[async_trait]
impl JobWriter for SqlStore {
    async fn insert_job(&self, job: &NewJob, admission: &Admission) -> Result<Job, JobError> {
        self.database
            .transaction(async |session| {
                refuse_when_full(session, &job.tenant, 1, admission).await?;
                insert_job(session, job, admission.keep_result).await?;
                end_submission(session, admission, Made::Job(job.id)).await?;
                get_job(session, &job.tenant, job.id).await
            })
            .await
    }

    async fn insert_batch(&self, batch: &NewBatch, jobs: &[NewJob], admission: &Admission) -> Result<Batch, JobError> {
        let n_jobs = u32::try_from(jobs.len()).unwrap_or(u32::MAX);
        let tags = rows::to_json("tags", &batch.tags)?;
        self.database
            .transaction(async |session| {
                refuse_when_full(session, &batch.tenant, n_jobs, admission).await?;
                let arguments =
                    bind![batch.id, &batch.tenant, n_jobs, tags, batch.external_ref.as_ref().map(ExternalRef::as_str)];
                session.execute(sql!("insert_batch"), arguments).await?;
                for job in jobs {
                    insert_job(session, job, admission.keep_result).await?;
                }
                end_submission(session, admission, Made::Batch(batch.id)).await?;
                batches::get_batch(session, &batch.tenant, batch.id).await
            })
            .await
    }

    async fn begin_once(&self, once: &IdempotencyKey, busy_for: Duration) -> Result<OnceStatus, JobError> {
        self.database.transaction(async |session| once::begin_once(session, once, busy_for).await).await
    }

    async fn extend_once(&self, once: &IdempotencyKey, busy_for: Duration) -> Result<(), JobError> {
        let arguments = bind![&once.tenant, &once.name, &once.token, busy_for];
        let extended = self.database.transaction(async |session| session.execute(sql!("extend_once"), arguments).await);
        extended.await.map(|_| ())
    }

    async fn give_up_once(&self, once: &IdempotencyKey) -> Result<(), JobError> {
        let arguments = bind![&once.tenant, &once.name, &once.token];
        let given_up =
            self.database.transaction(async |session| session.execute(sql!("give_up_once"), arguments).await);
        given_up.await.map(|_| ())
    }

    async fn cancel_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        self.database
            .transaction(async |session| {
                let state = lock_job(session, tenant, id).await?;
                match cancel_effect(state) {
                    CancelEffect::AlreadyCancelled => {}
                    CancelEffect::AlreadyFinal => return Err(JobError::AlreadyFinal { state }),
                    CancelEffect::TellWorker => {
                        session.execute(sql!("request_cancel"), bind![id]).await?;
                    }
                    CancelEffect::CancelNow => {
                        session.execute(sql!("request_cancel"), bind![id]).await?;
                        end_job(session, id, JobState::Cancelled, None, None).await?;
                    }
                }
                get_job(session, tenant, id).await
            })
            .await
    }

    async fn set_priority(&self, tenant: &Tenant, id: JobId, priority: i32) -> Result<Job, JobError> {
        self.database
            .transaction(async |session| {
                let state = lock_job(session, tenant, id).await?;
                if state.is_final() {
                    return Err(JobError::AlreadyFinal { state });
                }
                session.execute(sql!("set_priority"), bind![id, i64::from(priority)]).await?;
                get_job(session, tenant, id).await
            })
            .await
    }

    async fn delete_job(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        self.database
            .transaction(async |session| {
                let state = lock_job(session, tenant, id).await?;
                if !state.is_final() {
                    return Err(JobError::StillActive { state });
                }
                delete_job(session, id).await
            })
            .await?;
        self.note_deletion();
        Ok(())
    }
}

/// Deletes a job's row and everything that depends on it; its blobs become candidates for removal.
pub(super) async fn delete_job(session: &mut Session, id: JobId) -> Result<(), JobError> {
    blobs::note_candidates_of_job(session, id).await?;
    for query in [sql!("delete_once_of_job"), sql!("delete_changes_of_job"), sql!("delete_job")] {
        session.execute(query, bind![id]).await?;
    }
    Ok(())
}

/// Locks a job and returns its state, which cannot change until the transaction ends.
async fn lock_job(session: &mut Session, tenant: &Tenant, id: JobId) -> Result<JobState, JobError> {
    let state: Option<String> = session.value(sql!("lock_job"), bind![id, tenant]).await?;
    rows::state(&state.ok_or(JobError::NotFound)?)
}

/// Concurrent submissions may together exceed the limit by their own number, but no more: on PostgreSQL they do not see
/// each other's jobs, and serializing them would cost far more than an exact limit is worth.
pub(super) async fn refuse_when_full(
    session: &mut Session,
    tenant: &Tenant,
    n_new: u32,
    admission: &Admission,
) -> Result<(), JobError> {
    let limit = admission.max_queued;
    let waiting = queue_length(session, tenant, limit).await?;
    if waiting.saturating_add(n_new) > limit { Err(JobError::QueueFull { limit }) } else { Ok(()) }
}

/// Ends a submission whose jobs are stored: releases the hold on their inputs, and records them under the idempotency key.
async fn end_submission(session: &mut Session, admission: &Admission, made: Made) -> Result<(), JobError> {
    blobs::drop_hold(session, &admission.holder).await?;
    match &admission.once {
        Some(once) => once::finish_once(session, once, made).await,
        None => Ok(()),
    }
}
