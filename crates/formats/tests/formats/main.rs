//! Files of every format: variants, dialects, damage, and the memory that reading takes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout)]
#![allow(unsafe_code, reason = "an allocator that counts can only be written so")]

mod counting;
mod dialects;
mod files;
#[path = "../../../../tests/fixtures/mod.rs"]
#[allow(dead_code, reason = "each test binary uses a part of it")]
mod fixtures;
mod formats;
mod hostile;
mod memory;
mod samples;
