//! One sweep: visits every variable once, color class by color class, on all cores, with the same bytes on any number
//! of cores.
//!
//! No edge joins two variables of a class, so each is updated from the labels before the class. All changes are then
//! applied one after the other in a fixed order, and the running energy after each is exact.

use super::colors::ColorClasses;
use super::draws::{Draws, Purpose};
use super::energy::{SearchEnergy, Terms};
use super::gibbs::{GibbsScratch, loosest_bound};
use super::metropolis::{descent_step, metropolis_step};
use super::state::{SearchState, SiteMove};
use homolog_primitives::graph::EdgeGraph;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Largest number of parts of a class, each with its own scratch.
const MAX_PARTS: usize = 16;
/// Smallest number of variables in a part: fewer are not worth handing to another thread.
const MIN_PART: usize = 64;
/// Variables between two calls of the observer: at 100,000 labels a variable costs about a tenth of a millisecond.
const CHECK_EVERY: usize = 16;

/// Method of updating one variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SiteUpdate {
    /// Gibbs sampler at this temperature.
    Gibbs(f64),
    /// Metropolis sampler at this temperature.
    Metropolis(f64),
    /// A random move, accepted if it lowers the energy.
    Descent,
}

/// Summary of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct SweepEnd {
    /// Number of labels that changed.
    pub changed: u32,
    /// Whether the target was reached, in which case the rest of the sweep is skipped.
    pub target_reached: bool,
}

/// Classes and scratch, reused between sweeps.
pub(super) struct Sweeps {
    classes: ColorClasses,
    /// One move for every entry of `classes.order`.
    moves: Vec<SiteMove>,
    /// Bounds of the far parts of the Gibbs sampler, in the same order.
    bounds: Vec<f64>,
    /// The lowest temperature for which the bounds were computed.
    bounded_at: f64,
    n_labels: usize,
    scratch: Vec<GibbsScratch>,
}

/// Inputs of the updates of a sweep.
struct Updates<'s> {
    energy: &'s SearchEnergy<'s>,
    labels: &'s [u32],
    update: SiteUpdate,
    seed: u64,
    sweep: u32,
    observer: &'s dyn Observer,
}

impl Sweeps {
    /// Sweeps over `graph`. With `gibbs`, also allocates the scratch of that sampler, `O(n_labels)` for each of at most
    /// 16 parts.
    pub(super) fn new(graph: &EdgeGraph, n_labels: usize, gibbs: bool) -> Self {
        let classes = ColorClasses::new(graph);
        let largest = classes.ranges().map(|range| range.len()).max().unwrap_or(0);
        let parts = if gibbs { largest.div_ceil(part_length(largest)) } else { 0 };
        Sweeps {
            moves: vec![SiteMove::default(); classes.order.len()],
            bounds: vec![0.0; classes.order.len()],
            bounded_at: 0.0,
            n_labels,
            scratch: vec![GibbsScratch::new(n_labels); parts],
            classes,
        }
    }

    /// Discards the bounds on sums of unary weights. Call it when the unary potentials have changed.
    pub(super) fn reset(&mut self) {
        self.bounded_at = 0.0;
    }

    /// Updates every variable once. `sweep` names the random streams, together with `seed`.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(super) fn sweep(
        &mut self,
        energy: &SearchEnergy<'_>,
        state: &mut SearchState,
        update: SiteUpdate,
        (seed, sweep): (u64, u32),
        observer: &dyn Observer,
    ) -> Result<SweepEnd, Cancelled> {
        if let SiteUpdate::Gibbs(temperature) = update {
            // The bounds hold as long as the temperature falls.
            if temperature > self.bounded_at {
                self.bounds.fill(loosest_bound(self.n_labels));
            }
            self.bounded_at = temperature;
        }
        let mut end = SweepEnd { changed: 0, target_reached: false };
        for range in self.classes.ranges() {
            let updates = Updates { energy, labels: state.labels(), update, seed, sweep, observer };
            let length = part_length(range.len());
            let variables = &self.classes.order[range.clone()];
            let moves = &mut self.moves[range.clone()];
            let bounds = &mut self.bounds[range];
            match update {
                SiteUpdate::Gibbs(temperature) => variables
                    .par_chunks(length)
                    .zip(moves.par_chunks_mut(length))
                    .zip(bounds.par_chunks_mut(length))
                    .zip(&mut self.scratch)
                    .try_for_each(|(((variables, moves), bounds), scratch)| {
                        updates.gibbs(variables, temperature, moves, bounds, scratch)
                    })?,
                _ => variables
                    .par_chunks(length)
                    .zip(moves.par_chunks_mut(length))
                    .try_for_each(|(variables, moves)| updates.propose(variables, moves))?,
            }
            for change in moves.iter() {
                if state.labels()[change.variable as usize] != change.label {
                    state.apply(change);
                    end.changed += 1;
                    if state.reaches_target(energy) {
                        end.target_reached = true;
                        return Ok(end);
                    }
                }
            }
        }
        Ok(end)
    }
}

fn part_length(class: usize) -> usize {
    class.div_ceil(MAX_PARTS).max(MIN_PART)
}

impl Updates<'_> {
    fn draws(&self, i: u32) -> Draws {
        Draws::new(self.seed, Purpose::Site, self.sweep, i)
    }

    fn gibbs(
        &self,
        variables: &[u32],
        temperature: f64,
        moves: &mut [SiteMove],
        bounds: &mut [f64],
        scratch: &mut GibbsScratch,
    ) -> Result<(), Cancelled> {
        for (k, &variable) in variables.iter().enumerate() {
            if k % CHECK_EVERY == 0 {
                checkpoint(self.observer)?;
            }
            let i = variable as usize;
            let old = self.labels[i];
            let draws = &mut self.draws(variable);
            let label = scratch.draw(self.energy, self.labels, i, temperature, draws, &mut bounds[k]);
            let site = |x| self.energy.site(i, x, self.labels);
            let delta = if label == old { Terms::default() } else { site(label).minus(&site(old)) };
            moves[k] = SiteMove { variable, label, delta };
        }
        Ok(())
    }

    fn propose(&self, variables: &[u32], moves: &mut [SiteMove]) -> Result<(), Cancelled> {
        for (k, (&variable, slot)) in variables.iter().zip(moves).enumerate() {
            if k % CHECK_EVERY == 0 {
                checkpoint(self.observer)?;
            }
            let i = variable as usize;
            let draws = &mut self.draws(variable);
            let change = match self.update {
                SiteUpdate::Metropolis(temperature) => metropolis_step(self.energy, self.labels, i, temperature, draws),
                _ => descent_step(self.energy, self.labels, i, draws),
            };
            *slot = change.unwrap_or(SiteMove { variable, label: self.labels[i], delta: Terms::default() });
        }
        Ok(())
    }
}
