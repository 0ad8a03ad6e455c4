//! A lower bound on the energy of every labeling, which also bounds the distance of a labeling from the lowest energy.
//!
//! Messages move energy between unary and pairwise potentials without changing the energy of any labeling; for any
//! messages, the sum of the minima of all potentials is a bound. Each sweep visits the variables in one order and back.
//! A variable gathers the energy its edges hold and shares it between the edges ahead, and each edge passes on all it
//! can. The bound never falls and settles at a fixed point (weak tree agreement). On trees this is the minimum itself,
//! otherwise it is near the optimum of the linear relaxation.
//!
//! Source: tree-reweighted message passing, sequential: Kolmogorov, IEEE PAMI 28(10), 2006, written with the shares in
//! the messages as in Kolmogorov, IEEE PAMI 37(5), 2015. The sparse message over a truncated potential is the one of
//! belief propagation, in the domain of energies. Whole numbers instead of floating point make the arithmetic exact
//! ([`super::fixed_point`]): no rounding in a sweep can lift the bound above the energy.
//!
//! Pairwise potentials must be `≥ 0` and unary potentials finite. An infinite truncation is supported: it is replaced
//! by a large finite one, whose bound is lower or equal.

use super::block_plan::LANES;
use super::dual_update::{PassScratch, UnitTable, add, minimum, pass_on, shares, subtract};
use super::fixed_point::Grid;
use super::sweep_order::SweepOrder;
use crate::{Energy, Labeling, MrfModel};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Blocks of messages computed side by side: enough for many cores, with little scratch.
const BLOCKS_AT_ONCE: usize = 16;

/// Conditions that end a [`DualBound::run`] before its budget.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DualOptions {
    /// Largest gap between the best energy and the bound, as a share of the energy's magnitude, at which a run ends.
    pub gap_tolerance: f64,
    /// Largest rise of the bound in an iteration, as a share of its magnitude, at which a run ends.
    pub progress_tolerance: f64,
}

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DualStop {
    /// The best labeling is within the gap tolerance of the bound: its energy is the lowest, to that tolerance.
    Optimal,
    /// The bound hardly rises any more; a gap remains.
    Stalled,
    /// The budget of iterations ended.
    MaxIterations,
}

/// One finished iteration: a sweep there and back, `|E→|` messages.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DualIteration {
    /// From 1.
    pub iteration: u32,
    /// The best bound so far; never falls.
    pub bound: f64,
    /// Energy of the best labeling decoded so far; never rises.
    pub energy: Energy,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct DualOutcome {
    /// No labeling has an energy below this.
    pub bound: f64,
    /// The decoded labeling of lowest energy.
    pub labeling: Labeling,
    /// Its energy.
    pub energy: Energy,
    /// Iterations of this run.
    pub iterations: u32,
    /// Why it ended.
    pub stop: DualStop,
}

/// Messages of the dual of one model, the best bound and the best labeling.
///
/// Memory: `|E→| · n` whole numbers of 32 bits, and a few for every label and core.
pub struct DualBound<'a> {
    model: &'a MrfModel,
    options: DualOptions,
    grid: Grid,
    table: UnitTable,
    order: SweepOrder,
    reverse: Vec<u32>,
    /// `βℓ/ℓ'` of every directed edge, in grid units.
    lengths: Vec<i32>,
    /// Message `i → j`, one value a label of `j`, for every directed edge.
    messages: Vec<Vec<i32>>,
    scratch: Vec<PassScratch>,
    /// Labels decoded by the sweep.
    decoded: Labeling,
    best: (Labeling, Energy),
    bound: f64,
}

/// Direction in which a sweep traverses the order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Direction {
    Forward,
    Backward,
}

/// A variable that a sweep visits.
struct Visit {
    variable: usize,
    /// Its edges to variables that are visited later.
    ahead: Vec<usize>,
    /// The incoming messages of these edges, from which the shares are subtracted; taken out of the table meanwhile.
    incoming: Vec<Vec<i32>>,
    /// Minimum of the reparametrized unary potential.
    minimum: i32,
    label: u32,
}

impl<'a> DualBound<'a> {
    /// Starts without messages; the bound is the sum of the smallest unary potentials.
    pub fn new(model: &'a MrfModel, options: DualOptions) -> Self {
        let grid = Grid::new(model);
        let labeling = model.unary_minimum();
        let energy = model.energy(&labeling);
        DualBound {
            options,
            table: UnitTable::new(model, &grid),
            order: SweepOrder::new(&model.variables),
            reverse: model.variables.reverse_edges(),
            lengths: model.lengths.iter().map(|&length| grid.scaled_length(model, length)).collect(),
            messages: vec![vec![0; model.n_labels()]; model.variables.n_directed_edges()],
            scratch: Vec::new(),
            decoded: labeling.clone(),
            best: (labeling, energy),
            bound: grid.trivial_bound(),
            grid,
            model,
        }
    }

    /// The best bound so far; at any time, no labeling has a lower energy.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Sweeps until the bound meets the best labeling or hardly rises, or for `max_iterations`. Further runs continue
    /// from the present state.
    ///
    /// `on_iteration` is called after every iteration, with the best labeling so far. Cost of an iteration: `O(|E→| n
    /// k̄)`, on all cores, with the same bits on any number of cores.
    ///
    /// # Errors
    /// [`Cancelled`] as soon as `observer` asks to stop. The bound so far stays valid; a further run starts without
    /// messages.
    pub fn run(
        &mut self,
        max_iterations: u32,
        observer: &dyn Observer,
        mut on_iteration: impl FnMut(&DualIteration, &[u32]),
    ) -> Result<DualOutcome, Cancelled> {
        let mut stop = DualStop::MaxIterations;
        let mut iterations = 0;
        while iterations < max_iterations {
            iterations += 1;
            let before = self.bound;
            for direction in [Direction::Forward, Direction::Backward] {
                let swept = self.sweep(direction, observer);
                if swept.is_err() {
                    self.messages.iter_mut().for_each(|row| row.fill(0));
                }
                self.bound = self.bound.max(self.grid.bound(swept?));
                let energy = self.model.energy(&self.decoded);
                if energy.total() < self.best.1.total() {
                    self.best = (self.decoded.clone(), energy);
                }
            }
            let energy = self.best.1;
            on_iteration(&DualIteration { iteration: iterations, bound: self.bound, energy }, &self.best.0);
            if energy.total() - self.bound <= self.options.gap_tolerance * energy.total().abs() {
                stop = DualStop::Optimal;
                break;
            }
            if self.bound - before <= self.options.progress_tolerance * self.bound.abs() {
                stop = DualStop::Stalled;
                break;
            }
        }
        let (labeling, energy) = self.best.clone();
        Ok(DualOutcome { bound: self.bound, labeling, energy, iterations, stop })
    }

    /// Visits every variable once. Returns the sum of the minima of all potentials, in grid units.
    fn sweep(&mut self, direction: Direction, observer: &dyn Observer) -> Result<i64, Cancelled> {
        let mut units = 0;
        let n_steps = self.order.steps.len();
        for at in 0..n_steps {
            checkpoint(observer)?;
            let step = match direction {
                Direction::Forward => at,
                Direction::Backward => n_steps - 1 - at,
            };
            let visits = self.visit_step(step, direction);
            let mut ahead = Vec::new();
            for visit in visits {
                units += i64::from(visit.minimum);
                self.decoded[visit.variable] = visit.label;
                for (&edge, row) in visit.ahead.iter().zip(visit.incoming) {
                    self.messages[self.reverse[edge] as usize] = row;
                }
                ahead.extend(visit.ahead);
            }
            units += self.pass_on(&ahead);
        }
        Ok(units)
    }

    /// The variables of a step share out their energy side by side: no two are neighbors.
    fn visit_step(&mut self, step: usize, direction: Direction) -> Vec<Visit> {
        let graph = &self.model.variables;
        let visits: Vec<Visit> = self.order.steps[step]
            .iter()
            .map(|&i| {
                let is_ahead = |&edge: &usize| {
                    let other = self.order.step_of[graph.head(edge)] as usize;
                    if direction == Direction::Forward { other > step } else { other < step }
                };
                let ahead: Vec<usize> = graph.row(i as usize).filter(is_ahead).collect();
                let incoming =
                    ahead.iter().map(|&edge| std::mem::take(&mut self.messages[self.reverse[edge] as usize])).collect();
                Visit { variable: i as usize, ahead, incoming, minimum: 0, label: 0 }
            })
            .collect();
        let this = &*self;
        visits.into_par_iter().map(|visit| this.visit(visit)).collect()
    }

    fn visit(&self, mut visit: Visit) -> Visit {
        let graph = &self.model.variables;
        let mut potential = Vec::with_capacity(self.model.n_labels());
        self.grid.unary(visit.variable, self.model.unary_row(visit.variable), &mut potential);
        for row in &visit.incoming {
            add(&mut potential, row);
        }
        // A label is decoded given the labels of the variables visited before, whose potentials replace messages. The
        // truncation is left out of them because it is the same for all labels.
        let mut given = potential.clone();
        let behind: Vec<usize> = graph.row(visit.variable).filter(|edge| !visit.ahead.contains(edge)).collect();
        for &edge in &behind {
            add(&mut potential, &self.messages[self.reverse[edge] as usize]);
            for &(x, distance) in self.table.row(self.decoded[graph.head(edge)] as usize) {
                let near = (self.lengths[edge] - distance).abs().min(self.grid.truncation);
                given[x as usize] += near - self.grid.truncation;
            }
        }
        visit.label = minimum(&given).0 as u32;
        visit.minimum = minimum(&potential).1;
        shares(&mut potential, visit.minimum, visit.ahead.len().max(behind.len()));
        for row in &mut visit.incoming {
            subtract(row, &potential);
        }
        visit
    }

    /// Lets every edge of `edges` pass on all it can. Returns the sum of the minima that remain in them, in grid units.
    fn pass_on(&mut self, edges: &[usize]) -> i64 {
        let mut units = 0;
        let n = self.model.n_labels();
        for edges in edges.chunks(LANES * BLOCKS_AT_ONCE) {
            let blocks: Vec<&[usize]> = edges.chunks(LANES).collect();
            while self.scratch.len() < blocks.len() {
                self.scratch.push(PassScratch::new(n));
            }
            let mut outgoing: Vec<Vec<Vec<i32>>> = blocks
                .iter()
                .map(|block| block.iter().map(|&edge| std::mem::take(&mut self.messages[edge])).collect())
                .collect();
            let DualBound { model, grid, table, reverse, lengths, messages, scratch, .. } = &mut *self;
            let potential = (grid.truncation, model.pairwise.beta == 0.0);
            let sums: Vec<i64> = scratch
                .par_iter_mut()
                .zip(&blocks)
                .zip(&mut outgoing)
                .map(|((scratch, block), outgoing)| {
                    let against: Vec<&[i32]> =
                        block.iter().map(|&edge| messages[reverse[edge] as usize].as_slice()).collect();
                    let mut lane_lengths = [0; LANES];
                    for (lane, &edge) in block.iter().enumerate() {
                        lane_lengths[lane] = lengths[edge];
                    }
                    let minima = pass_on(table, &against, &lane_lengths, potential, scratch, outgoing);
                    minima[..block.len()].iter().map(|&m| i64::from(m)).sum()
                })
                .collect();
            units += sums.iter().sum::<i64>();
            for (&edge, row) in edges.iter().zip(outgoing.into_iter().flatten()) {
                self.messages[edge] = row;
            }
        }
        units
    }
}
