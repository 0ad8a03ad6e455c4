//! Progress, energy trace and cancellation of a running computation. Every minimizer and the pipeline report to one
//! [`Observer`].
//!
//! The numerics know no clock, no job and no terminal. They report the current phase, the share of the work done and
//! every point of the energy trace, and ask whether to continue. Implementations (the worker, the command line, tests)
//! add sequence numbers and times.

/// The steps of a matching job, in the order in which they usually run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Phase {
    /// Reading both inputs and making closed surfaces of them.
    Reading,
    /// Curvature in scale space on both surfaces.
    Features,
    /// Bounding the energy from below.
    Bounding,
    /// Minimizing the energy.
    Inference,
    /// RANSAC and absolute orientation.
    Registration,
    /// Iterative closest points.
    Refinement,
    /// Fitting a smooth displacement field.
    Displacement,
    /// Distances, consistency and the result document.
    Reporting,
}

impl Phase {
    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Phase::Reading => "reading",
            Phase::Features => "features",
            Phase::Bounding => "bounding",
            Phase::Inference => "inference",
            Phase::Registration => "registration",
            Phase::Refinement => "refinement",
            Phase::Displacement => "displacement",
            Phase::Reporting => "reporting",
        }
    }
}

/// Quantity that the energy of a trace point measures. Energies of different quantities cannot be compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Quantity {
    /// Energy of an assignment over curvature, of all variables.
    CurvatureEnergy,
    /// Energy of an assignment over distances along the surfaces, of all variables.
    IsometryEnergy,
    /// The same for each variable: of the starts of one fit, each a point.
    MeanIsometryEnergy,
    /// Energy of a displacement field, for each independent observation.
    FieldEnergy,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Quantity; 4] =
        [Quantity::CurvatureEnergy, Quantity::IsometryEnergy, Quantity::MeanIsometryEnergy, Quantity::FieldEnergy];

    /// The name used in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::CurvatureEnergy => "curvature_energy",
            Quantity::IsometryEnergy => "isometry_energy",
            Quantity::MeanIsometryEnergy => "mean_isometry_energy",
            Quantity::FieldEnergy => "field_energy",
        }
    }
}

/// One point of the energy trace; fields that have no meaning in a phase are `None` and absent in JSON.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TracePoint {
    /// Clamping round, from 0; in the phase `displacement`, or where assignments are minimized within it, the number of the fit, counted on
    /// from the last round.
    pub round: u32,
    /// Number of the fit, from 0, in the order in which they begin: each begins from another start. Absent outside of fits.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub start: Option<u32>,
    /// Quantity that `energy` and its parts measure; absent without an energy. Only points of one quantity can
    /// be compared, and only those of equal `round` and `start` are one series.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub quantity: Option<Quantity>,
    /// Whether this is the energy of the answer: only the last point of a trace can be, in the phase `reporting`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub chosen: bool,
    /// Where in the pipeline the point was taken.
    pub phase: Phase,
    /// Iteration within the phase of this round, from 1.
    pub iteration: u32,
    /// The energy that `quantity` names; no unit, lower is better. Of an assignment, that of the one decoded at this point, without
    /// clamping terms; of a field, the negative logarithm of the likelihood plus that of the prior, whose scale falls from
    /// step to step, so that the energy can rise.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub energy: Option<f64>,
    /// Sum of the unary potentials; of a field, the misfit of the surfaces.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub energy_unary: Option<f64>,
    /// Sum of the pairwise potentials; of a field, the cost of its deformation.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub energy_pairwise: Option<f64>,
    /// Largest change of any message in this iteration, in the linear domain (messages have maximum 1).
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub message_delta_max: Option<f64>,
    /// Variables whose target vertex changed in this iteration.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "serde", serde(alias = "labels_changed"))]
    pub vertices_changed: Option<u32>,
    /// Temperature of the annealer.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub temperature: Option<f64>,
    /// Best lower bound known on the energy of any assignment.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub lower_bound: Option<f64>,
    /// Inliers of the registration.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub support: Option<u32>,
}

impl TracePoint {
    /// A point with nothing measured yet.
    pub fn new(round: u32, phase: Phase, iteration: u32) -> Self {
        TracePoint {
            round,
            start: None,
            quantity: None,
            chosen: false,
            phase,
            iteration,
            energy: None,
            energy_unary: None,
            energy_pairwise: None,
            message_delta_max: None,
            vertices_changed: None,
            temperature: None,
            lower_bound: None,
            support: None,
        }
    }
}

/// Receives the progress of a computation and may cancel it. All methods are called often and should return quickly;
/// [`Observer::step`] and [`Observer::is_cancelled`] from any thread, the others from one thread at a time.
pub trait Observer: Sync {
    /// The observer that receives every report this one does not handle; none by default.
    fn inner(&self) -> Option<&dyn Observer> {
        None
    }
    /// A phase begins.
    fn phase(&self, phase: Phase) {
        if let Some(inner) = self.inner() {
            inner.phase(phase);
        }
    }
    /// The share of the whole work that is done, in `[0, 1]`; it never falls.
    fn progress(&self, fraction: f64) {
        if let Some(inner) = self.inner() {
            inner.progress(fraction);
        }
    }
    /// A step of the computation begins.
    fn step(&self) {
        if let Some(inner) = self.inner() {
            inner.step();
        }
    }
    /// A point of the energy trace.
    fn trace(&self, point: &TracePoint) {
        if let Some(inner) = self.inner() {
            inner.trace(point);
        }
    }
    /// Whether the computation should end now, without a result.
    fn is_cancelled(&self) -> bool {
        self.inner().is_some_and(|inner| inner.is_cancelled())
    }
}

/// Ignores all reports and never cancels.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Observer for Silent {}

/// The observer asked the computation to stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the computation was cancelled")]
pub struct Cancelled;

/// Begins a step of a computation; `Err(Cancelled)` once `observer` asks to stop.
///
/// # Errors
/// [`Cancelled`].
pub fn checkpoint(observer: &dyn Observer) -> Result<(), Cancelled> {
    observer.step();
    checkpoint_within(observer)
}

/// `Err(Cancelled)` once `observer` asks to stop. Call it within a step, between pieces of work of some milliseconds,
/// from any thread.
///
/// # Errors
/// [`Cancelled`].
pub fn checkpoint_within(observer: &dyn Observer) -> Result<(), Cancelled> {
    if observer.is_cancelled() { Err(Cancelled) } else { Ok(()) }
}
