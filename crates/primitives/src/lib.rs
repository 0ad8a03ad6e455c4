//! Shared parts of all numerics of homolog: graphs ([`graph`]), sets of points ([`points`]), progress reports and
//! cancellation ([`observe`]), an exponential for vector loops ([`exponential`]), and a minimizer of smooth functions
//! ([`lbfgs`]).
//!
//! This crate knows no surface, no energy, no file and no runtime.

pub mod exponential;
pub mod graph;
pub mod lbfgs;
pub mod observe;
pub mod points;
