//! Evaluation: synthetic subjects with known deformations and poses ([`phantom`]), and experiments that measure the
//! accuracy of every method, with their report ([`experiment`]).
//!
//! This crate knows nothing of the service: no runtime, no database, no HTTP.

pub mod experiment;
pub mod phantom;

/// The example of docs/rust.md, as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/rust.md")]
pub struct RustPage;
