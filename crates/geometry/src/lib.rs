//! What is measured on one surface: curvature in scale space ([`curvature`]), distances along it ([`geodesic`]), coarse
//! levels ([`hierarchy`]) and the first-order ellipsoid ([`harmonics`]).
//!
//! This crate knows no energy, no second surface, no file and no runtime.

pub mod curvature;
pub mod geodesic;
pub mod harmonics;
pub mod hierarchy;
