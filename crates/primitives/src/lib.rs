#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

pub mod exponential;
pub mod graph;
pub mod lbfgs;
pub mod observe;
pub mod points;
