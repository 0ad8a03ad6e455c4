//! `/v1/studies/{id}/score` and `/v1/studies/{id}/scores`: new subjects against the group of a study.

use super::studies::{CHANGE_MEMORY, body, definition_memory};
use super::{job_id, study_id};
use crate::http::auth::{Reader, Submitter};
use crate::http::content::{Wanted, streamed, wanted};
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::shares::Origin;
use crate::http::study_score_wire::{ScoreForm, ScoreGroupDocument, ScoreSubmissionDocument, StudyScoreDocument};
use crate::http::submission::{SentDetails, check_details, referred};
use crate::http::upload::Tap;
use crate::http::wire::JobDocument;
use crate::jobs::study::ScoreQuestions;
use crate::jobs::{Accepted, Job, ScoreSubmission, Tenant};
use axum::Json;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, Method, StatusCode, header};
use axum::response::{IntoResponse, Response};

/// Longest name of a covariate or a level, bytes.
const MAX_NAME: usize = 200;

/// Score a new subject against a study
///
/// One request for each subject: its surface or label volume is matched to the template of a finished study and compared with the
/// members of its model, or with those of one level of a covariate. The study does not change. The answer is a job, which is
/// followed, cancelled and deleted like any other; both of its inputs are the subject. When it has succeeded, `links.score` is its
/// score.
#[utoipa::path(
    post, path = "/v1/studies/{id}/score", tag = "studies", operation_id = "score_study_subject",
    params(
        ("id" = String, Path, description = "The study"),
        ("Idempotency-Key" = Option<String>, Header, description = "1 to 128 visible ASCII characters"),
    ),
    request_body(content((ScoreForm = "multipart/form-data"), (ScoreSubmissionDocument = "application/json"))),
    responses(
        (status = 202, description = "Accepted", body = JobDocument, headers(
            ("Location" = String, description = "The job"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such study or mesh", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 408, description = "The body took too long to arrive", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The study is not finished, or a request with the same Idempotency-Key is in progress", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The study was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "Beyond the limits", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Neither multipart nor JSON, or an unknown file format", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields or input, or an Idempotency-Key that was used for another request", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue is full", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 507, description = "Out of storage space", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn submit(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let headers = request.headers().clone();
    let (request, tap) = Tap::on(request, state.limits.max_body_bytes());
    let taken = match query.finish() {
        Ok(()) => take(&state, tenant, &id, request, &tap, &headers).await,
        Err(problem) => Err(problem),
    };
    let Accepted { made, replayed } = tap.settle(taken).await?;
    Ok(marked(accepted(&made), replayed))
}

async fn take(
    state: &HttpState,
    tenant: Tenant,
    id: &str,
    request: Request,
    tap: &Tap,
    headers: &HeaderMap,
) -> Result<Accepted<Job>, Problem> {
    let (study, idempotency_key) = (study_id(id)?, idempotency_key(headers)?);
    let origin = Origin::of(request.extensions());
    let (document, files): (ScoreSubmissionDocument, _) = body(state, &tenant, request, tap).await?;
    let ScoreSubmissionDocument { input, group, side, labels, tags, external_ref, priority, max_run_s } = document;
    let details = SentDetails {
        tags,
        labels: Default::default(),
        external_ref,
        priority,
        deadline_at: None,
        max_run_s,
        use_cache: None,
    };
    let (_, mut details) = check_details(None, details, &state.limits, state.service.limits())?;
    details.traceparent = traceparent(headers);
    let invalid = |faults: &[FieldError]| Problem::new(ProblemKind::InvalidRequest).errors(faults);
    if let Some(fault) = group.as_ref().and_then(group_fault) {
        return Err(invalid(&[fault]));
    }
    let input = referred("input", input, &files, &state.limits).map_err(|faults| invalid(&faults))?;
    let group = group.map(|group| (group.covariate, group.level));
    let asked = ScoreQuestions { side, labels, group };
    let _memory = definition_memory(state, &tenant, origin, study, CHANGE_MEMORY).await?;
    let submission = ScoreSubmission { tenant, study, input, asked, details, idempotency_key };
    Ok(state.service.submit_score(submission).await?)
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

/// 202 with the job.
fn accepted(job: &Job) -> Response {
    let document = JobDocument::from(job);
    let headers = [(header::LOCATION, document.links.job.clone()), (header::RETRY_AFTER, "1".to_owned())];
    (StatusCode::ACCEPTED, headers, Json(document)).into_response()
}

/// Get the score of a new subject
///
/// Its score at every vertex of the template, the regions beyond the bound of left-out members, and how unusual its shape is.
#[utoipa::path(
    get, path = "/v1/studies/{id}/scores/{job}", tag = "studies", operation_id = "get_study_score",
    params(
        ("id" = String, Path, description = "The study"),
        ("job" = String, Path, description = "The job that scores the subject"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of an earlier answer"),
    ),
    responses(
        (status = 200, description = "The score", body = StudyScoreDocument, headers(("ETag" = String, description = "Pass it as `If-None-Match`"))),
        (status = 304, description = "Not modified since the version that `If-None-Match` names"),
        (status = 404, description = "No such job of this study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 409, description = "The job is not finished, or finished without a result", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The result was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn get(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    Path((id, job)): Path<(String, String)>,
    method: Method,
    headers: HeaderMap,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let found = state.service.study_score(&tenant, study_id(&id)?, job_id(&job)?).await?;
    let etag = format!("\"{}\"", &found.key.hash()[..32]);
    Ok(match wanted(&method, &headers, &etag, found.n_bytes) {
        Wanted::Nothing(response) => *response,
        Wanted::Content { range, with_body } => {
            let stream = if with_body { Some(state.service.open(&found, range.clone()).await?) } else { None };
            streamed(&headers, &etag, "application/json", found.n_bytes, range.as_ref(), stream)
        }
    })
}
