//! Unary potentials from vertex features.

use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};
use rayon::prelude::*;

/// One feature measured on both surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Weight `w_f`.
    pub weight: f64,
    /// Value `f_i` at every variable.
    pub source: Vec<f64>,
    /// Value `f'_x` at every label.
    pub target: Vec<f64>,
}

impl Feature {
    /// Robust scale `s_f`: 1.4826 times the median absolute deviation, pooled over both surfaces (for normally
    /// distributed values the factor makes it the standard deviation). Never 0: a constant feature gets scale 1.
    pub fn robust_scale(&self) -> f64 {
        let mut values: Vec<f64> = self.source.iter().chain(&self.target).copied().collect();
        let center = median(&mut values);
        for v in &mut values {
            *v = (*v - center).abs();
        }
        let scale = 1.4826 * median(&mut values);
        if scale > 0.0 { scale } else { 1.0 }
    }
}

fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Unary potentials `θ_i(x) = α · mean_f [ w_f · min(|f_i − f'_x| / s_f, τ)^p ]`, computed on demand: the values of
/// [`unary_potentials`] without its table.
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
        // Scaled once, so that the loop is a difference, a minimum and a sum in 32 bits.
        let scaled = features.iter().map(|f| {
            let scale = f.robust_scale();
            let scaled = |values: &[f64]| values.iter().map(|v| (v / scale) as f32).collect();
            let weight = (alpha * f.weight / features.len() as f64) as f32;
            ScaledFeature { weight, source: scaled(&f.source), target: scaled(&f.target) }
        });
        FeaturePotentials { scaled: scaled.collect(), cap: cap as f32, order: order as f32 }
    }

    /// Writes the potentials of `variable` at every label into `row`.
    pub(crate) fn fill_row(&self, variable: usize, row: &mut [f32]) {
        row.fill(0.0);
        for f in &self.scaled {
            self.add(f.weight, f.source[variable], f.target.iter().copied(), row);
        }
    }

    /// Writes the potentials of `variable` at `labels` into `values`, one each.
    pub(crate) fn fill_at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        values.fill(0.0);
        for f in &self.scaled {
            self.add(f.weight, f.source[variable], labels.iter().map(|&x| f.target[x as usize]), values);
        }
    }

    /// Adds the term of one feature with value `at` to every potential of `values`, whose labels have the feature
    /// values `targets`.
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

/// The table `θ_i(x) = α · mean_f [ w_f · min(|f_i − f'_x| / s_f, τ)^p ]`, variable by variable.
///
/// `alpha ≥ 0`, `cap` is `τ`, `order` is `p`. Cost `O(variables · labels · features)`, on all cores.
///
/// # Errors
/// [`Cancelled`]; the observer is asked at every variable.
pub fn unary_potentials(
    features: &[Feature],
    alpha: f64,
    cap: f64,
    order: f64,
    observer: &dyn Observer,
) -> Result<Vec<f32>, Cancelled> {
    let n_variables = features.first().map_or(0, |f| f.source.len());
    let n_labels = features.first().map_or(0, |f| f.target.len());
    let potentials = FeaturePotentials::new(features, alpha, cap, order);
    let mut table = vec![0.0f32; n_variables * n_labels];
    table.par_chunks_mut(n_labels.max(1)).enumerate().try_for_each(|(i, row)| {
        checkpoint_within(observer)?;
        potentials.fill_row(i, row);
        Ok(())
    })?;
    Ok(table)
}
