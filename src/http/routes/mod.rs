//! The handlers, one file for each resource.

pub(crate) mod batches;
pub(crate) mod changes;
pub(crate) mod docs;
pub(crate) mod events;
pub(crate) mod files;
pub(crate) mod jobs;
pub(crate) mod keys;
pub(crate) mod meshes;
pub(crate) mod methods;
pub(crate) mod result;
pub(crate) mod studies;
pub(crate) mod study_scores;
pub(crate) mod study_subjects;
pub(crate) mod surfaces;
pub(crate) mod system;
pub(crate) mod tenant_events;
pub(crate) mod tickets;
pub(crate) mod trace;
pub(crate) mod webhooks;

use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use super::query::QueryString;
use super::router::{HttpState, IN_MEMORY};
use super::shares::Origin;
use super::submission::{ALLOWED_PRIORITIES, PRIORITIES, media_type, read_json};
use super::upload::Tap;
use crate::jobs::job::Cursor;
use crate::jobs::{BatchId, JobId, StudyId, Tenant};
use axum::extract::Request;
use serde::de::DeserializeOwned;

/// Entries of a page by default.
const DEFAULT_PAGE: u32 = 50;
/// Most entries of a page.
const MAX_PAGE: u32 = 500;
/// Largest body of a request with a small document, bytes.
const MAX_SMALL_BODY: usize = 64 << 10;

/// The job that a path names; a text that cannot be an id names none.
fn job_id(text: &str) -> Result<JobId, Problem> {
    JobId::parse(text).ok_or_else(|| Problem::new(ProblemKind::JobNotFound))
}

/// The batch that a path names.
fn batch_id(text: &str) -> Result<BatchId, Problem> {
    BatchId::parse(text).ok_or_else(|| Problem::new(ProblemKind::BatchNotFound))
}

/// The study that a path names.
fn study_id(text: &str) -> Result<StudyId, Problem> {
    StudyId::parse(text).ok_or_else(|| Problem::new(ProblemKind::StudyNotFound))
}

/// Refuses a priority that is not allowed.
fn check_priority(priority: i32) -> Result<(), Problem> {
    if PRIORITIES.contains(&priority) {
        return Ok(());
    }
    let fault = FieldError::new("/priority", "out_of_range", ALLOWED_PRIORITIES);
    Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]))
}

/// Size and start of a page, from `page_size` and `page_token`.
fn page(query: &mut QueryString) -> (u32, Option<Cursor>) {
    let size = query.number("page_size", 1..=MAX_PAGE).unwrap_or(DEFAULT_PAGE);
    let token = query.text("page_token").filter(|token| !token.is_empty());
    let after = token.as_deref().and_then(Cursor::from_token);
    if token.is_some() && after.is_none() {
        query.fault("page_token", "out_of_range", "must be a next_page_token of an earlier answer");
    }
    (size, after)
}

/// The document in the JSON body of a request that is small and has no query.
async fn small_json<T: DeserializeOwned>(
    state: &HttpState,
    tenant: &Tenant,
    request: Request,
    query: QueryString,
) -> Result<T, Problem> {
    let (request, tap) = Tap::on(request, MAX_SMALL_BODY);
    let read = async {
        query.finish()?;
        if media_type(&request) != "application/json" {
            return Err(Problem::new(ProblemKind::UnsupportedMediaType));
        }
        state.begin_reading(&tap, tenant, Origin::of(request.extensions()), IN_MEMORY).await?;
        read_json(request, &tap, &state.limits, MAX_SMALL_BODY).await
    };
    let read = read.await;
    tap.settle(read).await
}
