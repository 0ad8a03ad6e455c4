//! Messages over candidates with the flooding schedule: every message is computed from those of the previous iteration.

use super::super::beliefs::{belief_row, belief_spread};
use super::super::message_writer::Finish;
use super::super::options::{BpOptions, Product};
use super::super::outcome::{BpIteration, BpOutcome, BpStop, Decoded, Progress};
use super::super::pair_table::{PairTable, edge_factors};
use super::super::unary_factors::exponentiate;
use super::kernel::{EightLanes, Scratch, max_uniform, max_weighted, sum_uniform, sum_weighted};
use super::model::ActiveModel;
use super::plan::{Group, LANES, Layout, NearLists, groups};
use super::potentials::{UnaryInput, UnaryPotentials};
use super::sets::ActiveSets;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use nalgebra::Point3;
use rayon::prelude::*;

/// Groups of variables between two calls of the observer.
pub(super) const BATCH_GROUPS: usize = 32;

/// Result of a run over revised sets.
#[derive(Debug, Clone, PartialEq)]
pub struct ActiveOutcome {
    /// The result of the propagation.
    pub propagation: BpOutcome,
    /// Mean number of candidates per variable, over variables and iterations.
    pub mean_active: f64,
    /// Number of revisions of the sets.
    pub revisions: u32,
    /// Number of near label pairs visited by all message updates together.
    pub pair_updates: u64,
}

/// Messages and candidate sets, which are kept between runs.
///
/// # Cost
/// `O(|E→| K k)` an iteration for `K` candidates a variable, `k` of them near a label. Memory: ten bytes for each of the
/// `|E→| K` values of the messages (which are held twice, with a place in a list) and two for each pair of near labels, ten
/// where the pairwise potential has a distance term.
pub struct ActivePropagation<'a> {
    pub(super) model: ActiveModel<'a>,
    pub(super) options: BpOptions,
    pub(super) table: PairTable,
    /// `j → i` for every directed edge `i → j`.
    pub(super) reverse: Vec<u32>,
    /// Near and far factor of every directed edge.
    pub(super) factors: Vec<(f32, f32)>,
    pub(super) layout: Layout,
    pub(super) groups: Vec<Group>,
    /// Unary factors, bias included, in rows of the layout; 0 beyond the candidates.
    pub(super) phi: Vec<f32>,
    pub(super) messages: Vec<f32>,
    /// Buffer for the next messages.
    pub(super) spare: Vec<f32>,
}

/// Control of the revisions during a run.
type Revising<'r> = Option<(&'r ActiveSets, UnaryInput<'r>)>;

impl<'a> ActivePropagation<'a> {
    /// Flat messages over the candidates of `model`. Allocates the memory of an iteration.
    pub fn new(model: ActiveModel<'a>, options: BpOptions) -> Self {
        let (beta, scale) = (model.pairwise.beta, model.pairwise.length_scale);
        let table = PairTable::new(model.labels, beta, scale);
        let groups = groups(&model, &table);
        let mut this = ActivePropagation {
            options,
            reverse: model.variables.reverse_edges(),
            factors: model.lengths.iter().map(|&length| edge_factors(beta, scale, length)).collect(),
            layout: Layout::new(&model),
            groups,
            phi: Vec::new(),
            messages: Vec::new(),
            spare: Vec::new(),
            table,
            model,
        };
        this.set_bias(None);
        this.reset();
        this
    }

    /// The model with its present candidates.
    pub fn model(&self) -> &ActiveModel<'a> {
        &self.model
    }

    /// Makes all messages flat, so that the next run starts cold.
    pub fn reset(&mut self) {
        let n_values = self.layout.messages.last().copied().unwrap_or(0);
        // Beyond the candidates a message stays at its floor from the first iteration on.
        self.messages.clear();
        self.messages.resize(n_values, self.options.floor);
        self.spare.resize(n_values, 0.0);
        for edge in 0..self.model.variables.n_directed_edges() {
            let n = self.model.candidates.labels(self.model.variables.head(edge)).len();
            self.messages[self.layout.message(edge)][..n].fill(1.0);
        }
    }

    /// Sets the bias on the unary potentials of the present candidates. Messages are kept.
    pub fn set_bias(&mut self, bias: Option<&dyn UnaryPotentials>) {
        let (model, product) = (&self.model, self.options.product);
        let rows: Vec<Vec<f32>> = (0..model.n_variables())
            .into_par_iter()
            .map(|i| {
                let unary = model.candidates.unary(i);
                let mut row = vec![0.0; unary.len()];
                if let Some(bias) = bias {
                    bias.at(i, model.candidates.labels(i), &mut row);
                }
                row.iter_mut().zip(unary).for_each(|(value, theta)| *value += theta);
                exponentiate(&mut row, product);
                row
            })
            .collect();
        self.phi.clear();
        self.phi.resize(self.layout.rows.last().copied().unwrap_or(0), 0.0);
        for (i, row) in rows.iter().enumerate() {
            self.phi[self.layout.row(i)][..row.len()].copy_from_slice(row);
        }
    }

    /// Runs over the present candidates until no message changes by more than the tolerance, or for `max_iterations`.
    /// Reports like [`crate::inference::BeliefPropagation::run`], and equals it if all labels are candidates.
    ///
    /// # Errors
    /// [`Cancelled`]; the messages are then those of the last finished iteration.
    pub fn run(
        &mut self,
        max_iterations: u32,
        observer: &dyn Observer,
        on_iteration: impl FnMut(&BpIteration),
    ) -> Result<BpOutcome, Cancelled> {
        Ok(self.run_with(max_iterations, None, observer, on_iteration)?.propagation)
    }

    /// Like [`Self::run`], with candidates revised according to `sets` from the potentials of `evidence`. The bias of
    /// `evidence` takes effect at the first revision; set it before the run as well. A run ends when neither messages
    /// nor sets change.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn run_revising(
        &mut self,
        max_iterations: u32,
        sets: &ActiveSets,
        evidence: UnaryInput<'_>,
        observer: &dyn Observer,
        on_iteration: impl FnMut(&BpIteration),
    ) -> Result<ActiveOutcome, Cancelled> {
        self.run_with(max_iterations, Some((sets, evidence)), observer, on_iteration)
    }

    fn run_with(
        &mut self,
        max_iterations: u32,
        revising: Revising<'_>,
        observer: &dyn Observer,
        mut on_iteration: impl FnMut(&BpIteration),
    ) -> Result<ActiveOutcome, Cancelled> {
        let mut progress = Progress::new(self.model.n_variables());
        let mut delta = f32::INFINITY;
        let mut settled = false;
        let (mut revisions, mut pair_updates, mut active) = (0, 0, 0.0);
        // The pass that computes the next messages also computes the beliefs, so the labeling of iteration `k` is known
        // in pass `k + 1`; the last pass only decodes.
        for pass in 0..=max_iterations {
            settled = delta <= self.options.tolerance;
            if let Some((sets, evidence)) = revising
                && pass > 0
                && pass < max_iterations
                && (settled || pass % sets.every.max(1) == 0)
            {
                revisions += 1;
                settled &= !self.revise(sets, evidence, observer)?;
            }
            let last = pass == max_iterations || settled;
            let (decoded, new_delta) = self.pass(!last, observer)?;
            let labels_changed = progress.decoded(&decoded, |labeling| self.model.energy(labeling));
            if pass > 0 {
                on_iteration(&progress.iterated(delta, labels_changed));
            }
            if last {
                break;
            }
            delta = new_delta;
            pair_updates += self.pair_updates();
            active += self.model.candidates.mean_size();
        }
        let iterations = progress.iterations();
        Ok(ActiveOutcome {
            propagation: progress.finish(if settled { BpStop::Converged } else { BpStop::MaxIterations }),
            mean_active: if iterations > 0 {
                active / f64::from(iterations)
            } else {
                self.model.candidates.mean_size()
            },
            revisions,
            pair_updates,
        })
    }

    /// One pass over all variables: decodes the beliefs of the present messages and, with `update`, computes the next
    /// messages. Returns the largest change of a message.
    fn pass(&mut self, update: bool, observer: &dyn Observer) -> Result<(Vec<Decoded>, f32), Cancelled> {
        let mut spare = std::mem::take(&mut self.spare);
        let mut rest = spare.as_mut_slice();
        let mut outputs: Vec<&mut [f32]> = Vec::with_capacity(self.groups.len());
        for group in &self.groups {
            let n_values = if update { self.layout.sent_by(&self.model, &group.variables).len() } else { 0 };
            let (output, left) = rest.split_at_mut(n_values);
            outputs.push(output);
            rest = left;
        }
        let mut found = Vec::with_capacity(self.model.n_variables());
        let mut delta = 0.0f32;
        let mut finished = Ok(());
        for (groups, outputs) in self.groups.chunks(BATCH_GROUPS).zip(outputs.chunks_mut(BATCH_GROUPS)) {
            finished = checkpoint(observer);
            if finished.is_err() {
                break;
            }
            let results: Vec<(Vec<Decoded>, f32)> = groups
                .par_iter()
                .zip(outputs)
                .map_init(Scratch::default, |scratch, (group, output)| {
                    self.pass_group(group, update.then_some(&mut **output), scratch)
                })
                .collect();
            for (decoded, change) in results {
                found.extend(decoded);
                delta = delta.max(change);
            }
        }
        self.spare = spare;
        finished?;
        if update {
            std::mem::swap(&mut self.messages, &mut self.spare);
        }
        Ok((found, delta))
    }

    fn pass_group(&self, group: &Group, output: Option<&mut [f32]>, scratch: &mut Scratch) -> (Vec<Decoded>, f32) {
        let mut decoded = Vec::with_capacity(group.variables.len());
        let mut change = 0.0f32;
        let mut output = output;
        let finish = Finish { floor: self.options.floor, damping: self.options.damping };
        let first_value = self.layout.sent_by(&self.model, &group.variables).start;
        for (i, lists) in group.lists(&self.model) {
            let phi = &self.phi[self.layout.row(i)];
            scratch.multiply(phi, &self.incoming(i));
            let peak = scratch.peak(phi);
            let confidence = if peak.sum > 0.0 { f64::from(peak.value / peak.sum) } else { 0.0 };
            let label = self.model.candidates.labels(i)[peak.candidate as usize];
            decoded.push(Decoded { variable: i as u32, label, confidence });
            let Some(output) = output.as_deref_mut() else { continue };
            let mut places = lists.places;
            let edges = self.model.variables.row(i);
            for first in (0..edges.len()).step_by(LANES) {
                self.update(i, first, &lists, scratch);
                for (lane, edge) in edges.clone().skip(first).take(LANES).enumerate() {
                    let n = self.model.candidates.labels(self.model.variables.head(edge)).len();
                    let (own, left) = places.split_at(n);
                    places = left;
                    let range = self.layout.message(edge);
                    let new = &mut output[range.start - first_value..range.end - first_value];
                    change = change.max(scratch.finish(lane, own, finish, &self.messages[range], new));
                }
            }
        }
        (decoded, change)
    }

    /// The messages to `variable`, in the order of its edges.
    pub(super) fn incoming(&self, variable: usize) -> Vec<&[f32]> {
        let message = |edge: usize| &self.messages[self.layout.message(self.reverse[edge] as usize)];
        self.model.variables.row(variable).map(message).collect()
    }

    /// Computes the messages of `variable`, which was multiplied last, to its neighbors from number `first` on, over
    /// the union of their candidates, unscaled, into `scratch.updated`. Returns a lower bound of each message.
    pub(super) fn update(
        &self,
        variable: usize,
        first: usize,
        lists: &NearLists<'_>,
        scratch: &mut Scratch,
    ) -> EightLanes {
        let largest = scratch.transpose(&self.phi[self.layout.row(variable)], first);
        scratch.updated.resize(lists.ends.len(), EightLanes([0.0; LANES]));
        let epsilon = self.model.pairwise.epsilon();
        let floor = EightLanes(largest.0.map(|top| top * epsilon));
        let (near, far) = self.edge_lanes(variable, first);
        let Scratch { cavity, updated, .. } = scratch;
        match (self.options.product, self.model.pairwise.beta == 0.0) {
            (Product::Max, true) => max_uniform(lists, cavity, &floor, updated),
            (Product::Max, false) => max_weighted(lists, cavity, (&near, &far), &floor, updated),
            (Product::Sum, true) => sum_uniform(lists, cavity, epsilon, updated),
            (Product::Sum, false) => sum_weighted(lists, cavity, (&near, &far), epsilon, updated),
        }
        floor
    }

    /// Near and far factors of the edges of `variable` from number `first` on; 0 where there is none.
    fn edge_lanes(&self, variable: usize, first: usize) -> (EightLanes, EightLanes) {
        let (mut near, mut far) = (EightLanes([0.0; LANES]), EightLanes([0.0; LANES]));
        let factors = &self.factors[self.model.variables.row(variable)][first..];
        for (lane, &(n, f)) in factors.iter().take(LANES).enumerate() {
            (near.0[lane], far.0[lane]) = (n, f);
        }
        (near, far)
    }

    /// The belief of `variable` over its candidates, summing to 1; all 0 if every product of messages vanishes.
    pub fn belief(&self, variable: usize) -> Vec<f32> {
        let n = self.model.candidates.labels(variable).len();
        let messages = self.incoming(variable);
        let belief = belief_row(&self.phi[self.layout.row(variable)][..n], messages.iter().map(|m| &m[..n]));
        belief.into_iter().map(|b| b as f32).collect()
    }

    /// [`belief_spread`] of every variable over the positions of all labels, mm. Cost `O(|E→| K)`, on all cores.
    pub fn spreads(&self, positions: &[Point3<f64>]) -> Vec<f64> {
        let spread = |i: usize| {
            let at: Vec<Point3<f64>> = self.model.candidates.labels(i).iter().map(|&x| positions[x as usize]).collect();
            belief_spread(&self.belief(i), &at)
        };
        (0..self.model.n_variables()).into_par_iter().map(spread).collect()
    }

    /// Number of near label pairs visited by the message updates of one iteration.
    pub fn pair_updates(&self) -> u64 {
        self.groups.iter().map(|group| group.pair_updates(&self.model)).sum()
    }

    /// Memory of messages, lists and potentials, bytes.
    pub fn memory_bytes(&self) -> usize {
        let values = self.messages.len() + self.spare.len() + self.phi.len() + 2 * self.model.candidates.n_candidates();
        4 * values + self.groups.iter().map(Group::bytes).sum::<usize>()
    }
}
