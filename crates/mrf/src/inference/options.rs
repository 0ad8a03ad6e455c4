//! Options of belief propagation: semiring, message update, damping.

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
