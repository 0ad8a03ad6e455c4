//! Published methods that match two surfaces in one rigid pose. Each maps the vertices of the source to points on or near
//! the target, and can be compared with the Markov random field on equal terms.
//!
//! | module | method |
//! |---|---|
//! | [`cpd`] | coherent point drift |
//! | [`bcpd`] | its Bayesian formulation |
//! | [`nonrigid_icp`] | non-rigid iterative closest points with locally affine maps |
//! | [`functional_map`] | functional maps, refined by ZoomOut |
//! | [`spharm`] | SPHARM-PDM: equal parameters of spherical harmonics |
//! | [`medial`] | medial coordinates of tubular structures |
//! | [`diffeomorphic`] | the flow of a stationary velocity field, matched by varifolds |
//!
//! Lengths are dimensionless: every constant is in square roots of the area of a surface, and [`Frame`] converts
//! surfaces to that unit and answers back. An answer therefore does not depend on the unit or size of the inputs, and
//! scaling both by a power of two scales it to the bit. The same inputs give the same bits on any number of threads.
//!
//! This crate knows no energy, no search for a pose, no file and no runtime.

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
