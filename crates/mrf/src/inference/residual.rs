//! The residual schedule: the variable whose outgoing messages may change most sends next.
//!
//! The change of an update is bounded instead of computed, after Sutton, McCallum 2007: the log of an outgoing message,
//! up to a constant, changes by no more than the sum of the changes of the logs of the incoming messages since the
//! variable last sent. A message with maximum 1 whose log changes by at most `δ` changes by at most `1 − exp(−δ)`, so
//! the bound also tells when every message is within the tolerance of its update. Informed scheduling itself is due to
//! Elidan, McGraw, Koller 2006.
//!
//! Variables that are not neighbors do not read what the others write. A batch of such variables from the front of the
//! queue is therefore updated side by side, with the same result as one after the other; neither the batch nor its
//! result depends on the number of threads. Ties between bounds go to the lowest variable.

use super::beliefs::{belief_row, peak};
use super::block_plan::{BLOCK_LANES, BlockVariable};
use super::kernel::{Kernel, lane_factors};
use super::lanes::Lanes;
use super::message_writer::{Finish, inverse_of};
use super::outcome::{BpIteration, BpOutcome, BpStop, Decoded, Progress};
use super::sparse_update::Scratch;
use homolog_primitives::graph::EdgeGraph;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use multiversion::multiversion;
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Blocks per batch: enough for the cores of a small machine, few enough that a batch stays close to the order.
const BATCH_BLOCKS: usize = 8;
/// Least bound of a variable in a batch, as a share of the largest.
const BATCH_SHARE: f32 = 0.5;
/// Number of neighbors of members that are skipped before a batch is closed.
const PASSED_OVER: usize = 64;

/// The queue and the workspaces of the residual schedule. Message `i → j` lies in the row of its directed edge.
pub(super) struct Residual {
    /// The outgoing edges of every variable, at most [`BLOCK_LANES`] a piece; `lane` is set when a piece joins a block.
    pieces: Vec<Vec<BlockVariable>>,
    /// Near and far factors of the pairwise potential for every directed edge.
    factors: Vec<(f32, f32)>,
    /// Bound on the change of the log of any outgoing message, for every variable.
    pending: Vec<f32>,
    /// Bits of a bound (ordered like the non-negative numbers they represent) and its variable. An entry is void if its
    /// bound differs from `pending`.
    queue: BinaryHeap<(u32, Reverse<u32>)>,
    /// The last batch in which a variable was a member or the neighbor of one.
    taken: Vec<u64>,
    batch: u64,
    workspaces: Vec<Workspace>,
}

/// Scratch and output of one block.
struct Workspace {
    scratch: Scratch,
    /// New messages, lane by lane.
    output: Vec<f32>,
}

/// Change of one message: the largest difference, and the range of the ratio of its update to its old values.
#[derive(Debug, Clone, Copy, PartialEq)]
struct MessageChange {
    delta: f32,
    lowest: f32,
    highest: f32,
}

/// Summary of `|E→|` message updates, or of the last ones.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Round {
    /// Largest change of a message.
    delta: f32,
    /// Whether every message is within the tolerance of its update.
    settled: bool,
}

impl Residual {
    /// A queue over the variables of `graph`, with the edge factors of every directed edge.
    pub(super) fn new(graph: &EdgeGraph, factors: Vec<(f32, f32)>) -> Self {
        let reverse = graph.reverse_edges();
        let n = graph.n_vertices();
        let pieces = |variable: usize| {
            let incoming: Vec<u32> = graph.row(variable).map(|e| reverse[e]).collect();
            let piece = |start: usize| BlockVariable {
                variable,
                incoming: incoming.clone(),
                slots: start..(start + BLOCK_LANES).min(incoming.len()),
                lane: 0,
            };
            (0..incoming.len()).step_by(BLOCK_LANES).map(piece).collect()
        };
        Residual {
            pieces: (0..n).map(pieces).collect(),
            factors,
            pending: vec![0.0; n],
            queue: BinaryHeap::new(),
            taken: vec![0; n],
            batch: 0,
            workspaces: Vec::new(),
        }
    }

    /// Runs like [`super::BeliefPropagation::run`].
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(super) fn run(
        &mut self,
        kernel: Kernel<'_>,
        messages: &mut [f32],
        max_iterations: u32,
        observer: &dyn Observer,
        mut on_iteration: impl FnMut(&BpIteration),
    ) -> Result<BpOutcome, Cancelled> {
        let mut progress = Progress::new(kernel.model.n_variables());
        let mut stop = BpStop::MaxIterations;
        let energy = |labeling: &[u32]| kernel.model.energy(labeling);
        progress.decoded(&self.decode(kernel, messages), energy);
        self.begin();
        for _ in 0..max_iterations {
            let round = self.iterate(kernel, messages, observer)?;
            let labels_changed = progress.decoded(&self.decode(kernel, messages), energy);
            on_iteration(&progress.iterated(round.delta, labels_changed));
            if round.settled {
                stop = BpStop::Converged;
                break;
            }
        }
        Ok(progress.finish(stop))
    }

    /// The largest beliefs of all variables.
    fn decode(&self, kernel: Kernel<'_>, messages: &[f32]) -> Vec<Decoded> {
        let (stride, n) = (kernel.stride, kernel.model.n_labels());
        (0..self.pieces.len())
            .into_par_iter()
            .map(|i| {
                let incoming = self.pieces[i].first().map_or(&[][..], |piece| &piece.incoming);
                let rows = incoming.iter().map(|&row| &messages[row as usize * stride..][..n]);
                let belief = belief_row(&kernel.phi[i * stride..][..n], rows);
                let (label, confidence) = peak(&kernel.order.by_label(&belief));
                Decoded { variable: i as u32, label, confidence }
            })
            .collect()
    }

    /// Marks every variable as pending, since no message has been compared with its update yet.
    fn begin(&mut self) {
        self.queue.clear();
        for i in 0..self.pending.len() {
            self.pending[i] = 0.0;
            if !self.pieces[i].is_empty() {
                self.raise(i, f32::INFINITY);
            }
        }
    }

    fn raise(&mut self, variable: usize, by: f32) {
        let before = self.pending[variable];
        self.pending[variable] += by;
        if self.pending[variable] > before {
            self.queue.push((self.pending[variable].to_bits(), Reverse(variable as u32)));
        }
    }

    /// Updates about `|E→|` messages, to within a batch, or fewer if all are settled earlier.
    fn iterate(
        &mut self,
        kernel: Kernel<'_>,
        messages: &mut [f32],
        observer: &dyn Observer,
    ) -> Result<Round, Cancelled> {
        let graph = &kernel.model.variables;
        // The bound on the log for which the change itself is within the tolerance.
        let limit = -(1.0 - kernel.options.tolerance.clamp(0.0, 1.0)).ln();
        let mut round = Round { delta: 0.0, settled: false };
        let mut updates = 0;
        while updates < graph.n_directed_edges() {
            checkpoint(observer)?;
            let blocks = self.next_batch(graph, limit);
            if blocks.is_empty() {
                round.settled = true;
                return Ok(round);
            }
            let changes = self.compute(kernel, messages, &blocks);
            let n = kernel.model.n_labels();
            for ((block, workspace), changes) in blocks.iter().zip(&self.workspaces).zip(&changes) {
                for (lane, edge) in block_edges(graph, block).enumerate() {
                    let new = &workspace.output[lane * kernel.stride..][..n];
                    messages[edge * kernel.stride..][..n].copy_from_slice(new);
                    round.delta = round.delta.max(changes[lane].delta);
                }
                updates += changes.len();
            }
            self.account(graph, &blocks, &changes, kernel.options.damping);
        }
        round.settled = self.queue_is_settled(limit);
        Ok(round)
    }

    /// Variables from the front of the queue, no two of them neighbors, packed into blocks. Empty if no bound is
    /// above `limit`.
    fn next_batch(&mut self, graph: &EdgeGraph, limit: f32) -> Vec<Vec<BlockVariable>> {
        self.batch += 1;
        let mut blocks: Vec<Vec<BlockVariable>> = Vec::new();
        let mut room = 0;
        let mut least = 0.0f32;
        let mut passed_over = Vec::new();
        while let Some(entry) = self.queue.pop() {
            let (bound, variable) = (f32::from_bits(entry.0), entry.1.0 as usize);
            if bound.to_bits() != self.pending[variable].to_bits() {
                continue;
            }
            let length: usize = self.pieces[variable].iter().map(|piece| piece.slots.len()).sum();
            let full = !blocks.is_empty() && length > room && blocks.len() == BATCH_BLOCKS;
            if bound <= limit || bound < least || full || passed_over.len() == PASSED_OVER {
                self.queue.push(entry);
                break;
            }
            if self.taken[variable] == self.batch {
                passed_over.push(entry);
                continue;
            }
            least = least.max(bound * BATCH_SHARE);
            self.taken[variable] = self.batch;
            for &neighbor in graph.neighbors(variable) {
                self.taken[neighbor as usize] = self.batch;
            }
            for piece in &self.pieces[variable] {
                if piece.slots.len() > room {
                    blocks.push(Vec::new());
                    room = BLOCK_LANES;
                }
                if let Some(block) = blocks.last_mut() {
                    block.push(BlockVariable { lane: BLOCK_LANES - room, ..piece.clone() });
                }
                room -= piece.slots.len();
            }
        }
        self.queue.extend(passed_over);
        blocks
    }

    fn queue_is_settled(&mut self, limit: f32) -> bool {
        while let Some(&(bits, Reverse(variable))) = self.queue.peek() {
            if bits == self.pending[variable as usize].to_bits() {
                return f32::from_bits(bits) <= limit;
            }
            self.queue.pop();
        }
        true
    }

    /// Computes the new messages of all blocks into their workspaces, and the change of each lane.
    fn compute(
        &mut self,
        kernel: Kernel<'_>,
        messages: &[f32],
        blocks: &[Vec<BlockVariable>],
    ) -> Vec<Vec<MessageChange>> {
        while self.workspaces.len() < blocks.len() {
            let output = vec![0.0; BLOCK_LANES * kernel.stride];
            self.workspaces.push(Workspace { scratch: Scratch::new(kernel.stride), output });
        }
        let factors = &self.factors;
        self.workspaces
            .par_iter_mut()
            .zip(blocks)
            .map(|(workspace, block)| {
                let row = |edge: u32| &messages[edge as usize * kernel.stride..][..kernel.stride];
                let totals = kernel.cavity(row, block, &mut workspace.scratch);
                let graph = &kernel.model.variables;
                let (near, far) = lane_factors(block_edges(graph, block).map(|edge| factors[edge]));
                let top = kernel.update((&near, &far), &totals, &mut workspace.scratch);
                let finish = Finish { floor: kernel.options.floor, damping: kernel.options.damping };
                let n = kernel.model.n_labels();
                block_edges(graph, block)
                    .enumerate()
                    .map(|(lane, edge)| {
                        let old = &messages[edge * kernel.stride..][..n];
                        let new = &mut workspace.output[lane * kernel.stride..][..n];
                        settle_lane(&workspace.scratch.updated, lane, top[lane], old, new, finish)
                    })
                    .collect()
            })
            .collect()
    }

    /// Subtracts the changes sent by members of a batch from their bounds, and adds them to the bounds of their
    /// neighbors.
    fn account(
        &mut self,
        graph: &EdgeGraph,
        blocks: &[Vec<BlockVariable>],
        changes: &[Vec<MessageChange>],
        damping: f32,
    ) {
        for of in blocks.iter().flatten() {
            self.pending[of.variable] = 0.0;
        }
        for (block, changes) in blocks.iter().zip(changes) {
            let mut lanes = changes.iter();
            for of in block {
                let mut left = 0.0f32;
                for (edge, change) in block_edges(graph, std::slice::from_ref(of)).zip(&mut lanes) {
                    let (sent, kept_back) = change.log_ranges(damping);
                    left = left.max(kept_back);
                    self.raise(graph.head(edge), sent);
                }
                // Each piece of a variable with many neighbors retains a remainder; the largest counts.
                let more = left - self.pending[of.variable];
                if more > 0.0 {
                    self.raise(of.variable, more);
                }
            }
        }
    }
}

/// The directed edges of the lanes of a block, in order.
fn block_edges(graph: &EdgeGraph, block: &[BlockVariable]) -> impl Iterator<Item = usize> {
    block.iter().flat_map(move |of| {
        let start = graph.row(of.variable).start;
        start + of.slots.start..start + of.slots.end
    })
}

impl MessageChange {
    /// The change of the log of the message up to a constant, and the change that damping withheld.
    fn log_ranges(self, damping: f32) -> (f32, f32) {
        let (low, high) = (f64::from(self.lowest), f64::from(self.highest));
        // Both ratios grow with the ratio of the update, so the ends of the range stay its ends.
        let sent = |ratio: f64| (1.0 - f64::from(damping)) * ratio + f64::from(damping);
        let range = |from: f64, to: f64| (to / from).ln().max(0.0) as f32;
        let kept = |ratio: f64| ratio / sent(ratio);
        (range(sent(low), sent(high)), if damping > 0.0 { range(kept(low), kept(high)) } else { 0.0 })
    }
}

/// Scales one lane to maximum 1, floors it and damps it into `new`; `old` is the previous message.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn settle_lane(
    updated: &[Lanes],
    lane: usize,
    top: f32,
    old: &[f32],
    new: &mut [f32],
    finish: Finish,
) -> MessageChange {
    let scale = inverse_of(top, 1.0);
    // A lane whose products all vanished carries no information and becomes a flat message.
    let floor = if scale > 0.0 { finish.floor } else { 1.0 };
    let share = 1.0 - finish.damping;
    let mut change = MessageChange { delta: 0.0, lowest: f32::INFINITY, highest: 0.0 };
    for ((row, &old), new) in updated.iter().zip(old).zip(new) {
        let value = row[lane] * scale;
        let value = if value > floor { value } else { floor };
        // Without a floor both may be 0, which is no change.
        let (above, below) = (value + f32::MIN_POSITIVE, old + f32::MIN_POSITIVE);
        let ratio = above / below;
        change.lowest = if ratio < change.lowest { ratio } else { change.lowest };
        change.highest = if ratio > change.highest { ratio } else { change.highest };
        let value = share * value + finish.damping * old;
        let step = (value - old).abs();
        change.delta = if step > change.delta { step } else { change.delta };
        *new = value;
    }
    change
}
