//! The pipeline: two surfaces in, a dense correspondence and a rigid transform out.
//!
//! Features in scale space make the energy; belief propagation finds a labeling; RANSAC finds the rigid transform
//! that most of its pairs agree with; clamping feeds that back into the energy, round by round; ICP refines.
//! This is where the MRF, which knows no mesh, and registration, which knows no energy, meet.

mod active_labels;
mod bending;
#[cfg(test)]
mod bending_tests;
mod border;
mod bound;
mod clamping;
pub mod consistency;
mod displacement;
mod inverse;
mod levels;
mod light_smoothing;
mod minimiser;
pub mod outliers;
mod pipeline;
mod poses;
mod prepare;
mod registration_only;
mod reliability;
mod report;
mod rivals;
mod rounds;
mod scene;
mod side;
mod surface_index;
#[cfg(test)]
mod tests;

pub use levels::Levels;

use homolog_contract::parameters::{Algorithm, MatchParameters};
use homolog_contract::result::{
    AnatomyDocument, ConsistencyDocument, Correspondences, EnergyDocument, PoseDocument, ReliabilityDocument,
    RoundDocument, StopReason, SupportDocument, SurfaceDistanceDocument, TransformDocument,
};
use homolog_geometry::harmonics::HarmonicsError;
use homolog_mesh::SurfaceMesh;
use homolog_mrf::MrfModel;
use homolog_primitives::observe::{Cancelled, Observer, Phase};

/// What [`match_surfaces`] found; the caller adds timings and provenance to make a [`result::ResultDocument`].
#[derive(Debug, Clone, PartialEq)]
pub struct MatchOutcome {
    /// The rigid transform.
    pub transform: TransformDocument,
    /// Its support.
    pub support: SupportDocument,
    /// Distance of the registered surfaces.
    pub surface_distance: SurfaceDistanceDocument,
    /// Energies, if any was minimised.
    pub energy: Option<EnergyDocument>,
    /// Quality of the map.
    pub topology: ConsistencyDocument,
    /// What each round did.
    pub rounds: Vec<RoundDocument>,
    /// Poses that were compared.
    pub poses: Vec<PoseDocument>,
    /// Whether the answer can be relied on, where a displacement field was fitted.
    pub reliability: Option<ReliabilityDocument>,
    /// What knowledge of the structure changed.
    pub anatomy: Option<AnatomyDocument>,
    /// Whether an ellipsoid has two half axes so alike that the rotation about the third is arbitrary.
    pub ambiguous_axes: bool,
    /// The dense correspondence.
    pub correspondences: Correspondences,
    /// Why inference ended.
    pub stop_reason: StopReason,
}

/// Why a match has no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MatchError {
    /// The observer asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No transform had three inliers.
    #[error("no rigid transform is supported by three correspondences within {tolerance_mm} mm")]
    NoRegistration {
        /// Tolerance of an inlier, mm.
        tolerance_mm: f64,
    },
    /// A surface has no first-order ellipsoid.
    #[error("the {surface} has no first-order ellipsoid: {error}")]
    NoEllipsoid {
        /// `source` or `target`.
        surface: &'static str,
        /// Why.
        error: HarmonicsError,
    },
    /// The heat flow that smooths the surface could not be solved.
    #[error("curvature at scale {scale_mm} mm could not be computed: the surface has degenerate faces")]
    ScaleSpace {
        /// Scale, mm.
        scale_mm: f64,
    },
}

/// Bytes of a match for each vertex of either surface, whatever is minimised: 568 MiB were measured at 2 × 155,000.
const BYTES_PER_VERTEX: u64 = 2048;

/// Bytes that matching surfaces of these sizes takes at its peak, within a tenth where messages are most of it: the
/// messages once, a quarter of them for those that are still read while they are made anew, in 32 or 16 bits, and two
/// tables of unary potentials in 32, on the level on which the energy is minimised; and a share for each vertex. `source`
/// is vertices and faces.
///
/// A closed surface of genus 0 has `V + F − 2` edges, whatever its faces.
pub fn match_memory_bytes(source: (usize, usize), target_vertices: usize, parameters: &MatchParameters) -> u64 {
    let (mut vertices, faces, mut labels) = (source.0 as u64, source.1 as u64, target_vertices as u64);
    let each = BYTES_PER_VERTEX * (vertices + labels);
    if parameters.inference.algorithm == Algorithm::None {
        return each;
    }
    let mut directed_edges = 2 * (vertices + faces).saturating_sub(2);
    if let Some(coarse) = parameters.inference.coarse_vertices.map(u64::from) {
        labels = labels.min(coarse);
        if coarse < vertices {
            (vertices, directed_edges) = (coarse, 6 * coarse);
        }
    }
    let message_bytes = u64::from(parameters.inference.message_bits) / 8;
    each + (message_bytes * (directed_edges + directed_edges / 4) + 4 * 2 * vertices) * labels
}

/// The energy of matching `source` to `target`, as [`match_surfaces`] minimises it in its first round. Variables and
/// labels are in canonical numbering (see [`homolog_mesh::canonicalize`]).
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub fn energy_model(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    parameters: &MatchParameters,
) -> Result<MrfModel, MatchError> {
    prepare::build_model(&side::Side::new(source), &side::Side::new(target), parameters)
}

/// Matches `source` to `target` and registers them. Correspondences count the vertices of these two meshes.
///
/// The answer is the same to the bit for the same surfaces, parameters and seed, on any number of threads, and
/// renumbering the vertices of an input permutes it.
///
/// # Errors
/// [`MatchError`].
///
/// # Cost
/// Time `O(iterations · |E→| · n' · k̄)`; memory `1.25·|E→|·n'` numbers of 32 or 16 bits for the messages, for `n'` labels,
/// `|E→|` directed edges and `k̄` labels within the neighbourhood radius on the level on which the energy is minimised;
/// and `O(n log n)` for the vertices beside it.
pub fn match_surfaces(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    observer.phase(Phase::Features);
    let coarse = parameters.inference.coarse_vertices;
    let (source, target) = rayon::join(|| Levels::new(source, coarse), || Levels::new(target, coarse));
    match_levels(&source, &target, parameters, observer)
}

/// [`match_surfaces`] from levels that were made before, with the `inference.coarse_vertices` of `parameters`; the same
/// to the bit, whatever else these levels were matched with. Every vertex index of the outcome is an original of the
/// numbering that the levels were made with ([`Levels::numbered`]).
///
/// # Errors
/// [`MatchError`].
pub fn match_levels(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<MatchOutcome, MatchError> {
    pipeline::run(source, target, parameters, observer)
}
