#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

pub mod input;
pub mod parameters;
pub mod reason;
pub mod result;
pub mod study;
pub mod verdict;
