//! What each method is worth: synthetic subjects with known deformations and poses ([`phantom`]), and experiments with
//! their report ([`experiment`]).
//!
//! This crate knows no service: no runtime, no database, no HTTP.

pub mod experiment;
pub mod phantom;
