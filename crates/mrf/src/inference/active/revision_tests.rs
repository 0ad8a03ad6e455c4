//! Revised sets: messages of added labels, labels restored by neighbors, and equal bits on any number of threads.

use super::super::tests::{model_with_rings, path_with_chords};
use super::super::{BeliefPropagation, Product};
use super::tests::{any_product, beliefs, entropy, options, some_candidates};
use super::*;
use crate::MrfModel;
use homolog_primitives::observe::{Observer, Silent};
use proptest::prelude::*;
use std::collections::BTreeSet;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Without damping, so that a recomputed message equals that of one more iteration over the new sets from the same
    /// beliefs.
    #[test]
    fn an_added_label_gets_the_message_that_it_missed(
        n in 3usize..14,
        chords in prop::collection::btree_set((0u32..14, 0u32..14), 0..40),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        product in any_product(),
    ) {
        let model = model_with_rings(n, &path_with_chords(n, &chords), 31, &entropy, 2, beta, 3.0);
        let candidates = some_candidates(&model, &entropy);
        let mut active =
            ActivePropagation::new(ActiveModel::of(&model, candidates.clone()).unwrap(), options(product, 0.0, 1e-5));
        active.run(3, &Silent, |_| ()).unwrap();
        // Labels are added to one variable; its neighbors' sets do not change, nor do the messages that they would
        // send.
        let at = n / 2;
        let mut rows: Vec<Vec<u32>> = (0..n).map(|i| candidates.labels(i).to_vec()).collect();
        rows[at] = (0..31).collect();
        let before: Vec<Vec<f32>> = active.incoming(at).iter().map(|m| m[..rows_len(&candidates, at)].to_vec()).collect();
        let reference = slow_next(&active, at);
        prop_assert!(active.adopt(rows, UnaryInput::plain(&model), &Silent).unwrap());
        for ((message, before), reference) in active.incoming(at).iter().zip(&before).zip(&reference) {
            // Previous values are kept up to a factor, because the maximum may be at an added label.
            let known = candidates.labels(at).iter().map(|&x| message[x as usize]);
            let ratios: Vec<f32> = known.zip(before).map(|(a, b)| a / b).collect();
            prop_assert!(ratios.iter().all(|r| (r - ratios[0]).abs() < 1e-4 * ratios[0]));
            for (x, exact) in reference.iter().enumerate() {
                if candidates.labels(at).binary_search(&(x as u32)).is_err() {
                    let found = f64::from(message[x] / ratios[0]);
                    prop_assert!((found - exact.max(1e-5)).abs() < 1e-4 * exact.max(0.1), "{} against {}", found, exact);
                }
            }
        }
    }
}

fn rows_len(candidates: &Candidates, variable: usize) -> usize {
    candidates.labels(variable).len()
}

/// The messages to `variable` over all labels, from the present ones, in 64 bits; scaled by their largest value at its
/// present candidates.
fn slow_next(active: &ActivePropagation<'_>, variable: usize) -> Vec<Vec<f64>> {
    let model = &active.model;
    let graph = model.variables;
    let value = |edge: usize, y: usize| {
        let (i, terms) = (graph.head(edge), model.candidates.labels(graph.head(edge)).iter().enumerate());
        let terms = terms.map(|(at, &x)| {
            let others = graph.row(i).filter(|&e| graph.head(e) != variable);
            let incoming =
                others.map(|e| f64::from(active.messages[active.layout.message(active.reverse[e] as usize)][at]));
            let distance = model.labels.distance_within(x as usize, y).map(f64::from);
            let theta = f64::from(model.candidates.unary(i)[at])
                + model.pairwise.potential(model.lengths[edge].into(), distance);
            (-theta).exp() * incoming.product::<f64>()
        });
        match active.options.product {
            Product::Max => terms.fold(0.0, f64::max),
            Product::Sum => terms.sum(),
        }
    };
    graph
        .row(variable)
        .map(|edge| {
            let raw: Vec<f64> = (0..model.labels.n_labels()).map(|y| value(edge, y)).collect();
            let top = model.candidates.labels(variable).iter().map(|&x| raw[x as usize]).fold(0.0, f64::max);
            raw.iter().map(|value| value / top).collect()
        })
        .collect()
}

/// A strip of `n` pairs of vertices and its labels: the shape of a model of surfaces, in small.
fn strip(n: u32) -> MrfModel {
    let edges: Vec<[u32; 2]> = (0..n - 2).flat_map(|k| [[k, k + 1], [k, k + 2]]).collect();
    model_with_rings(n as usize, &edges, n as usize, &entropy(997), 2, 0.4, 5.0)
}

const SETS: ActiveSets = ActiveSets { initial: 12, kept: 10, largest: 30, margin: 6.0, every: 4, best_of_neighbors: 2 };

fn revising(model: &MrfModel, product: Product) -> (ActiveOutcome, Vec<Vec<f32>>) {
    let evidence = UnaryInput::plain(model);
    let candidates = SETS.propose(model.n_variables(), model.n_labels(), evidence, &Silent).unwrap();
    let mut active = ActivePropagation::new(ActiveModel::of(model, candidates).unwrap(), options(product, 0.5, 1e-5));
    let outcome = active.run_revising(20, &SETS, evidence, &Silent, |_| ()).unwrap();
    (outcome, beliefs(&active))
}

#[test]
fn one_thread_and_many_give_the_same_bits() {
    let model = strip(300);
    for product in [Product::Max, Product::Sum] {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| revising(&model, product))
        };
        let one = with(1);
        assert!(one.0.revisions > 2 && one.0.mean_active < 30.0 && one.0.pair_updates > 0);
        for threads in [2, 3, 7] {
            assert_eq!(one, with(threads), "{product:?} on {threads} threads");
        }
    }
}

#[test]
fn sets_that_are_revised_to_all_labels_end_at_the_dense_answer() {
    let model = strip(60);
    let sets = ActiveSets { initial: 60, kept: 60, largest: 60, margin: f32::INFINITY, every: 3, best_of_neighbors: 1 };
    let evidence = UnaryInput::plain(&model);
    let candidates = sets.propose(60, 60, evidence, &Silent).unwrap();
    let options = options(Product::Max, 0.5, 1e-5);
    let mut active = ActivePropagation::new(ActiveModel::of(&model, candidates).unwrap(), options);
    let found = active.run_revising(20, &sets, evidence, &Silent, |_| ()).unwrap();
    let dense = BeliefPropagation::new(&model, options).run(20, &Silent, |_| ()).unwrap();
    assert_eq!(found.mean_active, 60.0);
    assert_eq!((found.propagation.labeling, found.propagation.energy), (dense.labeling, dense.energy));
}

/// A chain that maps to itself, but one variable begins without the label that its neighbors agree on.
#[test]
fn neighbors_bring_back_a_label_that_was_left_out() {
    let n = 20usize;
    let edges: Vec<[u32; 2]> = (0..n as u32 - 1).map(|k| [k, k + 1]).collect();
    let mut model = model_with_rings(n, &edges, n, &[0.5], 1, 0.0, 4.0);
    for i in 0..n {
        for x in 0..n {
            model.unary[i * n + x] = if x == i { 0.0 } else { 3.0 };
        }
    }
    model.unary[10 * n + 10] = 2.0;
    model.unary[10 * n + 3] = 0.0;
    let rows = (0..n).map(|i| {
        let labels = if i == 10 { vec![3, 4, 5] } else { vec![i as u32, (i as u32 + 7) % n as u32] };
        let labels: Vec<u32> = labels.into_iter().collect::<BTreeSet<_>>().into_iter().collect();
        let unary = labels.iter().map(|&x| model.unary_row(i)[x as usize]).collect();
        (labels, unary)
    });
    let active = ActiveModel::of(&model, Candidates::from_rows(rows)).unwrap();
    let mut active = ActivePropagation::new(active, options(Product::Max, 0.0, 1e-5));
    let sets = ActiveSets { initial: 3, kept: 3, largest: 8, margin: 5.0, every: 3, best_of_neighbors: 1 };
    let closed = active.run(10, &Silent, |_| ()).unwrap();
    assert_eq!(closed.labeling[10], 3);
    let open = active.run_revising(12, &sets, UnaryInput::plain(&model), &Silent, |_| ()).unwrap();
    assert_eq!(open.propagation.labeling, (0..n as u32).collect::<Vec<_>>());
    assert!(open.mean_active < 8.0 && active.model().candidates().n_candidates() <= 8 * n);
}

/// A bias as a table.
struct Table(Vec<f32>, usize);

impl UnaryPotentials for Table {
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        values.iter_mut().zip(labels).for_each(|(v, &x)| *v = self.0[variable * self.1 + x as usize]);
    }

    fn row(&self, variable: usize, row: &mut [f32]) {
        row.copy_from_slice(&self.0[variable * self.1..][..self.1]);
    }
}

#[test]
fn feedback_opens_the_sets_where_it_points_and_stays_out_of_the_energy() {
    let n = 60;
    let model = strip(n as u32);
    let bias = Table((0..n * n).map(|at: usize| 0.5 * (at / n).abs_diff(at % n) as f32).collect(), n);
    let evidence = UnaryInput { unary: &model, bias: Some(&bias) };
    let candidates = SETS.propose(n, n, UnaryInput::plain(&model), &Silent).unwrap();
    let mut active =
        ActivePropagation::new(ActiveModel::of(&model, candidates).unwrap(), options(Product::Max, 0.5, 1e-5));
    active.run(5, &Silent, |_| ()).unwrap();
    active.reopen(&SETS, evidence, &Silent).unwrap();
    assert!((0..n).all(|i| active.model().candidates().labels(i).contains(&(i as u32))));
    let found = active.run_revising(30, &SETS, evidence, &Silent, |_| ()).unwrap().propagation;
    assert_eq!(found.energy, model.energy(&found.labeling));
    let mut dense = BeliefPropagation::new(&model, options(Product::Max, 0.5, 1e-5));
    dense.set_bias(|i, row| row.iter_mut().zip(&bias.0[i * n..]).for_each(|(theta, b)| *theta += b));
    let expected = dense.run(30, &Silent, |_| ()).unwrap();
    let same = found.labeling.iter().zip(&expected.labeling).filter(|(a, b)| a == b).count();
    assert!(same >= 57, "{same} of {n}");
}

#[test]
fn a_cancelled_run_leaves_the_messages_as_they_were() {
    struct Stop;
    impl Observer for Stop {
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let model = strip(100);
    let candidates = SETS.propose(100, 100, UnaryInput::plain(&model), &Silent).unwrap();
    let mut active =
        ActivePropagation::new(ActiveModel::of(&model, candidates).unwrap(), options(Product::Max, 0.5, 1e-5));
    active.run(3, &Silent, |_| ()).unwrap();
    let before = (active.messages.clone(), active.model.clone());
    assert!(active.run(3, &Stop, |_| ()).is_err());
    assert!(active.revise(&SETS, UnaryInput::plain(&model), &Stop).is_err());
    assert_eq!(before, (active.messages.clone(), active.model.clone()));
    active.run(3, &Silent, |_| ()).unwrap();
}
