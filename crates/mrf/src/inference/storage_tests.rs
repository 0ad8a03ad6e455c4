//! Messages of 16 bits compared with messages of 32, and with the largest possible effect of rounding.

use super::oracle::{exhaustive_minimum, updated_message};
use super::tests::{model, model_with_rings, path_with_chords, tree};
use super::*;
use crate::MrfModel;
use homolog_primitives::observe::Silent;
use proptest::prelude::*;

const HALF: BpMethod = BpMethod { update: Update::Sparse, schedule: Schedule::Flooding, storage: MessageStorage::Half };

fn options(product: Product, damping: f32, floor: f32) -> BpOptions {
    BpOptions { product, damping, floor, tolerance: 0.0 }
}

fn run<'m>(
    model: &'m MrfModel,
    options: BpOptions,
    method: BpMethod,
    iterations: u32,
) -> (BpOutcome, BeliefPropagation<'m>) {
    let mut bp = BeliefPropagation::with_method(model, options, method);
    (bp.run(iterations, &Silent, |_| ()).unwrap(), bp)
}

/// Lowest energy of all labelings in which `variable` has `label`.
fn lowest_with(model: &MrfModel, variable: usize, label: u32) -> f64 {
    let mut bound = model.clone();
    for (x, theta) in bound.unary[variable * model.n_labels()..][..model.n_labels()].iter_mut().enumerate() {
        *theta += if x as u32 == label { 0.0 } else { 1e3 };
    }
    exhaustive_minimum(&bound)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// A belief on a tree is made of every message towards its variable once, each rounded once; both products are
    /// linear in each message, so nothing amplifies the rounding.
    #[test]
    fn on_trees_beliefs_are_off_by_one_rounding_a_message(
        parents in prop::collection::vec(0usize..100, 4),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        sum in any::<bool>(),
        // Messages are not below exp(−T): in the range of full precision, and below.
        (truncation, rounding) in prop_oneof![Just((2.5f64, 2f64.powi(-11))), Just((11.0, 2f64.powi(-25) / (-11f64).exp()))],
    ) {
        let model = model(5, &tree(&parents), 5, &entropy, beta, truncation);
        let options = options(if sum { Product::Sum } else { Product::Max }, 0.0, 1e-9);
        let (_, single) = run(&model, options, BpMethod::default(), 12);
        let (outcome, half) = run(&model, options, HALF, 12);
        let off = ((1.0 + rounding) / (1.0 - rounding)).powi(4) * (1.0 + 1e-5);
        for i in 0..5 {
            for (a, b) in single.belief(i).into_iter().zip(half.belief(i)) {
                prop_assert!(b <= a * off as f32 && a <= b * off as f32, "{a} became {b}");
            }
            if !sum {
                let chosen = lowest_with(&model, i, outcome.labeling[i]);
                let lowest = exhaustive_minimum(&model);
                prop_assert!(chosen <= lowest + off.ln() + 1e-4, "variable {i}: {chosen} against {lowest}");
            }
        }
    }

    #[test]
    fn messages_that_no_longer_change_are_their_own_update_to_one_rounding(
        n in 3usize..10,
        chords in prop::collection::btree_set((0u32..10, 0u32..10), 0..8),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..2.0],
        sum in any::<bool>(),
        full in any::<bool>(),
        damping in prop_oneof![Just(0.0f32), Just(0.5)],
    ) {
        let model = model(n, &path_with_chords(n, &chords), 9, &entropy, beta, 0.5);
        let product = if sum { Product::Sum } else { Product::Max };
        let method = BpMethod { update: if full { Update::Full } else { Update::Sparse }, ..HALF };
        let (outcome, bp) = run(&model, options(product, damping, 1e-5), method, 400);
        prop_assume!(outcome.stop == BpStop::Converged);
        let reverse = model.variables.reverse_edges();
        let message = |edge: &u32| bp.incoming_message(*edge as usize).iter().map(|&m| f64::from(m)).collect();
        let messages: Vec<Vec<f64>> = reverse.iter().map(message).collect();
        // Half a step between numbers of 16 bits below 1; damping passes on only a share of it.
        let off = 2f64.powi(-12) / (1.0 - f64::from(damping)) + 1e-6;
        for (edge, message) in messages.iter().enumerate() {
            for (m, exact) in message.iter().zip(updated_message(&model, product, &messages, edge, 1e-5)) {
                prop_assert!((m - exact).abs() < off, "{m} against {exact}");
            }
        }
    }
}

#[test]
fn sixteen_bits_give_the_same_bits_on_any_number_of_threads() {
    let edges: Vec<[u32; 2]> = (0..199).map(|k| [k, k + 1]).chain((0..150).map(|k| [k, k + 50])).collect();
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 31 % 97) / 97.0).collect();
    let model = model(200, &edges, 90, &entropy, 0.5, 4.0);
    for product in [Product::Max, Product::Sum] {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| run(&model, options(product, 0.5, 1e-5), HALF, 10).0)
        };
        let one = with(1);
        for threads in [2, 5] {
            assert_eq!(one, with(threads), "{product:?} on {threads} threads");
        }
    }
}

/// Several chunks of labels, the last one partly filled, a hub, quads of lanes that a block leaves empty.
#[test]
fn beliefs_of_few_iterations_are_close_on_any_graph() {
    let edges: Vec<[u32; 2]> = (1..=31).map(|k| [0, k]).chain((1..29).map(|k| [k, k + 3])).chain([[1, 2]]).collect();
    let entropy: Vec<f64> = (0..997).map(|k| f64::from(k * 571 % 997) / 997.0).collect();
    for (product, beta, rings) in [(Product::Max, 0.0, 3), (Product::Max, 0.7, 2), (Product::Sum, 0.0, 2)] {
        let model = model_with_rings(32, &edges, 275, &entropy, rings, beta, 1.0);
        let (_, single) = run(&model, options(product, 0.3, 1e-5), BpMethod::default(), 3);
        let (_, half) = run(&model, options(product, 0.3, 1e-5), HALF, 3);
        for i in 0..32 {
            let (a, b) = (single.belief(i), half.belief(i));
            let highest = a.iter().copied().fold(0.0, f32::max);
            for (a, b) in a.iter().zip(&b) {
                assert!((a - b).abs() < 0.02 * highest, "{product:?} variable {i}: {a} became {b}");
            }
        }
    }
}

/// The floor is raised to the smallest positive number of 16 bits: no neighbor alone rules a label out.
#[test]
fn a_message_of_sixteen_bits_is_never_zero() {
    let mut model = model(4, &[[0, 1], [1, 2], [2, 3]], 30, &[0.1, 0.7, 0.3, 0.9], 0.0, f64::INFINITY);
    for (at, theta) in model.unary.iter_mut().enumerate() {
        *theta = 2.0 * (at % 30).abs_diff(3 * (at / 30)) as f32;
    }
    let least = |method| {
        let (_, bp) = run(&model, options(Product::Max, 0.0, 0.0), method, 10);
        let edges = 0..model.variables.n_directed_edges();
        edges.flat_map(|edge| bp.incoming_message(edge)).fold(1.0, f32::min)
    };
    let (single, half) = (least(BpMethod::default()), least(HALF));
    assert!(single < 1e-12, "{single}");
    assert_eq!(half, 2f32.powi(-24));
}

/// The bounds of the residual schedule on pending changes are finer than steps between numbers of 16 bits.
#[test]
fn the_residual_schedule_keeps_32_bits() {
    let edges: Vec<[u32; 2]> = (0..19).map(|k| [k, k + 1]).chain((0..15).map(|k| [k, k + 5])).collect();
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 31 % 97) / 97.0).collect();
    let model = model(20, &edges, 12, &entropy, 0.5, 4.0);
    let residual = |storage| BpMethod { schedule: Schedule::Residual, storage, ..HALF };
    let settings = options(Product::Max, 0.5, 1e-5);
    assert_eq!(
        run(&model, settings, residual(MessageStorage::Half), 5).0,
        run(&model, settings, residual(MessageStorage::Single), 5).0
    );
}
