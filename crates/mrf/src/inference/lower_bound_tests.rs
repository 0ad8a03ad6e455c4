//! The lower bound against the exhaustive minimum: never above it, never falling, tight on trees.

use super::oracle::exhaustive_minimum;
use super::tests::{model_with_rings, path_with_chords, tree};
use super::*;
use crate::MrfModel;
use homolog_primitives::observe::{Cancelled, Observer, Silent};
use proptest::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering};

/// Runs to the end of the budget, without stopping earlier.
const TO_THE_END: DualOptions = DualOptions { gap_tolerance: -1.0, progress_tolerance: -1.0 };

fn iterate(model: &MrfModel, iterations: u32) -> (DualOutcome, Vec<DualIteration>) {
    let mut trace = Vec::new();
    let outcome = DualBound::new(model, TO_THE_END).run(iterations, &Silent, |i, _| trace.push(*i)).unwrap();
    (outcome, trace)
}

fn any_beta() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.0f64..3.0]
}

fn any_truncation() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.05f64..0.5, 1.0f64..4.0, 30.0f64..60.0, Just(1e12), Just(f64::INFINITY)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn the_bound_is_never_above_the_minimum_and_never_falls(
        n in 2usize..6,
        chords in prop::collection::btree_set((0u32..6, 0u32..6), 0..10),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        shift in prop_oneof![Just(0.0f32), -5.0f32..5.0],
        n_labels in 2usize..7,
        rings in 1usize..3,
        beta in any_beta(),
        truncation in any_truncation(),
    ) {
        let mut model =
            model_with_rings(n, &path_with_chords(n, &chords), n_labels, &entropy, rings, beta, truncation);
        model.unary.iter_mut().for_each(|theta| *theta += shift);
        let lowest = exhaustive_minimum(&model);
        let (outcome, trace) = iterate(&model, 12);
        let mut before = DualBound::new(&model, TO_THE_END).bound();
        prop_assert!(before <= lowest);
        for iteration in &trace {
            prop_assert!(iteration.bound <= lowest, "{} above {lowest}", iteration.bound);
            prop_assert!(iteration.bound >= before);
            prop_assert!(iteration.energy.total() >= lowest - 1e-9);
            before = iteration.bound;
        }
        prop_assert_eq!(outcome.bound, before);
        prop_assert_eq!(outcome.energy, model.energy(&outcome.labeling));
        prop_assert!(outcome.energy.total() <= model.energy(&model.unary_minimum()).total());
    }

    #[test]
    fn on_trees_the_bound_is_the_minimum_and_the_labeling_has_it(
        parents in prop::collection::vec(0usize..100, 5),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        rings in 1usize..3,
        beta in any_beta(),
        truncation in any_truncation(),
    ) {
        let model = model_with_rings(6, &tree(&parents), 5, &entropy, rings, beta, truncation);
        let lowest = exhaustive_minimum(&model);
        let (outcome, _) = iterate(&model, 100);
        prop_assert!(outcome.bound <= lowest);
        prop_assert!(lowest - outcome.bound <= 1e-6 * lowest.max(1.0), "{} against {lowest}", outcome.bound);
        prop_assert!(outcome.energy.total() - lowest <= 1e-6 * lowest.max(1.0));
    }
}

/// A grid of 12 × 12 variables with 30 labels, by no means a tree.
fn grid_model(beta: f64) -> MrfModel {
    let at = |x: u32, y: u32| 12 * y + x;
    let mut edges = Vec::new();
    for y in 0..12 {
        for x in 0..12 {
            edges.extend((x < 11).then(|| [at(x, y), at(x + 1, y)]));
            edges.extend((y < 11).then(|| [at(x, y), at(x, y + 1)]));
        }
    }
    let entropy: Vec<f64> = (0..9973).map(|k| f64::from(k * 3571 % 9973) / 9973.0).collect();
    model_with_rings(144, &edges, 30, &entropy, 2, beta, 3.0)
}

#[test]
fn the_gap_shrinks_on_a_graph_full_of_cycles() {
    for beta in [0.0, 0.4] {
        let model = grid_model(beta);
        let (outcome, trace) = iterate(&model, 30);
        let trivial = DualBound::new(&model, TO_THE_END).bound();
        let first_gap = model.energy(&model.unary_minimum()).total() - trivial;
        let gap = |i: &DualIteration| i.energy.total() - i.bound;
        assert!(trace.windows(2).all(|w| gap(&w[1]) <= gap(&w[0])));
        assert!(gap(&trace[29]) < 0.1 * first_gap, "{} of {first_gap} at beta {beta}", gap(&trace[29]));
        let bp = BpOptions { product: Product::Max, damping: 0.5, floor: 1e-5, tolerance: 0.0 };
        let found = BeliefPropagation::new(&model, bp).run(60, &Silent, |_| ()).unwrap();
        assert!(found.energy.total() >= outcome.bound);
    }
}

#[test]
fn a_run_ends_when_bound_and_labeling_meet_or_nothing_moves() {
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 37 % 97) / 97.0).collect();
    let model = model_with_rings(6, &tree(&[0, 0, 1, 1, 2]), 5, &entropy, 1, 0.7, 2.5);
    let options = DualOptions { gap_tolerance: 1e-5, progress_tolerance: 0.0 };
    let outcome = DualBound::new(&model, options).run(200, &Silent, |_, _| ()).unwrap();
    assert_eq!(outcome.stop, DualStop::Optimal);
    let options = DualOptions { gap_tolerance: -1.0, progress_tolerance: 1e-9 };
    let outcome = DualBound::new(&grid_model(0.4), options).run(2000, &Silent, |_, _| ()).unwrap();
    assert_eq!(outcome.stop, DualStop::Stalled);
    let outcome = DualBound::new(&model, TO_THE_END).run(2, &Silent, |_, _| ()).unwrap();
    assert_eq!((outcome.stop, outcome.iterations), (DualStop::MaxIterations, 2));
}

#[test]
fn two_runs_one_after_the_other_are_one_run() {
    let model = grid_model(0.4);
    let mut bound = DualBound::new(&model, TO_THE_END);
    bound.run(4, &Silent, |_, _| ()).unwrap();
    let second = bound.run(3, &Silent, |_, _| ()).unwrap();
    let (whole, _) = iterate(&model, 7);
    assert_eq!((second.bound, second.labeling), (whole.bound, whole.labeling));
}

#[test]
fn one_thread_and_many_give_the_same_bound() {
    let model = grid_model(0.4);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| iterate(&model, 5))
    };
    let one = with(1);
    for threads in [2, 3, 7] {
        assert_eq!(one, with(threads));
    }
}

#[test]
fn a_cancelled_run_leaves_a_bound_that_holds_and_may_start_again() {
    struct StopAfter(AtomicU32);
    impl Observer for StopAfter {
        fn is_cancelled(&self) -> bool {
            self.0.fetch_add(1, Ordering::Relaxed) >= 100
        }
    }
    let entropy: Vec<f64> = (0..97).map(|k| f64::from(k * 37 % 97) / 97.0).collect();
    let edges = [[0, 1], [1, 2], [2, 3], [0, 3], [0, 2]];
    let model = model_with_rings(4, &edges, 6, &entropy, 1, 0.7, 2.5);
    let lowest = exhaustive_minimum(&model);
    let mut bound = DualBound::new(&model, TO_THE_END);
    assert_eq!(bound.run(1000, &StopAfter(AtomicU32::new(0)), |_, _| ()), Err(Cancelled));
    let held = bound.bound();
    assert!(held <= lowest);
    let outcome = bound.run(50, &Silent, |_, _| ()).unwrap();
    assert!(held <= outcome.bound && outcome.bound <= lowest);
}
