//! Measurements on one surface: curvature in scale space ([`curvature`]), geodesic distances ([`geodesic`]), coarse
//! levels ([`hierarchy`]), spherical harmonics ([`harmonics`]) and the spectrum of the Laplacian ([`spectrum`]).
//!
//! This crate knows no energy, no second surface, no file and no runtime.

pub mod canonical_form;
pub mod curvature;
pub mod geodesic;
pub mod harmonics;
pub mod hierarchy;
pub mod sparse;
pub mod spectrum;
