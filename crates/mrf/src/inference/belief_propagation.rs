//! Loopy belief propagation: passes messages between variables until they settle or the budget ends.
//!
//! Source: Pearl 1988; Kschischang, Frey, Loeliger 2001 (sum-product, max-product); the sparse update over a
//! truncated pairwise potential follows the thesis, chapter 5.
//!
//! [`BeliefPropagation`] owns the messages (slightly more than `|E→| · n` numbers of 32 bits) and is reused, warm, between clamping rounds. An iteration is `|E→|` message updates: `O(|E→| n k̄)` with the sparse
//! update, `O(|E→| n²)` with the full update.

use super::beliefs::{belief_row, belief_spread};
use super::block_plan::LANES;
use super::flooding::Flooding;
use super::kernel::Kernel;
use super::label_order::LabelOrder;
use super::options::{BpOptions, Update};
use super::outcome::{BpIteration, BpOutcome};
use super::pair_table::{PairTable, edge_factors};
use super::unary_factors::exponentiate;
use crate::MrfModel;
use homolog_primitives::observe::{Cancelled, Observer, Silent, checkpoint_within};
use nalgebra::Point3;
use rayon::prelude::*;

/// Messages and scratch of belief propagation over one model.
pub struct BeliefPropagation<'a> {
    model: &'a MrfModel,
    options: BpOptions,
    update: Update,
    /// The order of the labels in all rows.
    order: LabelOrder,
    table: PairTable,
    /// Length of a message row: the number of labels, rounded up by [`stride`].
    stride: usize,
    /// [Unary factors](super::unary_factors) `φ_i(x)`, bias included, row by row, in the order of the labels; 0 beyond them.
    phi: Vec<f32>,
    /// For every directed edge `i → j` the edge `j → i`.
    reverse: Vec<u32>,
    flooding: Flooding,
    /// Asked while messages and unary factors are set.
    observer: &'a dyn Observer,
}

impl<'a> BeliefPropagation<'a> {
    /// Flat messages over `model`, sparse update. Allocates the memory of an iteration.
    pub fn new(model: &'a MrfModel, options: BpOptions) -> Self {
        Self::with_update(model, options, Update::default())
    }

    /// Flat messages over `model` that are updated over the label pairs of `update`.
    pub fn with_update(model: &'a MrfModel, options: BpOptions, update: Update) -> Self {
        Self::observed(model, options, update, &Silent)
    }

    /// The same; [`Self::reset`] and [`Self::set_bias`], which this calls, leave off when `observer` asks to stop. A run with that
    /// observer then returns [`Cancelled`] at once.
    pub fn observed(model: &'a MrfModel, options: BpOptions, update: Update, observer: &'a dyn Observer) -> Self {
        let graph = &model.variables;
        let stride = stride(model.n_labels());
        let (beta, scale) = (model.pairwise.beta, model.pairwise.length_scale);
        let factors: Vec<_> = model.lengths.iter().map(|&length| edge_factors(beta, scale, length)).collect();
        let order = LabelOrder::new(model.labels.graph(), stride);
        let mut this = BeliefPropagation {
            options,
            update,
            table: PairTable::new(&order.reorder(&model.labels), beta, scale),
            order,
            stride,
            phi: vec![0.0; model.n_variables() * stride],
            reverse: graph.reverse_edges(),
            flooding: Flooding::new(graph, &factors, stride),
            observer,
            model,
        };
        this.reset();
        this.set_bias(|_, _| ());
        this
    }

    /// Makes all messages flat, so that the next run starts cold.
    pub fn reset(&mut self) {
        // Beyond the labels a message stays at its floor from the first iteration on.
        let mut flat = vec![self.options.floor; self.stride];
        flat[..self.model.n_labels()].fill(1.0);
        self.flooding.fill(&flat, self.observer);
    }

    /// Sets the unary potentials to those of the model plus a bias: `add(i, row)` may add to the row of variable `i`.
    /// Messages are kept, so that the next run starts warm.
    pub fn set_bias(&mut self, add: impl Fn(usize, &mut [f32]) + Sync) {
        let n = self.model.n_labels();
        let model = self.model;
        let (order, product, observer) = (&self.order, self.options.product, self.observer);
        let _left_off = self.phi.par_chunks_mut(self.stride.max(1)).enumerate().try_for_each_init(
            || vec![0.0; n],
            |potential, (i, row)| {
                checkpoint_within(observer)?;
                potential.copy_from_slice(model.unary_row(i));
                add(i, potential);
                exponentiate(potential, product);
                for (value, &label) in row.iter_mut().zip(order.labels()) {
                    *value = potential[label as usize];
                }
                Ok::<_, Cancelled>(())
            },
        );
    }

    /// Runs until no message changes by more than the tolerance, or for `max_iterations`.
    ///
    /// `on_iteration` is called after every iteration, with the energy of the decoded labeling.
    ///
    /// # Errors
    /// [`Cancelled`] as soon as `observer` asks to stop; the messages are then half-updated.
    pub fn run(
        &mut self,
        max_iterations: u32,
        observer: &dyn Observer,
        on_iteration: impl FnMut(&BpIteration),
    ) -> Result<BpOutcome, Cancelled> {
        // Directions that were left out must not be run.
        checkpoint_within(self.observer)?;
        let kernel = Kernel {
            model: self.model,
            options: self.options,
            update: self.update,
            order: &self.order,
            table: &self.table,
            stride: self.stride,
            phi: &self.phi,
        };
        self.flooding.run(kernel, max_iterations, observer, on_iteration)
    }

    /// The belief of `variable` over all labels from the present messages, summing to 1: its marginal where sum-product
    /// is exact. All 0 if every product of messages vanishes. Cost `O(n · degree)`.
    pub fn belief(&self, variable: usize) -> Vec<f32> {
        let n = self.model.n_labels();
        let messages = self.model.variables.row(variable).map(|edge| self.incoming_row(edge));
        let belief = belief_row(&self.phi[variable * self.stride..][..n], messages);
        self.order.by_label(&belief).into_iter().map(|b| b as f32).collect()
    }

    /// The message `j → i` of the directed edge `i → j`, over the labels; its largest value is 1 up to damping.
    #[cfg(test)]
    pub(super) fn incoming_message(&self, edge: usize) -> Vec<f32> {
        self.order.by_label(self.incoming_row(edge))
    }

    /// The message `j → i` of the directed edge `i → j`, in the order of the rows.
    fn incoming_row(&self, edge: usize) -> &[f32] {
        &self.flooding.message(self.reverse[edge] as usize)[..self.model.n_labels()]
    }

    /// [`belief_spread`] of every variable over the positions of the labels, mm. Cost `O(|E→| n)`, on all cores.
    ///
    /// # Errors
    /// [`Cancelled`]; the observer is asked at every variable.
    pub fn spreads(&self, positions: &[Point3<f64>], observer: &dyn Observer) -> Result<Vec<f64>, Cancelled> {
        let spread = |i: usize| {
            checkpoint_within(observer)?;
            Ok(belief_spread(&self.belief(i), positions))
        };
        (0..self.model.n_variables()).into_par_iter().map(spread).collect()
    }
}

/// Length of a row over `n` labels: an odd number of whole vectors. Many rows are read at once, label by label; rows a
/// power of two apart would evict each other from the nearest cache, which took a third more time at 3,072 values per
/// row than at 3,088.
fn stride(n: usize) -> usize {
    (n.div_ceil(LANES) | 1) * LANES
}
