//! Minimizers of the energy of [`crate`], and their reports during a run.
//!
//! [`BeliefPropagation`] passes messages over the graph of variables: max-product approximates the labeling of lowest
//! energy, sum-product the marginals. Its **sparse update** visits only label pairs within the neighborhood, because
//! all others share the truncated potential; it computes the same messages as the **full update** over all pairs.
//! All messages are updated at once, from those of the previous iteration (flooding).
//!
//! [`DualBound`] raises a lower bound on the energy of every labeling, which bounds the distance of a labeling from the
//! minimum, and decodes labelings on the way.
//!
//! [`SimulatedAnnealing`] and [`LasVegas`] change one label at a time at random; [`LasVegas`] certifies an answer whose energy
//! is at most a given target.
//!
//! [`ActivePropagation`] passes the messages of [`BeliefPropagation`] over a set of candidate labels for each variable, in
//! time and memory linear in the size of the surfaces.
//!
//! Sign convention: energies, lower is better. Messages and beliefs are in the linear domain, scaled to maximum 1.

mod active;
mod belief_propagation;
mod beliefs;
mod block_plan;
mod cavity;
mod convergence;
mod dual_update;
mod fixed_point;
mod flooding;
mod full_update;
mod kernel;
mod label_order;
mod label_rows;
mod lanes;
#[cfg(test)]
mod large_potentials_tests;
mod lower_bound;
#[cfg(test)]
mod lower_bound_tests;
mod message_store;
mod message_writer;
#[cfg(test)]
mod method_tests;
mod options;
#[cfg(test)]
mod oracle;
mod outcome;
mod pair_table;
mod randomized;
mod sparse_update;
mod sweep_order;
#[cfg(test)]
mod tests;
mod unary_factors;
mod vector;

pub use active::{
    ActiveModel, ActiveOutcome, ActivePropagation, ActiveSets, CandidateError, Candidates, UnaryInput, UnaryPotentials,
};
pub use belief_propagation::BeliefPropagation;
pub use beliefs::belief_spread;
pub use convergence::{Convergence, ConvergenceStatus};
pub use lower_bound::{DualBound, DualIteration, DualOptions, DualOutcome, DualStop};
pub use options::{BpOptions, Product, Update};
pub use outcome::{BpIteration, BpOutcome, BpStop};
pub use randomized::{
    AnnealingOptions, Cooling, LasVegas, LasVegasOptions, Sampler, SearchOutcome, SearchRun, SearchStop, SearchSweep,
    SimulatedAnnealing, local_confidence,
};
