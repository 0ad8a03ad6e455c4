//! Where jobs and blobs are kept: behind the ports of [`crate::jobs`].
//!
//! [`sqlite`] holds jobs on one machine, [`artifacts`] the blobs, [`presence`] tells living processes from dead ones.

pub mod artifacts;
pub mod presence;
pub mod sqlite;
