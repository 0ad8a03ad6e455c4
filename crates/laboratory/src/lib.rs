#![doc = include_str!("../README.md")]

pub mod experiment;
pub mod phantom;

/// The example of docs/rust.md, as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/rust.md")]
pub struct RustPage;
