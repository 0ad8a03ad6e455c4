//! The model against the definition of its energy, belief propagation against all labelings.

use super::*;
use proptest::prelude::*;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// Labels at random places of a plane, variables joined by `pairs`.
pub(super) fn random_model(seed: u64, n: usize, k: usize, pairs: &[[u32; 2]]) -> MetricModel {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut uniform = || (rng.next_u32() >> 8) as f32 / (1 << 24) as f32;
    let places: Vec<[f32; 2]> = (0..k).map(|_| [uniform(), uniform()]).collect();
    let distance = |a: [f32; 2], b: [f32; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let distances = places.iter().flat_map(|&a| places.iter().map(move |&b| distance(a, b))).collect();
    let unary = (0..n * k).map(|_| uniform()).collect();
    let edges = pairs.iter().map(|&ends| MetricEdge { ends, length: uniform(), weight: 1.0 + 9.0 * uniform() });
    MetricModel::new(distances, unary, edges.collect(), 2.0)
}

/// The energy by definition.
fn energy_by_definition(model: &MetricModel, x: &[u32]) -> f64 {
    let k = model.n_labels;
    let unary: f64 = x.iter().enumerate().map(|(i, &x)| f64::from(model.unary[i * k + x as usize])).sum();
    let pairwise = model.edges.iter().map(|e| {
        let [a, b] = e.ends.map(|i| x[i as usize] as usize);
        let missed = f64::from(model.distances[a * k + b]) - f64::from(e.length);
        (f64::from(e.weight) * missed * missed).min(f64::from(model.truncation))
    });
    unary + pairwise.sum::<f64>()
}

pub(super) fn all_labelings(n: usize, k: usize) -> impl Iterator<Item = Labeling> {
    (0..k.pow(n as u32)).map(move |code| (0..n).map(|i| (code / k.pow(i as u32) % k) as u32).collect())
}

/// Max-product belief propagation over all labels by definition, in negative logarithms, from messages of zero, with
/// all messages updated at once: the preferred labels after some iterations.
pub(super) fn max_product_by_definition(model: &MetricModel, iterations: usize) -> Labeling {
    let k = model.n_labels;
    let directed: Vec<(usize, usize, &MetricEdge)> = model
        .edges
        .iter()
        .flat_map(|e| [(e.ends[0] as usize, e.ends[1] as usize, e), (e.ends[1] as usize, e.ends[0] as usize, e)])
        .collect();
    let mut messages = vec![vec![0.0f32; k]; directed.len()];
    let belief = |messages: &[Vec<f32>], i: usize, x: usize, except: Option<usize>| {
        let arrive = |m: &usize| directed[*m].1 == i && except.is_none_or(|from| directed[*m].0 != from);
        model.unary[i * k + x] + (0..directed.len()).filter(arrive).map(|m| messages[m][x]).sum::<f32>()
    };
    for _ in 0..iterations {
        let sent = |&(from, to, edge): &(usize, usize, &MetricEdge)| {
            let to_label = |y: usize| {
                let cost =
                    |x: usize| belief(&messages, from, x, Some(to)) + model.pairwise(edge, model.row(x as u32)[y]);
                (0..k).map(cost).fold(f32::INFINITY, f32::min)
            };
            (0..k).map(to_label).collect()
        };
        messages = directed.iter().map(sent).collect();
    }
    let best = |i: usize| lowest(&(0..k).map(|x| belief(&messages, i, x, None)).collect::<Vec<_>>()) as u32;
    (0..model.n_variables).map(best).collect()
}

fn least_energy(model: &MetricModel) -> f64 {
    all_labelings(model.n_variables(), model.n_labels()).map(|x| model.energy(&x).total()).fold(f64::INFINITY, f64::min)
}

/// Options of undamped max-product with this number of iterations.
fn exhaustive(iterations: u32) -> ActiveOptions {
    ActiveOptions { semiring: Semiring::Max, iterations, damping: 0.0, tolerance: 0.0 }
}

proptest! {
    #[test]
    fn the_energy_is_its_definition(seed: u64) {
        let model = random_model(seed, 4, 5, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]);
        for x in all_labelings(4, 5).step_by(37) {
            prop_assert!((model.energy(&x).total() - energy_by_definition(&model, &x)).abs() < 1e-5);
        }
    }

    #[test]
    fn what_a_label_would_cost_is_the_difference_of_energies(seed: u64) {
        let model = random_model(seed, 4, 5, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]);
        let x = vec![1, 0, 4, 2];
        for i in 0..4 {
            let cost = model.conditional(i, &x);
            for (label, &c) in cost.iter().enumerate() {
                let mut y = x.clone();
                y[i] = label as u32;
                let difference = model.energy(&y).total() - model.energy(&x).total();
                prop_assert!((f64::from(c - cost[x[i] as usize]) - difference).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn belief_propagation_finds_the_least_energy_on_a_tree(seed: u64) {
        let model = random_model(seed, 5, 4, &[[0, 1], [2, 1], [1, 3], [4, 3]]);
        let found = model.minimized(&[], 4, &exhaustive(8), 0, |_, _, _| ());
        prop_assert!((model.energy(&found).total() - least_energy(&model)).abs() < 1e-4);
    }

    #[test]
    fn conditional_modes_lower_the_energy_to_where_no_single_change_does(seed: u64, start in prop::collection::vec(0u32..5, 4)) {
        let model = random_model(seed, 4, 5, &[[0, 1], [1, 2], [2, 3], [3, 0]]);
        let found = model.descend(start.clone(), 100);
        prop_assert!(model.energy(&found).total() <= model.energy(&start).total() + 1e-5);
        for i in 0..4 {
            let cost = model.conditional(i, &found);
            prop_assert_eq!(cost[lowest(&cost)], cost[found[i] as usize]);
        }
    }

    #[test]
    fn a_bias_moves_the_answer_and_not_the_energy(seed: u64) {
        let model = random_model(seed, 3, 4, &[[0, 1], [1, 2]]);
        let mut bias = vec![100.0; 12];
        for i in 0..3 {
            bias[4 * i + 2] = 0.0;
        }
        let found = model.propagate(&model.cheapest(&bias, 4), &bias, &exhaustive(5), |_, _, _| ());
        prop_assert_eq!(found.labeling(), vec![2, 2, 2]);
    }

    #[test]
    fn on_a_tree_fusion_is_the_best_of_all_choices(
        seed: u64,
        a in prop::collection::vec(0u32..6, 7),
        b in prop::collection::vec(0u32..6, 7),
    ) {
        let model = random_model(seed, 7, 6, &[[0, 1], [2, 1], [1, 3], [4, 3], [4, 5], [6, 0]]);
        let energy = |x: &[u32]| model.energy(x).total();
        let found = energy(&model.fused(&a, &b));
        prop_assert!((found - least_of_choices(&model, &a, &b)).abs() < 1e-6, "{found}");
    }

    #[test]
    fn fusion_takes_every_label_from_one_of_both_and_is_no_worse_than_either(
        seed: u64,
        a in prop::collection::vec(0u32..6, 6),
        b in prop::collection::vec(0u32..6, 6),
    ) {
        let pairs = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [0, 3], [1, 4], [2, 5]];
        let model = random_model(seed, 6, 6, &pairs);
        let energy = |x: &[u32]| model.energy(x).total();
        let found = model.fused(&a, &b);
        prop_assert!(found.iter().zip(a.iter().zip(&b)).all(|(x, (p, q))| x == p || x == q));
        prop_assert!(energy(&found) <= energy(&a).min(energy(&b)));
        prop_assert!(energy(&found) >= least_of_choices(&model, &a, &b) - 1e-6);
        prop_assert_eq!(&model.fused(&found, &found), &found);
    }

    #[test]
    fn the_fusion_of_all_is_no_worse_than_any_and_no_change_of_one_label_improves_it(
        seed: u64,
        labelings in prop::collection::vec(prop::collection::vec(0u32..6, 6), 1..5),
    ) {
        let model = random_model(seed, 6, 6, &[[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [0, 3]]);
        let energy = |x: &[u32]| model.energy(x).total();
        let found = model.fused_of_all(&labelings, 100).unwrap();
        prop_assert!(labelings.iter().all(|x| energy(&found) <= energy(x)));
        for i in 0..6 {
            let cost = model.conditional(i, &found);
            prop_assert_eq!(cost[lowest(&cost)], cost[found[i] as usize]);
        }
    }
}

/// The lowest energy of all labelings that take every label from `a` or from `b`.
fn least_of_choices(model: &MetricModel, a: &[u32], b: &[u32]) -> f64 {
    let choice = |code: usize| -> Labeling { (0..a.len()).map(|i| [a, b][code >> i & 1][i]).collect() };
    (0..1 << a.len()).map(|code| model.energy(&choice(code)).total()).fold(f64::INFINITY, f64::min)
}

#[test]
fn fusion_puts_two_halves_together() {
    // A chain whose labels are places on a line; each labeling is right about one half of it.
    let n = 12;
    let distances = (0..n * n).map(|k| ((k / n) as f32 - (k % n) as f32).abs()).collect();
    let unary = (0..n * n).map(|k| if k / n == k % n { 0.0 } else { 0.4 }).collect();
    let edges = (1..n as u32).map(|i| MetricEdge { ends: [i - 1, i], length: 1.0, weight: 1.0 });
    let model = MetricModel::new(distances, unary, edges.collect(), 2.0);
    let truth: Labeling = (0..n as u32).collect();
    // Each puts the other half the wrong way round.
    let a: Labeling = (0..n as u32).map(|i| if i < 6 { i } else { 17 - i }).collect();
    let b: Labeling = (0..n as u32).map(|i| if i < 6 { 5 - i } else { i }).collect();
    assert_eq!(model.fused(&a, &b), truth);
    assert_eq!(model.fused_of_all(&[b, a], 10).unwrap(), truth);
    assert_eq!(model.fused_of_all(&[], 10), None);
}
