//! Smooth displacement fields between two sets of points.
//!
//! A field `u(p)` is a Gaussian process: a translation, a linear part and smooth parts of stated widths, each with a
//! variance, independent for each axis ([`SmoothPrior`]). Over `m` inducing points spread evenly ([`farthest_points`])
//! it becomes `u(p) = Σ_k φ_k(p) c_k` with independent standard normal coefficients ([`FieldBasis`], the Nyström
//! approximation); wide kernels have few functions that matter, so `M` is tens, not thousands. What is seen at a point
//! is a displacement with one precision along a normal and another across it ([`Pull`]); [`fit()`] gives the posterior
//!
//! `(I + Φᵀ W Φ) c = Φᵀ W d`, `Cov c = (I + Φᵀ W Φ)⁻¹`
//!
//! and with it how sure the field is at every point. [`assign`] says what is seen where correspondences are unknown.
//!
//! Nothing here knows a mesh or an energy: points, normals, areas, features.
//!
//! Sources: Rasmussen, Williams, "Gaussian Processes for Machine Learning", 2006 (weight-space view, Nyström);
//! Myronenko, Song, IEEE PAMI 32(12), 2010, and Hirose, IEEE PAMI 43(7), 2021 (such a prior in point-set registration).

mod affinity;
mod assignment;
mod basis;
mod farthest;
mod fit;
mod neighbors;
#[cfg(test)]
mod tests;

pub use assignment::{Assignment, Likeness, Samples, assign};
pub use basis::{FieldBasis, GaussianKernel, SmoothPrior};
pub use farthest::farthest_points;
pub use fit::{FittedField, Pull, fit};
pub use neighbors::NeighborGrid;
