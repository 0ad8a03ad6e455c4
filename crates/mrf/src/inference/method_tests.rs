//! Full update, convergence, beliefs and the hard constraint against their oracles.

use super::oracle::{exhaustive_marginals, exhaustive_minimum, updated_message};
use super::tests::{model, model_with_rings, path_with_chords, tree};
use super::*;
use crate::MrfModel;
use homolog_primitives::observe::Silent;
use nalgebra::Point3;
use proptest::prelude::*;

fn options(product: Product, damping: f32, floor: f32) -> BpOptions {
    BpOptions { product, damping, floor, tolerance: 0.0 }
}

fn run(model: &MrfModel, options: BpOptions, update: Update, iterations: u32) -> (BpOutcome, Vec<Vec<f32>>) {
    let mut bp = BeliefPropagation::with_update(model, options, update);
    let outcome = bp.run(iterations, &Silent, |_| ()).unwrap();
    let beliefs = (0..model.n_variables()).map(|i| bp.belief(i)).collect();
    (outcome, beliefs)
}

fn any_update() -> impl Strategy<Value = Update> {
    prop_oneof![Just(Update::Sparse), Just(Update::Full)]
}

fn any_truncation() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.05f64..0.5, 1.0f64..4.0, Just(f64::INFINITY)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn full_and_sparse_updates_agree_to_the_bit_for_max_and_to_rounding_for_sum(
        n in 2usize..12,
        chords in prop::collection::btree_set((0u32..12, 0u32..12), 0..30),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        n_labels in 2usize..40,
        rings in 1usize..4,
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        truncation in any_truncation(),
    ) {
        let model = model_with_rings(n, &path_with_chords(n, &chords), n_labels, &entropy, rings, beta, truncation);
        let max = options(Product::Max, 0.5, 1e-5);
        prop_assert_eq!(run(&model, max, Update::Full, 5), run(&model, max, Update::Sparse, 5));
        let sum = options(Product::Sum, 0.5, 1e-5);
        let (full, sparse) = (run(&model, sum, Update::Full, 5).1, run(&model, sum, Update::Sparse, 5).1);
        for (a, b) in full.iter().flatten().zip(sparse.iter().flatten()) {
            prop_assert!((a - b).abs() < 1e-4, "{a} against {b}");
        }
    }

    #[test]
    fn every_method_finds_the_minimum_and_the_marginals_on_trees(
        parents in prop::collection::vec(0usize..100, 4),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        update in any_update(),
    ) {
        let model = model(5, &tree(&parents), 5, &entropy, beta, 2.5);
        let lowest = exhaustive_minimum(&model);
        let (outcome, _) = run(&model, options(Product::Max, 0.0, 1e-9), update, 40);
        prop_assert!((outcome.energy.total() - lowest).abs() < 1e-4, "{} against {lowest}", outcome.energy.total());
        let (_, beliefs) = run(&model, options(Product::Sum, 0.0, 1e-9), update, 40);
        for (belief, marginal) in beliefs.iter().zip(exhaustive_marginals(&model)) {
            for (b, exact) in belief.iter().zip(marginal) {
                prop_assert!((f64::from(*b) - exact).abs() < 1e-5, "{b} against {exact}");
            }
        }
    }

    #[test]
    fn messages_settle_at_a_fixed_point_of_the_full_update(
        n in 3usize..10,
        chords in prop::collection::btree_set((0u32..10, 0u32..10), 0..12),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..2.0],
        sum in any::<bool>(),
        damping in prop_oneof![Just(0.0f32), Just(0.5)],
        update in any_update(),
    ) {
        let model = model(n, &path_with_chords(n, &chords), 9, &entropy, beta, 0.5);
        let product = if sum { Product::Sum } else { Product::Max };
        let settings = BpOptions { tolerance: 1e-6, ..options(product, damping, 1e-5) };
        let mut bp = BeliefPropagation::with_update(&model, settings, update);
        let outcome = bp.run(400, &Silent, |_| ()).unwrap();
        prop_assume!(outcome.stop == BpStop::Converged);
        // Models with cycles may have several fixed points, so agreement with another run would prove nothing.
        let reverse = model.variables.reverse_edges();
        let message = |edge: &u32| bp.incoming_message(*edge as usize).iter().map(|&m| f64::from(m)).collect();
        let messages: Vec<Vec<f64>> = reverse.iter().map(message).collect();
        for (edge, message) in messages.iter().enumerate() {
            for (m, exact) in message.iter().zip(updated_message(&model, product, &messages, edge, 1e-5)) {
                prop_assert!((m - exact).abs() < 1e-5, "{m} against {exact}");
            }
        }
    }
}

#[test]
fn every_update_gives_the_same_bits_on_any_number_of_threads() {
    let edges: Vec<[u32; 2]> = (0..99).map(|k| [k, k + 1]).chain((0..70).map(|k| [k, k + 30])).collect();
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 31 % 97) / 97.0).collect();
    let model = model(100, &edges, 50, &entropy, 0.5, 4.0);
    for update in [Update::Full, Update::Sparse] {
        for product in [Product::Max, Product::Sum] {
            let with = |threads: usize| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| run(&model, options(product, 0.3, 1e-5), update, 8))
            };
            let one = with(1);
            for threads in [2, 5] {
                assert_eq!(one, with(threads), "{update:?} {product:?} on {threads} threads");
            }
        }
    }
}

/// Four variables, all neighbors, two labels: equal labels cost 5, different ones nothing; all prefer label 0
/// slightly. Under flooding all variables switch to the other label in every iteration.
fn frustrated() -> MrfModel {
    let edges = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    let mut model = model(4, &edges, 2, &[0.5], 5.0, 5.0);
    model.labels = homolog_primitives::graph::LabelNeighborhoods::new(
        &homolog_primitives::graph::EdgeGraph::from_edges(2, &[[0, 1]]),
        1,
        |x, y| {
            if x == y { 0.0 } else { 1.0 }
        },
    );
    model.lengths.fill(1.0);
    model.unary = [0.0, 0.1].repeat(4);
    model
}

#[test]
fn a_frustrated_model_oscillates_under_flooding_and_is_reported_so() {
    let (outcome, _) = run(&frustrated(), options(Product::Max, 0.0, 1e-5), Update::Sparse, 40);
    assert_eq!(outcome.stop, BpStop::MaxIterations);
    assert_eq!(outcome.convergence.status, ConvergenceStatus::Oscillating { period: 2 });
    let rate = outcome.convergence.residual_rate.unwrap();
    assert!((rate - 1.0).abs() < 0.01, "{rate}");
}

#[test]
fn a_run_that_settles_has_a_rate_below_one() {
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 37 % 97) / 97.0).collect();
    let model = model(6, &tree(&[0, 0, 1, 1, 2]), 5, &entropy, 0.5, 2.5);
    let settings = BpOptions { tolerance: 1e-5, ..options(Product::Sum, 0.3, 1e-5) };
    let (outcome, _) = run(&model, settings, Update::Sparse, 100);
    assert_eq!(outcome.convergence.status, ConvergenceStatus::Converged);
    assert!(outcome.convergence.residual_rate.unwrap() < 0.9);
    let (cut, _) = run(&model, settings, Update::Sparse, 3);
    assert_eq!(cut.convergence.status, ConvergenceStatus::Slow);
}

#[test]
fn beliefs_sum_to_one_and_their_peak_is_the_label_with_its_confidence() {
    let edges: Vec<[u32; 2]> = (1..=20).map(|k| [0, k]).chain((1..15).map(|k| [k, k + 1])).collect();
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 31 % 97) / 97.0).collect();
    // Variable 21 has no neighbors.
    let model = model(22, &edges, 17, &entropy, 0.5, 1.0);
    let places: Vec<Point3<f64>> = (0..17).map(|x| Point3::new(f64::from(x), 0.0, 0.0)).collect();
    for update in [Update::Sparse, Update::Full] {
        for product in [Product::Max, Product::Sum] {
            let mut bp = BeliefPropagation::with_update(&model, options(product, 0.5, 1e-5), update);
            let outcome = bp.run(12, &Silent, |_| ()).unwrap();
            let spreads = bp.spreads(&places, &Silent).unwrap();
            for i in 0..22 {
                let belief = bp.belief(i);
                assert!((belief.iter().sum::<f32>() - 1.0).abs() < 1e-5);
                let peak = f64::from(belief[outcome.labeling[i] as usize]);
                assert!((peak - outcome.confidence[i]).abs() < 1e-5, "{update:?} {product:?} variable {i}");
                assert!(belief.iter().all(|&b| f64::from(b) <= peak + 1e-6));
                assert_eq!(spreads[i], belief_spread(&belief, &places));
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The thesis' constraint: neighbors stay neighbors at any cost.
    #[test]
    fn on_a_chain_with_the_hard_constraint_every_update_finds_the_minimum(
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..2.0],
        update in any_update(),
    ) {
        let model = model(5, &[[0, 1], [1, 2], [2, 3], [3, 4]], 6, &entropy, beta, f64::INFINITY);
        let lowest = exhaustive_minimum(&model);
        let (outcome, beliefs) = run(&model, options(Product::Max, 0.0, 1e-30), update, 30);
        prop_assert!((outcome.energy.total() - lowest).abs() < 1e-4, "{} against {lowest}", outcome.energy.total());
        prop_assert_eq!(model.broken_edges(&outcome.labeling), 0);
        prop_assert!(beliefs.iter().flatten().all(|b| b.is_finite()));
        let (_, beliefs) = run(&model, options(Product::Sum, 0.0, 1e-30), update, 30);
        for (belief, marginal) in beliefs.iter().zip(exhaustive_marginals(&model)) {
            for (b, exact) in belief.iter().zip(marginal) {
                prop_assert!((f64::from(*b) - exact).abs() < 1e-5, "{b} against {exact}");
            }
        }
    }
}

#[test]
fn broken_edges_are_those_whose_labels_are_no_neighbors() {
    let model = model(4, &[[0, 1], [1, 2], [2, 3], [0, 3]], 4, &[0.3, 0.8], 0.0, f64::INFINITY);
    assert_eq!(model.broken_edges(&[0, 0, 1, 1]), 0);
    assert!(model.energy(&[0, 0, 1, 1]).total().is_finite());
    assert_eq!(model.broken_edges(&[0, 2, 2, 1]), 1);
    assert_eq!(model.broken_edges(&[0, 3, 0, 3]), 4);
    assert_eq!(model.energy(&[0, 3, 0, 3]).total(), f64::INFINITY);
}

proptest! {
    /// For any memory layout of the labels. Variables of 0 to 3 neighbors; every number is 0 or 1, or next to 0.
    #[test]
    fn of_equal_beliefs_that_of_the_lowest_label_wins(
        good in prop::collection::btree_set(0usize..40, 1..20),
        update in any_update(),
    ) {
        let mut model = model(5, &[[0, 1], [0, 2], [0, 3]], 40, &[0.5], 0.0, 9.2);
        for (at, unary) in model.unary.iter_mut().enumerate() {
            *unary = if good.contains(&(at % 40)) { 0.0 } else { 7.0 };
        }
        let (outcome, _) = run(&model, options(Product::Max, 0.0, 1e-5), update, 4);
        let lowest = *good.first().unwrap() as u32;
        prop_assert_eq!(outcome.labeling, vec![lowest; 5]);
    }
}
