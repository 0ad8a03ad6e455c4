//! The model against the definition of its energy, belief propagation against all labelings.

use super::*;
use proptest::prelude::*;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// Labels at random places of a plane, variables joined by `pairs`.
fn random_model(seed: u64, n: usize, k: usize, pairs: &[[u32; 2]]) -> MetricModel {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut uniform = || (rng.next_u32() >> 8) as f32 / (1 << 24) as f32;
    let places: Vec<[f32; 2]> = (0..k).map(|_| [uniform(), uniform()]).collect();
    let distance = |a: [f32; 2], b: [f32; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let distances = places.iter().flat_map(|&a| places.iter().map(move |&b| distance(a, b))).collect();
    let unary = (0..n * k).map(|_| uniform()).collect();
    let edges = pairs.iter().map(|&ends| MetricEdge { ends, length: uniform(), weight: 1.0 + 9.0 * uniform() });
    MetricModel::new(distances, unary, edges.collect(), 2.0)
}

/// The energy as it is written.
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

fn all_labelings(n: usize, k: usize) -> impl Iterator<Item = Labeling> {
    (0..k.pow(n as u32)).map(move |code| (0..n).map(|i| (code / k.pow(i as u32) % k) as u32).collect())
}

fn least_energy(model: &MetricModel) -> f64 {
    all_labelings(model.n_variables(), model.n_labels()).map(|x| model.energy(&x).total()).fold(f64::INFINITY, f64::min)
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
        let found = model.max_product(&[], 8, 0.0);
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
        prop_assert_eq!(model.max_product(&bias, 5, 0.0), vec![2, 2, 2]);
    }
}
