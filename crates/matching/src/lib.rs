//! Matches two surfaces: a dense correspondence and a rigid transform.
//!
//! A match runs in four stages, each of which hands an immutable value to the next:
//!
//! 1. **Coarse.** If an energy of labels is asked for, curvature in scale space on both surfaces makes it (a Markov random field whose
//!    variables are source vertices and whose labels are target vertices) on a coarse level of the surfaces.
//! 2. **Posed.** A minimiser finds a labeling; RANSAC finds the rigid transform that most of its pairs agree with; clamping feeds that
//!    transform back into the energy, round by round; ICP refines it. Or registration alone finds a pose, without an energy. By
//!    default the pose is left to the field.
//! 3. **Displaced.** A smooth displacement field moves the source, from the pose that fits best after the deformation,
//!    and every source vertex gets an image on the target, between vertices. Without a field the images are vertices.
//! 4. **Measured.** Support, distances, outliers, topology, and the map back to the source.
//!
//! The [`Method`]s are presets of [`MatchParameters`]: which minimiser runs, if any, and which stages do what.
//!
//! ```
//! use homolog_matching::{Method, Silent, SurfaceMesh, match_surfaces, preset, shapes};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let source: SurfaceMesh = shapes::ellipsoid([16.0, 8.0, 6.0].into(), 2);
//! let tapered = source.vertices().iter().map(|p| [p.x, p.y * (1.0 + 0.03 * p.x), p.z].into());
//! let target = source.with_vertices(tapered.collect())?;
//! let outcome = match_surfaces(&source, &target, &preset(Method::Balanced), &Silent)?;
//! println!("distance {:.2} mm, {:?}", outcome.surface_distance.mean_mm, outcome.transform.matrix);
//! for (source_vertex, target_vertex) in outcome.correspondences.source.iter().zip(&outcome.correspondences.target) {
//!     println!("{source_vertex} corresponds to {target_vertex}");
//! }
//! # Ok(())
//! # }
//! ```
//!
//! Parameters are checked by [`MatchParameters::check`], not by [`match_surfaces`]. An [`Observer`] is told phases,
//! progress and the energy trace, and may cancel. This crate reads no files and starts no threads of its own but those of
//! the current rayon pool; without its feature `serde` it has no wire form either.

mod active_labels;
mod bound;
mod candidate_poses;
mod clamping;
mod coarse;
pub mod consistency;
mod copies;
mod deformation;
mod displaced;
#[cfg(test)]
mod displaced_tests;
mod displacement;
mod features;
mod field_methods;
mod inverse;
mod lengths;
mod levels;
mod light_smoothing;
mod minimiser;
pub mod outliers;
mod pipeline;
mod posed;
mod prepare;
mod registration_only;
mod reliability;
mod report;
mod resized;
mod robust;
mod round_axis;
mod rounds;
mod scene;
mod side;
#[cfg(test)]
mod stages_tests;
mod surface_index;
#[cfg(test)]
mod testing {
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    /// Uniform numbers in `[0, 1)`.
    pub(crate) fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        move || (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }
}
#[cfg(test)]
mod tests;
mod vertex_map;

pub use displacement::{NearIsometryModel, near_isometry_model};
pub use homolog_contract::parameters::{self, MatchParameters, Method, preset};
pub use homolog_contract::result;
pub use homolog_mesh::{FaceArity, MeshError, SurfaceMesh, shapes};
pub use homolog_primitives::observe::{Cancelled, Observer, Phase, Silent, TracePoint};
pub use levels::Levels;

use homolog_contract::parameters::{Algorithm, Bending, DisplacementMode};
use homolog_contract::result::{
    ConsistencyDocument, Correspondences, DeformationDocument, EnergyDocument, PoseDocument, ReliabilityDocument,
    RoundDocument, StopReason, SupportDocument, SurfaceDistanceDocument, TransformDocument,
};
use homolog_geometry::harmonics::HarmonicsError;
use homolog_mrf::MrfModel;

/// The result of [`match_surfaces`]. With timings and provenance it makes a [`result::ResultDocument`].
#[derive(Debug, Clone, PartialEq)]
pub struct MatchOutcome {
    /// The rigid transform.
    pub transform: TransformDocument,
    /// The correspondences that support it.
    pub support: SupportDocument,
    /// Distance between the registered surfaces.
    pub surface_distance: SurfaceDistanceDocument,
    /// Energies of the answer; `None` where no energy was minimised.
    pub energy: Option<EnergyDocument>,
    /// Quality of the map.
    pub topology: ConsistencyDocument,
    /// How the map to the corresponding points deforms the source; `None` if no triangle has a counterpart.
    pub deformation: Option<DeformationDocument>,
    /// The rounds of inference and registration; empty where no energy was minimised.
    pub rounds: Vec<RoundDocument>,
    /// Candidate poses that were compared, the best first.
    pub poses: Vec<PoseDocument>,
    /// Whether the answer can be relied on; `None` where no displacement field was fitted.
    pub reliability: Option<ReliabilityDocument>,
    /// Whether two semi-axes of a first-order ellipsoid are so nearly equal that the rotation about the third is arbitrary.
    pub ambiguous_axes: bool,
    /// The dense correspondence.
    pub correspondences: Correspondences,
    /// Why inference ended.
    pub stop_reason: StopReason,
}

/// Why a match has no result. A minimiser that does not converge is no error: the [`MatchOutcome`] says so.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MatchError {
    /// The observer asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No rigid transform is supported by three labels of the first round, and nothing else can give a pose.
    ///
    /// A displacement field can start from the landmarks or from a search of all orientations, and registration alone always
    /// has a pose. So this is the error of an energy that is minimised without a displacement field (the presets `thesis`,
    /// `gibbs`, `metropolis` and `las_vegas`), and of a displacement field for which the search found no pose either, as on
    /// surfaces without area.
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
        /// The fault of the parametrization.
        error: HarmonicsError,
    },
    /// The heat flow that smooths the surface could not be solved.
    #[error("curvature at scale {scale_mm} mm could not be computed: the surface has degenerate faces")]
    ScaleSpace {
        /// Scale, mm.
        scale_mm: f64,
    },
    /// The spectrum that a heat or wave kernel signature is made of could not be computed.
    #[error("the spectrum of the surface could not be computed: it has degenerate faces")]
    Spectrum,
}

/// Memory of a match for each vertex of either surface, bytes, without messages: 568 MiB were measured at 2 × 155,000.
const BYTES_PER_VERTEX: u64 = 2048;

/// Memory for each source vertex of the source at the size of the target, bytes: 69 MB more were measured at 86,709. Whether the sizes
/// differ is not known from the numbers of vertices.
const BYTES_PER_RESIZED_VERTEX: u64 = 800;

/// Memory of belief propagation over distances along the surface on two threads, bytes: with the forms of both surfaces 45 MiB more were
/// measured at 2 × 5,000. The messages of a start take 8 MiB (about 1,900 edges in two directions, 512 labels, 32 bits), and each further thread
/// has one more start at work. Whether surfaces bend is not known from the numbers of vertices.
const BYTES_OF_NEAR_ISOMETRIES: u64 = 16 << 20;

/// Peak memory of matching surfaces of these sizes, bytes; accurate to a tenth where messages dominate. `source` is the
/// number of vertices and faces.
///
/// On the level on which the energy is minimised: the messages once and a quarter of them again (those that are read while
/// they are replaced), in 32 or 16 bits, and two tables of unary potentials in 32; a share for each vertex; and that of a
/// method of the field for each vertex of the thinned surfaces that it is given, and the bending-invariant forms. A closed
/// surface of genus 0 has `V + F − 2` edges, whatever its faces.
pub fn match_memory_bytes(source: (usize, usize), target_vertices: usize, parameters: &MatchParameters) -> u64 {
    let (mut vertices, faces, mut labels) = (source.0 as u64, source.1 as u64, target_vertices as u64);
    let of_method = field_methods::limits(parameters.displacement.mode)
        .map_or(0, |(most, bytes)| bytes * (vertices.min(most as u64) + labels.min(most as u64)));
    let resized = match parameters.displacement.mode {
        DisplacementMode::Smooth => BYTES_PER_RESIZED_VERTEX * vertices,
        _ => 0,
    };
    let bent = match (parameters.displacement.mode, parameters.displacement.bending) {
        (DisplacementMode::Smooth, Bending::NearIsometry) => {
            let form = |n_vertices: u64| displacement::Form::heap_bytes_over(n_vertices as usize) as u64;
            form(vertices) + form(labels) + BYTES_OF_NEAR_ISOMETRIES
        }
        _ => 0,
    };
    let each = BYTES_PER_VERTEX * (vertices + labels) + resized + bent + of_method;
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

/// The energy on the coarse levels of two surfaces, as [`match_levels`] minimises it in its first round.
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub fn coarse_energy_model(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
) -> Result<MrfModel, MatchError> {
    prepare::build_model(&source.energy().side, &target.energy().side, parameters)
}

/// Matches `source` to `target` and registers them. Correspondences use the vertex indices of these two meshes.
///
/// `source` is moved onto `target`; both are surfaces of any topology whose faces look outwards, mm. The answer is the same
/// to the bit for the same surfaces, parameters and seed, on any number of threads, and renumbering the vertices of an input
/// permutes it. Parameters are taken as they are: [`MatchParameters::check`] says which values are allowed.
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

/// [`match_surfaces`] from levels that were made before, with the `inference.coarse_vertices` of `parameters`. Gives the same
/// bits, whatever else these levels were matched with. Every vertex index of the outcome is an original of the numbering
/// that the levels were made with ([`Levels::numbered`]).
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
