//! Studies of synthetic groups: what they find, what they write, what they take, and that they stop.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout)]

mod cancellation;
mod equal_inputs;
mod joint;
#[path = "../making/mod.rs"]
mod making;
mod paired;
mod population;
#[cfg(target_os = "linux")]
mod price;
mod score;
mod sides;
mod statistics;
mod structures;
mod structures_matched;
mod study;
mod template;
