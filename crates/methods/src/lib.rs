#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

pub mod bcpd;
pub mod cpd;
pub mod diffeomorphic;
mod frame;
pub mod functional_map;
pub mod medial;
pub mod nonrigid_icp;
mod soft;
pub mod spharm;
#[cfg(test)]
mod testing;

pub use frame::Frame;

use homolog_geometry::harmonics::HarmonicsError;
use homolog_primitives::observe::Cancelled;

/// Reasons why a method gives no map. Not converging is not an error.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MethodError {
    /// The observer asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A linear system or an eigenproblem has no solution: points coincide, or a number is not finite.
    #[error("the system of {method} has no solution: points coincide, or a number is not finite")]
    Singular {
        /// The method.
        method: &'static str,
    },
    /// A surface cannot be mapped onto the sphere.
    #[error("the {surface} has no map onto the sphere: {error}")]
    Sphere {
        /// `source` or `target`.
        surface: &'static str,
        /// The fault of the parametrization.
        error: HarmonicsError,
    },
}
