//! homolog finds homologous points of two anatomical surfaces: a dense correspondence and a rigid transform.
//!
//! The modules in reading order, by layer. Each knows only those above it, as far as ARCHITECTURE.md allows.
//!
//! Numerics (no runtime, no database, no HTTP, no clock, no files): [`observe`], [`mesh`], [`volume`], [`formats`], [`matching`].
//! Inputs: [`intake`]. One match from bytes to the result document: [`run`].

#![cfg_attr(test, allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout))]

pub mod observe;

pub mod mesh;
pub mod volume;

pub mod formats;

pub mod intake;
pub mod matching;

pub mod run;
