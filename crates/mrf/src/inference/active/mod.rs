//! Belief propagation over **active labels**: every variable has a set of candidate labels and takes no others.
//!
//! The energy is that of [`crate`]; labels outside a variable's set have weight 0. A message `i → j` then has `|C_j|`
//! values instead of `n`, each computed from `|C_i|` values:
//!
//! ```text
//! m_{i→j}(y) = max( ε max_{x ∈ C_i} h(x),  max_{x ∈ N_r(y) ∩ C_i} ψ(x, y) h(x) )        y ∈ C_j
//! ```
//!
//! Sum-product has sums instead of maxima. With all labels as candidates these are the messages of the dense engine.
//! For `K` candidates per variable, `k ≤ k̄` of them near a label, memory is `O(|E→| K)` and an iteration `O(|E→| K
//! k)`, both linear in the size of the surfaces if `K` does not grow with it.
//!
//! Messages cannot restore a label that is not in a set. [`ActiveSets`] therefore controls how sets are revised during
//! a run: labels whose belief has fallen far below the best are dropped, and labels next to the images of a variable's
//! neighbors, where its own image must be, are added.
//!
//! # Exact exclusion by truncation
//! Two labels' messages from one neighbor differ by at most `exp(T)`. A label of a variable with `d` neighbors can
//! therefore never win if its unary potential is more than `d T` above the lowest, and leaving it out is exact. If `T`
//! is larger than the spread of the unary potentials, as by default, this excludes nothing; sets are capped instead,
//! and the dense engine of [`crate::inference`] remains the reference.

mod candidates;
mod kernel;
mod model;
mod plan;
mod potentials;
mod propagation;
mod revision;
#[cfg(test)]
mod revision_tests;
mod sets;
#[cfg(test)]
mod tests;

pub use candidates::{CandidateError, Candidates};
pub use model::ActiveModel;
pub use potentials::{UnaryInput, UnaryPotentials};
pub use propagation::{ActiveOutcome, ActivePropagation};
pub use sets::ActiveSets;
