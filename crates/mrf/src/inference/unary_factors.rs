//! Unary factors `φ_i(x) = exp(−θ_i(x))` in 32 bits, each row scaled so that no product of messages leaves the range.
//!
//! A factor common to all labels of a variable changes neither the maxima nor the shares of its beliefs, nor any
//! message, since messages are scaled to maximum 1. Each row may therefore have its own scale. Energies are computed
//! from the potentials, not from these factors, so scales do not affect them.
//!
//! A label whose potential is more than 87 above the lowest of its variable leaves the normal numbers of 32 bits; more
//! than 104 above it, its factor is 0. No messages bring such a label back, even where `d` neighbors that each pay up
//! to the truncation `T` for another label would (`d T > 87`).

use super::options::Product;

/// Range of a row's smallest potential within which the row is not shifted; other rows are shifted by their smallest
/// potential.
///
/// Shifting every row would also be correct, but `exp(−(θ − c))` rounds differently from `exp(−θ)`. Within this range
/// nothing is lost. At the upper limit `exp(−32) = 1.3e-14`: times 2^60, the scale of one chain of messages, and 1e-5
/// for each of eight messages at the usual floor, the largest belief is still a normal number (1e-36). At the lower
/// limit `exp(5) < 2^8`, and the cavity products, which carry both chains, stay under `2^8 · 2^120 = 2^128`.
const UNSHIFTED: std::ops::RangeInclusive<f32> = -5.0..=32.0;

/// Largest sum of a row of factors for sum-product, which adds up the cavity products of all labels. These are up to
/// `2^120` times the factors, so the sum has to stay below `2^8`, with room for rounding.
const LARGEST_SUM: f64 = 128.0;

/// Turns the potentials of a variable into its factors, in their own scale.
///
/// Potentials are finite, or `+∞` for a forbidden label; a row that forbids all labels prefers none. Cost `O(n)`.
pub(super) fn exponentiate(row: &mut [f32], product: Product) {
    let lowest = row.iter().copied().fold(f32::INFINITY, f32::min);
    if !lowest.is_finite() {
        row.fill(1.0);
    } else {
        let shift = if UNSHIFTED.contains(&lowest) { 0.0 } else { lowest };
        row.iter_mut().for_each(|value| *value = (shift - *value).exp());
    }
    if product == Product::Sum {
        let mut sum: f64 = row.iter().map(|&factor| f64::from(factor)).sum();
        // A power of two, so that no rounding depends on it.
        let mut scale = 1.0f32;
        while sum > LARGEST_SUM {
            (sum, scale) = (0.5 * sum, 0.5 * scale);
        }
        if scale < 1.0 {
            row.iter_mut().for_each(|factor| *factor *= scale);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn rows_of_small_potentials_keep_their_bits(
            lowest in -5.0f32..=32.0,
            above in prop::collection::vec(0.0f32..200.0, 1..100),
        ) {
            let mut row: Vec<f32> = above.iter().map(|a| lowest + a).collect();
            row.push(lowest);
            let expected: Vec<f32> = row.iter().map(|theta| (-theta).exp()).collect();
            exponentiate(&mut row, Product::Max);
            prop_assert_eq!(&row, &expected);
        }

        #[test]
        fn shares_are_those_of_the_potentials(
            lowest in prop_oneof![-1e4f32..1e4, -5.0f32..32.0],
            above in prop::collection::vec(0.0f32..60.0, 1..600),
            sum: bool,
        ) {
            let potentials: Vec<f32> = above.iter().map(|a| lowest + a).chain([lowest]).collect();
            let mut row = potentials.clone();
            exponentiate(&mut row, if sum { Product::Sum } else { Product::Max });
            let top = f64::from(*row.last().unwrap());
            prop_assert!(top >= 1e-14 && (!sum || row.iter().sum::<f32>() <= 129.0));
            for (factor, theta) in row.iter().zip(&potentials) {
                let exact = f64::from(lowest - theta).exp();
                prop_assert!((f64::from(*factor) / top - exact).abs() <= 1e-5 * exact, "{factor} at {theta}");
            }
        }
    }

    #[test]
    fn a_row_that_forbids_every_label_prefers_none() {
        let mut row = [f32::INFINITY; 3];
        exponentiate(&mut row, Product::Max);
        assert_eq!(row, [1.0; 3]);
        let mut row = [f32::INFINITY, 1e6, 1e6 + 1.0];
        exponentiate(&mut row, Product::Max);
        assert_eq!((row[0], row[1]), (0.0, 1.0));
    }
}
