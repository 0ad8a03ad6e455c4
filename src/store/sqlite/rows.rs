//! What the columns of a row mean.

use crate::jobs::{Failure, Job, JobError, JobId, JobInput, JobState, Progress, Tenant};
use crate::observe::Phase;
use jiff::Timestamp;
use serde::de::DeserializeOwned;

/// A row of the view `job_records`.
#[derive(Debug, sqlx::FromRow)]
pub(super) struct JobRow {
    id: String,
    tenant: String,
    state: String,
    method: String,
    method_version: String,
    parameters: String,
    source: String,
    target: String,
    priority: i32,
    labels: String,
    external_ref: Option<String>,
    attempt: u32,
    max_attempts: u32,
    crashes: u32,
    cancel_requested: bool,
    created_at: i64,
    started_at: Option<i64>,
    finished_at: Option<i64>,
    expires_at: Option<i64>,
    deadline_at: Option<i64>,
    lease_epoch: i64,
    error: Option<String>,
    fraction: Option<f64>,
    phase: Option<String>,
    iteration: Option<u32>,
    message: Option<String>,
    energy_latest: Option<f64>,
    read_at: i64,
}

impl JobRow {
    /// The job.
    pub(super) fn into_job(self) -> Result<Job, JobError> {
        let progress = match self.fraction {
            None => None,
            Some(fraction) => Some(Progress {
                fraction,
                phase: self.phase.as_deref().map(phase).transpose()?,
                iteration: self.iteration,
                message: self.message,
                energy_latest: self.energy_latest,
            }),
        };
        Ok(Job {
            id: JobId::parse(&self.id).ok_or(JobError::Corrupt { what: "a job's id", source: None })?,
            tenant: Tenant::new(&self.tenant).ok_or(JobError::Corrupt { what: "a tenant", source: None })?,
            state: state(&self.state)?,
            method: self.method,
            method_version: self.method_version,
            parameters: json("a job's parameters", &self.parameters)?,
            source: json::<JobInput>("a job's source", &self.source)?,
            target: json::<JobInput>("a job's target", &self.target)?,
            priority: self.priority,
            labels: json("a job's labels", &self.labels)?,
            external_ref: self.external_ref,
            attempt: self.attempt,
            max_attempts: self.max_attempts,
            crashes: self.crashes,
            progress,
            queue_position: None,
            created_at: time(self.created_at)?,
            started_at: self.started_at.map(time).transpose()?,
            finished_at: self.finished_at.map(time).transpose()?,
            expires_at: self.expires_at.map(time).transpose()?,
            deadline_at: self.deadline_at.map(time).transpose()?,
            cancel_requested: self.cancel_requested,
            error: self.error.as_deref().map(|e| json::<Failure>("a job's error", e)).transpose()?,
            lease_epoch: self.lease_epoch.unsigned_abs(),
            read_at: time(self.read_at)?,
        })
    }
}

/// The state of this name.
pub(super) fn state(name: &str) -> Result<JobState, JobError> {
    JobState::from_name(name).ok_or(JobError::Corrupt { what: "a job's state", source: None })
}

fn phase(name: &str) -> Result<Phase, JobError> {
    serde_json::from_value(name.into()).map_err(|e| JobError::corrupt("a phase", e))
}

fn time(milliseconds: i64) -> Result<Timestamp, JobError> {
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

/// A duration in the database's unit.
pub(super) fn milliseconds(duration: std::time::Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX / 4)
}
