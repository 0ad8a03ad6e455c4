//! The record of a job, the form of a new one, and how lists of jobs are requested.

use super::documents::Verdict;
use super::ids::{BatchId, JobId, SCORE_METHOD, STEP_METHOD, StudyId};
use super::metadata::{ExternalRef, Tags};
use super::state::JobState;
use super::trace::Progress;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// The owner of jobs and uploads. Every query carries it; without authentication it is `default`.
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
    /// Hash of the content as uploaded: 64 hexadecimal digits of BLAKE3.
    pub hash: String,
    /// Size of the content, bytes.
    pub n_bytes: u64,
    /// Extensions of the uploaded file's name, such as `.nii.gz`. The name itself may identify a patient and is not kept.
    pub name_hint: Option<String>,
    /// Vertices of the surface to be matched.
    pub n_vertices: u32,
    /// Its faces.
    pub n_faces: u32,
    /// Format, topology and repairs, as found at submission.
    pub report: Value,
}

/// Why a job ended without a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// Stable name of the problem.
    pub code: String,
    /// One sentence, without anything from file names or tags.
    pub detail: String,
    /// `source` or `target`, if one of them is the cause.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    /// Topology of the refused surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub topology: Option<Value>,
    /// Where the first fault of that surface is, mm, if it is at one place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place_mm: Option<Box<[f64; 3]>>,
}

impl Failure {
    /// A failure that is not caused by a single input.
    pub fn new(code: &str, detail: impl Into<String>) -> Self {
        Failure { code: code.to_owned(), detail: detail.into(), input: None, topology: None, place_mm: None }
    }
}

/// A job as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// Identity.
    pub id: JobId,
    /// Owner.
    pub tenant: Tenant,
    /// Its state.
    pub state: JobState,
    /// Name of the method.
    pub method: String,
    /// Version of the program that accepted it.
    pub method_version: String,
    /// Effective parameters, as JSON.
    pub parameters: Value,
    /// The surface that is moved.
    pub source: JobInput,
    /// The surface that stays fixed.
    pub target: JobInput,
    /// −100 to 100, higher first.
    pub priority: i32,
    /// Tags of the submitter.
    pub tags: BTreeMap<String, String>,
    /// The submitter's own identifier.
    pub external_ref: Option<String>,
    /// Number of times that a worker started it, not counting those that returned it to the queue.
    pub attempt: u32,
    /// Number of lost workers after which it is dead.
    pub max_attempts: u32,
    /// Number of workers that were lost while they ran it.
    pub crashes: u32,
    /// Progress of the current attempt.
    pub progress: Option<Progress>,
    /// Position among its tenant's queued jobs, 1 for the next to run; only while queued, and not in lists.
    pub queue_position: Option<u64>,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// When its current or last attempt started.
    pub started_at: Option<Timestamp>,
    /// When it reached its final state.
    pub finished_at: Option<Timestamp>,
    /// When its result will be removed.
    pub expires_at: Option<Timestamp>,
    /// Deadline for its start.
    pub deadline_at: Option<Timestamp>,
    /// Whether its cancellation was requested.
    pub cancel_requested: bool,
    /// Why it has no result.
    pub error: Option<Failure>,
    /// Whether its result can be relied on; absent before it has succeeded, and for jobs that ended before verdicts were
    /// stored.
    pub verdict: Option<Verdict>,
    /// Maximum run time that its submitter allows, ms.
    pub max_run_ms: Option<u64>,
    /// The job of which this one is a retry.
    pub retry_of: Option<JobId>,
    /// The batch that it belongs to.
    pub batch_id: Option<BatchId>,
    /// The study that it is part of.
    pub study_id: Option<StudyId>,
    /// Whether it shares the result of an equal job.
    pub cached: bool,
    /// When its result was removed.
    pub purged_at: Option<Timestamp>,
    /// W3C trace context of its submission.
    pub traceparent: Option<String>,
    /// Incremented at every claim; fences everything that a worker writes.
    pub lease_epoch: u64,
    /// The worker that runs it, only while it does.
    pub worker: Option<String>,
    /// Predicted run time, ms, while it waits or has just begun; not in lists.
    pub expected_run_ms: Option<u64>,
    /// The database's clock when this was read.
    pub read_at: Timestamp,
}

impl Job {
    /// Whether it plans or models a study, and is hidden from clients.
    pub fn is_step(&self) -> bool {
        self.method == STEP_METHOD && self.study_id.is_some()
    }

    /// Whether it scores a new subject against a study.
    pub fn is_score(&self) -> bool {
        self.method == SCORE_METHOD && self.study_id.is_some()
    }

    /// The job as it was when it was accepted, as in the response to its submission.
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
            verdict: None,
            purged_at: None,
            lease_epoch: 0,
            worker: None,
            ..self.clone()
        }
    }

    /// Estimated remaining time of the computation, ms: extrapolated from the progress, or predicted where less than 5 % is
    /// done; `None` if it was predicted to end earlier. Time in the queue does not count.
    pub fn eta_ms(&self) -> Option<u64> {
        match self.state {
            JobState::Queued => self.expected_run_ms,
            JobState::Running => {
                let elapsed = (self.read_at.as_millisecond() - self.started_at?.as_millisecond()).max(0);
                match self.progress.as_ref().filter(|progress| progress.tells_time()) {
                    Some(Progress { fraction, .. }) => {
                        Some((elapsed as f64 * (1.0 - fraction) / fraction).round() as u64)
                    }
                    None => self.expected_run_ms?.checked_sub(elapsed.unsigned_abs()),
                }
            }
            _ => None,
        }
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
    /// Effective parameters, as JSON.
    pub parameters: Value,
    /// The surface that is moved.
    pub source: JobInput,
    /// The surface that stays fixed.
    pub target: JobInput,
    /// −100 to 100, higher first.
    pub priority: i32,
    /// Tags of the submitter.
    pub tags: Tags,
    /// The submitter's own identifier.
    pub external_ref: Option<ExternalRef>,
    /// Number of lost workers after which it is dead.
    pub max_attempts: u32,
    /// Deadline for its start.
    pub deadline_at: Option<Timestamp>,
    /// Maximum run time that its submitter allows, ms.
    pub max_run_ms: Option<u64>,
    /// The job of which this one is a retry.
    pub retry_of: Option<JobId>,
    /// The batch that it belongs to.
    pub batch_id: Option<BatchId>,
    /// The study that it is part of.
    pub study_id: Option<StudyId>,
    /// The key of the record that it makes for its study.
    pub study_task: Option<String>,
    /// Jobs with equal keys have equal results; `None` if the result must not be shared.
    pub cache_key: Option<String>,
    /// Whether it may share the result of an equal job.
    pub use_cache: bool,
    /// W3C trace context of its submission.
    pub traceparent: Option<String>,
}

/// Filter of a list of jobs; an empty filter selects all jobs of the tenant.
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
    /// This study.
    pub study_id: Option<StudyId>,
    /// All of these tags.
    pub tags: BTreeMap<String, String>,
    /// Created at this time or later.
    pub created_from: Option<Timestamp>,
    /// Created before this time.
    pub created_before: Option<Timestamp>,
}

impl JobFilter {
    /// Maximum number of tags in a filter: the store's query has a line for each.
    pub const MAX_TAGS: usize = 4;
}

/// Order of a list by creation time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Order {
    /// The newest first.
    #[default]
    NewestFirst,
    /// The oldest first.
    OldestFirst,
}

/// The requested page of a list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PageRequest {
    /// Maximum number of entries.
    pub size: u32,
    /// The page begins after this entry, as stated by the page before.
    pub after: Option<Cursor>,
    /// Order.
    pub order: Order,
}

/// A position in a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cursor {
    /// Creation time, ms since 1970.
    pub created_at_ms: i64,
    /// Distinguishes entries with equal creation times.
    pub id: JobId,
}

impl Cursor {
    /// The token for this position; opaque to clients.
    pub fn to_token(self) -> String {
        format!("{:x}.{}", self.created_at_ms, self.id)
    }

    /// The position that a token encodes.
    pub fn from_token(token: &str) -> Option<Self> {
        let (time, id) = token.split_once('.')?;
        let created_at_ms = i64::from_str_radix(time, 16).ok()?;
        let cursor = Cursor { created_at_ms, id: JobId::parse(id)? };
        // Other spellings of the same numbers, and times that no job has, were never issued.
        (cursor.to_token() == token).then_some(cursor)
    }
}

/// A page of a list.
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
    fn page_tokens_round_trip_and_malformed_ones_are_refused() {
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
