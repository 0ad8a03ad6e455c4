//! All integration tests of the program, in one binary. Those of a library crate are in its own `tests` folder.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stderr, clippy::print_stdout)]

mod api;
mod audit;
mod backups;
mod cli;
mod contract;
mod deploy;
mod docs;
mod faults;
mod field_readers;
mod hostile;
mod jobs;
mod jobs_support;
mod keys;
mod long_polls;
mod metrics;
mod numbering;
mod orthanc;
mod phantom;
mod process;
mod prometheus;
mod promises;
mod representations;
mod runbook;
mod scheduling;
mod schemathesis;
mod server;
mod service;
mod spans;
mod store;
mod store_records;
mod supply;
mod tidy;
mod tokens;
mod webhooks;
