//! The flooding schedule: every message from the messages of the iteration before, block by block on all cores.

use super::block_plan::{Block, BlockPlan, LANES};
use super::kernel::{Kernel, lane_factors};
use super::outcome::{BpIteration, BpOutcome, BpStop, Decoded, Progress};
use super::sparse_update::{Finish, Lanes, Scratch, write_messages};
use crate::graph::EdgeGraph;
use crate::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Blocks, and the second copy of the messages.
pub(super) struct Flooding {
    plan: BlockPlan,
    /// Near and far factors of the pairwise potential, for each lane of each block.
    factors: Vec<(Lanes, Lanes)>,
    next: Vec<f32>,
}

impl Flooding {
    /// Blocks over the directed edges of `graph`; `factors` of every edge. The second copy is as long as `n_values`.
    pub fn new(graph: &EdgeGraph, factors: &[(f32, f32)], n_values: usize) -> Self {
        let plan = BlockPlan::new(graph);
        let lanes = |block: &Block| lane_factors(block.edges.iter().map(|&edge| factors[edge as usize]));
        Flooding { factors: plan.blocks.iter().map(lanes).collect(), plan, next: vec![1.0; n_values] }
    }

    /// The row in which message `i → j` lies, for every directed edge.
    pub fn rows(&self) -> Vec<u32> {
        let mut rows = vec![0; self.plan.blocks.iter().map(|b| b.edges.len()).sum()];
        for block in &self.plan.blocks {
            for (lane, &edge) in block.edges.iter().enumerate() {
                rows[edge as usize] = (block.first_row + lane) as u32;
            }
        }
        rows
    }

    /// Runs as [`super::BeliefPropagation::run`] does.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn run(
        &mut self,
        kernel: Kernel<'_>,
        messages: &mut Vec<f32>,
        max_iterations: u32,
        observer: &dyn Observer,
        mut on_iteration: impl FnMut(&BpIteration),
    ) -> Result<BpOutcome, Cancelled> {
        let tolerance = kernel.options.tolerance;
        let mut progress = Progress::new(kernel.model);
        let mut delta = f32::INFINITY;
        // Beliefs come out of the pass that makes the next messages, so the labeling of iteration `k` is known in
        // pass `k + 1`; the last pass only decodes.
        for pass in 0..=max_iterations {
            let last = pass == max_iterations || delta <= tolerance;
            let (found, new_delta) = self.pass(kernel, messages, !last, observer)?;
            if pass == 0 {
                progress.start(&found);
            } else {
                on_iteration(&progress.iterate(&found, delta));
            }
            if last {
                break;
            }
            delta = new_delta;
            std::mem::swap(messages, &mut self.next);
        }
        let settled = delta <= tolerance;
        Ok(progress.finish(if settled { BpStop::Converged } else { BpStop::MaxIterations }))
    }

    /// One pass over all blocks: decodes the beliefs of the present messages and, with `update`, makes the next ones.
    /// Returns the largest beliefs and the largest change of a message.
    fn pass(
        &mut self,
        kernel: Kernel<'_>,
        messages: &[f32],
        update: bool,
        observer: &dyn Observer,
    ) -> Result<(Vec<Decoded>, f32), Cancelled> {
        let stride = kernel.stride;
        let mut outputs: Vec<&mut [f32]> = Vec::with_capacity(self.plan.blocks.len());
        let mut rest = self.next.as_mut_slice();
        for block in &self.plan.blocks {
            let (piece, tail) = rest.split_at_mut(block.edges.len() * stride);
            outputs.push(piece);
            rest = tail;
        }
        let results: Vec<Option<(Vec<Decoded>, f32)>> = self
            .plan
            .blocks
            .par_iter()
            .zip(&self.factors)
            .zip(outputs)
            .map_init(
                || Scratch::new(stride),
                |scratch, ((block, factors), output)| {
                    if observer.is_cancelled() {
                        return None;
                    }
                    Some(make_block(kernel, messages, block, factors, scratch, update.then_some(output)))
                },
            )
            .collect();
        checkpoint(observer)?;
        let mut decoded = Vec::with_capacity(kernel.model.n_variables());
        let mut delta = 0.0f32;
        for (found, change) in results.into_iter().flatten() {
            decoded.extend(found);
            delta = delta.max(change);
        }
        // A variable without neighbours sends nothing and stands in no block: its belief is its unary potential.
        let n = kernel.model.n_labels();
        for i in (0..kernel.model.n_variables()).filter(|&i| kernel.model.variables.row(i).is_empty()) {
            decoded.push(decode_alone(i, &kernel.phi[i * stride..][..n]));
        }
        Ok((decoded, delta))
    }
}

fn decode_alone(variable: usize, phi: &[f32]) -> Decoded {
    let label = (0..phi.len()).fold(0, |best, x| if phi[x] > phi[best] { x } else { best });
    let sum: f32 = phi.iter().sum();
    Decoded { variable: variable as u32, label: label as u32, confidence: f64::from(phi[label] / sum) }
}

fn make_block(
    kernel: Kernel<'_>,
    messages: &[f32],
    block: &Block,
    (near, far): &(Lanes, Lanes),
    scratch: &mut Scratch,
    output: Option<&mut [f32]>,
) -> (Vec<Decoded>, f32) {
    let mut decoded = Vec::with_capacity(block.variables.len());
    let mut largest = [0.0f32; LANES];
    for of in &block.variables {
        let found = kernel.cavity(messages, of, scratch, &mut largest);
        // A variable in several blocks is decoded by the one that holds its first edges.
        if of.slots.start == 0 {
            decoded.push(found);
        }
    }
    let Some(new) = output else { return (decoded, 0.0) };
    let top = kernel.update((near, far), &largest, scratch);
    let old = &messages[block.first_row * kernel.stride..][..new.len()];
    let finish = Finish { floor: kernel.options.floor, damping: kernel.options.damping };
    let change = write_messages(&scratch.updated, &top, old, new, kernel.stride, finish);
    (decoded, change)
}
