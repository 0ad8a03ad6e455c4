//! Minimisers of the energy of [`crate::mrf`], and what they report on the way.
//!
//! [`BeliefPropagation`] passes messages over the graph of variables: max-product heads for the labeling of lowest
//! energy, sum-product for the marginals. Its **sparse update** visits only label pairs within the neighbourhood,
//! because all others share the truncated potential; it computes the same messages as the **full update** over all
//! pairs. Messages go all at once (flooding) or the most pending first (residual).
//!
//! [`DualBound`] minimises nothing: it raises a bound that no energy is below, and so tells how good a labeling is.
//!
//! [`SimulatedAnnealing`] and [`LasVegas`] change one label at a time at random; [`LasVegas`] knows when it is done.
//!
//! Sign convention: energies, lower is better. Messages and beliefs are in the linear domain, scaled to maximum 1.

mod annealing;
mod annealing_colors;
mod annealing_draws;
mod annealing_energy;
mod annealing_gibbs;
mod annealing_metropolis;
mod annealing_search;
mod annealing_state;
mod annealing_sweeps;
#[cfg(test)]
mod annealing_tests;
mod annealing_weights;
mod belief_propagation;
mod beliefs;
mod block_plan;
mod convergence;
mod dual_update;
mod fixed_point;
mod flooding;
mod full_update;
mod kernel;
mod las_vegas;
#[cfg(test)]
mod las_vegas_tests;
mod lower_bound;
#[cfg(test)]
mod lower_bound_tests;
#[cfg(test)]
mod method_tests;
mod options;
#[cfg(test)]
mod oracle;
mod outcome;
mod residual;
mod schedule;
mod sparse_update;
mod sweep_order;
#[cfg(test)]
mod tests;

pub use annealing::{AnnealingOptions, Sampler, SimulatedAnnealing};
pub use annealing_search::{SearchOutcome, SearchRun, SearchStop, SearchSweep, local_confidence};
pub use belief_propagation::BeliefPropagation;
pub use beliefs::belief_spread;
pub use convergence::{Convergence, ConvergenceStatus};
pub use las_vegas::{LasVegas, LasVegasOptions};
pub use lower_bound::{DualBound, DualIteration, DualOptions, DualOutcome, DualStop};
pub use options::{BpMethod, BpOptions, Product, Schedule, Update};
pub use outcome::{BpIteration, BpOutcome, BpStop};
pub use schedule::Cooling;
