//! Parameters of the minimizer and of the feedback from registration.

/// The minimizer of the energy.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct InferenceParameters {
    /// The algorithm. The method `balanced` has `none`, but `max_product` for a request that names no algorithm and states anything else about
    /// the energy of assignments: `features`, `energy`, `inference`, `clamping` or RANSAC's parameters, or landmarks without a smooth field.
    pub algorithm: Algorithm,
    /// Pairs of target vertices that belief propagation considers when it updates a message.
    pub update: Update,
    /// Vertices of the coarse levels on which the energy of larger surfaces is minimized; corresponding points of all
    /// vertices are determined after registration. `null`: every source vertex is a variable, every target vertex one of its choices.
    #[cfg_attr(feature = "openapi", schema(minimum = 100, maximum = 20000))]
    pub coarse_vertices: Option<u32>,
    /// Most iterations of belief propagation, or sweeps of a randomized minimizer, in the first round. Later rounds have a
    /// quarter of that.
    #[cfg_attr(feature = "openapi", schema(minimum = 1, maximum = 100000))]
    pub max_iterations: u32,
    /// Share of the old message that is kept in every update of belief propagation.
    pub damping: f64,
    /// A round of belief propagation ends when no message changes by more than this.
    pub tolerance: f64,
    /// Cooling of simulated annealing (`gibbs` and `metropolis`).
    pub annealing: AnnealingParameters,
    /// Energy at which `las_vegas`, `gibbs` and `metropolis` stop with a certified answer; `null`: the lower bound if one was
    /// computed, otherwise none.
    pub target_energy: Option<f64>,
    /// Sweeps without a lower energy after which `las_vegas` restarts from a random assignment.
    #[cfg_attr(feature = "openapi", schema(minimum = 1, maximum = 10000))]
    pub restart_after: u32,
    /// Iterations of the dual method that computes a lower bound of the energy; 0: no bound is computed.
    #[cfg_attr(feature = "openapi", schema(minimum = 0, maximum = 10000))]
    pub lower_bound_iterations: u32,
}

/// Algorithm that minimizes the energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Algorithm {
    /// Max-product belief propagation: approximates the assignment of lowest energy.
    MaxProduct,
    /// Sum-product belief propagation: approximates the marginals, and takes the most probable target vertex of each variable.
    SumProduct,
    /// Tree-reweighted message passing (TRW-S): raises a lower bound of the energy and decodes an assignment from it.
    TreeReweighted,
    /// Simulated annealing with the Gibbs sampler: every target vertex is drawn from its conditional distribution.
    Gibbs,
    /// Simulated annealing with the Metropolis sampler: a target vertex is proposed, then accepted or rejected.
    Metropolis,
    /// Random moves that are accepted only when they lower the energy, with restarts.
    LasVegas,
    /// No energy of assignments is minimized: the pose comes from `registration.initial`. With `search` and a smooth field, the field compares the
    /// poses of the search.
    None,
}

/// Pairs of target vertices that the update of a message considers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Update {
    /// Pairs within the neighborhood radius; all others share the truncation. Gives the same messages as `full`.
    Sparse,
    /// Pairs within the neighborhood radius, restricted to the target vertices of lowest unary potential of each variable and those
    /// near the best ones of its neighbors. Nearly the same answer in less time and memory.
    Active,
    /// All pairs: the same messages as `sparse` in more time, for small surfaces and for comparison.
    Full,
}

/// Temperatures of simulated annealing.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct AnnealingParameters {
    /// The law by which the temperature falls.
    pub schedule: CoolingSchedule,
    /// Initial temperature, in units of energy; `null`: twice the spread of the energy.
    pub initial_temperature: Option<f64>,
    /// Final temperature; `null`: a two-hundredth of the initial one. For the `logarithmic` schedule it is a lower limit.
    pub final_temperature: Option<f64>,
}

/// Law by which the temperature falls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum CoolingSchedule {
    /// By the same factor in every sweep.
    Geometric,
    /// With the logarithm of the number of the sweep (Geman, Geman 1984).
    Logarithmic,
    /// By the same amount in every sweep.
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
    /// Most rounds of feedback.
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
    /// Inlier variables are fixed to their target vertices.
    Hard,
    /// The distance and the disagreement of normals after registration are added to every unary potential.
    Soft,
}
