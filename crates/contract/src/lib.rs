//! The contract of a match: its [`parameters`] with their presets, its [`result`] document with the [`verdict`] on it,
//! the report on each [`input`], and the size of a [`study`].
//!
//! The types are plain data. With the feature `serde` they have their JSON form, and requests are resolved over their
//! presets; with `openapi` they also have the schemas of the service's OpenAPI document. This crate knows no algorithm,
//! no file and no runtime.

pub mod input;
pub mod parameters;
pub mod result;
pub mod study;
pub mod verdict;
