//! All integration tests, in one binary.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod api;
mod contract;
mod jobs;
mod jobs_support;
mod process;
mod store;
