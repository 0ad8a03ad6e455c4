//! Candidate sets that follow the beliefs: labels are dropped and added, messages are carried over.
//!
//! An added label gets the messages its neighbors would have sent, had it been a candidate in their last update. The
//! messages of the other labels are kept, so that a run continues after a revision instead of starting again.

use super::super::message_writer::inverse_of;
use super::super::options::Product;
use super::super::pair_table::pair_factor;
use super::candidates::{Candidates, MAX_CANDIDATES};
use super::kernel::{EightLanes, Scratch};
use super::plan::{Group, LANES, Layout, groups};
use super::potentials::UnaryInput;
use super::propagation::{ActivePropagation, BATCH_GROUPS};
use super::sets::{ActiveSets, keep_first, with_potentials};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rayon::prelude::*;

/// Marks a label that is not a candidate.
const ABSENT: u32 = u32::MAX;

/// The revision of a variable's set derived from its belief.
#[derive(Debug, Clone, PartialEq)]
struct Ranking {
    /// Labels that stay, in any order.
    kept: Vec<u32>,
    /// The best labels, whose neighbors are proposed to the variable's neighbors.
    best: Vec<u32>,
}

impl ActivePropagation<'_> {
    /// Drops labels whose belief is far below the best and adds labels that neighbors propose, according to `sets`.
    /// Returns whether any set changed.
    ///
    /// # Errors
    /// [`Cancelled`]; nothing has changed in that case.
    ///
    /// # Cost
    /// `O(n K k̄)` for the lists of near labels: between one and ten iterations.
    pub(super) fn revise(
        &mut self,
        sets: &ActiveSets,
        evidence: UnaryInput<'_>,
        observer: &dyn Observer,
    ) -> Result<bool, Cancelled> {
        checkpoint(observer)?;
        let rankings = self.rankings(sets);
        let largest = self.largest_set(sets.largest);
        let rows = (0..self.model.n_variables())
            .into_par_iter()
            .map_init(Vec::new, |votes, i| self.revised(i, &rankings, largest, votes))
            .collect();
        self.adopt(rows, evidence, observer)
    }

    /// Replaces the sets by the proposals of [`ActiveSets::propose`] for `evidence`, plus the best labels of the
    /// present beliefs. Call it when the feedback has changed; messages are carried over.
    ///
    /// # Errors
    /// [`Cancelled`]; nothing has changed in that case.
    pub fn reopen(
        &mut self,
        sets: &ActiveSets,
        evidence: UnaryInput<'_>,
        observer: &dyn Observer,
    ) -> Result<(), Cancelled> {
        let limit = self.largest_set(usize::MAX);
        let initial = sets.initial.min(limit.saturating_sub(sets.best_of_neighbors));
        let (n, n_labels) = (self.model.n_variables(), self.model.labels.n_labels());
        let mut rows = ActiveSets { initial, ..*sets }.lowest(n, n_labels, evidence, observer)?;
        for (row, ranking) in rows.iter_mut().zip(self.rankings(sets)) {
            row.extend(ranking.best);
            row.sort_unstable();
            row.dedup();
        }
        self.adopt(rows, evidence, observer)?;
        self.set_bias(evidence.bias);
        Ok(())
    }

    /// The largest number of candidates per variable, at most `wanted`, for which the candidates of all neighbors of a
    /// variable can be counted.
    fn largest_set(&self, wanted: usize) -> usize {
        let degree = (0..self.model.n_variables()).map(|i| self.model.variables.row(i).len()).max().unwrap_or(0);
        let few_labels = self.model.labels.n_labels() <= MAX_CANDIDATES;
        wanted.clamp(1, if few_labels { MAX_CANDIDATES } else { MAX_CANDIDATES / degree.max(1) })
    }

    fn rankings(&self, sets: &ActiveSets) -> Vec<Ranking> {
        let rank = |scratch: &mut Scratch, i: usize| {
            let phi = &self.phi[self.layout.row(i)];
            scratch.multiply(phi, &self.incoming(i));
            let threshold = scratch.peak(phi).value * (-sets.margin).exp();
            let beliefs = self.model.candidates.labels(i).iter().zip(scratch.belief(phi));
            let mut found: Vec<(f32, u32)> = beliefs.filter(|(_, b)| **b >= threshold).map(|(&x, &b)| (b, x)).collect();
            let order = |a: &(f32, u32), b: &(f32, u32)| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1));
            keep_first(&mut found, sets.kept.max(1), order);
            let kept = found.iter().map(|(_, x)| *x).collect();
            keep_first(&mut found, sets.best_of_neighbors, order);
            Ranking { kept, best: found.into_iter().map(|(_, x)| x).collect() }
        };
        (0..self.model.n_variables()).into_par_iter().map_init(Scratch::default, rank).collect()
    }

    /// The next candidates of `variable`, ascending: the labels that stay and, as far as there is room, the labels
    /// proposed by most neighbors. `votes` is scratch.
    fn revised(&self, variable: usize, rankings: &[Ranking], largest: usize, votes: &mut Vec<u32>) -> Vec<u32> {
        let mut kept = rankings[variable].kept.clone();
        let order = kept.len().min(largest);
        kept.truncate(order);
        kept.sort_unstable();
        votes.clear();
        for &k in self.model.variables.neighbors(variable) {
            for &x in &rankings[k as usize].best {
                votes.push(x);
                votes.extend_from_slice(self.model.labels.graph().neighbors(x as usize));
            }
        }
        votes.sort_unstable();
        let mut proposed: Vec<(usize, u32)> = votes
            .chunk_by(|a, b| a == b)
            .map(|same| (same.len(), same[0]))
            .filter(|(_, x)| kept.binary_search(x).is_err())
            .collect();
        keep_first(&mut proposed, largest - kept.len(), |a, b| b.0.cmp(&a.0).then(a.1.cmp(&b.1)));
        kept.extend(proposed.into_iter().map(|(_, x)| x));
        kept.sort_unstable();
        kept
    }

    /// Makes `rows` the candidates; returns whether they changed.
    pub(super) fn adopt(
        &mut self,
        rows: Vec<Vec<u32>>,
        evidence: UnaryInput<'_>,
        observer: &dyn Observer,
    ) -> Result<bool, Cancelled> {
        if rows.iter().enumerate().all(|(i, row)| row == self.model.candidates.labels(i)) {
            return Ok(false);
        }
        let rows: Vec<(Vec<u32>, Vec<f32>)> =
            rows.into_par_iter().enumerate().map(|(i, labels)| with_potentials(evidence, i, labels)).collect();
        let mut next = self.model.clone();
        next.candidates = Candidates::from_rows(rows.into_iter());
        let layout = Layout::new(&next);
        let n_values = layout.messages.last().copied().unwrap_or(0);
        let mut carried = std::mem::take(&mut self.spare);
        carried.clear();
        carried.resize(n_values, self.options.floor);
        let done = self.carry(&next.candidates, &layout, &mut carried, observer);
        if done.is_err() {
            carried.resize(self.messages.len(), 0.0);
            self.spare = carried;
            return done.map(|()| false);
        }
        self.spare = std::mem::replace(&mut self.messages, carried);
        self.spare.resize(n_values, 0.0);
        self.groups = groups(&next, &self.table);
        self.layout = layout;
        self.model = next;
        self.set_bias(evidence.bias);
        Ok(true)
    }

    /// Carries the messages over to the candidates `next`, into `carried` in the order of `layout`.
    fn carry(
        &self,
        next: &Candidates,
        layout: &Layout,
        carried: &mut [f32],
        observer: &dyn Observer,
    ) -> Result<(), Cancelled> {
        let mut rest = carried;
        let mut outputs: Vec<&mut [f32]> = Vec::with_capacity(self.groups.len());
        for group in &self.groups {
            let (output, left) = rest.split_at_mut(layout.sent_by(&self.model, &group.variables).len());
            outputs.push(output);
            rest = left;
        }
        let n_labels = self.model.labels.n_labels();
        for (groups, outputs) in self.groups.chunks(BATCH_GROUPS).zip(outputs.chunks_mut(BATCH_GROUPS)) {
            checkpoint(observer)?;
            groups.par_iter().zip(outputs).for_each_init(
                || (Scratch::default(), vec![ABSENT; n_labels]),
                |(scratch, number), (group, output)| self.carry_group(group, next, layout, output, scratch, number),
            );
        }
        Ok(())
    }

    /// `number` is scratch over all labels, [`ABSENT`] everywhere on entry and exit.
    fn carry_group(
        &self,
        group: &Group,
        next: &Candidates,
        layout: &Layout,
        output: &mut [f32],
        scratch: &mut Scratch,
        number: &mut [u32],
    ) {
        let first_value = layout.sent_by(&self.model, &group.variables).start;
        for (i, lists) in group.lists(&self.model) {
            let candidates = self.model.candidates.labels(i);
            candidates.iter().enumerate().for_each(|(at, &x)| number[x as usize] = at as u32);
            scratch.multiply(&self.phi[self.layout.row(i)], &self.incoming(i));
            let edges = self.model.variables.row(i);
            let mut places = lists.places;
            for first in (0..edges.len()).step_by(LANES) {
                let floor = self.update(i, first, &lists, scratch);
                for (lane, edge) in edges.clone().skip(first).take(LANES).enumerate() {
                    let j = self.model.variables.head(edge);
                    let before = self.model.candidates.labels(j);
                    let (own, left) = places.split_at(before.len());
                    places = left;
                    let top = own.iter().map(|&place| scratch.updated[place as usize].0[lane]).fold(0.0, f32::max);
                    let sender = Sender { edge, lane, floor: floor.0[lane], scale: inverse_of(top, 1.0) };
                    let old = &self.messages[self.layout.message(edge)];
                    let new = &mut output[layout.message(edge).start - first_value..][..next.labels(j).len()];
                    let mut known = before.iter().zip(old).peekable();
                    for (&y, value) in next.labels(j).iter().zip(new.iter_mut()) {
                        while known.next_if(|(x, _)| **x < y).is_some() {}
                        *value = match known.next_if(|(x, _)| **x == y) {
                            Some((_, &value)) => value,
                            None => self.value_of(y, sender, &scratch.cavity, number),
                        };
                    }
                    scale_down(new);
                }
            }
            candidates.iter().for_each(|&x| number[x as usize] = ABSENT);
        }
    }

    /// The message of `sender` at label `y`, which was not a candidate. `number` holds the sender's own candidates.
    fn value_of(&self, y: u32, sender: Sender, cavity: &[EightLanes], number: &[u32]) -> f32 {
        let edge_factors = self.factors[sender.edge];
        let epsilon = self.model.pairwise.epsilon();
        let terms = self.table.factors(y as usize).filter(|(x, _)| number[*x] != ABSENT).map(|(x, factors)| {
            let h = cavity[number[x] as usize].0[sender.lane];
            let psi = if self.model.pairwise.beta == 0.0 { 1.0 } else { pair_factor(edge_factors, factors) };
            (psi, h)
        });
        let value = match self.options.product {
            Product::Max => terms.map(|(psi, h)| psi * h).fold(sender.floor, f32::max),
            Product::Sum => {
                let all: f32 = cavity.iter().map(|h| h.0[sender.lane]).sum();
                terms.map(|(psi, h)| (psi.max(epsilon) - epsilon) * h).fold(epsilon * all, |sum, term| sum + term)
            }
        };
        // A new label may be better than all others by more than the range of a number.
        (value * sender.scale).clamp(self.options.floor, f32::MAX)
    }
}

/// One outgoing message of a variable whose cavity products are at hand.
#[derive(Debug, Clone, Copy)]
struct Sender {
    edge: usize,
    lane: usize,
    /// `ε max h`.
    floor: f32,
    /// The inverse of the largest value at the previous candidates.
    scale: f32,
}

/// Scales a message to maximum 1 if a new label is better than all others.
fn scale_down(message: &mut [f32]) {
    let top = message.iter().copied().fold(0.0, f32::max);
    if top > 1.0 {
        message.iter_mut().for_each(|value| *value /= top);
    }
}
