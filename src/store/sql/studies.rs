//! Studies: their state, and the blobs to which they refer.

use super::argument::bind;
use super::database::{Row, Session};
use super::dialect::sql;
use super::writing::{delete_job, end_job, insert_job, refuse_when_full};
use super::{SqlStore, blobs, once, rows};
use crate::jobs::job::Cursor;
use crate::jobs::metadata::ExternalRef;
use crate::jobs::study::{NewStudy, StudyProgress};
use crate::jobs::{
    Admission, ArtifactKey, Failure, JobError, JobId, JobState, Made, Study, StudyBlob, StudyChange, StudyId,
    StudyPage, StudyState, StudyStore, Tenant,
};
use async_trait::async_trait;
use std::time::Duration;

fn state(name: &str) -> Result<StudyState, JobError> {
    StudyState::from_name(name).ok_or(JobError::Corrupt { what: "a study's state", source: None })
}

fn study(row: &Row) -> Result<Study, JobError> {
    let error: Option<String> = row.get("error")?;
    let step: Option<String> = row.get("step_id")?;
    Ok(Study {
        id: rows::study_id(&row.get::<String>("id")?)?,
        tenant: rows::tenant(&row.get::<String>("tenant")?)?,
        state: state(&row.get::<String>("state")?)?,
        revision: row.get::<i64>("revision")?.unsigned_abs(),
        method: row.get("method")?,
        method_version: row.get("method_version")?,
        n_subjects: row.count("n_subjects")?,
        priority: i32::try_from(row.get::<i64>("priority")?).map_err(|e| JobError::corrupt("a priority", e))?,
        tags: rows::json("a study's tags", &row.get::<String>("labels")?)?,
        external_ref: row.get("external_ref")?,
        max_attempts: row.count("max_attempts")?,
        max_queued: row.count("max_queued")?,
        max_run_ms: row.get::<Option<i64>>("max_run_ms")?.map(i64::unsigned_abs),
        traceparent: row.get("traceparent")?,
        step: step.as_deref().map(rows::job_id).transpose()?,
        progress: StudyProgress {
            round: row.count("round")?,
            n_before: row.count("n_before")?,
            n_tasks: row.count("n_tasks")?,
            n_made: row.count("n_made")?,
        },
        n_active: row.count("n_active")?,
        error: error.as_deref().map(|e| rows::json::<Failure>("a study's error", e)).transpose()?,
        created_at: rows::time(row.get("created_at")?)?,
        finished_at: rows::maybe_time(row, "finished_at")?,
        expires_at: rows::maybe_time(row, "expires_at")?,
        purged_at: rows::maybe_time(row, "purged_at")?,
    })
}

async fn get_study(session: &mut Session, tenant: &Tenant, id: StudyId) -> Result<Study, JobError> {
    study(&session.row(sql!("get_study"), bind![id, tenant]).await?.ok_or(JobError::StudyNotFound)?)
}

/// Makes a study refer to this blob instead of the earlier one of the same name.
async fn set_study_blob(session: &mut Session, id: StudyId, blob: &StudyBlob) -> Result<(), JobError> {
    session.execute(sql!("note_candidates_of_study_blob"), bind![id, &blob.name, blob.key.path()]).await?;
    let arguments = bind![id, &blob.name, &blob.key.tenant, blob.key.path(), blob.n_bytes];
    session.execute(sql!("set_study_blob"), arguments).await.map(|_| ())
}

/// Makes a study refer to the records of finished matches. Their jobs are locked first: a purge or deletion of a job
/// has either committed, and its record is not found, or waits until the study refers to the record.
async fn take_records(session: &mut Session, id: StudyId) -> Result<(), JobError> {
    session.rows(sql!("lock_matches_of_study"), bind![id]).await?;
    session.execute(sql!("take_records"), bind![id]).await.map(|_| ())
}

/// Locks a study and returns its state.
async fn lock_study(session: &mut Session, tenant: &Tenant, id: StudyId) -> Result<StudyState, JobError> {
    let found: Option<String> = session.value(sql!("lock_study"), bind![id, tenant]).await?;
    state(&found.ok_or(JobError::StudyNotFound)?)
}

/// Sets the changed columns of a study. `false` if the study has changed since it was read.
async fn update_study(session: &mut Session, study: &Study, change: &StudyChange) -> Result<bool, JobError> {
    let error = change.error.as_ref().map(|error| rows::to_json("a failure", error)).transpose()?;
    let StudyProgress { round, n_before, n_tasks, n_made } = change.progress;
    let arguments = bind![
        study.id,
        study.revision,
        change.state.name(),
        change.step,
        round,
        n_before,
        n_tasks,
        n_made,
        change.n_subjects,
        error,
        change.state.is_final(),
        change.keep,
    ];
    Ok(session.execute(sql!("update_study"), arguments).await? == 1)
}

/// The jobs of a study, locked.
async fn jobs_of_study(session: &mut Session, id: StudyId) -> Result<Vec<(JobId, JobState)>, JobError> {
    let found = session.rows(sql!("jobs_of_study"), bind![id]).await?;
    let job = |row: &Row| Ok((rows::job_id(&row.get::<String>("id")?)?, rows::state(&row.get::<String>("state")?)?));
    found.iter().map(job).collect()
}

/// Drops the references of a study to blobs, which become candidates for removal.
pub(super) async fn drop_blobs_of_study(session: &mut Session, id: StudyId) -> Result<(), JobError> {
    for query in [sql!("lock_blobs_of_study"), sql!("note_candidates_of_study"), sql!("delete_blobs_of_study")] {
        session.execute(query, bind![id]).await?;
    }
    Ok(())
}

/// Marks a study whose result is past its retention, and drops its blobs. `false` if it needs no purge any more.
pub(super) async fn purge_study_result(
    session: &mut Session,
    id: StudyId,
    keep: Option<Duration>,
) -> Result<bool, JobError> {
    if session.execute(sql!("mark_study_purged"), bind![id, keep]).await? == 0 {
        return Ok(false);
    }
    drop_blobs_of_study(session, id).await.map(|()| true)
}

#[async_trait]
impl StudyStore for SqlStore {
    async fn insert_study(
        &self,
        study: &NewStudy,
        blobs: &[StudyBlob],
        admission: &Admission,
    ) -> Result<Study, JobError> {
        let tags = rows::to_json("tags", &study.tags)?;
        self.database
            .transaction(async |session| {
                refuse_when_full(session, &study.tenant, 1, admission).await?;
                let arguments = bind![
                    study.id,
                    &study.tenant,
                    &study.method,
                    &study.method_version,
                    study.n_subjects,
                    study.priority,
                    &tags,
                    study.external_ref.as_ref().map(ExternalRef::as_str),
                    study.max_attempts,
                    study.max_queued,
                    study.max_run_ms,
                    &study.traceparent,
                ];
                session.execute(sql!("insert_study"), arguments).await?;
                for blob in blobs {
                    set_study_blob(session, study.id, blob).await?;
                }
                blobs::drop_hold(session, &admission.holder).await?;
                if let Some(once) = &admission.once {
                    once::finish_once(session, once, Made::Study(study.id)).await?;
                }
                get_study(session, &study.tenant, study.id).await
            })
            .await
    }

    async fn get_study(&self, tenant: &Tenant, id: StudyId) -> Result<Study, JobError> {
        get_study(&mut self.database.reader().await?, tenant, id).await
    }

    async fn list_studies(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<StudyPage, JobError> {
        let arguments =
            bind![tenant, after.map(|c| c.created_at_ms), after.map(|c| c.id.to_string()), i64::from(size) + 1];
        let found = self.database.reader().await?.rows(sql!("list_studies"), arguments).await?;
        let studies: Vec<Study> = found.iter().take(size as usize).map(study).collect::<Result<_, _>>()?;
        let more = found.len() > size as usize;
        let next = studies.last().filter(|_| more).and_then(|last| rows::cursor(last.created_at, &last.id.to_string()));
        Ok(StudyPage { studies, next })
    }

    async fn active_studies(&self, limit: u32) -> Result<Vec<(Tenant, StudyId)>, JobError> {
        let found = self.database.reader().await?.rows(sql!("active_studies"), bind![limit]).await?;
        let one =
            |row: &Row| Ok((rows::tenant(&row.get::<String>("tenant")?)?, rows::study_id(&row.get::<String>("id")?)?));
        found.iter().map(one).collect()
    }

    async fn study_blobs(&self, tenant: &Tenant, id: StudyId) -> Result<Vec<StudyBlob>, JobError> {
        let mut session = self.database.reader().await?;
        get_study(&mut session, tenant, id).await?;
        let found = session.rows(sql!("study_blobs"), bind![id, tenant]).await?;
        let blob = |row: &Row| {
            let key = ArtifactKey::from_path(tenant, &row.get::<String>("path")?);
            let key = key.ok_or(JobError::Corrupt { what: "a blob's address", source: None })?;
            Ok(StudyBlob { name: row.get("name")?, key, n_bytes: row.get::<i64>("n_bytes")?.unsigned_abs() })
        };
        found.iter().map(blob).collect()
    }

    async fn study_failures(&self, id: StudyId) -> Result<Vec<(String, String)>, JobError> {
        let found = self.database.reader().await?.rows(sql!("study_failures"), bind![id]).await?;
        let failure = |row: &Row| {
            let error: Option<String> = row.get("error")?;
            let why = match error {
                Some(error) => rows::json::<Failure>("a job's error", &error)?.detail,
                None => format!("the match was {}", row.get::<String>("state")?),
            };
            Ok((row.get("study_task")?, why))
        };
        found.iter().map(failure).collect()
    }

    async fn study_step(&self, step: JobId) -> Result<Option<(JobState, Option<Failure>)>, JobError> {
        let Some(row) = self.database.reader().await?.row(sql!("study_step"), bind![step]).await? else {
            return Ok(None);
        };
        let error: Option<String> = row.get("error")?;
        let error = error.as_deref().map(|e| rows::json::<Failure>("a job's error", e)).transpose()?;
        Ok(Some((rows::state(&row.get::<String>("state")?)?, error)))
    }

    async fn change_study(&self, study: &Study, change: &StudyChange) -> Result<bool, JobError> {
        self.database
            .transaction(async |session| {
                if !update_study(session, study, change).await? {
                    return Ok(false);
                }
                take_records(session, study.id).await?;
                for blob in &change.blobs {
                    set_study_blob(session, study.id, blob).await?;
                }
                for job in &change.jobs {
                    insert_job(session, job, None).await?;
                }
                if let Some(holder) = &change.holder {
                    blobs::drop_hold(session, holder).await?;
                }
                Ok(true)
            })
            .await
    }

    async fn cancel_study(&self, tenant: &Tenant, id: StudyId) -> Result<Study, JobError> {
        self.database
            .transaction(async |session| {
                let state = lock_study(session, tenant, id).await?;
                if state.is_final() && state != StudyState::Cancelled {
                    return Err(JobError::StudyFinal { state });
                }
                let found = get_study(session, tenant, id).await?;
                if state != StudyState::Cancelled {
                    let change = StudyChange { state: StudyState::Cancelled, step: None, ..StudyChange::of(&found) };
                    update_study(session, &found, &change).await?;
                    for (job, state) in jobs_of_study(session, id).await? {
                        if !state.is_final() {
                            session.execute(sql!("request_cancel"), bind![job]).await?;
                        }
                        if state == JobState::Queued {
                            end_job(session, job, JobState::Cancelled, None, None).await?;
                        }
                    }
                }
                get_study(session, tenant, id).await
            })
            .await
    }

    async fn set_study_priority(&self, tenant: &Tenant, id: StudyId, priority: i32) -> Result<Study, JobError> {
        self.database
            .transaction(async |session| {
                let state = lock_study(session, tenant, id).await?;
                if state.is_final() {
                    return Err(JobError::StudyFinal { state });
                }
                session.execute(sql!("set_study_priority"), bind![id, i64::from(priority)]).await?;
                for (job, state) in jobs_of_study(session, id).await? {
                    if !state.is_final() {
                        session.execute(sql!("set_priority"), bind![job, i64::from(priority)]).await?;
                    }
                }
                get_study(session, tenant, id).await
            })
            .await
    }

    async fn delete_study(&self, tenant: &Tenant, id: StudyId) -> Result<(), JobError> {
        self.database
            .transaction(async |session| {
                let state = lock_study(session, tenant, id).await?;
                let jobs = jobs_of_study(session, id).await?;
                if !state.is_final() || jobs.iter().any(|(_, state)| !state.is_final()) {
                    return Err(JobError::StudyActive { state });
                }
                for (job, _) in jobs {
                    delete_job(session, job).await?;
                }
                drop_blobs_of_study(session, id).await?;
                for query in [sql!("delete_once_of_study"), sql!("delete_study")] {
                    session.execute(query, bind![id]).await?;
                }
                Ok(())
            })
            .await?;
        self.note_deletion();
        Ok(())
    }
}
