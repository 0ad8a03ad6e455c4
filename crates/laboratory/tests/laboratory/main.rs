//! Phantoms: the committed fixtures, and matches by the preset `thesis`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../../../../tests/fixtures/mod.rs"]
#[allow(dead_code, reason = "each test binary uses a part of it")]
mod fixtures;
mod laboratory;
mod thesis;
