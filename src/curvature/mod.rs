//! Gaussian and mean curvature of a surface, at stated scales.
//!
//! A scale `σ` (mm) means: positions are smoothed by heat flow of time `σ²/2` ([`ScaleSpace`]), then curvature is
//! measured on the smoothed surface ([`gaussian_curvature`], [`mean_curvature`]). Triangles use corner angles and
//! mixed Voronoi areas; quads use corner angles and a quarter of each face's area, so that in both cases
//! `Σ K_i A_i = 2πχ` to rounding.

mod angle_defect;
mod laplacian;
mod scale_space;

pub use angle_defect::{gaussian_curvature, mean_curvature, vertex_areas};
pub use scale_space::{ScaleSpace, ScaleSpaceError};
