//! Scores of new subjects against studies: one request for each subject, which changes nothing of the study.
//!
//! The job matches the subject to the study's template and compares it with the model of the study, as the study stands
//! when the job runs.

use super::admission::{IdempotencyKey, Made};
use super::artifact::{ArtifactKind, ArtifactRef};
use super::error::JobError;
use super::ids::{JobId, SCORE_METHOD, StudyId};
use super::job::{Job, NewJob, Tenant};
use super::service::JobService;
use super::study::{ScoreQuestions, StudyDefinition, StudyFault};
use super::study_state::StudyState;
use super::submission::{
    Accepted, CheckedInput, JobOptions, SubmitError, SubmittedInput, details_value, hash_of, input_value,
};
use serde_json::json;

/// A subject to be scored.
#[derive(Debug, Clone)]
pub struct ScoreSubmission {
    /// Owner of the study.
    pub tenant: Tenant,
    /// The study.
    pub study: StudyId,
    /// Its surface or label volume.
    pub input: SubmittedInput,
    /// Questions about the new subject.
    pub asked: ScoreQuestions,
    /// Everything else.
    pub details: JobOptions,
    /// The submitter's idempotency key.
    pub idempotency_key: Option<String>,
}

impl JobService {
    /// Accepts a subject to be scored: checks what is asked and its input, and stores its job.
    ///
    /// # Errors
    /// [`JobError::StudyNotReady`] before the study is finished; [`JobError::Gone`]; [`SubmitError`].
    pub async fn submit_score(&self, submission: ScoreSubmission) -> Result<Accepted<Job>, SubmitError> {
        let tenant = submission.tenant.clone();
        let print = hash_of(&json!([
            submission.study.to_string(),
            input_value(&submission.input),
            submission.asked,
            details_value(&submission.details)
        ]));
        let once = submission.idempotency_key.as_ref().map(|key| self.once(&tenant, key, print));
        if let Some(made) = self.begin_once(once.as_ref()).await? {
            let Made::Job(id) = made else { return Err(SubmitError::OtherRequest) };
            return Ok(Accepted { made: self.get(&tenant, id).await?, replayed: true });
        }
        let done = self.keeping(once.as_ref(), self.submit_score_once(submission, once.clone())).await;
        self.end_once(once.as_ref(), done).await.map(|made| Accepted { made, replayed: false })
    }

    async fn submit_score_once(
        &self,
        submission: ScoreSubmission,
        once: Option<IdempotencyKey>,
    ) -> Result<Job, SubmitError> {
        let ScoreSubmission { tenant, study: id, input, asked, details, .. } = submission;
        let study = self.study(&tenant, id).await?;
        if study.purged_at.is_some() {
            return Err(JobError::Gone.into());
        }
        if study.state != StudyState::Finished {
            return Err(JobError::StudyNotReady { state: study.state }.into());
        }
        let definition = self.study_definition(&tenant, id).await?.ok_or(JobError::Gone)?;
        self.engine.check_score(&definition, &asked).map_err(SubmitError::Study)?;
        self.refuse_when_full(&tenant).await?;
        let checked = self.check_subject(&tenant, input, &definition, &asked).await?;
        let record = checked.record();
        let definition = definition.with_scored(&asked, record.clone());
        self.engine.check_study_size(&definition).map_err(SubmitError::Pair)?;
        let job = NewJob {
            id: JobId::new(),
            tenant,
            method: SCORE_METHOD.to_owned(),
            method_version: study.method_version,
            parameters: json!({
                "method": SCORE_METHOD, "size": definition.size(), "score": asked, "match": definition.parameters
            }),
            // The template is in the files of the study.
            source: record.clone(),
            target: record,
            priority: details.priority,
            tags: details.tags,
            external_ref: details.external_ref,
            max_attempts: self.limits.max_attempts,
            deadline_at: details.deadline_at,
            max_run_ms: details.max_run_ms,
            retry_of: None,
            batch_id: None,
            study_id: Some(id),
            study_task: None,
            cache_key: None,
            use_cache: false,
            traceparent: details.traceparent,
        };
        self.store_job(job, vec![checked], once).await
    }

    /// Checks the input of a subject under the parameters of the study and its own labels.
    async fn check_subject(
        &self,
        tenant: &Tenant,
        input: SubmittedInput,
        definition: &StudyDefinition,
        asked: &ScoreQuestions,
    ) -> Result<CheckedInput, SubmitError> {
        let mut parameters = definition.parameters.clone();
        if let Some(labels) = &asked.labels {
            parameters["input"]["target"]["labels"] = json!(labels);
        }
        let fault =
            |pointer: &str, code: String, detail: String| StudyFault { pointer: pointer.to_owned(), code, detail };
        let resolved = self.engine.resolve(&parameters).map_err(|faults| {
            SubmitError::Study(faults.into_iter().map(|wrong| fault("/labels", wrong.code, wrong.detail)).collect())
        })?;
        match self.check(tenant, "target", input, &resolved).await {
            Err(SubmitError::Input { refusal, .. }) => {
                Err(SubmitError::Study(vec![fault("/input", refusal.code, refusal.detail)]))
            }
            checked => checked,
        }
    }

    /// The score of a subject, in the blob of its job.
    ///
    /// # Errors
    /// [`JobError::NotFound`] if the job scores no subject of this study; as for [`JobService::result_part`].
    pub async fn study_score(&self, tenant: &Tenant, study: StudyId, id: JobId) -> Result<ArtifactRef, JobError> {
        let job = self.get(tenant, id).await?;
        if job.study_id != Some(study) || !job.is_score() {
            return Err(JobError::NotFound);
        }
        self.result_part(tenant, id, ArtifactKind::StudyScore).await
    }
}
