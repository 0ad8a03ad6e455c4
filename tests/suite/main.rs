//! All integration tests, in one binary.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stderr, clippy::print_stdout)]

mod cli;
mod data;
mod formats;
mod intake;
mod phantom;
mod real_data;
mod real_pairs;
mod tidy;
