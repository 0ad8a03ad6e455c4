//! Storage, behind the ports of [`crate::jobs`].
//!
//! [`sql`] stores jobs in SQLite or PostgreSQL, [`artifacts`] stores blobs in a folder or an S3-compatible store,
//! [`backup`] copies a database and a folder while they are in use, and [`processes`] records which processes of one
//! machine are alive. [`seal`] encrypts secrets, [`keyring`] holds the keys for blobs and secrets, [`encryption`]
//! rotates them, `layout` names the files of a data directory, `private_files` keeps files from other users, `space` remembers that a store was full, and `reserve` keeps some
//! space for that case.

pub mod artifacts;
pub mod backup;
pub mod encryption;
pub mod keyring;
pub(crate) mod layout;
pub(crate) mod private_files;
pub(crate) mod processes;
pub(crate) mod reserve;
pub mod seal;
mod space;
pub mod sql;
