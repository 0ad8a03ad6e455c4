//! Active labels against the dense engine where all labels are active, against exhaustive search on trees, and against
//! a slow update over candidates otherwise.

use super::super::oracle::exhaustive_minimum;
use super::super::tests::{model, model_with_rings, path_with_chords, tree};
use super::super::{BeliefPropagation, BpOptions, Product};
use super::*;
use crate::{Feature, FeaturePotentials, MrfModel, unary_potentials};
use homolog_primitives::observe::Silent;
use proptest::prelude::*;

pub(super) fn options(product: Product, damping: f32, floor: f32) -> BpOptions {
    BpOptions { product, damping, floor, tolerance: 0.0 }
}

pub(super) fn any_product() -> impl Strategy<Value = Product> {
    prop_oneof![Just(Product::Max), Just(Product::Sum)]
}

pub(super) fn entropy(n: usize) -> Vec<f64> {
    (0..n).map(|k| (k * 571 % n) as f64 / n as f64).collect()
}

/// Some labels for every variable, from the numbers of `entropy`: about every third, and one at least.
pub(super) fn some_candidates(model: &MrfModel, entropy: &[f64]) -> Candidates {
    let n_labels = model.n_labels();
    let rows = (0..model.n_variables()).map(|i| {
        let chosen = |x: &usize| entropy[(i * 7 + x * 3) % entropy.len()] < 0.35 || *x == i % n_labels;
        let labels: Vec<u32> = (0..n_labels).filter(chosen).map(|x| x as u32).collect();
        let unary = labels.iter().map(|&x| model.unary_row(i)[x as usize]).collect();
        (labels, unary)
    });
    Candidates::from_rows(rows)
}

/// `model` with unary potentials so high outside `candidates` that no other label is ever taken.
fn forbidding(model: &MrfModel, candidates: &Candidates) -> MrfModel {
    let mut other = model.clone();
    let n_labels = model.n_labels();
    for (at, theta) in other.unary.iter_mut().enumerate() {
        if candidates.labels(at / n_labels).binary_search(&((at % n_labels) as u32)).is_err() {
            *theta = 1e3;
        }
    }
    other
}

/// Slow and obvious: beliefs over candidates, summing to 1, after `iterations` in 64 bits.
fn slow_beliefs(
    model: &MrfModel,
    candidates: &Candidates,
    product: Product,
    iterations: usize,
    damping: f64,
    floor: f64,
) -> Vec<Vec<f64>> {
    let graph = &model.variables;
    let reverse = graph.reverse_edges();
    let phi = |i: usize, x: u32| f64::from(-model.unary_row(i)[x as usize]).exp();
    let labels = |edge: usize| candidates.labels(graph.head(edge));
    let mut messages: Vec<Vec<f64>> = (0..graph.n_directed_edges()).map(|e| vec![1.0; labels(e).len()]).collect();
    for _ in 0..iterations {
        let updated = |edge: usize| -> Vec<f64> {
            let i = graph.head(reverse[edge] as usize);
            let h = |at: usize, x: u32| {
                let others = graph.row(i).filter(|&e| e != edge);
                phi(i, x) * others.map(|e| messages[reverse[e] as usize][at]).product::<f64>()
            };
            let value = |y: u32| {
                let terms = candidates.labels(i).iter().enumerate();
                let terms = terms.map(|(at, &x)| (-model.pairwise_potential(edge, x, y)).exp() * h(at, x));
                match product {
                    Product::Max => terms.fold(0.0, f64::max),
                    Product::Sum => terms.sum(),
                }
            };
            let raw: Vec<f64> = labels(edge).iter().map(|&y| value(y)).collect();
            let top = raw.iter().copied().fold(0.0, f64::max);
            let pairs = raw.iter().zip(&messages[edge]);
            pairs.map(|(new, old)| (1.0 - damping) * (new / top).max(floor) + damping * old).collect()
        };
        messages = (0..messages.len()).map(updated).collect();
    }
    (0..graph.n_vertices())
        .map(|i| {
            let value = |(at, &x): (usize, &u32)| {
                phi(i, x) * graph.row(i).map(|e| messages[reverse[e] as usize][at]).product::<f64>()
            };
            let belief: Vec<f64> = candidates.labels(i).iter().enumerate().map(value).collect();
            let sum: f64 = belief.iter().sum();
            belief.iter().map(|b| b / sum).collect()
        })
        .collect()
}

pub(super) fn beliefs(active: &ActivePropagation<'_>) -> Vec<Vec<f32>> {
    (0..active.model().n_variables()).map(|i| active.belief(i)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn with_all_labels_the_messages_are_those_of_the_dense_engine(
        n in 2usize..14,
        chords in prop::collection::btree_set((0u32..14, 0u32..14), 0..40),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        n_labels in 2usize..40,
        rings in 1usize..4,
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        truncation in prop_oneof![Just(0.0), 0.05f64..0.5, 1.0f64..4.0, Just(f64::INFINITY)],
        product in any_product(),
    ) {
        let model = model_with_rings(n, &path_with_chords(n, &chords), n_labels, &entropy, rings, beta, truncation);
        let options = options(product, 0.5, 1e-5);
        let mut dense = BeliefPropagation::new(&model, options);
        let mut steps = Vec::new();
        let expected = dense.run(5, &Silent, |step| steps.push(*step)).unwrap();
        let all = ActiveModel::of(&model, Candidates::all(&model)).unwrap();
        let mut active = ActivePropagation::new(all, options);
        let mut at = 0;
        let found = active.run(5, &Silent, |step| {
            let pair = (step.iteration, step.labels_changed, step.energy);
            assert_eq!(pair, (steps[at].iteration, steps[at].labels_changed, steps[at].energy));
            at += 1;
        }).unwrap();
        prop_assert_eq!((at, &found.labeling, found.energy), (steps.len(), &expected.labeling, expected.energy));
        prop_assert_eq!((found.stop, found.iterations), (expected.stop, expected.iterations));
        for edge in 0..model.variables.n_directed_edges() {
            let message = &active.messages[active.layout.message(active.reverse[edge] as usize)];
            match product {
                // Maxima do not depend on the order, so the bits are equal.
                Product::Max => prop_assert_eq!(&message[..n_labels], &dense.incoming_message(edge)[..]),
                Product::Sum => for (a, b) in message.iter().zip(dense.incoming_message(edge).iter()) {
                    prop_assert!((a - b).abs() < 1e-5, "{} against {}", a, b);
                },
            }
        }
    }

    #[test]
    fn beliefs_over_some_labels_equal_those_of_a_slow_update(
        n in 2usize..14,
        chords in prop::collection::btree_set((0u32..14, 0u32..14), 0..40),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        rings in 1usize..4,
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        damping in prop_oneof![Just(0.0f32), Just(0.5)],
        product in any_product(),
    ) {
        let model = model_with_rings(n, &path_with_chords(n, &chords), 31, &entropy, rings, beta, 3.0);
        let candidates = some_candidates(&model, &entropy);
        let expected = slow_beliefs(&model, &candidates, product, 4, damping.into(), 1e-5);
        let mut active = ActivePropagation::new(ActiveModel::of(&model, candidates).unwrap(), options(product, damping, 1e-5));
        let found = active.run(4, &Silent, |_| ()).unwrap();
        prop_assert_eq!(model.energy(&found.labeling), found.energy);
        for (i, (found_row, exact)) in beliefs(&active).iter().zip(&expected).enumerate() {
            for (a, b) in found_row.iter().zip(exact) {
                prop_assert!((f64::from(*a) - b).abs() < 1e-4, "{} against {} at variable {}", a, b, i);
            }
            let highest = exact.iter().copied().fold(0.0, f64::max);
            prop_assert!((found.confidence[i] - highest).abs() < 1e-4);
        }
    }

    #[test]
    fn max_product_finds_the_minimum_over_the_candidates_on_trees(
        parents in prop::collection::vec(0usize..100, 4),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
    ) {
        let model = model(5, &tree(&parents), 6, &entropy, beta, 2.5);
        let candidates = some_candidates(&model, &entropy);
        let lowest = exhaustive_minimum(&forbidding(&model, &candidates));
        let active = ActiveModel::of(&model, candidates).unwrap();
        let found = ActivePropagation::new(active, options(Product::Max, 0.0, 1e-9)).run(12, &Silent, |_| ()).unwrap();
        prop_assert!((found.energy.total() - lowest).abs() < 1e-4, "{} against {lowest}", found.energy.total());
    }

    #[test]
    fn potentials_of_features_follow_their_formula(
        values in prop::collection::vec(-3.0f64..3.0, 30),
        order in prop_oneof![Just(1.0), Just(2.0)],
    ) {
        let feature = |shift: usize| Feature {
            weight: 0.5 + shift as f64,
            source: values[shift..shift + 9].to_vec(),
            target: values[shift + 9..shift + 20].to_vec(),
        };
        let features = [feature(0), feature(5)];
        let table = unary_potentials(&features, 1.3, 0.7, order, &Silent).unwrap();
        let potentials = FeaturePotentials::new(&features, 1.3, 0.7, order);
        for (i, row) in table.chunks(11).enumerate() {
            for (x, &theta) in row.iter().enumerate() {
                let term = |f: &Feature| {
                    f.weight * ((f.source[i] - f.target[x]).abs() / f.robust_scale()).min(0.7).powf(order)
                };
                let exact = 1.3 * features.iter().map(term).sum::<f64>() / 2.0;
                prop_assert!((f64::from(theta) - exact).abs() < 1e-5 * (1.0 + exact), "{} against {}", theta, exact);
            }
            let mut few = vec![9.0; 3];
            potentials.at(i, &[1, 4, 10], &mut few);
            prop_assert_eq!(few, vec![row[1], row[4], row[10]]);
        }
    }
}

/// A wheel: its hub has more neighbors than fit side by side.
#[test]
fn variables_of_high_degree_equal_the_dense_engine() {
    let rim = 37u32;
    let edges: Vec<[u32; 2]> = (1..=rim).map(|k| [0, k]).chain((1..rim).map(|k| [k, k + 1])).collect();
    let model = model(rim as usize + 1, &edges, 18, &entropy(97), 0.7, 1.0);
    let options = options(Product::Max, 0.0, 1e-5);
    let dense = BeliefPropagation::new(&model, options).run(3, &Silent, |_| ()).unwrap();
    let all = ActiveModel::of(&model, Candidates::all(&model)).unwrap();
    let active = ActivePropagation::new(all, options).run(3, &Silent, |_| ()).unwrap();
    assert_eq!((dense.labeling, dense.energy), (active.labeling, active.energy));
}

#[test]
fn sets_that_do_not_fit_are_refused() {
    let refused = |offsets: Vec<usize>, labels: Vec<u32>| {
        let unary = vec![0.0; labels.len()];
        Candidates::new(offsets, labels, unary, 5).unwrap_err()
    };
    assert_eq!(refused(vec![0, 2, 2], vec![1, 3]), CandidateError::NoCandidate { variable: 1 });
    assert_eq!(refused(vec![0, 2], vec![3, 3]), CandidateError::NotAscending { variable: 0, n_labels: 5 });
    assert_eq!(refused(vec![0, 1], vec![5]), CandidateError::NotAscending { variable: 0, n_labels: 5 });
    assert!(matches!(refused(vec![0, 1], vec![1, 2]), CandidateError::LengthMismatch { .. }));
    assert!(matches!(refused(vec![], vec![]), CandidateError::LengthMismatch { .. }));
    let model = model(10, &tree(&[0; 9]), 10, &entropy(97), 0.0, 1.0);
    let few = Candidates::new(vec![0, 1], vec![1], vec![0.0], 10).unwrap();
    assert!(matches!(ActiveModel::of(&model, few), Err(CandidateError::LengthMismatch { .. })));
}
