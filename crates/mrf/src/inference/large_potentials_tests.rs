//! Potentials of any size: nothing panics, every number is finite, and small models are still minimized.
//!
//! `exp(−θ)` underflows single precision from `θ = 104` on, while callers allow unary potentials of a million and more.

use super::oracle::{exhaustive_marginals, exhaustive_minimum};
use super::tests::{model_with_rings, path_with_chords, tree};
use super::*;
use crate::MrfModel;
use homolog_primitives::observe::Silent;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

/// Unary potentials of a row: the smallest, and how far the others lie above it.
fn any_row(n_labels: usize) -> impl Strategy<Value = Vec<f32>> {
    let lowest = prop_oneof![Just(0.0f32), 0.0f32..40.0, 80.0f32..110.0, 110.0f32..1e3, 1e3f32..1e6];
    let above = prop_oneof![2 => 0.0f32..2.0, 1 => 0.0f32..200.0, 1 => 0.0f32..1e6];
    (lowest, prop::collection::vec(above, n_labels)).prop_map(|(lowest, mut row)| {
        let least = row.iter().copied().fold(f32::INFINITY, f32::min);
        row.iter_mut().for_each(|theta| *theta = lowest + (*theta - least));
        row
    })
}

fn any_rows(n: usize, n_labels: usize) -> impl Strategy<Value = Vec<f32>> {
    prop::collection::vec(any_row(n_labels), n).prop_map(|rows| rows.concat())
}

fn any_model() -> impl Strategy<Value = MrfModel> {
    let chords = prop::collection::btree_set((0u32..12, 0u32..12), 0..20);
    let truncation = prop_oneof![Just(0.5f64), Just(9.2), Just(60.0), Just(f64::INFINITY)];
    let beta = prop_oneof![Just(0.0), 0.0f64..3.0];
    (1usize..12, 1usize..30).prop_flat_map(move |(n, n_labels)| {
        let parts =
            (chords.clone(), prop::collection::vec(0.0f64..1.0, 97), truncation.clone(), beta.clone(), 1usize..3);
        (parts, any_rows(n, n_labels)).prop_map(move |((chords, entropy, truncation, beta, rings), unary)| {
            let edges = path_with_chords(n, &chords);
            MrfModel { unary, ..model_with_rings(n, &edges, n_labels, &entropy, rings, beta, truncation) }
        })
    })
}

const UPDATES: [Update; 2] = [Update::Sparse, Update::Full];

/// Properties of every run over `model`.
fn check_outcome(model: &MrfModel, outcome: &BpOutcome) -> Result<(), TestCaseError> {
    check_labeling(model, &outcome.labeling, outcome.energy)?;
    prop_assert!(outcome.confidence.iter().all(|c| (0.0..=1.0 + 1e-6).contains(c)), "{:?}", outcome.confidence);
    Ok(())
}

fn check_labeling(model: &MrfModel, labeling: &[u32], energy: crate::Energy) -> Result<(), TestCaseError> {
    prop_assert_eq!(labeling.len(), model.n_variables());
    prop_assert!(labeling.iter().all(|&x| (x as usize) < model.n_labels()), "{labeling:?}");
    prop_assert_eq!(energy, model.energy(labeling));
    prop_assert!(energy.unary.is_finite() && !energy.pairwise.is_nan());
    Ok(())
}

fn check_beliefs(beliefs: impl Iterator<Item = Vec<f32>>) -> Result<(), TestCaseError> {
    for belief in beliefs {
        let sum: f32 = belief.iter().sum();
        prop_assert!(belief.iter().all(|b| (0.0..=1.0 + 1e-6).contains(b)), "{belief:?}");
        prop_assert!((sum - 1.0).abs() < 1e-4 || sum == 0.0, "{belief:?}");
    }
    Ok(())
}

fn any_options() -> impl Strategy<Value = BpOptions> {
    let floor = prop_oneof![Just(1e-5f32), Just(1e-30), Just(0.0)];
    (any::<bool>(), prop_oneof![Just(0.0f32), Just(0.5)], floor).prop_map(|(sum, damping, floor)| BpOptions {
        product: if sum { Product::Sum } else { Product::Max },
        damping,
        floor,
        tolerance: 1e-4,
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn belief_propagation_stays_finite_by_every_method(
        model in any_model(),
        options in any_options(),
        bias in 0.0f32..1e6,
        clamped: bool,
    ) {
        for update in UPDATES {
            let mut bp = BeliefPropagation::with_update(&model, options, update);
            check_outcome(&model, &bp.run(6, &Silent, |_| ()).unwrap())?;
            // Feedback as callers add it: a term on every label, or a variable fixed to one.
            bp.set_bias(|i, row| match clamped && i % 2 == 0 {
                true => {
                    row.fill(model.pairwise.truncation as f32);
                    row[i % model.n_labels()] = 0.0;
                }
                false => row.iter_mut().enumerate().for_each(|(x, theta)| *theta += bias * (x % 3) as f32),
            });
            check_outcome(&model, &bp.run(6, &Silent, |_| ()).unwrap())?;
            check_beliefs((0..model.n_variables()).map(|i| bp.belief(i)))?;
            for edge in 0..model.variables.n_directed_edges() {
                let message = bp.incoming_message(edge);
                prop_assert!(message.iter().all(|m| (0.0..=1.0 + 1e-5).contains(m)), "{update:?}: {message:?}");
            }
        }
    }

    #[test]
    fn active_labels_stay_finite_and_their_sets_hold_labels(model in any_model(), options in any_options()) {
        let evidence = UnaryInput::plain(&model);
        let sets = ActiveSets { initial: 5, kept: 4, largest: 9, margin: 20.0, every: 2, best_of_neighbors: 2 };
        let candidates = sets.propose(model.n_variables(), model.n_labels(), evidence, &Silent).unwrap();
        let mut active = ActivePropagation::new(ActiveModel::of(&model, candidates).unwrap(), options);
        let found = active.run_revising(8, &sets, evidence, &Silent, |_| ()).unwrap();
        check_outcome(&model, &found.propagation)?;
        check_beliefs((0..model.n_variables()).map(|i| active.belief(i)))?;
        let mut all = ActivePropagation::new(ActiveModel::of(&model, Candidates::all(&model)).unwrap(), options);
        check_outcome(&model, &all.run(8, &Silent, |_| ()).unwrap())?;
        check_beliefs((0..model.n_variables()).map(|i| all.belief(i)))?;
    }

    #[test]
    fn the_other_minimizers_stay_finite(model in any_model(), seed: u64) {
        let run = SearchRun { sweeps: 8, seed, start: None, target_energy: None };
        let energy_of = |labeling: &[u32]| model.energy(labeling).total();
        for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
            let options = AnnealingOptions {
                sampler,
                schedule: Cooling::Geometric,
                initial_temperature: None,
                final_temperature: None,
                patience: 50,
            };
            let found = SimulatedAnnealing::new(&model, options).run(&run, &Silent, |_| ()).unwrap();
            check_labeling(&model, &found.labeling, found.energy)?;
            prop_assert!(found.confidence.iter().all(|c| (0.0..=1.0 + 1e-3).contains(c)), "{:?}", found.confidence);
        }
        let found = LasVegas::new(&model, LasVegasOptions { patience: 3 }).run(&run, &Silent, |_| ()).unwrap();
        check_labeling(&model, &found.labeling, found.energy)?;
        prop_assert!(found.confidence.iter().all(|c| (0.0..=1.0 + 1e-3).contains(c)), "{:?}", found.confidence);
        let options = DualOptions { gap_tolerance: 1e-6, progress_tolerance: 1e-9 };
        let found = DualBound::new(&model, options).run(20, &Silent, |_, _| ()).unwrap();
        check_labeling(&model, &found.labeling, found.energy)?;
        prop_assert!(found.bound.is_finite() && found.bound <= energy_of(&found.labeling));
    }

    /// On a tree max-product finds the minimum and sum-product the marginals, for any offset common to a row.
    #[test]
    fn trees_are_minimized_as_by_exhaustive_search(
        parents in prop::collection::vec(0usize..100, 3),
        entropy in prop::collection::vec(0.0f64..1.0, 97),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        // Three neighbors together do not reach 87, above which a label counts as impossible.
        truncation in prop_oneof![Just(8.0f64), Just(20.0)],
        unary in any_rows(4, 5),
    ) {
        let model = MrfModel { unary, ..model_with_rings(4, &tree(&parents), 5, &entropy, 1, beta, truncation) };
        let (minimum, gap) = unique_minimum(&model);
        prop_assume!(gap > 0.02);
        let mut options = BpOptions { product: Product::Max, damping: 0.0, floor: 1e-12, tolerance: 0.0 };
        for update in UPDATES {
            let found = BeliefPropagation::with_update(&model, options, update).run(20, &Silent, |_| ()).unwrap();
            prop_assert_eq!(&found.labeling, &minimum, "{:?}", update);
        }
        let active = ActiveModel::of(&model, Candidates::all(&model)).unwrap();
        prop_assert_eq!(ActivePropagation::new(active, options).run(20, &Silent, |_| ()).unwrap().labeling, minimum);
        options.product = Product::Sum;
        let marginals = exhaustive_marginals(&model);
        for update in UPDATES {
            let mut bp = BeliefPropagation::with_update(&model, options, update);
            bp.run(20, &Silent, |_| ()).unwrap();
            for (i, marginal) in marginals.iter().enumerate() {
                for (b, exact) in bp.belief(i).iter().zip(marginal) {
                    prop_assert!((f64::from(*b) - exact).abs() < 1e-4, "{update:?}: {b} against {exact}");
                }
            }
        }
    }
}

/// The labeling of lowest energy, and the gap to the next one.
fn unique_minimum(model: &MrfModel) -> (Vec<u32>, f64) {
    let mut best = (Vec::new(), f64::INFINITY);
    let mut next = f64::INFINITY;
    super::oracle::for_each_labeling(model, |labeling, energy| {
        if energy < best.1 {
            next = best.1;
            best = (labeling.to_vec(), energy);
        } else {
            next = next.min(energy);
        }
    });
    assert_eq!(best.1, exhaustive_minimum(model));
    (best.0, next - best.1)
}

/// A potential shared by all labels of a variable changes no answer, and no bit of it if the potential is small.
#[test]
fn a_row_far_above_zero_is_decoded_as_if_it_were_not() {
    let edges: Vec<[u32; 2]> = (0..29).map(|k| [k, k + 1]).chain((0..20).map(|k| [k, k + 10])).collect();
    let entropy: Vec<f64> = (0..997).map(|k| f64::from(k * 571 % 997) / 997.0).collect();
    let mut plain = model_with_rings(30, &edges, 40, &entropy, 2, 0.3, 9.2);
    // Multiples of 1/32, which stay exact where 4096 is added.
    plain.unary.iter_mut().for_each(|theta| *theta = (*theta * 32.0).round() / 32.0);
    let mut raised = plain.clone();
    raised.unary.iter_mut().for_each(|theta| *theta += 4096.0);
    for product in [Product::Max, Product::Sum] {
        let options = BpOptions { product, damping: 0.5, floor: 1e-5, tolerance: 0.0 };
        for update in UPDATES {
            let run = |model| BeliefPropagation::with_update(model, options, update).run(10, &Silent, |_| ()).unwrap();
            let (a, b) = (run(&plain), run(&raised));
            assert_eq!(a.labeling, b.labeling, "{product:?} {update:?}");
            assert!((b.energy.total() - a.energy.total() - 30.0 * 4096.0).abs() < 1e-6);
        }
    }
}

/// With 600 equally good labels, the sum of the cavity products is 600 times the largest of them.
#[test]
fn sums_over_many_labels_do_not_overflow() {
    let edges = [[0, 1], [1, 2], [2, 3]];
    let mut model = model_with_rings(4, &edges, 600, &[0.1, 0.7, 0.3], 1, 0.0, 3.0);
    model.unary.fill(0.0);
    for i in 0..4 {
        model.unary[600 * i + 7] = -1.0;
    }
    let options = BpOptions { product: Product::Sum, damping: 0.0, floor: 1e-9, tolerance: 0.0 };
    for update in [Update::Sparse, Update::Full] {
        let mut bp = BeliefPropagation::with_update(&model, options, update);
        // Information reaches a neighbor in one iteration: labels 6 and 8 are near 7, all others are not.
        bp.run(1, &Silent, |_| ()).unwrap();
        let message = bp.incoming_message(model.variables.row(0).start);
        let far = message[300];
        assert!(message[6] > 1.001 * far && message[8] > 1.001 * far, "{} {} {far}", message[6], message[8]);
    }
    let active = ActiveModel::of(&model, Candidates::all(&model)).unwrap();
    let mut active = ActivePropagation::new(active, options);
    active.run(1, &Silent, |_| ()).unwrap();
    let belief = active.belief(0);
    assert!(belief[6] > 1.001 * belief[300], "{} {}", belief[6], belief[300]);
}
