//! What all numerics of homolog share: graphs ([`graph`]), sets of points ([`points`]), progress reports and cancellation
//! ([`observe`]), and an exponential for vector loops ([`exponential`]).
//!
//! This crate knows no surface, no energy, no file and no runtime.

pub mod exponential;
pub mod graph;
pub mod observe;
pub mod points;
