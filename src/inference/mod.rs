//! Minimisers of the energy of [`crate::mrf`], and what they report on the way.
//!
//! [`BeliefPropagation`] passes messages over the graph of variables: max-product heads for the labeling of lowest
//! energy, sum-product for the marginals. Its **sparse update** visits only label pairs within the neighbourhood,
//! because all others share the truncated potential; it computes the same messages as an update over all pairs.
//!
//! Sign convention: energies, lower is better. Messages and beliefs are in the linear domain, scaled to maximum 1.

mod belief_propagation;
mod block_plan;
#[cfg(test)]
mod oracle;
mod sparse_update;
#[cfg(test)]
mod tests;

pub use belief_propagation::{BeliefPropagation, BpIteration, BpOptions, BpOutcome, BpStop, Product};
