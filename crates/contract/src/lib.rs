//! What is asked of a match and what it answers: [`parameters`] with their presets, the [`result`] document, and what is
//! told of an input ([`input`]).
//!
//! Plain data. With the feature `serde` these types have their JSON form and requests are resolved over their presets;
//! with `openapi` also the schemas of the service's OpenAPI document. This crate knows no algorithm, no file and no
//! runtime.

pub mod input;
pub mod parameters;
pub mod result;
