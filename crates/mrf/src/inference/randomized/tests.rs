//! Randomized minimizers against their oracles: exhaustive minima and marginals, full evaluations of the energy.

use super::draws::{Draws, Purpose};
use super::energy::SearchEnergy;
use super::gibbs::{GibbsScratch, loosest_bound};
use super::state::{SearchState, SiteMove};
use super::sweeps::{SiteUpdate, Sweeps};
use super::*;
use crate::inference::oracle::{exhaustive_marginals, exhaustive_minimum};
use crate::{MrfModel, PairwisePotential};
use homolog_primitives::graph::{EdgeGraph, LabelNeighborhoods};
use homolog_primitives::observe::{Observer, Silent};
use proptest::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering};

/// A model over given edges: labels on a path with a chord, everything else drawn from `seed`.
pub(super) fn model(n: usize, edges: &[[u32; 2]], n_labels: usize, seed: u64, beta: f64, truncation: f64) -> MrfModel {
    let mut draws = Draws::new(seed, Purpose::Start, 0, 77);
    let mut label_edges: Vec<[u32; 2]> = (0..n_labels as u32 - 1).map(|x| [x, x + 1]).collect();
    if n_labels > 4 {
        label_edges.push([0, n_labels as u32 - 2]);
    }
    let place: Vec<f64> = (0..n_labels).map(|_| 3.0 * draws.unit()).collect();
    let labels =
        LabelNeighborhoods::new(&EdgeGraph::from_edges(n_labels, &label_edges), 1, |x, y| (place[x] - place[y]).abs());
    let variables = EdgeGraph::from_edges(n, edges);
    let reverse = variables.reverse_edges();
    let mut lengths = vec![0.0; variables.n_directed_edges()];
    for e in 0..lengths.len() {
        if lengths[e] == 0.0 {
            lengths[e] = (0.2 + 2.0 * draws.unit()) as f32;
            lengths[reverse[e] as usize] = lengths[e];
        }
    }
    let unary = (0..n * n_labels).map(|_| (2.0 * draws.unit()) as f32).collect();
    MrfModel { variables, lengths, labels, unary, pairwise: PairwisePotential { beta, length_scale: 1.0, truncation } }
}

/// A ring of five variables with a chord.
pub(super) const RING: [[u32; 2]; 6] = [[0, 1], [1, 2], [2, 3], [3, 4], [0, 4], [1, 3]];

/// 400 variables and 90 labels: classes are long enough to be split over threads.
pub(super) fn large() -> MrfModel {
    let edges: Vec<[u32; 2]> = (0..399).map(|k| [k, k + 1]).chain((0..350).map(|k| [k, k + 50])).collect();
    model(400, &edges, 90, 5, 0.5, 4.0)
}

fn options(sampler: Sampler, schedule: Cooling) -> AnnealingOptions {
    AnnealingOptions { sampler, schedule, initial_temperature: None, final_temperature: None, patience: 50 }
}

pub(super) fn run_of(sweeps: u32, seed: u64) -> SearchRun<'static> {
    SearchRun { sweeps, seed, start: None, target_energy: None }
}

fn anneal(model: &MrfModel, sampler: Sampler, schedule: Cooling, sweeps: u32, seed: u64) -> SearchOutcome {
    SimulatedAnnealing::new(model, options(sampler, schedule)).run(&run_of(sweeps, seed), &Silent, |_| ()).unwrap()
}

pub(super) fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

/// Asks to stop from the `after`-th question on.
pub(super) struct CancelAfter(pub AtomicU32);

impl Observer for CancelAfter {
    fn is_cancelled(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
    }
}

#[test]
fn annealing_finds_the_exhaustive_minimum_of_small_models() {
    let models: Vec<(MrfModel, f64)> = (0..120)
        .map(|seed| {
            let model = model(5, &RING, 5, seed, 0.1 * (seed % 20) as f64, 2.5);
            let lowest = exhaustive_minimum(&model);
            (model, lowest)
        })
        .collect();
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        for schedule in [Cooling::Geometric, Cooling::Logarithmic, Cooling::Linear] {
            // The logarithmic schedule falls to a third within seven sweeps and hardly further: it has to begin hot.
            let initial_temperature = (schedule == Cooling::Logarithmic).then_some(5.0);
            let options = AnnealingOptions { initial_temperature, ..options(sampler, schedule) };
            let found = |(seed, (model, lowest)): (usize, &(MrfModel, f64))| {
                let outcome = SimulatedAnnealing::new(model, options).run(&run_of(1500, seed as u64), &Silent, |_| ());
                outcome.unwrap().energy.total() < lowest + 1e-9
            };
            let hits = models.iter().enumerate().filter(|&m| found(m)).count();
            assert!(hits * 100 >= 95 * models.len(), "{sampler:?} {schedule:?}: {hits} of {}", models.len());
        }
    }
}

/// Frequencies of the labels over a long chain at temperature 1. The bound is three times the standard error of a
/// chain whose samples are independent only every tenth sweep.
#[test]
fn both_samplers_at_temperature_one_visit_labels_by_their_marginals() {
    let sweeps = 60_000u32;
    for seed in 0..4 {
        let model = model(5, &RING, 5, seed, 1.0, 2.5);
        let exact = exhaustive_marginals(&model);
        let energy = SearchEnergy::new(&model);
        for update in [SiteUpdate::Gibbs(1.0), SiteUpdate::Metropolis(1.0)] {
            let mut state = SearchState::new(&energy, vec![0; 5], None);
            let mut chain = Sweeps::new(&model.variables, 5, true);
            let mut counts = [[0u32; 5]; 5];
            for sweep in 0..sweeps {
                chain.sweep(&energy, &mut state, update, (seed, sweep), &Silent).unwrap();
                state.settle();
                for (count, &x) in counts.iter_mut().zip(state.labels()) {
                    count[x as usize] += 1;
                }
            }
            for (i, (count, marginal)) in counts.iter().zip(&exact).enumerate() {
                for (x, (&c, &p)) in count.iter().zip(marginal).enumerate() {
                    let frequency = f64::from(c) / f64::from(sweeps);
                    let bound = 3.0 * (10.0 * p * (1.0 - p) / f64::from(sweeps)).sqrt();
                    assert!((frequency - p).abs() < bound, "{update:?} p({i}, {x}) = {p}, visited {frequency}");
                }
            }
        }
    }
}

/// Independent draws, so the bound is five standard errors; one bound of the far part lives through all temperatures.
#[test]
fn gibbs_draws_follow_the_conditional_while_the_temperature_falls() {
    let n_labels = 90;
    let model = large();
    let energy = SearchEnergy::new(&model);
    let mut scratch = GibbsScratch::new(n_labels);
    for i in [0usize, 57, 200] {
        let mut labels = energy.random_labels(3, 0);
        // Some neighbors agree with each other, so that near and far parts both matter.
        for &j in &model.variables.neighbors(i)[1..] {
            labels[j as usize] = 40 + j % 3;
        }
        let mut bound = loosest_bound(n_labels);
        for (step, temperature) in [4.0, 1.5, 0.7, 0.3].into_iter().enumerate() {
            let weights: Vec<f64> = (0..n_labels as u32)
                .map(|x| {
                    let mut changed = labels.clone();
                    changed[i] = x;
                    -model.energy(&changed).total() / temperature
                })
                .collect();
            let top = weights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let sum: f64 = weights.iter().map(|w| (w - top).exp()).sum();
            let n = 100_000u32;
            let mut counts = vec![0u32; n_labels];
            for k in 0..n {
                let mut draws = Draws::new(i as u64, Purpose::Site, step as u32, k);
                counts[scratch.draw(&energy, &labels, i, temperature, &mut draws, &mut bound) as usize] += 1;
            }
            for (x, &c) in counts.iter().enumerate() {
                let p = (weights[x] - top).exp() / sum;
                let expected = p * f64::from(n);
                let error = 5.0 * (expected * (1.0 - p)).sqrt() + 5.0;
                assert!((f64::from(c) - expected).abs() < error, "T {temperature}, label {x}: {c}, not {expected}");
            }
        }
    }
}

#[test]
fn the_confidence_is_the_conditional_probability_at_temperature_one() {
    let model = model(5, &RING, 5, 9, 1.0, 2.5);
    let outcome = anneal(&model, Sampler::Gibbs, Cooling::Geometric, 50, 1);
    for i in 0..5 {
        let weight = |x: u32| {
            let mut changed = outcome.labeling.clone();
            changed[i] = x;
            (outcome.energy.total() - model.energy(&changed).total()).exp()
        };
        let exact = 1.0 / (0..5).map(weight).sum::<f64>();
        assert!((outcome.confidence[i] - exact).abs() < 1e-5, "{} for {exact}", outcome.confidence[i]);
    }
}

fn edges_of(n: usize, chords: &std::collections::BTreeSet<(u32, u32)>) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = (0..n as u32 - 1).map(|k| [k, k + 1]).collect();
    edges.extend(chords.iter().filter(|(a, b)| a < b && *b < n as u32).map(|&(a, b)| [a, b]));
    edges.sort_unstable();
    edges.dedup();
    edges
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn running_energies_equal_full_evaluations(
        n in 2usize..30,
        chords in prop::collection::btree_set((0u32..30, 0u32..30), 0..60),
        seed in any::<u64>(),
        beta in prop_oneof![Just(0.0), 0.0f64..3.0],
        biased in any::<bool>(),
        temperature in 0.05f64..3.0,
    ) {
        let model = model(n, &edges_of(n, &chords), 21, seed, beta, 3.0);
        let mut energy = SearchEnergy::new(&model);
        if biased {
            energy.set_bias(|i, row| row[i % 21] -= 1.5);
        }
        for update in [SiteUpdate::Gibbs(temperature), SiteUpdate::Metropolis(temperature), SiteUpdate::Descent] {
            let mut state = SearchState::new(&energy, energy.random_labels(seed, 0), None);
            let mut sweeps = Sweeps::new(&model.variables, 21, true);
            for sweep in 1..30 {
                let before = state.terms().total();
                let end = sweeps.sweep(&energy, &mut state, update, (seed, sweep), &Silent).unwrap();
                state.settle();
                for (labels, terms) in [(state.labels(), state.terms()), (state.best_labels(), state.best_terms())] {
                    let (full, running) = (model.energy(labels), terms.energy());
                    prop_assert!((full.unary - running.unary).abs() < 1e-9);
                    prop_assert!((full.pairwise - running.pairwise).abs() < 1e-9);
                    prop_assert!((energy.all(labels).total() - terms.total()).abs() < 1e-9);
                }
                prop_assert!(state.best_terms().total() <= state.terms().total());
                if update == SiteUpdate::Descent {
                    prop_assert!(state.terms().total() < before || end.changed == 0);
                }
            }
        }
    }

    #[test]
    fn the_best_labeling_is_the_best_after_any_single_change(
        seed in any::<u64>(),
        steps in prop::collection::vec((0usize..5, 0u32..5, 0u8..10), 1..80),
    ) {
        let model = model(5, &RING, 5, seed, 1.0, 2.5);
        let energy = SearchEnergy::new(&model);
        let mut labels = energy.random_labels(seed, 0);
        let mut state = SearchState::new(&energy, labels.clone(), None);
        let mut best = model.energy(&labels).total();
        for (i, x, what) in steps {
            match what {
                0 => state.settle(),
                1 => {
                    labels = energy.random_labels(seed, x);
                    state.restart(&energy, labels.clone());
                }
                _ => {
                    let delta = energy.site(i, x, &labels).minus(&energy.site(i, labels[i], &labels));
                    let before = model.energy(&labels).total();
                    labels[i] = x;
                    prop_assert!((model.energy(&labels).total() - before - delta.total()).abs() < 1e-12);
                    state.apply(&SiteMove { variable: i as u32, label: x, delta });
                }
            }
            best = best.min(model.energy(&labels).total());
            prop_assert_eq!(state.labels(), labels.as_slice());
        }
        state.settle();
        prop_assert!((state.best_terms().total() - best).abs() < 1e-9);
        prop_assert!((model.energy(state.best_labels()).total() - best).abs() < 1e-9);
    }
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_number_of_threads() {
    let model = large();
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        let with = |threads, seed| on_threads(threads, || anneal(&model, sampler, Cooling::Geometric, 40, seed));
        let one = with(1, 7);
        for threads in [2, 3, 7] {
            assert_eq!(one, with(threads, 7), "{sampler:?} on {threads} threads");
        }
        assert_ne!(one.labeling, with(2, 8).labeling, "{sampler:?} with another seed");
    }
}

#[test]
fn a_second_run_does_not_depend_on_the_first() {
    let model = large();
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        let mut annealing = SimulatedAnnealing::new(&model, options(sampler, Cooling::Geometric));
        annealing.run(&run_of(10, 1), &Silent, |_| ()).unwrap();
        let second = annealing.run(&run_of(10, 2), &Silent, |_| ()).unwrap();
        assert_eq!(second, anneal(&model, sampler, Cooling::Geometric, 10, 2));
    }
}

#[test]
fn every_sweep_is_reported_and_the_best_energy_never_rises() {
    let model = large();
    let mut seen = Vec::new();
    let outcome = SimulatedAnnealing::new(&model, options(Sampler::Metropolis, Cooling::Linear))
        .run(&run_of(60, 3), &Silent, |sweep| seen.push(*sweep))
        .unwrap();
    assert_eq!((seen.len(), outcome.sweeps, outcome.stop), (60, 60, SearchStop::Budget));
    assert!(seen.windows(2).all(|w| w[1].best_energy.total() <= w[0].best_energy.total()));
    assert!(seen.windows(2).all(|w| w[1].temperature <= w[0].temperature));
    assert!(seen.iter().all(|s| s.best_energy.total() <= s.energy.total()));
    assert!((seen[59].best_energy.total() - outcome.energy.total()).abs() < 1e-9);
    assert_eq!(outcome.energy, model.energy(&outcome.labeling));
    assert!(!outcome.certified);
}

#[test]
fn a_frozen_chain_ends_early() {
    let model = model(5, &RING, 5, 1, 1.0, 2.5);
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        let cold = AnnealingOptions { final_temperature: Some(1e-3), ..options(sampler, Cooling::Geometric) };
        let outcome = SimulatedAnnealing::new(&model, cold).run(&run_of(2000, 1), &Silent, |_| ()).unwrap();
        assert_eq!(outcome.stop, SearchStop::Frozen);
        assert!(outcome.sweeps < 2000);
    }
}

#[test]
fn annealing_ends_certified_at_a_target() {
    let model = model(5, &RING, 5, 4, 1.0, 2.5);
    let lowest = exhaustive_minimum(&model);
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        let run = SearchRun { target_energy: Some(lowest), ..run_of(2000, 1) };
        let mut annealing = SimulatedAnnealing::new(&model, options(sampler, Cooling::Geometric));
        let outcome = annealing.run(&run, &Silent, |_| ()).unwrap();
        assert_eq!((outcome.stop, outcome.certified), (SearchStop::TargetReached, true));
        assert!(outcome.energy.total() <= lowest);
        // From there nothing is left to improve.
        let again = annealing.run(&SearchRun { start: Some(&outcome.labeling), ..run }, &Silent, |_| ()).unwrap();
        assert_eq!((again.sweeps, again.certified), (0, true));
    }
}

/// Hard constraints cut the labelings into islands between which single changes cannot move once it is cold, so not
/// every run finds the minimum; but none may leave an edge broken.
#[test]
fn with_an_infinite_truncation_no_edge_stays_broken_that_need_not_be() {
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        let mut hits = 0;
        for seed in 0..100 {
            let model = model(5, &RING, 5, seed, 1.0, f64::INFINITY);
            let lowest = exhaustive_minimum(&model);
            let outcome = anneal(&model, sampler, Cooling::Geometric, 1000, seed);
            assert!(outcome.energy.total().is_finite(), "{sampler:?}, seed {seed}");
            assert!(outcome.confidence.iter().all(|p| (0.0..=1.0 + 1e-6).contains(p)));
            hits += u32::from(outcome.energy.total() < lowest + 1e-9);
        }
        assert!(hits >= 90, "{sampler:?}: {hits} of 100");
    }
}

#[test]
fn a_bias_shifts_the_minimum_and_not_the_reported_energy() {
    for (seed, forbidden) in [(1, 3.0f32), (2, 50.0), (3, f32::INFINITY)] {
        let model = model(5, &RING, 5, seed, 1.0, 2.5);
        let mut shifted = model.clone();
        for row in shifted.unary.chunks_mut(5) {
            row[2] = 0.0;
            row.iter_mut().enumerate().filter(|(x, _)| *x != 2).for_each(|(_, v)| *v = forbidden.min(1e4));
        }
        for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
            let mut annealing = SimulatedAnnealing::new(&model, options(sampler, Cooling::Geometric));
            annealing.set_bias(|_, row| {
                row.fill(forbidden);
                row[2] = 0.0;
            });
            let outcome = annealing.run(&run_of(300, seed), &Silent, |_| ()).unwrap();
            assert!((shifted.energy(&outcome.labeling).total() - exhaustive_minimum(&shifted)).abs() < 1e-6);
            assert_eq!(outcome.energy, model.energy(&outcome.labeling));
        }
    }
}

#[test]
fn models_without_edges_or_choices_are_no_special_cases() {
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        let alone = model(3, &[], 6, 1, 1.0, 2.5);
        let outcome = anneal(&alone, sampler, Cooling::Geometric, 300, 1);
        assert_eq!(outcome.labeling, alone.unary_minimum());
        let single = model(2, &[[0, 1]], 1, 1, 1.0, 2.5);
        let outcome = anneal(&single, sampler, Cooling::Linear, 300, 1);
        assert_eq!((outcome.labeling, outcome.stop), (vec![0, 0], SearchStop::Frozen));
        let empty = model(0, &[], 3, 1, 1.0, 2.5);
        assert_eq!(anneal(&empty, sampler, Cooling::Linear, 300, 1).labeling, Vec::<u32>::new());
    }
}

#[test]
fn a_cancelled_run_ends_without_an_answer() {
    let model = large();
    for sampler in [Sampler::Gibbs, Sampler::Metropolis] {
        for after in [0, 5, 200] {
            let mut n_sweeps = 0;
            let observer = CancelAfter(AtomicU32::new(after));
            let outcome = SimulatedAnnealing::new(&model, options(sampler, Cooling::Linear)).run(
                &run_of(100_000, 1),
                &observer,
                |_| n_sweeps += 1,
            );
            assert!(outcome.is_err());
            // A sweep of 400 variables checks for cancellation more than 20 times.
            assert!(n_sweeps <= after / 20, "{n_sweeps} sweeps after {after} checks");
        }
    }
}
