//! Belief propagation over **active labels**: every variable holds a set of candidates and no other label.
//!
//! The energy is that of [`crate`]; a label outside its variable's set has weight 0, so that it cannot be taken.
//! A message `i → j` then has `|C_j|` values instead of `n`, and `|C_i|` of them to be made from:
//!
//! ```text
//! m_{i→j}(y) = max( ε max_{x ∈ C_i} h(x),  max_{x ∈ N_r(y) ∩ C_i} ψ(x, y) h(x) )        y ∈ C_j
//! ```
//!
//! and with sums instead of maxima for sum-product. With all labels as candidates these are the messages of the dense
//! engine. Memory is `O(|E→| K)` and an iteration `O(|E→| K k)` for `K` candidates a variable, of which `k ≤ k̄` are
//! near a label, both linear in the size of the surfaces where `K` does not grow with them.
//!
//! Messages cannot restore a label that is not in a set. [`ActiveSets`] therefore says how sets are revised during a
//! run: labels whose belief has fallen far below the best are dropped, and labels next to the images of a variable's
//! neighbors, where its own image has to be, are added.
//!
//! # What the truncation allows
//! Two labels' messages from one neighbor differ by `exp(T)` at most, so that the labels of a variable with `d`
//! neighbors whose unary potential is more than `d T` above the lowest can never win, and leaving them out is exact.
//! Where `T` is larger than the spread of the unary potentials, as it is by default, that excludes nothing; sets are
//! capped instead, and [`crate::inference`]'s dense engine remains the reference.

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
pub use potentials::{Evidence, UnaryPotentials};
pub use propagation::{ActiveOutcome, ActivePropagation};
pub use sets::ActiveSets;
