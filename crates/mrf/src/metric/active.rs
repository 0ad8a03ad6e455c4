//! Belief propagation over a few **active labels** of each variable: the labels that a variable may still take.
//!
//! Most labels of a variable are too expensive by themselves for any message to compensate. With the `A` cheapest of
//! `K` labels a message takes `A²` operations instead of `K²`, and the pairwise potentials of an edge fit into a table.
//! Labels that were left out become active again where the labels of the neighbors make them cheap
//! ([`MetricModel::revised`]), and [`MetricModel::descend`] considers all labels.
//!
//! Messages are normalized and in the linear domain: `φ = exp(−θ_i)`, `ψ = exp(−θ_ij)`, `m_{i→j}(y) = ⊕_x ψ(x, y) φ(x)
//! Π_{k ≠ j} m_{k→i}(x)`, scaled to maximum 1, where `⊕` is the maximum ([`Semiring::Max`]) or the sum
//! ([`Semiring::Sum`]). Truncation keeps `ψ ≥ exp(−T)`, so no message is 0.
//!
//! Sources: Pearl 1988; Anguelov et al., NIPS 2004 (labels of low unary cost only).

use super::MetricModel;
use crate::{Energy, Labeling};
use homolog_primitives::exponential::exp_negative;
use multiversion::multiversion;
use rayon::prelude::*;

/// Edges whose messages one task computes.
const BATCH: usize = 64;

/// Reduction of messages over the labels of the sending variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Semiring {
    /// Max-product: beliefs are max-marginals, and their maxima form a labeling of low energy.
    Max,
    /// Sum-product: beliefs are marginals.
    Sum,
}

/// Options of belief propagation over active labels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveOptions {
    /// Maximum or sum.
    pub semiring: Semiring,
    /// Largest number of iterations; each computes all messages from those of the previous one.
    pub iterations: u32,
    /// Share of the old message that is kept, in `[0, 1)`.
    pub damping: f32,
    /// Largest change of a message (maximum 1) at which propagation has converged and ends.
    pub tolerance: f32,
}

/// The same number `A` of active labels for each variable, ascending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ActiveLabels {
    per_variable: usize,
    labels: Vec<u32>,
}

impl ActiveLabels {
    /// Number of active labels of each variable.
    pub fn per_variable(&self) -> usize {
        self.per_variable
    }

    /// The active labels of a variable, ascending.
    pub fn of(&self, variable: usize) -> &[u32] {
        &self.labels[variable * self.per_variable..][..self.per_variable]
    }
}

/// Beliefs over active labels; those of a variable have maximum 1 (max-product) or sum 1 (sum-product).
#[derive(Debug, Clone, PartialEq)]
pub struct ActiveBeliefs {
    /// The labels.
    pub active: ActiveLabels,
    beliefs: Vec<f32>,
    /// Number of iterations.
    pub iterations: u32,
    /// Largest change of a message in the last iteration; messages have maximum 1.
    pub message_delta_max: f32,
}

impl ActiveBeliefs {
    /// Beliefs of a variable in the order of its active labels.
    pub fn of(&self, variable: usize) -> &[f32] {
        &self.beliefs[variable * self.active.per_variable..][..self.active.per_variable]
    }

    /// The label of the largest belief of each variable; ties go to the lowest label.
    pub fn labeling(&self) -> Labeling {
        let n = self.beliefs.len() / self.active.per_variable;
        let best = |i: usize| {
            let of = self.of(i);
            let best = (0..of.len()).fold(0, |best, x| if of[x] > of[best] { x } else { best });
            self.active.of(i)[best]
        };
        (0..n).map(best).collect()
    }
}

impl MetricModel {
    /// For each variable the `per_variable` labels of lowest unary potential plus `bias` (`n × K`, or empty); ties go
    /// to the lowest label; all labels if there are fewer. Cost `O(n K)`.
    ///
    /// # Panics
    /// If `bias` has another shape.
    pub fn cheapest(&self, bias: &[f32], per_variable: usize) -> ActiveLabels {
        assert!(bias.is_empty() || bias.len() == self.unary.len(), "a bias for each unary potential");
        let cost = |i: usize| {
            let mut cost = self.unary_row(i).to_vec();
            if !bias.is_empty() {
                cost.iter_mut().zip(&bias[i * self.n_labels..]).for_each(|(c, b)| *c += b);
            }
            cost
        };
        self.active(per_variable, |i, count| cheapest_of(&cost(i), count))
    }

    /// New active labels. One half has the largest beliefs. The other half, chosen from inactive labels, costs least
    /// while all other variables have the labels that `beliefs` prefer. Cost `O(K · edges)`.
    pub fn revised(&self, beliefs: &ActiveBeliefs) -> ActiveLabels {
        let labeling = beliefs.labeling();
        self.active(beliefs.active.per_variable, |i, count| {
            let (own, labels) = (beliefs.of(i), beliefs.active.of(i));
            let mut order: Vec<usize> = (0..own.len()).collect();
            order.sort_by(|&a, &b| own[b].total_cmp(&own[a]).then(a.cmp(&b)));
            let mut kept: Vec<u32> = order[..count.div_ceil(2)].iter().map(|&k| labels[k]).collect();
            let mut cost = self.conditional(i, &labeling);
            kept.iter().for_each(|&x| cost[x as usize] = f32::INFINITY);
            kept.extend(cheapest_of(&cost, count - kept.len()));
            kept
        })
    }

    fn active(&self, per_variable: usize, choose: impl Fn(usize, usize) -> Vec<u32> + Sync) -> ActiveLabels {
        let per_variable = per_variable.min(self.n_labels);
        let of = |i: usize| {
            let mut chosen = choose(i, per_variable);
            chosen.sort_unstable();
            chosen
        };
        let labels: Vec<Vec<u32>> = (0..self.n_variables).into_par_iter().map(of).collect();
        ActiveLabels { per_variable, labels: labels.concat() }
    }

    /// Belief propagation over the `active` labels, from messages of 1. `bias` (`n × K`, or empty) is added to the
    /// unary potentials and not part of the energy. After each iteration `observe` gets its number, from 1, the energy
    /// of the labeling that the beliefs prefer, and the largest change of a message. Any number of threads gives the
    /// same bits.
    ///
    /// # Cost
    /// `O(edges · A²)` for the tables, and the same for each iteration.
    ///
    /// # Panics
    /// If `bias` has another shape.
    pub fn propagate(
        &self,
        active: &ActiveLabels,
        bias: &[f32],
        options: &ActiveOptions,
        mut observe: impl FnMut(u32, Energy, f32),
    ) -> ActiveBeliefs {
        assert!(bias.is_empty() || bias.len() == self.unary.len(), "a bias for each unary potential");
        let a = active.per_variable;
        let tables = self.tables(active);
        let unary = self.unary_factors(active, bias);
        let mut messages = vec![1.0f32; 2 * self.edges.len() * a];
        let mut beliefs =
            ActiveBeliefs { active: active.clone(), beliefs: unary.clone(), iterations: 0, message_delta_max: 0.0 };
        for iteration in 1..=options.iterations {
            let of_batch = |(batch, messages): (usize, &mut [f32])| {
                let mut scratch = vec![0.0f32; 4 * a];
                let edges = self.edges[batch * BATCH..].iter().zip(tables[batch * BATCH * a * a..].chunks_exact(a * a));
                let mut largest = 0.0f32;
                for ((edge, table), messages) in edges.zip(messages.chunks_exact_mut(2 * a)) {
                    let [first, second] = edge.ends.map(|i| beliefs.of(i as usize));
                    largest = largest.max(exchange(first, second, table, messages, &mut scratch, options));
                }
                largest
            };
            let changes: Vec<f32> = messages.par_chunks_mut(2 * a * BATCH).enumerate().map(of_batch).collect();
            beliefs.message_delta_max = changes.into_iter().fold(0.0, f32::max);
            self.collect(&unary, &messages, &mut beliefs.beliefs, a);
            beliefs.iterations = iteration;
            observe(iteration, self.energy(&beliefs.labeling()), beliefs.message_delta_max);
            if beliefs.message_delta_max <= options.tolerance {
                break;
            }
        }
        if options.semiring == Semiring::Sum {
            for own in beliefs.beliefs.chunks_exact_mut(a) {
                let total: f32 = own.iter().sum();
                own.iter_mut().for_each(|b| *b /= total);
            }
        }
        beliefs
    }

    /// `ψ` of every edge, indexed by the label of the first end, then by the label of the second.
    fn tables(&self, active: &ActiveLabels) -> Vec<f32> {
        let a = active.per_variable;
        let mut tables = vec![0.0f32; self.edges.len() * a * a];
        tables.par_chunks_mut(a * a * BATCH).enumerate().for_each(|(batch, tables)| {
            for (edge, table) in self.edges[batch * BATCH..].iter().zip(tables.chunks_exact_mut(a * a)) {
                let [first, second] = edge.ends.map(|i| active.of(i as usize));
                for (&x, row) in first.iter().zip(table.chunks_exact_mut(a)) {
                    let distances = self.row(x);
                    row.iter_mut().zip(second).for_each(|(p, &y)| *p = distances[y as usize]);
                }
                factors(table, edge.length, edge.weight, self.truncation);
            }
        });
        tables
    }

    /// `φ` of every active label, scaled to maximum 1 for each variable.
    fn unary_factors(&self, active: &ActiveLabels, bias: &[f32]) -> Vec<f32> {
        let of = |i: usize| {
            let cost = |&x: &u32| {
                let at = i * self.n_labels + x as usize;
                self.unary[at] + bias.get(at).copied().unwrap_or(0.0)
            };
            let least = active.of(i).iter().map(cost).fold(f32::INFINITY, f32::min);
            active.of(i).iter().map(move |x| exp_negative(least - cost(x))).collect::<Vec<_>>()
        };
        (0..self.n_variables).flat_map(of).collect()
    }

    /// Products of the unary factors and all incoming messages, scaled to maximum 1 for each variable.
    fn collect(&self, unary: &[f32], messages: &[f32], beliefs: &mut [f32], a: usize) {
        beliefs.par_chunks_mut(a).enumerate().for_each(|(i, own)| {
            own.copy_from_slice(&unary[i * a..][..a]);
            for &e in &self.edges_of[i] {
                // The message to the second end comes first.
                let to_second = self.edges[e as usize].ends[1] as usize == i;
                let arrived = &messages[(2 * e as usize + usize::from(!to_second)) * a..][..a];
                own.iter_mut().zip(arrived).for_each(|(b, m)| *b *= m);
                scale(own);
            }
        });
    }
}

/// The indices of the `count` lowest values of `cost`; ties go to the first.
fn cheapest_of(cost: &[f32], count: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..cost.len() as u32).collect();
    let by_cost = |&x: &u32, &y: &u32| cost[x as usize].total_cmp(&cost[y as usize]).then(x.cmp(&y));
    if count < order.len() {
        order.select_nth_unstable_by(count, by_cost);
        order.truncate(count);
    }
    order
}

/// Numbers compared or added side by side; a fixed number makes the result independent of the instruction set.
const LANES: usize = 8;

/// The largest of `values`.
#[inline(always)]
fn largest(values: &[f32]) -> f32 {
    let mut lanes = [f32::MIN_POSITIVE; LANES];
    let chunks = values.chunks_exact(LANES);
    let rest = chunks.remainder();
    for chunk in chunks {
        for (lane, &v) in lanes.iter_mut().zip(chunk) {
            *lane = if v > *lane { v } else { *lane };
        }
    }
    lanes.iter().chain(rest).fold(f32::MIN_POSITIVE, |a, &b| if b > a { b } else { a })
}

/// Divides by the largest value; no result is 0.
#[inline(always)]
fn scale(values: &mut [f32]) {
    let factor = 1.0 / largest(values);
    for v in values {
        let scaled = *v * factor;
        *v = if scaled > f32::MIN_POSITIVE { scaled } else { f32::MIN_POSITIVE };
    }
}

/// `max_y a(y) b(y)`.
#[inline(always)]
fn largest_product(a: &[f32], b: &[f32]) -> f32 {
    let mut lanes = [0.0f32; LANES];
    let (left, right) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest = left.remainder().iter().zip(right.remainder()).map(|(x, y)| x * y);
    for (x, y) in left.zip(right) {
        for k in 0..LANES {
            let product = x[k] * y[k];
            lanes[k] = if product > lanes[k] { product } else { lanes[k] };
        }
    }
    rest.chain(lanes).fold(0.0, |a, b| if b > a { b } else { a })
}

/// `Σ_y a(y) b(y)`.
#[inline(always)]
fn sum_of_products(a: &[f32], b: &[f32]) -> f32 {
    let mut lanes = [0.0f32; LANES];
    let (left, right) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest = left.remainder().iter().zip(right.remainder()).map(|(x, y)| x * y);
    for (x, y) in left.zip(right) {
        for k in 0..LANES {
            lanes[k] += x[k] * y[k];
        }
    }
    rest.sum::<f32>() + lanes.iter().sum::<f32>()
}

/// Turns distances of labels into factors `exp(−min(w (d − ℓ)², T))`.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn factors(distances: &mut [f32], length: f32, weight: f32, truncation: f32) {
    for d in distances {
        let missed = *d - length;
        *d = exp_negative(-(weight * (missed * missed)).min(truncation));
    }
}

/// Computes both messages of an edge from the beliefs of its ends; returns the largest change.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn exchange(
    first: &[f32],
    second: &[f32],
    table: &[f32],
    messages: &mut [f32],
    scratch: &mut [f32],
    options: &ActiveOptions,
) -> f32 {
    let a = first.len();
    let (to_second, to_first) = messages.split_at_mut(a);
    let (from_first, rest) = scratch.split_at_mut(a);
    let (from_second, rest) = rest.split_at_mut(a);
    let (new_to_second, new_to_first) = rest.split_at_mut(a);
    // The message that an end received along this edge is removed from its belief.
    for x in 0..a {
        from_first[x] = first[x] / to_first[x];
        from_second[x] = second[x] / to_second[x];
    }
    scale(from_first);
    scale(from_second);
    new_to_second.fill(0.0);
    match options.semiring {
        Semiring::Max => {
            for ((row, &h), back) in table.chunks_exact(a).zip(&*from_first).zip(&mut *new_to_first) {
                for (m, p) in new_to_second.iter_mut().zip(row) {
                    let there = h * p;
                    *m = if there > *m { there } else { *m };
                }
                *back = largest_product(from_second, row);
            }
        }
        Semiring::Sum => {
            for ((row, &h), back) in table.chunks_exact(a).zip(&*from_first).zip(&mut *new_to_first) {
                for (m, p) in new_to_second.iter_mut().zip(row) {
                    *m += h * p;
                }
                *back = sum_of_products(from_second, row);
            }
        }
    }
    scale(new_to_second);
    scale(new_to_first);
    damped(to_second, new_to_second, options.damping).max(damped(to_first, new_to_first, options.damping))
}

/// Moves `old` messages towards `new` ones, which become the changes; returns the largest change.
#[inline(always)]
fn damped(old: &mut [f32], new: &mut [f32], damping: f32) -> f32 {
    for (old, new) in old.iter_mut().zip(&mut *new) {
        let change = (*new - *old).abs();
        *old = damping * *old + (1.0 - damping) * *new;
        *new = change;
    }
    largest(new)
}

impl MetricModel {
    /// The labeling found by max-product over active labels: the cheapest labels with `bias`, revised once from the
    /// beliefs, then up to `sweeps` of conditional modes over all labels.
    pub fn minimized(
        &self,
        bias: &[f32],
        per_variable: usize,
        options: &ActiveOptions,
        sweeps: usize,
        mut observe: impl FnMut(u32, Energy, f32),
    ) -> Labeling {
        let first = self.propagate(&self.cheapest(bias, per_variable), bias, options, &mut observe);
        let revised = self.propagate(&self.revised(&first), &[], options, |k, energy, change| {
            observe(first.iterations + k, energy, change);
        });
        let candidates = [first.labeling(), revised.labeling()].map(|x| self.descend(x, sweeps));
        let [a, b] = [0, 1].map(|k| self.energy(&candidates[k]).total());
        let [of_first, of_revised] = candidates;
        if b < a { of_revised } else { of_first }
    }
}

#[cfg(test)]
mod tests {
    use super::super::lowest;
    use super::super::tests::{all_labelings, max_product_by_definition, random_model};
    use super::*;
    use proptest::prelude::*;

    fn options(semiring: Semiring, iterations: u32) -> ActiveOptions {
        ActiveOptions { semiring, iterations, damping: 0.0, tolerance: 0.0 }
    }

    proptest! {
        #[test]
        fn on_a_tree_beliefs_are_the_marginals_over_all_labelings(seed in 0u64..200) {
            let (n, k) = (4, 5);
            let model = random_model(seed, n, k, &[[0, 1], [2, 1], [1, 3]]);
            let all = model.cheapest(&[], k);
            for semiring in [Semiring::Max, Semiring::Sum] {
                let found = model.propagate(&all, &[], &options(semiring, 6), |_, _, _| {});
                for i in 0..n {
                    let mut expected = vec![0.0f64; k];
                    for x in all_labelings(n, k) {
                        let p = (-model.energy(&x).total()).exp();
                        let at = &mut expected[x[i] as usize];
                        *at = if semiring == Semiring::Max { at.max(p) } else { *at + p };
                    }
                    let total = match semiring {
                        Semiring::Max => expected.iter().fold(0.0f64, |a, &b| a.max(b)),
                        Semiring::Sum => expected.iter().sum(),
                    };
                    for (found, expected) in found.of(i).iter().zip(&expected) {
                        prop_assert!((f64::from(*found) - expected / total).abs() < 1e-5);
                    }
                }
            }
        }

        #[test]
        fn the_cheapest_labels_are_those_of_lowest_cost_and_revision_keeps_the_preferred_ones(seed in 0u64..100) {
            let (n, k, a) = (6, 12, 4);
            let pairs = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]];
            let model = random_model(seed, n, k, &pairs);
            let active = model.cheapest(&[], a);
            for i in 0..n {
                let most = active.of(i).iter().map(|&x| model.unary_row(i)[x as usize]).fold(0.0, f32::max);
                let cheaper = model.unary_row(i).iter().filter(|&&u| u < most).count();
                prop_assert!(cheaper < a && active.of(i).is_sorted());
            }
            let found = model.propagate(&active, &[], &options(Semiring::Max, 5), |_, _, _| {});
            let revised = model.revised(&found);
            for (i, x) in found.labeling().iter().enumerate() {
                prop_assert!(revised.of(i).contains(x));
                let mut distinct = revised.of(i).to_vec();
                distinct.dedup();
                prop_assert_eq!(distinct.len(), a);
            }
        }

        #[test]
        fn all_labels_active_lead_where_max_product_over_all_labels_does(seed in 0u64..60) {
            let (n, k) = (5, 9);
            let model = random_model(seed, n, k, &[[0, 1], [1, 2], [2, 3], [3, 4], [4, 0], [1, 3]]);
            let found = model.propagate(&model.cheapest(&[], k), &[], &options(Semiring::Max, 3), |_, _, _| {});
            prop_assert_eq!(found.labeling(), max_product_by_definition(&model, 3));
        }

        #[test]
        fn the_minimized_labeling_costs_no_more_than_what_propagation_alone_finds(seed in 0u64..60) {
            let (n, k) = (7, 20);
            let model = random_model(seed, n, k, &[[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 0], [0, 3]]);
            let run = options(Semiring::Max, 8);
            let alone = model.propagate(&model.cheapest(&[], 6), &[], &run, |_, _, _| {});
            let found = model.minimized(&[], 6, &run, 20, |_, _, _| {});
            prop_assert!(model.energy(&found).total() <= model.energy(&alone.labeling()).total() + 1e-9);
        }
    }

    #[test]
    fn a_bias_says_where_propagation_begins() {
        // Two labelings of one energy: a variable of each end may be at either end of the target.
        let distances = vec![0.0, 1.0, 1.0, 0.0];
        let edge = super::super::MetricEdge { ends: [0, 1], length: 1.0, weight: 50.0 };
        let model = MetricModel::new(distances, vec![0.0; 4], vec![edge], 3.0);
        let active = model.cheapest(&[], 2);
        for (bias, expected) in [([0.0, 1.0, 0.0, 0.0], [0, 1]), ([1.0, 0.0, 0.0, 0.0], [1, 0])] {
            let found = model.propagate(&active, &bias, &options(Semiring::Max, 4), |_, _, _| {});
            assert_eq!(found.labeling(), expected);
        }
        assert_eq!(lowest(&[2.0, 1.0, 1.0]), 1);
    }
}
