//! The handlers, a file a resource.

pub mod docs;
pub mod jobs;
pub mod methods;
pub mod result;
pub mod surfaces;
pub mod system;
pub mod trace;

use super::problem::Problem;
use super::problem_table::ProblemKind;
use crate::jobs::{JobId, Tenant};

/// Whose request it is. Without authentication there is one tenant.
fn tenant() -> Tenant {
    Tenant::default()
}

/// The job that a path names; what cannot be an id names none.
fn job_id(text: &str) -> Result<JobId, Problem> {
    JobId::parse(text).ok_or_else(|| Problem::new(ProblemKind::JobNotFound))
}
