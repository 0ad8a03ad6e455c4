//! The attempt for tubular surfaces: both are straightened along their center lines, and matched as any two surfaces are.
//!
//! The inner side of a bend is shorter than the outer one, so a bent tube is no near isometry of a straight one. In the
//! coordinates of its center line ([`homolog_methods::medial`]) it is the same tube again, up to how well the line is known:
//! capsules bent by 150° then differ from the straight one by 0.6 edges (root mean square), by 0.3 to 0.4 away from the ends.
//! Search of the pose, field, comparison with mirror images and fit back are those of the surfaces themselves.

use super::fits::Fits;
use super::{ComparedPose, Deformed, DisplacementOptions, StartPose, Surfaces, along, deformed, prepare};
use crate::MatchError;
use homolog_contract::parameters::{Bending, Landmark};
use homolog_geometry::curvature::vertex_areas;
use homolog_geometry::hierarchy::coarsen;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_methods::medial::{CenterLine, MedialOptions};
use homolog_primitives::observe::checkpoint;
use homolog_registration::alignment::OrientedPoints;
use homolog_registration::{PoseSearchOptions, RigidTransform, absolute_orientation_of, pose_search};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Least length of the center line over the radius of a tubular surface.
const TUBULAR: f64 = 6.0;
/// Vertices of the level on which it is first looked how straight a surface is.
const N_COARSE: usize = 600;

/// A tubular surface and the same straightened.
struct Tube<'a> {
    surface: &'a SurfaceMesh,
    straight: SurfaceMesh,
    /// Closest points of the surface and of the straightened one.
    closest: [ClosestPointIndex; 2],
}

impl<'a> Tube<'a> {
    /// `None` for a surface that is not tubular.
    fn new(surface: &'a SurfaceMesh) -> Option<Tube<'a>> {
        let line = CenterLine::of(surface, &MedialOptions::default())?;
        line.slenderness().filter(|ratio| *ratio > TUBULAR)?;
        let straight = surface.with_vertices(line.straight).ok()?;
        let closest = [ClosestPointIndex::new(surface), ClosestPointIndex::new(&straight)];
        Some(Tube { surface, straight, closest })
    }

    fn oriented<'b>(&'b self, normals: &'b [Vector3<f64>], areas: &'b [f64]) -> OrientedPoints<'b> {
        OrientedPoints { points: self.straight.vertices(), normals, areas, features: &[] }
    }

    /// A point near the surface, straightened with it.
    fn straightened(&self, p: &Point3<f64>) -> Point3<f64> {
        carried(self.surface, &self.closest[0], &self.straight, p)
    }

    /// A point near the straightened surface, bent back with it.
    fn bent(&self, points: &[Point3<f64>]) -> Vec<Point3<f64>> {
        points.par_iter().map(|p| carried(&self.straight, &self.closest[1], self.surface, p)).collect()
    }
}

/// A point near `from`, carried along to the place of its closest point on `to`, whose vertices are those of `from` elsewhere.
fn carried(from: &SurfaceMesh, closest: &ClosestPointIndex, to: &SurfaceMesh, p: &Point3<f64>) -> Point3<f64> {
    let at = closest.closest(p);
    let normal = |mesh: &SurfaceMesh| {
        let [a, b, c] = at.triangle.map(|k| mesh.vertices()[k as usize]);
        (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_default()
    };
    let height = normal(from).dot(&(p - at.point));
    Point3::from(at.blend(|k| to.vertices()[k].coords) + normal(to) * height)
}

/// Distance of the ends of the center line over its length, on a coarser level.
fn straightness(surface: &SurfaceMesh) -> Option<f64> {
    let level = coarsen(surface, N_COARSE);
    let line = CenterLine::of(level.as_ref().map_or(surface, |level| &level.mesh), &MedialOptions::default());
    Some(line?.straightness())
}

/// The source deformed onto the target by way of both straightened; `None` if one is not tubular, or if the straightness of their
/// center lines, between 0 and 1, differs by less than `if_bent_by`. With the starts that were compared, the one that was kept first.
///
/// # Errors
/// [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
///
/// # Cost
/// That of a match of both surfaces, and two sparse factorizations for each.
pub(super) fn straightened(
    surfaces: &Surfaces<'_>,
    if_bent_by: f64,
    allow_reflection: bool,
    options: &DisplacementOptions,
    observer: &Fits<'_>,
) -> Result<Option<(Deformed, Vec<ComparedPose>)>, MatchError> {
    if if_bent_by > 0.0 {
        let (a, b) = rayon::join(|| straightness(surfaces.source), || straightness(surfaces.target));
        if !a.zip(b).is_some_and(|(a, b)| (a - b).abs() >= if_bent_by) {
            return Ok(None);
        }
    }
    let (source, target) = rayon::join(|| Tube::new(surfaces.source), || Tube::new(surfaces.target));
    checkpoint(observer)?;
    let (Some(source), Some(target)) = (source, target) else { return Ok(None) };
    let landmarks: Vec<Landmark> = surfaces
        .landmarks
        .iter()
        .map(|landmark| Landmark {
            source_mm: source.straightened(&Point3::from(landmark.source_mm)).into(),
            target_mm: target.straightened(&Point3::from(landmark.target_mm)).into(),
            ..landmark.clone()
        })
        .collect();
    let straight = Surfaces {
        source: &source.straight,
        target: &target.straight,
        full_source: &source.straight,
        full_target: &target.straight,
        source_closest: &source.closest[1],
        target_closest: &target.closest[1],
        landmarks: &landmarks,
        open: surfaces.open,
        part: surfaces.part,
        lengths: surfaces.lengths,
        bending: Bending::None,
        form_of: &|_| None,
    };
    let (normals, other_normals) = (source.straight.vertex_normals(), target.straight.vertex_normals());
    let (areas, other_areas) = (vertex_areas(&source.straight), vertex_areas(&target.straight));
    // A target that is a part has become the source.
    let source_is_part = surfaces.part.is_some();
    let search = PoseSearchOptions { allow_reflection: true, source_is_part, ..PoseSearchOptions::default() };
    let found =
        pose_search(&source.oriented(&normals, &areas), &target.oriented(&other_normals, &other_areas), &search);
    let poses: Vec<StartPose> =
        found.iter().map(|p| StartPose { excess: p.excess, ..StartPose::of(p.target_from_source) }).collect();
    checkpoint(observer)?;
    let prepared = prepare(&source.straight, &target.straight, surfaces.lengths.root_mm, source_is_part)?;
    let Some((deformed, compared)) = deformed(&straight, prepared, &poses, allow_reflection, options, observer)? else {
        return Ok(None);
    };
    let own = target.bent(&deformed.moved);
    // What is straightened keeps its handedness.
    let rigid = |images: &[Point3<f64>], mirrored: bool| {
        let areas = vertex_areas(surfaces.source);
        absolute_orientation_of(surfaces.source.vertices(), images, Some(&areas), mirrored).ok()
    };
    let Some(transform) = rigid(&own, deformed.transform.is_reflection()) else { return Ok(None) };
    let compared = compared
        .into_iter()
        .map(|compared| {
            let pose = &poses[compared.pose].pose;
            let moved: Vec<Point3<f64>> = source.straight.vertices().iter().map(|p| pose.apply(p)).collect();
            let bent: RigidTransform = rigid(&target.bent(&moved), pose.is_reflection()).unwrap_or(transform);
            ComparedPose { pose: usize::MAX, of_form: Some(bent), ..compared }
        })
        .collect();
    let error = along::squared_error(surfaces.source, &own, &deformed.agreement, &surfaces.lengths);
    let (moved, mut variances) = if surfaces.source == surfaces.full_source {
        (own, deformed.variances)
    } else {
        let Ok(moved) = surfaces.source.with_vertices(own) else { return Ok(None) };
        let carried = |p: &Point3<f64>| {
            let at = source.closest[0].closest(p);
            (carried(surfaces.source, &source.closest[0], &moved, p), at.blend(|k| deformed.variances[k]))
        };
        surfaces.full_source.vertices().par_iter().map(carried).unzip()
    };
    along::raise(&mut variances, error, &surfaces.lengths);
    Ok(Some((Deformed { moved, variances, transform, ..deformed }, compared)))
}
