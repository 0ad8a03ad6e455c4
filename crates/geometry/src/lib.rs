//! Measurements on one surface: curvature in scale space ([`curvature`]), geodesic distances ([`geodesic`]), coarse
//! levels ([`hierarchy`]) and the first-order ellipsoid ([`harmonics`]).
//!
//! This crate knows no energy, no second surface, no file and no runtime.

pub mod canonical_form;
pub mod curvature;
pub mod geodesic;
pub mod harmonics;
pub mod hierarchy;
mod sparse;
