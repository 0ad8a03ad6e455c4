//! Storage formats of messages. In every format, messages are computed in 32 bits.
//!
//! A message has maximum 1, and its small values count as much as its large ones, since it enters products. Half
//! precision (binary16 of IEEE 754) stores a number from 2⁻¹⁴ (6.1e-5) to 1 to a relative `2⁻¹¹` (4.9e-4), and smaller
//! ones to `2⁻²⁵` (3.0e-8) absolute. The potential that a message represents is off by at most 5e-4, or at most 3e-3 at
//! a floor of 1e-5. On a tree each message enters a belief once, and the error of the belief is the sum over its
//! messages. With cycles no such bound holds, and runs that do not settle may diverge from each other; their difference
//! on surfaces has to be measured.
//!
//! A value rounded to 0 would rule out a label regardless of the other messages, so the floor of messages is at least
//! the smallest positive number, [`MessageValue::LEAST`].

use super::vector::{Simd, Vector, WIDTH};
use half::f16;
use half::slice::HalfFloatSliceExt;
use std::borrow::Cow;

/// A stored value of a message.
pub(super) trait MessageValue: Copy + Send + Sync + 'static {
    /// 0.
    const ZERO: Self;
    /// Smallest value of a message that is not rounded to 0.
    const LEAST: f32;
    /// Loads from memory, at any address; exact.
    fn load<S: Simd>(simd: S, from: &[Self; WIDTH]) -> S::Vector;
    /// Stores to memory, at any address, rounding to the nearest number, ties to even. Returns the values that a load
    /// would give back.
    fn store<V: Vector>(values: V, to: &mut [Self; WIDTH]) -> V;
    /// Rounds to the nearest number, ties to even.
    fn narrow(value: f32) -> Self;
    /// Converts a row to 32 bits; exact.
    fn widen(row: &[Self]) -> Cow<'_, [f32]>;
}

impl MessageValue for f32 {
    const ZERO: Self = 0.0;
    const LEAST: f32 = 0.0;

    #[inline(always)]
    fn load<S: Simd>(simd: S, from: &[f32; WIDTH]) -> S::Vector {
        simd.load(from)
    }

    #[inline(always)]
    fn store<V: Vector>(values: V, to: &mut [f32; WIDTH]) -> V {
        values.store(to);
        values
    }

    fn narrow(value: f32) -> f32 {
        value
    }

    fn widen(row: &[f32]) -> Cow<'_, [f32]> {
        Cow::Borrowed(row)
    }
}

impl MessageValue for f16 {
    const ZERO: Self = f16::ZERO;
    const LEAST: f32 = f16::MIN_POSITIVE_SUBNORMAL.to_f32_const();

    #[inline(always)]
    fn load<S: Simd>(simd: S, from: &[f16; WIDTH]) -> S::Vector {
        simd.load_half(from)
    }

    #[inline(always)]
    fn store<V: Vector>(values: V, to: &mut [f16; WIDTH]) -> V {
        values.store_half(to)
    }

    fn narrow(value: f32) -> f16 {
        f16::from_f32(value)
    }

    fn widen(row: &[f16]) -> Cow<'_, [f32]> {
        let mut wide = vec![0.0; row.len()];
        row.convert_to_f32_slice(&mut wide);
        Cow::Owned(wide)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn half_precision_rounds_messages_by_no_more_than_documented(message in 1e-7f32..=1.0) {
            let off = (f16::narrow(message).to_f32() - message).abs();
            prop_assert!(off <= (message / 2048.0).max(1.0 / 33_554_432.0), "{message} is off by {off}");
        }
    }

    #[test]
    fn values_from_the_smallest_on_are_not_stored_as_zero() {
        assert_eq!(f16::LEAST, 2.0f32.powi(-24));
        // The floor survives rounding when it is damped.
        assert_eq!(f16::narrow(f16::LEAST * 0.999).to_f32(), f16::LEAST);
        assert_eq!(f16::narrow(1.0).to_f32(), 1.0);
    }
}
