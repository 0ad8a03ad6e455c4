//! Unary potentials from vertex features.

use rayon::prelude::*;

/// One feature measured on both surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Weight `w_f`.
    pub weight: f64,
    /// Its value `f_i` at every variable.
    pub source: Vec<f64>,
    /// Its value `f'_x` at every label.
    pub target: Vec<f64>,
}

impl Feature {
    /// Robust scale `s_f`: 1.4826 times the median absolute deviation, pooled over both surfaces (1.4826 makes it
    /// the standard deviation where values are normally distributed). Never 0: a constant feature gets scale 1.
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

/// The table `θ_i(x) = α · mean_f [ w_f · min(|f_i − f'_x| / s_f, τ)^p ]`, variable by variable.
///
/// `alpha ≥ 0`, `cap` is `τ`, `order` is `p`. Cost `O(variables · labels · features)`, on all cores.
pub fn unary_potentials(features: &[Feature], alpha: f64, cap: f64, order: f64) -> Vec<f32> {
    let n_variables = features.first().map_or(0, |f| f.source.len());
    let n_labels = features.first().map_or(0, |f| f.target.len());
    let mut table = vec![0.0f32; n_variables * n_labels];
    // Scaled once, so that the loop is a difference, a minimum and a sum in 32 bits.
    let scaled: Vec<(f32, Vec<f32>, Vec<f32>)> = features
        .iter()
        .map(|f| {
            let scale = f.robust_scale();
            let scaled = |values: &[f64]| values.iter().map(|v| (v / scale) as f32).collect();
            let weight = (alpha * f.weight / features.len() as f64) as f32;
            (weight, scaled(&f.source), scaled(&f.target))
        })
        .collect();
    let (cap, order) = (cap as f32, order as f32);
    table.par_chunks_mut(n_labels.max(1)).enumerate().for_each(|(i, row)| {
        for (weight, source, target) in &scaled {
            let (weight, at) = (*weight, source[i]);
            if order == 1.0 {
                for (theta, &value) in row.iter_mut().zip(target) {
                    let d = (value - at).abs();
                    *theta += weight * if d < cap { d } else { cap };
                }
            } else {
                for (theta, &value) in row.iter_mut().zip(target) {
                    *theta += weight * (value - at).abs().min(cap).powf(order);
                }
            }
        }
    });
    table
}
