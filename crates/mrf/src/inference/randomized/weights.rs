//! Rows of Boltzmann weights `exp(−E/T)` and draws from them.
//!
//! The exponential of [`homolog_primitives::exponential`] vectorizes and gives the same bits on every instruction set.

use homolog_primitives::exponential::exp_negative;
use multiversion::multiversion;

/// Weights summed side by side.
const LANES: usize = 16;
/// Weights per partial sum; a draw walks over partial sums first.
const BLOCK: usize = 64;

/// `weights[k] = exp((shift − energies[k]) · inverse)`; every energy at least `shift`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn boltzmann(energies: &[f32], shift: f32, inverse: f32, weights: &mut [f32]) {
    for (weight, &energy) in weights.iter_mut().zip(energies) {
        *weight = exp_negative((shift - energy) * inverse);
    }
}

/// `weights[k] = exp((shift − lowered[k]) · inverse) − exp((shift − raised[k]) · inverse)`, with `lowered ≤ raised`.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn boltzmann_gain(lowered: &[f32], raised: &[f32], shift: f32, inverse: f32, weights: &mut [f32]) {
    for ((weight, &low), &high) in weights.iter_mut().zip(lowered).zip(raised) {
        let gain = exp_negative((shift - low) * inverse) - exp_negative((shift - high) * inverse);
        // The polynomial is monotone only up to its rounding.
        *weight = if gain > 0.0 { gain } else { 0.0 };
    }
}

/// Sums of blocks of [`BLOCK`] weights, in the same order on every instruction set.
#[allow(unsafe_code, reason = "the dispatch to instruction sets that `multiversion` generates")]
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn block_sums(weights: &[f32], sums: &mut [f32]) {
    for (block, sum) in weights.chunks_exact(BLOCK).zip(sums) {
        let mut lanes = [0.0f32; LANES];
        for chunk in block.chunks_exact(LANES) {
            for k in 0..LANES {
                lanes[k] += chunk[k];
            }
        }
        *sum = lanes.iter().sum();
    }
}

/// A row of weights. Its memory is allocated once, for the longest row.
#[derive(Debug, Clone)]
pub(super) struct WeightRow {
    /// Whole blocks of weights; zero beyond the row in use.
    weights: Vec<f32>,
    sums: Vec<f32>,
    /// Blocks of the row in use.
    blocks: usize,
}

impl WeightRow {
    /// Room for `n` weights.
    pub(super) fn new(n: usize) -> Self {
        let n = n.next_multiple_of(BLOCK);
        WeightRow { weights: vec![0.0; n], sums: vec![0.0; n / BLOCK], blocks: 0 }
    }

    /// Fills the row with `exp((shift − energy) · inverse)` and returns the sum. No energy is below `shift`.
    pub(super) fn fill(&mut self, energies: &[f32], shift: f32, inverse: f32) -> f64 {
        boltzmann(energies, shift, inverse, &mut self.weights[..energies.len()]);
        self.finish(energies.len())
    }

    /// Fills the row with the gain of each weight when its energy is `lowered` instead of `raised`; returns the sum.
    pub(super) fn fill_gain(&mut self, lowered: &[f32], raised: &[f32], shift: f32, inverse: f32) -> f64 {
        boltzmann_gain(lowered, raised, shift, inverse, &mut self.weights[..lowered.len()]);
        self.finish(lowered.len())
    }

    fn finish(&mut self, n: usize) -> f64 {
        let padded = n.next_multiple_of(BLOCK);
        self.blocks = padded / BLOCK;
        self.weights[n..padded].fill(0.0);
        let sums = &mut self.sums[..self.blocks];
        block_sums(&self.weights[..padded], sums);
        sums.iter().map(|&s| f64::from(s)).sum()
    }

    /// The index at which the running sum of the weights passes `at`, in `[0, sum)`. Its weight is positive unless all
    /// weights are 0. Cost `O(n/64)`.
    pub(super) fn pick(&self, mut at: f64) -> usize {
        let mut last = 0;
        for (block, &sum) in self.sums[..self.blocks].iter().enumerate() {
            if sum <= 0.0 {
                continue;
            }
            let range = block * BLOCK..(block + 1) * BLOCK;
            let here = at < f64::from(sum);
            for index in range.filter(|&k| self.weights[k] > 0.0) {
                // Lanes and this walk round differently: the last positive weight takes the remainder.
                last = index;
                if here {
                    at -= f64::from(self.weights[index]);
                    if at < 0.0 {
                        return index;
                    }
                }
            }
            if here {
                return last;
            }
            at -= f64::from(sum);
        }
        last
    }

    /// The weight at `index`.
    pub(super) fn weight(&self, index: usize) -> f64 {
        self.weights[index].into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_row_sums_and_picks_as_a_plain_walk_does(
            energies in prop::collection::vec(0.0f32..30.0, 1..300),
            at in 0.0f64..1.0,
            inverse in 0.05f32..10.0,
        ) {
            let mut row = WeightRow::new(300);
            row.fill(&vec![0.0; 300], 0.0, 1.0);
            let least = energies.iter().copied().fold(f32::INFINITY, f32::min);
            let sum = row.fill(&energies, least, inverse);
            let weights: Vec<f64> =
                energies.iter().map(|&e| (f64::from(least - e) * f64::from(inverse)).exp()).collect();
            let exact: f64 = weights.iter().sum();
            prop_assert!((sum / exact - 1.0).abs() < 3e-5);
            let picked = row.pick(at * sum);
            prop_assert!(picked < energies.len());
            let before: f64 = weights[..picked].iter().sum();
            prop_assert!(before <= (at + 3e-5) * exact && (at - 3e-5) * exact <= before + weights[picked]);
        }

        #[test]
        fn gains_are_differences_of_weights(
            pairs in prop::collection::vec((0.0f32..30.0, 0.0f32..30.0), 1..100),
            inverse in 0.05f32..10.0,
        ) {
            let (lowered, raised): (Vec<f32>, Vec<f32>) = pairs.iter().map(|&(a, b)| (a.min(b), a.max(b))).unzip();
            let (mut row, mut other) = (WeightRow::new(100), WeightRow::new(100));
            let gain = row.fill_gain(&lowered, &raised, 0.0, inverse);
            let difference = other.fill(&lowered, 0.0, inverse) - other.fill(&raised, 0.0, inverse);
            prop_assert!((gain - difference).abs() < 1e-4 * (1.0 + gain));
        }
    }

    #[test]
    fn very_cold_rows_hold_zeros_and_a_one() {
        let mut row = WeightRow::new(3);
        assert_eq!(row.fill(&[1.0, 2.0, f32::MAX], 1.0, 1e6), 1.0);
        assert_eq!([row.weight(0), row.weight(1), row.weight(2)], [1.0, 0.0, 0.0]);
        assert_eq!(row.pick(0.999_999), 0);
    }
}
