//! The parameters of a match: named presets, requests that override them, and checks that locate each fault.
//!
//! A request sets some of them. [`resolve()`] overrides the preset named by `method` with these and returns the
//! complete, *effective* parameters, which are stored with the job and returned with its result.

mod displacement;
mod energy;
mod inference;
mod input;
mod landmarks;
mod presets;
#[cfg(feature = "serde")]
mod ranges;
mod registration;
#[cfg(feature = "openapi")]
mod request;
#[cfg(feature = "serde")]
mod resolve;

pub use displacement::{Bending, DisplacementMode, DisplacementParameters, FieldStarts, Uncertainty};
pub use energy::{CurvatureEstimator, EnergyParameters, FeatureKind, FeatureParameters, PairwiseDistance, Precisions};
pub use inference::{
    Algorithm, AnnealingParameters, ClampingMode, ClampingParameters, CoolingSchedule, InferenceParameters, Update,
};
pub use input::{InputParameters, LabelChoice, Repair, SideParameters, SurfaceKind};
pub use landmarks::Landmark;
pub use presets::{Method, preset};
#[cfg(feature = "serde")]
pub use ranges::{BOUNDS, Bounds, LENGTHS, Lengths};
pub use registration::{InitialPose, MinimalEstimator, OrientationSolver, Refinement, RegistrationParameters};
#[cfg(feature = "openapi")]
pub use request::{PartialParameters, parameter_schemas};
#[cfg(feature = "serde")]
pub use resolve::resolve;

/// Effective parameters of a match: every value stated.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct MatchParameters {
    /// The preset that supplies every value a request does not state.
    pub method: Method,
    /// How surfaces are made from the two inputs.
    pub input: InputParameters,
    /// Vertex features of the unary potential.
    pub features: Vec<FeatureParameters>,
    /// The energy that is minimized.
    pub energy: EnergyParameters,
    /// The algorithm that minimizes the energy, and its settings.
    pub inference: InferenceParameters,
    /// Feedback from registration to the energy.
    pub clamping: ClampingParameters,
    /// How the rigid transform is estimated.
    pub registration: RegistrationParameters,
    /// The smooth displacement field that is fitted after the rigid transform.
    pub displacement: DisplacementParameters,
    /// Pairs of points that are known to correspond. They enter the unary potentials, the candidate poses and the
    /// displacement field.
    #[cfg_attr(feature = "openapi", schema(max_items = 1000))]
    pub landmarks: Vec<Landmark>,
    /// Whether the result also contains the map from target to source.
    pub both_directions: bool,
    /// Seed of all random draws.
    pub seed: u64,
}

/// A fault in the parameters: its place, its kind, and the allowed values.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ParameterError {
    /// JSON pointer into the parameters, such as `/energy/alpha`.
    pub pointer: String,
    /// `unknown_key`, `wrong_type` or `out_of_range`.
    pub code: String,
    /// One sentence on the fault and the allowed values.
    pub detail: String,
}
