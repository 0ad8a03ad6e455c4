//! `/v1/studies/{id}/score` and `/v1/studies/{id}/scores`: new subjects against the group of a study.

use super::studies::{CHANGE_MEMORY, definition_memory};
use super::{accepted, taken};
use crate::http::call::{AuthorizedRequest, ResourceId};
use crate::http::content::Stored;
use crate::http::options::SentOptions;
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::study_score_wire::{ScoreForm, ScoreGroupDocument, ScoreSubmissionDocument, StudyScoreDocument};
use crate::http::study_wire::Covariates;
use crate::http::submission::{check_options, referred};
use crate::http::upload::LimitedBody;
use crate::http::wire::JobDocument;
use crate::jobs::study::ScoreQuestions;
use crate::jobs::{Accepted, Job, JobId, ScoreSubmission, StudyId};
use axum::extract::Request;
use axum::response::Response;

/// Longest name of a covariate or a level, bytes.
const MAX_NAME: usize = 200;
/// Most covariates to adjust for.
const MAX_ADJUST: usize = 256;

/// Score a new subject against a study
///
/// One request for each subject: its surface or label volume is matched to the template of a finished study and compared with the
/// members of its model, or with those of one level of a covariate. The study does not change. The answer is a job, which is
/// followed, cancelled and deleted like any other; both of its inputs are the subject. When it has succeeded, `links.score` is its
/// score.
#[utoipa::path(
    post, path = "/v1/studies/{id}/score",
    request_body(content((ScoreForm = "multipart/form-data"), (ScoreSubmissionDocument = "application/json"))),
    responses((status = 202, description = "Accepted", body = JobDocument))
)]
pub(crate) async fn submit(call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let Accepted { made, replayed } = taken(call, request, take).await?;
    let document = JobDocument::from(&made);
    Ok(marked(accepted(&document.links.job.clone(), document), replayed))
}

async fn take(call: &AuthorizedRequest, request: Request, tap: &LimitedBody) -> Result<Accepted<Job>, Problem> {
    let (study, idempotency_key) = (call.id::<StudyId>()?, idempotency_key(&call.headers)?);
    let (document, files): (ScoreSubmissionDocument, _) = call.document(request, tap).await?;
    let ScoreSubmissionDocument {
        input,
        group,
        adjust,
        covariates,
        side,
        labels,
        tags,
        external_ref,
        priority,
        max_run_s,
    } = document;
    let options = SentOptions { tags, external_ref, priority, max_run_s, ..SentOptions::default() };
    let (_, mut details) = check_options(options, &call.state)?;
    details.traceparent = traceparent(&call.headers);
    let invalid = |faults: &[FieldError]| Problem::new(ProblemKind::InvalidRequest).errors(faults);
    if let Some(fault) = group.as_ref().and_then(group_fault).or_else(|| adjustment_fault(&adjust, &covariates)) {
        return Err(invalid(&[fault]));
    }
    let input = referred("input", input, &files, &call.state.limits).map_err(|faults| invalid(&faults))?;
    let group = group.map(|group| (group.covariate, group.level));
    let asked = ScoreQuestions { side, labels, group, adjust, covariates: covariates.0 };
    let _memory = definition_memory(call, study, CHANGE_MEMORY).await?;
    let tenant = call.tenant.clone();
    let submission = ScoreSubmission { tenant, study, input, asked, details, idempotency_key };
    Ok(call.service().submit_score(submission).await?)
}

fn group_fault(group: &ScoreGroupDocument) -> Option<FieldError> {
    for (name, text) in [("covariate", &group.covariate), ("level", &group.level)] {
        if text.is_empty() || text.len() > MAX_NAME {
            let detail = format!("must have 1 to {MAX_NAME} bytes");
            return Some(FieldError::new(format!("/group/{name}"), "out_of_range", detail));
        }
    }
    None
}

/// These names and values are stored in the row of the job, so they are short.
fn adjustment_fault(adjust: &[String], covariates: &Covariates) -> Option<FieldError> {
    if adjust.len() > MAX_ADJUST {
        let detail = format!("must have at most {MAX_ADJUST} covariates");
        return Some(FieldError::new("/adjust", "out_of_range", detail));
    }
    let is_long = |text: &String| text.len() > MAX_NAME;
    let detail = || format!("must have at most {MAX_NAME} bytes");
    if let Some(k) = adjust.iter().position(is_long) {
        return Some(FieldError::new(format!("/adjust/{k}"), "out_of_range", detail()));
    }
    let is_short = covariates.0.iter().all(|(name, value)| !is_long(name) && !is_long(value));
    (!is_short).then(|| FieldError::new("/covariates", "out_of_range", detail()))
}

/// Get the score of a new subject
///
/// Its score at every vertex of the template, the regions beyond the bound of left-out members, and how unusual its shape is.
#[utoipa::path(
    get, path = "/v1/studies/{id}/scores/{job}",
    params(("job" = String, Path, description = "The job that scores the subject")),
    responses((status = 200, description = "The score", body = StudyScoreDocument))
)]
pub(crate) async fn get(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let study: StudyId = call.last_id()?;
    let job = JobId::parse(call.segment(1)).ok_or_else(|| Problem::new(<JobId as ResourceId>::NOT_FOUND))?;
    let found = call.service().study_score(&call.tenant, study, job).await?;
    let etag = format!("\"{}\"", &found.key.hash()[..32]);
    let stored = Stored { etag: &etag, content_type: "application/json", n_bytes: found.n_bytes };
    stored.answer(&call, |range| call.service().open(&found, range)).await
}
