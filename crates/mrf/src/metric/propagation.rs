//! Max-product belief propagation with dense messages, in negative logarithms (min-sum).

use super::{MetricEdge, MetricModel, lowest};
use crate::Labeling;
use multiversion::multiversion;

/// Messages along both directions of every edge, `K` numbers each: first from the first end to the second, then back.
struct Messages {
    values: Vec<f32>,
    n_labels: usize,
}

impl Messages {
    fn of(&self, edge: usize, direction: usize) -> &[f32] {
        &self.values[(2 * edge + direction) * self.n_labels..][..self.n_labels]
    }

    fn of_mut(&mut self, edge: usize, direction: usize) -> &mut [f32] {
        &mut self.values[(2 * edge + direction) * self.n_labels..][..self.n_labels]
    }
}

impl MetricModel {
    /// The labels that `iterations` of damped belief propagation prefer, from messages of zero, all messages at once. `bias`
    /// (`n × K`, or empty) is added to the unary potentials; it says where to begin, and is no part of the energy.
    ///
    /// # Cost
    /// `O(iterations · edges · K²)`, less by the share of labels that cost more than the best one and the truncation.
    ///
    /// # Panics
    /// If `bias` has another shape.
    pub fn max_product(&self, bias: &[f32], iterations: usize, damping: f32) -> Labeling {
        let k = self.n_labels;
        let mut unary = self.unary.clone();
        assert!(bias.is_empty() || bias.len() == unary.len(), "a bias for each unary potential");
        unary.iter_mut().zip(bias).for_each(|(u, b)| *u += b);
        let mut messages = Messages { values: vec![0.0; 2 * self.edges.len() * k], n_labels: k };
        let (mut cavity, mut next) = (vec![0.0; k], [vec![0.0; k], vec![0.0; k]]);
        for _ in 0..iterations {
            let beliefs = self.beliefs(&unary, &messages);
            for (e, edge) in self.edges.iter().enumerate() {
                for direction in 0..2 {
                    let belief = &beliefs[edge.ends[direction] as usize * k..][..k];
                    for ((c, b), m) in cavity.iter_mut().zip(belief).zip(messages.of(e, 1 - direction)) {
                        *c = b - m;
                    }
                    send(&cavity, edge, &self.distances, self.truncation, &mut next[direction]);
                }
                for (direction, next) in next.iter().enumerate() {
                    for (m, n) in messages.of_mut(e, direction).iter_mut().zip(next) {
                        *m = damping * *m + (1.0 - damping) * n;
                    }
                }
            }
        }
        self.beliefs(&unary, &messages).chunks_exact(k).map(|belief| lowest(belief) as u32).collect()
    }

    /// The sum of the unary potential and all messages that arrive, for each variable and label.
    fn beliefs(&self, unary: &[f32], messages: &Messages) -> Vec<f32> {
        let mut beliefs = unary.to_vec();
        for (e, edge) in self.edges.iter().enumerate() {
            for direction in 0..2 {
                let to = edge.ends[1 - direction] as usize;
                let belief = &mut beliefs[to * self.n_labels..][..self.n_labels];
                belief.iter_mut().zip(messages.of(e, direction)).for_each(|(b, m)| *b += m);
            }
        }
        beliefs
    }
}

/// The message along `edge` of a variable whose labels cost `cavity` without it: `min_x [cavity(x) + θ(x, y)]` for each `y`,
/// above its lowest possible value.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn send(cavity: &[f32], edge: &MetricEdge, distances: &[f32], truncation: f32, message: &mut [f32]) {
    let best = cavity.iter().fold(f32::INFINITY, |a, &b| a.min(b));
    message.fill(truncation);
    for (x, &cost) in cavity.iter().enumerate() {
        let cost = cost - best;
        // Any label is as cheap from the best one by way of the truncation.
        if cost >= truncation {
            continue;
        }
        let row = &distances[x * message.len()..][..message.len()];
        for (m, &distance) in message.iter_mut().zip(row) {
            let missed = distance - edge.length;
            let candidate = cost + edge.weight * (missed * missed);
            *m = if candidate < *m { candidate } else { *m };
        }
    }
}
