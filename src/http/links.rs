//! Links of jobs and results to their parts.

use super::wire::{JobLinks, ResultLinks};
use crate::jobs::{Job, JobId, JobState};

impl JobLinks {
    /// The links of a job: those to parts of its result once it has one.
    pub(super) fn of(job: &Job) -> Self {
        let path = format!("/v1/jobs/{}", job.id);
        let succeeded = job.state == JobState::Succeeded && job.purged_at.is_none();
        let part = |name: &str| (succeeded && !job.is_score()).then(|| format!("{path}/{name}"));
        JobLinks {
            trace: format!("{path}/trace"),
            events: format!("{path}/events"),
            result: part("result"),
            correspondences: part("correspondences"),
            transform: part("transform"),
            source_surface: part("surfaces/source"),
            target_surface: part("surfaces/target"),
            aligned: part("aligned"),
            warped: part("warped"),
            report: part("report"),
            batch: job.batch_id.map(|id| format!("/v1/batches/{id}")),
            study: job.study_id.map(|id| format!("/v1/studies/{id}")),
            score: job
                .study_id
                .filter(|_| succeeded && job.is_score())
                .map(|id| format!("/v1/studies/{id}/scores/{}", job.id)),
            retry_of: job.retry_of.map(|id| format!("/v1/jobs/{id}")),
            cancel: (!job.state.is_final()).then(|| format!("{path}/cancel")),
            retry: (job.state.is_final() && job.purged_at.is_none()).then(|| format!("{path}/retry")),
            job: path,
        }
    }
}

impl ResultLinks {
    /// The links of a job's result.
    pub(crate) fn of(id: JobId) -> Self {
        let path = format!("/v1/jobs/{id}");
        ResultLinks {
            transform: format!("{path}/transform"),
            source_surface: format!("{path}/surfaces/source"),
            target_surface: format!("{path}/surfaces/target"),
            correspondences: format!("{path}/correspondences"),
            trace: format!("{path}/trace"),
            aligned: format!("{path}/aligned"),
            warped: format!("{path}/warped"),
            report: format!("{path}/report"),
            job: path,
        }
    }
}
