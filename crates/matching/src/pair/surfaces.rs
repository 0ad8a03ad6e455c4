//! The two surfaces of a displacement, and the same in the other direction.

use super::lengths::Lengths;
use super::role::Role;
use crate::surface::moments::AreaMoments;
use crate::surface::side::Side;
use homolog_contract::parameters::{Bending, Landmark};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};

/// Ratio of the variances of the places of two surfaces from which they differ in spread.
const UNLIKE_SPREAD: f64 = 1.1;

/// The surfaces of a displacement, in canonical numbering, mm.
#[derive(Clone, Copy)]
pub(crate) struct Surfaces<'a> {
    /// The surface that the field is fitted on.
    pub source: &'a SurfaceMesh,
    /// The surface that it is fitted to.
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
    /// Whether a part of either surface may be missing.
    pub open: bool,
    /// Which of them shows a part of what the other shows, if one does.
    pub part: Option<Role>,
    pub lengths: Lengths,
    /// How surfaces that no rigid motion brings together are matched.
    pub bending: Bending,
    /// What is known of the surface that the fields are fitted on: sites and form. `None` where these say nothing.
    pub side_of: &'a (dyn Fn(Role) -> Option<&'a Side> + Sync),
}

impl Surfaces<'_> {
    /// Whether the pair is fitted from the target to the source: from the surface that is more spread out for its area. Places
    /// that lie far apart along it lie far apart in space as well, and a field can move them differently; on a bent surface
    /// they may be neighbors.
    pub(crate) fn is_fitted_backwards(&self) -> bool {
        spread(self.full_target) > spread(self.full_source)
    }

    /// The pair in the other direction.
    pub(crate) fn swapped<'b>(
        &'b self,
        landmarks: &'b [Landmark],
        side_of: &'b (dyn Fn(Role) -> Option<&'b Side> + Sync),
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

/// Whether one surface is more spread out than the other, for its area.
pub(crate) fn differ_in_spread(surfaces: &Surfaces<'_>) -> bool {
    let (a, b) = (spread(surfaces.source), spread(surfaces.target));
    a.max(b) > UNLIKE_SPREAD * a.min(b)
}

/// Variance of the places on a surface, over its area.
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
