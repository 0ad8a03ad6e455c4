//! Calls to a store that are repeated while it does not answer.

use crate::jobs::JobError;
use std::future::Future;
use std::time::{Duration, Instant};
use tokio::time::sleep;

/// How long calls to a store that does not answer are repeated. After this time the lease expires and the job runs
/// again.
const STORE_TIMEOUT: Duration = Duration::from_secs(60);

/// Repeats `work` while the store does not answer, for up to [`STORE_TIMEOUT`].
pub(super) async fn retrying<T, F: Future<Output = Result<T, JobError>>>(work: impl Fn() -> F) -> Result<T, JobError> {
    let began = Instant::now();
    let mut wait = Duration::from_millis(50);
    loop {
        match work().await {
            Err(error) if is_transient(&error) && began.elapsed() < STORE_TIMEOUT => {
                sleep(wait).await;
                wait = (wait * 2).min(Duration::from_secs(2));
            }
            done => return done,
        }
    }
}

/// Whether the same call may succeed later.
pub(super) fn is_transient(error: &JobError) -> bool {
    matches!(error, JobError::Unavailable(_) | JobError::StorageFull | JobError::BeingRemoved)
}
