//! Submission, cancel and delete.

use super::database::{Session, bind};
use super::dialect::sql;
use super::reading::find_job;
use super::{SqlStore, blobs, once, rows};
use crate::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, Batch, CancelEffect, Failure, Job, JobError, JobId, JobState,
    Made, NewBatch, NewJob, Tenant, cancel_effect,
};
use std::time::Duration;

/// Ends a job that is not finished. `false` if it was.
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

/// Makes a job refer to a blob.
pub(super) async fn refer(session: &mut Session, id: JobId, artifact: &ArtifactRef) -> Result<(), JobError> {
    let ArtifactRef { kind, key, n_bytes } = artifact;
    let arguments = bind![id, kind.name(), &key.tenant, key.path(), key.hash(), *n_bytes];
    session.execute(sql!("insert_artifact"), arguments).await.map(|_| ())
}

/// Adds a job as queued, or as succeeded where an equal job's result may be its own.
async fn add_job(session: &mut Session, job: &NewJob, keep_result: Option<Duration>) -> Result<(), JobError> {
    let arguments = bind![
        job.id,
        &job.tenant,
        &job.method,
        &job.method_version,
        job.parameters.to_string(),
        rows::to_json("a source", &job.source)?,
        rows::to_json("a target", &job.target)?,
        job.priority,
        rows::to_json("labels", &job.labels)?,
        &job.external_ref,
        job.max_attempts,
        job.deadline_at,
        job.max_run_ms,
        job.retry_of,
        job.batch_id,
        &job.cache_key,
        &job.traceparent,
    ];
    session.execute(sql!("insert_job"), arguments).await?;
    for (name, value) in &job.labels {
        session.execute(sql!("insert_label"), bind![job.id, name, value]).await?;
    }
    for (kind, input) in [(ArtifactKind::Source, &job.source), (ArtifactKind::Target, &job.target)] {
        let key = ArtifactKey::of_hash(&job.tenant, &input.hash);
        let key = key.ok_or(JobError::Corrupt { what: "an input's hash", source: None })?;
        refer(session, job.id, &ArtifactRef { kind, key, n_bytes: input.n_bytes }).await?;
    }
    if let (true, Some(cache_key)) = (job.use_cache, &job.cache_key) {
        answer_from_cache(session, job, cache_key, keep_result).await?;
    }
    Ok(())
}

/// Gives a new job the result of an equal one, if there is one.
async fn answer_from_cache(
    session: &mut Session,
    job: &NewJob,
    cache_key: &str,
    keep: Option<Duration>,
) -> Result<(), JobError> {
    let found: Option<String> = session.value(sql!("find_cached"), bind![&job.tenant, cache_key]).await?;
    let Some(first) = found else { return Ok(()) };
    // Locked, so that a purge of it either came before or waits until its blobs have another who refers to them.
    if session.row(sql!("lock_cached"), bind![&first]).await?.is_none() {
        return Ok(());
    }
    for query in [sql!("copy_artifacts"), sql!("copy_trace"), sql!("copy_progress")] {
        session.execute(query, bind![job.id, &first]).await?;
    }
    session.execute(sql!("answer_from_cache"), bind![job.id, keep]).await.map(|_| ())
}

impl SqlStore {
    pub(super) async fn insert_one(&self, job: &NewJob, admission: &Admission) -> Result<Job, JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            refuse_when_full(&mut session, &job.tenant, 1, admission).await?;
            add_job(&mut session, job, admission.keep_result).await?;
            admitted(&mut session, admission, Made::Job(job.id)).await?;
            find_job(&mut session, &job.tenant, job.id).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn insert_many(
        &self,
        batch: &NewBatch,
        jobs: &[NewJob],
        admission: &Admission,
    ) -> Result<Batch, JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            let n_jobs = u32::try_from(jobs.len()).unwrap_or(u32::MAX);
            refuse_when_full(&mut session, &batch.tenant, n_jobs, admission).await?;
            let labels = rows::to_json("labels", &batch.labels)?;
            let arguments = bind![batch.id, &batch.tenant, n_jobs, labels, &batch.external_ref];
            session.execute(sql!("insert_batch"), arguments).await?;
            for job in jobs {
                add_job(&mut session, job, admission.keep_result).await?;
            }
            admitted(&mut session, admission, Made::Batch(batch.id)).await?;
            super::batches::find_batch(&mut session, &batch.tenant, batch.id).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn cancel_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            let state = lock_job(&mut session, tenant, id).await?;
            match cancel_effect(state) {
                CancelEffect::AlreadyCancelled => {}
                CancelEffect::AlreadyFinal => return Err(JobError::AlreadyFinal { state }),
                CancelEffect::TellWorker => {
                    session.execute(sql!("request_cancel"), bind![id]).await?;
                }
                CancelEffect::CancelNow => {
                    session.execute(sql!("request_cancel"), bind![id]).await?;
                    end_job(&mut session, id, JobState::Cancelled, None, None).await?;
                }
            }
            find_job(&mut session, tenant, id).await
        };
        let done = done.await;
        session.end(done).await
    }

    pub(super) async fn delete_job(&self, tenant: &Tenant, id: JobId) -> Result<(), JobError> {
        let mut session = self.database.begin().await?;
        let done = async {
            let state = lock_job(&mut session, tenant, id).await?;
            if !state.is_final() {
                return Err(JobError::StillActive { state });
            }
            remove_job(&mut session, id).await
        };
        let done = done.await;
        session.end(done).await
    }
}

/// Removes a job's row and all that hangs on it; its blobs become candidates for removal.
pub(super) async fn remove_job(session: &mut Session, id: JobId) -> Result<(), JobError> {
    blobs::note_candidates_of_job(session, id).await?;
    for query in [sql!("delete_once_of_job"), sql!("delete_changes_of_job"), sql!("delete_job")] {
        session.execute(query, bind![id]).await?;
    }
    Ok(())
}

/// The state of a job, which nobody changes until the transaction ends.
async fn lock_job(session: &mut Session, tenant: &Tenant, id: JobId) -> Result<JobState, JobError> {
    let state: Option<String> = session.value(sql!("lock_job"), bind![id, tenant]).await?;
    rows::state(&state.ok_or(JobError::NotFound)?)
}

/// Submissions at the same moment may together pass the limit by their own number, no more: in PostgreSQL they do not
/// see one another, and making them wait for one another would cost far more than the limit is worth.
async fn refuse_when_full(
    session: &mut Session,
    tenant: &Tenant,
    n_new: u32,
    admission: &Admission,
) -> Result<(), JobError> {
    let limit = admission.max_queued;
    let row = session.row(sql!("queue_length_of_tenant"), bind![tenant, limit]).await?;
    let waiting = row.map_or(Ok(0), |row| row.count(0))?;
    if waiting.saturating_add(n_new) > limit { Err(JobError::QueueFull { limit }) } else { Ok(()) }
}

/// What is done when the jobs are in: the hold of their inputs ends, and the idempotency key remembers them.
async fn admitted(session: &mut Session, admission: &Admission, made: Made) -> Result<(), JobError> {
    blobs::end_hold(session, &admission.holder).await?;
    match &admission.once {
        Some(once) => once::remember(session, once, made).await,
        None => Ok(()),
    }
}
