//! Fusion of labelings: a labeling of low energy in which every variable takes its label from one of two labelings.
//!
//! Belief propagation from different starts is often right about different parts. Choosing the parts is a problem of
//! two labels for each variable, whatever the number of labels of the model, so it costs `O(edges)` and not `O(edges ·
//! K²)`.
//!
//! Source: Lempitsky, Rother, Roth, Blake, "Fusion moves for Markov random field optimization", IEEE PAMI 32(8), 2010.
//! They solve the problem of two labels by roof duality; here max-product belief propagation solves it, followed by
//! conditional modes.

use super::MetricModel;
use crate::Labeling;

/// Iterations of belief propagation over two labels, and the damping of its messages.
const ITERATIONS: usize = 40;
const DAMPING: f64 = 0.5;
/// Largest number of sweeps of conditional modes over two labels.
const SWEEPS: usize = 50;

/// The choice between two labelings: the cost of each choice for a variable, and of each pair of choices for an edge.
struct Choice {
    unary: Vec<[f64; 2]>,
    /// Indexed by the choice at the first end, then by the choice at the second.
    pairwise: Vec<[[f64; 2]; 2]>,
}

impl MetricModel {
    /// Combines `a` and `b`, variable by variable, into a labeling whose energy is no higher than that of either. It is
    /// not guaranteed to be the lowest such labeling.
    ///
    /// Cost `O(n + edges)` for each of a fixed number of iterations.
    pub fn fused(&self, a: &[u32], b: &[u32]) -> Labeling {
        let choice = self.choice(a, b);
        let of_a = vec![0; a.len()];
        let of_b = vec![1; a.len()];
        let proposed = self.choice_by_propagation(&choice);
        let mut best: Option<(f64, Vec<usize>)> = None;
        for start in [of_a, of_b, proposed] {
            let found = self.settled(&choice, start);
            let energy = choice.energy(self, &found);
            if best.as_ref().is_none_or(|(lowest, _)| energy < *lowest) {
                best = Some((energy, found));
            }
        }
        let chosen = best.map_or_else(Vec::new, |(_, chosen)| chosen);
        chosen.iter().enumerate().map(|(i, &k)| [a, b][k][i]).collect()
    }

    /// Fuses `labelings` one after another, followed by up to `sweeps` of conditional modes over all labels, and
    /// repeats this until the energy stops falling. Starts from the labeling of lowest energy; ties go to the first.
    /// `None` if `labelings` is empty.
    ///
    /// Cost `O(labelings · edges + sweeps · K · edges)` per pass.
    pub fn fused_of_all(&self, labelings: &[Labeling], sweeps: usize) -> Option<Labeling> {
        let energy = |x: &Labeling| self.energy(x).total();
        let mut best = labelings.iter().min_by(|a, b| energy(a).total_cmp(&energy(b)))?.clone();
        loop {
            let before = energy(&best);
            for other in labelings {
                best = self.fused(&best, other);
            }
            best = self.descend(best, sweeps);
            // Energies are sums in a fixed order, so an unchanged labeling has the same energy to the bit.
            if energy(&best) >= before {
                return Some(best);
            }
        }
    }

    fn choice(&self, a: &[u32], b: &[u32]) -> Choice {
        let labels = |i: u32| [a[i as usize], b[i as usize]];
        Choice {
            unary: (0..self.n_variables)
                .map(|i| labels(i as u32).map(|x| f64::from(self.unary_row(i)[x as usize])))
                .collect(),
            pairwise: self
                .edges
                .iter()
                .map(|edge| {
                    let [first, second] = edge.ends.map(labels);
                    first.map(|x| second.map(|y| f64::from(self.pairwise(edge, self.row(x)[y as usize]))))
                })
                .collect(),
        }
    }

    /// The choices of belief propagation from messages of zero, updating all messages at once.
    fn choice_by_propagation(&self, choice: &Choice) -> Vec<usize> {
        // A message is the additional cost of the second choice over the first.
        let mut messages = vec![[0.0f64; 2]; self.edges.len()];
        let mut beliefs = choice.beliefs(self, &messages);
        for _ in 0..ITERATIONS {
            for ((edge, costs), message) in self.edges.iter().zip(&choice.pairwise).zip(&mut messages) {
                let [from_first, from_second] = *message;
                // The cavity of an end is its belief without the message received along this edge.
                let first = beliefs[edge.ends[0] as usize] - from_second;
                let second = beliefs[edge.ends[1] as usize] - from_first;
                let sent = |cost: [f64; 2], cavity: f64| cost[0].min(cost[1] + cavity);
                let to_second = sent([costs[0][1], costs[1][1]], first) - sent([costs[0][0], costs[1][0]], first);
                let to_first = sent(costs[1], second) - sent(costs[0], second);
                *message = [
                    DAMPING * from_first + (1.0 - DAMPING) * to_second,
                    DAMPING * from_second + (1.0 - DAMPING) * to_first,
                ];
            }
            beliefs = choice.beliefs(self, &messages);
        }
        beliefs.iter().map(|&more| usize::from(more < 0.0)).collect()
    }

    /// Conditional modes of `chosen`: variables in turn, until none changes. Every change lowers the energy.
    fn settled(&self, choice: &Choice, mut chosen: Vec<usize>) -> Vec<usize> {
        for _ in 0..SWEEPS {
            let mut changed = false;
            for i in 0..chosen.len() {
                let mut cost = choice.unary[i];
                for &e in &self.edges_of[i] {
                    let [first, second] = self.edges[e as usize].ends.map(|v| v as usize);
                    for (k, cost) in cost.iter_mut().enumerate() {
                        let table = &choice.pairwise[e as usize];
                        *cost += if first == i { table[k][chosen[second]] } else { table[chosen[first]][k] };
                    }
                }
                let other = 1 - chosen[i];
                if cost[other] < cost[chosen[i]] {
                    chosen[i] = other;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        chosen
    }
}

impl Choice {
    /// The additional cost of the second choice over the first for each variable, with all `messages`.
    fn beliefs(&self, model: &MetricModel, messages: &[[f64; 2]]) -> Vec<f64> {
        let mut beliefs: Vec<f64> = self.unary.iter().map(|[first, second]| second - first).collect();
        for (edge, [to_second, to_first]) in model.edges.iter().zip(messages) {
            beliefs[edge.ends[1] as usize] += to_second;
            beliefs[edge.ends[0] as usize] += to_first;
        }
        beliefs
    }

    fn energy(&self, model: &MetricModel, chosen: &[usize]) -> f64 {
        let unary: f64 = self.unary.iter().zip(chosen).map(|(cost, &k)| cost[k]).sum();
        let of_edge = |(edge, table): (&super::MetricEdge, &[[f64; 2]; 2])| {
            let [first, second] = edge.ends.map(|v| chosen[v as usize]);
            table[first][second]
        };
        unary + model.edges.iter().zip(&self.pairwise).map(of_edge).sum::<f64>()
    }
}
