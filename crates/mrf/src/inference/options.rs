//! Options of belief propagation: semiring, message update, schedule, damping.

/// Semiring of the messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// Max-product: approximates the labeling of lowest energy; exact on trees.
    Max,
    /// Sum-product: approximates the marginals; exact on trees.
    Sum,
}

/// Label pairs visited by a message update. Both variants compute the same message: equal bits for max-product, equal
/// to rounding for sum-product, whose terms they add in a different order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Update {
    /// Pairs within the neighborhood `N_r`; all others share the truncation. `O(n k̄)` per message.
    #[default]
    Sparse,
    /// All pairs. `O(n²)` per message, without a table of potentials; for small meshes and as a check of the sparse
    /// update.
    Full,
}

/// Order in which messages are updated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Schedule {
    /// All messages at once from those of the previous iteration.
    #[default]
    Flooding,
    /// The variable with the largest pending change sends next. Settles on many models
    /// where flooding oscillates.
    Residual,
}

/// Number format in which messages are stored; they are computed in 32 bits in any case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MessageStorage {
    /// Single precision, 32 bits.
    #[default]
    Single,
    /// Half precision, binary16 of IEEE 754, in half the memory. A message is rounded to a relative `2⁻¹¹` above `2⁻¹⁴`
    /// (6e-5) and to `2⁻²⁵` absolute below, and its floor is at least `2⁻²⁴` (6e-8). Reported changes are those of the
    /// stored messages: 0, or a step between two numbers of 16 bits, `2⁻¹¹` near 1. Applies to flooding only; the
    /// residual schedule always stores single precision, because its bounds on pending changes are finer than such
    /// steps.
    Half,
}

/// Update, schedule and storage; the default is the sparse update, flooding, single precision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BpMethod {
    /// Label pairs visited by a message update.
    pub update: Update,
    /// Order in which messages are updated.
    pub schedule: Schedule,
    /// Number format in which messages are stored.
    pub storage: MessageStorage,
}

/// Options of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BpOptions {
    /// The semiring.
    pub product: Product,
    /// Share of the old message that is kept, in `[0, 1)`.
    pub damping: f32,
    /// Smallest value of a message (the largest is 1). With an infinite truncation it is the cost of a broken
    /// neighborhood for a message, in the place of `exp(−T)`.
    pub floor: f32,
    /// Largest change of a message at which a run ends.
    pub tolerance: f32,
}
