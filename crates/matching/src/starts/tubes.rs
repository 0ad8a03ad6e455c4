//! Tubular surfaces straightened along their center lines.
//!
//! The inner side of a bend is shorter than the outer side, so a bent tube is not nearly isometric to a straight one.
//! In the coordinates of its center line ([`homolog_geometry::center_line`]) it is the same tube, up to the precision of the
//! line: for capsules bent by 150° the difference is 0.6 edges (root mean square), 0.3 to 0.4 away from the ends.

use super::start_pose::StartPose;
use crate::pair::surfaces::Surfaces;
use homolog_contract::parameters::{Bending, Landmark};
use homolog_geometry::center_line::{CenterLine, CenterLineOptions};
use homolog_geometry::curvature::vertex_areas;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_registration::alignment::OrientedPoints;
use homolog_registration::{PoseSearchOptions, pose_search};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Least ratio of the length of the center line to the radius of a tubular surface.
const TUBULAR: f64 = 6.0;
/// A tubular surface and its straightened version.
pub(crate) struct Tube<'a> {
    pub surface: &'a SurfaceMesh,
    pub straight: SurfaceMesh,
    /// Closest points of the surface and of its straightened version.
    pub closest: [ClosestPointIndex; 2],
}

impl<'a> Tube<'a> {
    /// `None` for a surface that is not tubular.
    fn new(surface: &'a SurfaceMesh) -> Option<Tube<'a>> {
        let line = CenterLine::of(surface, &CenterLineOptions::default())?;
        line.slenderness().filter(|ratio| *ratio > TUBULAR)?;
        let straight = surface.with_vertices(line.straight).ok()?;
        let closest = [ClosestPointIndex::new(surface), ClosestPointIndex::new(&straight)];
        Some(Tube { surface, straight, closest })
    }

    fn oriented<'b>(&'b self, normals: &'b [Vector3<f64>], areas: &'b [f64]) -> OrientedPoints<'b> {
        OrientedPoints { points: self.straight.vertices(), normals, areas, features: &[] }
    }

    /// Maps a point near the surface to the straightened surface.
    fn straightened(&self, p: &Point3<f64>) -> Point3<f64> {
        carried(self.surface, &self.closest[0], &self.straight, p)
    }

    /// Maps points near the straightened surface back to the surface.
    pub(crate) fn bent(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        points.par_iter().map(|p| carried(&self.straight, &self.closest[1], self.surface, p)).collect()
    }
}

/// Moves a point near `from` with its closest point to `to`, which has the same faces as `from` and other vertices.
pub(crate) fn carried(
    from: &SurfaceMesh,
    closest: &ClosestPointIndex,
    to: &SurfaceMesh,
    p: &Point3<f64>,
) -> Point3<f64> {
    let at = closest.closest(p);
    let normal = |mesh: &SurfaceMesh| {
        let [a, b, c] = at.triangle.map(|k| mesh.vertices()[k as usize]);
        (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_default()
    };
    let height = normal(from).dot(&(p - at.point));
    Point3::from(at.blend(|k| to.vertices()[k].coords) + normal(to) * height)
}

/// Two tubular surfaces.
pub(crate) struct Tubes<'a> {
    pub source: Tube<'a>,
    pub target: Tube<'a>,
    landmarks: Vec<Landmark>,
}

impl<'a> Tubes<'a> {
    /// `None` if one of the surfaces is not tubular. Cost: two sparse factorizations for each.
    pub(crate) fn of(surfaces: &Surfaces<'a>) -> Option<Tubes<'a>> {
        let (source, target) = rayon::join(|| Tube::new(surfaces.source), || Tube::new(surfaces.target));
        let (source, target) = (source?, target?);
        let straightened = |landmark: &Landmark| Landmark {
            source_mm: source.straightened(&Point3::from(landmark.source_mm)).into(),
            target_mm: target.straightened(&Point3::from(landmark.target_mm)).into(),
            ..landmark.clone()
        };
        let landmarks = surfaces.landmarks.iter().map(straightened).collect();
        Some(Tubes { landmarks, source, target })
    }

    /// The straightened surfaces of `surfaces`.
    pub(crate) fn straight<'b>(&'b self, surfaces: &Surfaces<'_>) -> Surfaces<'b> {
        Surfaces {
            source: &self.source.straight,
            target: &self.target.straight,
            full_source: &self.source.straight,
            full_target: &self.target.straight,
            source_closest: &self.source.closest[1],
            target_closest: &self.target.closest[1],
            landmarks: &self.landmarks,
            open: surfaces.open,
            part: surfaces.part,
            lengths: surfaces.lengths,
            bending: Bending::None,
            side_of: &|_| None,
        }
    }

    /// Poses of the straightened source on the straightened target, from a search of all orientations.
    pub(crate) fn poses(&self, source_is_part: bool) -> Vec<StartPose> {
        let (source, target) = (&self.source, &self.target);
        let (normals, other_normals) = (source.straight.vertex_normals(), target.straight.vertex_normals());
        let (areas, other_areas) = (vertex_areas(&source.straight), vertex_areas(&target.straight));
        let search = PoseSearchOptions { allow_reflection: true, source_is_part, ..PoseSearchOptions::default() };
        let found =
            pose_search(&source.oriented(&normals, &areas), &target.oriented(&other_normals, &other_areas), &search);
        found.iter().map(|p| StartPose { excess: p.excess, ..StartPose::of(p.target_from_source) }).collect()
    }
}
