//! Fusion of labelings: a labeling of low energy in which every variable has its label of one or the other.
//!
//! Belief propagation from different starts is often right about different parts. Which part to take from which is a problem of two
//! labels for each variable, whatever the number of labels of the model, so it costs `O(edges)` and not `O(edges · K²)`.
//!
//! Source: Lempitsky, Rother, Roth, Blake, "Fusion moves for Markov random field optimization", IEEE PAMI 32(8), 2010. They solve the
//! problem of two labels by roof duality; here it is max-product belief propagation, followed by conditional modes.

use super::MetricModel;
use crate::Labeling;

/// Iterations of belief propagation over two labels, and the damping of its messages.
const ITERATIONS: usize = 40;
const DAMPING: f64 = 0.5;
/// Sweeps of conditional modes over two labels, at most.
const SWEEPS: usize = 50;

/// The choice between two labelings: what each choice costs a variable, and each pair of choices an edge.
struct Choice {
    unary: Vec<[f64; 2]>,
    /// By the choice at the first end, then by that at the second.
    pairwise: Vec<[[f64; 2]; 2]>,
}

impl MetricModel {
    /// A labeling of labels of `a` and `b`, variable by variable, whose energy is no higher than that of either. The lowest such one
    /// is not guaranteed.
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

    /// The lowest labeling that fusing `labelings` one after another leads to, followed by conditional modes over all labels
    /// for up to `sweeps`; over and over until the energy falls no more. It begins with the one of the lowest energy, the first of equal
    /// ones. `None` of none.
    ///
    /// Cost `O(labelings · edges + sweeps · K · edges)` a pass.
    pub fn fused_of_all(&self, labelings: &[Labeling], sweeps: usize) -> Option<Labeling> {
        let energy = |x: &Labeling| self.energy(x).total();
        let mut best = labelings.iter().min_by(|a, b| energy(a).total_cmp(&energy(b)))?.clone();
        loop {
            let before = energy(&best);
            for other in labelings {
                best = self.fused(&best, other);
            }
            best = self.descend(best, sweeps);
            // Energies are sums in a fixed order, so a labeling that has not changed has the same energy to the bit.
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

    /// What belief propagation from messages of zero chooses, all messages at once.
    fn choice_by_propagation(&self, choice: &Choice) -> Vec<usize> {
        // A message is how much more the second choice costs than the first.
        let mut messages = vec![[0.0f64; 2]; self.edges.len()];
        let mut beliefs = choice.beliefs(self, &messages);
        for _ in 0..ITERATIONS {
            for ((edge, costs), message) in self.edges.iter().zip(&choice.pairwise).zip(&mut messages) {
                let [from_first, from_second] = *message;
                // The cavity of an end is its belief without what it was told along this edge.
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

    /// Conditional modes of `chosen`: variables in turn, until none changes. The energy falls with every change.
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
    /// How much more the second choice costs each variable than the first, with all `messages`.
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
