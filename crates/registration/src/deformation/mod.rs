//! Smooth displacement fields between two sets of points: a Gaussian process prior and its posterior.
//!
//! A field `u(p)` is a Gaussian process: a translation, a linear part and smooth parts of stated widths, each with a
//! variance, independent for each axis ([`SmoothPrior`]). The bases below are finite: `u(p) = Σ_k φ_k(p) c_k` with
//! independent standard normal coefficients.
//!
//! - [`FieldBasis`]: the Nyström approximation over `m` inducing points that cover the surface evenly
//!   ([`homolog_primitives::points::farthest_points`]). Wide kernels have few relevant functions, so `M` is tens, not
//!   thousands. Observations are displacements, each with different precisions along and across a normal
//!   ([`Observation`]); [`fit_field`] gives the posterior mean, `(I + Φᵀ W Φ) c = Φᵀ W d`. [`fit_field_to`] is the same
//!   for single components of displacements ([`Information`]). Used by displacement.
//! - [`ComponentPosterior`]: the uncertainty if single components of displacements are observed ([`Component`]),
//!   exact and without a basis. Used by confidence.
//! - `taylor`: one kernel by the first terms of its Taylor series, twenty functions without an eigendecomposition, with
//!   isotropic observations and no covariance. Used by [`crate::pose_search()`], which fits a field to every candidate
//!   pose.
//!
//! If correspondences are unknown, [`crate::alignment::assign`] provides the observations. This module knows no mesh
//! and no energy.
//!
//! Sources: Rasmussen, Williams, "Gaussian Processes for Machine Learning", 2006 (weight-space view, Nyström);
//! Myronenko, Song, IEEE PAMI 32(12), 2010, and Hirose, IEEE PAMI 43(7), 2021 (such a prior in point-set registration).

mod evidence;
mod fit;
mod gram;
mod nystrom;
mod posterior;
pub(crate) mod taylor;
#[cfg(test)]
mod tests;

pub use evidence::{HeightEvidence, KernelEvidence, ONE_KERNEL, ProcessSearch, most_probable_kernel};
pub use fit::{FittedField, Information, Observation, fit_field, fit_field_to};
pub use nystrom::{FieldBasis, GaussianKernel, SmoothPrior};
pub use posterior::{Component, ComponentPosterior};
