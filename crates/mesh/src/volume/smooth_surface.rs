//! A smooth surface of a voxel set: the 0.5 iso-surface of the Gaussian-filtered mask.
//!
//! The filtered field is cut by marching cubes (`cubes`). The surface is a closed 2-manifold by construction but has
//! the topology of the field: the filter may open a tunnel or break a thin bridge. With `repair`, [`smooth_surface`]
//! moves single lattice values across 0.5 until the surface is a topological sphere, and reports how many.

use super::repair::{Contacts, FillChange, fill, largest_component};
use super::{VoxelMask, cubes, spacing_mm};
use crate::topology::analyze;
use crate::{MeshError, SurfaceMesh};

/// Extent of the Gaussian kernel, standard deviations; the samples beyond weigh 6e-5 together.
const TRUNCATION_SIGMAS: f64 = 4.0;

/// Level of the surface: at a half, a flat boundary between voxels keeps its position.
const LEVEL: f64 = 0.5;

/// Distance from the level of the lattice values that repair moves across it: far enough to separate the vertices
/// around them, near enough that the surface hardly moves.
const REPAIRED_OFFSET: f64 = 0.02;

/// A smooth surface and the changes made to its field.
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothSurface {
    /// The surface: triangles, mm, facing outwards.
    pub mesh: SurfaceMesh,
    /// Lattice values outside the largest piece that were moved below the level.
    pub n_dropped: usize,
    /// Lattice values moved across the level, if any, to close tunnels and cavities and to separate parts that touched.
    pub fill: Option<FillChange>,
}

/// Permitted changes of the filtered field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FieldRepair {
    /// Keep only the largest piece.
    pub largest_component: bool,
    /// Close tunnels and cavities.
    pub fill: bool,
}

/// The 0.5 iso-surface of `mask` filtered by a Gaussian of standard deviation `smoothing_mm`, in world mm.
///
/// Changes the field only if the surface would not be a topological sphere, and only as `repair` allows.
///
/// # Errors
/// [`MeshError::Empty`] if nothing of the set is left at the level.
///
/// # Cost
/// `O(voxels · smoothing / spacing)`; with repairs, plus the cost of [`fill`].
pub fn smooth_surface(mask: &VoxelMask, smoothing_mm: f64, repair: FieldRepair) -> Result<SmoothSurface, MeshError> {
    let field = gaussian_filter(mask, smoothing_mm);
    let mesh = cubes::iso_surface(mask, &field, LEVEL)?;
    let as_is = SmoothSurface { mesh, n_dropped: 0, fill: None };
    let report = analyze(&as_is.mesh).report;
    let wanted = repair.largest_component && report.n_components > 1 || repair.fill && report.genus != Some(0);
    if !wanted {
        return Ok(as_is);
    }
    let above = mask.with_voxels(field.iter().map(|&f| f >= LEVEL).collect());
    let (mut repaired, mut n_dropped, mut change) = (above.clone(), 0, None);
    if repair.largest_component {
        (repaired, _, n_dropped) = largest_component(&repaired);
    }
    // Cutting handles is meaningful only within one piece.
    if repair.fill && super::BettiNumbers::of(&repaired).n_pieces == 1 {
        let filled = fill(&repaired, Contacts::Resolve);
        (repaired, change) = (filled.mask, Some(filled.change));
    }
    let mut field = field;
    for (k, value) in field.iter_mut().enumerate() {
        if repaired.voxels()[k] != above.voxels()[k] {
            *value = if repaired.voxels()[k] { LEVEL + REPAIRED_OFFSET } else { LEVEL - REPAIRED_OFFSET };
        }
    }
    let mesh = cubes::iso_surface(mask, &field, LEVEL)?;
    Ok(SmoothSurface { mesh, n_dropped, fill: change.filter(|c| c.n_changed() > 0) })
}

/// `mask` as 0 and 1, filtered; zero outside the box. No point outside the bounding box of the set can reach the level,
/// so the empty border of a mask is enough padding.
pub(super) fn gaussian_filter(mask: &VoxelMask, smoothing_mm: f64) -> Vec<f64> {
    let mut field: Vec<f64> = mask.voxels().iter().map(|&v| if v { 1.0 } else { 0.0 }).collect();
    let (dims, strides, spacing) = (mask.dims(), mask.strides(), spacing_mm(mask.affine()));
    let mut line = Vec::new();
    for axis in 0..3 {
        let kernel = gaussian_kernel(smoothing_mm / spacing[axis], dims[axis]);
        if kernel.len() == 1 {
            continue;
        }
        let (len, step) = (dims[axis], strides[axis]);
        for start in (0..field.len()).filter(|k| k / step % len == 0) {
            line.clear();
            line.extend((0..len).map(|k| field[start + k * step]));
            if line.iter().all(|&v| v == 0.0) {
                continue;
            }
            for k in 0..len {
                let mut sum = line[k] * kernel[0];
                for (d, weight) in kernel.iter().enumerate().skip(1) {
                    let before = if d <= k { line[k - d] } else { 0.0 };
                    let after = line.get(k + d).copied().unwrap_or(0.0);
                    sum += (before + after) * weight;
                }
                field[start + k * step] = sum;
            }
        }
    }
    field
}

/// One half of a normalized Gaussian of `sigma` voxels, starting at the middle, no longer than the filtered line.
fn gaussian_kernel(sigma: f64, max_len: usize) -> Vec<f64> {
    // Below a tenth of a voxel the neighbors weigh less than 1e-21.
    if sigma < 0.1 {
        return vec![1.0];
    }
    let radius = (TRUNCATION_SIGMAS * sigma).ceil();
    let weight = |k: f64| (-0.5 * (k / sigma).powi(2)).exp();
    let mut total = 1.0;
    let mut k = 1.0;
    while k <= radius {
        total += 2.0 * weight(k);
        k += 1.0;
    }
    let len = (radius as usize + 1).min(max_len);
    (0..len).map(|k| weight(k as f64) / total).collect()
}

#[cfg(test)]
#[path = "smooth_surface_tests.rs"]
mod tests;
