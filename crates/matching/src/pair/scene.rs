//! The inputs of every step of a match: both surfaces on one level, the parameters, and the observer.

use crate::error::MatchError;
use crate::surface::side::SurfaceLevel;
use crate::surface::surface_index::SurfaceIndex;
use homolog_contract::parameters::{DisplacementMode, MatchParameters, Refinement};
use homolog_primitives::observe::{Observer, Phase};
use homolog_registration::{IcpMetric, IcpOptions, RigidTransform, refine_icp};
use nalgebra::Point3;

/// Default inlier tolerance, in mean target edge lengths.
const TOLERANCE_EDGES: f64 = 3.0;
/// Share of the source vertices that ICP keeps; the others may have no counterpart.
const ICP_KEEP: f64 = 0.9;
const ICP_ITERATIONS: u32 = 100;
/// Most steps if a displacement field follows, which needs only an approximate pose.
const ICP_ITERATIONS_OF_A_START: u32 = 15;
const ICP_TOLERANCE: f64 = 1e-6;
/// Most source vertices over which poses are compared.
const SAMPLE: usize = 500;

/// At most 500 of `points`, which are in canonical numbering. Canonical numbering follows a space-filling curve, so
/// every k-th point is an even sample.
pub(crate) fn even_sample(points: &[Point3<f64>]) -> impl Iterator<Item = &Point3<f64>> {
    points.iter().step_by(points.len().div_ceil(SAMPLE).max(1))
}

/// Two surfaces of a match, on one level.
#[derive(Clone, Copy)]
pub(crate) struct Scene<'a> {
    pub source: &'a SurfaceLevel,
    pub target: &'a SurfaceLevel,
    /// Closest points of the target.
    pub closest: &'a SurfaceIndex,
    pub parameters: &'a MatchParameters,
    /// Mean target edge length, mm.
    pub edge_mm: f64,
    /// Largest residual of an inlier, mm.
    pub tolerance_mm: f64,
    pub observer: &'a dyn Observer,
}

impl<'a> Scene<'a> {
    pub(crate) fn new(
        source: &'a SurfaceLevel,
        target: &'a SurfaceLevel,
        parameters: &'a MatchParameters,
        observer: &'a dyn Observer,
    ) -> Self {
        let edge_mm = target.mesh().mean_edge_length();
        Scene {
            closest: target.closest(),
            source,
            target,
            parameters,
            edge_mm,
            tolerance_mm: parameters.registration.tolerance_mm.unwrap_or(TOLERANCE_EDGES * edge_mm),
            observer,
        }
    }

    /// The target points of a labeling.
    pub(crate) fn images(&self, labeling: &[u32]) -> Vec<Point3<f64>> {
        labeling.iter().map(|&x| self.target.mesh().vertices()[x as usize]).collect()
    }

    /// Root mean square distance from the target of the source moved by `pose`, over a sample of its vertices, mm.
    pub(crate) fn sample_rms_mm(&self, pose: &RigidTransform) -> f64 {
        let source = self.source.mesh().vertices();
        let moved: Vec<_> = even_sample(source).map(|p| pose.apply(p)).collect();
        let squares: f64 = moved.iter().map(|p| (self.closest.index.closest(p).point - p).norm_squared()).sum();
        (squares / moved.len() as f64).sqrt()
    }

    /// `start` refined by ICP, according to the parameters.
    pub(crate) fn refine(&self, start: &RigidTransform) -> Result<RigidTransform, MatchError> {
        let metric = match self.parameters.registration.refine {
            Refinement::None => return Ok(*start),
            Refinement::PointToPoint => IcpMetric::PointToPoint,
            Refinement::PointToPlane => IcpMetric::PointToPlane,
        };
        self.observer.phase(Phase::Refinement);
        let max_iterations = match self.parameters.displacement.mode {
            DisplacementMode::None => ICP_ITERATIONS,
            _ => ICP_ITERATIONS_OF_A_START,
        };
        let options = IcpOptions { metric, keep: ICP_KEEP, max_iterations, tolerance: ICP_TOLERANCE };
        let report = refine_icp(self.source.mesh().vertices(), self.closest, start, &options, self.observer)?;
        Ok(report.target_from_source)
    }
}
