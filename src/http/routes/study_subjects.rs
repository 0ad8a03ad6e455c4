//! `/v1/studies/{id}/subjects`: the subjects of a study, and the decisions about them.

use super::studies::{CHANGE_MEMORY, OUTLINE_MEMORY, accepted_study, checked, counted, definition_memory};
use crate::http::call::AuthorizedRequest;
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::study_wire::{
    AddedSubjectsDocument, AddedSubjectsForm, DecisionDocument, StudyDocument, StudySubjectListDocument,
    StudySubjectStateDocument,
};
use crate::http::upload::LimitedBody;
use crate::jobs::{JobError, StudyId};
use axum::extract::Request;
use axum::response::Response;

/// Longest reason of a decision, bytes.
const MAX_REASON: usize = 1000;

/// List the subjects of a study
///
/// In the order in which they were added, with what was decided about them; without their covariates, which the result has.
#[utoipa::path(
    get, path = "/v1/studies/{id}/subjects",
    responses((status = 200, description = "A page", body = StudySubjectListDocument))
)]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let (size, first) = call.page(place_of);
    let (id, first) = (call.last_id()?, first.unwrap_or(0));
    let memory = definition_memory(&call, id, OUTLINE_MEMORY).await?;
    let outline = call.service().study_outline(&call.tenant, id, first..first.saturating_add(size as usize)).await?;
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
    post, path = "/v1/studies/{id}/subjects",
    request_body(content((AddedSubjectsForm = "multipart/form-data"), (AddedSubjectsDocument = "application/json"))),
    responses((status = 202, description = "Accepted", body = StudyDocument))
)]
pub(crate) async fn add(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let (request, tap) = LimitedBody::on(request, call.state.limits.max_body_bytes());
    let taken = async {
        call.query.finish()?;
        let id = call.id()?;
        let (AddedSubjectsDocument { subjects }, files) = call.document(request, &tap).await?;
        if subjects.is_empty() {
            let fault = FieldError::new("/subjects", "missing", "at least one subject is required");
            return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]));
        }
        let subjects = checked(subjects, &files, &call.state, Vec::new())?;
        let _memory = definition_memory(&call, id, CHANGE_MEMORY).await?;
        Ok(call.service().add_subjects(&call.tenant, id, subjects).await?)
    };
    Ok(accepted_study(&tap.settle(taken).await?))
}

/// Decide about a subject
///
/// A subject that is kept stays in the model and the statistics whatever its match looks like; one that is dropped is left out.
/// The study is computed again, without a match.
#[utoipa::path(
    put, path = "/v1/studies/{id}/subjects/{subject}/decision",
    params(("subject" = String, Path, description = "Id of the subject")),
    request_body = DecisionDocument,
    responses((status = 202, description = "Recorded; the study is computed again", body = StudyDocument))
)]
pub(crate) async fn decide(mut call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let DecisionDocument { decision, reason } = call.small_json(request).await?;
    if reason.len() > MAX_REASON || reason.chars().any(char::is_control) {
        let detail = format!("must have at most {MAX_REASON} bytes and no control characters");
        let fault = FieldError::new("/reason", "out_of_range", detail);
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]));
    }
    let id = call.id()?;
    let _memory = definition_memory(&call, id, CHANGE_MEMORY).await?;
    let study = call.service().decide(&call.tenant, id, call.segment(1), Some((decision, reason))).await?;
    Ok(accepted_study(&study))
}

/// Take back a decision about a subject
///
/// The study is computed again, without a match.
#[utoipa::path(
    delete, path = "/v1/studies/{id}/subjects/{subject}/decision",
    params(("subject" = String, Path, description = "Id of the subject")),
    responses((status = 202, description = "Taken back; the study is computed again", body = StudyDocument))
)]
pub(crate) async fn undecide(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let id: StudyId = call.last_id()?;
    let _memory = definition_memory(&call, id, CHANGE_MEMORY).await?;
    Ok(accepted_study(&call.service().decide(&call.tenant, id, call.segment(1), None).await?))
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
