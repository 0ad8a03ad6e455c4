//! The job store as workers use it, without HTTP and without processes.

use crate::store::{chunk, new_job, room};
use homolog::jobs::{
    ArtifactKey, ArtifactKind, ArtifactRef, JobError, JobId, JobState, JobStore, Lease, LeaseStatus, NewJob, Outcome,
    Recovered, Tenant, WorkerId,
};
use std::ops::RangeInclusive;
use std::sync::Arc;
use std::time::Duration;

/// A lease that outlives every test.
pub(super) const LONG: Duration = Duration::from_secs(3600);
/// A lease that expires soon.
pub(super) const SHORT: Duration = Duration::from_millis(100);

/// Connections to a job store.
#[derive(Clone)]
pub(super) struct Queue {
    pub store: Arc<dyn JobStore>,
}

impl Queue {
    /// Adds a job.
    pub(super) async fn add(&self) -> Result<JobId, JobError> {
        self.store.insert_job(&own_job(), &room(1_000_000)).await.map(|job| job.id)
    }

    /// The next job for a worker of this name.
    pub(super) async fn claim(&self, worker: &str, duration: Duration) -> Result<Option<Lease>, JobError> {
        let claimed = self.store.claim_next(&WorkerId::from_name(worker), duration, LONG).await?;
        Ok(claimed.map(|leased| leased.lease))
    }

    pub(super) async fn append(&self, lease: &Lease, seqs: RangeInclusive<u64>) -> Result<(), JobError> {
        self.store.append_trace(lease, &chunk(seqs)).await
    }

    /// Ends a job with a result whose content is `text`.
    pub(super) async fn finish(&self, lease: &Lease, text: &str) -> Result<(), JobError> {
        let key = ArtifactKey::of_result(lease, text.as_bytes());
        let result = ArtifactRef { kind: ArtifactKind::Result, key, n_bytes: text.len() as u64 };
        self.store.finish_job(lease, &Outcome::Succeeded { artifacts: vec![result], verdict: None }, None).await
    }

    pub(super) async fn finish_cancelled(&self, lease: &Lease) -> Result<(), JobError> {
        self.store.finish_job(lease, &Outcome::Cancelled, None).await
    }

    pub(super) async fn heartbeat(&self, lease: &Lease) -> Result<LeaseStatus, JobError> {
        self.store.heartbeat(lease, LONG).await
    }

    /// Announces a blob that a worker is about to write.
    pub(super) async fn hold(&self, lease: &Lease, text: &str) -> Result<(), JobError> {
        let key = ArtifactKey::of_result(lease, text.as_bytes());
        self.store.hold_blobs(&lease.holder(), &[key], LONG, Some(lease)).await
    }

    pub(super) async fn cancel(&self, id: JobId) -> Result<JobState, JobError> {
        self.store.cancel_job(&Tenant::default(), id).await.map(|job| job.state)
    }

    pub(super) async fn state(&self, id: JobId) -> JobState {
        self.store.get_job(&Tenant::default(), id).await.unwrap().state
    }

    /// The hash of the job's result.
    pub(super) async fn result_hash(&self, id: JobId) -> String {
        let (_, artifact) = self.store.get_artifact(&Tenant::default(), id, ArtifactKind::Result).await.unwrap();
        artifact.unwrap().key.hash().to_owned()
    }

    pub(super) async fn seqs(&self, id: JobId) -> Vec<u64> {
        let page = self.store.get_trace(&Tenant::default(), id, 0, 10_000).await.unwrap();
        page.points.iter().map(|point| point.seq).collect()
    }

    /// Waits until short leases have expired and recovers their jobs.
    pub(super) async fn expire(&self) -> Recovered {
        tokio::time::sleep(SHORT * 2).await;
        self.store.recover_expired().await.unwrap()
    }
}

/// A job with unique inputs.
fn own_job() -> NewJob {
    let mut job = new_job(0);
    for (input, side) in [(&mut job.source, "source"), (&mut job.target, "target")] {
        input.hash = blake3::hash(format!("{}{side}", job.id).as_bytes()).to_hex().to_string();
    }
    job
}
