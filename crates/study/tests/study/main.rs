//! Studies of synthetic groups: what they find, what they write, what they take, and that they stop.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout)]

mod adjusted_score;
mod cancellation;
mod equal_inputs;
#[allow(dead_code, reason = "each test binary uses a part")]
#[path = "../../../../tests/fixtures/mod.rs"]
mod fixtures;
mod joint;
#[path = "../making/mod.rs"]
mod making;
mod paired;
mod population;
#[cfg(target_os = "linux")]
mod price;
mod real_data;
mod rivals;
mod rivals_matched;
mod score;
mod sides;
#[path = "../../../../tests/fixtures/solids.rs"]
mod solids;
mod statistics;
mod structures;
mod structures_matched;
mod study;
mod template;
mod visits;
