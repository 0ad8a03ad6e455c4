//! Las Vegas: certified when the target is the minimum, honest when no labeling reaches it.

use super::tests::{CancelAfter, RING, large, model, on_threads, run_of};
use super::*;
use crate::MrfModel;
use crate::inference::oracle::exhaustive_minimum;
use homolog_primitives::observe::Silent;
use std::sync::atomic::AtomicU32;

const OPTIONS: LasVegasOptions = LasVegasOptions { patience: 10 };

fn search(model: &MrfModel, run: &SearchRun<'_>) -> SearchOutcome {
    LasVegas::new(model, OPTIONS).run(run, &Silent, |_| ()).unwrap()
}

#[test]
fn the_exhaustive_minimum_as_target_is_reached_and_certified() {
    for seed in 0..120 {
        let model = model(5, &RING, 5, seed, 0.1 * (seed % 20) as f64, 2.5);
        let lowest = exhaustive_minimum(&model);
        let outcome = search(&model, &SearchRun { target_energy: Some(lowest), ..run_of(20_000, seed) });
        assert_eq!((outcome.stop, outcome.certified), (SearchStop::TargetReached, true), "seed {seed}");
        assert_eq!(outcome.energy, model.energy(&outcome.labeling));
        assert!(outcome.energy.total() <= lowest);
    }
}

#[test]
fn the_budget_ends_for_a_target_below_the_minimum() {
    let model = model(5, &RING, 5, 3, 1.0, 2.5);
    let lowest = exhaustive_minimum(&model);
    let run = SearchRun { target_energy: Some(lowest - 1e-6), ..run_of(3000, 3) };
    let outcome = search(&model, &run);
    assert_eq!((outcome.stop, outcome.certified, outcome.sweeps), (SearchStop::Budget, false, 3000));
    assert!(outcome.restarts > 10);
    // The best of all descents is still there.
    assert!((outcome.energy.total() - lowest).abs() < 1e-9);
}

#[test]
fn without_a_target_the_best_of_all_descents_is_returned() {
    let model = large();
    let mut seen = Vec::new();
    let outcome = LasVegas::new(&model, OPTIONS).run(&run_of(400, 1), &Silent, |s| seen.push(*s)).unwrap();
    assert_eq!((outcome.stop, outcome.sweeps, outcome.certified), (SearchStop::Budget, 400, false));
    assert_eq!(seen.len(), 400);
    assert!(seen.iter().all(|s| s.temperature.is_none()));
    assert!(seen.windows(2).all(|w| w[1].best_energy.total() <= w[0].best_energy.total()));
    assert!((seen[399].best_energy.total() - outcome.energy.total()).abs() < 1e-9);
}

#[test]
fn a_start_that_reaches_the_target_is_the_answer() {
    let model = large();
    let start = model.unary_minimum();
    let target = model.energy(&start).total();
    let outcome = search(&model, &SearchRun { start: Some(&start), target_energy: Some(target), ..run_of(100, 1) });
    assert_eq!((outcome.sweeps, outcome.certified, outcome.labeling), (0, true, start));
}

#[test]
fn a_bias_guides_the_moves() {
    let model = model(5, &RING, 5, 6, 1.0, 2.5);
    let mut las_vegas = LasVegas::new(&model, OPTIONS);
    las_vegas.set_bias(|_, row| {
        row.fill(f32::INFINITY);
        row[1] = 0.0;
    });
    let outcome = las_vegas.run(&run_of(500, 1), &Silent, |_| ()).unwrap();
    assert_eq!(outcome.labeling, vec![1; 5]);
    assert_eq!(outcome.energy, model.energy(&[1; 5]));
}

#[test]
fn a_hard_constraint_is_met_where_it_can_be() {
    let model = model(5, &RING, 5, 8, 1.0, f64::INFINITY);
    let lowest = exhaustive_minimum(&model);
    let outcome = search(&model, &SearchRun { target_energy: Some(lowest), ..run_of(20_000, 1) });
    assert!(outcome.certified && outcome.energy.total() <= lowest);
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_number_of_threads() {
    let model = large();
    let with = |threads, seed| on_threads(threads, || search(&model, &run_of(60, seed)));
    let one = with(1, 7);
    for threads in [2, 3, 7] {
        assert_eq!(one, with(threads, 7), "on {threads} threads");
    }
    assert_ne!(one.labeling, with(2, 8).labeling);
}

#[test]
fn a_cancelled_run_ends_without_an_answer() {
    let observer = CancelAfter(AtomicU32::new(50));
    assert!(LasVegas::new(&large(), OPTIONS).run(&run_of(100_000, 1), &observer, |_| ()).is_err());
}
