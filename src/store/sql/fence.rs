//! The fence of a lease: writes of a worker under an epoch that is not the current one are refused.

use super::argument::bind;
use super::database::Session;
use super::dialect::sql;
use crate::jobs::{JobError, Lease};

/// The fence: returns [`JobError::LeaseLost`] unless the job is running under exactly this epoch; its row stays locked
/// until the transaction ends. Returns whether its cancellation was requested.
pub(super) async fn lock_lease(session: &mut Session, lease: &Lease) -> Result<bool, JobError> {
    let held: Option<bool> = session.value(sql!("lock_lease"), bind![lease.job_id, lease.epoch]).await?;
    held.ok_or(JobError::LeaseLost)
}
