//! The energy as used by the randomized minimizers: in terms of one variable, with a bias, and always finite.

use super::draws::{Draws, Purpose};
use crate::{Energy, MrfModel, PairwisePotential};
use rayon::prelude::*;

/// An energy, or a difference of energies, in its three parts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Terms {
    /// Unary potentials of the model.
    pub unary: f64,
    /// Bias on the unary potentials.
    pub bias: f64,
    /// Pairwise potentials.
    pub pairwise: f64,
}

impl Terms {
    /// The minimized quantity: all parts together.
    pub(super) fn total(&self) -> f64 {
        self.unary + self.bias + self.pairwise
    }

    /// The reported quantity: the energy of the model, without the bias.
    pub(super) fn energy(&self) -> Energy {
        Energy { unary: self.unary, pairwise: self.pairwise }
    }

    pub(super) fn minus(&self, other: &Terms) -> Terms {
        Terms {
            unary: self.unary - other.unary,
            bias: self.bias - other.bias,
            pairwise: self.pairwise - other.pairwise,
        }
    }

    pub(super) fn plus(&self, other: &Terms) -> Terms {
        Terms {
            unary: self.unary + other.unary,
            bias: self.bias + other.bias,
            pairwise: self.pairwise + other.pairwise,
        }
    }
}

/// A model with a bias on its unary potentials and a finite truncation.
///
/// **Hard constraints.** With `T = ∞` differences of energies would be `∞ − ∞`, so a finite stand-in replaces `T`. It
/// exceeds by one the largest possible difference of all unary and unbroken pairwise potentials of a variable, so that
/// any change of one label that leaves fewer broken edges lowers the energy. Infinite values written by a bias are
/// replaced in the same way.
pub(super) struct SearchEnergy<'a> {
    pub model: &'a MrfModel,
    /// The potential of the model, with the stand-in for an infinite truncation.
    pub pairwise: PairwisePotential,
    /// Unary potentials including a bias; `None` without a bias.
    biased: Option<Vec<f32>>,
    /// Minimum of every row of unary potentials, bias included.
    row_minima: Vec<f32>,
}

impl<'a> SearchEnergy<'a> {
    /// The energy of `model` without a bias. Cost `O(n_variables · n_labels)`.
    pub(super) fn new(model: &'a MrfModel) -> Self {
        let mut this = SearchEnergy { model, pairwise: model.pairwise, biased: None, row_minima: Vec::new() };
        this.refresh();
        this
    }

    /// Sets the unary potentials to those of the model plus the values that `add(i, row)` adds to the row of variable
    /// `i`.
    pub(super) fn set_bias(&mut self, add: impl Fn(usize, &mut [f32]) + Sync) {
        let model = self.model;
        let mut table = self.biased.take().unwrap_or_else(|| vec![0.0; model.unary.len()]);
        table.par_chunks_mut(model.n_labels().max(1)).enumerate().for_each(|(i, row)| {
            row.copy_from_slice(model.unary_row(i));
            add(i, row);
        });
        self.biased = Some(table);
        self.refresh();
    }

    /// Updates everything that depends on the unary potentials: stand-ins and minima.
    fn refresh(&mut self) {
        let model = self.model;
        let n = model.n_labels().max(1);
        let degree = (0..model.n_variables()).map(|i| model.variables.row(i).len()).max().unwrap_or(0) as f64;
        if model.pairwise.truncation.is_infinite() {
            let table = self.biased.as_deref().unwrap_or(&model.unary);
            let range = table.par_chunks(n).map(finite_range).reduce(|| 0.0, f64::max);
            self.pairwise.truncation = 1.0 + range + degree * largest_unbroken(model);
        }
        let forbidden = 1.0 + degree * self.pairwise.truncation;
        if let Some(table) = &mut self.biased {
            table.par_chunks_mut(n).for_each(|row| forbid(row, forbidden));
        }
        let table = self.biased.as_deref().unwrap_or(&model.unary);
        self.row_minima = table.par_chunks(n).map(|row| row.iter().copied().fold(f32::INFINITY, f32::min)).collect();
    }

    /// Unary potentials of variable `i`, bias included.
    pub(super) fn unary_row(&self, i: usize) -> &[f32] {
        let n = self.model.n_labels();
        self.biased.as_ref().map_or_else(|| self.model.unary_row(i), |table| &table[i * n..(i + 1) * n])
    }

    /// Minimum of the unary potentials of variable `i`, bias included.
    pub(super) fn row_minimum(&self, i: usize) -> f32 {
        self.row_minima[i]
    }

    /// `θ_ij(x, y)` for the directed edge with id `edge`, finite.
    pub(super) fn pair(&self, edge: usize, x: u32, y: u32) -> f64 {
        self.potential(edge, self.distance(x, y))
    }

    /// `d'(x, y)` if `y` is in `N_r(x)`. Cost `O(log k̄)`.
    pub(super) fn distance(&self, x: u32, y: u32) -> Option<f64> {
        self.model.labels.distance_within(x as usize, y as usize).map(f64::from)
    }

    /// `θ_ij` of the directed edge with id `edge` for labels at `distance`.
    pub(super) fn potential(&self, edge: usize, distance: Option<f64>) -> f64 {
        self.pairwise.potential(self.model.lengths[edge].into(), distance)
    }

    /// The terms of label `x` at variable `i` alone.
    pub(super) fn unary(&self, i: usize, x: u32) -> Terms {
        let unary = f64::from(self.model.unary_row(i)[x as usize]);
        let bias = if self.biased.is_some() { f64::from(self.unary_row(i)[x as usize]) - unary } else { 0.0 };
        Terms { unary, bias, pairwise: 0.0 }
    }

    /// All terms of variable `i` if it had label `x`, with the other labels unchanged. Cost `O(degree · log k̄)`.
    pub(super) fn site(&self, i: usize, x: u32, labels: &[u32]) -> Terms {
        let mut terms = self.unary(i, x);
        for edge in self.model.variables.row(i) {
            terms.pairwise += self.pair(edge, x, labels[self.model.variables.head(edge)]);
        }
        terms
    }

    /// All terms of a labeling. Cost `O(|E→| log k̄)`.
    pub(super) fn all(&self, labels: &[u32]) -> Terms {
        let mut terms = Terms::default();
        for (i, &x) in labels.iter().enumerate() {
            terms = terms.plus(&self.unary(i, x));
            for edge in self.model.variables.row(i) {
                let j = self.model.variables.head(edge);
                if i < j {
                    terms.pairwise += self.pair(edge, x, labels[j]);
                }
            }
        }
        terms
    }

    /// A label for every variable, uniform at random.
    pub(super) fn random_labels(&self, seed: u64, sweep: u32) -> Vec<u32> {
        let mut draws = Draws::new(seed, Purpose::Start, sweep, 0);
        let n_labels = self.model.n_labels() as u64;
        (0..self.model.n_variables()).map(|_| draws.below(n_labels) as u32).collect()
    }
}

/// Largest minus smallest finite value.
fn finite_range(row: &[f32]) -> f64 {
    let finite = || row.iter().copied().filter(|v| v.is_finite());
    let (low, high) = (finite().fold(f32::INFINITY, f32::min), finite().fold(f32::NEG_INFINITY, f32::max));
    if low <= high { f64::from(high) - f64::from(low) } else { 0.0 }
}

/// Replaces infinite values of a row by its largest finite value plus `above`.
fn forbid(row: &mut [f32], above: f64) {
    if row.iter().all(|v| v.is_finite()) {
        return;
    }
    let top = row.iter().copied().filter(|v| v.is_finite()).fold(0.0, f32::max);
    let value = (f64::from(top) + above) as f32;
    row.iter_mut().filter(|v| !v.is_finite()).for_each(|v| *v = value);
}

/// A bound of the pairwise potentials within the neighborhood, before truncation.
fn largest_unbroken(model: &MrfModel) -> f64 {
    let length = model.lengths.iter().copied().fold(0.0, f32::max);
    let distance = (0..model.n_labels()).flat_map(|x| model.labels.distances(x)).copied().fold(0.0, f32::max);
    model.pairwise.beta * f64::from(length.max(distance)) / model.pairwise.length_scale
}
