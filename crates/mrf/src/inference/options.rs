//! How belief propagation runs: semiring, message update, schedule, damping.

/// Which semiring the messages live in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// Max-product: approximates the labeling of lowest energy; exact on trees.
    Max,
    /// Sum-product: approximates the marginals; exact on trees.
    Sum,
}

/// Which label pairs a message update visits. Both compute the same message: equal bits for max-product, equal to
/// rounding for sum-product, whose terms they add in another order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Update {
    /// Pairs within the neighborhood `N_r`; all others share the truncation. `O(n k̄)` a message.
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

/// In which numbers messages are stored; they are computed in 32 bits in any case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MessageStorage {
    /// Single precision, 32 bits.
    #[default]
    Single,
    /// Half precision, binary16 of IEEE 754, in half the memory. A message is rounded to a relative `2⁻¹¹` above `2⁻¹⁴`
    /// (6e-5) and to `2⁻²⁵` absolute below, and its floor is at least `2⁻²⁴` (6e-8). Changes are those of the stored
    /// messages: none, or a step between two numbers of 16 bits, `2⁻¹¹` near 1. Flooding only; the residual schedule,
    /// whose bounds on what is pending are finer than such steps, stores single precision all the same.
    Half,
}

/// Update, schedule and storage; the default is the sparse update, flooding, single precision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BpMethod {
    /// Which label pairs a message update visits.
    pub update: Update,
    /// In which order messages are updated.
    pub schedule: Schedule,
    /// In which numbers messages are stored.
    pub storage: MessageStorage,
}

/// Options of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BpOptions {
    /// Which semiring.
    pub product: Product,
    /// Share of the old message that is kept, in `[0, 1)`.
    pub damping: f32,
    /// Smallest value of a message (the largest is 1). With a truncation of infinity it is what a broken
    /// neighborhood costs a message, as `exp(−T)` is otherwise.
    pub floor: f32,
    /// A run ends when no message changes by more than this.
    pub tolerance: f32,
}
