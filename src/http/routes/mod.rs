//! The handlers, a file a resource.

pub mod batches;
pub mod changes;
pub mod docs;
pub mod events;
pub mod jobs;
pub mod meshes;
pub mod methods;
pub mod result;
pub mod surfaces;
pub mod system;
pub mod trace;
pub mod webhooks;

use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::query::QueryString;
use crate::jobs::job::Cursor;
use crate::jobs::{BatchId, JobId};

/// Entries of a page, unless asked for otherwise.
const DEFAULT_PAGE: u32 = 50;
/// Most entries of a page.
const MAX_PAGE: u32 = 500;

/// The job that a path names; what cannot be an id names none.
fn job_id(text: &str) -> Result<JobId, Problem> {
    JobId::parse(text).ok_or_else(|| Problem::new(ProblemKind::JobNotFound))
}

/// The batch that a path names.
fn batch_id(text: &str) -> Result<BatchId, Problem> {
    BatchId::parse(text).ok_or_else(|| Problem::new(ProblemKind::BatchNotFound))
}

/// Size of a page and where it begins, from `page_size` and `page_token`.
fn page(query: &mut QueryString) -> (u32, Option<Cursor>) {
    let size = query.number("page_size", 1..=MAX_PAGE).unwrap_or(DEFAULT_PAGE);
    let token = query.text("page_token").filter(|token| !token.is_empty());
    let after = token.as_deref().and_then(Cursor::from_token);
    if token.is_some() && after.is_none() {
        query.fault("page_token", "out_of_range", "hand back a next_page_token as it was given");
    }
    (size, after)
}
