//! The third stage by a published method ([`homolog_methods`]) instead of the smooth displacement field: the source in
//! its rigid pose, thinned if it is large, is matched to the target, and the map is extended to all of its vertices.

use crate::answer::displaced::{Images, SmoothImages, VertexImages};
use crate::answer::images::images;
use crate::answer::reliability::without_counterpart;
use crate::error::MatchError;
use crate::pair::problem::MatchProblem;
use crate::poses::rigid_part::MAX_COPY_DISPLACEMENT_EDGES;
use homolog_contract::parameters::DisplacementMode;
use homolog_contract::result::PoseDocument;
use homolog_geometry::curvature::vertex_areas;
use homolog_geometry::hierarchy::coarsen_observed;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_methods::{Frame, MethodError, bcpd, cpd, diffeomorphic, functional_map, medial, nonrigid_icp, spharm};
use homolog_primitives::observe::{Cancelled, Observer};
use homolog_registration::{RigidTransform, absolute_orientation_of};
use nalgebra::Point3;
use rayon::prelude::*;

/// Steps of the flow of a velocity field when it moves all vertices.
const FLOW_STEPS: usize = 20;

/// Most vertices of either surface for a method, and an upper bound of its memory per vertex, bytes. Measured at these
/// limits: 25, 18, 43 and 14 MiB for coherent point drift, non-rigid ICP, functional maps and the flow; counted: 47,
/// 47, 68 and 16 MiB.
pub(crate) fn limits(mode: DisplacementMode) -> Option<(usize, u64)> {
    match mode {
        DisplacementMode::None | DisplacementMode::Smooth => None,
        DisplacementMode::Cpd | DisplacementMode::Bcpd => Some((1500, 16 << 10)),
        DisplacementMode::NonrigidIcp => Some((1500, 16 << 10)),
        // Not thinned: a map onto the sphere needs manifold surfaces, which thinned ones need not be, and a triangle of
        // a coarse surface can be wider than a tubular structure. The memory of these methods is linear in the surface.
        DisplacementMode::SpharmPdm | DisplacementMode::Medial => Some((usize::MAX, 4 << 10)),
        DisplacementMode::FunctionalMap => Some((2500, 14 << 10)),
        DisplacementMode::Diffeomorphic => Some((500, 16 << 10)),
    }
}

/// The images by the method `displacement.mode`, from `pose`. `None` if it finds no map: if a number is not finite, or
/// if a surface cannot be thinned to the limit of the method.
///
/// # Errors
/// [`MatchError::NoEllipsoid`] for SPHARM-PDM of a surface that is not closed or not of genus 0;
/// [`MatchError::Cancelled`].
pub(crate) fn by_method(
    coarse: &MatchProblem<'_>,
    pose: &RigidTransform,
    poses: Vec<PoseDocument>,
) -> Result<Option<VertexImages>, MatchError> {
    let scene = &coarse.full;
    let (source, target) = (scene.source.mesh(), scene.target.mesh());
    let mode = scene.parameters.displacement.mode;
    let Some((most, _)) = limits(mode) else { return Ok(None) };
    let (Some(frame), Ok(posed)) = (Frame::of(target), source.moved(&pose.matrix())) else { return Ok(None) };
    let entered = |mesh: &SurfaceMesh| mesh.with_vertices(mesh.vertices().iter().map(|p| frame.enter(p)).collect());
    let (Ok(whole), Ok(onto)) = (entered(&posed), entered(target)) else { return Ok(None) };
    let thinned = |mesh: SurfaceMesh| thinned(mesh, most, scene.observer);
    let (thin, onto) = rayon::join(|| thinned(whole.clone()), || thinned(onto));
    let (Some(thin), Some(onto)) = (thin?, onto?) else { return Ok(None) };
    let found = match moved(mode, &thin, &onto, &whole, scene.observer) {
        Ok(found) => found,
        Err(MethodError::Singular { .. }) => return Ok(None),
        Err(MethodError::Cancelled(cancelled)) => return Err(cancelled.into()),
        Err(MethodError::Sphere { surface, error }) => return Err(MatchError::NoEllipsoid { surface, error }),
    };
    if found.iter().any(|p| p.iter().any(|x| !x.is_finite())) {
        return Ok(None);
    }
    let moved: Vec<Point3<f64>> = found.iter().map(|p| frame.leave(p)).collect();
    Ok(Some(answered(coarse, pose, poses, moved)))
}

/// `mesh`, or a coarse version of it of about `most` vertices. `None` if it has more and no coarse version.
fn thinned(mesh: SurfaceMesh, most: usize, observer: &dyn Observer) -> Result<Option<SurfaceMesh>, Cancelled> {
    if mesh.n_vertices() <= most {
        return Ok(Some(mesh));
    }
    Ok(coarsen_observed(&mesh, most, observer)?.map(|coarse| coarse.mesh))
}

/// The vertices of `whole` moved by the map of `source`, a thinned version of it, to `target`.
fn moved(
    mode: DisplacementMode,
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    whole: &SurfaceMesh,
    observer: &dyn Observer,
) -> Result<Vec<Point3<f64>>, MethodError> {
    let (from, to) = (source.vertices(), target.vertices());
    Ok(match mode {
        DisplacementMode::None | DisplacementMode::Smooth => whole.vertices().to_vec(),
        DisplacementMode::Cpd => {
            cpd::register(from, to, &cpd::CpdOptions::default(), observer)?.field.moved(whole.vertices())
        }
        DisplacementMode::Bcpd => {
            bcpd::register(from, to, &bcpd::BcpdOptions::default(), observer)?.moved(whole.vertices())
        }
        DisplacementMode::NonrigidIcp => {
            let options = nonrigid_icp::NonrigidIcpOptions::default();
            let found = nonrigid_icp::register(source, target, &options, observer)?;
            let index = ClosestPointIndex::new(source);
            whole.vertices().par_iter().map(|p| found.moved(p, &index.closest(p))).collect()
        }
        DisplacementMode::SpharmPdm => {
            let found = spharm::register(source, target, &spharm::SpharmOptions::default(), observer)?;
            carried(source, &found.images, whole)
        }
        DisplacementMode::Medial => {
            let found = medial::register(source, target, &medial::MedialOptions::default(), observer)?;
            carried(source, &found.images, whole)
        }
        DisplacementMode::FunctionalMap => {
            let options = functional_map::FunctionalMapOptions::default();
            let found = functional_map::register(source, target, &options, observer)?;
            carried(source, &found.images, whole)
        }
        DisplacementMode::Diffeomorphic => {
            let options = diffeomorphic::DiffeomorphicOptions::default();
            let field = diffeomorphic::register(source, target, &options, observer)?;
            field.flowed(whole.vertices(), 1.0, FLOW_STEPS, observer)?
        }
    })
}

/// The vertices of `whole` displaced as the closest points of `source`, whose vertices have these `images`.
fn carried(source: &SurfaceMesh, images: &[Point3<f64>], whole: &SurfaceMesh) -> Vec<Point3<f64>> {
    let index = ClosestPointIndex::new(source);
    let displacement = |k: usize| images[k] - source.vertices()[k];
    whole.vertices().par_iter().map(|p| p + index.closest(p).blend(displacement)).collect()
}

/// The answer for source vertices moved to `moved`, mm. The spread is the sampling error plus the root mean square
/// distance from the target, the only residual that these methods give; it is not calibrated.
fn answered(
    coarse: &MatchProblem<'_>,
    pose: &RigidTransform,
    poses: Vec<PoseDocument>,
    moved: Vec<Point3<f64>>,
) -> VertexImages {
    let scene = &coarse.full;
    let (source, target) = (scene.source.mesh(), scene.target.mesh());
    let squares: f64 = moved.iter().map(|p| (scene.closest.index.closest(p).point - p).norm_squared()).sum();
    let variances = vec![squares / moved.len() as f64; moved.len()];
    let found = images(target, &scene.closest.index, &moved, &variances, scene.edge_mm);
    let no_counterpart = without_counterpart(target, scene.edge_mm, &found);
    let displaced: f64 = source.vertices().iter().zip(&moved).map(|(p, q)| (pose.apply(p) - q).norm_squared()).sum();
    let are_copies = (displaced / moved.len() as f64).sqrt() < MAX_COPY_DISPLACEMENT_EDGES * scene.edge_mm;
    let fitted = absolute_orientation_of(source.vertices(), &moved, Some(&vertex_areas(source)), pose.is_reflection());
    let confidence = found.iter().zip(&no_counterpart).map(|(i, &alone)| if alone { 0.0 } else { i.confidence });
    VertexImages {
        transform: if are_copies { *pose } else { fitted.unwrap_or(*pose) },
        labeling: found.iter().map(|image| image.label).collect(),
        confidence: confidence.collect(),
        spread_mm: found.iter().map(|image| image.spread_mm).collect(),
        poses,
        images: Images::Smooth(SmoothImages {
            points: found.iter().map(|image| image.closest).collect(),
            moved,
            no_counterpart,
        }),
        reliability: None,
        resized: false,
        inference: None,
    }
}
