//! All integration tests, in one binary.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stderr, clippy::print_stdout)]

mod api;
mod cli;
mod contract;
mod docs;
mod faults;
mod deploy;
mod formats;
mod intake;
mod jobs;
mod jobs_support;
mod phantom;
mod process;
mod real_data;
mod real_pairs;
mod representations;
mod server;
mod store;
mod tidy;
