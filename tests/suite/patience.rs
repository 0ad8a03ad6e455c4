//! How long tests wait.
//!
//! No test asserts an absolute duration: a busy or slow machine must not fail it. What has to happen "at once" is compared with
//! the time that the alternative takes in the same run: the end of a wait, of a grace period, or of a job.

use std::time::Duration;

/// How long a test waits for what must happen. Bounds a hang, and nothing else.
pub(crate) const PATIENCE: Duration = Duration::from_secs(240);

/// The longest wait that a request may ask for, s.
pub(crate) const WAIT_S: u32 = 30;

/// An answer that comes earlier than this did not wait for the end of [`WAIT_S`].
pub(crate) const BEFORE_ITS_END: Duration = Duration::from_secs(WAIT_S as u64 / 2);
