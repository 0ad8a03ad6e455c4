//! Where jobs and blobs are kept: behind the ports of [`crate::jobs`].
//!
//! [`sql`] holds jobs in SQLite or PostgreSQL, [`artifacts`] the blobs in a folder or an S3-compatible store,
//! [`presence`] tells living processes of one machine from dead ones.

pub mod artifacts;
pub mod presence;
pub mod sql;
