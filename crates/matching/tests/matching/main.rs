//! Matches of whole surfaces: bent ones, parts, sizes, symmetric shapes, extreme parameters; and the layout of the crate.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout)]

mod bent;
mod features;
#[cfg(feature = "comparison")]
mod field_methods;
mod layout;
#[cfg(feature = "comparison")]
mod parameter_extremes;
mod parts;
#[cfg(feature = "comparison")]
mod scale;
#[cfg(feature = "comparison")]
mod second_opinion;
mod sizes;
#[path = "../../../../tests/layout/mod.rs"]
mod source_tree;
mod symmetric;
