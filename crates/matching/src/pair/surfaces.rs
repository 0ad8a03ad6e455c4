//! The two surfaces of a displacement, in either direction.

use super::lengths::Lengths;
use super::role::Role;
use crate::surface::moments::AreaMoments;
use crate::surface::side::SurfaceLevel;
use homolog_contract::parameters::{Bending, Landmark};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};

/// Ratio of the spreads of two surfaces from which they count as different.
const UNLIKE_SPREAD: f64 = 1.1;

/// The surfaces of a displacement, in canonical numbering, mm.
#[derive(Clone, Copy)]
pub(crate) struct Surfaces<'a> {
    /// The surface that the field is fitted on.
    pub source: &'a SurfaceMesh,
    /// The surface that the field is fitted to.
    pub target: &'a SurfaceMesh,
    /// The source whose vertices get images.
    pub full_source: &'a SurfaceMesh,
    /// The target on which the images lie.
    pub full_target: &'a SurfaceMesh,
    /// Closest points of `full_source`.
    pub source_closest: &'a ClosestPointIndex,
    /// Closest points of `full_target`.
    pub target_closest: &'a ClosestPointIndex,
    /// Pairs of points that are known to correspond.
    pub landmarks: &'a [Landmark],
    /// Whether a region of either surface may be missing.
    pub open: bool,
    /// The surface that shows only a part of the structure, if one does.
    pub part: Option<Role>,
    pub lengths: Lengths,
    /// How surfaces that a rigid motion does not align are matched.
    pub bending: Bending,
    /// Sites and form of the surfaces that the fields are fitted on. `None` if they are not used.
    pub side_of: &'a (dyn Fn(Role) -> Option<&'a SurfaceLevel> + Sync),
}

impl Surfaces<'_> {
    /// Whether the pair is fitted from the target to the source: from the surface of larger spread relative to its
    /// area. Points that are far apart along this surface are also far apart in space, so a field can move them
    /// independently; on a bent surface they may be close in space.
    pub(crate) fn is_fitted_backwards(&self) -> bool {
        spread(self.full_target) > spread(self.full_source)
    }

    /// The pair in the other direction.
    pub(crate) fn swapped<'b>(
        &'b self,
        landmarks: &'b [Landmark],
        side_of: &'b (dyn Fn(Role) -> Option<&'b SurfaceLevel> + Sync),
    ) -> Surfaces<'b> {
        Surfaces {
            source: self.target,
            target: self.source,
            full_source: self.full_target,
            full_target: self.full_source,
            source_closest: self.target_closest,
            target_closest: self.source_closest,
            landmarks,
            side_of,
            open: self.open,
            part: self.part.map(Role::other),
            lengths: self.lengths,
            bending: self.bending,
        }
    }
}

/// Whether the surfaces differ in spread relative to area.
pub(crate) fn differ_in_spread(surfaces: &Surfaces<'_>) -> bool {
    let (a, b) = (spread(surfaces.source), spread(surfaces.target));
    a.max(b) > UNLIKE_SPREAD * a.min(b)
}

/// Variance of the points of a surface divided by its area, without unit.
fn spread(mesh: &SurfaceMesh) -> f64 {
    AreaMoments::of(mesh).map_or(0.0, |moments| moments.scatter.trace() / (moments.area * moments.area))
}

/// The landmark of the pair in the other direction.
pub(crate) fn swapped(landmark: &Landmark) -> Landmark {
    Landmark { source_mm: landmark.target_mm, target_mm: landmark.source_mm, ..landmark.clone() }
}

/// Length of the diagonal of the bounding box of `mesh`, mm.
pub(crate) fn diagonal_mm(mesh: &SurfaceMesh) -> f64 {
    let (low, high) = mesh.bounding_box();
    (high - low).norm()
}
