//! `/v1/studies/{id}/subjects`: the subjects of a study, and the decisions about them.

use super::studies::{CHANGE_MEMORY, OUTLINE_MEMORY, accepted, body, checked, counted, definition_memory};
use super::{DEFAULT_PAGE, MAX_PAGE, small_json, study_id};
use crate::http::auth::{Reader, Submitter};
use crate::http::problem::{FieldError, Problem, ProblemDocument};
use crate::http::problem_table::ProblemKind;
use crate::http::query::QueryString;
use crate::http::router::HttpState;
use crate::http::shares::Origin;
use crate::http::study_wire::{
    AddedSubjectsDocument, AddedSubjectsForm, DecisionDocument, StudyDocument, StudySubjectListDocument,
    StudySubjectStateDocument,
};
use crate::http::upload::Tap;
use crate::jobs::JobError;
use axum::extract::{Path, Request, State};
use axum::response::Response;

/// Longest reason of a decision, bytes.
const MAX_REASON: usize = 1000;

/// List the subjects of a study
///
/// In the order in which they were added, with what was decided about them; without their covariates, which the result has.
#[utoipa::path(
    get, path = "/v1/studies/{id}/subjects", tag = "studies", operation_id = "list_study_subjects",
    params(
        ("id" = String, Path, description = "The study"),
        ("page_size" = Option<u32>, Query, minimum = 1, maximum = 500, description = "Maximum number of entries; 50 if absent"),
        ("page_token" = Option<String>, Query, description = "`next_page_token` of the previous page"),
    ),
    responses(
        (status = 200, description = "A page", body = StudySubjectListDocument),
        (status = 400, description = "Invalid query parameters", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The study was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn list(
    State(state): State<HttpState>,
    Reader(tenant): Reader,
    origin: Origin,
    Path(id): Path<String>,
    mut query: QueryString,
) -> Result<Response, Problem> {
    let size = query.number("page_size", 1..=MAX_PAGE).unwrap_or(DEFAULT_PAGE) as usize;
    let token = query.text("page_token").filter(|token| !token.is_empty());
    let first = token.as_deref().map_or(Some(0), place_of);
    if first.is_none() {
        query.fault("page_token", "out_of_range", "must be a next_page_token of an earlier answer");
    }
    query.finish()?;
    let (id, first) = (study_id(&id)?, first.unwrap_or(0));
    let memory = definition_memory(&state, &tenant, origin, id, OUTLINE_MEMORY).await?;
    let outline = state.service.study_outline(&tenant, id, first..first.saturating_add(size)).await?;
    let outline = outline.ok_or(JobError::Gone)?;
    let next = first + outline.subjects.len();
    let next_page_token = (next < outline.n_subjects).then(|| token_of(next));
    let subjects = outline.subjects.iter().map(StudySubjectStateDocument::of).collect();
    let page = StudySubjectListDocument { subjects, next_page_token };
    Ok(counted(serde_json::to_vec(&page).map_err(|error| Problem::internal(&error))?, memory))
}

/// The token of a page that begins at a position. Subjects are only added at the end, so a position keeps its subject.
fn token_of(place: usize) -> String {
    format!("{place:x}.subject")
}

/// The position at which the page of a token begins; only the issued spelling is accepted.
fn place_of(token: &str) -> Option<usize> {
    let place = usize::from_str_radix(token.strip_suffix(".subject")?, 16).ok()?;
    (token_of(place) == token).then_some(place)
}

/// Add subjects to a study
///
/// Each costs one match; the template is kept. The study goes on, also from a final state.
#[utoipa::path(
    post, path = "/v1/studies/{id}/subjects", tag = "studies", operation_id = "add_study_subjects",
    params(("id" = String, Path, description = "The study")),
    request_body(content((AddedSubjectsForm = "multipart/form-data"), (AddedSubjectsDocument = "application/json"))),
    responses(
        (status = 202, description = "Accepted", body = StudyDocument, headers(
            ("Location" = String, description = "The study"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such study", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 408, description = "The body took too long to arrive", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The study was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 413, description = "More subjects than a study can have, or a body beyond the limits", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Neither multipart nor JSON, or an unknown file format", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields or inputs", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 429, description = "The queue is full", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn add(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    Path(id): Path<String>,
    query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let origin = Origin::of(request.extensions());
    let (request, tap) = Tap::on(request, state.limits.max_body_bytes());
    let taken = async {
        query.finish()?;
        let id = study_id(&id)?;
        let (AddedSubjectsDocument { subjects }, files) = body(&state, &tenant, request, &tap).await?;
        if subjects.is_empty() {
            let fault = FieldError::new("/subjects", "missing", "at least one subject is required");
            return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]));
        }
        let subjects = checked(subjects, &files, &state, Vec::new())?;
        let _memory = definition_memory(&state, &tenant, origin, id, CHANGE_MEMORY).await?;
        Ok(state.service.add_subjects(&tenant, id, subjects).await?)
    };
    let taken = taken.await;
    Ok(accepted(&tap.settle(taken).await?))
}

/// Decide about a subject
///
/// A subject that is kept stays in the model and the statistics whatever its match looks like; one that is dropped is left out.
/// The study is computed again, without a match.
#[utoipa::path(
    put, path = "/v1/studies/{id}/subjects/{subject}/decision", tag = "studies", operation_id = "decide_study_subject",
    params(("id" = String, Path, description = "The study"), ("subject" = String, Path, description = "Id of the subject")),
    request_body = DecisionDocument,
    responses(
        (status = 202, description = "Recorded; the study is computed again", body = StudyDocument, headers(
            ("Location" = String, description = "The study"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 400, description = "The body is malformed", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 404, description = "No such study, or it has no such subject", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The study was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 415, description = "Not JSON", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 422, description = "Invalid fields", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn decide(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    origin: Origin,
    Path((id, subject)): Path<(String, String)>,
    query: QueryString,
    request: Request,
) -> Result<Response, Problem> {
    let DecisionDocument { decision, reason } = small_json(&state, &tenant, request, query).await?;
    if reason.len() > MAX_REASON || reason.chars().any(char::is_control) {
        let detail = format!("must have at most {MAX_REASON} bytes and no control characters");
        let fault = FieldError::new("/reason", "out_of_range", detail);
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]));
    }
    let id = study_id(&id)?;
    let _memory = definition_memory(&state, &tenant, origin, id, CHANGE_MEMORY).await?;
    let study = state.service.decide(&tenant, id, &subject, Some((decision, reason))).await?;
    Ok(accepted(&study))
}

/// Take back a decision about a subject
///
/// The study is computed again, without a match.
#[utoipa::path(
    delete, path = "/v1/studies/{id}/subjects/{subject}/decision", tag = "studies", operation_id = "undecide_study_subject",
    params(("id" = String, Path, description = "The study"), ("subject" = String, Path, description = "Id of the subject")),
    responses(
        (status = 202, description = "Taken back; the study is computed again", body = StudyDocument, headers(
            ("Location" = String, description = "The study"), ("Retry-After" = u32, description = "Suggested delay before the next request, s"))),
        (status = 404, description = "No such study, or it has no such subject", body = ProblemDocument, content_type = "application/problem+json"),
        (status = 410, description = "The study was deleted at the end of its retention time", body = ProblemDocument, content_type = "application/problem+json"),
    )
)]
pub(crate) async fn undecide(
    State(state): State<HttpState>,
    Submitter(tenant): Submitter,
    origin: Origin,
    Path((id, subject)): Path<(String, String)>,
    query: QueryString,
) -> Result<Response, Problem> {
    query.finish()?;
    let id = study_id(&id)?;
    let _memory = definition_memory(&state, &tenant, origin, id, CHANGE_MEMORY).await?;
    Ok(accepted(&state.service.decide(&tenant, id, &subject, None).await?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_round_trip_and_others_are_refused() {
        for place in [0, 1, 500, usize::MAX] {
            assert_eq!(place_of(&token_of(place)), Some(place));
        }
        for nonsense in
            ["", ".subject", "1", "+1.subject", "01.subject", "A.subject", "-1.subject", "1ffffffffffffffff.subject"]
        {
            assert_eq!(place_of(nonsense), None, "{nonsense}");
        }
    }
}
