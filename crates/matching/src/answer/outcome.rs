//! The result of a match.

use homolog_contract::result::{
    ConsistencyDocument, Correspondences, DeformationDocument, EnergyDocument, PoseDocument, ReliabilityDocument,
    RoundDocument, StopReason, SupportDocument, SurfaceDistanceDocument, TransformDocument,
};

/// The result of [`crate::match_surfaces`]. With timings and provenance it makes a
/// [`homolog_contract::result::ResultDocument`].
#[derive(Debug, Clone, PartialEq)]
pub struct MatchOutcome {
    /// The rigid transform.
    pub transform: TransformDocument,
    /// The correspondences that support the transform.
    pub support: SupportDocument,
    /// Distance between the registered surfaces.
    pub surface_distance: SurfaceDistanceDocument,
    /// Energies of the answer; `None` if no energy was minimized.
    pub energy: Option<EnergyDocument>,
    /// Quality of the map.
    pub topology: ConsistencyDocument,
    /// Deformation of the source by the map to the corresponding points; `None` if no triangle has a counterpart.
    pub deformation: Option<DeformationDocument>,
    /// The rounds of inference and registration; empty if no energy was minimized.
    pub rounds: Vec<RoundDocument>,
    /// Candidate poses that were compared, the best first.
    pub poses: Vec<PoseDocument>,
    /// Whether the answer can be relied on; `None` if no displacement field was fitted.
    pub reliability: Option<ReliabilityDocument>,
    /// Whether two semi-axes of a first-order ellipsoid are so nearly equal that the rotation about the third is
    /// arbitrary.
    pub ambiguous_axes: bool,
    /// The dense correspondence.
    pub correspondences: Correspondences,
    /// Why inference ended.
    pub stop_reason: StopReason,
}
