//! Unary potentials on demand, so that no table of all variables by all labels has to be held.

use crate::{Feature, MrfModel};

/// Something that knows potentials of labels.
pub trait UnaryPotentials: Sync {
    /// Potentials of `variable` at `labels` into `values`, one each.
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]);

    /// Potentials of `variable` at every label into `row`.
    fn row(&self, variable: usize, row: &mut [f32]);
}

/// Unary potentials, and feedback on top of them that is not part of the energy.
#[derive(Clone, Copy)]
pub struct Evidence<'e> {
    /// `θ_i(x)`.
    pub unary: &'e dyn UnaryPotentials,
    /// What is added to it while messages are passed, and left out of every energy that is reported.
    pub bias: Option<&'e dyn UnaryPotentials>,
}

impl<'e> Evidence<'e> {
    /// Without feedback.
    pub fn plain(unary: &'e dyn UnaryPotentials) -> Self {
        Evidence { unary, bias: None }
    }

    /// `θ_i` plus bias over all labels into `row`; `bias` is scratch of the same length.
    pub(super) fn row(&self, variable: usize, row: &mut [f32], bias: &mut [f32]) {
        self.unary.row(variable, row);
        if let Some(feedback) = self.bias {
            feedback.row(variable, bias);
            row.iter_mut().zip(bias).for_each(|(theta, bias)| *theta += *bias);
        }
    }
}

impl UnaryPotentials for MrfModel {
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        let row = self.unary_row(variable);
        values.iter_mut().zip(labels).for_each(|(value, &x)| *value = row[x as usize]);
    }

    fn row(&self, variable: usize, row: &mut [f32]) {
        row.copy_from_slice(self.unary_row(variable));
    }
}

/// The potentials of [`crate::unary_potentials`], to the bit, without its table.
///
/// Memory `O((variables + labels) · features)`; a row costs `O(labels · features)`, a label `O(features)`.
#[derive(Debug, Clone, PartialEq)]
pub struct FeaturePotentials {
    scaled: Vec<ScaledFeature>,
    cap: f32,
    order: f32,
}

/// A feature in units of its scale.
#[derive(Debug, Clone, PartialEq)]
struct ScaledFeature {
    weight: f32,
    source: Vec<f32>,
    target: Vec<f32>,
}

impl FeaturePotentials {
    /// `alpha ≥ 0`, `cap` is `τ` and `order` is `p` of `θ_i(x) = α · mean_f [ w_f · min(|f_i − f'_x| / s_f, τ)^p ]`.
    pub fn new(features: &[Feature], alpha: f64, cap: f64, order: f64) -> Self {
        let scaled = features.iter().map(|f| {
            let scale = f.robust_scale();
            let scaled = |values: &[f64]| values.iter().map(|v| (v / scale) as f32).collect();
            let weight = (alpha * f.weight / features.len() as f64) as f32;
            ScaledFeature { weight, source: scaled(&f.source), target: scaled(&f.target) }
        });
        FeaturePotentials { scaled: scaled.collect(), cap: cap as f32, order: order as f32 }
    }

    /// Adds the term of one feature at `at` to every potential of `values`, whose labels have it at `targets`.
    fn add(&self, weight: f32, at: f32, targets: impl Iterator<Item = f32>, values: &mut [f32]) {
        if self.order == 1.0 {
            for (theta, value) in values.iter_mut().zip(targets) {
                let d = (value - at).abs();
                *theta += weight * if d < self.cap { d } else { self.cap };
            }
        } else {
            for (theta, value) in values.iter_mut().zip(targets) {
                *theta += weight * (value - at).abs().min(self.cap).powf(self.order);
            }
        }
    }
}

impl UnaryPotentials for FeaturePotentials {
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        values.fill(0.0);
        for f in &self.scaled {
            self.add(f.weight, f.source[variable], labels.iter().map(|&x| f.target[x as usize]), values);
        }
    }

    fn row(&self, variable: usize, row: &mut [f32]) {
        row.fill(0.0);
        for f in &self.scaled {
            self.add(f.weight, f.source[variable], f.target.iter().copied(), row);
        }
    }
}
