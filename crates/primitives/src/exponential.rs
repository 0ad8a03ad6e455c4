//! `exp(x)` for `x ≤ 0`, for loops over many numbers.
//!
//! A polynomial in 32 bits without fused operations, so that a loop around it vectorizes and every instruction set gives
//! the same bits. Source: range reduction by `ln 2` in two parts and the minimax polynomial of Moshier's Cephes library
//! (`expf`).

/// 1.5 · 2²³: adding it rounds to the nearest integer and leaves that in the low bits.
const ROUND: f32 = 12_582_912.0;
/// Below this the exponential is no normal number, and 0 is returned.
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

    #[test]
    fn exponentials_below_the_range_are_zero() {
        assert_eq!((exp_negative(0.0), exp_negative(-87.5), exp_negative(f32::NEG_INFINITY)), (1.0, 0.0, 0.0));
    }
}
