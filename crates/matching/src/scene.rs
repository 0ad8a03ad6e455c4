//! What every step of a match looks at: both surfaces, the parameters, and who watches.

use super::MatchError;
use super::side::Side;
use super::surface_index::SurfaceIndex;
use homolog_contract::parameters::{DisplacementMode, MatchParameters, Refinement};
use homolog_primitives::observe::{Observer, Phase};
use homolog_registration::{IcpMetric, IcpOptions, RigidTransform, refine_icp};
use nalgebra::Point3;

/// Inlier tolerance in mean target edge lengths where the request states none.
const TOLERANCE_EDGES: f64 = 3.0;
/// Share of the source vertices that ICP keeps: the rest may have no counterpart.
const ICP_KEEP: f64 = 0.9;
const ICP_ITERATIONS: u32 = 100;
/// Steps at most where a displacement field follows: it wants a pose, not the last digit.
const ICP_ITERATIONS_OF_A_START: u32 = 15;
const ICP_TOLERANCE: f64 = 1e-6;
/// Source vertices at most over which the distance of a pose is measured.
const SAMPLE: usize = 500;

/// Two surfaces that are being matched.
pub(super) struct Scene<'a> {
    pub source: &'a Side,
    pub target: &'a Side,
    /// Closest points of the target.
    pub closest: &'a SurfaceIndex,
    pub parameters: &'a MatchParameters,
    /// Mean target edge length.
    pub edge_mm: f64,
    /// Largest residual of an inlier.
    pub tolerance_mm: f64,
    pub observer: &'a dyn Observer,
}

impl<'a> Scene<'a> {
    pub fn new(
        source: &'a Side,
        target: &'a Side,
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
    pub fn images(&self, labeling: &[u32]) -> Vec<Point3<f64>> {
        labeling.iter().map(|&x| self.target.mesh().vertices()[x as usize]).collect()
    }

    /// Root mean square distance of the source, moved by `pose`, from the target, over a sample of its vertices, mm.
    pub fn sample_rms_mm(&self, pose: &RigidTransform) -> f64 {
        let source = self.source.mesh().vertices();
        // Canonical numbering follows a curve through space, so every k-th vertex is an even sample.
        let moved: Vec<_> = source.iter().step_by(source.len().div_ceil(SAMPLE)).map(|p| pose.apply(p)).collect();
        let squares: f64 = moved.iter().map(|p| (self.closest.index.closest(p).point - p).norm_squared()).sum();
        (squares / moved.len() as f64).sqrt()
    }

    /// `start` improved by closest points, as the parameters ask.
    pub fn refine(&self, start: &RigidTransform) -> Result<RigidTransform, MatchError> {
        let metric = match self.parameters.registration.refine {
            Refinement::None => return Ok(*start),
            Refinement::PointToPoint => IcpMetric::PointToPoint,
            Refinement::PointToPlane => IcpMetric::PointToPlane,
        };
        self.observer.phase(Phase::Refinement);
        let max_iterations = match self.parameters.displacement.mode {
            DisplacementMode::None => ICP_ITERATIONS,
            DisplacementMode::Smooth => ICP_ITERATIONS_OF_A_START,
        };
        let options = IcpOptions { metric, keep: ICP_KEEP, max_iterations, tolerance: ICP_TOLERANCE };
        let report = refine_icp(self.source.mesh().vertices(), self.closest, start, &options, self.observer)?;
        Ok(report.target_from_source)
    }
}
