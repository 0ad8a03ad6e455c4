//! The lengths that a match is measured in: the size of the surfaces and the distance of their samples. No length of the
//! numerics is stated in millimeters, so that an answer does not depend on the unit or on the size of a structure.

use crate::surface::side::Side;

/// Sampling finer than this many roots of the area is not taken to be more precise: a field of tens of functions is not.
const FINEST_SAMPLING: f64 = 0.022;

/// Squared error of an image that no field explains, in squared sampling distances. Fitted with the share of the field's
/// covariance that counts.
const SAMPLING_VARIANCE: f64 = 0.039;

/// The lengths of two surfaces, in the same unit as their coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lengths {
    /// Size of a surface: the square root of its area, as the geometric mean of both.
    pub root_mm: f64,
    /// Distance at which the coarser one is sampled: its mean edge length, and at least [`FINEST_SAMPLING`] roots.
    pub sampling_mm: f64,
}

impl Lengths {
    pub(crate) fn of(source: &Side, target: &Side) -> Self {
        // Scaling by a power of two scales the product by its square, which the root undoes without rounding.
        let root_mm = (source.root_mm * target.root_mm).sqrt();
        let edge_mm = source.mesh().mean_edge_length().max(target.mesh().mean_edge_length());
        Lengths { root_mm, sampling_mm: edge_mm.max(FINEST_SAMPLING * root_mm) }
    }
}

/// Variance of an image that no field explains, mm², on surfaces sampled at a distance of `sampling_mm`.
pub(crate) fn sampling_variance(sampling_mm: f64) -> f64 {
    SAMPLING_VARIANCE * sampling_mm * sampling_mm
}
