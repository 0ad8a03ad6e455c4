//! The Gibbs sampler at one variable: a draw from `p(x) ∝ exp(−E_i(x)/T)`, with all other labels fixed.
//!
//! Source: Geman, Geman, IEEE PAMI 6(6), 1984. The method of avoiding most labels in a draw is original:
//!
//! With the constant `degree · T_trunc` left out, `E_i(x) = θ_i(x) − g(x)`, where `g(x) = Σ_j [T_trunc − θ_ij(x, x_j)]`
//! is non-negative, and 0 outside of `∪_j N_r(x_j)`. The weights are therefore a sum of two non-negative parts. The
//! **far** part `exp(−θ_i/T)`, over all labels, does not depend on neighbors. The **near** part is the gain `exp(−(θ_i
//! − g)/T) − exp(−θ_i/T)` of a few dozen labels. The near part is computed; for the far part only a bound of its sum is
//! needed. Relative to the row's minimum that sum never grows while the temperature falls, so the sum of an earlier
//! sweep is such a bound. A draw that falls into the far part computes it and tightens the bound. If it fell into the
//! slack between bound and sum, it starts over: this is rejection sampling, and exact.
//!
//! Cost: `O(degree · k̄)`, plus `O(n_labels)` whenever the far part is hit, which happens always at high temperatures
//! and hardly ever once labels agree with their neighbors'.

use super::draws::Draws;
use super::energy::SearchEnergy;
use super::weights::WeightRow;

/// Scratch of one thread: nothing is allocated in a sweep.
#[derive(Debug, Clone)]
pub(super) struct GibbsScratch {
    /// `g(x)`; reset to 0 after each variable.
    gain: Vec<f32>,
    /// Labels with a gain.
    touched: Vec<u32>,
    /// Energies of these labels without and with the gain, relative to the row's minimum.
    raised: Vec<f32>,
    lowered: Vec<f32>,
    near: WeightRow,
    far: WeightRow,
}

/// A bound of the far part at any temperature: no weight exceeds 1.
pub(super) fn loosest_bound(n_labels: usize) -> f64 {
    n_labels as f64
}

impl GibbsScratch {
    /// Room for `n_labels` labels.
    pub(super) fn new(n_labels: usize) -> Self {
        GibbsScratch {
            gain: vec![0.0; n_labels],
            touched: Vec::with_capacity(n_labels),
            raised: Vec::with_capacity(n_labels),
            lowered: Vec::with_capacity(n_labels),
            near: WeightRow::new(n_labels),
            far: WeightRow::new(n_labels),
        }
    }

    /// Draws a label for variable `i`. `bound` is at least the sum of the far part relative to the row's minimum at
    /// this temperature; the draw tightens it.
    pub(super) fn draw(
        &mut self,
        energy: &SearchEnergy<'_>,
        labels: &[u32],
        i: usize,
        temperature: f64,
        draws: &mut Draws,
        bound: &mut f64,
    ) -> u32 {
        let lowest = self.gather(energy, labels, i);
        let inverse = (1.0 / temperature) as f32;
        let near = self.near.fill_gain(&self.lowered, &self.raised, lowest, inverse);
        let scale = (f64::from(lowest) / temperature).exp();
        let mut far = None;
        loop {
            let at = draws.unit() * (near + *bound * scale);
            if at < near {
                return self.touched[self.near.pick(at)];
            }
            let sum = *far.get_or_insert_with(|| self.fill_far(energy, i, inverse));
            *bound = sum;
            let at = (at - near) / scale;
            if at < sum {
                return self.far.pick(at) as u32;
            }
        }
    }

    /// `p(x_i = labels[i] | neighbors)` at temperature 1. Cost `O(degree · k̄ + n_labels)`.
    pub(super) fn confidence(&mut self, energy: &SearchEnergy<'_>, labels: &[u32], i: usize) -> f64 {
        let lowest = self.gather(energy, labels, i);
        let near = self.near.fill_gain(&self.lowered, &self.raised, lowest, 1.0);
        let scale = f64::from(lowest).exp();
        let far = self.fill_far(energy, i, 1.0);
        let gained = self.touched.iter().position(|&x| x == labels[i]).map_or(0.0, |k| self.near.weight(k));
        (gained + self.far.weight(labels[i] as usize) * scale) / (near + far * scale)
    }

    /// Fills the far part and returns its sum, at least 1: the row's minimum has weight 1.
    fn fill_far(&mut self, energy: &SearchEnergy<'_>, i: usize, inverse: f32) -> f64 {
        self.far.fill(energy.unary_row(i), energy.row_minimum(i), inverse)
    }

    /// Finds the labels with a gain, and their energies; returns the lowest of all energies relative to the row's
    /// minimum, at most 0.
    fn gather(&mut self, energy: &SearchEnergy<'_>, labels: &[u32], i: usize) -> f32 {
        let model = energy.model;
        let top = energy.pairwise.truncation as f32;
        let slope = (energy.pairwise.beta / energy.pairwise.length_scale) as f32;
        self.touched.clear();
        for edge in model.variables.row(i) {
            let length = model.lengths[edge];
            let y = labels[model.variables.head(edge)] as usize;
            for (&x, &distance) in model.labels.members(y).iter().zip(model.labels.distances(y)) {
                let gained = top - slope * (length - distance).abs();
                if gained > 0.0 {
                    let gain = &mut self.gain[x as usize];
                    if *gain == 0.0 {
                        self.touched.push(x);
                    }
                    *gain += gained;
                }
            }
        }
        let (row, minimum) = (energy.unary_row(i), energy.row_minimum(i));
        self.raised.clear();
        self.lowered.clear();
        let mut lowest = 0.0f32;
        for &x in &self.touched {
            let raised = row[x as usize] - minimum;
            let lowered = raised - std::mem::take(&mut self.gain[x as usize]);
            lowest = if lowered < lowest { lowered } else { lowest };
            self.raised.push(raised);
            self.lowered.push(lowered);
        }
        lowest
    }
}
