//! All integration tests of the program, in one binary. Tests of a library crate are in its own `tests` folder.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stderr, clippy::print_stdout)]

mod api;
mod audit;
mod backups;
mod browsers;
mod cli;
mod clients;
mod command_line;
mod contract;
mod dashboard;
mod deploy;
mod dicom;
mod docs;
mod encryption;
mod energy_trace;
mod examples;
mod faults;
mod field_inputs;
mod field_readers;
#[path = "../fixtures/mod.rs"]
#[allow(dead_code, reason = "each test binary uses a part of it")]
mod fixtures;
mod hostile;
mod inputs_and_tags;
mod isolation;
mod jobs;
mod jobs_support;
mod keys;
mod labels;
mod layout;
mod long_polls;
mod metrics;
mod numbering;
mod orthanc;
mod patience;
mod phantom;
mod process;
mod prometheus;
mod promises;
mod refusals;
mod representations;
mod rights;
mod runbook;
mod scheduling;
mod schemathesis;
mod server;
mod service;
#[path = "../fixtures/solids.rs"]
mod solids;
#[path = "../layout/mod.rs"]
mod source_tree;
mod spans;
mod store;
mod store_records;
mod studies;
mod study_labels;
mod study_questions;
mod study_scores;
mod study_service;
mod study_structures;
mod supply;
mod tickets;
mod tidy;
mod tls;
mod tokens;
mod webhooks;
