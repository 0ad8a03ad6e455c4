//! Parameters of the minimiser and of the feedback from registration.

/// The minimiser of the energy.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct InferenceParameters {
    /// Who minimises.
    pub algorithm: Algorithm,
    /// Over which label pairs belief propagation updates a message.
    pub update: Update,
    /// In which order belief propagation updates messages.
    pub schedule: MessageSchedule,
    /// Bits in which belief propagation stores a number of a message, 32 or 16; it computes in 32. With 16, half precision,
    /// messages take half the memory; beliefs are off by a thousandth or so, and labels of nearly equal belief may be
    /// exchanged. For flooding over all labels.
    #[cfg_attr(feature = "serde", serde(default = "default_message_bits"))]
    #[cfg_attr(feature = "openapi", schema(minimum = 16, maximum = 32, multiple_of = 16))]
    pub message_bits: u32,
    /// The energy of larger surfaces is that of coarse levels of about so many vertices, and every vertex is answered
    /// after registration; `null`: every vertex is a variable, every target vertex a label.
    #[cfg_attr(feature = "openapi", schema(minimum = 100, maximum = 20000))]
    pub coarse_vertices: Option<u32>,
    /// Iterations of belief propagation, or sweeps of a randomised minimiser, in the first round at most.
    #[cfg_attr(feature = "openapi", schema(minimum = 1, maximum = 100000))]
    pub max_iterations: u32,
    /// Share of the old message that is kept in every update.
    pub damping: f64,
    /// A round of belief propagation ends when no message changes by more than this.
    pub tolerance: f64,
    /// How the annealers cool.
    pub annealing: AnnealingParameters,
    /// Energy at which `las_vegas` and the annealers stop, the answer being certified; `null`: the lower bound where
    /// one was computed, else none.
    pub target_energy: Option<f64>,
    /// Sweeps without gain after which `las_vegas` starts anew from a random labeling.
    #[cfg_attr(feature = "openapi", schema(minimum = 1, maximum = 10000))]
    pub restart_after: u32,
    /// Iterations of the dual method that bounds the energy from below; 0: no bound.
    #[cfg_attr(feature = "openapi", schema(minimum = 0, maximum = 10000))]
    pub lower_bound_iterations: u32,
}

fn default_message_bits() -> u32 {
    32
}

/// Who minimises the energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Algorithm {
    /// Max-product belief propagation: heads for the labeling of lowest energy.
    MaxProduct,
    /// Sum-product belief propagation: heads for the marginals.
    SumProduct,
    /// Tree-reweighted message passing (TRW-S): raises the lower bound, and decodes a labeling on the way.
    TreeReweighted,
    /// Simulated annealing, every label drawn from its conditional distribution.
    Gibbs,
    /// Simulated annealing, labels proposed and accepted or not.
    Metropolis,
    /// Random moves, taken only when they lower the energy, with restarts.
    LasVegas,
    /// Nobody: registration alone, from `registration.initial`.
    None,
}

/// Over which label pairs a message is updated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Update {
    /// Pairs within the neighbourhood; all others share the truncation.
    Sparse,
    /// Pairs within the neighbourhood, of the labels that can still win: each variable holds its best labels, and those
    /// that its neighbours demand. Nearly the same answer in less time and memory.
    Active,
    /// All pairs: the same messages in more time, for small surfaces and for comparison.
    Full,
}

/// In which order belief propagation updates messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum MessageSchedule {
    /// All at once, from those of the iteration before.
    Flooding,
    /// The one that would change most first.
    Residual,
}

/// How the temperature of an annealer falls.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct AnnealingParameters {
    /// By which law.
    pub schedule: CoolingSchedule,
    /// First temperature, in units of energy; `null`: twice the spread of the energy.
    pub initial_temperature: Option<f64>,
    /// Last temperature; `null`: a two-hundredth of the first. For the logarithmic schedule only a floor.
    pub final_temperature: Option<f64>,
}

/// The law by which a temperature falls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum CoolingSchedule {
    /// By the same factor every sweep.
    Geometric,
    /// With the logarithm of the sweep (Geman, Geman 1984).
    Logarithmic,
    /// By the same amount every sweep.
    Linear,
}

/// Feedback from registration to the energy.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct ClampingParameters {
    /// How the feedback enters the unary potentials.
    pub mode: ClampingMode,
    /// Rounds of feedback at most.
    pub max_rounds: u32,
}

/// How registration feeds back into the unary potentials.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ClampingMode {
    /// No feedback.
    None,
    /// Inlier variables are fixed to their label.
    Hard,
    /// Distance and normal disagreement after registration are added to every unary potential.
    Soft,
}
