#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

pub mod canonical_form;
pub mod center_line;
pub mod curvature;
pub mod descriptors;
pub mod geodesic;
pub mod harmonics;
pub mod hierarchy;
pub mod sparse;
pub mod spectrum;
