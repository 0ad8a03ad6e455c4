//! The job store as workers use it, past HTTP and past processes.

use homolog::jobs::{
    Admission, ArtifactKey, ArtifactKind, ArtifactRef, JobError, JobId, JobInput, JobState, JobStore, Lease,
    LeaseStatus, NewJob, NumberedPoint, Outcome, Progress, Recovered, Tenant, TraceChunk, WorkerId,
};
use homolog::observe::{Phase, TracePoint};
use serde_json::json;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::Arc;
use std::time::Duration;

/// A lease that outlives every test.
pub const LONG: Duration = Duration::from_secs(3600);
/// A lease that is over soon.
pub const SHORT: Duration = Duration::from_millis(100);

/// Connections to a job store.
#[derive(Clone)]
pub struct Queue {
    pub store: Arc<dyn JobStore>,
}

impl Queue {
    /// Adds a job.
    pub async fn add(&self) -> Result<JobId, JobError> {
        let admission = Admission { max_queued: 1_000_000, holder: String::new(), keep_result: None, once: None };
        self.store.insert(&new_job(), &admission).await.map(|job| job.id)
    }

    /// The next job for a worker of this name.
    pub async fn claim(&self, worker: &str, duration: Duration) -> Result<Option<Lease>, JobError> {
        let claimed = self.store.claim(&WorkerId::from_name(worker), duration, LONG).await?;
        Ok(claimed.map(|leased| leased.lease))
    }

    pub async fn append(&self, lease: &Lease, seqs: RangeInclusive<u64>) -> Result<(), JobError> {
        self.store.append_trace(lease, &chunk(seqs)).await
    }

    /// Ends a job with a result whose content is `text`.
    pub async fn finish(&self, lease: &Lease, text: &str) -> Result<(), JobError> {
        let key = ArtifactKey::of_result(lease, text.as_bytes());
        let result = ArtifactRef { kind: ArtifactKind::Result, key, n_bytes: text.len() as u64 };
        self.store.finish(lease, &Outcome::Succeeded(vec![result]), None).await
    }

    pub async fn finish_cancelled(&self, lease: &Lease) -> Result<(), JobError> {
        self.store.finish(lease, &Outcome::Cancelled, None).await
    }

    pub async fn heartbeat(&self, lease: &Lease) -> Result<LeaseStatus, JobError> {
        self.store.heartbeat(lease, LONG).await
    }

    /// Announces a blob that a worker is about to write.
    pub async fn hold(&self, lease: &Lease, text: &str) -> Result<(), JobError> {
        let key = ArtifactKey::of_result(lease, text.as_bytes());
        self.store.hold_blobs(&lease.holder(), &[key], LONG, Some(lease)).await
    }

    pub async fn cancel(&self, id: JobId) -> Result<JobState, JobError> {
        self.store.cancel(&Tenant::default(), id).await.map(|job| job.state)
    }

    pub async fn state(&self, id: JobId) -> JobState {
        self.store.get(&Tenant::default(), id).await.unwrap().state
    }

    /// The hash of the job's result.
    pub async fn result_hash(&self, id: JobId) -> String {
        let (_, artifact) = self.store.artifact(&Tenant::default(), id, ArtifactKind::Result).await.unwrap();
        artifact.unwrap().key.hash().to_owned()
    }

    pub async fn seqs(&self, id: JobId) -> Vec<u64> {
        let page = self.store.trace(&Tenant::default(), id, 0, 10_000).await.unwrap();
        page.points.iter().map(|point| point.seq).collect()
    }

    /// Takes back what ran out, after short leases had the time to.
    pub async fn expire(&self) -> Recovered {
        tokio::time::sleep(SHORT * 2).await;
        self.store.recover_expired().await.unwrap()
    }
}

/// Whether a store refused because of the fence.
pub fn is_lost<T: std::fmt::Debug>(answer: &Result<T, JobError>) -> bool {
    matches!(answer, Err(JobError::LeaseLost))
}

fn new_job() -> NewJob {
    let id = JobId::new();
    let input = |side: &str| JobInput {
        hash: blake3::hash(format!("{id}{side}").as_bytes()).to_hex().to_string(),
        n_bytes: 1,
        name_hint: None,
        n_vertices: 1,
        n_faces: 1,
        report: json!({}),
    };
    NewJob {
        id,
        tenant: Tenant::default(),
        method: "obedient".to_owned(),
        method_version: "1".to_owned(),
        parameters: json!({}),
        source: input("source"),
        target: input("target"),
        priority: 0,
        labels: BTreeMap::new(),
        external_ref: None,
        max_attempts: 3,
        deadline_at: None,
        max_run_ms: None,
        retry_of: None,
        batch_id: None,
        cache_key: None,
        use_cache: false,
        traceparent: None,
    }
}

fn chunk(seqs: RangeInclusive<u64>) -> TraceChunk {
    let fraction = *seqs.end() as f64 / 1000.0;
    let point =
        |seq: u64| NumberedPoint { seq, point: TracePoint::new(0, Phase::Inference, seq as u32), elapsed_ms: seq };
    TraceChunk {
        points: seqs.map(point).collect(),
        progress: Progress { fraction, phase: None, iteration: None, message: None, energy_latest: None },
    }
}
