//! Eight numbers of 32 bits in a register, and what the dense kernel does with them.
//!
//! Loops are written once, over [`Vector`], and compiled for two kinds of it: [`Plain`] for any machine and [`Avx2`] for
//! those that have AVX2 and F16C. Each operation is one rounding or none in both, so that both give the same bits; a test
//! holds them equal. By hand, because of the turn of rows into columns: what the compiler makes of it goes through memory,
//! number by number.

// Intrinsics need unsafe calls where a vector goes to memory, and outside functions that are compiled for AVX2.
#![allow(unsafe_code)]

use half::f16;
use wide::f32x4;

/// Numbers in a vector.
pub(super) const WIDTH: usize = 8;

/// Eight numbers; all operations number by number.
pub(super) trait Vector: Copy {
    /// The same number eight times.
    fn splat(value: f32) -> Self;
    /// From memory, at any address.
    fn load(from: &[f32; WIDTH]) -> Self;
    /// To memory, at any address.
    fn store(self, to: &mut [f32; WIDTH]);
    /// From numbers of 16 bits in memory, at any address.
    fn load_half(from: &[f16; WIDTH]) -> Self;
    /// To numbers of 16 bits in memory, at any address: to the nearest, of two equally near ones to the even one. Returns
    /// what [`Vector::load_half`] gives back.
    fn store_half(self, to: &mut [f16; WIDTH]) -> Self;
    /// `self + other`.
    fn add(self, other: Self) -> Self;
    /// `self − other`.
    fn sub(self, other: Self) -> Self;
    /// `self · other`.
    fn mul(self, other: Self) -> Self;
    /// `self` where it is larger, else `other`.
    fn max(self, other: Self) -> Self;
    /// Without its sign.
    fn abs(self) -> Self;
    /// `a` where `self` is larger than `other`, else `b`.
    fn choose_if_above(self, other: Self, a: Self, b: Self) -> Self;
    /// Column `k` of eight rows in memory, for every `k`.
    fn columns(rows: [&[f32; 4]; WIDTH]) -> [Self; 4];
    /// Asks for the line that holds `values[at]`, if there is such a number, to be brought into the nearest cache.
    fn prefetch<T>(values: &[T], at: usize);
    /// Likewise into the second nearest.
    fn prefetch_far<T>(values: &[T], at: usize);
}

/// A vector on any machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plain([f32; WIDTH]);

impl Plain {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        Plain(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl Vector for Plain {
    #[inline(always)]
    fn splat(value: f32) -> Self {
        Plain([value; WIDTH])
    }

    #[inline(always)]
    fn load(from: &[f32; WIDTH]) -> Self {
        Plain(*from)
    }

    #[inline(always)]
    fn store(self, to: &mut [f32; WIDTH]) {
        *to = self.0;
    }

    #[inline(always)]
    fn load_half(from: &[f16; WIDTH]) -> Self {
        Plain(from.map(f16::to_f32))
    }

    #[inline(always)]
    fn store_half(self, to: &mut [f16; WIDTH]) -> Self {
        *to = self.0.map(f16::from_f32);
        Self::load_half(to)
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Plain(self.0.map(f32::abs))
    }

    #[inline(always)]
    fn choose_if_above(self, other: Self, a: Self, b: Self) -> Self {
        Plain(std::array::from_fn(|k| if self.0[k] > other.0[k] { a.0[k] } else { b.0[k] }))
    }

    #[inline(always)]
    fn columns(rows: [&[f32; 4]; WIDTH]) -> [Self; 4] {
        let turned = |at: usize| f32x4::transpose(std::array::from_fn(|k| f32x4::from(*rows[at + k])));
        let (low, high) = (turned(0), turned(4));
        std::array::from_fn(|x| {
            let ([a, b, c, d], [e, f, g, h]) = (low[x].to_array(), high[x].to_array());
            Plain([a, b, c, d, e, f, g, h])
        })
    }

    #[inline(always)]
    fn prefetch<T>(_: &[T], _: usize) {}

    #[inline(always)]
    fn prefetch_far<T>(_: &[T], _: usize) {}
}

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{Vector, WIDTH};
    use half::f16;
    use std::arch::x86_64::*;

    /// A vector of a machine that has AVX2 and F16C, which came before it. To be used in functions that are compiled for
    /// both and entered only where the machine has them: `#[multiversion]` sees to that, and `match_target!` names this
    /// type nowhere else.
    #[derive(Clone, Copy)]
    pub(in super::super) struct Avx2(__m256);

    // SAFETY, of every call below: the machine has AVX2 and F16C, as is said of the type; loads and stores are of memory that is
    // borrowed for that, at any alignment; a prefetch may be of any address.
    impl Vector for Avx2 {
        #[inline(always)]
        fn splat(value: f32) -> Self {
            Avx2(unsafe { _mm256_set1_ps(value) })
        }

        #[inline(always)]
        fn load(from: &[f32; WIDTH]) -> Self {
            Avx2(unsafe { _mm256_loadu_ps(from.as_ptr()) })
        }

        #[inline(always)]
        fn store(self, to: &mut [f32; WIDTH]) {
            unsafe { _mm256_storeu_ps(to.as_mut_ptr(), self.0) }
        }

        #[inline(always)]
        fn load_half(from: &[f16; WIDTH]) -> Self {
            Avx2(unsafe { _mm256_cvtph_ps(_mm_loadu_si128(from.as_ptr().cast())) })
        }

        #[inline(always)]
        fn store_half(self, to: &mut [f16; WIDTH]) -> Self {
            unsafe {
                let halves = _mm256_cvtps_ph::<_MM_FROUND_TO_NEAREST_INT>(self.0);
                _mm_storeu_si128(to.as_mut_ptr().cast(), halves);
                Avx2(_mm256_cvtph_ps(halves))
            }
        }

        #[inline(always)]
        fn add(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_add_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_sub_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_mul_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_max_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn abs(self) -> Self {
            Avx2(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
        }

        #[inline(always)]
        fn choose_if_above(self, other: Self, a: Self, b: Self) -> Self {
            Avx2(unsafe { _mm256_blendv_ps(b.0, a.0, _mm256_cmp_ps::<_CMP_GT_OQ>(self.0, other.0)) })
        }

        #[inline(always)]
        fn columns([a, b, c, d, e, f, g, h]: [&[f32; 4]; WIDTH]) -> [Self; 4] {
            unsafe {
                // Two rows in one register are two loads and no shuffle.
                let two = |x: &[f32; 4], y: &[f32; 4]| _mm256_loadu2_m128(y.as_ptr(), x.as_ptr());
                quads([two(a, e), two(b, f), two(c, g), two(d, h)]).map(Avx2)
            }
        }

        #[inline(always)]
        fn prefetch_far<T>(values: &[T], at: usize) {
            unsafe { _mm_prefetch::<_MM_HINT_T1>(values.as_ptr().wrapping_add(at).cast()) }
        }

        #[inline(always)]
        fn prefetch<T>(values: &[T], at: usize) {
            // Past the end it is an address like any other, which nothing is read from.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().wrapping_add(at).cast()) }
        }
    }

    /// The turns of four rows in both halves of a register.
    ///
    /// # Safety
    /// The machine has AVX2.
    #[inline(always)]
    unsafe fn quads([a, b, c, d]: [__m256; 4]) -> [__m256; 4] {
        unsafe {
            let (p, q) = (_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b));
            let (r, s) = (_mm256_unpacklo_ps(c, d), _mm256_unpackhi_ps(c, d));
            [
                _mm256_shuffle_ps::<0x44>(p, r),
                _mm256_shuffle_ps::<0xee>(p, r),
                _mm256_shuffle_ps::<0x44>(q, s),
                _mm256_shuffle_ps::<0xee>(q, s),
            ]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use multiversion::multiversion;
    use multiversion::target::match_target;
    use proptest::prelude::*;

    /// A half of each row.
    fn quads(rows: &[[f32; WIDTH]; WIDTH], half: usize) -> [&[f32; 4]; WIDTH] {
        std::array::from_fn(|k| &rows[k].as_chunks().0[half])
    }

    /// What every operation makes of two vectors, and of eight rows.
    #[inline(always)]
    fn everything<V: Vector>(rows: &[[f32; WIDTH]; WIDTH]) -> Vec<[u32; WIDTH]> {
        let loaded: [V; WIDTH] = std::array::from_fn(|k| V::load(&rows[k]));
        let (a, b) = (loaded[0], loaded[1]);
        V::prefetch(&rows[0], 3);
        V::prefetch_far(&rows[0], 99);
        let mut made = vec![V::splat(rows[0][0]), a.add(b), a.sub(b), a.mul(b), a.max(b), b.max(a), a.abs()];
        made.push(a.choose_if_above(b, loaded[2], loaded[3]));
        made.extend(V::columns(quads(rows, 0)).into_iter().chain(V::columns(quads(rows, 1))));
        made.extend(loaded.map(|row| row.store_half(&mut [f16::ZERO; WIDTH])));
        made.extend(
            rows.map(|row| V::load_half(&row.map(|number| f16::from_bits((number.to_bits() >> 9) as u16 & 0xbfff)))),
        );
        let bits = |vector: V| {
            let mut numbers = [0.0; WIDTH];
            vector.store(&mut numbers);
            numbers.map(f32::to_bits)
        };
        made.into_iter().map(bits).collect()
    }

    #[multiversion(targets("x86_64+avx2+f16c"))]
    fn on_this_machine(rows: &[[f32; WIDTH]; WIDTH]) -> Vec<[u32; WIDTH]> {
        match_target! {
            "x86_64+avx2+f16c" => everything::<Avx2>(rows),
            _ => everything::<Plain>(rows),
        }
    }

    proptest! {
        #[test]
        fn both_kinds_of_vector_give_the_same_bits(entropy in prop::collection::vec(-2.0f32..2.0, 64), same in any::<bool>()) {
            let mut rows = [[0.0; WIDTH]; WIDTH];
            rows.as_flattened_mut().copy_from_slice(&entropy);
            if same {
                rows[1][3] = rows[0][3];
                rows[1][4] = -0.0;
                rows[0][4] = 0.0;
            }
            prop_assert_eq!(on_this_machine(&rows), everything::<Plain>(&rows));
        }

        #[test]
        fn numbers_of_any_size_are_rounded_to_the_same_halves(
            entropy in prop::collection::vec((-30i32..0, 0u32..1 << 23), 64),
        ) {
            // Every 16th lies in the middle between two halves.
            let number = |(at, &(exponent, fraction)): (usize, &(i32, u32))| {
                let fraction = if at % 16 == 0 { fraction & !0xfff | 0x1000 } else { fraction };
                f32::from_bits(((exponent + 127) as u32) << 23 | fraction)
            };
            let mut rows = [[0.0; WIDTH]; WIDTH];
            let numbers: Vec<f32> = entropy.iter().enumerate().map(number).collect();
            rows.as_flattened_mut().copy_from_slice(&numbers);
            prop_assert_eq!(on_this_machine(&rows), everything::<Plain>(&rows));
            for row in rows {
                let mut halves = [f16::ZERO; WIDTH];
                Plain(row).store_half(&mut halves);
                prop_assert_eq!(halves, row.map(f16::from_f32_const));
                prop_assert_eq!(Plain::load_half(&halves), Plain(halves.map(f16::to_f32_const)));
            }
        }

        #[test]
        fn columns_are_those_of_the_rows(entropy in prop::collection::vec(-2.0f32..2.0, 64), half in 0usize..2) {
            let mut rows = [[0.0; WIDTH]; WIDTH];
            rows.as_flattened_mut().copy_from_slice(&entropy);
            for (x, column) in (4 * half..).zip(Plain::columns(quads(&rows, half))) {
                prop_assert!((0..WIDTH).all(|k| column.0[k] == rows[k][x]));
            }
        }
    }
}
