//! The parameters of a match: named presets, what overrides them, and every check with the place of the fault.
//!
//! A request states a part; [`resolve()`] lays it over the preset that `method` names and returns the whole, the
//! *effective* parameters, which are stored with the job and returned with its result.

mod displacement;
mod energy;
mod inference;
mod input;
mod landmarks;
mod presets;
#[cfg(feature = "serde")]
mod ranges;
mod registration;
#[cfg(feature = "serde")]
mod resolve;

pub use displacement::{Anatomy, DisplacementMode, DisplacementParameters};
pub use energy::{CurvatureEstimator, EnergyParameters, FeatureKind, FeatureParameters, PairwiseDistance};
pub use inference::{
    Algorithm, AnnealingParameters, ClampingMode, ClampingParameters, CoolingSchedule, InferenceParameters,
    MessageSchedule, Update,
};
pub use input::{InputParameters, Repair, SurfaceKind};
pub use landmarks::Landmark;
pub use presets::{Method, preset};
pub use registration::{InitialPose, MinimalEstimator, OrientationSolver, Refinement, RegistrationParameters};
#[cfg(feature = "serde")]
pub use resolve::resolve;

/// Effective parameters of a match: every value stated.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct MatchParameters {
    /// The preset that the other values started from.
    pub method: Method,
    /// How surfaces are made of the two inputs.
    pub input: InputParameters,
    /// Vertex features of the unary potential.
    pub features: Vec<FeatureParameters>,
    /// The energy.
    pub energy: EnergyParameters,
    /// Who minimises it.
    pub inference: InferenceParameters,
    /// Feedback from registration to the energy.
    pub clamping: ClampingParameters,
    /// The rigid transform.
    pub registration: RegistrationParameters,
    /// The smooth displacement field after it.
    pub displacement: DisplacementParameters,
    /// Points that are known to correspond: they enter the unary potentials, the poses and the displacement field.
    #[cfg_attr(feature = "openapi", schema(max_items = 1000))]
    pub landmarks: Vec<Landmark>,
    /// Whether the map from target to source is answered too.
    pub both_directions: bool,
    /// Seed of everything that is drawn at random.
    pub seed: u64,
}

/// A fault in the parameters: where, which kind, what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ParameterError {
    /// JSON pointer into the parameters, such as `/energy/alpha`.
    pub pointer: String,
    /// `unknown_key`, `wrong_type` or `out_of_range`.
    pub code: String,
    /// One sentence that says what is wrong and what is allowed.
    pub detail: String,
}
