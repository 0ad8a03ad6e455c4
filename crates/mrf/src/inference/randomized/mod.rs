//! Minimizers that change one label at a time at random: simulated annealing by two samplers, and Las Vegas.
//!
//! `annealing` and `las_vegas` are the minimizers. `search` has their parameters and results, `sweeps` visits the
//! variables by the colors of `colors`, and `gibbs` and `metropolis` change one variable. `state` keeps the running
//! energy and the best labeling, `energy` computes changes of the energy in `O(degree)`, and `draws` has the random
//! streams.

mod annealing;
mod colors;
mod draws;
mod energy;
mod gibbs;
mod las_vegas;
#[cfg(test)]
mod las_vegas_tests;
mod metropolis;
mod schedule;
mod search;
mod state;
mod sweeps;
#[cfg(test)]
mod tests;
mod weights;

pub use annealing::{AnnealingOptions, Sampler, SimulatedAnnealing};
pub use las_vegas::{LasVegas, LasVegasOptions};
pub use schedule::Cooling;
pub use search::{SearchOutcome, SearchRun, SearchStop, SearchSweep, local_confidence};
