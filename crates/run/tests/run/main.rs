//! From the bytes of two files to the result: intake, and matches of phantoms and of real data.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout)]

mod field_files;
#[path = "../../../../tests/fixtures/mod.rs"]
#[allow(dead_code, reason = "each test binary uses a part of it")]
mod fixtures;
mod formats;
mod intake;
mod mirrors;
mod pairs;
mod progress;
mod structures;
mod warnings;
