//! The inputs of a step of a study, read from the stores: its definition, the existing records and template, and the
//! files of its subjects, each when it is needed.

use super::pool_parts::PoolParts;
use super::retry::retrying;
use super::study_score;
use crate::jobs::study::{StudyDefinition, StudyInputs, StudyMaterial, blob};
use crate::jobs::{ArtifactKey, ArtifactStore, ComputeInputs, Job, JobError, Lease, Purpose, StudyBlob, Tenant};
use futures_util::StreamExt as _;
use futures_util::TryStreamExt as _;
use std::collections::BTreeMap;
use std::fmt;
use std::io;
use std::sync::Arc;
use tokio::runtime::Handle;

/// Files that are read at the same time.
const AT_ONCE: usize = 16;

/// The uploads of a tenant, read by a thread of a computation.
struct Uploads {
    tenant: Tenant,
    artifacts: Arc<dyn ArtifactStore>,
    runtime: Handle,
}

impl fmt::Debug for Uploads {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Uploads")
    }
}

impl StudyInputs for Uploads {
    fn read(&self, hash: &str) -> io::Result<Vec<u8>> {
        let key = ArtifactKey::of_hash(&self.tenant, hash).ok_or(io::ErrorKind::NotFound)?;
        // The threads of computations do not belong to the runtime, so they may wait for it.
        let bytes = self.runtime.block_on(retrying(|| self.artifacts.get(&key)));
        bytes.map(Vec::from).map_err(io::Error::other)
    }
}

/// Reads the inputs of a step, or of the score of a new subject, which is then the last of the study.
///
/// # Errors
/// Those of the stores.
pub(super) async fn read_step(parts: &PoolParts, lease: &Lease, job: &Job) -> Result<ComputeInputs, JobError> {
    let id = job.study_id.ok_or(JobError::Corrupt { what: "a step without a study", source: None })?;
    let studies = &parts.studies.studies;
    let blobs = retrying(|| studies.study_blobs(&lease.tenant, id)).await?;
    let failures = retrying(|| studies.study_failures(id)).await?;
    let found = blobs.iter().find(|found| found.name == blob::DEFINITION).ok_or(JobError::Gone)?;
    let definition = retrying(|| parts.artifacts.get(&found.key)).await?;
    let mut definition: StudyDefinition =
        serde_json::from_slice(&definition).map_err(|e| JobError::corrupt("the definition of a study", e))?;
    if job.is_score() {
        let asked = study_score::asked(&job.parameters).map_err(|e| JobError::corrupt("what a score asks", e))?;
        definition = definition.with_scored(&asked, job.target.clone());
    }
    let of_folder: Vec<StudyBlob> = blobs.into_iter().filter(|found| blob::is_of_folder(&found.name)).collect();
    let artifacts = &parts.artifacts;
    let read = |found: StudyBlob| async move {
        let bytes = retrying(|| artifacts.get(&found.key)).await?;
        Ok::<_, JobError>((found.name, Vec::from(bytes)))
    };
    let files: BTreeMap<String, Vec<u8>> =
        futures_util::stream::iter(of_folder).map(read).buffer_unordered(AT_ONCE).try_collect().await?;
    let inputs =
        Uploads { tenant: lease.tenant.clone(), artifacts: Arc::clone(&parts.artifacts), runtime: Handle::current() };
    let material = StudyMaterial { definition, files, failures, inputs: Box::new(inputs) };
    Ok(ComputeInputs {
        source: Vec::new(),
        source_hint: None,
        target: Vec::new(),
        target_hint: None,
        purpose: Purpose::Step(Arc::new(material)),
    })
}
