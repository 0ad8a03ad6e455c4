//! How belief propagation runs: semiring, message update, schedule, damping.

/// Which semiring the messages live in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// Max-product: heads for the labeling of lowest energy.
    Max,
    /// Sum-product: heads for the marginals.
    Sum,
}

/// Which label pairs a message update visits. Both compute the same message: equal bits for max-product, equal to
/// rounding for sum-product, whose terms they add in another order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Update {
    /// Pairs within the neighbourhood `N_r`; all others share the truncation. `O(n k̄)` a message.
    #[default]
    Sparse,
    /// All pairs. `O(n²)` a message, without a table of potentials; for small meshes and as a check of the other.
    Full,
}

/// In which order messages are updated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Schedule {
    /// All messages at once from those of the iteration before.
    #[default]
    Flooding,
    /// The variable with the largest pending change sends next. Settles on many models
    /// where flooding oscillates.
    Residual,
}

/// Update and schedule; the default is the sparse update, flooding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BpMethod {
    /// Which label pairs a message update visits.
    pub update: Update,
    /// In which order messages are updated.
    pub schedule: Schedule,
}

/// Options of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BpOptions {
    /// Which semiring.
    pub product: Product,
    /// Share of the old message that is kept, in `[0, 1)`.
    pub damping: f32,
    /// Smallest value of a message (the largest is 1). With a truncation of infinity it is what a broken
    /// neighbourhood costs a message, as `exp(−T)` is otherwise.
    pub floor: f32,
    /// A run ends when no message changes by more than this.
    pub tolerance: f32,
}
