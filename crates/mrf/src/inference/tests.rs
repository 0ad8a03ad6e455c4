//! Belief propagation against its oracles: exact on trees, equal to the full update, the same bits on any threads.

use super::oracle::{exhaustive_marginals, exhaustive_minimum, full_update_beliefs};
use super::*;
use crate::{MrfModel, PairwisePotential};
use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};
use homolog_primitives::observe::Silent;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

/// A model over given variable edges; labels on a ring with chords, everything else from the numbers of `entropy`.
pub(super) fn model(
    n: usize,
    edges: &[[u32; 2]],
    n_labels: usize,
    entropy: &[f64],
    beta: f64,
    truncation: f64,
) -> MrfModel {
    model_with_rings(n, edges, n_labels, entropy, 1, beta, truncation)
}

/// As [`model`], with the neighborhood radius `rings`.
pub(super) fn model_with_rings(
    n: usize,
    edges: &[[u32; 2]],
    n_labels: usize,
    entropy: &[f64],
    rings: usize,
    beta: f64,
    truncation: f64,
) -> MrfModel {
    let variables = EdgeGraph::from_edges(n, edges);
    let mut numbers = entropy.iter().copied().cycle();
    let mut number = || numbers.next().unwrap_or(0.5);
    let mut label_edges: Vec<[u32; 2]> = (0..n_labels as u32 - 1).map(|x| [x, x + 1]).collect();
    if n_labels > 4 {
        label_edges.push([0, n_labels as u32 - 2]);
    }
    let place: Vec<f64> = (0..n_labels).map(|_| 3.0 * number()).collect();
    let graph = EdgeGraph::from_edges(n_labels, &label_edges);
    let labels = LabelNeighborhoods::new(&graph, rings, |x, y| (place[x] - place[y]).abs());
    let mut lengths = vec![0.0; variables.n_directed_edges()];
    let reverse = variables.reverse_edges();
    for e in 0..lengths.len() {
        if lengths[e] == 0.0 {
            lengths[e] = (0.2 + 2.0 * number()) as f32;
            lengths[reverse[e] as usize] = lengths[e];
        }
    }
    let unary = (0..n * n_labels).map(|_| (2.0 * number()) as f32).collect();
    MrfModel { variables, lengths, labels, unary, pairwise: PairwisePotential { beta, length_scale: 1.0, truncation } }
}

fn run(model: &MrfModel, product: Product, iterations: u32, damping: f32, floor: f32) -> BpOutcome {
    let options = BpOptions { product, damping, floor, tolerance: 0.0 };
    BeliefPropagation::new(model, options).run(iterations, &Silent, |_| ()).unwrap()
}

/// The edges `a < b < n` of `pairs`, and those of a path through all `n` vertices, each once.
pub(super) fn path_with_chords(n: usize, pairs: &std::collections::BTreeSet<(u32, u32)>) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = (0..n as u32 - 1).map(|k| [k, k + 1]).collect();
    edges.extend(pairs.iter().filter(|(a, b)| a < b && *b < n as u32).map(|&(a, b)| [a, b]));
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// Edges of a random tree: vertex `k > 0` hangs on an earlier one.
pub(super) fn tree(parents: &[usize]) -> Vec<[u32; 2]> {
    parents.iter().enumerate().map(|(k, &p)| [(p % (k + 1)) as u32, k as u32 + 1]).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn max_product_finds_the_minimum_on_trees(
        parents in prop::collection::vec(0usize..100, 4),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in 0.0f64..3.0,
    ) {
        let model = model(5, &tree(&parents), 5, &entropy, beta, 2.5);
        let found = run(&model, Product::Max, 12, 0.0, 1e-9);
        let lowest = exhaustive_minimum(&model);
        prop_assert!((found.energy.total() - lowest).abs() < 1e-4, "{} against {lowest}", found.energy.total());
    }

    #[test]
    fn sum_product_finds_the_marginals_on_trees(
        parents in prop::collection::vec(0usize..100, 4),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in 0.0f64..3.0,
    ) {
        let model = model(5, &tree(&parents), 5, &entropy, beta, 2.5);
        let found = run(&model, Product::Sum, 12, 0.0, 1e-9);
        for (i, marginal) in exhaustive_marginals(&model).iter().enumerate() {
            let exact = marginal[found.labeling[i] as usize];
            let highest = marginal.iter().copied().fold(0.0, f64::max);
            prop_assert!((found.confidence[i] - exact).abs() < 1e-4);
            prop_assert!(highest - exact < 1e-4);
        }
    }

    #[test]
    fn sparse_and_full_updates_give_the_same_beliefs(
        n in 2usize..24,
        chords in prop::collection::btree_set((0u32..24, 0u32..24), 0..60),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        sum in any::<bool>(),
        damping in prop_oneof![Just(0.0f32), Just(0.5)],
    ) {
        let model = model(n, &path_with_chords(n, &chords), 21, &entropy, beta, 3.0);
        let product = if sum { Product::Sum } else { Product::Max };
        let found = run(&model, product, 4, damping, 1e-5);
        let beliefs = full_update_beliefs(&model, product, 4, damping.into(), 1e-5);
        for (i, belief) in beliefs.iter().enumerate() {
            let highest = belief.iter().copied().fold(0.0, f64::max);
            prop_assert!((belief[found.labeling[i] as usize] - highest).abs() < 1e-4 * highest);
            prop_assert!((found.confidence[i] - highest).abs() < 1e-4 * highest);
        }
    }
}

/// A wheel: its hub has more neighbors than a block has lanes.
#[test]
fn variables_of_high_degree_equal_the_full_update() -> Result<(), TestCaseError> {
    let rim = 37u32;
    let edges: Vec<[u32; 2]> = (1..=rim).map(|k| [0, k]).chain((1..rim).map(|k| [k, k + 1])).collect();
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 37 % 97) / 97.0).collect();
    let model = model(rim as usize + 1, &edges, 18, &entropy, 0.7, 1.0);
    for product in [Product::Max, Product::Sum] {
        let found = run(&model, product, 3, 0.0, 1e-5);
        for (i, belief) in full_update_beliefs(&model, product, 3, 0.0, 1e-5).iter().enumerate() {
            let highest = belief.iter().copied().fold(0.0, f64::max);
            assert!((found.confidence[i] - highest).abs() < 1e-3 * highest, "{product:?} variable {i}");
        }
    }
    Ok(())
}

/// Labels of several chunks, the last of them partly filled, and variables of 1 to 11 neighbors.
#[test]
fn many_labels_equal_the_full_update() {
    let edges: Vec<[u32; 2]> = (1..=11).map(|k| [0, k]).chain((1..9).map(|k| [k, k + 3])).chain([[1, 2]]).collect();
    let entropy: Vec<f64> = (0..997).map(|k| f64::from(k * 571 % 997) / 997.0).collect();
    for (product, beta, rings) in [(Product::Max, 0.0, 3), (Product::Max, 0.7, 2), (Product::Sum, 0.0, 2)] {
        let model = model_with_rings(12, &edges, 275, &entropy, rings, beta, 1.0);
        let options = BpOptions { product, damping: 0.3, floor: 1e-5, tolerance: 0.0 };
        let mut bp = BeliefPropagation::new(&model, options);
        bp.run(3, &Silent, |_| ()).unwrap();
        for (i, belief) in full_update_beliefs(&model, product, 3, 0.3, 1e-5).iter().enumerate() {
            let highest = belief.iter().copied().fold(0.0, f64::max);
            for (found, exact) in bp.belief(i).iter().zip(belief) {
                assert!((f64::from(*found) - exact).abs() < 1e-4 * highest, "{product:?} variable {i}");
            }
        }
    }
}

#[test]
fn one_thread_and_many_give_the_same_bits() {
    let edges: Vec<[u32; 2]> = (0..199).map(|k| [k, k + 1]).chain((0..150).map(|k| [k, k + 50])).collect();
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 31 % 97) / 97.0).collect();
    let model = model(200, &edges, 90, &entropy, 0.5, 4.0);
    for product in [Product::Max, Product::Sum] {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| run(&model, product, 10, 0.5, 1e-5))
        };
        let one = with(1);
        for threads in [2, 3, 7] {
            assert_eq!(one, with(threads), "{product:?} on {threads} threads");
        }
    }
}

#[test]
fn a_cancelled_run_ends_without_an_answer() {
    struct Stop;
    impl homolog_primitives::observe::Observer for Stop {
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let model = model(3, &[[0, 1], [1, 2]], 4, &[0.1, 0.7, 0.3], 0.0, 3.0);
    let options = BpOptions { product: Product::Max, damping: 0.0, floor: 1e-5, tolerance: 0.0 };
    assert!(BeliefPropagation::new(&model, options).run(5, &Stop, |_| ()).is_err());
}

#[test]
fn messages_that_are_not_all_set_are_never_run() {
    use homolog_primitives::observe::Observer;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Asks to stop after some checks.
    struct StopAfter(usize, AtomicUsize);
    impl Observer for StopAfter {
        fn step(&self) {
            panic!("the start of a run is no step")
        }
        fn is_cancelled(&self) -> bool {
            self.1.fetch_add(1, Ordering::Relaxed) >= self.0
        }
    }
    let n = 12;
    let edges: Vec<[u32; 2]> = (0..n as u32 - 1).map(|k| [k, k + 1]).collect();
    let model = model(n, &edges, 5, &[0.1, 0.7, 0.3], 0.0, 3.0);
    let options = BpOptions { product: Product::Max, damping: 0.0, floor: 1e-5, tolerance: 0.0 };
    for update in [Update::Sparse, Update::Full] {
        let whole = StopAfter(usize::MAX, AtomicUsize::new(0));
        drop(BeliefPropagation::observed(&model, options, update, &whole));
        let asked = whole.1.load(Ordering::Relaxed);
        assert!(asked >= n + 2 * edges.len(), "{asked} checks");
        for checks in [0, edges.len(), asked - 1] {
            let stopping = StopAfter(checks, AtomicUsize::new(0));
            let mut begun = BeliefPropagation::observed(&model, options, update, &stopping);
            assert!(begun.run(5, &Silent, |_| ()).is_err(), "after {checks} of {asked}");
        }
    }
}
