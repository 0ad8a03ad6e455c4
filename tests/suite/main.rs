//! All integration tests, in one binary.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stderr, clippy::print_stdout)]

mod api;
mod cli;
mod contract;
mod deploy;
mod docs;
mod faults;
mod formats;
mod intake;
mod jobs;
mod jobs_support;
mod keys;
mod long_polls;
mod metrics;
mod numbering;
mod phantom;
mod process;
mod real_data;
mod real_pairs;
mod real_structures;
mod representations;
mod scheduling;
mod server;
mod service;
mod store;
mod store_records;
mod tidy;
mod webhooks;
