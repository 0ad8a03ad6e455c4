//! Synthetic hippocampus-like shapes with a known truth: for the demo, for tests, and for users without data.
//!
//! A [`Phantom`] is one subject, generated from a seed: a bent, tapered, bumpy tube of genus 0 with a larger head in
//! front and a thin, curved tail. It is available as a closed triangle surface ([`Phantom::surface`]) or as a label
//! volume with an anterior and a posterior part ([`Phantom::volume`]), both from the same formula. A [`PhantomPair`]
//! adds the second surface of a pair, deformed by a known smooth field and placed in a known pose. This module reads no
//! file and no clock; the same seeds give the same shapes.

mod deformation;
mod pair;
mod random;
mod raster;
mod shape;
mod spine;
mod surface;

pub use deformation::{Deformation, MAX_RMS_SHARE, MIN_JACOBIAN, random_permutation, random_pose};
pub use pair::{PairRecipe, PhantomPair};
pub use raster::PhantomVolume;
pub use shape::{Part, Phantom};
pub use surface::PhantomSurface;

use homolog_mesh::MeshError;

/// Edge length, mm, for about as many vertices (2,400) as the surface of a real hippocampus labeled at 1 mm.
pub const DEFAULT_EDGE_MM: f64 = 0.8;

/// Reasons why a requested phantom cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PhantomError {
    /// The edge length does not give a usable surface.
    #[error("an edge length of {edge_mm} mm is out of range; choose one from 0.2 to 4 mm")]
    EdgeOutOfRange {
        /// The requested length, mm.
        edge_mm: f64,
    },
    /// The voxel spacing does not resolve the shape.
    #[error("a voxel spacing of {spacing_mm} mm is out of range; choose one from 0.2 to 3 mm")]
    SpacingOutOfRange {
        /// The requested length, mm.
        spacing_mm: f64,
    },
    /// The requested deformation is too strong, or negative.
    #[error("a deformation of {rms_share} of the diagonal is out of range; choose one from 0 to {MAX_RMS_SHARE}")]
    ShareOutOfRange {
        /// The requested RMS displacement, as a share of the diagonal.
        rms_share: f64,
    },
    /// No deformation of this strength and seed preserves orientation.
    #[error("no deformation of {rms_share} of the diagonal with this seed is free of folds; choose another seed")]
    Folds {
        /// The requested RMS displacement, as a share of the diagonal.
        rms_share: f64,
    },
    /// There is nothing to deform or to fill.
    #[error("the surface has no vertices")]
    NoVertices,
    /// The volume exceeds the limit.
    #[error("the volume would have {n_voxels} voxels, more than {max}; choose a larger spacing")]
    TooManyVoxels {
        /// Number of voxels required.
        n_voxels: usize,
        /// Number of voxels allowed.
        max: usize,
    },
    /// The surface is not a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

#[cfg(test)]
mod tests;
