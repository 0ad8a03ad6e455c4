//! The rigid part of a displacement.
//!
//! For surfaces of different shape it is the absolute orientation of all correspondences. For copies the freedom of the
//! field only adds noise: alignment of points with tangent planes, in both directions and on surfaces without voxel
//! steps, is more accurate.
//!
//! An open surface may lack a region, and pairs without a true counterpart rotate the absolute orientation and hide
//! that the surfaces are copies. So open surfaces are first aligned, and are copies if the residual along the normals
//! is as small as sampling noise.
//!
//! Source: Chen, Medioni 1992 (point-to-plane); Rusinkiewicz, "A symmetric objective function for ICP", 2019 (uses both
//! surfaces; here the planes of each in turn); Tukey's biweight for points without counterpart.

use super::copies::{Aligned, align_shortly};
use crate::error::MatchError;
use crate::surface::smooth::SmoothSurface;
use homolog_geometry::curvature::vertex_areas;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Observer;
use homolog_registration::{
    IcpMetric, RigidTransform, SurfaceSide, TwoSidedOptions, absolute_orientation_of, align_both_ways,
};
use nalgebra::Point3;

/// Root mean square displacement after the rigid transform below which closed surfaces are copies, in mean target edge
/// lengths.
pub(crate) const MAX_COPY_DISPLACEMENT_EDGES: f64 = 0.5;
/// Most steps of the alignment of copies.
const MAX_STEPS: u32 = 30;
/// The alignment ends when a step rotates by less than this, radians, and moves by less than this, in diagonals of the
/// source.
const TOLERANCE: f64 = 1e-7;

/// The rigid part of a displacement.
pub(crate) struct RigidPart {
    /// `target_from_source`.
    pub transform: RigidTransform,
    /// Whether the surfaces are copies of one shape.
    pub copies: bool,
}

fn side(surface: &SmoothSurface) -> SurfaceSide<'_> {
    SurfaceSide { points: surface.mesh.vertices(), areas: &surface.areas, closest: surface.closest() }
}

/// Two prepared surfaces to align rigidly.
pub(crate) struct Alignment<'a> {
    pub source: &'a SmoothSurface,
    pub target: &'a SmoothSurface,
    /// Mean edge length of the target, mm.
    pub edge_mm: f64,
    pub observer: &'a dyn Observer,
}

impl Alignment<'_> {
    /// The rigid part of the correspondences `source vertex → image` (mm); `mirrored`: whether it is a reflection. With
    /// `open`, an alignment of the surfaces decides whether they are copies. `None` for collinear correspondences.
    ///
    /// # Errors
    /// [`MatchError::Cancelled`].
    pub(crate) fn rigid_part(
        &self,
        source: &SurfaceMesh,
        images: &[Point3<f64>],
        mirrored: bool,
        open: bool,
    ) -> Result<Option<RigidPart>, MatchError> {
        let areas = vertex_areas(source);
        let fitted = absolute_orientation_of(source.vertices(), images, Some(&areas), mirrored);
        let Ok(fitted) = fitted else { return Ok(None) };
        let squares: f64 =
            source.vertices().iter().zip(images).map(|(p, q)| (fitted.apply(p) - q).norm_squared()).sum();
        let mut copies = (squares / images.len() as f64).sqrt() < MAX_COPY_DISPLACEMENT_EDGES * self.edge_mm;
        let mut start = fitted;
        if open {
            let first = self.aligned_shortly(&fitted)?;
            copies = first.copies;
            start = first.target_from_source;
        }
        let transform = if copies { self.aligned(&start)? } else { fitted };
        Ok(Some(RigidPart { transform, copies }))
    }

    /// Whether a rigid alignment from `start` shows the surfaces to be copies in a pose other than `pose`, the result
    /// of an alignment from another start. If copies coincide in one pose only, both alignments end there.
    ///
    /// # Errors
    /// [`MatchError::Cancelled`].
    pub(crate) fn copies_elsewhere(&self, start: &RigidTransform, pose: &RigidTransform) -> Result<bool, MatchError> {
        let first = self.aligned_shortly(start)?;
        if !first.copies {
            return Ok(false);
        }
        let other = self.aligned(&first.target_from_source)?;
        let points = self.source.mesh.vertices();
        let squares: f64 = points.iter().map(|p| (other.apply(p) - pose.apply(p)).norm_squared()).sum();
        Ok((squares / points.len() as f64).sqrt() >= MAX_COPY_DISPLACEMENT_EDGES * self.edge_mm)
    }

    /// The result of a rigid alignment of all points from `start`.
    fn aligned(&self, start: &RigidTransform) -> Result<RigidTransform, MatchError> {
        let options = TwoSidedOptions {
            metric: IcpMetric::PointToPlane,
            max_sample: usize::MAX,
            sample_steps: 0,
            full_steps: MAX_STEPS,
            tolerance: TOLERANCE,
        };
        let found = align_both_ways(&side(self.source), &side(self.target), start, &options, self.observer)?;
        Ok(found.target_from_source)
    }

    /// The result of a few steps of rigid alignment from `start`, and whether the surfaces are copies there.
    fn aligned_shortly(&self, start: &RigidTransform) -> Result<Aligned, MatchError> {
        let (of_source, of_target) = (side(self.source), side(self.target));
        Ok(align_shortly(&of_source, &of_target, start, (self.edge_mm, TOLERANCE), self.observer)?)
    }
}
