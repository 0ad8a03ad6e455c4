//! `/v1/studies`: studies of groups of subjects.

use super::{NAMED_FAULTS, accepted, check_priority, taken};
use crate::http::call::{AuthorizedRequest, PageOf};
use crate::http::content::{Counted, Stored};
use crate::http::fields::Fields;
use crate::http::long_poll::{Resource, Snapshot, Version, Watched, watch};
use crate::http::preferences::{idempotency_key, marked, traceparent};
use crate::http::problem::{FieldError, Problem};
use crate::http::problem_table::ProblemKind;
use crate::http::representation::as_page;
use crate::http::shares::SharePermit;
use crate::http::state::HttpState;
use crate::http::study_wire::{
    StudyChangeDocument, StudyDocument, StudyForm, StudyListDocument, StudyProgressDocument, StudyResultDocument,
    StudySubjectDocument, StudySubmissionDocument,
};
use crate::http::submission::{SentFiles, check_options, referred};
use crate::http::upload::LimitedBody;
use crate::jobs::follow::Feed;
use crate::jobs::job::Cursor;
use crate::jobs::study_submission::{StudySubmission, SubmittedSubject};
use crate::jobs::{Accepted, ArtifactKind, Study, StudyId};
use async_trait::async_trait;
use axum::Json;
use axum::body::Body;
use axum::extract::Request;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::sync::Arc;

/// Longest id of a subject, bytes; file names contain the id.
const MAX_ID: usize = 200;
/// Subjects in the document of a study; the list of its subjects has the others.
const SHOWN_SUBJECTS: usize = 500;
/// Submit a study
///
/// A template, given or made from the group, is matched to every subject; from that come a shape model, statistics at every
/// vertex, volumes and labels, a list for quality control and a report. Inputs are uploads, by their ids, small files in
/// base64, or files of the form. What is asked and all inputs are checked before the answer. The matches are jobs, `GET /v1/jobs?study=ID`. The result
/// is that of `homolog study` with the same inputs, to the bit.
#[utoipa::path(
    post, path = "/v1/studies",
    request_body(content((StudyForm = "multipart/form-data"), (StudySubmissionDocument = "application/json"))),
    responses((status = 202, description = "Accepted", body = StudyDocument))
)]
pub(crate) async fn submit(call: AuthorizedRequest, request: Request) -> Result<Response, Problem> {
    let Accepted { made, replayed } = taken(call, request, take).await?;
    Ok(marked(accepted_study(&made), replayed))
}

async fn take(call: &AuthorizedRequest, request: Request, tap: &LimitedBody) -> Result<Accepted<Study>, Problem> {
    let AuthorizedRequest { state, tenant, headers, .. } = call;
    let idempotency_key = idempotency_key(headers)?;
    let (mut document, files): (StudySubmissionDocument, _) = call.document(request, tap).await?;
    let questions = document.questions();
    let (parameters, mut details) = check_options(document.take_options(), state)?;
    let StudySubmissionDocument { subjects, template, template_rounds, permutations, .. } = document;
    details.traceparent = traceparent(headers);
    let mut faults = Vec::new();
    for (name, is_right, allowed) in [
        ("template_rounds", template_rounds.is_none_or(|n| (1..=20).contains(&n)), "must be an integer from 1 to 20"),
        (
            "permutations",
            permutations.is_none_or(|n| (1..=1_000_000).contains(&n)),
            "must be an integer from 1 to 1000000",
        ),
        ("cycles", questions.cycles <= 1000, "must be an integer from 0 to 1000"),
    ] {
        if !is_right {
            faults.push(FieldError::new(format!("/{name}"), "out_of_range", allowed));
        }
    }
    let template = template.and_then(|template| match referred("template", template, &files, &state.limits) {
        Ok(template) => Some(template),
        Err(more) => {
            faults.extend(more);
            None
        }
    });
    let subjects = checked(subjects, &files, state, faults)?;
    let tenant = tenant.clone();
    let submission = StudySubmission { tenant, subjects, template, questions, parameters, details, idempotency_key };
    Ok(state.service.submit_study(submission).await?)
}

/// Subjects whose fields are within their limits.
pub(super) fn checked(
    subjects: Vec<StudySubjectDocument>,
    files: &SentFiles,
    state: &HttpState,
    mut faults: Vec<FieldError>,
) -> Result<Vec<SubmittedSubject>, Problem> {
    let mut taken = Vec::with_capacity(subjects.len());
    for (number, document) in subjects.into_iter().enumerate() {
        let StudySubjectDocument { id, input, subject, role, side, labels, structure, covariates } = document;
        if id.len() > MAX_ID {
            let detail = format!("must have at most {MAX_ID} characters");
            faults.push(FieldError::new(format!("/subjects/{number}/id"), "out_of_range", detail));
        }
        if structure.as_ref().is_some_and(|name| name.len() > MAX_ID) {
            let detail = format!("must have at most {MAX_ID} characters");
            faults.push(FieldError::new(format!("/subjects/{number}/structure"), "out_of_range", detail));
        }
        match referred(&format!("subjects/{number}/input"), input, files, &state.limits) {
            Ok(input) => {
                let (role, covariates) = (role.unwrap_or_default(), covariates.0);
                taken.push(SubmittedSubject { id, subject, role, side, labels, structure, covariates, input });
            }
            Err(more) => faults.extend(more),
        }
        if faults.len() >= NAMED_FAULTS {
            break;
        }
    }
    if faults.is_empty() { Ok(taken) } else { Err(Problem::new(ProblemKind::InvalidRequest).errors(&faults)) }
}

/// 202 with the study.
pub(super) fn accepted_study(study: &Study) -> Response {
    let document = StudyDocument::of(study, None);
    accepted(&document.links.study.clone(), document)
}

/// List studies
///
/// `fields` selects members of each entry, as in the list of jobs.
#[utoipa::path(get, path = "/v1/studies", responses((status = 200, description = "A page", body = StudyListDocument)))]
pub(crate) async fn list(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let PageOf { size, after, fields } = call.last_page::<_, StudyDocument>(Cursor::from_token)?;
    let page = call.service().studies(&call.tenant, size, after).await?;
    let studies = page.studies.iter().map(|study| StudyDocument::of(study, None)).collect();
    let next_page_token = page.next.map(|cursor| cursor.to_token());
    fields.answer(&StudyListDocument { studies, next_page_token }, "studies")
}

/// Get a study
///
/// Its state, how far its matches are, and the first of its subjects with what was decided about them. `fields` selects members:
/// `?fields=id,state,progress` is enough to follow it. With `wait` the answer is delayed until the study has changed, as for a job; a
/// change of progress alone is answered one second after the request at the earliest. A study that has ended is answered at once.
#[utoipa::path(
    get, path = "/v1/studies/{id}",
    params(("fields" = Option<String>, Query, description = "Members to be answered, separated by commas; all if absent")),
    responses((status = 200, description = "The study", body = StudyDocument))
)]
pub(crate) async fn get(call: AuthorizedRequest) -> Result<Response, Problem> {
    watch::<StudyId, StudyDocument>(call, Fields::of).await
}

#[async_trait]
impl Resource for Watched<StudyId, StudyDocument> {
    type Seen = Study;

    async fn look(&self) -> Result<Snapshot, Problem> {
        let Watched { call, id, fields } = self;
        let memory = match fields.wants("subjects") || fields.wants("parameters") {
            true => Some(definition_memory(call, *id, OUTLINE_MEMORY).await?),
            false => None,
        };
        let study = call.service().study(&call.tenant, *id).await?;
        let places = 0..if fields.wants("subjects") { SHOWN_SUBJECTS } else { 0 };
        let outline = match memory {
            Some(_) => call.service().study_outline(&call.tenant, *id, places).await?,
            None => None,
        };
        let body = fields.json(&StudyDocument::of(&study, outline.as_ref()))?;
        Ok(Snapshot { version: version(&study)?, body, is_final: study.state.is_final(), memory })
    }

    async fn follow(&self) -> Result<Arc<Feed<Study>>, Problem> {
        Ok(self.call.service().follow_study(&self.call.tenant, self.id).await?)
    }

    fn version(&self, seen: &Study) -> Result<Version, Problem> {
        version(seen)
    }
}

/// What of a study counts as a change. Progress: its matches, and every revision, such as one with a decision. State: all else.
fn version(study: &Study) -> Result<Version, Problem> {
    let mut document = StudyDocument::of(study, None);
    let StudyProgressDocument { template_round, matches_done, matches_total } = std::mem::take(&mut document.progress);
    Version::of(&document, &(template_round, matches_done, matches_total, study.revision))
}

/// Change the priority of a study
///
/// Takes effect on its jobs that are queued and on those to come; what runs already goes on.
#[utoipa::path(
    patch, path = "/v1/studies/{id}",
    request_body = StudyChangeDocument,
    responses((status = 200, description = "Changed", body = StudyDocument))
)]
pub(crate) async fn update(mut call: AuthorizedRequest, request: Request) -> Result<Json<StudyDocument>, Problem> {
    let StudyChangeDocument { priority } = call.small_json(request).await?;
    check_priority(priority)?;
    let study = call.service().set_study_priority(&call.tenant, call.id()?, priority).await?;
    Ok(Json(StudyDocument::of(&study, None)))
}

const JSON: [(header::HeaderName, &str); 1] = [(header::CONTENT_TYPE, "application/json")];

/// A JSON answer whose memory is counted until it is sent.
pub(super) fn counted(json: Vec<u8>, memory: SharePermit) -> Response {
    (JSON, Body::new(Counted::new(json.into(), memory))).into_response()
}

/// Memory of a change to a definition for each stored byte: names, numbers and texts of covariates are separate
/// allocations, and a change holds the definition twice.
pub(super) const CHANGE_MEMORY: u64 = 64;
/// Memory of a page of subjects for each stored byte: the stored bytes, the decisions and the page.
pub(super) const OUTLINE_MEMORY: u64 = 4;

/// Memory for reading the definition of a study, `factor` times its stored size, taken before it is read.
pub(super) async fn definition_memory(
    call: &AuthorizedRequest,
    id: StudyId,
    factor: u64,
) -> Result<SharePermit, Problem> {
    let n_bytes = call.service().study_definition_bytes(&call.tenant, id).await?.saturating_mul(factor);
    call.memory(usize::try_from(n_bytes).unwrap_or(usize::MAX)).await
}

/// Delete a study
///
/// Deletes a finished study with its matches and everything that was found, and with those of its inputs that are no uploads.
#[utoipa::path(delete, path = "/v1/studies/{id}", responses((status = 204, description = "Deleted")))]
pub(crate) async fn delete(mut call: AuthorizedRequest) -> Result<StatusCode, Problem> {
    let id: StudyId = call.last_id()?;
    call.service().delete_study(&call.tenant, id).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Cancel a study
///
/// Cancels the study and its matches: queued ones at once, running ones within a second. What is finished is kept: when a
/// subject is added or a decision changes, the study goes on from there.
#[utoipa::path(
    post, path = "/v1/studies/{id}/cancel",
    responses((status = 202, description = "Cancelled", body = StudyDocument))
)]
pub(crate) async fn cancel(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let id: StudyId = call.last_id()?;
    Ok(accepted_study(&call.service().cancel_study(&call.tenant, id).await?))
}

/// Get the result of a study
///
/// The `study.json` that `homolog study` writes: subjects, settings, decisions, and under `found` the main figures.
#[utoipa::path(
    get, path = "/v1/studies/{id}/result",
    responses((status = 200, description = "The result", body = StudyResultDocument))
)]
pub(crate) async fn result(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    part(&mut call, ArtifactKind::StudyDocument, "application/json").await
}

/// Get the report of a study
///
/// One HTML page for people, which loads nothing from anywhere: quality control with pictures, maps and modes to turn with the
/// mouse, effects, the model, consistency, labels, and methods with versions and parameters. It contains the ids of the subjects.
#[utoipa::path(
    get, path = "/v1/studies/{id}/report",
    responses((status = 200, description = "The page", content((String = "text/html"))))
)]
pub(crate) async fn report(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    part(&mut call, ArtifactKind::StudyReport, "text/html; charset=utf-8").await.map(as_page)
}

/// Get everything that a study found
///
/// The folder that `homolog study` writes, as a zip archive: tables, surfaces, modes, maps, labels, the report, and the records of
/// the matches.
#[utoipa::path(
    get, path = "/v1/studies/{id}/archive",
    responses((status = 200, description = "The archive", content((String = "application/zip")), headers(("Content-Disposition" = String, description = "Suggested file name"))))
)]
pub(crate) async fn archive(mut call: AuthorizedRequest) -> Result<Response, Problem> {
    let mut response = part(&mut call, ArtifactKind::StudyArchive, "application/zip").await?;
    let name = format!("attachment; filename=\"homolog-study-{}.zip\"", call.id::<StudyId>()?);
    if let Ok(value) = HeaderValue::from_str(&name) {
        response.headers_mut().insert(header::CONTENT_DISPOSITION, value);
    }
    Ok(response)
}

/// A part of a study's result in its stored form, or a range of it.
async fn part(
    call: &mut AuthorizedRequest,
    kind: ArtifactKind,
    content_type: &'static str,
) -> Result<Response, Problem> {
    let id = call.last_id()?;
    let found = call.service().study_part(&call.tenant, id, kind).await?;
    let etag = format!("\"{}\"", &found.key.hash()[..32]);
    let stored = Stored { etag: &etag, content_type, n_bytes: found.n_bytes };
    stored.answer(call, |range| call.service().open(&found, range)).await
}
