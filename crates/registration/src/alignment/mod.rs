//! Soft alignment: possible correspondences between the points of two surfaces, and a measure of their agreement.
//!
//! Coherent point drift alternates two steps while a kernel width `σ` shrinks. The expectation step assigns every point
//! of one surface softly to the points of the other; the maximization step fits a transform to the assigned means. This
//! module has the expectation step, the measure of fit and the annealing schedule. The maximization steps are
//! [`crate::absolute_orientation()`] (rigid) and [`crate::deformation`] (smooth displacement fields).
//!
//! # Terms
//! - **Oriented points** ([`OrientedPoints`]): positions, unit normals, the area that each point represents, features.
//! - **Affinity** `g_ij ≥ 0`: agreement of point `i` of the source with point `j` of the target, from their distance
//!   relative to `σ`, their normals and their features.
//! - **Kernel density** `G_i = Σ_j a_j g_ij`, with `a_j` the areas: the amount of matching surface around point `i`.
//!   Areas make it independent of the sampling density of either surface. On a flat surface that matches perfectly it
//!   is `2πσ²`, the **flat density**.
//! - **Background** `b = ω · 2πσ²`: a uniform alternative to all points of the other surface, with `ω` the **outlier
//!   share** ([`OUTLIER_SHARE`]). A part without counterpart is assigned to the background.
//! - **Responsibility** `w_ij`: the share of point `j` that is assigned to point `i`. Its sum over `j` is the **mass**
//!   of `i`.
//! - **Misfit**: mean over both surfaces of `−ln((b + G) / 2πσ²)`, by area; lower is better.
//! - **Annealing** ([`annealed`]): `σ` falls geometrically from step to step.
//!
//! # Two kernels
//! Pose search compares hundreds of poses of a hundred patches each; displacement fits a few poses of thousands of
//! vertices. They use different formulas, which give different numbers:
//!
//! | | `compact`, used by [`crate::pose_search()`] | `gaussian`, used by displacement through [`assign`] |
//! |---|---|---|
//! | distance `d` | `(1 − d²/8σ²)⁴₊`: close to the Gaussian, no exponential, 0 from `2.83 σ` | `exp(−d²/2σ²)`, cut off at `3σ` |
//! | normals | `⟨n_i, n_j⟩₊`, normals of patches, shorter where a patch is bent | `exp(−ν (1 − ⟨n_i, n_j⟩))`, 0 where they oppose |
//! | features | `(1 + ¼‖f_i − f_j‖²)⁻²`, unit variances, heavy tails | `exp(−½ Σ_f π_f (f_i − f_j)²)`, precisions estimated in each step |
//! | responsibility | `½ a_j g_ij (1/(b + G_i) + 1/(b + G_j))`: swapping the surfaces inverts the transform | `a_j g_ij / (b + G_j)`, that of coherent point drift |
//! | pairs | all | points within reach, by the bounding boxes of blocks |
//! | background | added to the relative density in 64 bits | first summand of the density, in 32 bits on the target |
//!
//! Both compute in 32 bits, [`LANES`] target points side by side. They share the memory layout, distances, normal
//! agreement, misfit, background and annealing. All operations are the same on every instruction set (no fused
//! multiply-add, fixed order), so the dispatched versions give equal bits.
//!
//! Source: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010.

mod annealing;
pub(crate) mod compact;
mod gaussian;
mod points;
#[cfg(test)]
mod tests;

pub use annealing::{annealed, progress_short_of_end, progress_to_end};
pub use gaussian::{Assignment, AssignmentKernel, AssignmentTarget, PointMisfits, assign, misfit, point_misfits};
pub use points::OrientedPoints;
pub(crate) use points::{OrientedPoint, PackedPoints};

use points::{Block, LANES, LanePoint, Lanes, normal_agreements, squared_distances};
use std::f64::consts::TAU;

/// `ω`: the background, as a share of the density of a matching flat surface.
pub const OUTLIER_SHARE: f64 = 0.1;

/// `2πσ²`, mm²: the kernel density on a flat surface that matches perfectly.
fn flat_density(sigma_mm: f64) -> f64 {
    TAU * sigma_mm * sigma_mm
}

/// Mean, by area, of `−ln` of the relative densities of the points of one surface.
fn mean_misfit(relative_densities: impl Iterator<Item = f64>, areas: impl Iterator<Item = f64> + Clone) -> f64 {
    let weighted: f64 = relative_densities.zip(areas.clone()).map(|(density, area)| -area * density.ln()).sum();
    weighted / areas.sum::<f64>()
}
