//! Conversion of rows to records.

use super::database::Row;
use crate::jobs::documents::Verdict;
use crate::jobs::job::Cursor;
use crate::jobs::{BatchId, Failure, Job, JobError, JobId, JobInput, JobState, Progress, StudyId, Tenant, WaitingJob};
use homolog_primitives::observe::Phase;
use jiff::Timestamp;
use serde::de::DeserializeOwned;
use std::time::Duration;

/// The job in a row of the view `job_records`.
pub(super) fn job(row: &Row) -> Result<Job, JobError> {
    let progress = match row.get::<Option<f64>>("fraction")? {
        None => None,
        Some(fraction) => Some(Progress {
            fraction,
            phase: row.get::<Option<String>>("phase")?.as_deref().map(phase).transpose()?,
            iteration: number(row, "iteration")?,
            message: row.get("message")?,
            energy_latest: row.get("energy_latest")?,
        }),
    };
    let error: Option<String> = row.get("error")?;
    let verdict: Option<String> = row.get("verdict")?;
    let state = state(&row.get::<String>("state")?)?;
    let worker: Option<String> = row.get("worker_id")?;
    Ok(Job {
        id: job_id(&row.get::<String>("id")?)?,
        tenant: tenant(&row.get::<String>("tenant")?)?,
        state,
        method: row.get("method")?,
        method_version: row.get("method_version")?,
        parameters: json("a job's parameters", &row.get::<String>("parameters")?)?,
        source: json::<JobInput>("a job's source", &row.get::<String>("source")?)?,
        target: json::<JobInput>("a job's target", &row.get::<String>("target")?)?,
        priority: i32::try_from(row.get::<i64>("priority")?).map_err(|e| JobError::corrupt("a priority", e))?,
        tags: json("a job's tags", &row.get::<String>("labels")?)?,
        external_ref: row.get("external_ref")?,
        attempt: row.count("attempt")?,
        max_attempts: row.count("max_attempts")?,
        crashes: row.count("crashes")?,
        progress,
        queue_position: None,
        expected_run_ms: None,
        created_at: time(row.get("created_at")?)?,
        started_at: maybe_time(row, "started_at")?,
        finished_at: maybe_time(row, "finished_at")?,
        expires_at: maybe_time(row, "expires_at")?,
        deadline_at: maybe_time(row, "deadline_at")?,
        cancel_requested: row.get("cancel_requested")?,
        error: error.as_deref().map(|e| json::<Failure>("a job's error", e)).transpose()?,
        verdict: verdict.as_deref().map(|v| json::<Verdict>("a job's verdict", v)).transpose()?,
        max_run_ms: row.get::<Option<i64>>("max_run_ms")?.map(i64::unsigned_abs),
        retry_of: row.get::<Option<String>>("retry_of")?.as_deref().map(job_id).transpose()?,
        batch_id: row.get::<Option<String>>("batch_id")?.as_deref().map(batch_id).transpose()?,
        study_id: row.get::<Option<String>>("study_id")?.as_deref().map(study_id).transpose()?,
        cached: row.get("cached")?,
        purged_at: maybe_time(row, "purged_at")?,
        traceparent: row.get("traceparent")?,
        lease_epoch: row.get::<i64>("lease_epoch")?.unsigned_abs(),
        worker: worker.filter(|_| state == JobState::Running),
        read_at: time(row.get("read_at")?)?,
    })
}

/// The queued job in a row of `front_of_queue`.
pub(super) fn waiting_job(row: &Row) -> Result<WaitingJob, JobError> {
    let waited_ms: i64 = row.get("waited_ms")?;
    Ok(WaitingJob {
        id: job_id(&row.get::<String>("id")?)?,
        parameters: json("a job's parameters", &row.get::<String>("parameters")?)?,
        source: json("a job's source", &row.get::<String>("source")?)?,
        target: json("a job's target", &row.get::<String>("target")?)?,
        waited: Duration::from_millis(waited_ms.max(0).unsigned_abs()),
    })
}

fn number(row: &Row, column: &'static str) -> Result<Option<u32>, JobError> {
    let value: Option<i64> = row.get(column)?;
    value.map(|v| u32::try_from(v).map_err(|e| JobError::corrupt("a number", e))).transpose()
}

pub(super) fn maybe_time(row: &Row, column: &'static str) -> Result<Option<Timestamp>, JobError> {
    row.get::<Option<i64>>(column)?.map(time).transpose()
}

/// The position of an entry in a list. A cursor contains a job's id; ids of other entries have the same form.
pub(super) fn cursor(created_at: Timestamp, id: &str) -> Option<Cursor> {
    JobId::parse(id).map(|id| Cursor { created_at_ms: created_at.as_millisecond(), id })
}

/// Parses the id of a job.
pub(super) fn job_id(text: &str) -> Result<JobId, JobError> {
    JobId::parse(text).ok_or(JobError::Corrupt { what: "a job's id", source: None })
}

/// Parses the id of a batch.
pub(super) fn batch_id(text: &str) -> Result<BatchId, JobError> {
    BatchId::parse(text).ok_or(JobError::Corrupt { what: "a batch's id", source: None })
}

/// Parses the id of a study.
pub(super) fn study_id(text: &str) -> Result<StudyId, JobError> {
    StudyId::parse(text).ok_or(JobError::Corrupt { what: "a study's id", source: None })
}

/// Parses the name of a tenant.
pub(super) fn tenant(name: &str) -> Result<Tenant, JobError> {
    Tenant::new(name).ok_or(JobError::Corrupt { what: "a tenant", source: None })
}

/// Parses the name of a state.
pub(super) fn state(name: &str) -> Result<JobState, JobError> {
    JobState::from_name(name).ok_or(JobError::Corrupt { what: "a job's state", source: None })
}

fn phase(name: &str) -> Result<Phase, JobError> {
    serde_json::from_value(name.into()).map_err(|e| JobError::corrupt("a phase", e))
}

/// A time in the database, ms since 1970.
pub(super) fn time(milliseconds: i64) -> Result<Timestamp, JobError> {
    Timestamp::from_millisecond(milliseconds).map_err(|e| JobError::corrupt("a time", e))
}

/// Reads a JSON column.
pub(super) fn json<T: DeserializeOwned>(what: &'static str, text: &str) -> Result<T, JobError> {
    serde_json::from_str(text).map_err(|e| JobError::corrupt(what, e))
}

/// Writes a JSON column.
pub(super) fn to_json<T: serde::Serialize>(what: &'static str, value: &T) -> Result<String, JobError> {
    serde_json::to_string(value).map_err(|e| JobError::corrupt(what, e))
}
