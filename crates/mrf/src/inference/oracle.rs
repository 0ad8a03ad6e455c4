//! Slow and obvious references: exhaustive minimum and marginals, and belief propagation over all label pairs in 64
//! bits.

use super::Product;
use crate::MrfModel;

/// Every labeling of the model with its energy, by counting.
pub(super) fn for_each_labeling(model: &MrfModel, mut visit: impl FnMut(&[u32], f64)) {
    let (n, labels) = (model.n_variables(), model.n_labels() as u32);
    let mut labeling = vec![0u32; n];
    loop {
        visit(&labeling, model.energy(&labeling).total());
        let Some(at) = labeling.iter().position(|&x| x + 1 < labels) else { return };
        labeling[at] += 1;
        labeling[..at].fill(0);
    }
}

/// Lowest energy of all labelings.
pub(super) fn exhaustive_minimum(model: &MrfModel) -> f64 {
    let mut lowest = f64::INFINITY;
    for_each_labeling(model, |_, energy| lowest = lowest.min(energy));
    lowest
}

/// Marginal of every variable under `p(x) ∝ exp(−E(x))`.
pub(super) fn exhaustive_marginals(model: &MrfModel) -> Vec<Vec<f64>> {
    let lowest = exhaustive_minimum(model);
    let mut marginals = vec![vec![0.0; model.n_labels()]; model.n_variables()];
    for_each_labeling(model, |labeling, energy| {
        for (marginal, &x) in marginals.iter_mut().zip(labeling) {
            marginal[x as usize] += (lowest - energy).exp();
        }
    });
    for marginal in &mut marginals {
        let sum: f64 = marginal.iter().sum();
        marginal.iter_mut().for_each(|p| *p /= sum);
    }
    marginals
}

/// Beliefs (summing to 1 for each variable) after `iterations` of the full update with the given damping and floor.
pub(super) fn full_update_beliefs(
    model: &MrfModel,
    product: Product,
    iterations: usize,
    damping: f64,
    floor: f64,
) -> Vec<Vec<f64>> {
    let graph = &model.variables;
    let n = model.n_labels();
    let phi = |i: usize, x: usize| f64::from(-model.unary_row(i)[x]).exp();
    let reverse = graph.reverse_edges();
    let mut messages = vec![vec![1.0; n]; graph.n_directed_edges()];
    for _ in 0..iterations {
        let damped = |edge: usize| {
            let updated = updated_message(model, product, &messages, edge, floor);
            let pairs = updated.iter().zip(&messages[edge]);
            pairs.map(|(new, old)| (1.0 - damping) * new + damping * old).collect()
        };
        messages = (0..messages.len()).map(damped).collect();
    }
    (0..graph.n_vertices())
        .map(|i| {
            let belief: Vec<f64> = (0..n)
                .map(|x| phi(i, x) * graph.row(i).map(|e| messages[reverse[e] as usize][x]).product::<f64>())
                .collect();
            let sum: f64 = belief.iter().sum();
            belief.iter().map(|b| b / sum).collect()
        })
        .collect()
}

/// The message of directed edge `edge` by the full update from all `messages`, scaled to maximum 1 and floored.
pub(super) fn updated_message(
    model: &MrfModel,
    product: Product,
    messages: &[Vec<f64>],
    edge: usize,
    floor: f64,
) -> Vec<f64> {
    let graph = &model.variables;
    let reverse = graph.reverse_edges();
    let i = graph.head(reverse[edge] as usize);
    let cavity = |x: usize| -> f64 {
        let others = graph.row(i).filter(|&e| e != edge);
        let phi = f64::from(-model.unary_row(i)[x]).exp();
        phi * others.map(|e| messages[reverse[e] as usize][x]).product::<f64>()
    };
    let n = model.n_labels();
    let cavity: Vec<f64> = (0..n).map(cavity).collect();
    let value = |y: usize| -> f64 {
        let terms = (0..n).map(|x| (-model.pairwise_potential(edge, x as u32, y as u32)).exp() * cavity[x]);
        match product {
            Product::Max => terms.fold(0.0, f64::max),
            Product::Sum => terms.sum(),
        }
    };
    let raw: Vec<f64> = (0..n).map(value).collect();
    let top = raw.iter().copied().fold(0.0, f64::max);
    raw.iter().map(|value| (value / top).max(floor)).collect()
}
