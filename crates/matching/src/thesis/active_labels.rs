//! Belief propagation over active labels as a minimizer: each variable keeps only its best labels.

use super::minimizer::{InferenceRun, Minimizer, MinimizerResult, OnStep};
use super::propagation::{labeled, trace_point};
use homolog_mrf::MrfModel;
use homolog_mrf::inference::{ActiveModel, ActivePropagation, ActiveSets, BpOptions, UnaryInput, UnaryPotentials};
use homolog_primitives::observe::Cancelled;
use rayon::prelude::*;

/// Active labels of a variable after a registration restricts them.
const WITH_FEEDBACK: usize = 64;
/// Without feedback any label may be the best: a variable begins with one `SHARE`th of the labels, at least `AT_LEAST`.
const SHARE: usize = 5;
const AT_LEAST: usize = 256;
/// Sets without feedback are revised every `EVERY` iterations: labels whose energy exceeds the best by more than
/// `MARGIN` are dropped, and those around the best `DEMANDED` labels of each neighbor are added.
const EVERY: u32 = 20;
const MARGIN: f32 = 20.0;
const DEMANDED: usize = 2;

/// A minimizer over active labels.
pub(crate) struct ActiveLabels<'a> {
    model: &'a MrfModel,
    options: BpOptions,
    /// The addition of feedback to the unary potentials, variable by variable, over all labels.
    bias: Option<Table>,
    propagation: Option<ActivePropagation<'a>>,
    /// Whether the label sets were chosen under the present feedback.
    is_open: bool,
}

/// Potentials of all labels.
struct Table {
    n_labels: usize,
    values: Vec<f32>,
}

impl UnaryPotentials for Table {
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        let row = &self.values[variable * self.n_labels..][..self.n_labels];
        values.iter_mut().zip(labels).for_each(|(value, &x)| *value = row[x as usize]);
    }

    fn row(&self, variable: usize, row: &mut [f32]) {
        row.copy_from_slice(&self.values[variable * self.n_labels..][..self.n_labels]);
    }
}

impl<'a> ActiveLabels<'a> {
    pub(crate) fn new(model: &'a MrfModel, options: BpOptions) -> Self {
        ActiveLabels { model, options, bias: None, propagation: None, is_open: false }
    }

    fn sets(&self) -> ActiveSets {
        let n = self.model.n_labels();
        let initial = if self.bias.is_some() { WITH_FEEDBACK } else { (n / SHARE).max(AT_LEAST) };
        ActiveSets {
            initial,
            kept: initial,
            largest: initial,
            margin: MARGIN,
            every: EVERY,
            best_of_neighbors: DEMANDED,
        }
    }
}

impl Minimizer for ActiveLabels<'_> {
    fn reset(&mut self) {
        self.propagation = None;
    }

    fn set_bias(&mut self, add: &(dyn Fn(usize, &mut [f32]) + Sync)) {
        let n_labels = self.model.n_labels();
        let mut values = vec![0.0; self.model.variables.n_vertices() * n_labels];
        values.par_chunks_mut(n_labels.max(1)).enumerate().for_each(|(i, row)| add(i, row));
        self.bias = Some(Table { n_labels, values });
        self.is_open = false;
    }

    fn run(&mut self, run: &InferenceRun<'_>, on_step: OnStep<'_>) -> Result<MinimizerResult, Cancelled> {
        let &InferenceRun { round, budget, positions, observer } = run;
        let sets = self.sets();
        let bias = self.bias.as_ref().map(|table| table as &dyn UnaryPotentials);
        let evidence = UnaryInput { unary: self.model, bias };
        let mut propagation = match self.propagation.take() {
            Some(mut propagation) => {
                if !self.is_open {
                    propagation.reopen(&sets, evidence, observer)?;
                }
                propagation
            }
            None => {
                let n = self.model.variables.n_vertices();
                let candidates = sets.propose(n, self.model.n_labels(), evidence, observer)?;
                // The candidates are of this model, so they fit it.
                let Ok(model) = ActiveModel::of(self.model, candidates) else { unreachable!("sets of another model") };
                ActivePropagation::new(model, self.options)
            }
        };
        self.is_open = true;
        propagation.set_bias(bias);
        let mut on_iteration = |iteration: &_| on_step(trace_point(round, iteration));
        let outcome = if bias.is_some() {
            propagation.run(budget, observer, &mut on_iteration)?
        } else {
            propagation.run_revising(budget, &sets, evidence, observer, &mut on_iteration)?.propagation
        };
        let spread_mm = propagation.spreads(positions);
        self.propagation = Some(propagation);
        Ok(labeled(outcome, spread_mm))
    }
}
