//! The flooding schedule: every message is computed from the messages of the previous iteration, block by block on all
//! cores.
//!
//! # Limits of speed
//! An iteration reads and writes every message once, `2 · 4 · |E→| · n` bytes. It performs `|E→| · n` times the operations for one value of a message: three products of messages, plus, with
//! max-product and `β = 0`, one maximum for each member of `N_1`, `r` times over, or else a few operations for each
//! member of `N_r`. A lower bound for the time of an iteration is the longer of two times: the bytes over the rate at
//! which memory is changed in place, and the operations over the rate of the vector units.
//! `crates/laboratory/benches/kernel.rs` measures all of these in one run. There are also the transposes between rows
//! and lanes, and scaling, damping and comparing, seven operations per value.
//!
//! Without a distance term the measured time is far above that bound, and waiting for memory is not the reason: with
//! all messages in the caches an iteration takes four fifths of its time. Two vectors can be loaded and one stored per
//! cycle. Each value is loaded twice for its products, once for each of two transposes, once for each member of `N_1`
//! and once for the comparison, and is stored four times.

use super::block_plan::{BLOCK_LANES, Block, BlockPlan};
use super::kernel::{Kernel, lane_factors};
use super::lanes::Lanes;
use super::message_store::{Batches, MessageStore, OpenStore};
use super::message_writer::BlockRows;
use super::outcome::{BpIteration, BpOutcome, BpStop, Decoded, Progress};
use super::sparse_update::Scratch;
use homolog_primitives::graph::EdgeGraph;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use parking_lot::Mutex;
use rayon::prelude::*;

/// Blocks and their messages.
pub(super) struct Flooding {
    plan: BlockPlan,
    batches: Batches,
    /// Near and far factors of the pairwise potential, for each lane of each block.
    factors: Vec<(Lanes, Lanes)>,
    messages: MessageStore,
    /// One scratch per thread.
    scratch: Vec<Mutex<Scratch>>,
}

/// Result of one pass over the blocks.
struct Pass {
    decoded: Vec<Decoded>,
    /// Largest change of a message.
    delta: f32,
}

impl Flooding {
    /// Blocks over the directed edges of `graph`; `factors` of every edge; rows of `stride` values.
    pub(super) fn new(graph: &EdgeGraph, factors: &[(f32, f32)], stride: usize) -> Self {
        let plan = BlockPlan::new(graph);
        let batches = Batches::new(&plan);
        Flooding {
            factors: factors.chunks(BLOCK_LANES).map(|edges| lane_factors(edges.iter().copied())).collect(),
            messages: MessageStore::new(&plan, stride, batches.n_spare),
            batches,
            plan,
            scratch: Vec::new(),
        }
    }

    /// The message `i → j` of a directed edge.
    pub(super) fn message(&self, edge: usize) -> &[f32] {
        self.messages.message(edge)
    }

    /// Sets every message to `message`, unless `observer` asks to stop meanwhile.
    pub(super) fn fill(&mut self, message: &[f32], observer: &dyn Observer) {
        self.messages.fill(message, observer);
    }

    /// Runs like [`super::BeliefPropagation::run`].
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(super) fn run(
        &mut self,
        kernel: Kernel<'_>,
        max_iterations: u32,
        observer: &dyn Observer,
        mut on_iteration: impl FnMut(&BpIteration),
    ) -> Result<BpOutcome, Cancelled> {
        let tolerance = kernel.options.tolerance;
        let mut progress = Progress::new(kernel.model.n_variables());
        let mut delta = f32::INFINITY;
        while self.scratch.len() < rayon::current_num_threads() {
            self.scratch.push(Mutex::new(Scratch::new(kernel.stride)));
        }
        // The pass that computes the next messages also computes the beliefs, so the labeling of iteration `k` is known
        // in pass `k + 1`; the last pass only decodes.
        for pass in 0..=max_iterations {
            let last = pass == max_iterations || delta <= tolerance;
            let Pass { decoded, delta: new_delta } = self.pass(kernel, !last, observer)?;
            let labels_changed = progress.decoded(&decoded, |labeling| kernel.model.energy(labeling));
            if pass > 0 {
                on_iteration(&progress.iterated(delta, labels_changed));
            }
            if last {
                break;
            }
            delta = new_delta;
        }
        let settled = delta <= tolerance;
        Ok(progress.finish(if settled { BpStop::Converged } else { BpStop::MaxIterations }))
    }

    /// One pass over all blocks: decodes the beliefs of the present messages and, with `update`, computes the next
    /// ones.
    fn pass(&mut self, kernel: Kernel<'_>, update: bool, observer: &dyn Observer) -> Result<Pass, Cancelled> {
        let Flooding { plan, batches, factors, messages, scratch } = self;
        let mut open = messages.open();
        let mut found = Pass { decoded: Vec::with_capacity(kernel.model.n_variables()), delta: 0.0 };
        for (blocks, released) in &batches.batches {
            if observer.is_cancelled() {
                break;
            }
            let mut lent = open.lend(if update { blocks.len() } else { 0 });
            let mut outputs: Vec<Option<&mut [f32]>> = lent.iter_mut().map(|lent| Some(&mut *lent.values)).collect();
            outputs.resize_with(blocks.len(), || None);
            let results: Vec<(Vec<Decoded>, f32)> = blocks
                .clone()
                .into_par_iter()
                .zip(outputs)
                .map(|(block, output)| {
                    // No other thread has this index, so the lock is free; leftovers of a panic are overwritten.
                    let own = &scratch[rayon::current_thread_index().unwrap_or(0) % scratch.len()];
                    let mut scratch = own.lock();
                    make_block(kernel, &open, (block, &plan.blocks[block]), &factors[block], &mut scratch, output)
                })
                .collect();
            for (decoded, change) in results {
                found.decoded.extend(decoded);
                found.delta = found.delta.max(change);
            }
            for (block, lent) in blocks.clone().zip(lent) {
                open.give_back(block, lent);
            }
            for &block in released {
                open.release(block);
            }
        }
        open.close();
        checkpoint(observer)?;
        // A variable without neighbors sends no message and is in no block: its belief is its unary factor.
        for i in (0..kernel.model.n_variables()).filter(|&i| kernel.model.variables.row(i).is_empty()) {
            found.decoded.push(decode_alone(kernel, i));
        }
        Ok(found)
    }
}

fn decode_alone(kernel: Kernel<'_>, variable: usize) -> Decoded {
    let phi = kernel.order.by_label(kernel.phi_row(variable));
    let label = (0..phi.len()).fold(0, |best, x| if phi[x] > phi[best] { x } else { best });
    let sum: f32 = phi.iter().sum();
    Decoded { variable: variable as u32, label: label as u32, confidence: f64::from(phi[label] / sum) }
}

/// Decodes the variables of block `number` and, given an `output`, writes its next messages there. Also returns the
/// largest change of a message.
fn make_block(
    kernel: Kernel<'_>,
    messages: &OpenStore<'_>,
    (number, block): (usize, &Block),
    (near, far): &(Lanes, Lanes),
    scratch: &mut Scratch,
    output: Option<&mut [f32]>,
) -> (Vec<Decoded>, f32) {
    let totals = kernel.cavity(|edge| messages.message(edge), &block.variables, scratch);
    // A variable in several blocks is decoded in the block of its first edges.
    let decoded = kernel.decode(&block.variables, scratch).filter(|(of, _)| of.slots.start == 0).map(|(_, d)| d);
    let decoded = decoded.collect();
    let Some(output) = output else { return (decoded, 0.0) };
    let n_values = block.n_edges * kernel.stride;
    let (old, new) = (&messages.block(number)[..n_values], &mut output[..n_values]);
    let mut rows = BlockRows { old, new, stride: kernel.stride };
    let change = kernel.write((near, far), &totals, scratch, &mut rows);
    (decoded, change)
}
