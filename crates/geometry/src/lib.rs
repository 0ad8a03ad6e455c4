//! Measurements on one surface: curvature in scale space ([`curvature`]), geodesic distances ([`geodesic`]), coarse
//! levels ([`hierarchy`]), spherical harmonics ([`harmonics`]), the spectrum of the Laplacian ([`spectrum`]) and local
//! descriptors ([`descriptors`]).
//!
//! This crate knows no energy, no correspondence with a second surface, no file and no runtime.

pub mod canonical_form;
pub mod curvature;
pub mod descriptors;
pub mod geodesic;
pub mod harmonics;
pub mod hierarchy;
pub mod sparse;
pub mod spectrum;
