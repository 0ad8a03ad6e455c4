//! The record of a job, what makes a new one, and how lists of them are asked for.

use super::batch::BatchId;
use super::state::JobState;
use super::trace::Progress;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// Identity of a job: a UUIDv7, so ids sort by the time of their making.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JobId(uuid::Uuid);

impl JobId {
    /// A new id.
    pub fn new() -> Self {
        JobId(uuid::Uuid::now_v7())
    }

    /// The id written in `text`, in the usual hyphenated form.
    pub fn parse(text: &str) -> Option<Self> {
        if text.len() != 36 {
            return None;
        }
        uuid::Uuid::try_parse(text).ok().map(JobId)
    }
}

impl Default for JobId {
    fn default() -> Self {
        JobId::new()
    }
}

impl std::fmt::Display for JobId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.as_hyphenated().fmt(f)
    }
}

/// Whose job it is. Every query carries it; without authentication it is `default`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Tenant(String);

impl Tenant {
    /// A tenant by name: lower-case letters, digits and hyphens, so that it can be part of a path.
    pub fn new(name: &str) -> Option<Self> {
        let ok = !name.is_empty()
            && name.len() <= 64
            && name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-');
        ok.then(|| Tenant(name.to_owned()))
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.0
    }
}

impl Default for Tenant {
    fn default() -> Self {
        Tenant("default".to_owned())
    }
}

/// One of a job's two inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JobInput {
    /// Content hash of the bytes as uploaded: 64 hexadecimal digits of BLAKE3.
    pub hash: String,
    /// Their number.
    pub n_bytes: u64,
    /// The endings of the uploaded file's name, such as `.nii.gz`. The name itself may name a patient and is not kept.
    pub name_hint: Option<String>,
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs, as found when it was submitted.
    pub report: Value,
}

/// Why a job ended without a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// Stable name of the problem.
    pub code: String,
    /// One sentence without anything from the inputs' names or labels.
    pub detail: String,
    /// `source` or `target`, where one of them is the reason.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    /// Topology of the surface that was refused.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub topology: Option<Value>,
}

impl Failure {
    /// A failure that no single input explains.
    pub fn new(code: &str, detail: impl Into<String>) -> Self {
        Failure { code: code.to_owned(), detail: detail.into(), input: None, topology: None }
    }
}

/// A job as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// Identity.
    pub id: JobId,
    /// Owner.
    pub tenant: Tenant,
    /// Where it stands.
    pub state: JobState,
    /// Name of the method.
    pub method: String,
    /// Version of the program that accepted it.
    pub method_version: String,
    /// Effective parameters.
    pub parameters: Value,
    /// The surface that moves.
    pub source: JobInput,
    /// The surface that stays.
    pub target: JobInput,
    /// −100 to 100, higher first.
    pub priority: i32,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name for it.
    pub external_ref: Option<String>,
    /// Times a worker began it, not counting those that gave it back.
    pub attempt: u32,
    /// Crashes after which it is dead.
    pub max_attempts: u32,
    /// Workers lost while they held it.
    pub crashes: u32,
    /// How far the present attempt is.
    pub progress: Option<Progress>,
    /// 1 for the next to run; only while queued and only when one job is asked for.
    pub queue_position: Option<u64>,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// When its present or last attempt began.
    pub started_at: Option<Timestamp>,
    /// When it reached its final state.
    pub finished_at: Option<Timestamp>,
    /// When it will be removed.
    pub expires_at: Option<Timestamp>,
    /// When it is too late to begin.
    pub deadline_at: Option<Timestamp>,
    /// Whether somebody asked for its end.
    pub cancel_requested: bool,
    /// Why it has no result.
    pub error: Option<Failure>,
    /// Longest run that its submitter allows.
    pub max_run_ms: Option<u64>,
    /// The job that this one tries again.
    pub retry_of: Option<JobId>,
    /// The batch that it belongs to.
    pub batch_id: Option<BatchId>,
    /// Whether it was answered from an equal job's result.
    pub cached: bool,
    /// When its result was removed.
    pub purged_at: Option<Timestamp>,
    /// W3C trace context of its submission.
    pub traceparent: Option<String>,
    /// Raised at every claim; fences everything a worker writes.
    pub lease_epoch: u64,
    /// The database's clock when this was read.
    pub read_at: Timestamp,
}

impl Job {
    /// The job as it was when it was accepted: what its submission was answered.
    #[must_use]
    pub fn as_accepted(&self) -> Job {
        if self.cached {
            return self.clone();
        }
        Job {
            state: JobState::Queued,
            attempt: 0,
            crashes: 0,
            progress: None,
            queue_position: None,
            started_at: None,
            finished_at: None,
            expires_at: None,
            cancel_requested: false,
            error: None,
            purged_at: None,
            lease_epoch: 0,
            ..self.clone()
        }
    }

    /// Remaining time, ms, if the rest goes as fast as what is done. `None` before a twentieth is done.
    pub fn eta_ms(&self) -> Option<u64> {
        let (progress, started) = (self.progress.as_ref()?, self.started_at?);
        if self.state != JobState::Running || progress.fraction < 0.05 {
            return None;
        }
        let elapsed = (self.read_at.as_millisecond() - started.as_millisecond()).max(0) as f64;
        Some((elapsed * (1.0 - progress.fraction) / progress.fraction).round() as u64)
    }
}

/// A job to be stored. Times are the database's.
#[derive(Debug, Clone, PartialEq)]
pub struct NewJob {
    /// Identity.
    pub id: JobId,
    /// Owner.
    pub tenant: Tenant,
    /// Name of the method.
    pub method: String,
    /// Version of this program.
    pub method_version: String,
    /// Effective parameters.
    pub parameters: Value,
    /// The surface that moves.
    pub source: JobInput,
    /// The surface that stays.
    pub target: JobInput,
    /// −100 to 100, higher first.
    pub priority: i32,
    /// The submitter's own marks.
    pub labels: BTreeMap<String, String>,
    /// The submitter's own name for it.
    pub external_ref: Option<String>,
    /// Crashes after which it is dead.
    pub max_attempts: u32,
    /// When it is too late to begin.
    pub deadline_at: Option<Timestamp>,
    /// Longest run that its submitter allows.
    pub max_run_ms: Option<u64>,
    /// The job that this one tries again.
    pub retry_of: Option<JobId>,
    /// The batch that it belongs to.
    pub batch_id: Option<BatchId>,
    /// Jobs with this key have the same result; `None` if it must be computed.
    pub cache_key: Option<String>,
    /// Whether the result of an equal job may be its own.
    pub use_cache: bool,
    /// W3C trace context of its submission.
    pub traceparent: Option<String>,
}

/// Which jobs a list shows; an empty filter shows all of the tenant.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct JobFilter {
    /// Any of these states; empty for all.
    pub states: Vec<JobState>,
    /// This method.
    pub method: Option<String>,
    /// This external reference.
    pub external_ref: Option<String>,
    /// This batch.
    pub batch_id: Option<BatchId>,
    /// All of these labels.
    pub labels: BTreeMap<String, String>,
    /// Made at this time or later.
    pub created_from: Option<Timestamp>,
    /// Made before this time.
    pub created_before: Option<Timestamp>,
}

impl JobFilter {
    /// Most labels of a filter: the store's query has a line for each.
    pub const MAX_LABELS: usize = 4;
}

/// Order of a list by time of making.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Order {
    /// The newest first.
    #[default]
    NewestFirst,
    /// The oldest first.
    OldestFirst,
}

/// Which part of a list is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PageRequest {
    /// Most entries.
    pub size: u32,
    /// After this one, as an earlier page said.
    pub after: Option<Cursor>,
    /// Order.
    pub order: Order,
}

/// A place in a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cursor {
    /// Time of making, ms since 1970.
    pub created_at_ms: i64,
    /// Among equals.
    pub id: JobId,
}

impl Cursor {
    /// The token that stands for this place; clients hand it back as it is.
    pub fn to_token(self) -> String {
        format!("{:x}.{}", self.created_at_ms, self.id)
    }

    /// The place that a token stands for.
    pub fn from_token(token: &str) -> Option<Self> {
        let (time, id) = token.split_once('.')?;
        let created_at_ms = i64::from_str_radix(time, 16).ok()?;
        Some(Cursor { created_at_ms, id: JobId::parse(id)? })
    }
}

/// A part of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct JobPage {
    /// The jobs.
    pub jobs: Vec<Job>,
    /// Where the next page begins, if there is one.
    pub next: Option<Cursor>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_tokens_lead_back_and_nonsense_is_refused() {
        let cursor = Cursor { created_at_ms: 1_795_238_118_123, id: JobId::new() };
        assert_eq!(Cursor::from_token(&cursor.to_token()), Some(cursor));
        for nonsense in ["", ".", "1", "x.y", "zz.0195", "1.{}"] {
            assert_eq!(Cursor::from_token(nonsense), None, "{nonsense}");
        }
    }

    #[test]
    fn tenants_are_safe_in_paths() {
        assert!(Tenant::new("clinic-7").is_some());
        for bad in ["", "..", "a/b", "A", "a b"] {
            assert!(Tenant::new(bad).is_none(), "{bad}");
        }
    }
}
