//! Loopy belief propagation with flooding schedule: every message from the messages of the iteration before.
//!
//! Source: Pearl 1988; Kschischang, Frey, Loeliger 2001 (sum-product, max-product); the sparse update over a
//! truncated pairwise potential follows the thesis, chapter 5.
//!
//! [`BeliefPropagation`] owns two copies of the messages (`2 · |E→| · n` numbers of 32 bits) and is reused from one
//! clamping round to the next, warm. An iteration costs `O(|E→| n k̄)` and reads and writes each message once.

use super::block_plan::{Block, BlockPlan, LANES};
use super::sparse_update::{
    Finish, PairTable, Scratch, cavity_products, edge_factors, max_update, max_update_uniform, sum_update,
    write_messages,
};
use crate::mrf::{Energy, Labeling, MrfModel};
use crate::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Which semiring the messages live in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// Max-product: heads for the labeling of lowest energy.
    Max,
    /// Sum-product: heads for the marginals.
    Sum,
}

/// How belief propagation runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BpOptions {
    /// Which semiring.
    pub product: Product,
    /// Share of the old message that is kept, in `[0, 1)`.
    pub damping: f32,
    /// Smallest value of a message (the largest is 1).
    pub floor: f32,
    /// A run ends when no message changes by more than this.
    pub tolerance: f32,
}

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BpStop {
    /// No message changed by more than the tolerance.
    Converged,
    /// The budget of iterations ended.
    MaxIterations,
}

/// One finished iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BpIteration {
    /// From 1.
    pub iteration: u32,
    /// Energy of the labeling decoded after it.
    pub energy: Energy,
    /// Largest change of a message.
    pub message_delta_max: f32,
    /// Variables whose label changed.
    pub labels_changed: u32,
}

/// What a run leaves.
#[derive(Debug, Clone, PartialEq)]
pub struct BpOutcome {
    /// Label of the largest belief of every variable.
    pub labeling: Labeling,
    /// That belief, scaled so that the beliefs of a variable sum to 1.
    pub confidence: Vec<f64>,
    /// Energy of the labeling.
    pub energy: Energy,
    /// Iterations of this run.
    pub iterations: u32,
    /// Why it ended.
    pub stop: BpStop,
}

/// Messages and scratch of belief propagation over one model.
pub struct BeliefPropagation<'a> {
    model: &'a MrfModel,
    options: BpOptions,
    plan: BlockPlan,
    table: PairTable,
    /// Values of a message row: the labels, rounded up to whole vectors.
    stride: usize,
    /// `φ_i(x) = exp(−θ_i(x))`, unary bias included, row by row; 0 beyond the labels.
    phi: Vec<f32>,
    messages: Vec<f32>,
    next: Vec<f32>,
    /// Near and far factors of the pairwise potential, for each lane of each block.
    factors: Vec<([f32; LANES], [f32; LANES])>,
}

/// Largest belief of a variable: label and share.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Decoded {
    variable: u32,
    label: u32,
    confidence: f64,
}

impl<'a> BeliefPropagation<'a> {
    /// Flat messages over `model`. Allocates everything that an iteration needs.
    pub fn new(model: &'a MrfModel, options: BpOptions) -> Self {
        let plan = BlockPlan::new(&model.variables);
        let stride = model.n_labels().next_multiple_of(LANES);
        let messages = vec![1.0; stride * model.variables.n_directed_edges()];
        let (beta, scale) = (model.pairwise.beta, model.pairwise.length_scale);
        let factors = plan
            .blocks
            .iter()
            .map(|block| {
                let mut factors = ([0.0; LANES], [0.0; LANES]);
                for (lane, &edge) in block.edges.iter().enumerate() {
                    (factors.0[lane], factors.1[lane]) = edge_factors(beta, scale, model.lengths[edge as usize]);
                }
                factors
            })
            .collect();
        let mut this = BeliefPropagation {
            options,
            table: PairTable::new(&model.labels, beta, scale),
            stride,
            phi: vec![0.0; model.n_variables() * stride],
            next: messages.clone(),
            messages,
            plan,
            factors,
            model,
        };
        this.forget();
        this.set_bias(|_, _| ());
        this
    }

    /// Makes all messages flat again, so that the next run starts cold.
    pub fn forget(&mut self) {
        let n = self.model.n_labels();
        let floor = self.options.floor;
        self.messages.par_chunks_mut(self.stride.max(1)).for_each(|row| {
            row[..n].fill(1.0);
            row[n..].fill(floor);
        });
    }

    /// Sets the unary potentials to those of the model plus a bias: `add(i, row)` may add to the row of variable `i`.
    /// Messages stay, so that the next run starts warm.
    pub fn set_bias(&mut self, add: impl Fn(usize, &mut [f32]) + Sync) {
        let n = self.model.n_labels();
        let model = self.model;
        self.phi.par_chunks_mut(self.stride.max(1)).enumerate().for_each(|(i, row)| {
            row[..n].copy_from_slice(model.unary_row(i));
            add(i, &mut row[..n]);
            for value in &mut row[..n] {
                *value = (-*value).exp();
            }
        });
    }

    /// Runs until no message changes by more than the tolerance, or for `max_iterations`.
    ///
    /// `on_iteration` hears of every iteration after its labeling is decoded.
    ///
    /// # Errors
    /// [`Cancelled`] as soon as `observer` asks to stop; the messages are then half-updated.
    pub fn run(
        &mut self,
        max_iterations: u32,
        observer: &dyn Observer,
        mut on_iteration: impl FnMut(&BpIteration),
    ) -> Result<BpOutcome, Cancelled> {
        let n = self.model.n_variables();
        let mut decoded = vec![Decoded { variable: 0, label: 0, confidence: 1.0 }; n];
        let mut energy = Energy { unary: 0.0, pairwise: 0.0 };
        let mut stop = BpStop::MaxIterations;
        let mut delta = f32::INFINITY;
        let mut iterations = 0;
        // Beliefs come out of the pass that makes the next messages, so the labeling of iteration `k` is known in
        // pass `k + 1`; the last pass only decodes.
        for pass in 0..=max_iterations {
            let last = pass == max_iterations || delta <= self.options.tolerance;
            let (found, new_delta) = self.pass(!last, observer)?;
            let mut changed = 0;
            for d in &found {
                let slot = &mut decoded[d.variable as usize];
                changed += u32::from(slot.label != d.label || pass == 0);
                *slot = *d;
            }
            let labeling: Labeling = decoded.iter().map(|d| d.label).collect();
            energy = self.model.energy(&labeling);
            if pass > 0 {
                on_iteration(&BpIteration {
                    iteration: pass,
                    energy,
                    message_delta_max: delta,
                    labels_changed: changed,
                });
            }
            iterations = pass;
            if last {
                if delta <= self.options.tolerance {
                    stop = BpStop::Converged;
                }
                break;
            }
            delta = new_delta;
            std::mem::swap(&mut self.messages, &mut self.next);
        }
        Ok(BpOutcome {
            labeling: decoded.iter().map(|d| d.label).collect(),
            confidence: decoded.iter().map(|d| d.confidence).collect(),
            energy,
            iterations,
            stop,
        })
    }

    /// One pass over all blocks: decodes the beliefs of the present messages and, with `update`, makes the next ones.
    fn pass(&mut self, update: bool, observer: &dyn Observer) -> Result<(Vec<Decoded>, f32), Cancelled> {
        let mut outputs: Vec<&mut [f32]> = Vec::with_capacity(self.plan.blocks.len());
        let mut rest = self.next.as_mut_slice();
        for block in &self.plan.blocks {
            let (piece, tail) = rest.split_at_mut(block.edges.len() * self.stride);
            outputs.push(piece);
            rest = tail;
        }
        let kernel = Kernel {
            model: self.model,
            options: self.options,
            table: &self.table,
            stride: self.stride,
            phi: &self.phi,
            messages: &self.messages,
        };
        let stride = self.stride;
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
                    Some(kernel.block(block, factors, scratch, update.then_some(output)))
                },
            )
            .collect();
        checkpoint(observer)?;
        let mut decoded = Vec::with_capacity(self.model.n_variables());
        let mut delta = 0.0f32;
        for (found, change) in results.into_iter().flatten() {
            decoded.extend(found);
            delta = delta.max(change);
        }
        // A variable without neighbours sends nothing and stands in no block: its belief is its unary potential.
        for i in (0..self.model.n_variables()).filter(|&i| self.model.variables.row(i).is_empty()) {
            decoded.push(decode_alone(i, &self.phi[i * stride..][..self.model.n_labels()]));
        }
        Ok((decoded, delta))
    }
}

fn decode_alone(variable: usize, phi: &[f32]) -> Decoded {
    let label = (0..phi.len()).fold(0, |best, x| if phi[x] > phi[best] { x } else { best });
    let sum: f32 = phi.iter().sum();
    Decoded { variable: variable as u32, label: label as u32, confidence: f64::from(phi[label] / sum) }
}

/// What every block reads.
struct Kernel<'a> {
    model: &'a MrfModel,
    options: BpOptions,
    table: &'a PairTable,
    stride: usize,
    phi: &'a [f32],
    messages: &'a [f32],
}

impl Kernel<'_> {
    fn block(
        &self,
        block: &Block,
        (near, far): &([f32; LANES], [f32; LANES]),
        scratch: &mut Scratch,
        output: Option<&mut [f32]>,
    ) -> (Vec<Decoded>, f32) {
        let stride = self.stride;
        let mut decoded = Vec::with_capacity(block.variables.len());
        let mut largest = [0.0f32; LANES];
        for of in &block.variables {
            let phi = &self.phi[of.variable * stride..][..stride];
            let best = cavity_products(phi, self.messages, of, scratch, &mut largest);
            // A variable in several blocks is decoded by the one that holds its first edges.
            if of.slots.start == 0 {
                let confidence = if best.sum > 0.0 { f64::from(best.peak / best.sum) } else { 0.0 };
                decoded.push(Decoded { variable: of.variable as u32, label: best.label, confidence });
            }
        }
        let Some(new) = output else { return (decoded, 0.0) };
        let epsilon = (-self.model.pairwise.truncation).exp() as f32;
        let Scratch { cavity, updated, .. } = scratch;
        let floor = largest.map(|top| top * epsilon);
        let top = match self.options.product {
            Product::Max if self.model.pairwise.beta == 0.0 => max_update_uniform(self.table, cavity, &floor, updated),
            Product::Max => max_update(self.table, cavity, (near, far), &floor, updated),
            Product::Sum => sum_update(self.table, cavity, (near, far), epsilon, updated),
        };
        let old = &self.messages[block.first_row * stride..][..new.len()];
        let finish = Finish { floor: self.options.floor, damping: self.options.damping };
        let change = write_messages(updated, &top, old, new, stride, finish);
        (decoded, change)
    }
}
