//! The units of length of a match: the size of the surfaces and their sampling distance. Algorithms state no length in
//! millimeters, so results do not depend on the unit or the size of a structure.

use crate::surface::side::SurfaceLevel;

/// Least sampling distance, in roots of the area: a field of tens of functions is no more precise on finer sampling.
const FINEST_SAMPLING: f64 = 0.022;

/// Robust standard deviation of residuals along the normals after a deformation from which two surfaces are of two
/// subjects, in sampling distances.
const TWO_SUBJECTS: f64 = 0.135;

/// Squared error of an image that no field explains, in squared sampling distances; fitted.
const SAMPLING_VARIANCE: f64 = 0.039;

/// The lengths of two surfaces, in the same unit as their coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lengths {
    /// Size: the square root of the area, as the geometric mean over both surfaces.
    pub root_mm: f64,
    /// Sampling distance of the coarser surface: its mean edge length, but at least [`FINEST_SAMPLING`] roots.
    pub sampling_mm: f64,
}

impl Lengths {
    pub(crate) fn of(source: &SurfaceLevel, target: &SurfaceLevel) -> Self {
        // Exact under scaling by a power of two: the product scales by the square, and the root undoes this without
        // rounding.
        let root_mm = (source.root_mm * target.root_mm).sqrt();
        let edge_mm = source.mesh().mean_edge_length().max(target.mesh().mean_edge_length());
        Lengths { root_mm, sampling_mm: edge_mm.max(FINEST_SAMPLING * root_mm) }
    }

    /// Whether a residual along the normals after a deformation is as large as between two subjects.
    pub(crate) fn are_of_two_subjects(&self, residual_mm: f64) -> bool {
        residual_mm >= TWO_SUBJECTS * self.sampling_mm
    }
}

/// Variance of an image that no field explains, mm², for a sampling distance of `sampling_mm`.
pub(crate) fn sampling_variance(sampling_mm: f64) -> f64 {
    SAMPLING_VARIANCE * sampling_mm * sampling_mm
}
