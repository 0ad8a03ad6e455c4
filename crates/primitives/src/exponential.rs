//! `exp(x)` for `x ≤ 0`, for loops over many numbers.
//!
//! It uses no fused operations, so a loop around it vectorizes and gives the same bits on every instruction set.
//! Source: range reduction by `ln 2` in two parts, and the minimax polynomial (32 bits) or rational function (64 bits)
//! of Moshier's Cephes library (`expf`, `exp`).

/// 1.5 · 2²³: adding it rounds a number to the nearest integer, which ends in the low bits.
const ROUND: f32 = 12_582_912.0;
/// Exponent below which the result would be subnormal; 0 is returned instead.
const SMALLEST_EXPONENT: f32 = -87.0;

/// `exp(x)` for `x ≤ 0`, to two units in the last place; 0 below −87.
#[inline(always)]
pub fn exp_negative(x: f32) -> f32 {
    let bounded = if x > SMALLEST_EXPONENT { x } else { SMALLEST_EXPONENT };
    let shifted = bounded * std::f32::consts::LOG2_E + ROUND;
    let k = shifted - ROUND;
    // ln 2 = 0.693359375 − 2.12194440e-4; the first part has few bits, so its product with k is exact.
    let r = bounded - k * 0.693_359_4 + k * 2.121_944_4e-4;
    let mut p = 1.987_569_2e-4f32;
    for c in [1.398_2e-3, 8.333_452e-3, 4.166_579_6e-2, 1.666_666_5e-1, 0.5] {
        p = p * r + c;
    }
    let fraction = p * r * r + r + 1.0;
    let power = f32::from_bits((shifted.to_bits() << 23).wrapping_add(127 << 23));
    if x > SMALLEST_EXPONENT { fraction * power } else { 0.0 }
}

/// 1.5 · 2⁵²: the counterpart of [`ROUND`] for 64 bits.
const ROUND_F64: f64 = 6_755_399_441_055_744.0;
/// The counterpart of [`SMALLEST_EXPONENT`] for 64 bits.
const SMALLEST_EXPONENT_F64: f64 = -708.0;

/// `exp(x)` for `x ≤ 0`, to two units in the last place; 0 below −708.
#[inline(always)]
pub fn exp_negative_f64(x: f64) -> f64 {
    let bounded = if x > SMALLEST_EXPONENT_F64 { x } else { SMALLEST_EXPONENT_F64 };
    let shifted = bounded * std::f64::consts::LOG2_E + ROUND_F64;
    let k = shifted - ROUND_F64;
    let r = bounded - k * 6.931_457_519_531_25e-1 - k * 1.428_606_820_309_417_2e-6;
    let squared = r * r;
    let odd = r * ((1.261_771_930_748_105_9e-4 * squared + 3.029_944_077_074_419_6e-2) * squared + 1.0);
    let even = ((3.001_985_051_386_644_6e-6 * squared + 2.524_483_403_496_841e-3) * squared
        + 2.272_655_482_081_550_3e-1)
        * squared
        + 2.0;
    let fraction = 1.0 + 2.0 * (odd / (even - odd));
    let power = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1023 << 52));
    if x > SMALLEST_EXPONENT_F64 { fraction * power } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_exponential_agrees_with_double_precision(x in -86.9f32..=0.0) {
            let exact = f64::from(x).exp();
            prop_assert!((f64::from(exp_negative(x)) / exact - 1.0).abs() < 4e-7, "{} at {x}", exp_negative(x));
        }
    }

    proptest! {
        #[test]
        fn the_exponential_in_64_bits_agrees_with_that_of_the_standard_library(x in -707.9f64..=0.0) {
            let ratio = exp_negative_f64(x) / x.exp();
            prop_assert!((ratio - 1.0).abs() <= 3.0 * f64::EPSILON, "{} at {x}", exp_negative_f64(x));
        }
    }

    #[test]
    fn exponentials_below_the_range_are_zero() {
        assert_eq!((exp_negative(0.0), exp_negative(-87.5), exp_negative(f32::NEG_INFINITY)), (1.0, 0.0, 0.0));
        let of = [0.0, -708.5, f64::NEG_INFINITY].map(exp_negative_f64);
        assert_eq!(of, [1.0, 0.0, 0.0]);
    }
}
